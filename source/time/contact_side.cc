// SPDX-License-Identifier: LGPL-2.1-or-later

#include <thermocontact/time/contact_side.h>

#include <cmath>

namespace ThermoContact
{
  namespace
  {
    /** One that the scene has without a row. */
    ContactSide
    end_of_rod(const Body<1> &body)
    {
      const Material &material = body.scene.material;
      return {1.,
              static_cast<unsigned int>(
                body.contact_end().entries(Field::displacement)[0].second),
              -1,
              body.discretization.n_active_cells(),
              body.scene.parameters.mesh.contact_spacing(),
              std::sqrt(material.inertia),
              1.,
              material.viscosity,
              material.thermal_stress};
    }



    /**
     * @param vertex from the left, in linear cells its node
     * @param sign 1: the body on its left
     */
    ContactSide
    side_of_row(const Body<1> &body, const unsigned int vertex, const int sign)
    {
      const BodyRow     &row      = body.scene.row;
      const Material    &material = body.scene.material;
      const unsigned int next     = sign > 0 ? vertex - 1 : vertex;
      ContactSide        side{
        static_cast<double>(sign), vertex, 0, 0, 0., 0., 0., 0., 0.};
      if (next >= row.cells.size() || row.cells[next].is_gap)
        return side;
      const RowCell &cell = row.cells[next];
      for (unsigned int c = next; c < row.cells.size() && !row.cells[c].is_gap;
           c -= sign)
        ++side.n_cells;
      side.inward                  = -sign;
      const EquationFactors &whole = cell.whole;
      const RowBody         &rod   = row.bodies[cell.body];
      const EquationFactors  end =
        row.of_rod(next, sign > 0 ? rod.end : rod.begin);
      side.cell_size = cell.size;
      side.impedance =
        std::sqrt(material.inertia * end.inertia * end.stiffness);
      side.stiffness = whole.stiffness;
      side.viscosity = material.viscosity * whole.viscosity / whole.stiffness;
      side.thermal_stress = material.thermal_stress * whole.coupling;
      return side;
    }
  } // namespace



  std::vector<std::vector<ContactSide>>
  contact_sides(const Body<1> &body)
  {
    const BodyRow &row = body.scene.row;
    if (!row.is_given())
      return {{end_of_rod(body)}};
    std::vector<std::vector<ContactSide>> sides;
    for (const RowContact &contact : row.contacts)
      sides.push_back({side_of_row(body, contact.cell, 1),
                       side_of_row(body, contact.cell + 1, -1)});
    if (row.meets_obstacle || row.contacts.empty())
      sides.push_back({side_of_row(body, row.cells.size(), 1)});
    return sides;
  }
} // namespace ThermoContact
