// SPDX-License-Identifier: LGPL-2.1-or-later

#include <thermocontact/time/node_equilibrium.h>

namespace ThermoContact
{
  namespace
  {
    SystemCoefficients
    of_nodes(const bool takes_heat, const double factor)
    {
      SystemCoefficients result =
        takes_heat ? motion_at_once : motion_without_heat;
      result.stiffness *= factor;
      return result;
    }
  } // namespace



  template <int dim>
  NodeEquilibrium<dim>::NodeEquilibrium(const Body<dim> &body,
                                        const double     factor,
                                        SolverCounters  &counters,
                                        const bool       takes_heat)
    : body(body)
    , takes_heat(takes_heat && body.equations.is_coupled())
    , system(body.equations,
             of_nodes(this->takes_heat, factor),
             nullptr,
             LinearSystem<dim>::Rows::contact_end)
    , port(body, system)
    , forces(body.discretization.make_vector(Field::displacement))
    , displacement(forces)
    , heat(body.discretization.make_vector(Field::temperature))
  {
    counters.factorizations += system.n_factorizations();
    if (this->takes_heat && system.has_factors())
      counters.responses += body.contact_end().n_all_nodes();
  }



  template <int dim>
  std::vector<double>
  NodeEquilibrium<dim>::changes() const
  {
    std::vector<double> result;
    body.contact_end().get_all_values(Field::displacement,
                                      displacement,
                                      result);
    return result;
  }



  template <int dim>
  FullMatrix<double>
  NodeEquilibrium<dim>::receptance()
  {
    const ContactEnd<dim> &end = body.contact_end();
    FullMatrix<double>     result(end.n_all_nodes(), end.n_nodes());
    for (unsigned int j = 0; j < result.n(); ++j)
      {
        end.set_load_of_node(Field::displacement, j, 1., forces);
        system.solve(displacement, forces);
        const std::vector<double> column = changes();
        for (unsigned int i = 0; i < result.m(); ++i)
          result(i, j) = column[i];
      }
    return result;
  }



  template <int dim>
  std::vector<double>
  NodeEquilibrium<dim>::solve(const std::vector<double>  &load,
                              const std::vector<NodeLaw> &laws,
                              const std::vector<double>  &position,
                              std::vector<double>        &pressure)
  {
    forces = 0.;
    body.contact_end().set_all_values(Field::displacement, load, forces);
    displacement = 0.;
    port.solve_contact(forces, laws, position, 1., displacement, pressure);
    return changes();
  }



  template <int dim>
  std::vector<double>
  NodeEquilibrium<dim>::solve_rates(const std::vector<double>       &load,
                                    const std::vector<double>       &rate,
                                    const std::vector<NodeLaw>      &laws,
                                    const std::vector<unsigned int> &closing)
  {
    forces = 0.;
    body.contact_end().set_all_values(Field::displacement, load, forces);
    port.solve_rates(forces, rate, laws, closing, displacement);
    return changes();
  }



  template <int dim>
  void
  NodeEquilibrium<dim>::add_heating(const std::vector<double> &change,
                                    Vector                    &temperature)
  {
    if (!takes_heat)
      return;
    displacement = 0.;
    body.contact_end().set_all_values(Field::displacement,
                                      change,
                                      displacement);
    system.heat_of_motion(heat, displacement);
    temperature += heat;
  }



  template class NodeEquilibrium<1>;
  template class NodeEquilibrium<2>;
  template class NodeEquilibrium<3>;
} // namespace ThermoContact
