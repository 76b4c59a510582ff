// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef thermocontact_contact_heat_exchange_h
#define thermocontact_contact_heat_exchange_h

#include <functional>
#include <string>

namespace ThermoContact
{
  /** The temperatures at a node of the contact boundary, and when. */
  struct ExchangeConditions
  {
    double temperature  = 0.; ///< $\theta$ of the body
    double surroundings = 0.; ///< $\theta_{obs}$
    double time         = 0.; ///< of the loads
  };



  /**
   * Heat exchange between one node of the contact boundary and the obstacle,
   * doc/model.md (M5.1): the coefficient $k$ of the flux
   * $k(\theta-\theta_{obs})$ that leaves the body, which may depend on the gap
   * and the pressure there, on both temperatures and on time. No mesh, no
   * matrix.
   */
  class HeatExchange
  {
  public:
    /** $k$ of gap and pressure, which are $\ge0$, and the rest; unchecked. */
    using Law = std::function<double(const double              gap,
                                     const double              pressure,
                                     const ExchangeConditions &there)>;

    /** What $k$ depends on. */
    struct Dependence
    {
      bool on_contact     = false; ///< on gap or pressure
      bool on_temperature = false; ///< of the body, or of the obstacle
      bool on_time        = false;

      /** The flux depends on the temperature of an obstacle that has a mass,
       * which the matrices do not know. */
      bool on_partner = false;

      /** Of the coefficient. */
      bool
      any() const
      {
        return on_contact || on_temperature || on_time;
      }
    };

    /** As in the paper: the same @p coefficient $k\ge0$ always. */
    explicit HeatExchange(const double coefficient);

    /** @param description "k = " and what it is, for the screen */
    HeatExchange(const std::string &description,
                 const Dependence  &dependence,
                 const Law         &law);

    const std::string &
    description() const
    {
      return description_;
    }

    const Dependence &
    dependence() const
    {
      return dependence_;
    }

    /** True if $k$ is a number and the matrices contain the exchange; else it
     * goes through the contact nodes, stage by stage. */
    bool
    is_in_matrices() const
    {
      return !dependence_.any() && !dependence_.on_partner;
    }

    /**
     * $k\ge0$ of a node.
     *
     * @param penetration $u_n-g$; negative: minus the gap
     * @param pressure not negative
     * @throw ComputationError if $k$ is negative or not finite there
     */
    double
    coefficient(const double              penetration,
                const double              pressure,
                const ExchangeConditions &there) const;

  private:
    const std::string description_;
    const Dependence  dependence_;
    const Law         law;
  };
} // namespace ThermoContact

#endif
