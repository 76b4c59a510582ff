// SPDX-License-Identifier: LGPL-2.1-or-later

#include <thermocontact/base/special_numbers.h>
#include <thermocontact/base/text.h>
#include <thermocontact/contact/contact_law.h>

#include <algorithm>
#include <cmath>

namespace ThermoContact
{
  namespace
  {
    /** $p=(s/\varepsilon)^m$ with $m>1$, doc/model.md (M4.1). */
    class PowerLaw : public ContactLaw
    {
    public:
      PowerLaw(const double compliance,
               const double exponent,
               const double damping,
               const double dashpot)
        : ContactLaw(damping, dashpot)
        , compliance(compliance)
        , exponent(exponent)
      {}

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
                 infinity :
                 compliance / exponent *
                   std::pow(std::abs(pressure), 1. / exponent - 1.);
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
       * Newton's method for $x+(r/\varepsilon)x^m=z/\varepsilon$,
       * $x=s/\varepsilon$, convex and increasing: from a value that is too
       * large it comes down to the solution.
       */
      NodalPressure
      resolve(const double z, const double r) const override
      {
        if (!(z > 0.))
          return {};
        const double load = z / compliance;
        const double chi  = r / compliance;
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
        const double p = std::pow(x, exponent);
        if (!(p > 0.))
          return {p, {}};
        const double t = tangent(p);
        return {p, {t, compliance * x - t * p}};
      }

    protected:
      double
      mean_in_contact(const double s_0, const double s_1) const override
      {
        // (s_1^n - s_0^n) / n (s_1 - s_0) eps^m, n = m + 1, from the smaller on
        const double s      = std::min(s_0, s_1);
        const double excess = std::abs(s_1 - s_0) / s;
        const double n      = exponent + 1.;
        return pressure(s) * (excess > 0. ? std::expm1(n * std::log1p(excess)) /
                                              (n * excess) :
                                            1.);
      }

      bool
      has_constant_tangent() const override
      {
        return false;
      }

      std::string
      undamped_description() const override
      {
        return text("power-law obstacle, epsilon = ",
                    compliance,
                    ", exponent ",
                    exponent);
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
            {compliance_entry(),
             {"Exponent",
              "",
              1.5,
              1.,
              10.,
              false,
              "Exponent m >= 1 of a power law: pressure = (penetration / "
              "epsilon)^m; 1.5 is Hertz's contact of a rounded end, 1 is "
              "normal compliance."},
             damping_entry(),
             dashpot_entry()},
            [](const ContactLawParameters &parameters)
              -> std::unique_ptr<const ContactLaw> {
              const double exponent = parameters.at("Exponent");
              if (exponent == 1.)
                return normal_compliance().make(parameters);
              return std::make_unique<PowerLaw>(parameters.at("Compliance"),
                                                exponent,
                                                parameters.at("Damping"),
                                                parameters.at("Dashpot"));
            }};
  }
} // namespace ThermoContact
