// SPDX-License-Identifier: LGPL-2.1-or-later

#include <thermocontact/method/contact_solver.h>
#include <thermocontact/method/exchange_stage.h>

#include <algorithm>
#include <cmath>

namespace ThermoContact
{
  using dealii::FullMatrix;

  namespace
  {
    using Values = std::vector<double>;

    Values
    multiply(const FullMatrix<double> &matrix, const Values &values)
    {
      Values result(values.size(), 0.);
      for (unsigned int i = 0; i < result.size(); ++i)
        for (unsigned int j = 0; j < values.size(); ++j)
          result[i] += matrix(i, j) * values[j];
      return result;
    }



    /** @p left times @p right. */
    FullMatrix<double>
    multiply(const FullMatrix<double> &left, const FullMatrix<double> &right)
    {
      FullMatrix<double> result(left.m(), right.n());
      left.mmult(result, right);
      return result;
    }
  } // namespace



  EndResponse
  seen_from_stops(const EndResponse &response, const NearerStops &stops)
  {
    EndResponse seen(response);
    stops.turn_rows(seen.penetration_by_pressure);
    stops.turn_columns(seen.penetration_by_pressure);
    stops.turn_rows(seen.penetration_by_flux);
    stops.turn_columns(seen.temperature_by_pressure);
    return seen;
  }



  ExchangeStage::ExchangeStage(const ContactLaw        &law,
                               const HeatExchange      &exchange,
                               const EndResponse       &response,
                               const ContactMode        mode,
                               const std::vector<bool> &is_held,
                               const Values            &pressure,
                               const NodesInMotion     &motion)
    : n(response.free_penetration.size())
    , pressure(pressure)
    , law(law)
    , exchange(exchange)
    , response(response)
    , mode(mode)
    , is_held(is_held)
    , motion(motion)
    , is_far(n, false)
  {}



  void
  ExchangeStage::eliminate_fluxes(const Values &coefficient)
  {
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
    free_loss        = multiply(shrinkage, response.free_temperature);
    free_penetration = response.free_penetration;
    for (unsigned int i = 0; i < n; ++i)
      free_penetration[i] -= free_loss[i];
    far_penetration = response.far_penetration;
    for (unsigned int i = 0; i < far_penetration.size(); ++i)
      far_penetration[i] += free_loss[i];
    receptance = response.penetration_by_pressure;
    receptance.add(-1., multiply(shrinkage, response.temperature_by_pressure));
  }



  void
  ExchangeStage::solve_damped_contact()
  {
    // not from penetrations, whose differences have lost digits in short stages
    without_contact = motion;
    for (unsigned int i = 0; i < n; ++i)
      without_contact.free_velocity[i] -= free_loss[i] / motion.tau;
    FullMatrix<double> velocity_response(receptance);
    velocity_response /= motion.tau;
    n_iterations =
      DampedContact(law).solve(velocity_response, without_contact, pressure);
  }



  double
  ExchangeStage::tangent(const unsigned int i) const
  {
    if (law.damping() == 0.)
      return law.tangent(pressure[i]);
    double velocity = without_contact.free_velocity[i];
    for (unsigned int j = 0; j < n; ++j)
      velocity -= receptance(i, j) / motion.tau * pressure[j];
    return motion.tau / DampedContact(law).stiffness(motion, i, velocity);
  }



  void
  ExchangeStage::solve_contact()
  {
    n_iterations = 0;
    if (law.damping() > 0. && mode != ContactMode::open)
      return solve_damped_contact();
    bool is_in_reach = false;
    for (unsigned int i = 0; i < n; ++i)
      is_in_reach |= free_penetration[i] > 0. || stays_closed(i) ||
                     (!far_penetration.empty() && far_penetration[i] > 0.);
    if (mode == ContactMode::closed)
      ContactSolver(law).solve_closed(receptance, free_penetration, pressure);
    else if (mode == ContactMode::unilateral && is_in_reach)
      n_iterations = ContactSolver(law).solve(
        receptance, free_penetration, pressure, is_held, far_penetration);
    else
      pressure.assign(n, 0.);
  }



