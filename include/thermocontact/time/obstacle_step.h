// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef thermocontact_time_obstacle_step_h
#define thermocontact_time_obstacle_step_h

#include <thermocontact/input/time_function.h>
#include <thermocontact/method/butcher_tableau.h>
#include <thermocontact/space/body.h>
#include <thermocontact/time/driven_step.h>

#include <vector>

namespace ThermoContact
{
  /**
   * A Runge-Kutta step of a body whose obstacle moves: where the obstacle is at
   * each stage, doc/model.md (M.109). Its gaps follow their rates as all other
   * unknowns do, the rates shifted such that the step ends at the gaps of its
   * end: so the schemes keep their orders, and what the obstacle does to the
   * body is the pressure times these rates.
   */
  template <int dim>
  class ObstacleStep
  {
  public:
    /** @param body borrowed, before an obstacle that moves */
    explicit ObstacleStep(const Body<dim> &body);

    /**
     * Begins a step by @p size from @p state.
     *
     * @param begin the first time with the rates of the step
     */
    void
    start(const State      &state,
          const double      begin,
          const double      size,
          const StageTimes &stages);

    /**
     * Puts the obstacle of stage @p i where it is at the end of the stage.
     *
     * @param known in, out: known values of the stage
     */
    void
    place(const ButcherTableau &tableau,
          const unsigned int    i,
          State                &known) const;

    /**
     * Nodes with mass that a rigid obstacle holds move with it: their known
     * velocities are those from which they reach its velocity with its
     * acceleration; (M.110).
     */
    void
    hold(const unsigned int i, const double tau, State &known) const;

  private:
    const Body<dim>    &body;
    double              size = 0.;
    std::vector<double> old_gap;

    /** Of the stages, one for each node. */
    std::vector<std::vector<double>> velocities;
    std::vector<std::vector<double>> accelerations;

    // memory
    std::vector<TimeDerivatives> obstacle, old_obstacle;
    std::vector<double>          old_velocity;
  };
} // namespace ThermoContact

#endif
