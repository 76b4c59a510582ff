// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef thermocontact_multigrid_stage_preconditioner_h
#define thermocontact_multigrid_stage_preconditioner_h

#include <thermocontact/multigrid/stage_block.h>

namespace ThermoContact
{
  /** Solves the block of a field of the stage matrix approximately. */
  class StagePreconditioner
  {
  public:
    virtual ~StagePreconditioner() = default;

    /**
     * Rows of contact. Between two calls it is the same linear map. Collective.
     *
     * @param rows of the body; null: no contact
     * @param are_as_before the last ones that were not null were the same
     */
    virtual void
    set_contact(const ContactRows *rows, const bool are_as_before = false) = 0;

    /** @p z = about the solution for @p r. Collective. */
    virtual void
    vmult(Vector &z, const Vector &r) const = 0;
  };
} // namespace ThermoContact

#endif
