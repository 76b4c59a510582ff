// SPDX-License-Identifier: LGPL-2.1-or-later

#include <thermocontact/base/text.h>
#include <thermocontact/output/contact_face_file.h>
#include <thermocontact/output/patch_units.h>
#include <thermocontact/space/node_laws.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <sstream>
#include <utility>

namespace ThermoContact
{
  namespace
  {
    /** Nodes along y; the nodes are sorted by z, then by y. */
    template <int dim>
    unsigned int
    n_along_y(const std::vector<ContactNode<dim>> &nodes)
    {
      unsigned int n = 1;
      while (dim > 1 && n < nodes.size() &&
             nodes[n].position[dim > 1 ? 1 : 0] >
               nodes[n - 1].position[dim > 1 ? 1 : 0])
        ++n;
      return n;
    }



    /**
     * The cells of the grid that contact nodes, in order of their positions,
     * form: 2 corners of a line, or 4 of a quadrilateral in the order of VTK,
     * cell after cell.
     */
    template <int dim>
    std::vector<unsigned int>
    contact_face_corners(const std::vector<ContactNode<dim>> &nodes)
    {
      const unsigned int        n = n_along_y(nodes);
      std::vector<unsigned int> corners;
      for (unsigned int j = 0; j + (dim > 2 ? n : 0) < nodes.size(); j += n)
        for (unsigned int i = j; i + 1 < j + n; ++i)
          {
            corners.insert(corners.end(), {i, i + 1});
            if (dim > 2)
              corners.insert(corners.end(), {i + 1 + n, i + n});
          }
      return corners;
    }



    /** A name and the values at the contact nodes. */
    using NamedValues = std::pair<std::string, std::vector<double>>;

    template <int dim>
    std::vector<NamedValues>
    values_of(const Body<dim> &body, const State &state)
    {
      std::vector<double>  temperature, in_contact, gap;
      std::vector<NodeLaw> laws;
      get_node_laws(body, state, laws, gap);
      for (unsigned int i = 0; i < gap.size(); ++i)
        gap[i] = 0. - laws[i].penetration(gap[i]);
      for (const double pressure : state.contact_pressure)
        in_contact.push_back(pressure != 0. ? 1. : 0.);
      std::vector<NamedValues> values = {{"contact_pressure",
                                          state.contact_pressure},
                                         {"gap", gap},
                                         {"in_contact", in_contact}};
      if (body.scene.fields.has_temperature)
        {
          body.contact_end().get_values(Field::temperature,
                                        state.temperature,
                                        temperature);
          values.emplace_back("temperature", temperature);
        }
      return values;
    }



    /** All nodes of the end, sorted by z, then by y. */
    template <int dim>
    std::vector<ContactNode<dim>>
    sorted_nodes(const ContactEnd<dim> &end)
    {
      std::vector<ContactNode<dim>> nodes(end.all_nodes());
      // those without weight, on an axis, stand behind the others
      if (dim == 2)
        std::sort(nodes.begin(),
                  nodes.end(),
                  [](const ContactNode<dim> &a, const ContactNode<dim> &b) {
                    return a.position[dim - 1] < b.position[dim - 1];
                  });
      return nodes;
    }



    std::string
    array(const std::string                              &attributes,
          const unsigned int                              n,
          const std::function<std::string(unsigned int)> &value)
    {
      std::string text = "<DataArray " + attributes + " format=\"ascii\">\n";
      for (unsigned int i = 0; i < n; ++i)
        text += value(i) + "\n";
      return text + "</DataArray>\n";
    }
  } // namespace



  template <int dim>
  std::string
  contact_face_file(const Body<dim>             &body,
                    const State                 &state,
                    const DataOutBase::VtkFlags &flags,
                    const OutputUnits           &units)
  {
    const std::vector<NamedValues> values = values_of(body, state);
    if (Utilities::MPI::this_mpi_process(body.discretization.communicator()) !=
        0)
      return "";

    const auto    &nodes     = body.contact_end().nodes();
    const auto     corners   = contact_face_corners(nodes);
    constexpr auto n_corners = GeometryInfo<dim - 1>::vertices_per_cell;
    constexpr std::array<unsigned int, 4> order = {{0, 1, 3, 2}}; // not VTK's
    std::vector<DataOutBase::Patch<dim - 1, dim>> patches(corners.size() /
                                                          n_corners);
    for (unsigned int c = 0; c < patches.size(); ++c)
      {
        auto &patch          = patches[c];
        patch.patch_index    = c;
        patch.n_subdivisions = 1;
        patch.reference_cell = ReferenceCells::get_hypercube<dim - 1>();
        patch.data.reinit(values.size(), n_corners);
        for (unsigned int i = 0; i < n_corners; ++i)
          {
            const unsigned int node = corners[c * n_corners + order[i]];
            patch.vertices[i]       = nodes[node].position;
            for (unsigned int k = 0; k < values.size(); ++k)
              patch.data(k, i) = values[k].second[node];
          }
      }
    std::vector<std::string> names;
    for (const auto &[name, at_nodes] : values)
      names.push_back(name);
    const std::string     file     = "fields/contact-*.vtu";
    DataOutBase::VtkFlags in_flags = flags;
    in_flags.physical_units        = units_of_arrays(names, file, units);
    std::ostringstream text;
    DataOutBase::write_vtu(in_units(std::move(patches), names, file, units),
                           names,
                           {},
                           in_flags,
                           text);
    return text.str();
  }



