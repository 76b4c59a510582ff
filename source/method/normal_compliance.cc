// SPDX-License-Identifier: LGPL-2.1-or-later

#include <thermocontact/base/text.h>
#include <thermocontact/method/contact_law.h>

#include <algorithm>
#include <cmath>

namespace ThermoContact
{
  namespace
  {
    /** Elastic obstacle, $s=\varepsilon p$, doc/model.md (M.4). */
    class NormalCompliance : public ContactLaw
    {
    public:
      explicit NormalCompliance(const double compliance)
        : compliance(compliance)
      {}

      std::string
      description() const override
      {
        return text("elastic obstacle, epsilon = ", compliance);
      }

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

      double
      local_closed_pressure(const double free_penetration,
                            const double receptance) const override
      {
        return free_penetration / (compliance + receptance);
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

    private:
      const double compliance; ///< $\varepsilon>0$
    };
  } // namespace



  ContactLawKind
  normal_compliance()
  {
    return {"normal compliance",
            "elastic obstacle",
            {"Compliance", "Damping"},
            [](const ContactLawParameters &parameters) {
              return with_damping(std::make_unique<NormalCompliance>(
                                    parameters.compliance),
                                  parameters.damping);
            }};
  }
} // namespace ThermoContact
