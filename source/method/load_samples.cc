// SPDX-License-Identifier: LGPL-2.1-or-later

#include <thermocontact/method/load_samples.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace ThermoContact
{
  namespace
  {
    /** Around a named time the spacing goes down to $T$ over 2 to it. */
    constexpr int finest_level = 48;

    /** A variation below this part of the values counts as it. */
    constexpr double rounding_of_values = 1e-8;

    /** Parts of the end time. */
    constexpr double little_beyond = 1e-9;

    /** More evaluations, beside the first ones, are not worth their time. */
    constexpr unsigned int max_evaluations = 1 << 19;
  } // namespace



  double
  next_time(const double time)
  {
    return std::nextafter(time, std::numeric_limits<double>::infinity());
  }



  double
  distance(const std::vector<double> &a, const std::vector<double> &b)
  {
    double largest = 0.;
    for (unsigned int c = 0; c < a.size(); ++c)
      largest = std::max(largest, std::abs(a[c] - b[c]));
    return largest;
  }



  void
  ValueRange::add(const std::vector<double> &values)
  {
    if (smallest.empty())
      smallest = largest = values;
    for (unsigned int c = 0; c < values.size(); ++c)
      {
        smallest[c] = std::min(smallest[c], values[c]);
        largest[c]  = std::max(largest[c], values[c]);
      }
  }



  double
  ValueRange::variation() const
  {
    return distance(smallest, largest);
  }



  LoadSamples::LoadSamples(const LoadSample          &load,
                           const double               end_time,
                           const std::vector<double> &named_times)
    : load(load)
    , n_asked(0)
  {
    for (unsigned int i = 0; i < n_intervals; ++i)
      samples.push_back(at(end_time * i / n_intervals));
    samples.push_back(at(end_time));
    uniform_samples = samples;
    for (const double time : named_times)
      if (time >= 0. && time < end_time)
        add_around(time);
    sort();
    n_asked = 0;
    for (const TimedValues &sample : samples)
      range.add(sample.values);
  }



  TimedValues
  LoadSamples::at(const double time)
  {
    TimedValues sample{time, {}};
    load(time, sample.values);
    for (const double value : sample.values)
      if (!std::isfinite(value))
        throw UnresolvedLoad{time, true};
    if (++n_asked > max_evaluations)
      throw UnresolvedLoad{time, false};
    return sample;
  }



  double
  LoadSamples::scale() const
  {
    double largest = 0.;
    for (const TimedValues &sample : uniform_samples)
      for (const double value : sample.values)
        largest = std::max(largest, std::abs(value));
    // what bends at the end has begun to change there by the rounding of time;
    // what jumps behind it has not
    const auto change = [&](const double part) {
      std::vector<double> values;
      load(end_time() * (1. + part * little_beyond), values);
      return distance(uniform_samples.back().values, values);
    };
    const double whole = change(1.), half = change(0.5);
    return std::max(
      {variation(),
       rounding_of_values * largest,
       half <= 0.75 * whole && std::isfinite(whole) ? whole : 0.});
  }



  void
  LoadSamples::add_around(const double time)
  {
    samples.push_back(at(time));
    samples.push_back(at(next_time(time)));
    double distance = end_time() / n_intervals;
    for (int level = 15; level < finest_level; ++level)
      {
        distance *= 0.5;
        if (time - distance > 0.)
          samples.push_back(at(time - distance));
        if (time + distance < end_time())
          samples.push_back(at(time + distance));
      }
  }



  void
  LoadSamples::sort()
  {
    std::sort(samples.begin(),
              samples.end(),
              [](const TimedValues &a, const TimedValues &b) {
                return a.time < b.time;
              });
    samples.erase(std::unique(samples.begin(),
                              samples.end(),
                              [](const TimedValues &a, const TimedValues &b) {
                                return a.time == b.time;
                              }),
                  samples.end());
  }
} // namespace ThermoContact
