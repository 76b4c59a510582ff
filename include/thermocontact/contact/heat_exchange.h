// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef thermocontact_contact_heat_exchange_h
#define thermocontact_contact_heat_exchange_h

#include <functional>
#include <string>

namespace ThermoContact
{
  /**
   * Heat exchange between one node of the contact boundary and the obstacle,
   * doc/model.md (M5.1): the coefficient $k$ of the flux
   * $k(\theta-\theta_{obs})$ that leaves the body, which may depend on the gap
   * and on the pressure there. No mesh, no matrix.
   */
  class HeatExchange
  {
  public:
    /** As in the paper: the same @p coefficient $k\ge0$ always. */
    explicit HeatExchange(const double coefficient);

    /**
     * @param description "k = " and what it is, for the screen
     * @param value $k$ of gap and pressure, which are $\ge0$; unchecked
     */
    HeatExchange(const std::string                           &description,
                 const std::function<double(double, double)> &value);

    const std::string &
    description() const
    {
      return description_;
    }

    /** True if $k$ depends on nothing, so that the exchange is linear. */
    bool
    is_constant() const
    {
      return is_constant_;
    }

    /**
     * $k\ge0$ of a node.
     *
     * @param penetration $u_n-g$; negative: minus the gap
     * @param pressure not negative
     * @throw ComputationError if $k$ is negative or not finite there
     */
    double
    coefficient(const double penetration, const double pressure) const;

  private:
    const std::string                           description_;
    const bool                                  is_constant_;
    const std::function<double(double, double)> value;
  };
} // namespace ThermoContact

#endif
