// SPDX-License-Identifier: LGPL-2.1-or-later

#include <thermocontact/space/node_laws.h>
#include <thermocontact/time/contact_equilibrium_many.h>
#include <thermocontact/time/contact_node_problem.h>

#include <limits>
#include <vector>

namespace ThermoContact
{
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
    std::vector<NodeLaw> laws;
    std::vector<double>  position;
    get_node_laws(body, state.gap, displacement, laws, position);
    const std::vector<double> change = problem.solve(load, laws, position, p);
    const std::vector<double> acceleration = problem.solve_for_same_branches(
      rate_load, before_obstacle(state.gap_rate, velocity));
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
    std::vector<NodeLaw>    laws;
    get_velocity_laws(body, state, is_closed, laws);
    end.get_all_values(Field::displacement, state.velocity, velocity);
    for (unsigned int i = 0; i < p.size(); ++i)
      if (!is_closed[i] || laws[i].side * p[i] <= 0.)
        p[i] = 0.;
    const std::vector<double> change =
      problem.solve(load, laws, before_obstacle(state.gap_rate, velocity), p);
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
} // namespace ThermoContact
