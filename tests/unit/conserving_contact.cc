// SPDX-License-Identifier: LGPL-2.1-or-later
//
// Pressures of steps that conserve energy, no mesh.
//
// 1. One node, 4 branches, eps > 0 and eps = 0, lengths or stiffnesses of
//    1e-100, 1, 1e100: p of the closed form is that of a bisection of
//    p - (V(s1) - V(s0))/(s1 - s0), which grows with p, to 1e-13.
// 2. Several nodes. K random, symmetric positive definite, weights w random,
//    X = K^{-1} diag(w), B = G diag(w) with G random, symmetric, positive
//    semidefinite of full or lower rank, of size 1. Whatever happens on the
//    way, the work sum w p (s1 - s0) is V(s1) - V(s0),
//      V = 1/2 eps sum w p^2 + 1/2 (X p)^T K (X p),
//    with p in equilibrium at s, to 1e-12 of the sum of the absolute values, or
//    to 1e-15/(eps + X), what the rounding of s does to p. eps from 1 to 1e-10
//    and 0, X of size 1 to 1e-10.
//    Likewise between two stops, where the pressures of the rear one are
//    negative, for one node, too; nodes go from one stop to the other.
// 3. Nodes that change together: n times the same node, coupled and uncoupled.
//    p is that of one node with the receptance of all.
// 4. Three nodes that touch, X = [1 1/4 1/4; ...], and all move on by m, 3e-16
//    of their position and more, B = 0: p = m/2 / (1 + 2/4) to rounding, also
//    where rounding hides that they move; the first update finds it, and the
//    second iteration that it is found.

#include <thermocontact/contact/conserving_contact.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <random>
#include <utility>
#include <vector>

#include "../tests.h"

using namespace ThermoContact;
using dealii::FullMatrix;

namespace
{
  FullMatrix<double>
  scalar(const double value)
  {
    FullMatrix<double> matrix(1, 1);
    matrix(0, 0) = value;
    return matrix;
  }



  double
  pressure_of_node(const double compliance,
                   const double static_receptance,
                   const double receptance,
                   const double start,
                   const double free_end)
  {
    std::vector<double> pressure(1, 0.);
    const auto          law = make_law(compliance);
    ConservingContact(*law, scalar(static_receptance))
      .step_pressure(
        {NodeLaw(*law)}, {start}, {free_end}, scalar(receptance), 0., pressure);
    return pressure[0];
  }



  /** (V(end) - V(start)) / (end - start) for V = [s]_+^2/(2e). */
  double
  mean_slope(const double e, const double start, const double end)
  {
    if (start > 0. && end > 0.)
      return 0.5 * (start / e + end / e);
    const double inside = std::max({start, end, 0.});
    return inside == 0. ? 0. :
                          0.5 * inside / e * (inside / std::abs(end - start));
  }



  double
  pressure_by_bisection(const double e,
                        const double receptance,
                        const double start,
                        const double free_end)
  {
    double low = 0., high = std::max({start, free_end, 0.}) / e;
    for (double p = 0.5 * high; p != low && p != high; p = 0.5 * (low + high))
      (p < mean_slope(e, start, free_end - 2. * receptance * p) ? low : high) =
        p;
    return 0.5 * (low + high);
  }



  void
  test_one_node()
  {
    std::mt19937                           generator(1);
    std::uniform_real_distribution<double> uniform(-1., 1.);
    double                                 largest = 0.;
    bool                                   are_all = true;
    for (const auto &[length, stiffness] :
         std::vector<std::pair<double, double>>{
           {1., 1.}, {1e-100, 1.}, {1e100, 1.}, {1., 1e-100}, {1., 1e100}})
      {
        std::array<unsigned int, 4> n_branch{};
        for (unsigned int k = 0; k < 400; ++k)
          {
            const double compliance =
              k % 3 == 0 ? 0. : std::pow(10., 5. * uniform(generator) - 5.);
            const double X = std::pow(10., 2. * uniform(generator));
            const double r =
              k % 7 == 0 ? 0. : std::pow(10., 4. * uniform(generator));
            const double start = length * uniform(generator);
            const double free_end =
              length *
              (uniform(generator) + 20. * (k % 2) * uniform(generator));
            const double p     = pressure_of_node(compliance / stiffness,
                                              X / stiffness,
                                              r / stiffness,
                                              start,
                                              free_end);
            const double exact = pressure_by_bisection(
              (compliance + X) / stiffness, r / stiffness, start, free_end);
            const double end = free_end - 2. * r / stiffness * exact;
            ++n_branch[2 * (start > 0.) + (end > 0.)];
            raise(largest, p == exact ? 0. : std::abs(p - exact) / exact);
          }
        are_all &= *std::min_element(n_branch.begin(), n_branch.end()) > 10;
      }
    deallog << "one node: all branches " << are_all << ", as bisection "
            << within(largest, 1e-13) << std::endl;
  }



