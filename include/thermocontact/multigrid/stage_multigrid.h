// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef thermocontact_multigrid_stage_multigrid_h
#define thermocontact_multigrid_stage_multigrid_h

#include <thermocontact/multigrid/chebyshev_smoother.h>
#include <thermocontact/multigrid/coarse_solver.h>
#include <thermocontact/multigrid/multigrid_levels.h>
#include <thermocontact/multigrid/stage_preconditioner.h>

#include <memory>
#include <vector>

namespace ThermoContact
{
  /**
   * One V-cycle: Chebyshev smoothers with the diagonal, of more steps for
   * materials that hardly change their volume, and a CoarseSolver. Symmetric to
   * the rounding of @p Number. Systems are solved over a scale, so that float
   * has room for them.
   */
  template <int dim, typename Number>
  class StageMultigrid : public StagePreconditioner
  {
  public:
    /** @param levels borrowed */
    StageMultigrid(const MultigridLevels<dim, Number> &levels,
                   const Field::Block                  field,
                   const double                        tau);

    /**
     * The largest eigenvalues stay those without contact; so does its
     * CoarseSolver, which is kept beside that of the last rows.
     */
    void
    set_contact(const ContactRows *rows,
                const bool         are_as_before = false) override;

    void
    vmult(Vector &z, const Vector &r) const override;

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

    std::unique_ptr<const CoarseSolver> coarse_without_contact;
    std::unique_ptr<const CoarseSolver> coarse_with_contact; ///< last rows
    bool                                has_contact = false;
    mutable std::vector<double>         coarse_values;

    /** Springs and held nodes of a level and of those that are coarser. */
    void
    set_rows(const unsigned int level, const ContactRows &rows);

    /** For the present block of the coarsest level. */
    std::unique_ptr<const CoarseSolver>
    make_coarse_solver() const;

    /** On the coarsest level. */
    void
    solve_coarse() const;

    /** Solves approximately on a level: right to solution. */
    void
    cycle(const unsigned int level) const;
  };
} // namespace ThermoContact

#endif
