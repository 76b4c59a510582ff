// SPDX-License-Identifier: LGPL-2.1-or-later

#include <thermocontact/base/special_numbers.h>
#include <thermocontact/base/tolerances.h>
#include <thermocontact/method/load_history.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <set>

namespace ThermoContact
{
  namespace
  {
    /** Stretches that may overlap as some that do not, of the smallest width.
     */
    std::vector<LoadStretch>
    smallest_widths(const std::vector<LoadStretch> &stretches)
    {
      struct Bound
      {
        double time, width;
        bool   is_begin;
      };
      std::vector<Bound> bounds;
      for (const LoadStretch &s : stretches)
        {
          bounds.push_back({s.begin, s.width, true});
          bounds.push_back({s.end, s.width, false});
        }
      std::sort(bounds.begin(),
                bounds.end(),
                [](const Bound &a, const Bound &b) { return a.time < b.time; });
      std::vector<LoadStretch> result;
      std::multiset<double>    widths; // of bounds that have begun
      double                   begin = 0.;
      for (const Bound &bound : bounds)
        {
          if (!widths.empty() && bound.time > begin)
            {
              const double width = *widths.begin();
              if (!result.empty() && result.back().end == begin &&
                  result.back().width == width)
                result.back().end = bound.time;
              else
                result.push_back({begin, bound.time, width});
            }
          begin = bound.time;
          if (bound.is_begin)
            widths.insert(bound.width);
          else
            widths.erase(widths.find(bound.width));
        }
      return result;
    }
  } // namespace



  LoadBreak::LoadBreak(const double time, const bool is_jump)
    : time(time)
    , old_time(std::nextafter(time, 0.))
    , new_time(std::nextafter(time, infinity))
    , is_jump(is_jump)
  {}



  std::vector<LoadBreak>
  merged(std::vector<LoadBreak> breaks)
  {
    std::stable_sort(breaks.begin(),
                     breaks.end(),
                     [](const LoadBreak &a, const LoadBreak &b) {
                       return a.time < b.time;
                     });
    std::vector<LoadBreak> result;
    for (const LoadBreak &b : breaks)
      {
        if (result.empty() || !are_same_time(b.time, result.back().time))
          {
            result.push_back(b);
            continue;
          }
        LoadBreak &last       = result.back();
        const bool ends_steps = last.ends_steps || b.ends_steps;
        if (b.is_jump && !last.is_jump)
          last = b;
        else if (b.is_jump)
          last.new_time = std::max(last.new_time, b.new_time);
        last.ends_steps = ends_steps;
      }
    return result;
  }



  void
  LoadHistory::add_breaks(const std::vector<double> &times)
  {
    for (const double time : times)
      {
        const auto known =
          std::find_if(breaks.begin(), breaks.end(), [&](const LoadBreak &b) {
            return are_same_time(b.time, time);
          });
        if (known == breaks.end())
          breaks.push_back({time, true});
        else
          known->ends_steps = true;
      }
    breaks = merged(breaks);
  }



  void
  LoadHistory::add(const LoadHistory &other)
  {
    breaks.insert(breaks.end(), other.breaks.begin(), other.breaks.end());
    breaks = merged(breaks);
    stretches.insert(stretches.end(),
                     other.stretches.begin(),
                     other.stretches.end());
    stretches = smallest_widths(stretches);
  }



  void
  LoadHistory::end_at(const double end_time)
  {
    // sin(t) > 0 jumps at the first number that is not zero
    const double start =
      Tolerances::same_time * Tolerances::same_time * end_time;
    for (LoadBreak &b : breaks)
      if (b.time <= start)
        {
          b.time     = 0.;
          b.old_time = 0.;
        }
    for (LoadBreak &b : breaks)
      if (b.time < end_time && are_same_time(b.time, end_time))
        {
          b.time     = end_time;
          b.new_time = std::max(b.new_time, end_time);
        }
    breaks = merged(breaks);
  }



  namespace
  {
    /** The first break after @p time, or the end. */
    std::vector<LoadBreak>::const_iterator
    first_after(const std::vector<LoadBreak> &breaks, const double time)
    {
      return std::upper_bound(breaks.begin(),
                              breaks.end(),
                              time,
                              [](const double t, const LoadBreak &b) {
                                return t < b.time;
                              });
    }
  } // namespace



  const LoadBreak *
  LoadHistory::next_break(const double time) const
  {
    const auto next =
      std::find_if(first_after(breaks, time),
                   breaks.end(),
                   [](const LoadBreak &b) { return b.ends_steps; });
    return next == breaks.end() ? nullptr : &*next;
  }



  const LoadBreak *
  LoadHistory::break_at(const double time) const
  {
    const auto next = first_after(breaks, time);
    if (next != breaks.begin())
      if (const LoadBreak &last = *std::prev(next);
          last.time == time ||
          (!last.ends_steps && are_same_time(last.time, time)))
        return &last;
    return next != breaks.end() && !next->ends_steps &&
               are_same_time(next->time, time) ?
             &*next :
             nullptr;
  }



  std::vector<LoadBreak>
  LoadHistory::breaks_within(const double begin, const double end) const
  {
    std::vector<LoadBreak> within;
    for (auto b = first_after(breaks, begin);
         b != breaks.end() && b->time < end;
         ++b)
      if (!are_same_time(b->time, begin) && !are_same_time(b->time, end))
        within.push_back(*b);
    return within;
  }



  double
  LoadHistory::largest_step(const double time, const double size) const
  {
    auto   stretch = std::upper_bound(stretches.begin(),
                                    stretches.end(),
                                    time,
                                    [](const double t, const LoadStretch &s) {
                                      return t < s.end;
                                    });
    double largest = size;
    for (; stretch != stretches.end() && stretch->begin < time + largest;
         ++stretch)
      largest =
        std::max(std::min(largest, stretch->width), stretch->begin - time);
    return largest;
  }
} // namespace ThermoContact
