// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef thermocontact_study_trajectory_h
#define thermocontact_study_trajectory_h

#include <thermocontact/contact/event_locator.h>
#include <thermocontact/simulation/measurements.h>

#include <array>
#include <vector>

namespace ThermoContact
{
  /** The contact quantities of a run over time, which a study compares. */
  class Trajectory
  {
  public:
    enum Quantity
    {
      displacement_end,
      velocity_end,
      contact_force,
      temperature_end,
      energy,
      n_quantities
    };

    using Values = std::array<double, n_quantities>;

    /** Of the quantities, in the order of the enumeration. */
    static const std::array<const char *, n_quantities> names;

    /** Appends an accepted state. */
    void
    add(const StepRecord &record);

    bool
    empty() const
    {
      return times.empty();
    }

    /** Takes the contact events of the run, when it has ended. */
    void
    set_events(const std::vector<ContactEvent> &events);

    /** Time of the first contact; NaN without contact. */
    double
    first_contact_time() const;

    /** Differences of two trajectories. */
    struct Difference
    {
      Values maximum;     ///< over the step ends after t = 0
      Values final_value; ///< at the last of them
      double first_contact_time;

      /** All of them @p value. */
      explicit Difference(const double value)
        : first_contact_time(value)
      {
        maximum.fill(value);
        final_value.fill(value);
      }
    };

    /**
     * Differences to a reference at the own step ends. Between its steps the
     * reference is interpolated by polynomials of degree five through six of
     * its steps between which contact does not change; exact at common times.
     *
     * Beyond the end of the reference the difference is NaN.
     *
     * @param reference not empty
     */
    Difference
    compare(const Trajectory &reference) const;

    template <typename Archive>
    void
    serialize(Archive &archive, const unsigned int)
    {
      archive &times &values &event_times;
    }

  private:
    std::vector<double> times;
    std::vector<Values> values;
    std::vector<double> event_times;

    /** Number of events before the middle of the step to state @p n. */
    unsigned int
    phase(const std::size_t n) const;

    Values
    interpolate(const double time) const;
  };
} // namespace ThermoContact

#endif
