// SPDX-License-Identifier: LGPL-2.1-or-later

#include <thermocontact/base/special_numbers.h>
#include <thermocontact/base/tolerances.h>
#include <thermocontact/input/load_enclosure.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace ThermoContact
{
  namespace
  {
    /**
     * A load is nearly a parabola in a span if it is off by that part of its
     * change there.
     */
    constexpr double nearly_parabolic = 0.25;

    constexpr double negligible = Tolerances::negligible_load;

    /** More enclosures are not worth their time. */
    constexpr unsigned int max_evaluations = 1 << 20;

    /** Parts of $T$ below which times are the start: epsilon twice. */
    constexpr double start = std::numeric_limits<double>::epsilon() *
                             std::numeric_limits<double>::epsilon();



    /** Thrown where a load has no history. */
    struct Unresolved
    {
      double time;
      bool   is_infinite;
    };



    class LoadEncloser
    {
    public:
      LoadEncloser(const TimeFunction &load,
                   const double        end_time,
                   EnclosedLoad       &result)
        : load(load)
        , end_time(end_time)
        , result(result)
      {}



      void
      enclose()
      {
        constexpr unsigned int n_samples = 64;
        for (unsigned int i = 0; i <= n_samples; ++i)
          note_value(load.value(end_time * i / n_samples));
        // level by level, so that the variation is known before what is small
        std::vector<Interval> level{{0., end_time}}, halves;
        while (!level.empty())
          {
            halves.clear();
            for (const Interval &span : level)
              enclose(span, halves);
            level.swap(halves);
          }
        find_breaks();
      }

    private:
      const TimeFunction   &load;
      const double          end_time;
      EnclosedLoad         &result;
      Interval              range{infinity, -infinity}; ///< of values seen
      std::vector<Interval> left; ///< spans that cannot be halved



      void
      note_value(const double value)
      {
        if (std::isfinite(value))
          range = hull(range, value);
      }



      /** Negligible variation: a part of the whole, but not of its rounding. */
      double
      threshold() const
      {
        return range.low > range.high ?
                 0. :
                 negligible *
                   std::max(range.width(), negligible * range.magnitude());
      }



      void
      enclose(const Interval &span, std::vector<Interval> &halves)
      {
        const double middle = span.middle();
        if (++result.n_evaluations > max_evaluations)
          throw Unresolved{middle, false};
        const IntervalJet     all = load.enclosure(span);
        const TimeDerivatives at  = load.derivatives(middle);
        note_value(at.value);
        if (is_smooth(all, at, span))
          return;
        if (!(middle > span.low && middle < span.high) ||
            span.width() < start * end_time)
          left.push_back(span);
        else
          {
            halves.emplace_back(span.low, middle);
            halves.emplace_back(middle, span.high);
          }
      }



      /** If so, its width is kept where it limits steps. */
      bool
      is_smooth(const IntervalJet     &all,
                const TimeDerivatives &at,
                const Interval        &span)
      {
        const double h = span.width();
        if (!is_nearly_parabolic(all, at, h, threshold()))
          return false;
        if (all.first.width() * h / 4. > threshold() && all.second.width() > 0.)
          {
            // the same of a longer span, in which the third derivative is
            const double third = all.second.width() / h;
            const double half  = nearly_parabolic * std::abs(at.second) / 2.;
            const double width =
              (half + std::sqrt(half * half + 8. * third * nearly_parabolic *
                                                std::abs(at.first))) /
              third;
            if (width < end_time)
              result.history.stretches.push_back(
                {span.low,
                 span.high,
                 std::max({width, h, std::cbrt(8. * threshold() / third)})});
          }
        return true;
      }



      /** Neighbouring spans that are left hold one break. */
      void
      find_breaks()
      {
        std::sort(left.begin(),
                  left.end(),
                  [](const Interval &a, const Interval &b) {
                    return a.low < b.low;
                  });
        for (unsigned int i = 0; i < left.size();)
          {
            Interval span = left[i];
            while (++i < left.size() && is_same_time(span.high, left[i].low))
              span.high = left[i].high;
            add_break(span);
          }
      }



      static bool
      is_same_time(const double a, const double b)
      {
        return b - a <= 8. * std::numeric_limits<double>::epsilon() * b;
      }



      /**
       * The last double from @p a on at which a quantity is nearly that of
       * @p a, if it changes before @p b.
       */
      template <typename Quantity>
      static double
      last_like(double a, double b, const Quantity &quantity)
      {
        const double old  = quantity(a);
        const double near = 0.001 * std::abs(quantity(b) - old); // no tie
        while (true)
          {
            const double middle = 0.5 * (a + b);
            if (middle == a || middle == b)
              return a;
            (std::abs(quantity(middle) - old) <= near ? a : b) = middle;
          }
      }



      void
      add_break(const Interval &span)
      {
        const auto value = [&](const double t) { return load.value(t); };
        const auto slope = [&](const double t) {
          return load.derivatives(t).first;
        };
        for (const double t : {span.low, span.middle(), span.high})
          if (!std::isfinite(value(t)))
            throw Unresolved{t, true};
        const bool is_jump =
          std::abs(value(span.high) - value(span.low)) > threshold();
        if (!is_jump &&
            std::abs(slope(span.high) - slope(span.low)) * end_time <=
              threshold())
          return; // it is smooth there
        LoadBreak found(is_jump ? last_like(span.low, span.high, value) :
                                  last_like(span.low, span.high, slope),
                        is_jump);
        found.old_time = found.time;
        found.new_time = is_jump ? last_like(span.high, span.low, value) :
                                   last_like(span.high, span.low, slope);
        result.history.breaks.push_back(found);
      }
    };
  } // namespace



  double
  range_of(const TimeFunction &load,
           const LoadHistory  &history,
           const double        end_time)
  {
    constexpr unsigned int n_times = 64;
    Interval               values(load.value(0.));
    const auto             add = [&](const double time) {
      values = hull(values, load.value(time));
    };
    for (unsigned int i = 1; i <= n_times; ++i)
      add(end_time * i / n_times);
    for (const LoadBreak &at : history.breaks)
      {
        add(at.old_time);
        add(at.new_time);
      }
    for (const LoadStretch &stretch : history.stretches)
      add(0.5 * (stretch.begin + stretch.end));
    return values.width();
  }



  bool
  is_nearly_parabolic(const IntervalJet &all,
                      const NumberJet   &middle,
                      const double       h,
                      const double       negligible)
  {
    if (!all.value.is_finite() || !all.first.is_finite() ||
        !all.second.is_finite())
      return false;
    const double miss = all.second.width() * h * h / 8.;
    const double change =
      std::abs(middle.first) * h + std::abs(middle.second) * h * h / 8.;
    return miss <= nearly_parabolic * change || miss <= negligible ||
           all.first.width() * h / 4. <= negligible;
  }



  EnclosedLoad
  enclose_load(const TimeFunction &load, const double end_time)
  {
    EnclosedLoad result;
    try
      {
        LoadEncloser(load, end_time, result).enclose();
        result.history.add({}); // in order
      }
    catch (const Unresolved &fault)
      {
        result.history     = {};
        result.is_resolved = false;
        result.time        = fault.time;
        result.is_infinite = fault.is_infinite;
      }
    return result;
  }
} // namespace ThermoContact
