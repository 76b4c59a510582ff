// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef thermocontact_time_iterative_solver_h
#define thermocontact_time_iterative_solver_h

#include <thermocontact/space/body.h>
#include <thermocontact/time/iterative_stage.h>
#include <thermocontact/time/stage_solver.h>

#include <vector>

namespace ThermoContact
{
  /**
   * A stage of a large body: both fields at once and contact by
   * solve_by_branches(), without a matrix and without a response for each node.
   *
   * For a set of nodes in contact the stage is linear, and IterativeStage
   * solves it, loosely until the set repeats itself.
   */
  template <int dim>
  class IterativeSolver : public StageSolver, private InterfaceOperator
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

    std::string
    linear_solver() const override
    {
      return "iterative";
    }

    /**
     * Displacement and pressures that balance all forces on a body without
     * inertia and viscosity, for its temperature, (M.35); to rounding.
     *
     * @param known in: also to start from; its velocity becomes zero
     * @throw ComputationError if the solver does not converge, or the set of
     *   nodes in contact does not settle
     */
    void
    solve_equilibrium(const Vector &heat_load,
                      const Vector &momentum_load,
                      State        &known);

    /**
     * The velocity of a body without inertia that does not move nodes in
     * contact into a rigid obstacle, times $\zeta/(\zeta+1)$, and pressures
     * there, (M.34).
     *
     * @param laws of velocities: nodes in contact cannot move into an obstacle
     */
    void
    solve_quasi_static_velocity(const State                &known,
                                const Vector               &heat_load,
                                const Vector               &momentum_load,
                                const std::vector<NodeLaw> &laws,
                                StageRates                 &rates);

    bool
    can_hold_nodes() const override
    {
      return true;
    }

    void
    keep_contact(const std::vector<bool>   &is_closed,
                 const std::vector<double> &pressure,
                 State                     &difference) override;

    /** The coarsest level, of one field; zero without factors. */
    types::global_dof_index
    n_factorized_unknowns() const override;

    RetainedFactorizations
    retained() const override;

    void
    restore(const RetainedFactorizations &retained) override;

  private:
    const Body<dim>    &body;
    IterativeStage<dim> stage;

    /** Solves for the present set to a relative residual. */
    void
    solve_linear(const double tolerance, std::vector<double> &pressure);

    /** (M.65) of the stage that was solved last. */
    double
    algebraic_power(const State               &known,
                    const double               tau,
                    const std::vector<double> &pressure) const;

    /** The stage that was prepared, from the pressures of @p known on. */
    void
    solve_prepared(const State      &known,
                   const ContactMode mode,
                   StageRates       &rates);

    /** A stage with or without its temperature: solve() or solve_momentum(). */
    void
    solve_fields(const State      &known,
                 const double      tau,
                 const Vector     &heat_load,
                 const Vector     &momentum_load,
                 const ContactMode mode,
                 const bool        with_heat,
                 StageRates       &rates);

    /** The same from these branches on. */
    void
    solve_contact(std::vector<int> &branch, StageRates &rates);

    void
    solve(const std::vector<int> &branch,
          const bool              is_last,
          std::vector<double>    &position,
          std::vector<double>    &pressure) override;

    void
    count(const unsigned int n_iterations);
  };
} // namespace ThermoContact

#endif
