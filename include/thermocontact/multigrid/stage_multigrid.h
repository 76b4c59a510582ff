// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef thermocontact_multigrid_stage_multigrid_h
#define thermocontact_multigrid_stage_multigrid_h

#include <thermocontact/multigrid/chebyshev_smoother.h>
#include <thermocontact/multigrid/coarse_solver.h>
#include <thermocontact/multigrid/multigrid_levels.h>
#include <thermocontact/multigrid/stage_block.h>

#include <memory>
#include <vector>

namespace ThermoContact
{
  /**
   * One V-cycle for the block of a field of the stage matrix: a preconditioner.
   * Chebyshev smoothers of degree 3 with the diagonal (2 for heat) and a
   * CoarseSolver. Symmetric to the rounding of @p Number and, between two calls
   * of set_contact(), always the same. Systems are solved over a scale, so that
   * float has room for them.
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
     * The largest eigenvalues stay those without contact; so does its
     * CoarseSolver, which is kept beside that of the last rows. Collective.
     *
     * @param rows of the finest level; null: no contact
     * @param are_as_before the last ones that were not null were the same
     */
    void
    set_contact(const ContactRows *rows, const bool are_as_before = false);

    /** @p z = one V-cycle for @p r. */
    void
    vmult(Vector &z, const Vector &r) const;

  private:
    /** Of all levels but the coarsest. */
    struct Level
    {
      std::unique_ptr<StageBlock<dim, Number>>        block;
      std::unique_ptr<ChebyshevSmoother<dim, Number>> smoother;
    };

    const MultigridLevels<dim, Number> &levels;
    const Field::Block                  field;
    const double                        tau;
    double                              scale = 1.; ///< of matrices
    std::vector<Level>                  fine;       ///< level l is fine[l - 1]

    std::unique_ptr<CoarseSolver<dim>> coarse_without_contact;
    std::unique_ptr<CoarseSolver<dim>> coarse_with_contact; ///< of present rows
    ContactRows                        coarse_rows;
    bool                               has_contact = false;

    /** Springs and held nodes of all levels; those of the coarsest are kept. */
    void
    set_rows(const ContactRows &rows);

    /** Zero where the coarsest level has prescribed rates. */
    void
    zero_coarse(Vector &vector) const;

    /** On the coarsest level. */
    void
    solve_coarse() const;

    /** Solves approximately on a level: right to solution. */
    void
    cycle(const unsigned int level) const;
  };
} // namespace ThermoContact

#endif
