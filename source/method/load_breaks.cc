// SPDX-License-Identifier: LGPL-2.1-or-later

#include <thermocontact/method/load_breaks.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <optional>

namespace ThermoContact
{
  namespace
  {
    using Values = std::vector<double>;

    constexpr unsigned int max_breaks = 20000;

    /** Samples on both sides of an interval that a jump stands out of. */
    constexpr unsigned int n_around = 8;

    /** Parts of the largest variation that do not matter. */
    constexpr double negligible_jump = 1e-6;
    constexpr double negligible_kink = 1e-7;

    /** Parts of the end time within which a jump of the slope is. */
    constexpr double around_bend = 1e-7;

    /** Stretches of so many distances of samples may have bends between. */
    constexpr double n_close = 8.;



    bool
    is_earlier(const LoadBreak &a, const LoadBreak &b)
    {
      return a.time < b.time;
    }



    /** The polynomial of degree two through three samples, at @p time. */
    Values
    extrapolate(const TimedValues &a,
                const TimedValues &b,
                const TimedValues &c,
                const double       time)
    {
      const double la = (time - b.time) * (time - c.time) /
                        ((a.time - b.time) * (a.time - c.time));
      const double lb = (time - a.time) * (time - c.time) /
                        ((b.time - a.time) * (b.time - c.time));
      const double lc = (time - a.time) * (time - b.time) /
                        ((c.time - a.time) * (c.time - b.time));
      Values values(a.values);
      for (unsigned int i = 0; i < values.size(); ++i)
        values[i] = la * a.values[i] + lb * b.values[i] + lc * c.values[i];
      return values;
    }



    /** The slope from one sample to another. */
    Values
    slope(const TimedValues &a, const TimedValues &b)
    {
      Values values(a.values);
      for (unsigned int i = 0; i < values.size(); ++i)
        values[i] = (b.values[i] - a.values[i]) / (b.time - a.time);
      return values;
    }



    class BreakFinder
    {
    public:
      explicit BreakFinder(LoadSamples &samples)
        : samples(samples)
        , scale(samples.scale())
      {}



      std::vector<LoadBreak>
      breaks()
      {
        find_jumps();
        find_kinks();
        return merged(result.breaks);
      }

    private:
      LoadSamples &samples;
      const double scale; ///< of its variation
      LoadHistory  result;



      void
      add_break(const double time, const bool is_jump)
      {
        if (result.breaks.size() >= max_breaks)
          throw UnresolvedLoad{time, false};
        result.breaks.push_back({time, is_jump});
      }



      /** Jumps between two samples that differ by more than @p threshold. */
      void
      find_jumps_between(const TimedValues &first,
                         const TimedValues &last,
                         const double       threshold)
      {
        const double all = distance(first.values, last.values);
        if (all <= threshold)
          return;
        TimedValues a(first), b(last);
        while (next_time(a.time) < b.time)
          {
            const double middle = 0.5 * (a.time + b.time);
            if (!(middle > a.time && middle < b.time))
              break;
            const TimedValues m = samples.at(middle);
            (distance(a.values, m.values) > distance(m.values, b.values) ? b :
                                                                           a) =
              m;
            // what is smooth has lost nearly all of its change
            if (distance(a.values, b.values) < 0.1 * all)
              return;
          }
        add_break(a.time, true);
        find_jumps_between(first, a, threshold);
        find_jumps_between(b, last, threshold);
      }



      void
      find_jumps()
      {
        for (unsigned int i = 0; i + 1 < samples.all().size(); ++i)
          {
            const double change =
              distance(samples.all()[i].values, samples.all()[i + 1].values);
            if (change <= negligible_jump * scale)
              continue;
            ValueRange         around;
            const unsigned int last =
              std::min<unsigned int>(i + 1 + n_around,
                                     samples.all().size() - 1);
            for (unsigned int j = i - std::min(i, n_around); j <= last; ++j)
              around.add(samples.all()[j].values);
            const double threshold = 0.2 * around.variation();
            if (change > threshold)
              find_jumps_between(samples.all()[i],
                                 samples.all()[i + 1],
                                 std::max(0.5 * threshold,
                                          negligible_jump * scale));
          }
        std::sort(result.breaks.begin(), result.breaks.end(), is_earlier);
      }



