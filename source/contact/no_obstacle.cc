// SPDX-License-Identifier: LGPL-2.1-or-later

#include <thermocontact/contact/contact_law.h>

namespace ThermoContact
{
  namespace
  {
    /** A free end: nothing pushes back. */
    class NoObstacle : public ContactLaw
    {
    public:
      std::string
      description() const override
      {
        return "none: free end";
      }

      bool
      is_active() const override
      {
        return false;
      }

      double
      pressure(const double) const override
      {
        return 0.;
      }

      double
      penetration(const double) const override
      {
        return 0.;
      }

      double
      tangent(const double) const override
      {
        return 0.;
      }

      double
      energy(const double) const override
      {
        return 0.;
      }

      double
      penetration_of_energy(const double) const override
      {
        return 0.;
      }

      NodalPressure
      resolve(const double, const double) const override
      {
        return {};
      }

    protected:
      double
      mean_in_contact(const double, const double) const override
      {
        return 0.;
      }
    };
  } // namespace



  ContactLawKind
  no_obstacle()
  {
    return {"none", "free end", {}, [](const ContactLawParameters &) {
              return std::make_unique<NoObstacle>();
            }};
  }
} // namespace ThermoContact
