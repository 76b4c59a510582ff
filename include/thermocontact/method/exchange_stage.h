// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef thermocontact_method_exchange_stage_h
#define thermocontact_method_exchange_stage_h

#include <thermocontact/method/contact_law.h>
#include <thermocontact/method/damped_contact.h>
#include <thermocontact/method/heat_exchange.h>
#include <thermocontact/method/two_stops.h>

#include <deal.II/lac/full_matrix.h>

#include <vector>

namespace ThermoContact
{
  /**
   * What the contact nodes have at the end of a stage without pressures and
   * heat fluxes, and what they lose by them, doc/model.md (M.56): penetrations
   * $s=s^{free}-Wp-Vq$, temperatures $\theta=\theta^{free}-Up-Hq$ beyond that
   * of the obstacle. Column j of a matrix is for a unit load at node j.
   */
  struct EndResponse
  {
    std::vector<double> free_penetration; ///< $s^{free}$
    std::vector<double> free_temperature; ///< $\theta^{free}-\theta_{obs}$

    dealii::FullMatrix<double> penetration_by_pressure; ///< $W$
    dealii::FullMatrix<double> penetration_by_flux;     ///< $V$
    dealii::FullMatrix<double> temperature_by_pressure; ///< $U$
    dealii::FullMatrix<double> temperature_by_flux;     ///< $H$

    /** $s^{free}$ at a second stop on the other side; empty: there is none. */
    std::vector<double> far_penetration = {};
  };



  /** The same with each node seen from its stop. */
  EndResponse
  seen_from_stops(const EndResponse &response, const NearerStops &stops);



  /**
   * The contact nodes at the end of a stage for given coefficients $k_i$: what
   * is linear or contact in doc/model.md (M.57), and what the law would have
   * them.
   */
  class ExchangeStage
  {
  public:
    using Values = std::vector<double>;

    /**
     * All references are borrowed.
     *
     * @param is_held nodes that stay closed in mode unilateral; empty: none
     * @param pressure of a nearby problem
     * @param motion without contact and fluxes; with a damped obstacle
     */
    ExchangeStage(const ContactLaw        &law,
                  const HeatExchange      &exchange,
                  const EndResponse       &response,
                  const ContactMode        mode,
                  const std::vector<bool> &is_held,
                  const Values            &pressure,
                  const NodesInMotion     &motion = {});

    const unsigned int n; ///< number of nodes
    Values             pressure;
    Values             flux;
    unsigned int       n_iterations = 0; ///< of ContactSolver

    /**
     * Sets pressures and fluxes for @p coefficient.
     *
     * @return the coefficients of the law at the gaps and pressures there
     */
    Values
    law_at(const Values &coefficient);

    /** Derivatives of the result of the last law_at(), for smooth laws. */
    dealii::FullMatrix<double>
    derivative() const;

    /** After law_at(): the pressure moves the node by less than rounding. */
    bool
    has_rounded_pressure(const unsigned int node) const;

  private:
    const ContactLaw   &law;
    const HeatExchange &exchange;
    const EndResponse  &response;
    const ContactMode   mode;

    const std::vector<bool> &is_held;
    const NodesInMotion      motion;
    NodesInMotion            without_contact; ///< with the fluxes that follow

    dealii::FullMatrix<double> inverse;     ///< $(I+kH)^{-1}$
    dealii::FullMatrix<double> conductance; ///< $(I+kH)^{-1}k$
    dealii::FullMatrix<double> receptance;  ///< $W$ with the fluxes that follow
    Values                     free_penetration;
    Values                     far_penetration; ///< without contact
    Values                     free_loss; ///< of it, by fluxes without pressure
    Values                     penetration; ///< at the nearer stop
    std::vector<bool>          is_far;      ///< that is the second one

    bool
    stays_closed(const unsigned int i) const
    {
      return mode == ContactMode::closed || (mode == ContactMode::unilateral &&
                                             !is_held.empty() && is_held[i]);
    }

    bool
    is_closed(const unsigned int i) const
    {
      return stays_closed(i) || pressure[i] != 0.;
    }

    /** What the heat exchange sees: the push of either stop. */
    double
    push(const unsigned int i) const;

    /** Fluxes as functions of the pressures. */
    void
    eliminate_fluxes(const Values &coefficient);

    void
    solve_contact();

    /** The same for a damped obstacle. */
    void
    solve_damped_contact();

    /** $dp/ds$ of node @p i, inverted. */
    double
    tangent(const unsigned int i) const;

    /** Derivatives of the pressures, from those of the free penetrations. */
    dealii::FullMatrix<double>
    pressure_derivative(const dealii::FullMatrix<double> &loss) const;
  };
} // namespace ThermoContact

#endif
