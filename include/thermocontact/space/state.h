// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef thermocontact_space_state_h
#define thermocontact_space_state_h

#include <thermocontact/base/local_sums.h>
#include <thermocontact/base/types.h>
#include <thermocontact/contact/obstacle_action.h>

#include <array>
#include <utility>
#include <vector>

namespace ThermoContact
{
  /** The rates of a state. */
  struct Rates
  {
    Vector temperature_rate; ///< $\theta'$
    Vector velocity;         ///< $v=u'$
    Vector acceleration;     ///< $v'$

    /** In the order of State::vectors(), whose rates they are. */
    std::array<Vector *, 3>
    vectors()
    {
      return {{&temperature_rate, &velocity, &acceleration}};
    }

    std::array<const Vector *, 3>
    vectors() const
    {
      return {{&temperature_rate, &velocity, &acceleration}};
    }
  };



  /**
   * The body at one time: everything that a time integrator needs to go on.
   * A value: copied, exchanged, dropped.
   */
  struct State
  {
    double time = 0.;
    Vector temperature;  ///< $\theta$, including the value of the fixed end
    Vector displacement; ///< $u$
    Vector velocity;     ///< $v$

    ObstacleAction contact;

    /** Gaps $g$ at the contact nodes, on all ranks: where the obstacle is. */
    std::vector<double> gap;

    /** $g'$ there: how fast an obstacle that moves goes away from the body. */
    std::vector<double> gap_rate;

    /**
     * Velocities at the contacts of a row, relative and positive into them,
     * where the scheme knows them better than by nodes; else empty.
     */
    std::vector<double> contact_velocity;

    /**
     * Penetrations of known values that the difference of displacement and gap
     * would lose the digits of; else empty, as of the end of a step.
     */
    std::vector<double> known_penetration;

    /**
     * Time of the loads that act on it: its own, but beside a discontinuity of
     * theirs the last one before it or the first one behind it.
     */
    double load_time = 0.;

    /** Time at which a jump of the loads moved it last; negative: none did. */
    double jump_time = -1.;

    /**
     * By initial values, or by a jump of the loads: then a body in equilibrium
     * at all times has no velocity.
     */
    bool
    was_moved_at_once() const
    {
      return time == 0. || time == jump_time;
    }

    /** What changes with rates. */
    std::array<Vector *, 3>
    vectors()
    {
      return {{&temperature, &displacement, &velocity}};
    }

    std::array<const Vector *, 3>
    vectors() const
    {
      return {{&temperature, &displacement, &velocity}};
    }

    /** Rates become zero, of this layout. */
    void
    set_layout(Rates &rates) const
    {
      for (unsigned int k = 0; k < vectors().size(); ++k)
        rates.vectors()[k]->reinit(*vectors()[k]);
    }

    /**
     * Temperature and displacement become the ones at the end of a stage of
     * length @p tau from @p known values, which may be its own. The velocity
     * stays as it is.
     */
    void
    advance(const State &known, const double tau, const Rates &rates)
    {
      set_sum(temperature, known.temperature, tau, rates.temperature_rate);
      set_sum(displacement, known.displacement, tau, rates.velocity);
    }

    /** Becomes the body of another state; allocates nothing for one layout. */
    void
    copy_values(const State &from)
    {
      if (contact.pressure.size() != from.contact.pressure.size())
        {
          *this = from; // the first one: gets its layout
          return;
        }
      for (unsigned int k = 0; k < vectors().size(); ++k)
        set_equal(*vectors()[k], *from.vectors()[k]);
      contact          = from.contact;
      contact_velocity = from.contact_velocity;
    }

    /** Exchanges two states without copying or allocating. */
    void
    swap(State &other)
    {
      std::swap(time, other.time);
      std::swap(load_time, other.load_time);
      std::swap(jump_time, other.jump_time);
      for (unsigned int k = 0; k < vectors().size(); ++k)
        vectors()[k]->swap(*other.vectors()[k]);
      contact.swap(other.contact);
      gap.swap(other.gap);
      gap_rate.swap(other.gap_rate);
      known_penetration.swap(other.known_penetration);
      contact_velocity.swap(other.contact_velocity);
    }

    /** The values that all ranks know; StateSerialiser saves the vectors. */
    template <class Archive>
    void
    serialize(Archive &archive, const unsigned int)
    {
      archive &time &contact &gap &gap_rate &load_time &jump_time
        &contact_velocity;
    }
  };
} // namespace ThermoContact

#endif
