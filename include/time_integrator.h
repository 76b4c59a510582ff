// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef thermocontact_time_integrator_h
#define thermocontact_time_integrator_h

#include <string>

#include "energy.h"
#include "problem_data.h"
#include "step_controller.h"
#include "step_solver.h"
#include "thermoviscoelastic_operator.h"

namespace ThermoContact
{
  /** A step that has been computed but not yet accepted. */
  struct StepResult
  {
    State        state;                      ///< at the end of the step
    EnergyTerms  energy;                     ///< of that state
    double       work                  = 0.; ///< $W$ of (M.25)
    double       dissipation           = 0.; ///< $D$ of (M.23)
    double       numerical_dissipation = 0.; ///< $N$ of (M.24)
    unsigned int n_iterations          = 0;
    bool         is_prescribed = false; ///< the paper's first step, (M.26)
    std::string  failure;               ///< empty: the step is solved
  };



  /**
   * Backward Euler: one stage of length $\Delta t$ whose known values are the
   * old state, equations (3.1), (3.2) of the paper; and the paper's first step.
   */
  template <int dim>
  class TimeIntegrator
  {
  public:
    /** The references are borrowed. */
    TimeIntegrator(const Discretization<dim>             &discretization,
                   const ThermoviscoelasticOperator<dim> &stage_operator,
                   const Energy<dim>                     &energy,
                   const ContactLaw                      &law,
                   ProblemData<dim>                      &data,
                   StepSolver                            &step_solver);

    /**
     * One step with all equations solved.
     *
     * @param result out; reuses the memory of an earlier result
     */
    void
    step(const State &state, const TimeStep &time_step, StepResult &result);

    /**
     * The start of the paper, (M.26): the displacement moves with the present
     * velocity, then the heat equation is solved. No stage is solved, so that
     * the pressure is that of the compliance law, and the defect of the energy
     * balance is booked as numerical dissipation, of either sign. The caller
     * has made sure that a rigid obstacle is not penetrated.
     */
    void
    prescribed_step(const State    &state,
                    const TimeStep &time_step,
                    StepResult     &result);

    /** What the prescribed steps have spent; the rest is the step solver's. */
    const SolverCounters &
    counters() const
    {
      return counters_;
    }

  private:
    const Discretization<dim>             &discretization;
    const ThermoviscoelasticOperator<dim> &stage_operator;
    const Energy<dim>                     &energy;
    const ContactLaw                       law;
    ProblemData<dim>                      &data;
    StepSolver                            &step_solver;
    SolverCounters                         counters_;
    StageRates                             rates;
    Vector                                 heat_load;
    Vector                                 momentum_load;

    /** Energy, dissipation and work of a step whose end state is known. */
    void
    balance(const TimeStep &time_step, StepResult &result) const;
  };
} // namespace ThermoContact

#endif
