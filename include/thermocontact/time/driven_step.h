// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef thermocontact_time_driven_step_h
#define thermocontact_time_driven_step_h

#include <thermocontact/space/body.h>
#include <thermocontact/time/stage_solver.h>
#include <thermocontact/time/step_controller.h>

#include <vector>

namespace ThermoContact
{
  /** The stages of a Runge-Kutta step: times and weights. */
  struct StageTimes
  {
    std::vector<double>        times; ///< at which loads are taken
    const std::vector<double> &weights;
  };



  /**
   * A step of a body whose fixed end is heated or moved: what the end does at
   * each stage, doc/model.md (M.90), and the equations and rates of the stage
   * with it. The rates of the end are those of the drive, all of them shifted
   * by what lets the step end at its value; where the drive has no derivative,
   * jumps, or starts from another value, they still lead there.
   */
  template <int dim>
  class DrivenStep
  {
  public:
    /** @param body borrowed, with a driven end */
    explicit DrivenStep(const Body<dim> &body);

    /** Begins a step by @p size from @p state. */
    void
    start(const State &state, const double size, const StageTimes &stages);

    /**
     * Puts the motion of a stage of length @p tau into its known values and
     * into copies of the loads: heat_load(), momentum_load().
     */
    void
    constrain(const unsigned int stage,
              const double       tau,
              const Vector      &heat_load,
              const Vector      &momentum_load,
              State             &known);

    const Vector &
    heat_load() const
    {
      return heat_load_;
    }

    const Vector &
    momentum_load() const
    {
      return momentum_load_;
    }

    /** Gives a stage that has been solved the rates of its end. */
    void
    complete(StageRates &rates, Vector &acceleration) const;

  private:
    const Body<dim> &body;
    Vector           heat_load_;
    Vector           momentum_load_;
    EndMotion        motion; ///< of the present stage

    /** Mean rates of the step at each entry of the end. */
    std::vector<double> mean_temperature_rate;
    std::vector<double> mean_velocity;
    std::vector<double> mean_acceleration;

    /** How rates of the drive differ from their mean, at each stage. */
    std::vector<double> temperature_deviations;
    std::vector<double> velocity_deviations;
    std::vector<double> acceleration_deviations;
  };
} // namespace ThermoContact

#endif
