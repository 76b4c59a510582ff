// SPDX-License-Identifier: LGPL-2.1-or-later
//
// Contact solver, no mesh; contact laws of their own are in contact_laws.cc.
//
// 1. One node, receptance 0.03, gap 0.1 taken off. By hand:
//      compliance 0.01, free displacement 0.12: p = 0.02/0.04 = 0.5
//      rigid,           free displacement 0.13: p = 0.03/0.03 = 1
//      free displacement 0.1 (touching) or less: p = 0; no obstacle: p = 0
// 2. Two nodes, W = [2 1; 1 2], rigid, g = 0. By hand:
//      free (3, 3): both active, p = (1, 1)
//      free (2, 0.5): node 1 alone would reach 0.5 - 1 < 0: p = (1, 0)
// 3. 200 random problems with 6 nodes, W = A^T A + 0.01 I with columns scaled
//    by positive weights, random compliance (0 in every third) and free
//    penetrations of both signs. The solution satisfies p >= 0,
//    r = (W + eps I) p - s >= 0, p r = 0 to 1e-10, whatever the pressures
//    the search starts from; it is unique, so two starts give the same.
// 4. W = [1 0 2; 2 1 0; 0 2 1], a P-matrix but not a response, free (1, 1, 1),
//    rigid: all active, p = (1, 1, 1)/3. From {1} the active sets cycle, {1,
//    3}, {2, 3}, {1, 2}, until the least-index rule takes over after 20 of
//    them.
// 5. Ties: 5 nodes that just touch (free penetration zero), uncoupled and
//    coupled: zero pressure, and no more iterations than nodes, although
//    rounding of either sign makes it a problem of its own.
// 6. Held nodes, W of 2, rigid, free (1, -3). By hand:
//      none held: node 1 alone, p = (1/2, 0), node 2 at -3.5
//      node 2 held: W p = (1, -3), p = (5/3, -7/3), whatever the start
//      one node alone, W = 2, free -3: p = 0, and -3/2 if it is held
// 7. Small changes, (W + 1) dp = (3, 5) on a set, eps = 1. By hand:
//      node 1: 3 dp = 3, dp = (1, 0); both: dp = (4, 12)/8; none: dp = 0
// 8. Two stops, 200 random problems with 6 nodes and responses as in 3, play
//    d from 0.1 to 2, linear, rigid, power law m = 2, damped c = 1/2: with x =
//    s - W p, each node has p = phi(x) - phi(-x - d), (M.114), or at a rigid
//    stop x = 0 with p > 0, x = -d with p < 0, or lies between; damped with the
//    factors [1 +- c v]_+, x = x_0 + v; to 1e-10, whatever the start. Nodes are
//    at both stops.

#include <thermocontact/method/contact_solver.h>
#include <thermocontact/method/damped_contact.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <random>
#include <utility>

#include "../tests.h"

using namespace ThermoContact;
using dealii::FullMatrix;

namespace
{
  void
  test_one_node()
  {
    for (const double compliance : {0.01, 0.})
      for (const double free_displacement : {0.12, 0.13, 0.1, -1.})
        deallog
          << "compliance " << compliance << ", free displacement "
          << free_displacement << ": p "
          << make_law(compliance)->local_pressure(free_displacement - 0.1, 0.03)
          << std::endl;
    deallog << "no obstacle: p "
            << no_obstacle().make({})->local_pressure(0.02, 0.03) << std::endl;
  }



  void
  test_two_nodes()
  {
    FullMatrix<double> response(2, 2);
    response(0, 0) = response(1, 1) = 2.;
    response(0, 1) = response(1, 0) = 1.;
    const auto          law         = make_law(0.);
    const ContactSolver solver(*law);
    for (const std::vector<double> &free_displacement :
         {std::vector<double>{3., 3.}, std::vector<double>{2., 0.5}})
      {
        std::vector<double> pressure(2, 0.);
        solver.solve(response, free_displacement, pressure);
        deallog << "free displacement " << free_displacement[0] << ' '
                << free_displacement[1] << ": p " << pressure[0] << ' '
                << pressure[1] << std::endl;
      }
  }



  /** Largest violation of the complementarity problem. */
  double
  violation(const FullMatrix<double>  &response,
            const ContactLaw          &law,
            const std::vector<double> &free_penetration,
            const std::vector<double> &pressure)
  {
    double worst = 0.;
    for (unsigned int i = 0; i < pressure.size(); ++i)
      {
        double slack = law.penetration(pressure[i]) - free_penetration[i];
        for (unsigned int j = 0; j < pressure.size(); ++j)
          slack += response(i, j) * pressure[j];
        raise(worst, -slack);
        raise(worst, -pressure[i]);
        raise(worst, std::abs(pressure[i] * slack));
      }
    return worst;
  }



