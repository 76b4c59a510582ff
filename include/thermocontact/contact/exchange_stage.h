// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef thermocontact_contact_exchange_stage_h
#define thermocontact_contact_exchange_stage_h

#include <thermocontact/contact/heat_exchange.h>
#include <thermocontact/contact/interface_problem.h>

#include <deal.II/lac/full_matrix.h>

#include <vector>

namespace ThermoContact
{
  /**
   * Values of the contact nodes at the end of a stage without pressures and
   * heat fluxes, and their losses by these, doc/contact-in-time.md (C5.1):
   * displacements by $Wp+Vq$, temperatures $\theta=\theta^{free}-Up-Hq$ above
   * the obstacle. Column j of a matrix is for a unit load at node j.
   */
  struct EndResponse
  {
    std::vector<double> free;             ///< $x^{free}$, as the laws have it
    std::vector<double> free_temperature; ///< $\theta^{free}-\theta_{obs}$
    std::vector<double> surroundings;     ///< $\theta_{obs}$
    double              time = 0.;        ///< of the loads

    dealii::FullMatrix<double> penetration_by_pressure; ///< $W$
    dealii::FullMatrix<double> penetration_by_flux;     ///< $V$
    dealii::FullMatrix<double> temperature_by_pressure; ///< $U$
    dealii::FullMatrix<double> temperature_by_flux;     ///< $H$
    dealii::FullMatrix<double> velocity_by_pressure;    ///< $W/\tau$

    /** 1, or $1/\tau$ where x is a velocity. */
    double x_per_displacement = 1.;
  };



  /** $k$ of a node here, with this pressure; no gap if it is in contact. */
  double
  coefficient_of_node(const HeatExchange       &exchange,
                      const NodeLaw            &law,
                      const double              position,
                      const double              pressure,
                      const ExchangeConditions &there);



  /**
   * The contact nodes at the end of a stage for given coefficients $k_i$: the
   * linear part and the contact of doc/contact-in-time.md (C5.2), and the
   * coefficients by the law of the heat exchange.
   */
  class ExchangeStage
  {
  public:
    using Values = std::vector<double>;

    /**
     * All references are borrowed.
     *
     * @param pressure of a nearby problem
     */
    ExchangeStage(const HeatExchange         &exchange,
                  const EndResponse          &response,
                  const std::vector<NodeLaw> &laws,
                  const Values               &pressure);

    const unsigned int n; ///< number of nodes
    Values             pressure;
    Values             flux;
    unsigned int       n_iterations = 0; ///< of InterfaceProblem

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

  private:
    const HeatExchange         &exchange;
    const EndResponse          &response;
    const std::vector<NodeLaw> &laws;
    InterfaceProblem            problem;

    dealii::FullMatrix<double> inverse;     ///< $(I+kH)^{-1}$
    dealii::FullMatrix<double> conductance; ///< $(I+kH)^{-1}k$
    dealii::FullMatrix<double>
           receptance; ///< of x, with the fluxes that follow
    Values position;   ///< of the nodes
    Values slope;      ///< of their laws
    std::vector<ExchangeConditions> conditions; ///< of the nodes

    /** The heat exchange is that of a gap of zero. */
    bool
    is_closed(const unsigned int i) const
    {
      return laws[i].is_held || pressure[i] != 0.;
    }
  };
} // namespace ThermoContact

#endif
