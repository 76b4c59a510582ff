// SPDX-License-Identifier: LGPL-2.1-or-later

#include <thermocontact/base/number_text.h>
#include <thermocontact/base/text.h>
#include <thermocontact/output/contact_face_file.h>
#include <thermocontact/output/obstacle_file.h>

#include <algorithm>
#include <functional>
#include <optional>
#include <vector>

namespace ThermoContact
{
  namespace
  {
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
