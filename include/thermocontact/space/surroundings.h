// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef thermocontact_space_surroundings_h
#define thermocontact_space_surroundings_h

#include <thermocontact/contact/heat_exchange.h>
#include <thermocontact/input/time_function.h>
#include <thermocontact/scene/scene.h>
#include <thermocontact/space/contact_end.h>
#include <thermocontact/space/state.h>

#include <vector>

namespace ThermoContact
{
  /**
   * What the contact nodes exchange heat with: the obstacle of temperature
   * $\theta_{obs}$, which may vary in time and in y, z, or the partner of a
   * node in a row, whose values are differences. Nondimensional.
   */
  template <int dim>
  class Surroundings
  {
  public:
    /** @param end of the body; both are borrowed */
    Surroundings(const Scene &scene, const ContactEnd<dim> &end);

    /** $\theta_{obs}$ at a node at a time of the loads; 0 for a partner. */
    double
    temperature(const unsigned int node, const double time) const;

    /** $\theta_{obs}$ on the axis. */
    double
    of_obstacle(const double time) const
    {
      return of_time.empty() ? heat.obstacle_temperature :
                               of_time.back().value(time);
    }

    /** The temperature that the steady profile of a body goes with. */
    double
    reference(const unsigned int node) const
    {
      return end.nodes()[node].has_partner(Field::temperature) ?
               0. :
               heat.obstacle_temperature;
    }

    /**
     * Heat that leaves a node of temperature @p of_body,
     * $k(\theta-\theta_{obs})$.
     */
    double
    flux(const unsigned int node,
         const double       coefficient,
         const double       of_body,
         const double       time) const
    {
      return coefficient * (of_body - temperature(node, time));
    }

    /**
     * flux() of all nodes of a state, by its coefficients.
     *
     * @param values in: temperatures of the contact nodes; out: the fluxes
     */
    void
    to_fluxes(const State &state, std::vector<double> &values) const
    {
      for (unsigned int i = 0; i < values.size(); ++i)
        values[i] = flux(i,
                         state.contact.exchange_coefficient[i],
                         values[i],
                         state.load_time);
    }

    /** What the law of the exchange is told of a node. */
    ExchangeConditions
    conditions(const unsigned int node,
               const double       of_body,
               const double       time) const
    {
      return {of_body, temperature(node, time), time};
    }

  private:
    const SceneHeat       &heat;
    const ContactEnd<dim> &end;

    /** At all nodes, and last on the axis; empty if it is constant. */
    std::vector<TimeFunction> of_time;
  };
} // namespace ThermoContact

#endif
