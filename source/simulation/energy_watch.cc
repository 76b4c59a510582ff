// SPDX-License-Identifier: LGPL-2.1-or-later

#include <thermocontact/simulation/energy_watch.h>

#include <algorithm>
#include <sstream>

namespace ThermoContact
{
  namespace
  {
    bool
    cannot_create_energy(const TimeParameters &time)
    {
      return time.scheme == "backward euler" || time.is_energy_conserving();
    }



    std::string
    remedy_for(const Parameters &parameters)
    {
      std::string remedy = parameters.time.has_error_control() ?
                             "a smaller Time/Tolerance" :
                             "a smaller Time/Step size";
      if (parameters.contact_law().is_active && parameters.has_contact_mass())
        remedy += ", Contact/Massless nodes = on";
      if (parameters.contact_law().is_active && parameters.model.inertia > 0. &&
          !parameters.time.is_energy_conserving())
        remedy += ", or Time/Scheme = energy conserving with fixed steps";
      return remedy;
    }
  } // namespace



  EnergyWatch::EnergyWatch(const Parameters &parameters, const bool has_work)
    : is_active(!has_work)
    , remedy(remedy_for(parameters))
    , allowed_per_run(!cannot_create_energy(parameters.time) &&
                          !parameters.time.has_error_control() ?
                        1e-3 :
                        1e-9)
    , allowed_per_step(parameters.time.has_error_control() ?
                         2. * parameters.time.tolerance :
                         0.)
    , smallest(0.)
    , scale(0.)
    , n_steps(0)
    , has_warned(false)
  {}



  void
  EnergyWatch::start(const EnergyTerms &terms)
  {
    smallest = terms.sum();
    scale    = terms.magnitude();
    n_steps  = 0;
  }



  std::string
  EnergyWatch::add(const unsigned int step,
                   const double       time,
                   const EnergyTerms &terms)
  {
    scale                = std::max(scale, terms.magnitude());
    const double created = terms.sum() - smallest;
    ++n_steps;
    if (created <= 0.)
      {
        smallest = terms.sum();
        n_steps  = 0;
      }
    const double allowed =
      (allowed_per_run + n_steps * allowed_per_step) * scale;
    if (!is_active || has_warned || created <= allowed)
      return "";
    has_warned = true;
    std::ostringstream message;
    message << "step " << step << ", t = " << time
            << ": the scheme has created the energy " << created
            << ", more than its accuracy explains (" << allowed
            << "); remedy: " << remedy;
    return message.str();
  }
} // namespace ThermoContact
