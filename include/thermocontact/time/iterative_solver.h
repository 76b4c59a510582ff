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
   * A stage of a large body: both fields at once and contact by primal-dual
   * active sets, without a matrix and without a response for each node.
   *
   * For a set of nodes in contact the stage is linear, and IterativeStage
   * solves it, loosely until the set repeats itself.
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
    const Body<dim>    &body;
    IterativeStage<dim> stage;

    void
    provide_hierarchy(const double tau);

    /** Solves for the present set to a relative residual. */
    void
    solve_linear(const double tolerance, std::vector<double> &pressure);

    /** Whether the set changes; only its first wrong node if asked so. */
    bool
    update_set(const std::vector<double> &pressure,
               const bool                 only_the_first,
               std::vector<bool>         &is_active) const;

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
  };
} // namespace ThermoContact

#endif
