// SPDX-License-Identifier: LGPL-2.1-or-later

#include <thermocontact/contact/contact_law.h>

namespace ThermoContact
{
  namespace
  {
    /** Signorini condition, $s=0$ under any pressure, doc/model.md (M1.5). */
    class RigidObstacle : public StoresNothing
    {
    public:
      bool
      is_rigid() const override
      {
        return true;
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
      std::string
      undamped_description() const override
      {
        return "rigid obstacle";
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
