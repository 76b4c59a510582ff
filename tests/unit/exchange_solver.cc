// SPDX-License-Identifier: LGPL-2.1-or-later
//
// Contact and heat exchange of the nodes at the end of a stage, no mesh.
//
// 1. One node, W = V = H = 1, U = 0, k = 1/(1 + gap) open and 1 + p closed,
//    elastic with compliance 1, free temperature 3. By hand:
//      free penetration 0.5:  open with k = 1/2: q = 3/2 / (3/2) = 1,
//                             gap = 1 - 0.5 = 0.5, and 1/(1.5) is not 1/2; with
//                             gap = y, k = 1/(1 + y): q = 3 k/(1 + k) =
//                             3/(2 + y) = y + 0.5: y^2 + 2.5 y - 2 = 0, so
//                             y = (sqrt(14.25) - 2.5)/2
//      free penetration 3.5:  closed, p = (3.5 - q)/2, k = 1 + p, q = 3 k/(1 +
//      k):
//                             q = 3 (5.5 - q)/(7.5 - q), so
//                             q^2 - 10.5 q + 16.5 = 0, q = (10.5 -
//                             sqrt(44.25))/2
//    held open at 3.5: gap 0, k = 1: q = 3/2, p = 0; held closed at 0.5: no
//    gap, p = (0.5 - q)/2 negative, k = 1: q = 3/2, p = -1/2.
// 2. Where k jumps: k = 10 under pressure, 0 else, rigid, W = V = H = 1, U = 0,
//    free penetration 0.1, free temperature 1. Open, nothing cools: it reaches
//    the obstacle; closed, q = 10/11 > 0.1: it leaves. So it touches without
//    pressure: q = 0.1, theta = 0.9, k = 1/9. Two that act on each other, W = V
//    = H = (2 1; 1 2), free penetrations 0.3 and 0.4: both touch without
//    pressure, V q = (0.3, 0.4), so q = (1/15, 1/6), theta = 1 - (0.3, 0.4) and
//    k = q/theta = (2/21, 5/18).
// 3. Random problems with 1 and 6 nodes: [H U; V W] = A^T A + 0.01 I plus an
//    antisymmetric part, columns scaled by positive weights, random compliance,
//    0 in every third: the laws hold to 1e-11 of the largest term, and from
//    other values to start with, too. k = 0.2/(0.1 + gap) + p. With the contact
//    law, with each second node held in contact, with all of them: these have
//    no gap and follow the law to pulls, where k is that of p = 0.
//    300 of 6 nodes with a tenth of V, which heat has on a body, by secants:
//    the same coefficients to 1e-9 in at most 20 systems. Measured: 1e-12, 13.
//    Derivatives of 100 stages of 6 nodes, each second one seen from the rear
//    one of two stops, each third one held, each second stage
//    damped: the difference quotients to 1e-4 of the largest.
// 4. k = 1 - gap, held open, from k = 1, free penetration -2 and temperature 1:
//    q = 1/2, gap = 5/2, where k = -3/2: an error that says so. Of a law of all
//    its arguments, which are different numbers, each with its name; of a law
//    in time the time alone.
// 5. One node in a stage of length tau = 1e-9, deep in a hard damped obstacle,
//    p = 1e20 s [1 + v]_+: v = -1 but for 1e-20. W = V = tau, H = U = 0, k = 2,
//    free temperature 1, velocity 3 without flux and pressure: q = 2 and
//    3 - q - p = -1, so p = 2. s = 1 has 7 digits of tau v, the velocity all.

#include <thermocontact/base/exceptions.h>
#include <thermocontact/contact/exchange_solver.h>

#include <deal.II/lac/identity_matrix.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <random>

#include "../tests.h"

using namespace ThermoContact;
using dealii::FullMatrix;

namespace
{
  using Values = std::vector<double>;

  struct Exchange : public HeatExchange
  {
    explicit Exchange(const std::function<double(double, double)> &value)
      : HeatExchange("k",
                     {true},
                     [value](const double gap,
                             const double pressure,
                             const ExchangeConditions &) {
                       return value(gap, pressure);
                     })
    {}
  };



