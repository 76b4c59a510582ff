// SPDX-License-Identifier: LGPL-2.1-or-later

#include <thermocontact/base/text.h>
#include <thermocontact/method/contact_law.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace ThermoContact
{
  namespace
  {
    /** $p=(s/\varepsilon)^m$ with $m>1$, doc/model.md (M.69). */
    class PowerLaw : public ContactLaw
    {
    public:
      PowerLaw(const double compliance, const double exponent)
        : compliance(compliance)
        , exponent(exponent)
      {}

      std::string
      description() const override
      {
        return text("power-law obstacle, epsilon = ",
                    compliance,
                    ", exponent ",
                    exponent);
      }

      double
      pressure(const double penetration) const override
      {
        return penetration > 0. ? std::pow(penetration / compliance, exponent) :
                                  0.;
      }

      double
      penetration(const double pressure) const override
      {
        return std::copysign(compliance *
                               std::pow(std::abs(pressure), 1. / exponent),
                             pressure);
      }

      double
      tangent(const double pressure) const override
      {
        return pressure == 0. ?
                 std::numeric_limits<double>::infinity() :
                 compliance / exponent *
                   std::pow(std::abs(pressure), 1. / exponent - 1.);
      }

      bool
      is_linear() const override
      {
        return false;
      }

      double
      energy(const double pressure) const override
      {
        return compliance / (exponent + 1.) *
               std::pow(std::abs(pressure), 1. + 1. / exponent);
      }

      double
      penetration_of_energy(const double energy) const override
      {
        return compliance * std::pow((exponent + 1.) * energy / compliance,
                                     1. / (exponent + 1.));
      }

      /**
       * Newton's method for $x+(\chi/\varepsilon)x^m=s_{free}/\varepsilon$,
       * $x=s/\varepsilon$, convex and increasing: from a value that is too
       * large it comes down to the solution.
       */
      double
      local_closed_pressure(const double free_penetration,
                            const double receptance) const override
      {
        const double load = std::abs(free_penetration) / compliance;
        const double chi  = receptance / compliance;
        double       x    = load;
        if (chi > 0.)
          x = std::min(x, std::pow(load / chi, 1. / exponent));
        for (unsigned int i = 0; i < 100 && x > 0.; ++i)
          {
            const double force = chi * std::pow(x, exponent);
            const double next =
              x - (x + force - load) / (1. + exponent * force / x);
            if (!(next < x))
              break;
            x = next;
          }
        return std::copysign(std::pow(x, exponent), free_penetration);
      }

    private:
      const double compliance; ///< $\varepsilon>0$
      const double exponent;   ///< $m>1$
    };
  } // namespace



  ContactLawKind
  power_law()
  {
    return {"power law",
            "elastic obstacle, pressure = (penetration / epsilon)^m",
            {"Compliance", "Exponent", "Damping"},
            [](const ContactLawParameters &parameters)
              -> std::unique_ptr<const ContactLaw> {
              if (parameters.exponent == 1.)
                return normal_compliance().make(parameters);
              return with_damping(std::make_unique<PowerLaw>(
                                    parameters.compliance, parameters.exponent),
                                  parameters.damping);
            }};
  }
} // namespace ThermoContact
