// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef thermocontact_time_prescribed_motion_h
#define thermocontact_time_prescribed_motion_h

#include <thermocontact/input/time_function.h>
#include <thermocontact/space/driven_end.h>

#include <functional>
#include <vector>

namespace ThermoContact
{
  /** The stages of a Runge-Kutta step. */
  struct StageTimes
  {
    const std::vector<std::vector<double>> &a; ///< lower triangle
    const std::vector<double>              &weights;
    std::vector<double> times; ///< at which loads are taken; last: of the end
  };



  /**
   * Scalars that are functions of time, in the stages of a Runge-Kutta step:
   * temperatures and displacements of the fixed end, gaps of an obstacle that
   * moves; doc/discretisation.md (D6.1), (C8.1). Rates are those of the
   * functions, all shifted alike so that the step ends at the right value;
   * values follow from rates as for all other unknowns: so schemes keep their
   * orders. A motion with inertia has rates that follow the second
   * derivatives in the same way, as the velocities of all nodes around it do: a
   * viscous body would answer the difference by accelerations of low order.
   * Where a function has no derivative, jumps, or starts from another value,
   * the rates still lead to its value.
   */
  class PrescribedMotion
  {
  public:
    /**
     * Begins a step.
     *
     * @param old_values at its beginning
     * @param has_inertia rates are to follow second derivatives
     * @param functions_at of each scalar at a time
     */
    void
    start(
      const StageTimes                                          &stages,
      const double                                               size,
      const std::vector<double>                                 &old_values,
      const bool                                                 has_inertia,
      const std::function<std::vector<TimeDerivatives>(double)> &functions_at);

    /**
     * Shifts second derivatives likewise, such that they lead from rates at the
     * beginning of the step to those at its end; to be called after start().
     */
    void
    set_accelerations(const std::vector<double> &old_rates,
                      const std::vector<double> &new_rates);

    const std::vector<PrescribedStage> &
    stages() const
    {
      return stages_;
    }

  private:
    double                       size = 0.;
    std::vector<double>          weights;
    std::vector<PrescribedStage> stages_;

    /**
     * Rates of scalar @p k that its second derivatives lead from stage to stage
     * to that at the end of the step; those without a number are left alone.
     */
    void
    integrate_accelerations(const StageTimes &stages, const unsigned int k);
  };
} // namespace ThermoContact

#endif