  std::vector<double>
  ExchangeStage::law_at(const Values &coefficient)
  {
    eliminate_fluxes(coefficient);
    solve_contact();
    Values       driving(response.free_temperature);
    const Values loss = multiply(response.temperature_by_pressure, pressure);
    for (unsigned int i = 0; i < n; ++i)
      driving[i] -= loss[i];
    flux = multiply(conductance, driving);

    penetration          = response.free_penetration;
    const Values by_flux = multiply(response.penetration_by_flux, flux);
    const Values by_contact =
      multiply(response.penetration_by_pressure, pressure);
    Values result(n);
    for (unsigned int i = 0; i < n; ++i)
      {
        const double way = by_flux[i] + by_contact[i];
        penetration[i] -= way;
        if (!response.far_penetration.empty())
          {
            const double far = response.far_penetration[i] + way;
            is_far[i] =
              !stays_closed(i) && nearer_stop(penetration[i], far) < 0;
            if (is_far[i])
              penetration[i] = far;
          }
        if (is_closed(i))
          penetration[i] = 0.;
        result[i] = exchange.coefficient(penetration[i], push(i));
      }
    return result;
  }



  bool
  ExchangeStage::has_rounded_pressure(const unsigned int node) const
  {
    double length = 0.;
    for (const double s : response.free_penetration)
      length = std::max(length, std::abs(s));
    return std::abs(receptance(node, node) * pressure[node]) <= 1e-13 * length;
  }



  double
  ExchangeStage::push(const unsigned int i) const
  {
    return std::max(is_far[i] ? -pressure[i] : pressure[i], 0.);
  }



  FullMatrix<double>
  ExchangeStage::pressure_derivative(const FullMatrix<double> &loss) const
  {
    std::vector<unsigned int> closed, all;
    for (unsigned int i = 0; i < n; ++i)
      {
        all.push_back(i);
        if (is_closed(i) && std::isfinite(tangent(i)))
          closed.push_back(i);
      }
    FullMatrix<double> result(n, n);
    if (closed.empty())
      return result;
    const unsigned int m = closed.size();
    FullMatrix<double> matrix(m, m), rhs(m, n);
    matrix.extract_submatrix_from(receptance, closed, closed);
    rhs.extract_submatrix_from(loss, closed, all);
    for (unsigned int i = 0; i < m; ++i)
      matrix(i, i) += tangent(closed[i]);
    matrix.gauss_jordan();
    FullMatrix<double> of_closed = multiply(matrix, rhs);
    of_closed *= -1.;
    of_closed.scatter_matrix_to(closed, all, result);
    return result;
  }



  FullMatrix<double>
  ExchangeStage::derivative() const
  {
    // from (I + kH) dq = dk (theta - theta_obs) - k U dp
    const Values cooling = multiply(response.temperature_by_flux, flux);
    const Values loss    = multiply(response.temperature_by_pressure, pressure);
    FullMatrix<double> flux_alone(inverse);
    for (unsigned int i = 0; i < n; ++i)
      for (unsigned int j = 0; j < n; ++j)
        flux_alone(i, j) *= response.free_temperature[j] - cooling[j] - loss[j];
    const FullMatrix<double> shrinkage =
      multiply(response.penetration_by_flux, flux_alone);
    const FullMatrix<double> by_pressure = pressure_derivative(shrinkage);
    FullMatrix<double>       result      = multiply(receptance, by_pressure);
    result.add(1., shrinkage); // of the gaps

    double length = 0., load = 0.;
    for (unsigned int i = 0; i < n; ++i)
      {
        length = std::max(length, std::abs(response.free_penetration[i]));
        load   = std::max(load, push(i));
      }
    for (unsigned int i = 0; i < n; ++i)
      {
        // away from the contact, where k may jump
        const bool   closed = is_closed(i);
        const double h      = 1e-7 * (closed ? load : length);
        const double s      = penetration[i];
        const double p      = push(i);
        const double slope =
          h == 0. ?
            0. :
            (exchange.coefficient(closed ? s : s - h, closed ? p + h : p) -
             exchange.coefficient(s, p)) /
              h;
        for (unsigned int j = 0; j < n; ++j)
          result(i, j) = (is_far[i] ? -slope : slope) *
                         (closed ? by_pressure(i, j) : result(i, j));
      }
    return result;
  }
} // namespace ThermoContact
