// SPDX-License-Identifier: LGPL-2.1-or-later

#include <thermocontact/output/patch_units.h>
#include <thermocontact/output/snapshot.h>

#include <algorithm>
#include <cmath>
#include <sstream>

namespace ThermoContact
{
  template <int dim>
  std::vector<std::string>
  Snapshot<dim>::vtu_pieces(const Discretization<dim>   &discretization,
                            const DataOutBase::VtkFlags &flags,
                            const OutputUnits           &units)
  {
    constexpr double   max_points = 50000.;
    const unsigned int degree     = discretization.degree();
    const unsigned int n_at_once =
      std::max(1., max_points / std::pow(degree + 1, dim));
    const unsigned int n =
      discretization.dof_handler().get_triangulation().n_active_cells();
    std::vector<std::string> pieces;
    for (unsigned int begin = 0; begin < n; begin += n_at_once)
      {
        this->set_cell_selection(
          [=](const typename Triangulation<dim>::cell_iterator &cell) {
            return cell->is_active() && cell->is_locally_owned() &&
                   cell->active_cell_index() >= begin &&
                   cell->active_cell_index() - begin < n_at_once;
          });
        this->build_patches(discretization.mapping(), degree);
        pieces.push_back(vtu_piece(flags, units));
      }
    return pieces;
  }



  template <int dim>
  std::string
  Snapshot<dim>::vtu_piece(const DataOutBase::VtkFlags &flags,
                           const OutputUnits           &units) const
  {
    if (this->get_patches().empty())
      return "";
    const std::vector<std::string> names  = this->get_dataset_names();
    auto                           ranges = this->get_nonscalar_data_ranges();
    const auto stress = std::find(names.begin(), names.end(), "stress");
    if (dim > 1 && stress != names.end())
      {
        const unsigned int first = stress - names.begin();
        ranges.emplace_back(
          first,
          first + n_stresses<dim> - 1,
          "stress",
          DataComponentInterpretation::component_is_part_of_tensor);
      }
    std::ostringstream text;
    if (units.is_si())
      DataOutBase::write_vtu_main(
        in_units(this->get_patches(), names, "fields/fields-*.vtu", units),
        names,
        ranges,
        flags,
        text);
    else
      DataOutBase::write_vtu_main(
        this->get_patches(), names, ranges, flags, text);
    return text.str();
  }



  template class Snapshot<1>;
  template class Snapshot<2>;
  template class Snapshot<3>;
} // namespace ThermoContact
