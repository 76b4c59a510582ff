// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef thermocontact_time_driven_step_h
#define thermocontact_time_driven_step_h

#include <thermocontact/space/body.h>
#include <thermocontact/time/prescribed_motion.h>
#include <thermocontact/time/stage_solver.h>

namespace ThermoContact
{
  /**
   * A step of a body whose fixed end may be heated or moved: the equations and
   * rates of its stages with the motion of the end, doc/discretisation.md
   * (D6.1). Where the end rests all of it does nothing.
   */
  template <int dim>
  class DrivenStep
  {
  public:
    /** @param body borrowed */
    explicit DrivenStep(const Body<dim> &body);

    bool
    is_active() const
    {
      return body.driven_end.is_active();
    }

    /** Begins a step by @p size from @p state. */
    void
    start(const State &state, const double size, const StageTimes &stages);

    /** Loads of a stage, of heat and momentum; borrowed. */
    struct StageLoads
    {
      const Vector &heat;
      const Vector &momentum;
    };

    /**
     * Puts the motion of a stage into its known values and into copies of the
     * loads.
     *
     * @return the copies, or the loads themselves
     */
    StageLoads
    constrain(const unsigned int stage, const StageLoads &loads, State &known);

    /** Gives a stage that has been solved the rates of its end, with the
     * acceleration. */
    void
    complete(const unsigned int stage, StageRates &rates) const;

  private:
    const Body<dim> &body;
    Vector           heat_load;
    Vector           momentum_load;
    PrescribedMotion temperature, displacement; ///< of the end
  };
} // namespace ThermoContact

#endif
