// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef thermocontact_space_state_h
#define thermocontact_space_state_h

#include <thermocontact/base/types.h>

#include <algorithm>
#include <stdexcept>
#include <utility>
#include <vector>

namespace ThermoContact
{
  /**
   * The body at one time: everything that a time integrator needs to go on.
   * A value: copied, compared, dropped.
   */
  struct State
  {
    double time = 0.;
    Vector temperature;  ///< $\theta$, including the value of the fixed end
    Vector displacement; ///< $u$
    Vector velocity;     ///< $v$

    /** Pressure $p_i\ge0$ at the contact nodes, on all ranks. */
    std::vector<double> contact_pressure;

    /**
     * Heat exchange coefficient $k_i\ge0$ at the contact nodes, on all ranks:
     * that of the law, or, where the law jumps, any between its limits there.
     */
    std::vector<double> exchange_coefficient;

    /** Exchanges two states without copying or allocating. */
    void
    swap(State &other)
    {
      std::swap(time, other.time);
      temperature.swap(other.temperature);
      displacement.swap(other.displacement);
      velocity.swap(other.velocity);
      contact_pressure.swap(other.contact_pressure);
      exchange_coefficient.swap(other.exchange_coefficient);
    }

    /**
     * The part of this rank, for checkpoints. A state that is read has its
     * layout already.
     *
     * @throw std::length_error if the layout is another one
     */
    template <class Archive>
    void
    serialize(Archive &archive, const unsigned int)
    {
      archive &time &contact_pressure &exchange_coefficient;
      for (Vector *vector : {&temperature, &displacement, &velocity})
        {
          std::vector<double> values(vector->begin(), vector->end());
          archive            &values;
          if (values.size() != vector->locally_owned_size())
            throw std::length_error("vectors of another discretisation");
          if (Archive::is_loading::value)
            std::copy(values.begin(), values.end(), vector->begin());
        }
    }
  };
} // namespace ThermoContact

#endif
