// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef thermocontact_time_iterative_solver_h
#define thermocontact_time_iterative_solver_h

#include <thermocontact/contact/exchange_solver.h>
#include <thermocontact/space/body.h>
#include <thermocontact/time/iterative_stage.h>
#include <thermocontact/time/stage_solver.h>

#include <vector>

namespace ThermoContact
{
  /**
   * A stage of a large body: both fields at once and contact by
   * solve_by_tangents(), without a matrix and without a response for each node.
   *
   * With tangents in place of laws the stage is linear, and IterativeStage
   * solves it, loosely until the laws are met.
   */
  template <int dim>
  class IterativeSolver : public StageSolver,
                          private InterfaceOperator,
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

    /**
     * $(\zeta+1)Sy+Np=r$ of a body without inertia, as Equilibrium::solve().
     *
     * @param laws,position empty: no contact
     */
    void
    solve_forces(const Vector               &forces,
                 const std::vector<NodeLaw> &laws,
                 const std::vector<double>  &position,
                 const double                factor,
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
    const Body<dim>     &body;
    IterativeStage<dim>  stage;
    std::vector<NodeLaw> laws;          ///< of a stage
    std::vector<double>  start;         ///< its x without velocity
    double               factor = 0.;   ///< of IterativeStage::set_interface()
    std::vector<double>  positions;     ///< x at its end
    std::vector<double>  end_pressures; ///< of the exchange that is tried last
    unsigned int         n_sets = 0;    ///< of tangents for it

    /** (D8.5) of the stage that was solved last. */
    double
    algebraic_power(const State               &known,
                    const double               tau,
                    const std::vector<double> &pressure) const;

    /**
     * What is prepared, with contact, from these pressures on.
     *
     * @param start,factor of IterativeStage::set_interface()
     * @return number of sets of tangents
     */
    unsigned int
    solve_contact(const std::vector<NodeLaw> &laws,
                  const std::vector<double>  &start,
                  const double                factor,
                  std::vector<double>        &pressure);

    void
    solve(const std::vector<AffineLaw> &laws,
          const bool                    is_last,
          std::vector<double>          &position,
          std::vector<double>          &pressure) override;

    std::vector<double>
    law_at(const std::vector<double> &coefficient) override;

    void
    count(const unsigned int n_iterations);
  };
} // namespace ThermoContact

#endif
