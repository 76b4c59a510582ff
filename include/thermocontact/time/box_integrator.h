// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef thermocontact_time_box_integrator_h
#define thermocontact_time_box_integrator_h

#include <thermocontact/time/driven_step.h>
#include <thermocontact/time/monolithic_solver.h>
#include <thermocontact/time/time_integrator.h>

#include <vector>

namespace ThermoContact
{
  /**
   * The scheme without dispersion, doc/contact-in-time.md section 6: the
   * midpoint rule on equal linear cells whose mass is taken at their midpoints,
   * in steps in which a wave passes one of them. One stage of length
   * $\Delta t/2$, whose matrix and factorisation are those of other schemes;
   * the contact node keeps its mass, and is one.
   */
  class BoxIntegrator : public TimeIntegrator
  {
  public:
    /** @param body borrowed */
    explicit BoxIntegrator(Body<1> &body);

    void
    step(const State      &state,
         const TimeStep   &time_step,
         const ContactMode mode,
         StepResult       &result) override;

    StageSolver &
    stage_solver() override
    {
      return solver;
    }

  private:
    Body<1>            &body;
    MonolithicSolver<1> solver;

    DrivenStep<1> driven; ///< of a fixed end that is heated

    StageRates rates;
    State      midpoint;
    State      obstacle; ///< gaps alone, at the end of the step
    Vector     heat_load;
    Vector     momentum_load;
    Vector     acceleration; ///< of an end that rests

    /**
     * The pressure is the mean that conserves energy, $\varepsilon\ge h/2$,
     * from where on the mesh follows the obstacle without overshooting. Else it
     * is that of the law at the end of the step, which takes energy; (C6.9).
     */
    bool has_mean_pressure = false;

    std::vector<NodeLaw> laws;         ///< of the contact node in the step
    std::vector<double>  start;        ///< its position at the beginning
    std::vector<double>  end_position; ///< and at the end, without contact

    /** Where the obstacle will be, and its mean velocity. */
    void
    move_obstacle(const State &state, const TimeStep &time_step);

    /** The stage to the middle of the step, with a driven end. */
    void
    solve_without_contact(const State &state, const TimeStep &time_step);

    /** Finds $\bar p$ and adds its response to the rates. */
    void
    apply_contact(const State &state, const TimeStep &time_step);
  };
} // namespace ThermoContact

#endif