  /** Nodes that do not act on each other, with W = V = H = 1, U = 0. */
  EndResponse
  separate_nodes(const unsigned int n, const double s, const double theta)
  {
    EndResponse response;
    response.free.assign(n, s);
    response.free_temperature.assign(n, theta);
    response.surroundings.assign(n, 0.);
    response.temperature_by_pressure.reinit(n, n);
    response.penetration_by_pressure = dealii::IdentityMatrix(n);
    response.penetration_by_flux     = response.penetration_by_pressure;
    response.temperature_by_flux     = response.penetration_by_pressure;
    return response;
  }



  struct NodeExchange : ObstacleAction
  {
    std::vector<double> flux;
  };



  NodeExchange
  start(const unsigned int n, const double k)
  {
    const std::vector<double> none(n, 0.);
    return {{none, std::vector<double>(n, k)}, none};
  }



  unsigned int
  solve(const HeatExchange         &exchange,
        const EndResponse          &response,
        const std::vector<NodeLaw> &laws,
        NodeExchange               &end)
  {
    return solve_contact_and_exchange(exchange, response, laws, end, end.flux);
  }



  /** Nodes with one law. */
  std::vector<NodeLaw>
  laws_of(const ContactLaw  &law,
          const unsigned int n,
          const ContactMode  mode = ContactMode::unilateral)
  {
    NodeLaw node(law);
    node.is_held = mode == ContactMode::closed;
    if (mode == ContactMode::open)
      node.law = nullptr;
    return std::vector<NodeLaw>(n, node);
  }



  void
  test_one_node()
  {
    const auto     law = make_law(1.);
    const Exchange exchange([](const double gap, const double p) {
      return p > 0. ? 1. + p : 1. / (1. + gap);
    });
    const double   y = 0.5 * (std::sqrt(14.25) - 2.5);
    const double   q = 0.5 * (10.5 - std::sqrt(44.25));
    for (const double k : {0., 0.3, 20.})
      {
        NodeExchange end = start(1, k);
        solve(exchange, separate_nodes(1, 0.5, 3.), laws_of(*law, 1), end);
        deallog << "from k = " << k << ": open, flux "
                << end.flux[0] / (y + 0.5) << ", pressure " << end.pressure[0]
                << ", k " << end.exchange_coefficient[0] * (1. + y);
        end = start(1, k);
        solve(exchange, separate_nodes(1, 3.5, 3.), laws_of(*law, 1), end);
        deallog << "; closed, flux " << end.flux[0] / q << ", pressure "
                << end.pressure[0] / (0.5 * (3.5 - q)) << std::endl;
      }
    NodeExchange end = start(1, 0.3);
    solve(exchange,
          separate_nodes(1, 3.5, 3.),
          laws_of(*law, 1, ContactMode::open),
          end);
    deallog << "held open: flux " << end.flux[0] << ", pressure "
            << end.pressure[0];
    solve(exchange,
          separate_nodes(1, 0.5, 3.),
          laws_of(*law, 1, ContactMode::closed),
          end);
    deallog << "; held closed: flux " << end.flux[0] << ", pressure "
            << end.pressure[0] << std::endl;
  }



  void
  test_jump()
  {
    const auto     law = make_law(0.);
    const Exchange exchange(
      [](const double, const double p) { return p > 0. ? 10. : 0.; });
    NodeExchange end = start(1, 0.);
    solve(exchange, separate_nodes(1, 0.1, 1.), laws_of(*law, 1), end);
    deallog << "jump: k " << end.exchange_coefficient[0] << ", flux "
            << end.flux[0] << ", pressure below 1e-12 "
            << within(end.pressure[0], 1e-12) << std::endl;
  }



