// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef thermocontact_stage_solver_h
#define thermocontact_stage_solver_h

#include <deal.II/lac/full_matrix.h>

#include <list>
#include <memory>

#include "contact_solver.h"
#include "direct_solver.h"
#include "step_solver.h"
#include "thermoviscoelastic_operator.h"

namespace ThermoContact
{
  /**
   * The monolithic stage: both fields at once and contact exactly, doc/model.md
   * (M.15)-(M.18). One factorisation per stage length; those used last are
   * kept, since error-controlled steps come back to few sizes. The response to
   * unit pressures is computed when a node first reaches the obstacle.
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
          ContactMode   mode,
          StageRates   &rates) override;

    types::global_dof_index
    n_factorized_unknowns() const override;

  private:
    const Discretization<dim>             &discretization;
    const ThermoviscoelasticOperator<dim> &stage_operator;
    const ContactLaw                       law;
    const ContactSolver                    contact_solver;

    /** The stage matrix for one stage length and what goes with it. */
    struct Factorization
    {
      double                        tau;
      std::unique_ptr<DirectSolver> solver;
      std::vector<Vector>           unit_responses; ///< rates, whole system
      FullMatrix<double>            response;       ///< $W$
    };

    const unsigned int       max_factorizations;
    std::list<Factorization> factorizations; ///< the one used last in front

    Vector              heat_rhs;
    Vector              momentum_rhs;
    Vector              system_rhs;
    Vector              system_rates;
    std::vector<double> known_displacement;
    std::vector<double> free_displacement;

    /** Puts the factorisation for @p tau in front. */
    void
    provide_factorization(const double tau);

    void
    compute_response(Factorization &factorization);

    /** Pressures from the displacements without contact. */
    void
    solve_contact(Factorization    &factorization,
                  const State      &known,
                  const ContactMode mode,
                  StageRates       &rates);
  };
} // namespace ThermoContact

#endif
