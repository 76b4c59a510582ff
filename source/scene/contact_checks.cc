// SPDX-License-Identifier: LGPL-2.1-or-later

#include <thermocontact/base/exceptions.h>
#include <thermocontact/base/text.h>
#include <thermocontact/scene/contact_checks.h>

namespace ThermoContact
{
  void
  check_damping(const Scene &scene)
  {
    const double damping = scene.contact.law->damping();
    if (damping == 0.)
      return;
    const auto refuse_since = [&](const std::string &reason,
                                  const std::string &remedy) {
      throw InputError(text("Contact/Damping = ",
                            damping,
                            "\n  allowed: 0, since ",
                            reason,
                            "\n  remedy:  ",
                            remedy));
    };
    if (scene.is_fixed_point)
      refuse_since("Solver/Step solver = fixed point",
                   "Solver/Step solver = monolithic: the iteration of the "
                   "paper is that of an elastic obstacle");
    if (!scene.scheme.needs_linear_contact.empty())
      refuse_since("Time/Scheme = " + scene.scheme.name,
                   "Time/Scheme = " + default_scheme().name +
                     ": an obstacle with damping has no potential, of which "
                     "that scheme needs the gradient");
    if (scene.contact.has_massless_nodes && !scene.material.has_viscosity())
      refuse_since("Contact/Massless nodes = on and Model/Viscosity = 0",
                   "Contact/Massless nodes = automatic: nodes without mass and "
                   "viscosity are in equilibrium at all times, which a damped "
                   "obstacle does not leave them");
  }



  void
  check_rear_gap(const Scene &scene)
  {
    const double rear_gap = scene.contact.rear_gap;
    const auto   refuse   = [rear_gap](const std::string &allowed,
                                   const std::string &remedy) {
      throw InputError(text("Contact/Rear gap = ",
                            rear_gap,
                            "\n  allowed: ",
                            allowed,
                            "\n  remedy:  ",
                            remedy));
    };
    if (!(rear_gap > 0.))
      refuse("none, or g_2 > 0", "Contact/Rear gap = none for one stop");
    if (scene.contact.gap + rear_gap <= 0.)
      refuse(text("above ", -scene.contact.gap, ", minus Contact/Gap"),
             "a larger one: the stops overlap");
  }
} // namespace ThermoContact
