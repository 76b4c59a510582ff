// SPDX-License-Identifier: LGPL-2.1-or-later

#include <thermocontact/space/nearer_stop.h>
#include <thermocontact/time/contact_equilibrium_many.h>
#include <thermocontact/time/contact_node_problem.h>

#include <limits>
#include <vector>

namespace ThermoContact
{
  template <int dim>
  EndPenetrations
  all_penetrations(const Body<dim>           &body,
                   const State               &state,
                   const std::vector<double> &displacement)
  {
    EndPenetrations penetration{before_obstacle(state.gap, displacement), {}};
    if (body.scene.contact.rear_gap)
      for (const double u : displacement)
        penetration.rear.push_back(-u - *body.scene.contact.rear_gap);
    return penetration;
  }



  template <int dim>
  void
  settle_many_nodes(const Body<dim>           &body,
                    const std::vector<double> &load,
                    const std::vector<double> &rate_load,
                    State                     &state)
  {
    const ContactEnd<dim>  &end = body.contact_end();
    std::vector<double>    &p   = state.contact_pressure;
    ContactNodeProblem<dim> problem(body, 1.);
    std::vector<double>     displacement, velocity;
    end.get_all_values(Field::displacement, state.displacement, displacement);
    end.get_all_values(Field::displacement, state.velocity, velocity);
    const std::vector<double> change =
      problem.solve(load,
                    all_penetrations(body, state, displacement),
                    std::vector<bool>(p.size(), body.law().is_active()),
                    p);
    const std::vector<double> acceleration =
      problem.solve_for_same_set(rate_load,
                                 before_obstacle(state.gap_rate, velocity));
    for (unsigned int i = 0; i < displacement.size(); ++i)
      {
        velocity[i] += acceleration[i];
        // where there is pressure, the law is exact to rounding of u
        displacement[i] = i < p.size() && p[i] != 0. ?
                            displacement_of_law(body, state, i) :
                            displacement[i] + change[i];
      }
    end.set_all_values(Field::displacement, displacement, state.displacement);
    end.set_all_values(Field::displacement, velocity, state.velocity);
  }



  template <int dim>
  void
  settle_many_velocities(const Body<dim>           &body,
                         const std::vector<double> &load,
                         const std::vector<bool>   &is_closed,
                         State                     &state)
  {
    const ContactEnd<dim>  &end = body.contact_end();
    ContactNodeProblem<dim> problem(body, body.scene.material.viscosity);
    std::vector<double>    &p = state.contact_pressure;
    std::vector<double>     velocity;
    NearerStops             stops;
    look_at_stops(body, state, stops);
    end.get_all_values(Field::displacement, state.velocity, velocity);
    // towards the other stop nodes are free
    constexpr double infinity = std::numeric_limits<double>::infinity();
    EndPenetrations  into{before_obstacle(state.gap_rate, velocity), {}};
    if (stops.are_two())
      into.rear.assign(velocity.size(), -infinity);
    for (unsigned int i = 0; i < p.size(); ++i)
      {
        const double side = stops.side(i);
        p[i]              = is_closed[i] && side * p[i] > 0. ? p[i] : 0.;
        if (side > 0.)
          continue;
        into.front[i] = -infinity;
        into.rear[i]  = -velocity[i];
      }
    const std::vector<double> change = problem.solve(load, into, is_closed, p);
    for (unsigned int i = 0; i < velocity.size(); ++i)
      velocity[i] = i < p.size() && p[i] != 0. ? state.gap_rate[i] :
                                                 velocity[i] + change[i];
    end.set_all_values(Field::displacement, velocity, state.velocity);
  }



#define INSTANTIATE(dim)                                                 \
  template void settle_many_nodes<dim>(const Body<dim> &,                \
                                       const std::vector<double> &,      \
                                       const std::vector<double> &,      \
                                       State &);                         \
  template void settle_many_velocities<dim>(const Body<dim> &,           \
                                            const std::vector<double> &, \
                                            const std::vector<bool> &,   \
                                            State &)

  INSTANTIATE(2);
  INSTANTIATE(3);

#undef INSTANTIATE

  template EndPenetrations
  all_penetrations<2>(const Body<2> &,
                      const State &,
                      const std::vector<double> &);
  template EndPenetrations
  all_penetrations<3>(const Body<3> &,
                      const State &,
                      const std::vector<double> &);
} // namespace ThermoContact