  template <int dim>
  std::string
  obstacle_file(const ContactEnd<dim>       &end,
                const OutputUnits           &units,
                const double                 rear_gap,
                const dealii::Function<dim> *gap_at)
  {
    auto       nodes   = sorted_nodes(end);
    auto       corners = contact_face_corners(nodes);
    const auto n_front = nodes.size();
    if (std::isfinite(rear_gap))
      {
        const auto front_corners = corners;
        for (const unsigned int corner : front_corners)
          corners.push_back(n_front + corner);
        for (unsigned int i = 0; i < n_front; ++i)
          {
            nodes.push_back(nodes[i]);
            nodes.back().gap = rear_gap;
          }
      }
    const unsigned int n_nodes = nodes.size(), n_corners = dim > 2 ? 4 : 2,
                       n_cells = corners.size() / n_corners;
    const auto number          = [](const double value) {
      return significant(value, all_digits);
    };
    const auto gap = [&](const unsigned int i) {
      return number(units.of("obstacle.vtu", "gap")(
        gap_at != nullptr ? gap_at->value(nodes[i].position) : nodes[i].gap));
    };
    const Conversion &position = units.of("position");
    const std::string vector   = "NumberOfComponents=\"3\"";
    return "<?xml version=\"1.0\"?>\n"
           "<VTKFile type=\"UnstructuredGrid\" version=\"0.1\">\n"
           "<UnstructuredGrid>\n" +
           text("<Piece NumberOfPoints=\"",
                n_nodes,
                "\" NumberOfCells=\"",
                n_cells,
                "\">\n<Points>\n") +
           array("type=\"Float64\" " + vector,
                 n_nodes,
                 [&](const unsigned int i) {
                   std::string point;
                   for (unsigned int d = 0; d < 3; ++d)
                     point +=
                       (d > 0 ? " " : "") +
                       (d < dim ? number(position(nodes[i].position[d])) : "0");
                   return point;
                 }) +
           "</Points>\n<Cells>\n" +
           array("type=\"Int32\" Name=\"connectivity\"",
                 corners.size(),
                 [&](const unsigned int i) { return text(corners[i]); }) +
           array("type=\"Int32\" Name=\"offsets\"",
                 n_cells,
                 [&](const unsigned int i) {
                   return text((i + 1) * n_corners);
                 }) +
           array("type=\"UInt8\" Name=\"types\"",
                 n_cells,
                 [](const unsigned int) { return dim > 2 ? "9" : "3"; }) +
           "</Cells>\n<PointData>\n" +
           array("type=\"Float64\" Name=\"gap\"", n_nodes, gap) +
           array("type=\"Float64\" Name=\"displacement\" " + vector,
                 n_nodes,
                 [&](const unsigned int i) {
                   return (i < n_front ? "" : "-") + gap(i) + " 0 0";
                 }) +
           "</PointData>\n</Piece>\n</UnstructuredGrid>\n</VTKFile>\n";
  }



  template std::string
  contact_face_file(const Body<2> &,
                    const State &,
                    const DataOutBase::VtkFlags &,
                    const OutputUnits &);
  template std::string
  contact_face_file(const Body<3> &,
                    const State &,
                    const DataOutBase::VtkFlags &,
                    const OutputUnits &);
  template std::string
  obstacle_file(const ContactEnd<1> &,
                const OutputUnits &,
                const double,
                const dealii::Function<1> *);
  template std::string
  obstacle_file(const ContactEnd<2> &,
                const OutputUnits &,
                const double,
                const dealii::Function<2> *);
  template std::string
  obstacle_file(const ContactEnd<3> &,
                const OutputUnits &,
                const double,
                const dealii::Function<3> *);
} // namespace ThermoContact