  void
  test_jump_of_coupled_nodes()
  {
    const auto     law = make_law(0.);
    const Exchange exchange(
      [](const double, const double p) { return p > 0. ? 10. : 0.; });
    EndResponse response = separate_nodes(2, 0.3, 1.);
    for (FullMatrix<double> *const matrix : {&response.penetration_by_pressure,
                                             &response.penetration_by_flux,
                                             &response.temperature_by_flux})
      for (unsigned int i = 0; i < 2; ++i)
        for (unsigned int j = 0; j < 2; ++j)
          (*matrix)(i, j) = i == j ? 2. : 1.;
    response.free[1] = 0.4;
    for (const double k : {0., 1.})
      {
        NodeExchange end = start(2, k);
        solve(exchange, response, laws_of(*law, 2), end);
        deallog << "jump of two coupled nodes from k = " << k << ": k "
                << end.exchange_coefficient[0] * 21. / 2. << ' '
                << end.exchange_coefficient[1] * 18. / 5. << ", flux "
                << end.flux[0] * 15. << ' ' << end.flux[1] * 6.
                << ", pressure below 1e-12 "
                << within(std::max(end.pressure[0], end.pressure[1]), 1e-12)
                << std::endl;
      }
  }



  /** $A^TA+0.01I$ of a random matrix. */
  FullMatrix<double>
  random_matrix(const unsigned int n, std::mt19937 &random)
  {
    std::uniform_real_distribution<double> number(-1., 1.);
    FullMatrix<double>                     factor(n, n), matrix(n, n);
    for (unsigned int i = 0; i < n; ++i)
      for (unsigned int j = 0; j < n; ++j)
        factor(i, j) = number(random);
    factor.Tmmult(matrix, factor);
    for (unsigned int i = 0; i < n; ++i)
      matrix(i, i) += 0.01;
    return matrix;
  }



  /** What a stage could answer, and where its nodes would be. */
  EndResponse
  random_response(const unsigned int n, std::mt19937 &random)
  {
    std::uniform_real_distribution<double> number(-1., 1.);
    EndResponse                            response = separate_nodes(n, 0., 0.);
    response.temperature_by_flux                    = random_matrix(n, random);
    response.penetration_by_pressure                = random_matrix(n, random);
    for (unsigned int i = 0; i < n; ++i)
      for (unsigned int j = 0; j < n; ++j)
        {
          response.penetration_by_flux(i, j) = number(random);
          response.temperature_by_pressure(j, i) =
            -response.penetration_by_flux(i, j);
        }
    for (unsigned int j = 0; j < n; ++j)
      {
        const double weight = 0.1 + std::abs(number(random));
        for (FullMatrix<double> *const matrix :
             {&response.temperature_by_flux,
              &response.temperature_by_pressure,
              &response.penetration_by_flux,
              &response.penetration_by_pressure})
          for (unsigned int i = 0; i < n; ++i)
            (*matrix)(i, j) *= weight;
        response.free[j]             = number(random);
        response.free_temperature[j] = 2. * number(random);
      }
    return response;
  }



  /**
   * Largest violation of a law, relative to the largest term.
   *
   * @param is_held nodes that stay in contact
   */
  double
  violation(const EndResponse       &r,
            const NodeExchange      &end,
            const ContactLaw        &law,
            const HeatExchange      &exchange,
            const std::vector<bool> &is_held)
  {
    double       largest = 0., scale = 1.;
    const double n = end.flux.size();
    for (unsigned int i = 0; i < n; ++i)
      {
        double s = r.free[i], theta = r.free_temperature[i];
        for (unsigned int j = 0; j < n; ++j)
          {
            s -= r.penetration_by_pressure(i, j) * end.pressure[j] +
                 r.penetration_by_flux(i, j) * end.flux[j];
            theta -= r.temperature_by_pressure(i, j) * end.pressure[j] +
                     r.temperature_by_flux(i, j) * end.flux[j];
            scale = std::max(
              {scale, std::abs(end.pressure[j]), std::abs(end.flux[j])});
          }
        const double p = end.pressure[i], k = end.exchange_coefficient[i];
        const bool   is_closed = is_held[i] || p > 0.;
        if (!is_held[i])
          raise(largest, -p);
        raise(largest, std::abs(end.flux[i] - k * theta));
        // of a linear law, on both sides of zero
        raise(largest, is_closed ? std::abs(s - law.tangent(0.) * p) : s);
        raise(largest,
              std::abs(k - exchange.coefficient(is_closed ? 0. : s,
                                                std::max(p, 0.),
                                                {theta, 0., 0.})));
      }
    return largest / scale;
  }



