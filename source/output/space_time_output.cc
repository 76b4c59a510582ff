// SPDX-License-Identifier: LGPL-2.1-or-later

#include <thermocontact/base/writable_file.h>
#include <thermocontact/output/space_time_output.h>
#include <thermocontact/output/vtu_cells.h>

#include <filesystem>
#include <fstream>

namespace ThermoContact
{
  namespace
  {
    /** Quadrilaterals of a piece of the file, which is held in memory. */
    constexpr unsigned int cells_per_piece = 50000;
  } // namespace



  template <int dim>
  SpaceTimeOutput<dim>::SpaceTimeOutput(const std::string &directory,
                                        const Body<dim>   &body)
    : directory(directory)
    , columns_path(directory + "/space-time.columns")
    , units(body.scene.parameters)
    , places(places_on_axis(body.discretization))
    , places_per_cell(body.discretization.degree() + 1)
    , point_values(body.scene, body.discretization, places)
  {
    const SceneFields &fields = body.scene.fields;
    for (unsigned int i = 0; i < PointValues<dim>::n_quantities; ++i)
      if (i == PointValues<dim>::temperature ? fields.has_temperature :
                                               fields.has_displacement)
        {
          quantities.push_back(i);
          names.emplace_back(PointValues<dim>::names[i]);
        }
  }



  template <int dim>
  void
  SpaceTimeOutput<dim>::write(const State &state)
  {
    const std::vector<double> &values = point_values.evaluate(state);
    columns_file.append_row([&](std::string &rows) {
      const auto append = [&rows](const double *numbers, const std::size_t n) {
        rows.append(reinterpret_cast<const char *>(numbers),
                    n * sizeof(double));
      };
      append(&state.time, 1);
      for (const unsigned int quantity : quantities)
        append(values.data() + quantity * places.size(), places.size());
    });
  }



  template <int dim>
  std::string
  SpaceTimeOutput<dim>::write_vtu(const bool is_done)
  {
    if (const std::string fault = columns_file.flush(); !fault.empty())
      return fault;
    namespace fs              = std::filesystem;
    const std::string path    = directory + "/space-time.vtu";
    const double      length  = units.of("position").factor;
    const Conversion &time    = units.of("time");
    const std::size_t n       = places.size();
    bool              has_any = false;
    std::string       fault;
    std::error_code   error;

    VtuCells<2>   cells("space-time.vtu", names, units);
    std::ofstream file(path + part_suffix);
    file << cells.head();
    std::ifstream       columns(columns_path, std::ios::binary);
    std::vector<double> lower(1 + n * names.size()), upper(lower.size());
    const auto          read = [&columns](std::vector<double> &column) {
      columns.read(reinterpret_cast<char *>(column.data()),
                   column.size() * sizeof(double));
      return columns.good();
    };
    for (read(lower); read(upper); lower.swap(upper))
      if (static_cast<float>(lower[0]) < static_cast<float>(upper[0]))
        {
          has_any = true;
          for (unsigned int place = 0; place + 1 < n; ++place)
            if ((place + 1) % places_per_cell != 0)
              cells.add(
                1,
                [&](const unsigned int i) {
                  return Point<2>(length * places[place + i % 2].position[0],
                                  time((i < 2 ? lower : upper)[0]));
                },
                [&](const unsigned int row, const unsigned int i) {
                  return (i < 2 ? lower : upper)[1 + row * n + place + i % 2];
                });
          if (cells.cells().size() >= cells_per_piece)
            file << cells.take_piece();
        }
    if (!cells.cells().empty())
      file << cells.take_piece();
    file << VtuCells<2>::foot();
    file.close();
    if (!has_any && file)
      fs::remove(path + part_suffix, error);
    else
      fault = put_in_place(path,
                           file ? "" :
                                  path +
                                    ": cannot be written\n  remedy:  check "
                                    "free space and rights; the data are in " +
                                    columns_path);
    if (is_done && fault.empty() &&
        !fs::exists(directory + "/checkpoint.bin", error))
      fs::remove(columns_path, error);
    return fault;
  }



  template class SpaceTimeOutput<1>;
  template class SpaceTimeOutput<2>;
  template class SpaceTimeOutput<3>;
} // namespace ThermoContact
