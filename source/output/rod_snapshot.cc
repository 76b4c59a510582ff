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
    std::string
    array(const std::string         &type,
          const std::string         &attributes,
          const std::vector<Number> &values)
    {
      const std::uint32_t        size = values.size() * sizeof(Number);
      std::vector<unsigned char> bytes(sizeof(size) + size);
      std::memcpy(bytes.data(), &size, sizeof(size));
      std::memcpy(bytes.data() + sizeof(size), values.data(), size);
      return "<DataArray type=\"" + type + "\" " + attributes +
             " format=\"binary\">\n" + Utilities::encode_base64(bytes) +
             "\n</DataArray>\n";
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
    return !body.scene.material.is_static() &&
           body.discretization.n_active_cells() *
               (body.discretization.degree() + 1) <=
             max_points;
  }



  RodSnapshot::RodSnapshot(const Body<1> &body)
    : fields(body.scene.fields)
    , places(places_on_axis(body.discretization))
    , point_values(body.scene, body.discretization, places)
  {
    std::vector<float>        points;
    std::vector<std::int32_t> connectivity, offsets;
    const unsigned int        n_per_cell = body.discretization.degree() + 1;
    for (std::int32_t i = 0; i < std::int32_t(places.size()); ++i)
      {
        points.insert(points.end(), {float(places[i].position[0]), 0.f, 0.f});
        if ((i + 1) % n_per_cell == 0)
          continue; // the last one of a cell
        connectivity.insert(connectivity.end(), {i, i + 1});
        offsets.push_back(connectivity.size());
      }
    constexpr std::uint8_t line = 3; // VTK_LINE
    cells =
      text("<Piece NumberOfPoints=\"",
           places.size(),
           "\" NumberOfCells=\"",
           offsets.size(),
           "\">\n<Points>\n") +
      array("Float32", "Name=\"Points\" NumberOfComponents=\"3\"", points) +
      "</Points>\n<Cells>\n" +
      array("Int32", "Name=\"connectivity\"", connectivity) +
      array("Int32", "Name=\"offsets\"", offsets) +
      array("UInt8",
            "Name=\"types\"",
            std::vector<std::uint8_t>(offsets.size(), line)) +
      "</Cells>\n<PointData>\n";
  }



  std::string
  RodSnapshot::file(const State &state, const unsigned int cycle)
  {
    std::string file = "<?xml version=\"1.0\"?>\n"
                       "<VTKFile type=\"UnstructuredGrid\" version=\"0.1\" "
                       "byte_order=\"";
    file += byte_order();
    file += "\">\n<UnstructuredGrid>\n<FieldData>\n";
    const std::string scalar =
      "NumberOfTuples=\"1\" format=\"ascii\">"; // of the time and the cycle
    if (cycle > 0)                              // as DataOut
      file += text("<DataArray type=\"Float32\" Name=\"CYCLE\" ",
                   scalar,
                   cycle,
                   "</DataArray>\n");
    file += text("<DataArray type=\"Float32\" Name=\"TIME\" ",
                 scalar,
                 state.time,
                 "</DataArray>\n</FieldData>\n");
    file += cells;
    const std::vector<double> &values = point_values.evaluate(state);
    const auto                 append = [&](const std::string &name,
                            const unsigned int quantity,
                            const unsigned int n_components) {
      std::vector<float> numbers(n_components * places.size(), 0.f);
      for (unsigned int i = 0; i < places.size(); ++i)
        numbers[i * n_components] = values[quantity * places.size() + i];
      file += array("Float32",
                    "Name=\"" + name + "\"" +
                      (n_components > 1 ? " NumberOfComponents=\"3\"" : ""),
                    numbers);
    };
    if (fields.has_displacement)
      {
        append("displacement", PointValues<1>::displacement, 3);
        append("velocity", PointValues<1>::velocity, 3);
      }
    if (fields.has_temperature)
      append("temperature", PointValues<1>::temperature, 1);
    if (fields.has_displacement)
      append("stress", PointValues<1>::stress, 1);
    return file + "</PointData>\n</Piece>\n</UnstructuredGrid>\n</VTKFile>\n";
  }
} // namespace ThermoContact
