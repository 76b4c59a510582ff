// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef thermocontact_space_make_rod_matrices_h
#define thermocontact_space_make_rod_matrices_h

#include <thermocontact/rod/rod_matrices.h>
#include <thermocontact/space/discretization.h>
#include <thermocontact/space/field_matrices.h>

#include <memory>

namespace ThermoContact
{
  /**
   * The field matrices of a rod that one process owns, cell by cell; null if
   * its cells or nodes are not numbered from one end to the other as RodLayout
   * says.
   */
  std::unique_ptr<const RodMatrices>
  make_rod_matrices(const Discretization<1> &discretization,
                    const FieldMatrices<1>  &matrices);
} // namespace ThermoContact

#endif
