// SPDX-License-Identifier: LGPL-2.1-or-later

#include <thermocontact/output/snapshot.h>
#include <thermocontact/output/vtu_cells.h>

#include <deal.II/base/quadrature_lib.h>

#include <deal.II/fe/fe_values.h>

#include <algorithm>
#include <cmath>

namespace ThermoContact
{
  namespace
  {
    /** Both fields in one vector, with its ghosts. */
    template <int dim>
    BlockVector
    joined(const Discretization<dim> &discretization,
           const Vector              &temperature,
           const Vector              &displacement)
    {
      BlockVector result = discretization.make_ghosted_vector();
      for (const auto &[field, values] :
           {std::pair(Field::temperature, &temperature),
            std::pair(Field::displacement, &displacement)})
        if (discretization.has_field(field))
          result.block(discretization.ghosted_block(field))
            .copy_locally_owned_data_from(*values);
      result.update_ghost_values();
      return result;
    }
  } // namespace



  template <int dim>
  std::vector<std::string>
  snapshot_pieces(const Body<dim>   &body,
                  const State       &state,
                  const unsigned int cycle,
                  const OutputUnits &units)
  {
    const Discretization<dim> &space    = body.discretization;
    const SceneFields         &fields   = body.scene.fields;
    const Material            &material = body.scene.material;
    constexpr unsigned int     n_rows   = dim == 1 ? 1 : 3; // of the stress

    std::vector<std::string> names(fields.has_temperature, "temperature");
    const unsigned int       first = names.size();
    if (fields.has_displacement)
      {
        names.insert(names.end(), dim, "displacement");
        names.insert(names.end(), dim, "velocity");
        names.insert(names.end(), n_rows * n_rows, "stress");
      }
    VtuCells<dim> cells("fields/fields-*.vtu", names, units);
    cells.flags.time  = units.of("time")(state.time);
    cells.flags.cycle = cycle;
    if (fields.has_displacement)
      {
        cells.join(first, first + dim - 1);
        cells.join(first + dim, first + 2 * dim - 1);
        if (dim > 1)
          cells.join(first + 2 * dim, names.size() - 1);
      }

    Vector viscous_displacement = state.displacement;
    viscous_displacement.add(material.viscosity, state.velocity);
    const auto present = joined(space, state.temperature, state.displacement);
    const auto moving  = joined(space, state.temperature, state.velocity);
    const auto viscous = joined(space, state.temperature, viscous_displacement);

    const unsigned int          degree = space.degree();
    FEValues<dim>               values(space.mapping(),
                         space.finite_element(),
                         QIterated<dim>(QTrapezoid<1>(), degree),
                         update_values | update_gradients |
                           update_quadrature_points);
    const unsigned int          n_points = values.n_quadrature_points;
    std::vector<double>         temperature(n_points);
    std::vector<Tensor<1, dim>> displacement(n_points), velocity(n_points),
      total(n_points);
    std::vector<Tensor<2, dim>> gradient(n_points);
    const auto component = [&](unsigned int row, const unsigned int point) {
      if (row < first)
        return temperature[point];
      row -= first;
      if (row < 2 * dim)
        return row < dim ? displacement[point][row] :
                           velocity[point][row - dim];
      const unsigned int d = (row - 2 * dim) / n_rows,
                         e = (row - 2 * dim) % n_rows;
      const Strain strain =
        space.geometry().strain(gradient[point],
                                total[point],
                                values.quadrature_point(point));
      return elastic_stress(material, strain, d, e) -
             (d == e && material.has_thermal_stress() ?
                material.thermal_stress * temperature[point] :
                0.);
    };

    constexpr double         max_points = 50000.;
    const unsigned int       n_at_once  = std::max(1., max_points / n_points);
    std::vector<std::string> pieces;
    for (const auto &cell : space.dof_handler().active_cell_iterators())
      if (cell->is_locally_owned())
        {
          values.reinit(cell);
          if (fields.has_temperature)
            values[space.temperature_extractor()].get_function_values(
              present, temperature);
          if (fields.has_displacement)
            {
              const auto &of_fields = values[space.displacement_extractor()];
              of_fields.get_function_values(present, displacement);
              of_fields.get_function_values(moving, velocity);
              of_fields.get_function_values(viscous, total);
              of_fields.get_function_gradients(viscous, gradient);
            }
          const double length = units.of("position").factor;
          cells.add(
            degree,
            [&](const unsigned int i) { return length * cell->vertex(i); },
            component);
          if (cells.cells().size() == n_at_once)
            pieces.push_back(cells.take_piece());
        }
    // ParaView does not read a file that starts with a piece without cells
    if (!cells.cells().empty())
      pieces.push_back(cells.take_piece());
    return pieces;
  }



  template std::vector<std::string>
  snapshot_pieces(const Body<1> &,
                  const State &,
                  const unsigned int,
                  const OutputUnits &);
  template std::vector<std::string>
  snapshot_pieces(const Body<2> &,
                  const State &,
                  const unsigned int,
                  const OutputUnits &);
  template std::vector<std::string>
  snapshot_pieces(const Body<3> &,
                  const State &,
                  const unsigned int,
                  const OutputUnits &);
} // namespace ThermoContact
