// SPDX-License-Identifier: LGPL-2.1-or-later

#include <thermocontact/base/text.h>
#include <thermocontact/input/probe_positions.h>
#include <thermocontact/output/probe_output.h>

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
  } // namespace



  template <int dim>
  ProbeOutput<dim>::ProbeOutput(const std::string &directory,
                                const Body<dim>   &body)
    : path(directory + "/probes.csv")
    , is_writer(Utilities::MPI::this_mpi_process(
                  body.discretization.communicator()) == 0)
    , places(places_of<dim>(body.scene.parameters))
    , point_values(body.scene, body.discretization, places)
    , units(body.scene.parameters)
    , columns(make_columns(places.size()))
    , conversions(units.of_columns("probes.csv", columns))
  {}



  template <int dim>
  CsvColumns<typename ProbeOutput<dim>::Record>
  ProbeOutput<dim>::make_columns(const unsigned int n_places)
  {
    const std::pair<const char *, unsigned int> fields[] = {
      {"temperature", PointValues<dim>::temperature},
      {"displacement", PointValues<dim>::displacement},
      {"velocity", PointValues<dim>::velocity},
      {"stress", PointValues<dim>::stress}};

    CsvColumns<Record> columns = {{"time", &Record::time}};
    for (unsigned int i = 0; i < n_places; ++i)
      for (const auto &[name, field] : fields)
        columns.emplace_back(text(name, '_', i + 1),
                             [k = field * n_places + i](const Record &record) {
                               return record.values[k];
                             });
    return columns;
  }



  template <int dim>
  void
  ProbeOutput<dim>::open(const std::string &comments, const std::uint64_t size)
  {
    if (!is_writer)
      return;
    if (size > 0)
      return table_file.reopen(path, size);
    table_file.open(path);
    std::string       head   = comments;
    const Conversion &length = units.of("position");
    for (unsigned int i = 0; i < places.size(); ++i)
      {
        head += text("# probe ", i + 1, ": x = ");
        for (unsigned int d = 0; d < dim; ++d)
          {
            if (d > 0)
              head += d == 1 ? ", y = " : ", z = ";
            head += significant(length(places[i].position[d]), all_digits) +
                    (length.unit.empty() ? "" : " " + length.unit);
          }
        head += '\n';
      }
    table_file.write_row(head + csv_head(columns, conversions));
  }



  template <int dim>
  void
  ProbeOutput<dim>::write(const State &state)
  {
    const Record record{state.time, point_values.evaluate(state)};
    table_file.append_row([&](std::string &rows) {
      append_csv_row(columns, record, rows, conversions);
    });
  }



  template class ProbeOutput<1>;
  template class ProbeOutput<2>;
  template class ProbeOutput<3>;
} // namespace ThermoContact
