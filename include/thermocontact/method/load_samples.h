// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef thermocontact_method_load_samples_h
#define thermocontact_method_load_samples_h

#include <thermocontact/method/load_history.h>

#include <vector>

namespace ThermoContact
{
  /** The values of a load at one time, at several places. */
  struct TimedValues
  {
    double              time;
    std::vector<double> values;
  };



  /** The next time that a double can hold. */
  double
  next_time(const double time);

  /** Largest difference of two values at one place. */
  double
  distance(const std::vector<double> &a, const std::vector<double> &b);



  /** Smallest and largest values. */
  class ValueRange
  {
  public:
    void
    add(const std::vector<double> &values);

    /** Largest distance of the two at one place; 0 without values. */
    double
    variation() const;

  private:
    std::vector<double> smallest, largest;
  };



  /** Thrown where a load has no history. */
  struct UnresolvedLoad
  {
    double time;
    bool   is_infinite;
  };



  /** A load at many times in $[0,T]$, in order; more can be asked for. */
  class LoadSamples
  {
  public:
    /** Intervals of equal length. */
    static constexpr unsigned int n_intervals = 1 << 15;

    /**
     * @param load borrowed
     * @throw UnresolvedLoad if a value is not finite
     */
    LoadSamples(const LoadSample          &load,
                const double               end_time,
                const std::vector<double> &named_times);

    /**
     * The values at one more time, which are not kept.
     *
     * @throw UnresolvedLoad if one is not finite, or after so many times that
     *   more would not be worth it
     */
    TimedValues
    at(const double time);

    /** All that are kept. */
    const std::vector<TimedValues> &
    all() const
    {
      return samples;
    }

    /** Those at the ends of intervals of equal length. */
    const std::vector<TimedValues> &
    uniform() const
    {
      return uniform_samples;
    }

    double
    end_time() const
    {
      return uniform_samples.back().time;
    }

    /** Variation over all times. */
    double
    variation() const
    {
      return range.variation();
    }

    /**
     * The same, or what is to be told apart from the rounding of the values or
     * of time if that is more: small parts of it do not matter.
     */
    double
    scale() const;

  private:
    const LoadSample        &load;
    unsigned int             n_asked;
    std::vector<TimedValues> samples;
    std::vector<TimedValues> uniform_samples;
    ValueRange               range;

    /** Times ever closer around one that is named. */
    void
    add_around(const double time);

    void
    sort();
  };
} // namespace ThermoContact

#endif