      /** The time in the i-th interval where two parabolas meet. */
      double
      kink_time(const unsigned int i)
      {
        double a = samples.uniform()[i].time, b = samples.uniform()[i + 1].time;
        while (b - a > 1e-15 * samples.end_time())
          {
            const double middle = 0.5 * (a + b);
            if (!(middle > a && middle < b))
              break;
            const Values value = samples.at(middle).values;
            const Values left  = extrapolate(samples.uniform()[i - 2],
                                            samples.uniform()[i - 1],
                                            samples.uniform()[i],
                                            middle);
            const Values right = extrapolate(samples.uniform()[i + 1],
                                             samples.uniform()[i + 2],
                                             samples.uniform()[i + 3],
                                             middle);
            (distance(value, left) <= distance(value, right) ? a : b) = middle;
          }
        return 0.5 * (a + b);
      }



      /** The slope jumps within an interval, or at one of its ends. */
      bool
      has_kink(const unsigned int i) const
      {
        const auto slope_at = [&](const unsigned int j) {
          return slope(samples.uniform()[j], samples.uniform()[j + 1]);
        };
        const Values left   = slope_at(i - 1);
        const Values right  = slope_at(i + 1);
        const double change = distance(left, right);
        return change * samples.end_time() / LoadSamples::n_intervals >
                 negligible_kink * scale &&
               change > 8. * distance(slope_at(i - 2), left) &&
               change > 8. * distance(right, slope_at(i + 2));
      }



      /** The slope jumps where its changes on both sides are much smaller. */
      void
      find_kinks()
      {
        const LoadHistory jumps    = result;
        const auto       &times    = samples.uniform();
        bool              has_last = false;
        for (unsigned int i = 2; i + 3 < times.size(); ++i)
          {
            const LoadBreak *jump =
              jumps.next_break(std::nextafter(times[i - 2].time, -1.));
            const bool is_kink =
              has_kink(i) &&
              (jump == nullptr || jump->time > times[i + 3].time);
            if (is_kink)
              {
                // near a sample both of its intervals have it
                const double time  = kink_time(i);
                const double slack = 1e-6 * (times[i + 1].time - times[i].time);
                if (!has_last)
                  add_break(time, false);
                else if (time > times[i].time + slack)
                  result.breaks.back() = {time, false};
              }
            has_last = is_kink;
          }
      }
    };
  } // namespace



  std::vector<LoadBreak>
  find_load_breaks(LoadSamples &samples)
  {
    return BreakFinder(samples).breaks();
  }



  namespace
  {
    using Rate = std::function<Values(const double)>;

    /**
     * Where the rate jumps between two times, to the last digit.
     *
     * @param share of the change between them that a jump has
     */
    std::optional<LoadBreak>
    bend_between(const Rate &rate, double a, double b, const double share)
    {
      Values       old_rate = rate(a), new_rate = rate(b);
      const double all = distance(old_rate, new_rate);
      while (next_time(a) < b)
        {
          const double middle = 0.5 * (a + b);
          if (!(middle > a && middle < b))
            break;
          const Values at     = rate(middle);
          const bool   is_old = distance(old_rate, at) < distance(at, new_rate);
          (is_old ? a : b)    = middle;
          (is_old ? old_rate : new_rate) = at;
        }
      if (!(distance(old_rate, new_rate) > share * all))
        return {};
      LoadBreak bend(a, false);
      bend.old_time = a;
      bend.new_time = b;
      return bend;
    }
  } // namespace



  void
  sharpen_bends(const LoadSample &rate,
                const double      end_time,
                LoadHistory      &history)
  {
    const Rate rate_at = [&rate](const double time) {
      Values values;
      rate(time, values);
      return values;
    };
    for (LoadBreak &bend : history.breaks)
      if (!bend.is_jump)
        if (const auto found =
              bend_between(rate_at,
                           std::max(bend.time - around_bend * end_time, 0.),
                           std::min(bend.time + around_bend * end_time,
                                    end_time),
                           0.5))
          bend = *found;
    // those that are too close for samples at equal distances
    const double close = n_close * end_time / LoadSamples::n_intervals;
    for (unsigned int i = 0; i + 1 < history.stretches.size(); ++i)
      {
        const LoadStretch &s = history.stretches[i];
        const LoadStretch &t = history.stretches[i + 1];
        if (std::min(s.end - s.begin, t.end - t.begin) > close)
          continue;
        const double a = std::max(0.5 * (s.begin + s.end), s.end - close);
        const double b = std::min(0.5 * (t.begin + t.end), t.begin + close);
        if (const auto found = bend_between(rate_at, a, b, 0.5))
          history.breaks.push_back(*found);
      }
    history.breaks = merged(history.breaks);
  }
} // namespace ThermoContact
