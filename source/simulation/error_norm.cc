// SPDX-License-Identifier: LGPL-2.1-or-later

#include <thermocontact/base/tolerances.h>
#include <thermocontact/simulation/error_norm.h>

#include <algorithm>
#include <cmath>

namespace ThermoContact
{
  ErrorNorm::ErrorNorm(const double temperature_energy,
                       const double heating,
                       const double inertia,
                       const double accuracy)
    : temperature_energy(temperature_energy)
    , heat_of_deformation(heating * heating / std::max(1., inertia))
    , accuracy(accuracy)
    , max_thermal(0.)
    , max_mechanical(0.)
    , first_thermal(0.)
    , first_mechanical(0.)
  {}



  void
  ErrorNorm::add(const EnergyTerms &energy)
  {
    max_thermal    = std::max(max_thermal, energy.thermal);
    max_mechanical = std::max({max_mechanical, energy.elastic, energy.kinetic});
  }



  double
  ErrorNorm::mechanical_energy(const EnergyTerms &energy) const
  {
    return std::max({max_mechanical == 0. ? first_mechanical : max_mechanical,
                     energy.elastic,
                     energy.kinetic});
  }



  bool
  ErrorNorm::is_rounding(const EnergyTerms &energy,
                         const double       rigid_displacement) const
  {
    return mechanical_energy(energy) <= Tolerances::rounding_of_sum *
                                          rigid_displacement *
                                          rigid_displacement;
  }



  void
  ErrorNorm::note_attempt(const EnergyTerms &energy,
                          const double       rigid_displacement)
  {
    // Without a scale of its own the error of a load that starts like a power
    // of t has the same relative size for every step.
    if (first_thermal == 0. && std::isfinite(energy.thermal))
      first_thermal = energy.thermal;
    if (first_mechanical == 0. && !is_rounding(energy, rigid_displacement) &&
        std::isfinite(energy.elastic + energy.kinetic))
      first_mechanical = std::max(energy.elastic, energy.kinetic);
  }



  double
  ErrorNorm::operator()(const EnergyTerms &error,
                        const EnergyTerms &energy,
                        const double       rigid_displacement) const
  {
    const double mechanical = mechanical_energy(energy);
    const auto   ratio      = [](const double part, const double whole) {
      return part == 0. ? 0. : part / whole;
    };
    const double smallest_elastic =
      0.5 *
      std::pow(Tolerances::strains_of_errors * accuracy * rigid_displacement,
               2);
    const double elastic_error = is_rounding(energy, rigid_displacement) &&
                                     error.elastic <= smallest_elastic ?
                                   0. :
                                   error.elastic;
    const double thermal =
      std::max({max_thermal == 0. ? first_thermal : max_thermal,
                energy.thermal,
                heat_of_deformation * mechanical});
    const double thermal_error =
      error.thermal <= Tolerances::rounding_of_sum *
                         Tolerances::rounding_of_sum *
                         (temperature_energy + thermal) ?
        0. :
        error.thermal;
    return std::sqrt(
      ratio(thermal_error, thermal) +
      ratio(elastic_error + error.kinetic + error.obstacle, mechanical));
  }
} // namespace ThermoContact
