// SPDX-License-Identifier: LGPL-2.1-or-later

#include <thermocontact/contact/contact_law.h>

namespace ThermoContact
{
  namespace
  {
    /** A free end: nothing pushes back. */
    class NoObstacle : public StoresNothing
    {
    public:
      bool
      is_active() const override
      {
        return false;
      }

      NodalPressure
      resolve(const double, const double) const override
      {
        return {};
      }

    protected:
      std::string
      undamped_description() const override
      {
        return "none: free end";
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
