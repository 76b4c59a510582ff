// SPDX-License-Identifier: LGPL-2.1-or-later

#include <thermocontact/input/parameters.h>
#include <thermocontact/input/section_of_entries.h>
#include <thermocontact/input/unit_text.h>

#include <deal.II/base/patterns.h>

#include <algorithm>

namespace ThermoContact
{
  const std::vector<ScalesParameters::Scale> &
  ScalesParameters::all()
  {
    using S                                = ScalesParameters;
    static const std::vector<Scale> scales = {
      {"Length", &S::length, false, true, "Length of the rod, m."},
      {"Time",
       &S::time,
       false,
       true,
       "Time in which heat diffuses through the rod, s."},
      {"Displacement",
       &S::displacement,
       false,
       false,
       "What displacement, gap and penetration are measured in, m; none: in "
       "Length."},
      {"Stress",
       &S::stress,
       false,
       true,
       "What stress and pressure are measured in, Pa."},
      {"Area",
       &S::area,
       false,
       true,
       "Area of the cross-section, m^2: a force is a stress times it."},
      {"Temperature",
       &S::temperature,
       true,
       true,
       "What temperatures above the reference are measured in, K."},
      {"Reference temperature",
       &S::reference_temperature,
       true,
       true,
       "Absolute temperature of the rod without stress, K, at which the "
       "nondimensional one is 0."}};
    return scales;
  }



  void
  ScalesParameters::add_parameters(ParameterHandler &prm)
  {
    const NumberOrText none = NumberOrText::word("none");
    SectionOfEntries   entry(prm, "Scales");
    for (const Scale &scale : all())
      entry(scale.name, this->*scale.value, none)
        .means(scale.text, kind_of_coefficients);
    entry("Time unit",
          time_unit,
          dealii::Patterns::Selection(names_of_time_units))
      .means("Unit of times in files and on the screen.");
    entry("Temperature unit",
          temperature_unit,
          dealii::Patterns::Selection("K|C"))
      .means("Unit of temperatures there: kelvin, or C for degrees Celsius.");
  }



  bool
  ScalesParameters::is_given() const
  {
    return std::any_of(all().begin(), all().end(), [this](const Scale &scale) {
      return (this->*scale.value).has_value();
    });
  }
} // namespace ThermoContact
