// SPDX-License-Identifier: LGPL-2.1-or-later

#include <thermocontact/base/text.h>
#include <thermocontact/output/rod_snapshot.h>

#include <deal.II/base/utilities.h>

#include <cstdint>
#include <cstring>

namespace ThermoContact
{
  namespace
  {
    /** Files of at most 5 kB; of more points compression makes smaller ones. */
    constexpr unsigned int max_points = 64;



    /** An array of a VTU file: its bytes behind their number, in base 64. */
    template <typename Number>
    void
    append_array(std::string               &file,
                 const std::string         &name,
                 const std::vector<Number> &values,
                 const bool                 are_vectors)
    {
      const std::uint32_t        size = values.size() * sizeof(Number);
      std::vector<unsigned char> bytes(sizeof(size) + size);
      std::memcpy(bytes.data(), &size, sizeof(size));
      std::memcpy(bytes.data() + sizeof(size), values.data(), size);
      file += "<DataArray type=\"";
      file += std::is_same<Number, float>::value        ? "Float32" :
              std::is_same<Number, std::int32_t>::value ? "Int32" :
                                                          "UInt8";
      file += "\" Name=\"" + name + "\"";
      if (are_vectors)
        file += " NumberOfComponents=\"3\"";
      file += " format=\"binary\">\n" + Utilities::encode_base64(bytes) +
              "\n</DataArray>\n";
    }



    /** In single precision; of vectors, along the rod. */
    std::vector<float>
    single_precision(const std::vector<double> &values, const bool are_vectors)
    {
      const unsigned int n_components = are_vectors ? 3 : 1;
      std::vector<float> result(n_components * values.size(), 0.f);
      for (unsigned int i = 0; i < values.size(); ++i)
        result[i * n_components] = static_cast<float>(values[i]);
      return result;
    }



    const char *
    byte_order()
    {
      const std::uint16_t one = 1;
      unsigned char       first;
      std::memcpy(&first, &one, 1);
      return first == 1 ? "LittleEndian" : "BigEndian";
    }
  } // namespace



  bool
  RodSnapshot::is_for(const Body<1> &body)
  {
    return body.equations.rod() != nullptr &&
           body.discretization.n_active_cells() *
               (body.discretization.degree() + 1) <=
             max_points;
  }



  RodSnapshot::RodSnapshot(const Body<1> &body)
    : body(body)
    , layout(body.equations.rod()->layout())
    , values(layout.nodes_per_cell(), layout.nodes_per_cell())
    , derivatives(values)
  {
    const unsigned int      p = layout.degree, n = p + 1;
    const FiniteElement<1> &fe =
      body.discretization.finite_element().base_element(0);
    for (unsigned int point = 0; point < n; ++point)
      for (unsigned int node = 0; node < n; ++node)
        {
          const Point<1> position(static_cast<double>(point) / p);
          values(point, node)      = fe.shape_value(node, position);
          derivatives(point, node) = fe.shape_grad(node, position)[0];
        }

    std::vector<double>       points;
    std::vector<std::int32_t> connectivity, offsets;
    vertices.push_back(0.);
    for (const auto &cell :
         body.discretization.dof_handler().active_cell_iterators())
      {
        const double left = cell->vertex(0)[0], right = cell->vertex(1)[0];
        const std::int32_t first = points.size();
        vertices.push_back(right);
        for (unsigned int i = 0; i <= p; ++i)
          points.push_back(left + (right - left) * i / p);
        for (unsigned int i = 0; i < p; ++i)
          {
            connectivity.insert(connectivity.end(),
                                {std::int32_t(first + i),
                                 std::int32_t(first + i + 1)});
            offsets.push_back(connectivity.size());
          }
      }
    constexpr std::uint8_t          line = 3; // VTK_LINE
    const std::vector<std::uint8_t> kinds(offsets.size(), line);
    cells = text("<Piece NumberOfPoints=\"",
                 points.size(),
                 "\" NumberOfCells=\"",
                 offsets.size(),
                 "\">\n<Points>\n");
    append_array(cells, "Points", single_precision(points, true), true);
    cells += "</Points>\n<Cells>\n";
    append_array(cells, "connectivity", connectivity, false);
    append_array(cells, "offsets", offsets, false);
    append_array(cells, "types", kinds, false);
    cells += "</Cells>\n<PointData>\n";
  }



  std::vector<double>
  RodSnapshot::at_points(const Vector             &nodes,
                         const FullMatrix<double> &matrix,
                         const bool                is_derivative) const
  {
    const unsigned int  n = layout.nodes_per_cell();
    std::vector<double> result;
    result.reserve(layout.n_cells * n);
    const double *const value = nodes.begin();
    for (unsigned int cell = 0; cell < layout.n_cells; ++cell)
      for (unsigned int point = 0; point < n; ++point)
        {
          double sum = 0.;
          for (unsigned int node = 0; node < n; ++node)
            sum += matrix(point, node) * value[layout.node(cell, node)];
          result.push_back(
            is_derivative ? sum / (vertices[cell + 1] - vertices[cell]) : sum);
        }
    return result;
  }



  std::string
  RodSnapshot::file(const State &state, const unsigned int cycle) const
  {
    std::string file = "<?xml version=\"1.0\"?>\n"
                       "<VTKFile type=\"UnstructuredGrid\" version=\"0.1\" "
                       "byte_order=\"";
    file += byte_order();
    file += "\">\n<UnstructuredGrid>\n<FieldData>\n";
    if (cycle > 0) // as DataOut
      file += text("<DataArray type=\"Float32\" Name=\"CYCLE\" "
                   "NumberOfTuples=\"1\" format=\"ascii\">",
                   cycle,
                   "</DataArray>\n");
    file += text("<DataArray type=\"Float32\" Name=\"TIME\" "
                 "NumberOfTuples=\"1\" format=\"ascii\">",
                 state.time,
                 "</DataArray>\n</FieldData>\n");
    file += cells;
    const SceneFields &fields   = body.scene.fields;
    const Material    &material = body.scene.material;
    const auto         append   = [&](const std::string         &name,
                            const std::vector<double> &at_points,
                            const bool                 are_vectors) {
      append_array(file,
                   name,
                   single_precision(at_points, are_vectors),
                   are_vectors);
    };
    const auto values_of = [&](const Vector &nodes) {
      return at_points(nodes, values, false);
    };
    if (fields.has_displacement)
      {
        append("displacement", values_of(state.displacement), true);
        append("velocity", values_of(state.velocity), true);
      }
    std::vector<double> temperature;
    if (fields.has_temperature)
      {
        temperature = values_of(state.temperature);
        append("temperature", temperature, false);
      }
    if (fields.has_displacement)
      {
        std::vector<double> stress =
          at_points(state.displacement, derivatives, true);
        const std::vector<double> rate =
          at_points(state.velocity, derivatives, true);
        for (unsigned int i = 0; i < stress.size(); ++i)
          {
            stress[i] += material.viscosity * rate[i];
            if (material.has_thermal_stress())
              stress[i] -= material.thermal_stress * temperature[i];
          }
        append("stress", stress, false);
      }
    file += "</PointData>\n</Piece>\n</UnstructuredGrid>\n</VTKFile>\n";
    return file;
  }
} // namespace ThermoContact