  struct Problem
  {
    FullMatrix<double>  stiffness, static_receptance, receptance;
    std::vector<double> weights;
  };



  /** @p rank of B; @p scale of X. */
  Problem
  random_problem(const unsigned int n,
                 const unsigned int rank,
                 const double       scale,
                 std::mt19937      &generator)
  {
    std::uniform_real_distribution<double> uniform(-1., 1.);
    const auto gram = [&](const unsigned int n_factors) {
      FullMatrix<double> factor(n_factors, n), result(n, n);
      for (unsigned int i = 0; i < n_factors; ++i)
        for (unsigned int j = 0; j < n; ++j)
          factor(i, j) = uniform(generator);
      if (n_factors > 0)
        factor.Tmmult(result, factor);
      return result;
    };
    Problem problem;
    problem.stiffness = gram(n);
    for (unsigned int i = 0; i < n; ++i)
      {
        problem.stiffness(i, i) += 0.1;
        problem.weights.push_back(1.5 + uniform(generator));
      }
    problem.stiffness /= scale;
    problem.static_receptance = problem.stiffness;
    problem.static_receptance.gauss_jordan();
    problem.receptance = gram(rank);
    for (unsigned int j = 0; j < n; ++j)
      for (unsigned int i = 0; i < n; ++i)
        {
          problem.static_receptance(i, j) *= problem.weights[j];
          problem.receptance(i, j) *= problem.weights[j];
        }
    return problem;
  }



  /** V(s) and its pressures. */
  double
  potential(const Problem              &problem,
            const ContactLaw           &law,
            const std::vector<NodeLaw> &laws,
            const std::vector<double>  &s,
            std::vector<double>        &pressure)
  {
    const unsigned int n = s.size();
    pressure.assign(n, 0.);
    ConservingContact(law, problem.static_receptance)
      .equilibrium(laws, s, pressure);
    double value = 0.;
    for (unsigned int i = 0; i < n; ++i)
      {
        // K X = diag(w)
        double loss = 0.;
        for (unsigned int j = 0; j < n; ++j)
          loss += problem.static_receptance(i, j) * pressure[j];
        value += 0.5 * problem.weights[i] * pressure[i] *
                 (law.penetration(pressure[i]) + loss);
      }
    return value;
  }



  /** Relative defect of the work; counts nodes whose state changes. */
  double
  work_defect(const Problem    &problem,
              const ContactLaw &law,
              const double      amplitude,
              const bool        has_rear_stop,
              std::mt19937     &generator,
              unsigned int     &n_changes)
  {
    std::uniform_real_distribution<double> uniform(-1., 1.);
    const unsigned int                     n = problem.weights.size();
    std::vector<double>                    start, free_end, end, p(n, 0.);
    std::vector<NodeLaw>                   laws(n, NodeLaw(law));
    for (unsigned int i = 0; i < n; ++i)
      {
        start.push_back(amplitude * uniform(generator));
        free_end.push_back(amplitude * uniform(generator));
        if (has_rear_stop)
          laws[i].play = amplitude * (0.5 + 0.4 * uniform(generator));
      }
    ConservingContact contact(law, problem.static_receptance);
    contact.step_pressure(laws, start, free_end, problem.receptance, 0., p);
    end         = free_end;
    double work = 0., scale = 0.;
    for (unsigned int i = 0; i < n; ++i)
      {
        for (unsigned int j = 0; j < n; ++j)
          end[i] -= 2. * problem.receptance(i, j) * p[j];
        const double term = problem.weights[i] * p[i] * (end[i] - start[i]);
        work += term;
        scale += std::abs(term);
      }
    std::vector<double> p_start, p_end;
    const double        V_start = potential(problem, law, laws, start, p_start);
    const double        V_end   = potential(problem, law, laws, end, p_end);
    for (unsigned int i = 0; i < n; ++i)
      n_changes += has_rear_stop ? p_start[i] * p_end[i] < 0. :
                                   (p_start[i] > 0.) != (p_end[i] > 0.);
    scale += V_start + V_end;
    return scale == 0. ? std::abs(work) :
                         std::abs(V_end - V_start - work) / scale;
  }



