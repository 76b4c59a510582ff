// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef thermocontact_simulation_sampled_peak_h
#define thermocontact_simulation_sampled_peak_h

#include <thermocontact/base/special_numbers.h>

#include <boost/serialization/array.hpp>

#include <algorithm>
#include <array>

namespace ThermoContact
{
  /**
   * The largest value of a quantity that is known at step ends, and what it may
   * have been between them, (D9.2): with rates the largest value of the cubics
   * that have the values and the rates of the ends of a step; without them, or
   * where the step before the largest value has no cubic, the vertex of the
   * parabola through the largest value and its neighbours. A cubic beside a
   * kink, whose rates do not go with its values, is a doubt: an estimate, no
   * value. Arithmetic only.
   */
  class SampledPeak
  {
  public:
    /**
     * Takes the next value; of one time the last one counts.
     *
     * @param rate of the quantity there, per unit of time; NaN: not known. The cubic of a step needs positive values at its ends: a force that is zero without contact has no rate there
     */
    void
    add(const double time, const double value, const double rate = nan);

    /** The largest of all values and of the cubics without a kink. */
    double
    top() const
    {
      return std::max(largest, of_cubics);
    }

    /** Of the largest of all values, the last one of several. */
    double
    time_of_largest() const
    {
      return time;
    }

    /** Not below it. */
    double
    estimate() const
    {
      return std::max({of_parabola, of_cubics, of_kinks});
    }

    /**
     * How much a quantity that jumps or has a cusp next to its largest value
     * goes on in a step beside it. Of the steps there, before it or behind it,
     * the one of least change counts, since the jump itself takes two of them,
     * and there may be another one; steps from or to values that are not
     * positive do not.
     */
    double
    change_beside() const;

    /** How far the quantity falls behind its largest value before it rises
     * again within a few steps; 0 if it does not. */
    double
    ringing() const;

    template <class Archive>
    void
    serialize(Archive &archive, const unsigned int)
    {
      archive &before &last &now &n_samples &largest &time &of_parabola
        &of_cubics &of_kinks &recent &in_front &behind &n_behind;
    }

  private:
    struct Sample
    {
      double time  = 0.;
      double value = 0.;
      double rate  = 0.;

      template <class Archive>
      void
      serialize(Archive &archive, const unsigned int)
      {
        archive &time &value &rate;
      }
    };

    Sample       before, last, now;
    unsigned int n_samples   = 0;
    double       largest     = 0.;
    double       time        = 0.; ///< of it
    double       of_parabola = 0.; ///< not below the largest
    double       of_cubics   = 0.; ///< of steps without a kink
    double       of_kinks    = 0.; ///< of cubics of the other steps

    static constexpr unsigned int n_beside = 4, n_of_ringing = 8;

    /** The last values, the last one first; when the largest one came; and
     * those behind it. */
    std::array<double, n_beside>     recent{}, in_front{};
    std::array<double, n_of_ringing> behind{};
    unsigned int                     n_behind = 0;

    /** Of the parabola through all three samples. */
    double
    vertex() const;

    /** Of the cubic between the last two. */
    double
    top_of_step() const;

    /** True if the secant of the last step is nearer to the rate at one of its
     * ends than to the mean of both; false without rates. */
    bool
    has_kink() const;
  };
} // namespace ThermoContact

#endif
