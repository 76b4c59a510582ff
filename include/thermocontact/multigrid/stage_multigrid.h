// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef thermocontact_multigrid_stage_multigrid_h
#define thermocontact_multigrid_stage_multigrid_h

#include <thermocontact/multigrid/chebyshev_smoother.h>
#include <thermocontact/multigrid/multigrid_levels.h>

#include <memory>
#include <vector>

namespace ThermoContact
{
  /**
   * One V-cycle: Chebyshev smoothers, and factors of the coarsest level.
   * Symmetric to the rounding of @p Number. Systems are solved over a scale, so
   * that float has room for them.
   */
  template <int dim, typename Number>
  class StageMultigrid
  {
  public:
    /** @param levels borrowed */
    StageMultigrid(const MultigridLevels<dim, Number> &levels,
                   const Field::Block                  field,
                   const double                        tau);

    /**
     * Rows of contact. Between two calls it is the same linear map. The largest
     * eigenvalues stay those without contact; so do its factors, which are kept
     * beside those of the last rows. Collective.
     *
     * @param rows of the body; null: no contact
     * @param are_as_before the last ones that were not null were the same
     */
    void
    set_contact(const ContactRows *rows, const bool are_as_before = false);

    /** @p z = about the solution for @p r. Collective. */
    void
    vmult(Vector &z, const Vector &r) const;

  private:
    /** Of the coarsest level without smoother. */
    struct Level
    {
      std::unique_ptr<StageBlock<dim, Number>>        block;
      std::unique_ptr<ChebyshevSmoother<dim, Number>> smoother;
    };

    const MultigridLevels<dim, Number> &levels;
    const Field::Block                  field;
    double                              scale = 1.; ///< of matrices
    std::vector<Level>                  stage_levels;

    std::unique_ptr<const BandFactors> factors_without_contact;
    std::unique_ptr<const BandFactors> factors_with_contact; ///< last rows
    bool                               has_contact = false;
    mutable std::vector<double>        coarse_values;

    /** Springs and held nodes of a level and of those that are coarser. */
    void
    set_rows(const unsigned int level, const ContactRows &rows);

    /** Solves approximately on a level: right to solution. */
    void
    cycle(const unsigned int level) const;
  };
} // namespace ThermoContact

#endif