  void
  test_random(const std::string &name,
              const ContactMode  mode,
              const bool         holds_second_nodes)
  {
    std::mt19937   random(1);
    const Exchange exchange(
      [](const double gap, const double p) { return 0.2 / (0.1 + gap) + p; });
    for (const unsigned int n : {1, 6})
      {
        double            largest  = 0.;
        unsigned int      n_closed = 0, n_open = 0, n_pulled = 0;
        std::vector<bool> is_held(n, mode == ContactMode::closed);
        for (unsigned int i = 1; i < n && holds_second_nodes; i += 2)
          is_held[i] = true;
        for (unsigned int i = 0; i < 100; ++i)
          {
            const auto law = make_law(i % 3 == 0 ? 0. : 0.1 * (i % 7 + 1));
            const EndResponse response = random_response(n, random);
            for (const double k : {0., 1.})
              {
                NodeExchange         end  = start(n, k);
                std::vector<NodeLaw> laws = laws_of(*law, n);
                for (unsigned int j = 0; j < n; ++j)
                  laws[j].is_held = is_held[j];
                solve(exchange, response, laws, end);
                raise(largest,
                      violation(response, end, *law, exchange, is_held));
                for (const double p : end.pressure)
                  ++(p > 0. ? n_closed : p < 0. ? n_pulled : n_open);
              }
          }
        deallog << n << " random nodes, " << name << ": laws hold to 1e-11 "
                << within(largest, 1e-11) << ", some pressed " << (n_closed > 0)
                << ", open " << (n_open > 0) << ", pulled " << (n_pulled > 0)
                << std::endl;
      }
  }



  /** Where only systems for given coefficients are solved. */
  class BodyOf : public ExchangeOperator
  {
  public:
    explicit BodyOf(ExchangeStage &stage)
      : stage(stage)
    {}

    std::vector<double>
    law_at(const std::vector<double> &coefficient) override
    {
      ++n_systems;
      return stage.law_at(coefficient);
    }

    unsigned int n_systems = 0;

  private:
    ExchangeStage &stage;
  };

  void
  test_secants()
  {
    std::mt19937   random(2);
    const Exchange exchange(
      [](const double gap, const double p) { return 0.2 / (0.1 + gap) + p; });
    double       change = 0.;
    unsigned int most = 0, n_failed = 0;
    for (unsigned int i = 0; i < 300; ++i)
      {
        const auto  law      = make_law(i % 3 == 0 ? 0. : 0.1 * (i % 7 + 1));
        EndResponse response = random_response(6, random);
        response.penetration_by_flux *= 0.1;
        const std::vector<NodeLaw> laws = laws_of(*law, 6);
        NodeExchange               end = start(6, 1.), other = end;
        ExchangeStage stage(exchange, response, laws, other.pressure);
        BodyOf        body(stage);
        try
          {
            solve(exchange, response, laws, end);
            solve_by_secants(body, 1e-12, other.exchange_coefficient);
          }
        catch (const ComputationError &)
          {
            ++n_failed;
            continue;
          }
        most = std::max(most, body.n_systems);
        for (unsigned int j = 0; j < 6; ++j)
          raise(change,
                std::abs(end.exchange_coefficient[j] -
                         other.exchange_coefficient[j]) /
                  end.exchange_coefficient[j]);
      }
    deallog << "by secants: the same to 1e-9 " << within(change, 1e-9)
            << ", at most 20 systems " << (most <= 20) << ", failed "
            << n_failed << std::endl;
  }



