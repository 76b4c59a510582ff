// SPDX-License-Identifier: LGPL-2.1-or-later

#include <thermocontact/base/tolerances.h>
#include <thermocontact/contact/exchange_stage.h>

#include <algorithm>
#include <cmath>

namespace ThermoContact
{
  using dealii::FullMatrix;

  namespace
  {
    using Values = std::vector<double>;

    FullMatrix<double>
    multiply(const FullMatrix<double> &left, const FullMatrix<double> &right)
    {
      FullMatrix<double> result(left.m(), right.n());
      left.mmult(result, right);
      return result;
    }
  } // namespace



  ExchangeStage::ExchangeStage(const HeatExchange         &exchange,
                               const EndResponse          &response,
                               const std::vector<NodeLaw> &laws,
                               const Values               &pressure)
    : n(laws.size())
    , pressure(pressure)
    , exchange(exchange)
    , response(response)
    , laws(laws)
    , position(n)
    , conditions(n)
  {
    for (unsigned int i = 0; i < n; ++i)
      {
        conditions[i].surroundings = response.surroundings[i];
        conditions[i].time         = response.time;
      }
  }



  double
  coefficient_of_node(const HeatExchange       &exchange,
                      const NodeLaw            &law,
                      const double              position,
                      const double              pressure,
                      const ExchangeConditions &there)
  {
    return exchange.coefficient(law.is_held || pressure != 0. ?
                                  0. :
                                  law.penetration(position),
                                law.push(pressure),
                                there);
  }



  std::vector<double>
  ExchangeStage::law_at(const Values &coefficient)
  {
    // fluxes as functions of the pressures
    inverse = response.temperature_by_flux;
    for (unsigned int i = 0; i < n; ++i)
      for (unsigned int j = 0; j < n; ++j)
        inverse(i, j) = coefficient[i] * inverse(i, j) + (i == j ? 1. : 0.);
    inverse.gauss_jordan();
    conductance = inverse;
    for (unsigned int i = 0; i < n; ++i)
      for (unsigned int j = 0; j < n; ++j)
        conductance(i, j) *= coefficient[j];
    const FullMatrix<double> shrinkage =
      multiply(response.penetration_by_flux, conductance);
    const double x_per_displacement = response.x_per_displacement;
    receptance                      = response.penetration_by_pressure;
    receptance.add(-1., multiply(shrinkage, response.temperature_by_pressure));
    receptance *= x_per_displacement;

    Values free    = product(shrinkage, response.free_temperature);
    bool   is_open = true;
    for (unsigned int i = 0; i < n; ++i)
      {
        free[i] = response.free[i] - x_per_displacement * free[i];
        is_open &= laws[i].is_open(free[i]);
      }
    slope.assign(n, 0.);
    n_iterations = 0;
    if (is_open)
      std::fill(pressure.begin(), pressure.end(), 0.);
    else
      {
        n_iterations = problem.solve(receptance, laws, free, pressure);
        slope        = problem.slopes();
      }

    Values       driving(response.free_temperature);
    const Values cooling = product(response.temperature_by_pressure, pressure);
    for (unsigned int i = 0; i < n; ++i)
      driving[i] -= cooling[i];
    flux = product(conductance, driving);

    const Values by_flux   = product(response.penetration_by_flux, flux);
    const Values by_losses = product(response.temperature_by_flux, flux);
    const Values by_contact =
      product(response.penetration_by_pressure, pressure);
    Values result(n);
    for (unsigned int i = 0; i < n; ++i)
      {
        position[i] = laws[i].position(
          response.free[i] - x_per_displacement * (by_flux[i] + by_contact[i]));
        conditions[i].temperature =
          conditions[i].surroundings + driving[i] - by_losses[i];
        result[i] = coefficient_of_node(
          exchange, laws[i], position[i], pressure[i], conditions[i]);
      }
    return result;
  }



  FullMatrix<double>
  ExchangeStage::derivative() const
  {
    // from (I + kH) dq = dk (theta - theta_obs) - k U dp
    const Values cooling = product(response.temperature_by_flux, flux);
    const Values loss    = product(response.temperature_by_pressure, pressure);
    FullMatrix<double> flux_alone(inverse);
    for (unsigned int i = 0; i < n; ++i)
      for (unsigned int j = 0; j < n; ++j)
        flux_alone(i, j) *= response.free_temperature[j] - cooling[j] - loss[j];
    const FullMatrix<double> shrinkage =
      multiply(response.penetration_by_flux, flux_alone);
    FullMatrix<double> by_pressure(shrinkage);
    by_pressure *= -response.x_per_displacement;
    respond_to_change(receptance, slope, by_pressure);
    for (unsigned int i = 0; i < n; ++i)
      for (unsigned int j = 0; j < n; ++j)
        by_pressure(i, j) *= slope[i];
    FullMatrix<double> result = multiply(receptance, by_pressure);
    result *= 1. / response.x_per_displacement;
    result.add(1., shrinkage); // of the gaps in front

    const bool         by_heat = exchange.dependence().on_temperature;
    FullMatrix<double> warming(by_heat ? n : 0); // of the nodes
    if (by_heat)
      {
        FullMatrix<double> fluxes =
          multiply(multiply(conductance, response.temperature_by_pressure),
                   by_pressure);
        fluxes.add(-1., flux_alone);
        warming = multiply(response.temperature_by_flux, fluxes);
        warming.add(-1.,
                    multiply(response.temperature_by_pressure, by_pressure));
      }

    double length = 0., load = 0., warmest = 0.;
    for (unsigned int i = 0; i < n; ++i)
      {
        length  = std::max(length, std::abs(position[i]));
        load    = std::max(load, laws[i].push(pressure[i]));
        warmest = std::max({warmest,
                            std::abs(conditions[i].temperature),
                            std::abs(conditions[i].surroundings)});
      }
    const double by_length  = Tolerances::difference_step * length;
    const double by_load    = Tolerances::difference_step * load;
    const double by_warming = Tolerances::difference_step * warmest;
    for (unsigned int i = 0; i < n; ++i)
      {
        // away from the contact, where k may jump
        const bool         closed = is_closed(i);
        const double       h      = closed ? by_load : by_length;
        const double       s = closed ? 0. : laws[i].penetration(position[i]);
        const double       p = laws[i].push(pressure[i]);
        const double       inwards = closed ? laws[i].push_slope(pressure[i]) :
                                              laws[i].penetration_slope(position[i]);
        const double       k       = exchange.coefficient(s, p, conditions[i]);
        const double       slope_of_k = h == 0. ?
                                          0. :
                                          (exchange.coefficient(closed ? s : s - h,
                                                          closed ? p + h : p,
                                                          conditions[i]) -
                                     k) /
                                      h;
        ExchangeConditions warmer     = conditions[i];
        warmer.temperature += by_warming;
        const double slope_of_heat =
          !by_heat || by_warming == 0. ?
            0. :
            (exchange.coefficient(s, p, warmer) - k) / by_warming;
        for (unsigned int j = 0; j < n; ++j)
          {
            result(i, j) = inwards * slope_of_k *
                           (closed ? by_pressure(i, j) : result(i, j));
            if (by_heat)
              result(i, j) += slope_of_heat * warming(i, j);
          }
      }
    return result;
  }
} // namespace ThermoContact
