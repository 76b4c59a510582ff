// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef thermocontact_time_newton_stage_h
#define thermocontact_time_newton_stage_h

#include <thermocontact/time/driven_step.h>
#include <thermocontact/time/monolithic_solver.h>

namespace ThermoContact
{
  /**
   * A stage of a body whose coefficients depend on the temperature: Newton's
   * method, each iteration of which is a stage with the tangents at the last
   * one, with contact in it, doc/discretisation.md (D2.3).
   */
  template <int dim>
  class NewtonStage
  {
  public:
    /** @param body borrowed; has NonlinearTerms */
    explicit NewtonStage(const Body<dim> &body);

    StageSolver &
    solver()
    {
      return linear;
    }

    /**
     * @param i number of the stage, for the motion of the ends
     * @param tau its length
     * @param mode as of StageSolver::solve()
     * @param driven motion of the ends in this step
     * @param known known values; out: at driven ends those at its end
     * @param heat_load,momentum_load in: loads of the stage; out: with what the
     *   coefficients add at its end, so that the matrices of the body hold
     * @param stage out: as of StageSolver::solve(); a stage that does not
     *   converge or leaves the range of the coefficients has a failure
     */
    void
    solve(const unsigned int i,
          const double       tau,
          const ContactMode  mode,
          DrivenStep<dim>   &driven,
          State             &known,
          Vector            &heat_load,
          Vector            &momentum_load,
          StageRates        &stage);

  private:
    const Body<dim>      &body;
    MonolithicSolver<dim> linear;

    State      end;            ///< of the stage, in the last iteration
    StageRates full;           ///< its rates with those of the ends of the body
    Vector     heat, momentum; ///< loads of an iteration
    Vector     heat_product, momentum_product; ///< of rates
    Vector     last_rate, last_velocity;

    /** The end of a stage with these rates. */
    void
    set_end(const unsigned int     i,
            const double           tau,
            const DrivenStep<dim> &driven,
            const State           &known,
            const StageRates      &stage);

    /**
     * Loads for the tangents at the end that was set, by which the solver
     * solves.
     */
    void
    linearize(const double tau, const StageRates &stage);

    /** The last change of the end of a stage by an iteration, of its size. */
    double
    change(const double tau, const State &known, const StageRates &stage) const;
  };
} // namespace ThermoContact

#endif
