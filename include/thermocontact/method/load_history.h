// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef thermocontact_method_load_history_h
#define thermocontact_method_load_history_h

#include <vector>

namespace ThermoContact
{
  /** Loads of which somebody answers a jump at once, as bits. */
  enum LoadKind : unsigned int
  {
    other_load            = 0,
    force                 = 1, ///< on the body or its end
    fixed_end_temperature = 2
  };



  /** A time at which a load is not smooth. */
  struct LoadBreak
  {
    /** @param time the last one with the old value, or one that is listed */
    LoadBreak(const double time, const bool is_jump);

    double time;     ///< where steps end; it has the old value or the new one
    double old_time; ///< a time right before it, with the old value
    double new_time; ///< the first time from which on it has the new one
    bool   is_jump;  ///< or else its slope jumps

    unsigned int jumping = other_load; ///< bits: the loads that jump there

    /** Steps end there; else those that end there by themselves know it. */
    bool ends_steps = true;
  };



  /**
   * Breaks in order of time. Breaks that are too close to be told apart are
   * one: no step could see the load between them.
   */
  std::vector<LoadBreak>
  merged(std::vector<LoadBreak> breaks);



  /** A stretch of time in which steps are not to be longer than its width. */
  struct LoadStretch
  {
    double begin = 0.;
    double end   = 0.;

    /** Over this time loads are nearly parabolas around the stretch. */
    double width = 0.;
  };



  /** Loads in time, doc/contact-in-time.md section 7. */
  struct LoadHistory
  {
    std::vector<LoadBreak> breaks; ///< in order of time

    /** In order, none within another; steps elsewhere may be of any length. */
    std::vector<LoadStretch> stretches;

    bool is_complete = true; ///< false: a load is too fast to be searched

    /** Steps end anywhere and are of any length. */
    bool
    is_empty() const
    {
      return next_break(-1.) == nullptr && stretches.empty();
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

    /** The first break after @p time at which steps end, or nullptr. */
    const LoadBreak *
    next_break(const double time) const;

    /**
     * The break at @p time, or nullptr; one at which no step has to end also
     * where the times cannot be told apart.
     */
    const LoadBreak *
    break_at(const double time) const;

    /** The breaks between these times, but for those at one of them. */
    std::vector<LoadBreak>
    breaks_within(const double begin, const double end) const;

    /**
     * The largest step from @p time on, not above @p size, that is no longer
     * than the widths of the stretches that it crosses.
     */
    double
    largest_step(const double time, const double size) const;
  };
} // namespace ThermoContact

#endif