  void
  test_random_problems()
  {
    std::mt19937                           generator(1);
    std::uniform_real_distribution<double> uniform(-1., 1.);
    const unsigned int                     n = 6;

    double       worst = 0., worst_difference = 0.;
    unsigned int n_mixed = 0;
    for (unsigned int k = 0; k < 200; ++k)
      {
        FullMatrix<double> factor(n, n), response(n, n);
        for (unsigned int i = 0; i < n; ++i)
          for (unsigned int j = 0; j < n; ++j)
            factor(i, j) = uniform(generator);
        factor.Tmmult(response, factor);
        for (unsigned int j = 0; j < n; ++j)
          {
            response(j, j) += 0.01;
            const double weight = 1.5 + uniform(generator);
            for (unsigned int i = 0; i < n; ++i)
              response(i, j) *= weight;
          }
        const auto          law = make_law(k % 3 == 0 ? 0. : 0.1 * (k % 7));
        const double        gap = 0.3 * uniform(generator);
        std::vector<double> free_penetration(n);
        for (double &s : free_penetration)
          s = uniform(generator) - gap;

        const ContactSolver solver(*law);
        std::vector<double> from_open(n, 0.), from_closed(n, 1.);
        solver.solve(response, free_penetration, from_open);
        solver.solve(response, free_penetration, from_closed);
        unsigned int n_active = 0;
        for (unsigned int i = 0; i < n; ++i)
          {
            raise(worst_difference,
                  std::abs(from_open[i] - from_closed[i]) /
                    (1. + from_open[i]));
            n_active += from_open[i] > 0.;
          }
        n_mixed += n_active > 0 && n_active < n;
        raise(worst, violation(response, *law, free_penetration, from_open));
      }
    deallog << "random problems: active and inactive nodes in most "
            << (n_mixed > 100) << ", conditions hold to 1e-10 "
            << (worst < 1e-10) << ", solution is unique "
            << (worst_difference < 1e-10) << std::endl;
  }



  void
  test_cycle()
  {
    FullMatrix<double> response(3, 3);
    response(0, 0) = response(1, 1) = response(2, 2) = 1.;
    response(0, 2) = response(1, 0) = response(2, 1) = 2.;
    const auto          law                          = make_law(0.);
    const ContactSolver solver(*law);
    std::vector<double> pressure = {1., 0., 0.};
    const unsigned int  n_iterations =
      solver.solve(response, {1., 1., 1.}, pressure);
    deallog << "cycle: p " << pressure[0] << ' ' << pressure[1] << ' '
            << pressure[2] << ", by the least-index rule "
            << (n_iterations > 20) << std::endl;
  }



  void
  test_ties()
  {
    const unsigned int n = 5;
    for (const double coupling : {0., 0.3})
      {
        FullMatrix<double> response(n, n);
        for (unsigned int i = 0; i < n; ++i)
          for (unsigned int j = 0; j < n; ++j)
            response(i, j) = i == j ? 1. : coupling;
        const auto          law = make_law(0.);
        const ContactSolver solver(*law);
        // zero, but for rounding of either sign
        const std::vector<double> free_displacement = {
          0., 1.4e-17, -1.4e-17, 0., 0.};
        for (const double start : {0., 1.})
          {
            std::vector<double> pressure(n, start);
            const unsigned int  n_iterations =
              solver.solve(response, free_displacement, pressure);
            double largest = 0.;
            for (const double p : pressure)
              raise(largest, std::abs(p));
            deallog << "tie: pressure is zero " << (largest < 1e-15)
                    << ", few iterations " << (n_iterations <= n) << std::endl;
          }
      }
  }



  void
  test_held_nodes()
  {
    FullMatrix<double> response(2, 2), single(1, 1);
    response(0, 0) = response(1, 1) = 2.;
    response(0, 1) = response(1, 0) = 1.;
    single(0, 0)                    = 2.;
    const auto          law         = make_law(0.);
    const ContactSolver solver(*law);
    for (const std::vector<bool> &is_held :
         {std::vector<bool>(), std::vector<bool>{false, true}})
      for (const double start : {0., 1.})
        {
          std::vector<double> pressure(2, start);
          solver.solve(response, {1., -3.}, pressure, is_held);
          deallog << "held " << is_held.size() << ": p " << pressure[0] << ' '
                  << pressure[1] << std::endl;
        }
    for (const bool is_held : {false, true})
      {
        std::vector<double> pressure(1, 0.);
        solver.solve(single, {-3.}, pressure, {is_held});
        deallog << "alone, held " << is_held << ": p " << pressure[0]
                << std::endl;
      }
  }