  void
  test_work(const bool has_rear_stop)
  {
    double       largest = 0.; // in its bound
    unsigned int fewest  = 1000;
    for (const double compliance : {1., 1e-2, 1e-5, 1e-10, 0.})
      for (const double scale : {1., 1e-4, 1e-10})
        {
          std::mt19937 generator(2);
          unsigned int n_changes = 0;
          for (unsigned int k = 0; k < 60; ++k)
            {
              const unsigned int n = (has_rear_stop ? 1 : 2) + k % 5;
              const Problem      problem =
                random_problem(n, std::min(n, k % 7), scale, generator);
              raise(largest,
                    work_defect(problem,
                                *make_law(compliance),
                                k % 3 ? 1. : 1e-3,
                                has_rear_stop,
                                generator,
                                n_changes) /
                      std::max(1e-12, 1e-15 / (compliance + scale)));
            }
          fewest = std::min(fewest, n_changes);
        }
    deallog << (has_rear_stop ? "two stops" : "one obstacle")
            << ": many nodes change " << (fewest > (has_rear_stop ? 20 : 60))
            << ", work " << noise_within(largest, 1.) << std::endl;
  }



  void
  test_together()
  {
    double       largest      = 0.;
    unsigned int n_iterations = 0;
    for (const double coupling : {0., 0.3})
      for (const double noise : {0., 1e-16})
        for (const double compliance : {0., 0.1})
          for (const double start : {-1., 0., 1.})
            for (const double free_end : {-1., 0.7, 2.})
              {
                const unsigned int n = 12;
                FullMatrix<double> X(n, n), B(n, n);
                for (unsigned int i = 0; i < n; ++i)
                  for (unsigned int j = 0; j < n; ++j)
                    {
                      X(i, j) = i == j ? 1. : coupling;
                      B(i, j) = 0.5 * X(i, j) + coupling;
                    }
                const double factor = 1. + (n - 1) * coupling;
                const double exact =
                  pressure_of_node(compliance,
                                   factor,
                                   0.5 * factor + n * coupling,
                                   start,
                                   free_end);
                std::vector<double> starts, free_ends, p(n, 0.);
                for (unsigned int i = 0; i < n; ++i)
                  {
                    starts.push_back(start + noise * (i % 3));
                    free_ends.push_back(free_end * (1. + noise * (i % 4)));
                  }
                const auto law = make_law(compliance);
                n_iterations =
                  std::max(n_iterations,
                           ConservingContact(*law, X).step_pressure(
                             std::vector<NodeLaw>(n, NodeLaw(*law)),
                             starts,
                             free_ends,
                             B,
                             0.,
                             p));
                for (const double value : p)
                  raise(largest, std::abs(value - exact));
              }
    deallog << "nodes that change together: as one " << within(largest, 1e-12)
            << ", few iterations " << (n_iterations < 10) << std::endl;
  }



  void
  test_touch()
  {
    FullMatrix<double> X(3, 3);
    for (unsigned int i = 0; i < 3; ++i)
      for (unsigned int j = 0; j < 3; ++j)
        X(i, j) = i == j ? 1. : 0.25;
    const auto                 law = make_law(0.);
    ConservingContact          contact(*law, X);
    const std::vector<NodeLaw> laws(3, NodeLaw(*law));
    for (const double motion : {3e-16, 1e-14, 1e-12, 1e-8})
      {
        // without feedback: the ends are the free ends
        const FullMatrix<double>  no_receptance(3, 3);
        const std::vector<double> start(3, 0.), end(3, (1. + motion) - 1.);
        std::vector<double>       p(3, 0.);
        const unsigned int        n =
          contact.step_pressure(laws, start, end, no_receptance, 1., p);
        double largest = 0.;
        for (const double value : p)
          raise(largest, std::abs(value - 0.5 * motion / 1.5));
        deallog << "motion " << motion << " at the obstacle: to rounding "
                << within(largest, 1e-14) << ", iterations " << n << std::endl;
      }
  }
} // namespace



void
main_conserving_contact()
{
  initlog();
  test_one_node();
  test_together();
  test_touch();
  test_work(false);
  test_work(true);
}
