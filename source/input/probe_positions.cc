// SPDX-License-Identifier: LGPL-2.1-or-later

#include <thermocontact/base/exceptions.h>
#include <thermocontact/base/text.h>
#include <thermocontact/input/parameters.h>
#include <thermocontact/input/unit_text.h>

#include <deal.II/base/utilities.h>

#include <sstream>

namespace ThermoContact
{
  namespace
  {
    /** The parts of @p text between separators, also empty ones. */
    std::vector<std::string>
    split(const std::string &text, const char separator)
    {
      std::vector<std::string> parts;
      std::istringstream       stream(text + separator);
      for (std::string part; std::getline(stream, part, separator);)
        parts.push_back(dealii::Utilities::trim(part));
      return parts;
    }



    [[noreturn]] void
    refuse_position(const Parameters  &parameters,
                    const std::string &position,
                    const std::string &fault)
    {
      const unsigned int dim     = parameters.dimension;
      const auto         in_unit = [&](const double x) {
        return parameters.text_of_coordinate(x);
      };
      std::string shown = position;
      if (parameters.rod.is_given())
        {
          shown.clear();
          for (const std::string &part : split(position, ','))
            {
              const auto x = parse_number(part);
              shown += (shown.empty() ? "" : ", ") + (x ? in_unit(*x) : part);
            }
        }
      std::string example = in_unit(0.5) + (dim == 1 ? "; " + in_unit(1.) : "");
      for (unsigned int d = 1; d < dim; ++d)
        example += ", " + in_unit(0.);
      throw InputError("Output/Probes = " + parameters.output.probes + ": '" +
                       shown + "' " + fault + "\n  allowed: " +
                       parameters.mesh.limits_of_places(dim, in_unit) +
                       "; ';' between positions\n  remedy:  e.g. "
                       "Output/Probes = " +
                       example);
    }
  } // namespace



  std::string
  Parameters::text_of_coordinate(const double x) const
  {
    const std::string &unit = output.unit_of_probes;
    if (!rod.is_given())
      return text(x);
    return text(convert_unit(x * rod.length, "m", unit).value(), ' ', unit);
  }



  std::vector<std::array<double, 3>>
  Parameters::probe_positions() const
  {
    const unsigned int                 dim = dimension;
    std::vector<std::array<double, 3>> positions;
    if (dealii::Utilities::trim(output.probes).empty())
      return positions;
    for (const std::string &part : split(output.probes, ';'))
      {
        const auto coordinates = split(part, ',');
        if (coordinates.size() != dim)
          refuse_position(*this,
                          part,
                          text("has ",
                               coordinates.size(),
                               " coordinates, Dimension is ",
                               dim));
        positions.push_back({{0., 0., 0.}});
        for (unsigned int d = 0; d < dim; ++d)
          {
            const auto x = parse_number(coordinates[d]);
            if (!x)
              refuse_position(*this, part, "is no position");
            positions.back()[d] = *x;
          }
        // the rods of a row are looked at where their places are known
        if (has_row() ? !(positions.back()[0] >= 0.) :
                        !mesh.contains(positions.back()))
          refuse_position(*this, part, "is not in the body");
      }
    return positions;
  }
} // namespace ThermoContact
