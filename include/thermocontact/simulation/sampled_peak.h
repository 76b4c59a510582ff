// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef thermocontact_simulation_sampled_peak_h
#define thermocontact_simulation_sampled_peak_h

#include <algorithm>

namespace ThermoContact
{
  /**
   * The largest value of a quantity that is known at step ends, and what it may
   * have been between them: the vertex of the parabola through the largest
   * value and its neighbours, (M.87). Arithmetic only.
   */
  class SampledPeak
  {
  public:
    /** Takes the next value; of one time the last one counts. */
    void
    add(const double time, const double value)
    {
      if (n_samples > 0 && time == now.time)
        --n_samples; // replaced
      else
        {
          before = last;
          last   = now;
        }
      now = {time, value};
      ++n_samples;
      if (n_samples == 1 || value >= largest)
        largest = estimate_ = value;
      else if (n_samples > 2 && last.value == largest)
        estimate_ = vertex();
    }

    /** Not below the largest value. */
    double
    estimate() const
    {
      return estimate_;
    }

    template <class Archive>
    void
    serialize(Archive &archive, const unsigned int)
    {
      archive &before &last &now &n_samples &largest &estimate_;
    }

  private:
    struct Sample
    {
      double time  = 0.;
      double value = 0.;

      template <class Archive>
      void
      serialize(Archive &archive, const unsigned int)
      {
        archive &time &value;
      }
    };

    Sample       before, last, now;
    unsigned int n_samples = 0;
    double       largest   = 0.;
    double       estimate_ = 0.;

    double
    vertex() const
    {
      const double rise =
        (last.value - before.value) / (last.time - before.time);
      const double fall = (now.value - last.value) / (now.time - last.time);
      const double curvature = (fall - rise) / (now.time - before.time);
      if (!(curvature < 0.))
        return std::max(largest, estimate_);
      const double slope = rise + curvature * (last.time - before.time);
      return std::max(last.value - slope * slope / (4. * curvature), estimate_);
    }
  };
} // namespace ThermoContact

#endif
