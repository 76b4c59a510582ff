// SPDX-License-Identifier: LGPL-2.1-or-later

#include <thermocontact/base/text.h>
#include <thermocontact/contact/contact_law.h>

#include <utility>

namespace ThermoContact
{
  namespace
  {
    /**
     * An elastic obstacle with the factor $[1+cv]_+$, doc/model.md (M4.2). What
     * the interface tells of pressures and penetrations is that of the elastic
     * law, at $v=0$.
     */
    class DampedObstacle : public ContactLaw
    {
    public:
      DampedObstacle(std::unique_ptr<const ContactLaw> elastic,
                     const double                      damping)
        : elastic(std::move(elastic))
        , coefficient(damping)
      {}

      std::string
      description() const override
      {
        return text(elastic->description(), ", damping c = ", coefficient);
      }

      double
      damping() const override
      {
        return coefficient;
      }

      bool
      is_linear() const override
      {
        return false;
      }

      double
      pressure(const double penetration) const override
      {
        return elastic->pressure(penetration);
      }

      double
      penetration(const double pressure) const override
      {
        return elastic->penetration(pressure);
      }

      double
      tangent(const double pressure) const override
      {
        return elastic->tangent(pressure);
      }

      double
      energy(const double pressure) const override
      {
        return elastic->energy(pressure);
      }

      double
      penetration_of_energy(const double energy) const override
      {
        return elastic->penetration_of_energy(energy);
      }

      NodalPressure
      resolve(const double z, const double r) const override
      {
        return elastic->resolve(z, r);
      }

      double
      numerical_dissipation(const double change,
                            const double old_penetration,
                            const double old_pressure,
                            const double pressure) const override
      {
        return elastic->numerical_dissipation(change,
                                              old_penetration,
                                              old_pressure,
                                              pressure);
      }

    protected:
      double
      mean_in_contact(const double s_0, const double s_1) const override
      {
        return elastic->mean_pressure(s_0, s_1);
      }

    private:
      const std::unique_ptr<const ContactLaw> elastic;
      const double                            coefficient; ///< $c>0$
    };
  } // namespace



  std::unique_ptr<const ContactLaw>
  with_damping(std::unique_ptr<const ContactLaw> elastic, const double damping)
  {
    if (damping == 0.)
      return elastic;
    return std::make_unique<DampedObstacle>(std::move(elastic), damping);
  }
} // namespace ThermoContact
