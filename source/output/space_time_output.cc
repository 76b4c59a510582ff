// SPDX-License-Identifier: LGPL-2.1-or-later

#include <thermocontact/output/space_time_output.h>

#include <filesystem>

namespace ThermoContact
{
  namespace
  {
    void
    append_bytes(std::string &row, const double *numbers, const std::size_t n)
    {
      row.append(reinterpret_cast<const char *>(numbers), n * sizeof(double));
    }
  } // namespace



  template <int dim>
  SpaceTimeOutput<dim>::SpaceTimeOutput(const std::string &directory,
                                        const Body<dim>   &body)
    : directory(directory)
    , columns_path(directory + "/space-time.columns")
    , units(body.scene.parameters)
    , places(places_on_axis(body.discretization))
    , point_values(body.scene, body.discretization, places)
  {
    layout.places_per_cell  = body.discretization.degree() + 1;
    layout.has_temperature  = body.scene.fields.has_temperature;
    layout.has_displacement = body.scene.fields.has_displacement;
    for (const Place<dim> &place : places)
      layout.x.push_back(place.position[0]);
  }



  template <int dim>
  void
  SpaceTimeOutput<dim>::open(const std::uint64_t size)
  {
    std::string               head;
    const std::vector<double> numbers = layout.head();
    append_bytes(head, numbers.data(), numbers.size());
    columns_file.open(columns_path, head, size);
  }



  template <int dim>
  void
  SpaceTimeOutput<dim>::write(const State &state)
  {
    const std::vector<double> &values = point_values.evaluate(state);
    columns_file.append_row([&](std::string &rows) {
      append_bytes(rows, &state.time, 1);
      const std::size_t n = places.size();
      for (unsigned int i = 0; i < PointValues<dim>::n_quantities; ++i)
        if (i == PointValues<dim>::temperature ? layout.has_temperature :
                                                 layout.has_displacement)
          append_bytes(rows, values.data() + i * n, n);
    });
  }



  template <int dim>
  std::string
  SpaceTimeOutput<dim>::write_vtu(const bool is_done)
  {
    if (const std::string fault = columns_file.flush(); !fault.empty())
      return fault;
    const std::string fault =
      write_space_time_vtu(columns_path, directory + "/space-time.vtu", units);
    std::error_code error;
    if (is_done && fault.empty() &&
        !std::filesystem::exists(directory + "/checkpoint.bin", error))
      std::filesystem::remove(columns_path, error);
    return fault;
  }



  template class SpaceTimeOutput<1>;
  template class SpaceTimeOutput<2>;
  template class SpaceTimeOutput<3>;
} // namespace ThermoContact
