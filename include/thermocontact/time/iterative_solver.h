// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef thermocontact_time_iterative_solver_h
#define thermocontact_time_iterative_solver_h

#include <thermocontact/base/recently_used.h>
#include <thermocontact/base/tolerances.h>
#include <thermocontact/contact/exchange_solver.h>
#include <thermocontact/space/body.h>
#include <thermocontact/time/contact_port.h>
#include <thermocontact/time/iterative_stage.h>
#include <thermocontact/time/stage_solver.h>

#include <vector>

namespace ThermoContact
{
  /**
   * A stage of a large body: both fields at once, without a matrix; responses
   * of single nodes are for estimates of errors alone. Its contact nodes are
   * those of a ContactPort, for whose tangents IterativeStage solves it,
   * loosely until the laws are met.
   */
  template <int dim>
  class IterativeSolver : public StageSolver,
                          private ContactPort<dim>,
                          private ExchangeOperator
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

    /** Solves a stage for each contact node. */
    const FullMatrix<double> &
    response(const double tau) override;

    void
    apply_pressure(StageRates &rates) override;

    void
    subtract_response(const std::vector<AffineLaw> &laws,
                      const std::vector<double>    &displacement,
                      State                        &difference) override;

    types::global_dof_index
    n_factorized_unknowns() const override
    {
      return stage.preconditioners().n_factorized_unknowns();
    }

    RetainedFactorizations
    retained() const override;

    void
    restore(const RetainedFactorizations &retained) override;

  private:
    const Body<dim>     &body;
    IterativeStage<dim>  stage;
    std::vector<NodeLaw> laws;          ///< of a stage
    std::vector<double>  start;         ///< its x without velocity
    double               factor = 0.;   ///< x per velocity
    std::vector<double>  end_pressures; ///< of the exchange that is tried last
    unsigned int         n_sets = 0;    ///< of tangents for it
    Vector               excess; ///< $\theta$ over the steady one at the start

    struct Response
    {
      double             tau;
      FullMatrix<double> matrix;
    };

    RecentlyUsed<Response> responses;

    /**
     * Sets the rates of the stage that was solved last and the power of its
     * residuals, (D8.5).
     *
     * @param pressure on the contact nodes that the loads of the stage lack
     */
    void
    set_rates(const std::vector<double> &pressure, StageRates &rates) const;

    using ContactPort<dim>::solve;

    /** Solves the prepared stage with contact; @return number of sets of tangents. */
    unsigned int
    meet_laws(std::vector<double> &pressure);

    void
    solve_system(const bool is_last) override;

    const Vector &
    left() override
    {
      return stage.unsolved(Field::displacement);
    }

    const Vector &
    diagonal() const override
    {
      return stage.preconditioners().current().diagonals[Field::displacement];
    }

    void
    set_springs(const std::vector<double> &springs,
                const std::vector<double> &relaxed) override
    {
      stage.set_springs(springs, relaxed);
    }

    double
    rounding() const override
    {
      return Tolerances::rounding_of_solution;
    }

    std::vector<double>
    law_at(const std::vector<double> &coefficient) override;
  };
} // namespace ThermoContact

#endif
