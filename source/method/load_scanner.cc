// SPDX-License-Identifier: LGPL-2.1-or-later
//
// How a load is looked at before a run.

#include <thermocontact/method/load_breaks.h>

#include <algorithm>
#include <cmath>

namespace ThermoContact
{
  namespace
  {
    using Values = std::vector<double>;

    /** A load is nearly linear if it is off by that part of its variation. */
    constexpr double nearly_linear = 0.02;

    /** Variation is that within so many widths on both sides. */
    constexpr double n_widths = 8.;

    /** Parts of the largest variation that do not matter. */
    constexpr double negligible = 1e-6;

    /** Parts of the time that are not divided. */
    constexpr double smallest_width = 1e-13;



    class LoadScanner
    {
    public:
      LoadScanner(const LoadSample          &load,
                  const double               end_time,
                  const std::vector<double> &named_times)
        : samples(load, end_time, named_times)
        , scale(samples.scale())
      {}



      LoadHistory
      history()
      {
        if (samples.variation() == 0.)
          return {};
        result.breaks = find_load_breaks(samples);
        find_stretches();
        return result;
      }

    private:
      LoadSamples  samples;
      const double scale; ///< of its variation
      LoadHistory  result;

      /** Those at equal distances, and both sides of the breaks. */
      std::vector<TimedValues> nodes;



      /** Neighbouring nodes, within those of a segment between breaks. */
      struct Panel
      {
        unsigned int first, last;
        unsigned int segment_first, segment_last;
      };



      /** Off the chord from @p a to @p b by as much. */
      static double
      deviation(const TimedValues &sample,
                const TimedValues &a,
                const TimedValues &b)
      {
        const double part    = (sample.time - a.time) / (b.time - a.time);
        double       largest = 0.;
        for (unsigned int c = 0; c < a.values.size(); ++c)
          largest =
            std::max(largest,
                     std::abs(sample.values[c] - (1. - part) * a.values[c] -
                              part * b.values[c]));
        return largest;
      }



      /**
       * The same of all samples between them, whose values are added to
       * @p range.
       */
      double
      deviation_between(const TimedValues &a,
                        const TimedValues &b,
                        ValueRange        &range) const
      {
        auto   next    = std::upper_bound(samples.all().begin(),
                                     samples.all().end(),
                                     a.time,
                                     [](const double t, const TimedValues &s) {
                                       return t < s.time;
                                     });
        double largest = 0.;
        for (; next != samples.all().end() && next->time < b.time; ++next)
          {
            range.add(next->values);
            largest = std::max(largest, deviation(*next, a, b));
          }
        return largest;
      }



      /** Variation around a panel, within its segment. */
      double
      variation_around(const Panel &panel) const
      {
        const double margin =
          n_widths * (nodes[panel.last].time - nodes[panel.first].time);
        ValueRange range;
        for (unsigned int i = panel.first;; --i)
          {
            range.add(nodes[i].values);
            if (i == panel.segment_first ||
                nodes[i].time < nodes[panel.first].time - margin)
              break;
          }
        for (unsigned int i = panel.first;
             i <= panel.segment_last &&
             nodes[i].time <= nodes[panel.last].time + margin;
             ++i)
          range.add(nodes[i].values);
        return range.variation();
      }



      void
      add_stretch(const TimedValues &a, const TimedValues &b)
      {
        result.stretches.push_back({a.time, b.time, b.time - a.time});
      }



      /** Stretches between two times that are no nodes. */
      void
      halve(const TimedValues &a, const TimedValues &b, const double variation)
      {
        if (b.time - a.time <= smallest_width * samples.end_time())
          return add_stretch(a, b);
        const TimedValues m = samples.at(0.5 * (a.time + b.time));
        ValueRange        range;
        for (const TimedValues *s : {&a, &m, &b})
          range.add(s->values);
        const double off =
          std::max(deviation(m, a, b), deviation_between(a, b, range));
        const double larger = std::max(variation, range.variation());
        if (off <= negligible * scale || off <= nearly_linear * larger)
          return add_stretch(a, b);
        halve(a, m, larger);
        halve(m, b, larger);
      }



      /** A panel that did not become part of a longer stretch. */
      void
      finish(const Panel &panel)
      {
        if (panel.last == panel.first + 1)
          halve(nodes[panel.first], nodes[panel.last], variation_around(panel));
        else
          add_stretch(nodes[panel.first], nodes[panel.last]);
      }



      /** True if a panel is nearly linear by what is known of it. */
      bool
      is_nearly_linear(const Panel &panel) const
      {
        ValueRange   range;
        const double off =
          deviation_between(nodes[panel.first], nodes[panel.last], range);
        return off <= negligible * scale ||
               off <= nearly_linear * variation_around(panel);
      }



      /**
       * True if a panel can be a stretch, or part of a longer one; else it is
       * divided into stretches. Its parts must be able to, too: beside a load
       * that varies much, one that varies less is seen at its own scale.
       */
      bool
      is_stretch(const Panel &panel)
      {
        if (panel.last == panel.first + 1)
          {
            if (is_nearly_linear(panel))
              return true;
            finish(panel);
            return false;
          }
        Panel left(panel), right(panel);
        left.last = right.first = (panel.first + panel.last) / 2;
        const bool has_left     = is_stretch(left);
        const bool has_right    = is_stretch(right);
        if (has_left && has_right && is_nearly_linear(panel))
          return true;
        if (has_left)
          finish(left);
        if (has_right)
          finish(right);
        return false;
      }



      /** Between breaks, from the time after one to the next one. */
      void
      find_stretches()
      {
        const auto is_earlier = [](const auto &a, const auto &b) {
          return a.time < b.time;
        };
        nodes = samples.uniform();
        for (const LoadBreak &b : result.breaks)
          for (const double time : {b.time, b.new_time})
            nodes.push_back(samples.at(time));
        nodes.erase(std::remove_if(nodes.begin(),
                                   nodes.end(),
                                   [&](const auto &node) {
                                     return result.is_within_break(node.time);
                                   }),
                    nodes.end());
        std::sort(nodes.begin(), nodes.end(), is_earlier);
        nodes.erase(std::unique(nodes.begin(),
                                nodes.end(),
                                [](const auto &a, const auto &b) {
                                  return a.time == b.time;
                                }),
                    nodes.end());
        unsigned int first = result.break_at(nodes[0].time) ? 1 : 0;
        for (unsigned int last = 1; last < nodes.size(); ++last)
          if (last + 1 == nodes.size() ||
              result.break_at(nodes[last].time) != nullptr)
            {
              const Panel segment{first, last, first, last};
              if (first < last && is_stretch(segment))
                finish(segment);
              first = last + 1;
            }
        std::sort(result.stretches.begin(),
                  result.stretches.end(),
                  [](const LoadStretch &a, const LoadStretch &b) {
                    return a.begin < b.begin;
                  });
      }
    };
  } // namespace



  ScannedLoad
  scan_load(const LoadSample          &load,
            const double               end_time,
            const std::vector<double> &named_times)
  {
    ScannedLoad scanned;
    try
      {
        scanned.history = LoadScanner(load, end_time, named_times).history();
      }
    catch (const UnresolvedLoad &fault)
      {
        scanned.is_resolved = false;
        scanned.time        = fault.time;
        scanned.is_infinite = fault.is_infinite;
      }
    return scanned;
  }
} // namespace ThermoContact
