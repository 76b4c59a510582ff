// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef thermocontact_time_iterative_stage_h
#define thermocontact_time_iterative_stage_h

#include <thermocontact/multigrid/stage_hierarchies.h>
#include <thermocontact/space/body.h>

#include <vector>

namespace ThermoContact
{
  /**
   * The linear system of a stage of a large body for a given set of nodes in
   * contact, doc/model.md (M.50)-(M.54). An elastic obstacle adds springs to
   * the diagonal of (M.15), a rigid one prescribes the velocity that ends at
   * it. GMRES, preconditioned from the right by one V-cycle for each field, the
   * temperature first, solves it from the present solution on.
   */
  template <int dim>
  class IterativeStage
  {
  public:
    /** @param body borrowed; it has no matrices */
    explicit IterativeStage(const Body<dim> &body);

    /** The preconditioners of the stage lengths used last. */
    StageHierarchies<dim> &
    preconditioners()
    {
      return hierarchies;
    }

    const StageHierarchies<dim> &
    preconditioners() const
    {
      return hierarchies;
    }

    /**
     * A new stage; its solution starts at the velocity at its beginning.
     *
     * @param with_heat false: the temperature stays as it is
     */
    void
    prepare(const State  &known,
            const double  stage_length,
            const Vector &heat_load,
            const Vector &momentum_load,
            const bool    with_heat);

    /** Puts springs and held nodes of the active set in place. */
    void
    set_active(const std::vector<bool> &is_active);

    /**
     * Solves for the present set.
     *
     * @param tolerance relative residual, (M.53)
     * @return number of iterations
     * @throw ComputationError if there are too many
     */
    unsigned int
    solve(const double tolerance);

    /** Pressures of the solution at the active nodes, else 0; (M.54). */
    void
    get_pressures(std::vector<double> &pressure);

    /** Penetrations at the end of the stage. */
    void
    get_reach(std::vector<double> &reach) const;

    /** $\tau\theta'$ or $v$. */
    const Vector &
    unknowns(const Field::Block field) const
    {
      return solution.block(field);
    }

    /** What is left of the rows (M.50), without contact. */
    const Vector &
    unsolved(const Field::Block field) const
    {
      return residual.block(field);
    }

    const MultigridLevels<dim> &
    multigrid_levels() const
    {
      return levels;
    }

  private:
    const Body<dim>           &body;
    const MultigridLevels<dim> levels;

    StageHierarchies<dim> hierarchies;

    double              tau      = 0.;
    bool                has_heat = true; ///< its temperature is unknown
    std::vector<double> known_penetration;
    std::vector<bool>   is_active;
    ContactRows         contact;
    BlockVector         rhs;      ///< without contact
    BlockVector         solution; ///< $(\tau\theta',v)$
    BlockVector         residual; ///< without contact
    BlockVector         weights;  ///< of the residuals
    BlockVector         inverse_weights;
    BlockVector         correction;
    BlockVector         scaled_residual;

    /** Makes residuals relative: one over the size of the terms of a row. */
    void
    set_weights(const State &known);

    /** @p y = the matrix of the stage without contact times @p x. */
    void
    apply(BlockVector &y, const BlockVector &x) const;

    void
    compute_residual();

    class Matrix;
    class Preconditioner;
  };
} // namespace ThermoContact

#endif
