// SPDX-License-Identifier: LGPL-2.1-or-later

#include <thermocontact/report/key_errors.h>

#include <limits>

namespace ThermoContact
{
  const std::array<const char *, n_key_errors> key_error_names = {
    {"first_contact_time",
     "max_contact_force",
     "max_penetration",
     "contact_impulse",
     "final_displacement_end",
     "final_temperature_end"}};



  namespace
  {
    template <int dim>
    KeyValues
    values_with_peaks(const Simulation<dim> &simulation,
                      const double           force,
                      const double           penetration)
    {
      const StepRecord &record = simulation.record();
      const auto       &events = simulation.events();
      return {{events.empty() ? std::numeric_limits<double>::quiet_NaN() :
                                events.front().time,
               force,
               penetration,
               record.contact_impulse,
               record.displacement_end,
               record.temperature_end}};
    }
  } // namespace



  template <int dim>
  KeyValues
  key_values(const Simulation<dim> &simulation)
  {
    const RunHistory &history = simulation.history();
    return values_with_peaks(simulation,
                             history.max_contact_force,
                             history.max_penetration);
  }



  template <int dim>
  KeyValues
  smooth_key_values(const Simulation<dim> &simulation)
  {
    const RunHistory &history = simulation.history();
    return values_with_peaks(simulation,
                             history.force_peak.estimate(),
                             history.penetration_peak.estimate());
  }



#define INSTANTIATE(dim)                                  \
  template KeyValues key_values(const Simulation<dim> &); \
  template KeyValues smooth_key_values(const Simulation<dim> &)

  INSTANTIATE(1);
  INSTANTIATE(2);
  INSTANTIATE(3);

#undef INSTANTIATE
} // namespace ThermoContact
