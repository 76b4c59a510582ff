// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef thermocontact_method_load_history_h
#define thermocontact_method_load_history_h

#include <functional>
#include <vector>

namespace ThermoContact
{
  /** A time at which a load is not smooth. */
  struct LoadBreak
  {
    /** @param time the last one with the old value, or one that is listed */
    LoadBreak(const double time, const bool is_jump);

    double time;     ///< where steps end; it has the old value or the new one
    double old_time; ///< a time right before it, with the old value
    double new_time; ///< the first time from which on it has the new one
    bool   is_jump;  ///< or else its slope jumps

    /**
     * Length of a step of its own in which nodes that have the load for their
     * value follow its jump; 0 if there are none.
     */
    double node_step = 0.;
  };



  /**
   * Breaks in order of time, those that are too close to be told apart as one:
   * what is between them is no load that a step could see.
   */
  std::vector<LoadBreak>
  merged(std::vector<LoadBreak> breaks);



  /** A stretch of time in which loads are nearly linear. */
  struct LoadStretch
  {
    double begin = 0.;
    double end   = 0.;

    /** Over this time loads are nearly linear around the stretch. */
    double width = 0.;
  };



  /** What loads do in time, doc/model.md section 18. */
  struct LoadHistory
  {
    std::vector<LoadBreak> breaks; ///< in order of time

    /** Cover all of the time, in order. */
    std::vector<LoadStretch> stretches;

    /** Loads that all steps see the same way need no stretches. */
    bool
    is_empty() const
    {
      return breaks.empty() && stretches.empty();
    }

    /**
     * Takes times that are listed, where there are no breaks so far. Loads may
     * jump there.
     */
    void
    add_breaks(const std::vector<double> &times);

    /** The history of these loads and of others together. */
    void
    add(const LoadHistory &other);

    /**
     * Breaks that are too close to the end, or to the start, to be told apart
     * from it are there.
     */
    void
    end_at(const double end_time);

    /** The first break after @p time, or nullptr. */
    const LoadBreak *
    next_break(const double time) const;

    /** The break at @p time, or nullptr. */
    const LoadBreak *
    break_at(const double time) const;

    /** True if @p time lies between the old and the new value of a break. */
    bool
    is_within_break(const double time) const;

    /**
     * The largest step from @p time on, not above @p size, that is no longer
     * than some widths of the stretches that it crosses.
     */
    double
    largest_step(const double time, const double size) const;
  };



  /** Values of a load at several places: out; as many at every time. */
  using LoadSample =
    std::function<void(const double time, std::vector<double> &values)>;



  /**
   * Finds the jumps of the slope to the last digit, where the slope is known;
   * also those that are too close to each other for the samples of the load.
   *
   * @param rate of the load
   * @param history in, out: of the load
   */
  void
  sharpen_bends(const LoadSample &rate,
                const double      end_time,
                LoadHistory      &history);



  /** A load as it was seen. */
  struct ScannedLoad
  {
    LoadHistory history;
    bool        is_resolved = true; ///< false: it has no history

    /** If it is not resolved: a time near which it is not. */
    double time = 0.;

    /** The value there is not finite. */
    bool is_infinite = false;
  };



  /**
   * Looks at a load over $[0,T]$: at times with the spacing $T/2^{15}$ and,
   * ever closer, around those that are named; then between them where the load
   * changes. Jumps are found to the last digit, jumps of the slope nearly so.
   *
   * @param end_time $T>0$
   * @param named_times such as those in the expression
   */
  ScannedLoad
  scan_load(const LoadSample          &load,
            const double               end_time,
            const std::vector<double> &named_times);
} // namespace ThermoContact

#endif
