// SPDX-License-Identifier: LGPL-2.1-or-later

#include <thermocontact/contact/contact_law.h>

namespace ThermoContact
{
  namespace
  {
    /** Signorini condition, $s=0$ under any pressure, doc/model.md (M1.5). */
    class RigidObstacle : public ContactLaw
    {
    public:
      std::string
      description() const override
      {
        return "rigid obstacle";
      }

      bool
      is_rigid() const override
      {
        return true;
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
      resolve(const double z, const double r) const override
      {
        return z > 0. ? NodalPressure{z / r, {0., 0.}} : NodalPressure();
      }

      double
      numerical_dissipation(const double,
                            const double old_penetration,
                            const double,
                            const double pressure) const override
      {
        // the way to the obstacle, which a node in contact has gone to its end
        return pressure * -old_penetration;
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
  rigid_obstacle()
  {
    return {"rigid", "Signorini", {}, [](const ContactLawParameters &) {
              return std::make_unique<RigidObstacle>();
            }};
  }
} // namespace ThermoContact
