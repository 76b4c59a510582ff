// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef thermocontact_contact_heat_exchange_h
#define thermocontact_contact_heat_exchange_h

#include <memory>
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
    virtual ~HeatExchange() = default;

    /** "k = " and what it is, for the screen. */
    virtual std::string
    description() const = 0;

    /** True if $k$ depends on nothing, so that the exchange is linear. */
    virtual bool
    is_constant() const
    {
      return false;
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

  protected:
    /** $k$ as the law has it, unchecked; @p gap, @p pressure $\ge0$. */
    virtual double
    value(const double gap, const double pressure) const = 0;
  };



  /** The exchange of the paper: the same @p coefficient $k\ge0$ always. */
  std::unique_ptr<const HeatExchange>
  constant_exchange(const double coefficient);
} // namespace ThermoContact

#endif
