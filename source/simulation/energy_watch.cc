// SPDX-License-Identifier: LGPL-2.1-or-later

#include <thermocontact/simulation/energy_watch.h>

#include <algorithm>
#include <sstream>

namespace ThermoContact
{
  namespace
  {
    std::string
    remedy_for(const Scene &scene)
    {
      std::string remedy = scene.parameters.time.has_error_control() ?
                             "a smaller Time/Tolerance" :
                             "a smaller Time/Step size";
      if (!scene.contact.law->is_active())
        return remedy;
      if (scene.contact.has_mass())
        remedy += ", Contact/Massless nodes = on";
      const ContactLaw   &law        = *scene.contact.law;
      const Scheme *const conserving = find_scheme([&](const Scheme &s) {
        return !s.can_create_energy && s.order > 1 &&
               (s.needs_linear_contact.empty() || law.is_linear());
      });
      if (conserving != nullptr && scene.material.has_inertia() &&
          &scene.scheme != conserving)
        remedy +=
          ", or Time/Scheme = " + conserving->name + " with fixed steps";
      return remedy;
    }
  } // namespace



  EnergyWatch::EnergyWatch(const Scene &scene)
    : is_active(!scene.has_work())
    , remedy(remedy_for(scene))
    , allowed_per_run(scene.scheme.can_create_energy &&
                          !scene.parameters.time.has_error_control() ?
                        1e-3 :
                        1e-9)
    , allowed_per_step(scene.parameters.time.has_error_control() ?
                         2. * scene.parameters.time.tolerance :
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
