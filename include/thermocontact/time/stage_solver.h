// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef thermocontact_time_stage_solver_h
#define thermocontact_time_stage_solver_h

#include <thermocontact/method/contact_solver.h>
#include <thermocontact/space/thermoviscoelastic_operator.h>
#include <thermocontact/time/stage_factorization.h>
#include <thermocontact/time/step_solver.h>

#include <deal.II/lac/full_matrix.h>

#include <list>

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

    SolverMemory
    memory() const override;

    void
    restore(const SolverMemory &memory) override;

    /**
     * The rates of a stage for zero pressures, to be followed by
     * apply_pressure(); parameters as for solve().
     */
    void
    solve_without_contact(const State  &known,
                          const double  tau,
                          const Vector &heat_load,
                          const Vector &momentum_load,
                          StageRates   &rates);

    /** $W$ of (M.16) for the stage that was solved last. */
    const FullMatrix<double> &
    response();

    /**
     * Adds the response to @p rates.pressure to the rates of the stage that was
     * solved last without contact.
     */
    void
    apply_pressure(StageRates &rates) const;

  private:
    const Discretization<dim>             &discretization;
    const ThermoviscoelasticOperator<dim> &stage_operator;
    const ContactLaw                       law;
    const ContactSolver                    contact_solver;

    /** Rates per unit pressure at a node, with the sign reversed. */
    struct UnitResponse
    {
      Vector temperature_rate;
      Vector velocity;
    };

    /** The stage matrix for one stage length and what goes with it. */
    struct Factorization
    {
      StageFactorization<dim>   matrix;
      std::vector<UnitResponse> unit_responses;
      FullMatrix<double>        response; ///< $W$
    };

    const unsigned int       max_factorizations;
    std::list<Factorization> factorizations; ///< the one used last in front

    Vector              heat_rhs;
    Vector              momentum_rhs;
    std::vector<double> known_displacement;
    std::vector<double> free_displacement;

    /** Puts the factorisation for @p tau in front. */
    void
    provide_factorization(const double tau);

    void
    compute_response(Factorization &factorization);

    /** Pressures from the displacements without contact. */
    void
    solve_contact(const State      &known,
                  const ContactMode mode,
                  StageRates       &rates);
  };
} // namespace ThermoContact

#endif
