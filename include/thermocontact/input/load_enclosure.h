// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef thermocontact_input_load_enclosure_h
#define thermocontact_input_load_enclosure_h

#include <thermocontact/input/time_function.h>
#include <thermocontact/method/load_history.h>

namespace ThermoContact
{
  /** A function of time up to the end of a run. */
  struct EnclosedLoad
  {
    LoadHistory history;
    bool        is_resolved = true; ///< false: it has no history

    /** If it is not resolved: a time near which it is not. */
    double time = 0.;

    /** The value there is not finite. */
    bool is_infinite = false;

    unsigned int n_evaluations = 0; ///< enclosures of a span of time
  };



  /**
   * Encloses a function over $[0,T]$ in spans of time, which are halved until
   * it is smooth in them and nearly a parabola. A span that cannot be halved
   * any more is a jump, between two neighbouring doubles, or a jump of the
   * slope. Since the values in a span are enclosed, nothing in it is
   * overlooked, however short.
   *
   * @param end_time $T>0$
   */
  EnclosedLoad
  enclose_load(const TimeFunction &load, const double end_time);



  /** How far its values in $[0,T]$ are apart, by 65 of them and those of its
   * history. */
  double
  range_of(const TimeFunction &load,
           const LoadHistory  &history,
           const double        end_time);



  /**
   * True if a function is nearly a parabola in a span of a variable: if it is
   * off by a quarter of its change there, or by a part that is negligible.
   *
   * @param all what it is in the span
   * @param middle what it is in the middle of the span
   * @param h length of the span
   */
  bool
  is_nearly_parabolic(const IntervalJet &all,
                      const NumberJet   &middle,
                      const double       h,
                      const double       negligible);
} // namespace ThermoContact

#endif
