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
  ProbeOutput<dim>::ProbeOutput(const Body<dim> &body)
    : units(body.scene.parameters)
    , places(places_of<dim>(body.scene.parameters))
    , point_values(body.scene, body.discretization, places)
    , csv_file("probes.csv", make_columns(places.size()), units)
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
  ProbeOutput<dim>::open(const std::string  &directory,
                         const std::string  &comments,
                         const std::uint64_t size)
  {
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
    csv_file.open(directory, head, size);
  }



  template <int dim>
  void
  ProbeOutput<dim>::write(const State &state)
  {
    csv_file.add({state.time, point_values.evaluate(state)});
  }



  template class ProbeOutput<1>;
  template class ProbeOutput<2>;
  template class ProbeOutput<3>;
} // namespace ThermoContact
