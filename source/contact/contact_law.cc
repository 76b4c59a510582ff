// SPDX-License-Identifier: LGPL-2.1-or-later

#include <thermocontact/base/named.h>
#include <thermocontact/base/text.h>
#include <thermocontact/contact/contact_law.h>

#include <algorithm>
#include <cmath>

namespace ThermoContact
{
  std::string
  ContactLaw::description() const
  {
    std::string words = undamped_description();
    if (damping_ > 0.)
      words += text(", damping c = ", damping_);
    if (dashpot_ > 0.)
      words += text(", dashpot d = ", dashpot_);
    return words;
  }



  double
  ContactLaw::mean_pressure(const double s_0, const double s_1) const
  {
    if (s_0 > 0. && s_1 > 0.)
      return mean_in_contact(s_0, s_1);
    const double beyond = std::max({s_0, s_1, 0.});
    return beyond > 0. ? energy(pressure(beyond)) / std::abs(s_1 - s_0) : 0.;
  }



  double
  ContactLaw::damped_pressure(const double penetration, const double v) const
  {
    return !is_damped()      ? pressure(penetration) :
           penetration >= 0. ? std::max(0., held_pressure(penetration, v)) :
                               0.;
  }



  double
  ContactLaw::held_pressure(const double penetration, const double v) const
  {
    return std::copysign(pressure(std::abs(penetration)), penetration) *
             velocity_factor(v) +
           dashpot_ * v;
  }



  double
  ContactLaw::work_to(const double penetration, const double v) const
  {
    return energy(pressure(penetration)) * velocity_factor(v) +
           dashpot_ * penetration * v;
  }



  double
  ContactLaw::numerical_dissipation(const double change,
                                    const double,
                                    const double old_pressure,
                                    const double pressure) const
  {
    return pressure * change - (energy(pressure) - energy(old_pressure));
  }



  ContactLawKind
  power_law();



  const std::vector<ContactLawKind> &
  contact_laws()
  {
    static const std::vector<ContactLawKind> kinds = {normal_compliance(),
                                                      power_law(),
                                                      rigid_obstacle(),
                                                      no_obstacle()};
    return kinds;
  }



  const ContactLawKind &
  contact_law(const std::string &name)
  {
    return named(name, contact_laws());
  }



  bool
  ContactLawKind::uses(const std::string &entry) const
  {
    return std::any_of(entries.begin(),
                       entries.end(),
                       [&](const ContactLawEntry &own) {
                         return own.name == entry;
                       });
  }



  std::vector<ContactLawEntry>
  contact_law_entries()
  {
    ContactLawKind all;
    for (const ContactLawKind &law : contact_laws())
      for (const ContactLawEntry &entry : law.entries)
        if (!all.uses(entry.name))
          all.entries.push_back(entry);
    return all.entries;
  }



  ContactLawParameters
  default_law_parameters()
  {
    ContactLawParameters parameters;
    for (const ContactLawEntry &entry : contact_law_entries())
      parameters[entry.name] = entry.default_value;
    return parameters;
  }



  ContactLawEntry
  compliance_entry()
  {
    return {"Compliance",
            "compliance",
            0.01,
            0.,
            1e15,
            true,
            "Compliance epsilon > 0 of an elastic obstacle: pressure = "
            "penetration / epsilon, or a power of it."};
  }



  ContactLawEntry
  damping_entry()
  {
    return {"Damping",
            "damping",
            0.,
            0.,
            1e15,
            false,
            "Damping c >= 0 of an elastic obstacle (Hunt and Crossley): its "
            "pressure is multiplied by 1 + c times the velocity into it, and "
            "never negative."};
  }



  ContactLawEntry
  dashpot_entry()
  {
    return {"Dashpot",
            "dashpot",
            0.,
            0.,
            1e15,
            false,
            "Coefficient d >= 0 of a dashpot in an elastic obstacle: pressure "
            "d times the velocity into it beside the elastic one, in contact, "
            "and never a pull."};
  }
} // namespace ThermoContact
