// SPDX-License-Identifier: LGPL-2.1-or-later

#include <thermocontact/contact/contact_law.h>

#include <deal.II/base/exceptions.h>

#include <algorithm>
#include <cmath>

namespace ThermoContact
{
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
    const double elastic = pressure(penetration);
    const double c       = damping();
    return c == 0. ? elastic : elastic * std::max(0., 1. + c * v);
  }



  double
  ContactLaw::numerical_dissipation(const double change,
                                    const double,
                                    const double old_pressure,
                                    const double pressure) const
  {
    return pressure * change - (energy(pressure) - energy(old_pressure));
  }



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
    const auto &kinds = contact_laws();
    const auto  kind =
      std::find_if(kinds.begin(), kinds.end(), [&](const ContactLawKind &k) {
        return k.name == name;
      });
    Assert(kind != kinds.end(), dealii::ExcInternalError());
    return *kind;
  }
} // namespace ThermoContact
