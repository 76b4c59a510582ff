// SPDX-License-Identifier: LGPL-2.1-or-later

#include <thermocontact/method/bracketed_root.h>
#include <thermocontact/method/cubic_hermite.h>
#include <thermocontact/simulation/sampled_peak.h>

#include <algorithm>
#include <cmath>

namespace ThermoContact
{
  void
  SampledPeak::add(const double time, const double value, const double rate)
  {
    const bool is_replaced = n_samples > 0 && time == now.time;
    if (is_replaced)
      {
        --n_samples;
        std::move(recent.begin() + 1, recent.end(), recent.begin());
        n_behind -= n_behind > 0;
      }
    else
      {
        before = last;
        last   = now;
      }
    now = {time, value, rate};
    ++n_samples;
    if (n_samples == 1 || value >= largest)
      {
        in_front   = recent;
        n_behind   = 0;
        this->time = time;
      }
    else if (n_behind < n_of_ringing)
      behind[n_behind++] = value;
    std::move_backward(recent.begin(), recent.end() - 1, recent.end());
    recent[0] = value;
    if (n_samples == 1 || value >= largest)
      largest = of_parabola = value;
    else if (n_samples > 2 && last.value == largest &&
             (std::isnan(rate) || !(before.value > 0.)))
      of_parabola = std::max(of_parabola, vertex());
    if (!std::isnan(rate))
      {
        double &top = has_kink() ? of_kinks : of_cubics;
        top         = std::max(top, top_of_step());
      }
  }



  double
  SampledPeak::change_beside() const
  {
    const auto least = [this](const double *const values,
                              const unsigned int  n) {
      double change = infinity, next = largest;
      for (unsigned int i = 0; i < n && values[i] > 0.; ++i)
        {
          change = std::min(change, std::abs(next - values[i]));
          next   = values[i];
        }
      return std::isinf(change) ? 0. : change;
    };
    return std::max(least(in_front.data(), n_beside),
                    least(behind.data(), std::min(n_behind, n_beside)));
  }



  double
  SampledPeak::ringing() const
  {
    const auto end    = behind.begin() + n_behind;
    const auto lowest = std::min_element(behind.begin(), end);
    return n_behind == 0 || lowest + 1 == end || !(*lowest > 0.) ?
             0. :
             largest - *lowest;
  }



  double
  SampledPeak::vertex() const
  {
    const double rise = (last.value - before.value) / (last.time - before.time);
    const double fall = (now.value - last.value) / (now.time - last.time);
    const double curvature = (fall - rise) / (now.time - before.time);
    if (!(curvature < 0.))
      return largest;
    const double slope = rise + curvature * (last.time - before.time);
    return last.value - slope * slope / (4. * curvature);
  }



  double
  SampledPeak::top_of_step() const
  {
    if (n_samples < 2 || !(last.value > 0. && now.value > 0.) ||
        !(last.rate > 0. && now.rate < 0.))
      return largest;
    const double       size = now.time - last.time;
    const CubicHermite cubic(last.value,
                             size * last.rate,
                             now.value,
                             size * now.rate);
    const double       x =
      bracketed_root([&cubic](const double x) { return cubic.slope(x); },
                     0.,
                     1.)
        .first;
    return cubic.value(x);
  }



  bool
  SampledPeak::has_kink() const
  {
    if (n_samples < 2)
      return false;
    // The slope of the secant is the mean of the rates to second order in the
    // step where the force is smooth. Behind a kink at the beginning, where the
    // force is straight, it is the rate at the end, off by half of the change
    // of the rate; half of that is between the two.
    const double secant = (now.value - last.value) / (now.time - last.time);
    return std::abs(secant - 0.5 * (last.rate + now.rate)) >
           0.25 * std::abs(now.rate - last.rate);
  }
} // namespace ThermoContact
