// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef thermocontact_time_driven_step_h
#define thermocontact_time_driven_step_h

#include <thermocontact/space/body.h>
#include <thermocontact/time/prescribed_motion.h>
#include <thermocontact/time/stage_solver.h>

namespace ThermoContact
{
  /**
   * A step of a body whose fixed end is heated or moved: the equations and
   * rates of its stages with the motion of the end, doc/discretisation.md
   * (D6.1).
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
     * Puts the motion of a stage into its known values and into copies of the
     * loads: heat_load(), momentum_load().
     */
    void
    constrain(const unsigned int stage,
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
    complete(const unsigned int stage,
             StageRates        &rates,
             Vector            &acceleration) const;

  private:
    const Body<dim> &body;
    Vector           heat_load_;
    Vector           momentum_load_;
    PrescribedMotion temperature, displacement; ///< of the end
  };
} // namespace ThermoContact

#endif
