// SPDX-License-Identifier: LGPL-2.1-or-later

#include <thermocontact/input/probe_positions.h>
#include <thermocontact/output/probe_output.h>

#include <cstdio>

namespace ThermoContact
{
  namespace
  {
    template <int dim>
    std::vector<Place<dim>>
    places_of(const Parameters &parameters)
    {
      std::vector<Place<dim>> places;
      for (const auto &coordinates : parse_probe_positions(
             parameters.output.probes, dim, parameters.mesh.width))
        {
          Point<dim> position;
          for (unsigned int d = 0; d < dim; ++d)
            position[d] = coordinates[d];
          places.push_back({position, position});
        }
      return places;
    }



    void
    append(std::string &row, const char *format, const double number)
    {
      char      text[40];
      const int length = std::snprintf(text, sizeof(text), format, number);
      row.append(text, length);
    }
  } // namespace



  template <int dim>
  ProbeOutput<dim>::ProbeOutput(const std::string &directory,
                                const Body<dim>   &body)
    : path(directory + "/probes.csv")
    , is_writer(Utilities::MPI::this_mpi_process(
                  body.discretization.communicator()) == 0)
    , places(places_of<dim>(body.scene.parameters))
    , point_values(body.scene, body.discretization, places)
  {}



  template <int dim>
  void
  ProbeOutput<dim>::open(const std::string &comments, const std::uint64_t size)
  {
    if (!is_writer)
      return;
    if (size > 0)
      return table_file.reopen(path, size);
    table_file.open(path);
    row = comments;
    for (unsigned int i = 0; i < places.size(); ++i)
      {
        row += "# probe " + std::to_string(i + 1) + ": x = ";
        for (unsigned int d = 0; d < dim; ++d)
          {
            if (d > 0)
              row += d == 1 ? ", y = " : ", z = ";
            append(row, "%.17g", places[i].position[d]);
          }
        row += '\n';
      }
    row += "time";
    for (unsigned int i = 1; i <= places.size(); ++i)
      for (const char *name :
           {"temperature", "displacement", "velocity", "stress"})
        row += std::string(",") + name + '_' + std::to_string(i);
    row += '\n';
    table_file.write_row(row);
  }



  template <int dim>
  void
  ProbeOutput<dim>::write(const State &state)
  {
    const std::vector<double> &values = point_values.evaluate(state);
    if (!is_writer)
      return;
    row.clear();
    append(row, "%.17g", state.time);
    for (unsigned int i = 0; i < places.size(); ++i)
      for (unsigned int field = 0; field < PointValues<dim>::n_quantities;
           ++field)
        append(row, ",%.17g", values[field * places.size() + i]);
    row += '\n';
    table_file.write_row(row);
  }



  template class ProbeOutput<1>;
  template class ProbeOutput<2>;
  template class ProbeOutput<3>;
} // namespace ThermoContact