  void
  test_derivatives()
  {
    std::mt19937   random(3);
    const Exchange exchange(
      [](const double gap, const double p) { return 0.2 / (0.1 + gap) + p; });
    const double h     = 1e-5;
    double       error = 0.;
    for (unsigned int i = 0; i < 100; ++i)
      {
        const bool  is_damped = i % 2 == 1;
        const auto  law = make_law(0.1 * (i % 7 + 1), is_damped ? 0.6 : 0.);
        EndResponse response      = random_response(6, random);
        std::vector<NodeLaw> laws = laws_of(*law, 6);
        for (unsigned int j = 0; j < 6; ++j)
          {
            laws[j].side           = j % 2 == 0 ? 1 : -1;
            laws[j].play           = 0.7;
            laws[j].is_held        = j % 3 == 2;
            laws[j].is_in_velocity = is_damped;
            laws[j].start          = 0.1 * j;
            laws[j].tau            = 0.8;
          }
        if (is_damped)
          response.x_per_displacement = 1. / 0.8;
        Values        k{1.2, 0.3, 0.7, 1.5, 0.9, 0.4};
        ExchangeStage stage(exchange, response, laws, Values(6, 0.));
        stage.law_at(k);
        const FullMatrix<double> derivative = stage.derivative();
        FullMatrix<double>       difference(derivative);
        for (unsigned int j = 0; j < 6; ++j)
          for (const double sign : {1., -1.})
            {
              k[j] += sign * h;
              const Values there = stage.law_at(k);
              k[j] -= sign * h;
              for (unsigned int l = 0; l < 6; ++l)
                difference(l, j) -= sign * there[l] / (2. * h);
            }
        raise(error, difference.linfty_norm() / derivative.linfty_norm());
      }
    deallog << "derivatives: " << within(error, 1e-4) << std::endl;
  }



  void
  test_negative()
  {
    const auto     law = make_law(1.);
    const Exchange exchange(
      [](const double gap, const double) { return 1. - gap; });
    NodeExchange end = start(1, 1.);
    try
      {
        solve(exchange,
              separate_nodes(1, -2., 1.),
              laws_of(*law, 1, ContactMode::open),
              end);
        deallog << "accepted" << std::endl;
      }
    catch (const ComputationError &error)
      {
        deallog << error.what() << std::endl;
      }
    const auto negative = [](const double, const double, const auto &) {
      return -1.;
    };
    for (const bool is_of_all : {true, false})
      try
        {
          HeatExchange("of all", {is_of_all, is_of_all, true}, negative)
            .coefficient(-0.25, 3., {5., 7., 11.});
        }
      catch (const ComputationError &error)
        {
          deallog << error.what() << std::endl;
        }
  }



  void
  test_short_stage()
  {
    const auto     law = make_law(1e-20, 1.);
    const Exchange exchange([](const double, const double) { return 2.; });
    const double   tau = 1e-9;
    NodeLaw        node(*law);
    node.is_in_velocity                    = true;
    node.start                             = 1.;
    node.tau                               = tau;
    EndResponse response                   = separate_nodes(1, 3., 1.);
    response.x_per_displacement            = 1. / tau;
    response.penetration_by_pressure(0, 0) = tau;
    response.penetration_by_flux(0, 0)     = tau;
    response.temperature_by_flux(0, 0)     = 0.;
    NodeExchange end                       = start(1, 1.);
    solve(exchange, response, {node}, end);
    deallog << "damped, short stage: flux " << end.flux[0]
            << ", pressure to 1e-13 "
            << within(std::abs(end.pressure[0] - 2.), 1e-13) << std::endl;
  }
} // namespace



void
main_exchange_solver()
{
  initlog();
  test_one_node();
  test_jump();
  test_jump_of_coupled_nodes();
  test_random("contact law", ContactMode::unilateral, false);
  test_random("each second held", ContactMode::unilateral, true);
  test_random("all held", ContactMode::closed, false);
  test_secants();
  test_derivatives();
  test_negative();
  test_short_stage();
}
