// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef thermocontact_stage_solver_h
#define thermocontact_stage_solver_h

#include <deal.II/lac/full_matrix.h>

#include <memory>

#include "contact_solver.h"
#include "direct_solver.h"
#include "step_solver.h"
#include "thermoviscoelastic_operator.h"

namespace ThermoContact
{
  /**
   * The monolithic stage: both fields at once and contact exactly, doc/model.md
   * (M.15)-(M.18). One factorisation per stage length; the response to unit
   * pressures is computed when a node first reaches the obstacle.
   */
  template <int dim>
  class StageSolver : public StepSolver
  {
  public:
    /** The references are borrowed. */
    StageSolver(const Discretization<dim>             &discretization,
                const ThermoviscoelasticOperator<dim> &stage_operator,
                const ContactLaw                      &law);

    void
    solve(const State  &known,
          const double  tau,
          const Vector &heat_load,
          const Vector &momentum_load,
          StageRates   &rates) override;

    types::global_dof_index
    n_factorized_unknowns() const override;

  private:
    const Discretization<dim>             &discretization;
    const ThermoviscoelasticOperator<dim> &stage_operator;
    const ContactLaw                       law;
    const ContactSolver                    contact_solver;

    double                        factorized_tau;
    std::unique_ptr<DirectSolver> solver;
    std::vector<Vector>           unit_responses; ///< rates, whole system
    FullMatrix<double>            response;       ///< $W$

    Vector              heat_rhs;
    Vector              momentum_rhs;
    Vector              system_rhs;
    Vector              system_rates;
    std::vector<double> known_displacement;
    std::vector<double> free_displacement;

    void
    factorize(const double tau);

    void
    compute_response();
  };
} // namespace ThermoContact

#endif
