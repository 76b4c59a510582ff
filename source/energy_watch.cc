// SPDX-License-Identifier: LGPL-2.1-or-later

#include "energy_watch.h"

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
  } // namespace



  EnergyWatch::EnergyWatch(const TimeParameters &time, const bool has_work)
    : is_active(!has_work)
    , allowed_per_run(
        !cannot_create_energy(time) && !time.has_error_control() ? 1e-3 : 1e-9)
    , allowed_per_step(time.has_error_control() ? 2. * time.tolerance : 0.)
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
            << "); remedy: a smaller Time/Tolerance or Step size, "
               "Contact/Massless nodes = on, or Time/Scheme = energy "
               "conserving";
    return message.str();
  }
} // namespace ThermoContact
