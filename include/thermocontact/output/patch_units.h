// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef thermocontact_output_patch_units_h
#define thermocontact_output_patch_units_h

#include <thermocontact/output/output_units.h>

#include <deal.II/base/data_out_base.h>

#include <map>
#include <string>
#include <vector>

namespace ThermoContact
{
  /**
   * Patches of a VTU file in units: their points are positions, their values
   * what the table of @p file says of @p names.
   */
  template <int dim, int spacedim>
  std::vector<dealii::DataOutBase::Patch<dim, spacedim>>
  in_units(std::vector<dealii::DataOutBase::Patch<dim, spacedim>> patches,
           const std::vector<std::string>                        &names,
           const std::string                                     &file,
           const OutputUnits                                     &units)
  {
    if (!units.is_si())
      return patches;
    const double length = units.of("position").factor;
    Conversions  conversions;
    for (const std::string &name : names)
      conversions.push_back(units.of(file, name));
    for (auto &patch : patches)
      {
        for (auto &vertex : patch.vertices)
          vertex *= length;
        for (unsigned int row = 0; row < patch.data.n_rows(); ++row)
          for (unsigned int i = 0; i < patch.data.n_cols(); ++i)
            // points, if they are there, stand behind the values
            patch.data(row, i) = row < conversions.size() ?
                                   conversions[row](patch.data(row, i)) :
                                   length * patch.data(row, i);
      }
    return patches;
  }



  /** The units of the arrays @p names, as attributes of a VTU file. */
  inline std::map<std::string, std::string>
  units_of_arrays(const std::vector<std::string> &names,
                  const std::string              &file,
                  const OutputUnits              &units)
  {
    std::map<std::string, std::string> result;
    for (const std::string &name : names)
      if (const std::string &unit = units.of(file, name).unit; !unit.empty())
        result[name] = unit;
    return result;
  }
} // namespace ThermoContact

#endif
