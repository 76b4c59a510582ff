// SPDX-License-Identifier: LGPL-2.1-or-later

#include <thermocontact/space/surroundings.h>

namespace ThermoContact
{
  template <int dim>
  Surroundings<dim>::Surroundings(const Scene           &scene,
                                  const ContactEnd<dim> &end)
    : heat(scene.heat)
    , end(end)
  {
    if (!heat.obstacle_drive)
      return;
    for (const ContactNode<dim> &node : end.nodes())
      of_time.emplace_back(*heat.obstacle_drive, node.position);
    of_time.emplace_back(*heat.obstacle_drive, Point<1>(1.));
  }



  template <int dim>
  double
  Surroundings<dim>::temperature(const unsigned int node,
                                 const double       time) const
  {
    return of_time.empty() ||
               end.nodes()[node].has_partner(Field::temperature) ?
             reference(node) :
             of_time[node].value(time);
  }



  template class Surroundings<1>;
  template class Surroundings<2>;
  template class Surroundings<3>;
} // namespace ThermoContact