  void
  test_small_changes()
  {
    FullMatrix<double> response(2, 2);
    response(0, 0) = response(1, 1) = 2.;
    response(0, 1) = response(1, 0) = 1.;
    const auto          law         = make_law(1.);
    const ContactSolver solver(*law);
    for (const std::vector<bool> &is_active : {std::vector<bool>{true, false},
                                               std::vector<bool>{true, true},
                                               std::vector<bool>{false, false}})
      {
        const std::vector<double> change =
          solver.solve_linearized(response, {7., 7.}, is_active, {3., 5.});
        deallog << "small change: dp " << change[0] << ' ' << change[1]
                << std::endl;
      }
  }

  /** What a node at @p x with pressure @p p misses the law of its stops by. */
  double
  miss_between_stops(const ContactLaw &law,
                     const double      x,
                     const double      v,
                     const double      play,
                     const double      p)
  {
    if (law.is_rigid())
      return p > 0. ? std::abs(x) :
             p < 0. ? std::abs(x + play) :
                      std::max({x, -x - play, 0.});
    const double exact =
      law.damped_pressure(x, v) - law.damped_pressure(-x - play, -v);
    // as a penetration, which a stiff stop knows better
    const double slope = std::max(1., std::abs(p));
    return std::abs(p - exact) / slope;
  }



  void
  test_two_stops()
  {
    constexpr unsigned int                 n = 6;
    std::mt19937                           generator(5);
    std::uniform_real_distribution<double> uniform(-1., 1.);
    const auto                             make_power = [](const double c) {
      return contact_law("power law").make({0.3, 2., c});
    };
    for (const auto &[name, law] :
         {std::make_pair("linear", make_law(0.1).release()),
          std::make_pair("rigid", make_law(0.).release()),
          std::make_pair("power law", make_power(0.).release()),
          std::make_pair("damped", make_power(0.5).release())})
      {
        const std::unique_ptr<const ContactLaw> owned(law);
        double                                  miss = 0., change = 0.;
        unsigned int                            n_front = 0, n_rear = 0;
        for (unsigned int k = 0; k < 200; ++k)
          {
            FullMatrix<double> A(n, n), response(n, n);
            for (unsigned int i = 0; i < n; ++i)
              for (unsigned int j = 0; j < n; ++j)
                A(i, j) = uniform(generator);
            A.Tmmult(response, A);
            std::vector<double> free(n), far(n), play(n);
            NodesInMotion       nodes;
            nodes.tau = 1.;
            for (unsigned int i = 0; i < n; ++i)
              {
                response(i, i) += 0.01;
                free[i] = 3. * uniform(generator);
                play[i] = 1.05 + 0.95 * uniform(generator);
                far[i]  = -free[i] - play[i];
                nodes.start.push_back(uniform(generator));
                nodes.far_start.push_back(-nodes.start[i] - play[i]);
                nodes.free_velocity.push_back(free[i] - nodes.start[i]);
              }
            std::vector<double> p(n, 0.), other(n);
            for (unsigned int i = 0; i < n; ++i)
              other[i] = 10. * uniform(generator);
            for (std::vector<double> *start : {&p, &other})
              if (law->damping() > 0.)
                DampedContact(*law).solve(response, nodes, *start);
              else
                ContactSolver(*law).solve(response, free, *start, {}, far);
            for (unsigned int i = 0; i < n; ++i)
              {
                double x = free[i];
                for (unsigned int j = 0; j < n; ++j)
                  x -= response(i, j) * p[j];
                raise(miss,
                      miss_between_stops(
                        *law, x, x - nodes.start[i], play[i], p[i]));
                raise(change,
                      std::abs(p[i] - other[i]) / std::max(1., std::abs(p[i])));
                n_front += p[i] > 0.;
                n_rear += p[i] < 0.;
              }
          }
        deallog << "two stops, " << name << ": nodes at both "
                << (n_front > 200 && n_rear > 200) << ", law " << (miss < 1e-10)
                << ", from another start " << (change < 1e-8) << std::endl;
        if (!(miss < 1e-10 && change < 1e-8))
          deallog << miss << ' ' << change << std::endl;
      }
  }
} // namespace



int
main()
{
  initlog();
  test_one_node();
  test_two_nodes();
  test_random_problems();
  test_cycle();
  test_ties();
  test_held_nodes();
  test_small_changes();
  test_two_stops();
}
