// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef thermocontact_time_iterative_solver_h
#define thermocontact_time_iterative_solver_h

#include <thermocontact/multigrid/stage_multigrid.h>
#include <thermocontact/space/body.h>
#include <thermocontact/time/stage_solver.h>

#include <array>
#include <list>
#include <memory>
#include <vector>

namespace ThermoContact
{
  /**
   * A stage of a large body: both fields at once and contact by primal-dual
   * active sets, without a matrix and without a response for each node.
   *
   * For a set of nodes in contact the stage is linear: an elastic obstacle adds
   * springs to the diagonal of (M.15), a rigid one prescribes the velocity that
   * ends at it. GMRES, preconditioned from the right by one V-cycle for each
   * field, the temperature first, solves it from the velocity at the beginning
   * of the stage on; loosely until the set repeats itself. The pressure is the
   * residual of the equations without contact, in both cases.
   */
  template <int dim>
  class IterativeSolver : public StageSolver
  {
  public:
    /** @param body borrowed; it has no matrices */
    explicit IterativeSolver(const Body<dim> &body);

    void
    solve(const State  &known,
          const double  tau,
          const Vector &heat_load,
          const Vector &momentum_load,
          ContactMode   mode,
          StageRates   &rates) override;

    /** The same with a given rate of temperature, zero. */
    void
    solve_momentum(const State  &known,
                   const double  tau,
                   const Vector &heat_load,
                   const Vector &momentum_load,
                   ContactMode   mode,
                   StageRates   &rates);

    /** The coarsest level, of one field. */
    types::global_dof_index
    n_factorized_unknowns() const override;

    RetainedFactorizations
    retained() const override;

    void
    restore(const RetainedFactorizations &retained) override;

  private:
    const Body<dim>           &body;
    const MultigridLevels<dim> levels;

    /** The preconditioners for a stage length. */
    struct Hierarchy
    {
      double                               tau;
      std::unique_ptr<StageMultigrid<dim>> heat;
      std::unique_ptr<StageMultigrid<dim>> momentum;
      std::array<Vector, 2>                diagonals; ///< of the blocks
    };

    std::list<Hierarchy> hierarchies; ///< the one used last in front

    /** The stage that is being solved. */
    struct Stage
    {
      double              tau      = 0.;
      bool                has_heat = true; ///< its temperature is unknown
      const State        *known    = nullptr;
      std::vector<double> known_penetration;
      BlockVector         rhs;      ///< without contact
      BlockVector         solution; ///< $(\tau\theta',v)$
      BlockVector         residual; ///< without contact
      BlockVector         weights;  ///< of the residuals
      BlockVector         inverse_weights;
      std::vector<bool>   is_active;
      ContactRows         contact;
      unsigned int        n_sets = 0;
    };

    Stage       stage;
    BlockVector correction, scaled_residual;

    void
    provide_hierarchy(const double tau);

    void
    prepare(const State  &known,
            const double  tau,
            const Vector &heat_load,
            const Vector &momentum_load);

    /** Makes residuals relative: one over the size of the terms of a row. */
    void
    set_weights(const State &known, const double tau);

    /** @p y = the matrix of the stage without contact times @p x. */
    void
    apply(BlockVector &y, const BlockVector &x) const;

    void
    compute_residual();

    /** Puts springs and held nodes of the active set in place. */
    void
    set_active(const std::vector<bool> &is_active);

    /** Solves for the present set to a relative residual. */
    void
    solve_linear(const double tolerance);

    /** Pressures of the solution at the active nodes, else 0. */
    void
    get_pressures(std::vector<double> &pressure);

    /** Whether the set changes; only its first wrong node if asked so. */
    bool
    update_set(const std::vector<double> &pressure,
               const bool                 only_the_first,
               std::vector<bool>         &is_active) const;

    void
    solve_prepared(const ContactMode mode, StageRates &rates);

    class Matrix;
    class Preconditioner;
  };
} // namespace ThermoContact

#endif
