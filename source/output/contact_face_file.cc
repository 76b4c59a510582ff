// SPDX-License-Identifier: LGPL-2.1-or-later

#include <thermocontact/output/contact_face_file.h>
#include <thermocontact/space/node_laws.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace ThermoContact
{
  namespace
  {
    /**
     * Adds the cells between nodes, which are sorted by z, then by y.
     *
     * @param value of a component at a node
     */
    template <int dim, typename Value>
    void
    add_cells(const std::vector<ContactNode<dim>> &nodes,
              const OutputUnits                   &units,
              const Value                         &value,
              VtuCells<dim - 1, dim>              &cells)
    {
      const double length = units.of("position").factor;
      unsigned int n      = 1; // along y
      while (n < nodes.size() &&
             nodes[n].position[1] > nodes[n - 1].position[1])
        ++n;
      for (unsigned int j = 0; j + (dim > 2 ? n : 0) < nodes.size(); j += n)
        for (unsigned int i = j; i + 1 < j + n; ++i)
          {
            const std::array<unsigned int, 4> corners = {
              {i, i + 1, i + n, i + n + 1}};
            cells.add(
              1,
              [&](const unsigned int corner) {
                return length * nodes[corners[corner]].position;
              },
              [&](const unsigned int row, const unsigned int corner) {
                return value(row, corners[corner]);
              });
          }
    }
  } // namespace



  template <int dim>
  VtuCells<dim - 1, dim>
  contact_face(const Body<dim>   &body,
               const State       &state,
               const OutputUnits &units)
  {
    std::vector<double>  temperature, gap;
    std::vector<NodeLaw> laws;
    get_node_laws(body, state, laws, gap);
    body.contact_end().get_values(Field::temperature,
                                  state.temperature,
                                  temperature);
    std::vector<std::string> names = {"contact_pressure", "gap", "in_contact"};
    if (body.scene.fields.has_temperature)
      names.emplace_back("temperature");
    VtuCells<dim - 1, dim> cells("fields/contact-*.vtu", names, units);
    add_cells(
      body.contact_end().nodes(),
      units,
      [&](const unsigned int row, const unsigned int i) {
        const double pressure = state.contact.pressure[i];
        return row == 0 ? pressure :
               row == 1 ? 0. - laws[i].penetration(gap[i]) :
               row == 2 ? laws[i].is_in_contact(gap[i], pressure) :
                          temperature[i];
      },
      cells);
    return cells;
  }



  template <int dim>
  VtuCells<dim - 1, dim>
  obstacle_shape(const Body<dim>             &body,
                 const OutputUnits           &units,
                 const dealii::Function<dim> &gap,
                 const double                 moved)
  {
    std::vector<ContactNode<dim>> nodes(body.contact_end().all_nodes());
    const double                  rear_gap = body.scene.contact.rear_gap;
    // those without weight, on an axis, stand behind the others
    if (dim == 2)
      std::sort(nodes.begin(),
                nodes.end(),
                [](const ContactNode<dim> &a, const ContactNode<dim> &b) {
                  return a.position[1] < b.position[1];
                });
    std::vector<std::string> names(1, "gap");
    names.resize(1 + dim, "displacement");
    VtuCells<dim - 1, dim> cells("obstacle.vtu", names, units);
    cells.join(1, dim);
    add_cells(
      nodes,
      units,
      [&](const unsigned int row, const unsigned int i) {
        return row > 1 ? 0. : moved + gap.value(nodes[i].position);
      },
      cells);
    if (std::isfinite(rear_gap))
      add_cells(
        nodes,
        units,
        [&](const unsigned int row, const unsigned int) {
          return row > 1 ? 0. : row == 1 ? -rear_gap : rear_gap;
        },
        cells);
    return cells;
  }



  template VtuCells<1, 2>
  contact_face(const Body<2> &, const State &, const OutputUnits &);
  template VtuCells<2, 3>
  contact_face(const Body<3> &, const State &, const OutputUnits &);
  template VtuCells<1, 2>
  obstacle_shape(const Body<2> &,
                 const OutputUnits &,
                 const dealii::Function<2> &,
                 const double);
  template VtuCells<2, 3>
  obstacle_shape(const Body<3> &,
                 const OutputUnits &,
                 const dealii::Function<3> &,
                 const double);
} // namespace ThermoContact
