// SPDX-License-Identifier: LGPL-2.1-or-later

#include <thermocontact/base/text.h>
#include <thermocontact/contact/contact_law.h>

#include <algorithm>
#include <cmath>

namespace ThermoContact
{
  namespace
  {
    /** Elastic obstacle, $s=\varepsilon p$, doc/model.md (M1.4). */
    class NormalCompliance : public ContactLaw
    {
    public:
      NormalCompliance(const double compliance,
                       const double damping,
                       const double dashpot)
        : ContactLaw(damping, dashpot)
        , compliance(compliance)
      {}

      double
      pressure(const double penetration) const override
      {
        return penetration > 0. ? penetration / compliance : 0.;
      }

      double
      penetration(const double pressure) const override
      {
        return compliance * pressure;
      }

      double
      tangent(const double) const override
      {
        return compliance;
      }

      double
      energy(const double pressure) const override
      {
        return 0.5 * compliance * pressure * pressure;
      }

      double
      penetration_of_energy(const double energy) const override
      {
        return std::sqrt(2. * compliance * energy);
      }

      NodalPressure
      resolve(const double z, const double r) const override
      {
        return z > 0. ? NodalPressure{z / (compliance + r), {compliance, 0.}} :
                        NodalPressure();
      }

      double
      numerical_dissipation(const double change,
                            const double,
                            const double old_pressure,
                            const double pressure) const override
      {
        // the difference of the squares keeps digits that two energies lose
        return pressure * change -
               0.5 * compliance *
                 (pressure * pressure - old_pressure * old_pressure);
      }

    protected:
      double
      mean_in_contact(const double s_0, const double s_1) const override
      {
        return (s_0 + s_1) / (2. * compliance);
      }

      std::string
      undamped_description() const override
      {
        return text("elastic obstacle, epsilon = ", compliance);
      }

    private:
      const double compliance; ///< $\varepsilon>0$
    };
  } // namespace



  ContactLawKind
  normal_compliance()
  {
    return {"normal compliance",
            "elastic obstacle",
            {compliance_entry(), damping_entry(), dashpot_entry()},
            [](const ContactLawParameters &parameters) {
              return std::make_unique<NormalCompliance>(
                parameters.at("Compliance"),
                parameters.at("Damping"),
                parameters.at("Dashpot"));
            }};
  }
} // namespace ThermoContact
