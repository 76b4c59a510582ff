// SPDX-License-Identifier: LGPL-2.1-or-later
//
// Pressures of a damped obstacle from velocities, doc/model.md (M.83), (M.84).
//
// 1. By hand, eps = 1/2, m = 1, c = 2, tau = 1: start s~ = -1, v = 3/2 gives s
//    = 1/2 and p = 1 (1 + 3) = 4, so that the response 1/4 leaves v = 3/2 of
//    the free velocity 5/2. Start 1, v = -1/4: s = 3/4, p = 3/2 * 1/2 = 3/4, so
//    that the response 1 leaves it of 1/2. Start 3, v = -1: 1 + c v < 0, p = 0
//    at s = 2. Start 1 with tau = 0, v = 1/2: p = 2 * 2 = 4, free velocity 1
//    with the response 1/8. An obstacle so hard, phi = 1e24, that all
//    velocities but -1/c, to rounding, make too large a pressure: start 1 and
//    the response 1 leave it of 3/2 if p = 2, one node alone and two. Four
//    nodes, R_ij = f_max(i,j) w_j, f = (38, 12, 7, 2), w = (1, 1, 17, 19):
//    p = 1 leaves -1/2 of R 1 - 1/2 = (206.5, 180.5, 170.5, 75.5). One node
//    after the other, from no pressures, they have 207/38 = 5.4, 9.6, 0.55 and
//    0.71, with which the first one misses 208 of its velocity, more than the
//    207 without pressures.
// 2. A node that is held, start 1/4, tau = 1: v = -1/2 gives s = -1/4 and p =
//    -1/2 [1 - 2/4] = -1/4, so that the response 1 leaves it of -3/4. At the
//    start 1 the factor is 0: p = 0 for the free velocity -2.
// 3. Exponents 1, 1.2, 1.5, 2, 3, 6, c = 0.01 to 100, tau = 1e-6 to 1e3: starts
//    and velocities of 6 nodes that are drawn, and p of their law, make the
//    free velocities v + R p for random responses R, of the size with which
//    pressures matter. The solver has to find p, to 1e-8 of the largest; one
//    node alone to 1e-11 of what a velocity is rounded by.
// 4. Its derivative with respect to the velocity: differences of pressures.
// 5. The end of a static body goes from 0.05 beyond one of two stops to 0.05
//    before it, between both, where there is no pressure, from t = 1 to 2: it
//    leaves at 1.5, seen from either stop.

#include <thermocontact/method/damped_contact.h>
#include <thermocontact/method/event_locator.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "../tests.h"

using namespace ThermoContact;
using dealii::FullMatrix;

namespace
{
  std::unique_ptr<const ContactLaw>
  make_law(const double eps, const double m, const double c)
  {
    return power_law().make({eps, m, c});
  }



  double
  pressure_alone(const ContactLaw &law,
                 const double      tau,
                 const double      start,
                 const double      free_velocity,
                 const double      response,
                 const bool        is_held = false)
  {
    FullMatrix<double> matrix(1, 1);
    matrix(0, 0) = response;
    std::vector<double> pressure;
    DampedContact(law).solve(matrix,
                             {tau, {start}, {free_velocity}, {is_held}},
                             pressure);
    return pressure[0];
  }



  void
  test_by_hand()
  {
    const auto law = make_law(0.5, 1., 2.);
    deallog << "closing " << pressure_alone(*law, 1., -1., 2.5, 0.25)
            << ", opening " << pressure_alone(*law, 1., 1., 0.5, 1.)
            << ", left behind " << pressure_alone(*law, 1., 3., -1., 1.)
            << ", in place " << pressure_alone(*law, 0., 1., 1., 0.125)
            << ", before " << pressure_alone(*law, 1., -1., 0.5, 1.)
            << std::endl;
    const auto         hard = make_law(1e-24, 1., 2.);
    FullMatrix<double> response(2, 2);
    response(0, 0) = response(1, 1) = 1.;
    std::vector<double> pressure;
    DampedContact(*hard).solve(response,
                               {1e-3, {1., 1.}, {1.5, 1.5}, {}},
                               pressure);
    std::vector<double> coupled;
    response.reinit(4, 4);
    for (unsigned int i = 0; i < 4; ++i)
      for (unsigned int j = 0; j < 4; ++j)
        response(i, j) = std::vector<double>{38., 12., 7., 2.}[std::max(i, j)] *
                         std::vector<double>{1., 1., 17., 19.}[j];
    DampedContact(*hard).solve(
      response,
      {1e-3, std::vector<double>(4, 1.), {206.5, 180.5, 170.5, 75.5}, {}},
      coupled);
    const auto factor_of_rounding = make_law(1e-24, 1., 49.); // 1 - 49 (1/49)
    deallog << "hard " << pressure_alone(*hard, 1e-3, 1., 1.5, 1.) << ", "
            << pressure_alone(*factor_of_rounding, 1e-3, 1., 2. - 1. / 49., 1.)
            << ", two " << pressure[0] << ' ' << pressure[1] << ", coupled "
            << coupled[0] << ' ' << coupled[3] << std::endl;
    deallog << "held " << pressure_alone(*law, 1., 0.25, -0.75, 1., true)
            << ", let go " << pressure_alone(*law, 1., 1., -2., 1., true)
            << ", held in contact "
            << pressure_alone(*law, 1., 1., 0.5, 1., true) << std::endl;
  }



