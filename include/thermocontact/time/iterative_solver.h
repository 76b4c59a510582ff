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

    std::string
    linear_solver() const override
    {
      return "iterative";
    }

    /**
     * $(\zeta+1)Sy+Np=r$ of a body without inertia, as
     * Equilibrium::solve() with $c=1$.
     *
     * @param laws,position empty: no contact
     */
    void
    solve_forces(const Vector               &forces,
                 const std::vector<NodeLaw> &laws,
                 const std::vector<double>  &position,
                 Vector                     &y,
                 std::vector<double>        &pressure);

    void
    keep_contact(const std::vector<bool>   &is_closed,
                 const std::vector<double> &pressure,
                 State                     &difference) override;

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

    /** Solves for the present set to a relative residual. */
    void
    solve_linear(const double tolerance, std::vector<double> &pressure);

    /** (D8.5) of the stage that was solved last. */
    double
    algebraic_power(const State               &known,
                    const double               tau,
                    const std::vector<double> &pressure) const;

    /** The stage that was prepared, from the pressures of @p known on. */
    void
    solve_prepared(const State      &known,
                   const ContactMode mode,
                   StageRates       &rates);

    /**
     * The contact of what is prepared, from these branches on.
     *
     * @return number of sets of branches
     */
    unsigned int
    solve_contact(std::vector<int> &branch, std::vector<double> &pressure);

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
