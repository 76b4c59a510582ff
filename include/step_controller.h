// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef thermocontact_step_controller_h
#define thermocontact_step_controller_h

#include "parameters.h"

namespace ThermoContact
{
  /** One step of the time loop: from the present time to @p end. */
  struct TimeStep
  {
    unsigned int number = 0;  ///< from 1
    double       size   = 0.; ///< $\Delta t$
    double       end    = 0.; ///< time at its end
  };



  /**
   * Fixed steps of $\Delta t$ up to $T$, which is hit exactly: the last step is
   * shortened unless it differs from $\Delta t$ by rounding only. Times are
   * multiples of $\Delta t$, so that rounding does not accumulate. Arithmetic
   * only.
   */
  class StepController
  {
  public:
    explicit StepController(const Parameters &parameters)
      : step_size(parameters.time.step_size)
      , end_time(parameters.time.end_time)
      , n_steps(parameters.time.n_steps())
    {}

    /** The step after step @p number; number < n_steps(). */
    TimeStep
    propose(const unsigned int number) const
    {
      if (number + 1 < n_steps)
        return {number + 1, step_size, (number + 1) * step_size};
      const double remainder = end_time - number * step_size;
      const bool   is_full =
        remainder > (1. - 1e-6) * step_size && remainder <= 1.001 * step_size;
      return {number + 1, is_full ? step_size : remainder, end_time};
    }

    bool
    is_finished(const unsigned int number) const
    {
      return number >= n_steps;
    }

  private:
    const double       step_size;
    const double       end_time;
    const unsigned int n_steps;
  };
} // namespace ThermoContact

#endif