  /** Random nodes whose pressures are known. */
  struct Problem
  {
    NodesInMotion       nodes;
    FullMatrix<double>  response;
    std::vector<double> pressure, velocity;
    double              largest = 0.;
  };



  Problem
  draw(const ContactLaw &law,
       const double      eps,
       const double      c,
       const double      tau,
       std::mt19937     &generator)
  {
    std::uniform_real_distribution<double> uniform(-1., 1.);
    const unsigned int                     n = 6;
    Problem                                problem;
    FullMatrix<double>                     factor(n, n);
    problem.response.reinit(n, n);
    for (unsigned int i = 0; i < n; ++i)
      for (unsigned int j = 0; j < n; ++j)
        factor(i, j) = uniform(generator);
    factor.Tmmult(problem.response, factor);
    problem.nodes.tau     = tau;
    const double velocity = std::min(eps / tau, 1. / c);
    for (unsigned int i = 0; i < n; ++i)
      {
        problem.response(i, i) += 0.01;
        const double v = 2. * velocity * uniform(generator);
        const double s = eps * (0.3 + uniform(generator));
        problem.velocity.push_back(v);
        problem.nodes.start.push_back(s - tau * v);
        problem.pressure.push_back(
          law.damped_pressure(problem.nodes.start[i] + tau * v, v));
        raise(problem.largest, problem.pressure[i]);
      }
    if (problem.largest > 0.)
      problem.response *=
        velocity / problem.largest * std::pow(10., 2. * uniform(generator));
    problem.nodes.free_velocity = problem.velocity;
    for (unsigned int i = 0; i < n; ++i)
      for (unsigned int j = 0; j < n; ++j)
        problem.nodes.free_velocity[i] +=
          problem.response(i, j) * problem.pressure[j];
    return problem;
  }



  void
  test_random()
  {
    std::mt19937 generator(5);
    const double exponents[] = {1., 1.2, 1.5, 2., 3., 6.};
    double       worst = 0., worst_alone = 0., worst_slope = 0.;
    unsigned int n_problems = 0, n_slopes = 0;
    for (unsigned int k = 0; k < 300; ++k)
      {
        const double  eps = std::pow(10., -2. + 3. * (k % 4) / 3.);
        const double  c   = std::pow(10., -2. + (k % 5));
        const double  tau = std::pow(10., -6. + (k % 10));
        const auto    law = make_law(eps, exponents[k % 6], c);
        const Problem p   = draw(*law, eps, c, tau, generator);
        if (p.largest == 0.)
          continue;
        for (const double start : {0., 10. * p.largest})
          {
            std::vector<double> pressure(6, start);
            DampedContact(*law).solve(p.response, p.nodes, pressure);
            for (unsigned int i = 0; i < 6; ++i)
              raise(worst, std::abs(pressure[i] - p.pressure[i]) / p.largest);
            ++n_problems;
          }
        const double chi = p.response(0, 0);
        const double slope =
          DampedContact(*law).stiffness(p.nodes, 0, p.velocity[0]);
        const double alone = pressure_alone(*law,
                                            tau,
                                            p.nodes.start[0],
                                            p.velocity[0] + chi * p.pressure[0],
                                            chi);
        const double rounding =
          1e-5 * (p.largest + slope * (std::abs(p.velocity[0]) +
                                       std::abs(p.nodes.start[0]) / tau));
        raise(worst_alone, std::abs(alone - p.pressure[0]) / rounding);
        if (p.pressure[0] < 0.01 * p.largest)
          continue;
        const double h =
          1e-5 * std::min({p.nodes.start[0] / tau + p.velocity[0],
                           p.velocity[0] + 1. / c});
        const auto pressure_at = [&](const double v) {
          return law->damped_pressure(p.nodes.start[0] + tau * v, v);
        };
        raise(worst_slope,
              std::abs((pressure_at(p.velocity[0] + h) -
                        pressure_at(p.velocity[0] - h)) /
                         (2. * h) / slope -
                       1.));
        ++n_slopes;
      }
    deallog << "random: " << (n_problems > 500) << ", pressures "
            << within(worst, 1e-8) << ", one node to 1e-6 of 1e-5 "
            << within(worst_alone, 1e-6) << std::endl;
    deallog << "derivatives: " << (n_slopes > 100) << " "
            << within(worst_slope, 1e-5) << std::endl;
    if (!(worst < 1e-8 && worst_alone < 1e-6 && worst_slope < 1e-5))
      deallog << worst << ' ' << worst_alone << ' ' << worst_slope << std::endl;
  }



  void
  test_end_between_stops()
  {
    const auto law = with_damping(make_law(0.01, 1., 0.), 1.);
    deallog << "leaves one of two stops, at";
    for (const double side : {1., -1.})
      {
        // each stop is 0.2 from the middle
        const auto values = [&](const double time, const double beyond) {
          const double u = side * (0.2 + beyond);
          return ContactValues{time,
                               {u},
                               {u - 0.2},
                               {-side},
                               {side * law->pressure(beyond)},
                               {-u - 0.2}};
        };
        std::vector<ContactEvent> events;
        EventLocator locator(*law, true, ContactNodes::of_static_body, 1e-3);
        locator.start(values(1., 0.05), events);
        const EventLocator::Finding finding =
          locator.examine(values(2., -0.05), false, {1., 1.});
        deallog << ' '
                << (finding.kind == EventLocator::Finding::within ?
                      finding.time :
                      0.);
      }
    deallog << std::endl;
  }
} // namespace



int
main()
{
  initlog();
  test_by_hand();
  test_random();
  test_end_between_stops();
}
