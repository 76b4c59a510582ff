// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef thermocontact_time_fixed_point_solver_h
#define thermocontact_time_fixed_point_solver_h

#include <thermocontact/space/body.h>
#include <thermocontact/space/linear_system.h>
#include <thermocontact/time/stage_solver.h>

#include <memory>
#include <string>
#include <vector>

namespace ThermoContact
{
  /**
   * The iteration (3.3)-(3.4) of the paper, doc/discretisation.md (D7.1): heat
   * with the last velocity, then momentum with the new temperature and the last
   * contact pressure; one factorisation per field, or V-cycles for both. Needs
   * an elastic obstacle or none.
   *
   * It converges for small stages only: the contact part contracts by
   * $\rho=\chi/\varepsilon$, (D7.2). Not far past that limit it settles into a
   * bounded 2-cycle, so that a stage that has not converged within the allowed
   * iterations is a failure. Converged: the largest change of a displacement
   * is below the tolerance times the largest displacement (or the gap as long
   * as nothing moves).
   */
  template <int dim>
  class FixedPointSolver : public StageSolver
  {
  public:
    /** @param body borrowed */
    explicit FixedPointSolver(const Body<dim> &body);

    void
    solve(const State  &known,
          const double  tau,
          const Vector &heat_load,
          const Vector &momentum_load,
          ContactMode   mode,
          StageRates   &rates) override;

    types::global_dof_index
    n_factorized_unknowns() const override;

    std::string
    linear_solver() const override
    {
      return body.equations.is_eliminated_along_rod() ?
               "block tridiagonal" :
               body.scene.linear_solver.name();
    }

    RetainedFactorizations
    retained() const override;

    void
    restore(const RetainedFactorizations &retained) override;

  private:
    const Body<dim>   &body;
    const double       tolerance;
    const unsigned int max_iterations;

    double                                factorized_tau;
    const std::unique_ptr<Preconditioner> preconditioner; ///< or null
    std::unique_ptr<LinearSystem<dim>>    heat_system;
    std::unique_ptr<LinearSystem<dim>>    momentum_system;

    Vector               heat_rhs;
    Vector               momentum_rhs;
    Vector               rhs;
    Vector               momentum_stage_rhs;
    Vector               last_velocity;
    std::vector<NodeLaw> laws;
    std::vector<double>  known_position;
    std::vector<double>  contact_velocity;

    void
    factorize(const double tau);

    /** Solves for one field to rounding, which the iteration does not see. */
    void
    solve_field(const LinearSystem<dim> &system,
                const Vector            &right,
                Vector                  &solution);

    /** Pressure of the compliance law (M1.4) at the end of the stage. */
    void
    update_pressure(const double tau, StageRates &rates);

    /**
     * The contraction factor (D7.2) of the contact part in the present stage,
     * of length @p tau: $\chi/\varepsilon$ with $\chi$ the largest eigenvalue
     * of the response of the momentum matrix to contact pressures; 0 without
     * an obstacle.
     */
    double
    contraction_factor(const double tau);

    std::string
    describe_failure(const double       tau,
                     const unsigned int n_iterations,
                     const double       change,
                     const double       last_change);
  };
} // namespace ThermoContact

#endif
