// SPDX-License-Identifier: LGPL-2.1-or-later

#include <thermocontact/base/exceptions.h>
#include <thermocontact/method/contact_solver.h>

#include <deal.II/lac/vector.h>

#include <algorithm>
#include <cmath>

namespace ThermoContact
{
  namespace
  {
    /** Loss of displacement of node @p i under all pressures. */
    double
    loss(const dealii::FullMatrix<double> &response,
         const std::vector<double>        &pressure,
         const unsigned int                i)
    {
      double sum = 0.;
      for (unsigned int j = 0; j < pressure.size(); ++j)
        sum += response(i, j) * pressure[j];
      return sum;
    }



    double
    largest_size(const std::vector<double> &values)
    {
      double largest = 0.;
      for (const double value : values)
        largest = std::max(largest, std::abs(value));
      return largest;
    }
  } // namespace



  ContactSolver::ContactSolver(const ContactLaw &law)
    : law(law)
  {}



  void
  ContactSolver::solve_on_active_set(
    const dealii::FullMatrix<double> &response,
    const std::vector<double>        &free_penetration,
    const std::vector<bool>          &is_active,
    std::vector<double>              &pressure) const
  {
    std::vector<double> rhs(free_penetration);
    if (!law.is_linear()) // s(p) = s'(p) p + offset
      for (unsigned int i = 0; i < rhs.size(); ++i)
        rhs[i] -=
          law.penetration(pressure[i]) - law.tangent(pressure[i]) * pressure[i];
    pressure = solve_linearized(response, pressure, is_active, rhs);
  }



  std::vector<double>
  ContactSolver::solve_linearized(const dealii::FullMatrix<double> &response,
                                  const std::vector<double>        &pressure,
                                  const std::vector<bool>          &is_active,
                                  const std::vector<double> &free_change) const
  {
    std::vector<double>       change(pressure.size(), 0.);
    std::vector<unsigned int> active;
    for (unsigned int i = 0; i < is_active.size(); ++i)
      if (is_active[i] && std::isfinite(law.tangent(pressure[i])))
        active.push_back(i);
    if (active.empty())
      return change;

    const unsigned int         n = active.size();
    dealii::FullMatrix<double> matrix(n, n);
    dealii::Vector<double>     rhs(n), solution(n);
    for (unsigned int i = 0; i < n; ++i)
      {
        for (unsigned int j = 0; j < n; ++j)
          matrix(i, j) = response(active[i], active[j]);
        matrix(i, i) += law.tangent(pressure[active[i]]);
        rhs(i) = free_change[active[i]];
      }
    matrix.gauss_jordan();
    matrix.vmult(solution, rhs);
    for (unsigned int i = 0; i < n; ++i)
      change[active[i]] = solution(i);
    return change;
  }



  bool
  ContactSolver::update_active_set(const dealii::FullMatrix<double> &response,
                                   const std::vector<double> &free_penetration,
                                   const std::vector<double> &pressure,
                                   const std::vector<bool>   &is_held,
                                   const bool                 only_the_first,
                                   std::vector<bool>         &is_active) const
  {
    // A node that touches without pressure must not flip for ever.
    const double rounding = 1e-14 * largest_size(free_penetration);
    bool         changed  = false;
    for (unsigned int i = 0;
         i < pressure.size() && !(changed && only_the_first);
         ++i)
      {
        const double p          = pressure[i];
        const double receptance = response(i, i) + law.tangent(p);
        const double reach = free_penetration[i] - loss(response, pressure, i);
        const bool   is_wrong = is_active[i] ?
                                  p * receptance < -rounding && !is_held[i] :
                                  reach > rounding;
        if (is_wrong)
          is_active[i] = !is_active[i];
        // Newton's method goes on until the law is met
        const bool is_inexact =
          !law.is_linear() && is_active[i] &&
          !(std::abs(reach - law.penetration(p)) <= 10. * rounding);
        changed |= is_wrong || is_inexact;
      }
    return changed;
  }



  bool
  ContactSolver::begins_without_stiffness() const
  {
    return !law.is_linear() && std::isinf(law.tangent(0.));
  }



  namespace
  {
    /** The nodes of (M.70): penetrations of either sign, and pressures. */
    struct Penetrations
    {
      std::vector<double> penetration, pressure, defect;
      double              largest_defect = 0.;
      double              scale          = 0.; ///< of what a defect consists
    };



    double
    pressure_at(const ContactLaw &law,
                const double      penetration,
                const bool        is_held)
    {
      return is_held && penetration < 0. ? -law.pressure(-penetration) :
                                           law.pressure(penetration);
    }



    /** Pressures and defects of penetrations. */
    void
    evaluate(const ContactLaw                 &law,
             const dealii::FullMatrix<double> &response,
             const std::vector<double>        &free_penetration,
             const std::vector<bool>          &is_held,
             Penetrations                     &nodes)
    {
      const unsigned int n = nodes.penetration.size();
      nodes.pressure.resize(n);
      nodes.defect.resize(n);
      for (unsigned int i = 0; i < n; ++i)
        nodes.pressure[i] = pressure_at(law, nodes.penetration[i], is_held[i]);
      nodes.largest_defect = nodes.scale = 0.;
      for (unsigned int i = 0; i < n; ++i)
        {
          const double by_pressure = loss(response, nodes.pressure, i);
          nodes.defect[i] =
            nodes.penetration[i] + by_pressure - free_penetration[i];
          // a NaN is no small defect
          nodes.largest_defect =
            std::abs(nodes.defect[i]) <= nodes.largest_defect ?
              nodes.largest_defect :
              std::abs(nodes.defect[i]);
          nodes.scale = std::max({nodes.scale,
                                  std::abs(free_penetration[i]),
                                  std::abs(nodes.penetration[i]),
                                  std::abs(by_pressure)});
        }
    }



    /** A step of Newton's method in the penetrations. */
    std::vector<double>
    newton_step(const ContactLaw                 &law,
                const dealii::FullMatrix<double> &response,
                const Penetrations               &nodes)
    {
      const unsigned int         n = nodes.penetration.size();
      dealii::FullMatrix<double> matrix(response);
      dealii::Vector<double>     rhs(n), change(n);
      std::vector<double>        scale(n);
      for (unsigned int j = 0; j < n; ++j)
        {
          // columns of stiff nodes are larger by any factor: their diagonal is
          // made 1
          const double stiffness = 1. / law.tangent(nodes.pressure[j]);
          scale[j]               = 1. + stiffness * response(j, j);
          for (unsigned int i = 0; i < n; ++i)
            matrix(i, j) *= stiffness / scale[j];
          matrix(j, j) = 1.;
          rhs(j)       = nodes.defect[j];
        }
      matrix.gauss_jordan();
      matrix.vmult(change, rhs);
      std::vector<double> penetration(nodes.penetration);
      for (unsigned int i = 0; i < n; ++i)
        penetration[i] -= change(i) / scale[i];
      return penetration;
    }



    /** One node after another meets the law, by (M.17). */
    void
    sweep(const ContactLaw                 &law,
          const dealii::FullMatrix<double> &response,
          const std::vector<double>        &free_penetration,
          const std::vector<bool>          &is_held,
          Penetrations                     &nodes)
    {
      std::vector<double> &p = nodes.pressure;
      for (unsigned int i = 0; i < p.size(); ++i)
        {
          const double reach =
            free_penetration[i] - loss(response, p, i) + response(i, i) * p[i];
          p[i] = is_held[i] ? law.local_closed_pressure(reach, response(i, i)) :
                              law.local_pressure(reach, response(i, i));
          nodes.penetration[i] = p[i] != 0. ? law.penetration(p[i]) : reach;
        }
    }
  } // namespace



  unsigned int
  ContactSolver::solve_for_penetrations(
    const dealii::FullMatrix<double> &response,
    const std::vector<double>        &free_penetration,
    const std::vector<bool>          &is_held,
    std::vector<double>              &pressure) const
  {
    constexpr unsigned int max_iterations = 1000;
    constexpr double       smallest_part  = 1e-6; // of a step
    const unsigned int     n              = pressure.size();
    Penetrations           nodes;
    for (unsigned int i = 0; i < n; ++i)
      nodes.penetration.push_back(
        pressure[i] != 0. ? law.penetration(pressure[i]) :
                            free_penetration[i] - loss(response, pressure, i));
    const auto evaluate_nodes = [&](Penetrations &at) {
      evaluate(law, response, free_penetration, is_held, at);
    };
    evaluate_nodes(nodes);
    for (unsigned int iteration = 1; iteration <= max_iterations; ++iteration)
      {
        const std::vector<double> aim = newton_step(law, response, nodes);
        Penetrations              trial(nodes);
        bool                      is_better = false;
        for (double part = 1.; part > smallest_part && !is_better; part *= 0.5)
          {
            for (unsigned int i = 0; i < n; ++i)
              trial.penetration[i] =
                part * aim[i] + (1. - part) * nodes.penetration[i];
            evaluate_nodes(trial);
            is_better = trial.largest_defect < nodes.largest_defect;
          }
        if (is_better)
          nodes = trial;
        if (nodes.largest_defect <= (is_better ? 1e-15 : 1e-13) * nodes.scale)
          {
            pressure = nodes.pressure;
            return iteration;
          }
        if (!is_better)
          {
            sweep(law, response, free_penetration, is_held, nodes);
            evaluate_nodes(nodes);
          }
      }
    throw ComputationError("the pressures of " + std::to_string(n) +
                           " contact nodes were not found\n  remedy:  a "
                           "smaller Time/Step size");
  }



  unsigned int
  ContactSolver::solve_closed(const dealii::FullMatrix<double> &response,
                              const std::vector<double> &free_penetration,
                              std::vector<double>       &pressure) const
  {
    const unsigned int n = free_penetration.size();
    pressure.resize(n, 0.);
    if (n == 1)
      {
        pressure[0] =
          law.local_closed_pressure(free_penetration[0], response(0, 0));
        return 1;
      }
    const std::vector<bool> all(n, true);
    if (begins_without_stiffness())
      return solve_for_penetrations(response, free_penetration, all, pressure);
    const double rounding = 1e-13 * largest_size(free_penetration);
    for (unsigned int iteration = 1; iteration <= 50; ++iteration)
      {
        solve_on_active_set(response, free_penetration, all, pressure);
        if (law.is_linear())
          return iteration;
        bool is_solution = true; // a residual that is NaN is none
        for (unsigned int i = 0; i < n; ++i)
          is_solution &=
            std::abs(free_penetration[i] - loss(response, pressure, i) -
                     law.penetration(pressure[i])) <= rounding;
        if (is_solution)
          return iteration;
      }
    throw ComputationError("the pressures of " + std::to_string(n) +
                           " contact nodes that are held closed were not "
                           "found\n  remedy:  a smaller Time/Step size");
  }



  unsigned int
  ContactSolver::solve(const dealii::FullMatrix<double> &response,
                       const std::vector<double>        &free_penetration,
                       std::vector<double>              &pressure,
                       const std::vector<bool>          &is_held) const
  {
    const unsigned int n = free_penetration.size();
    if (!law.is_active())
      {
        std::fill(pressure.begin(), pressure.end(), 0.);
        return 0;
      }
    if (n == 1)
      {
        pressure[0] =
          !is_held.empty() && is_held[0] ?
            law.local_closed_pressure(free_penetration[0], response(0, 0)) :
            law.local_pressure(free_penetration[0], response(0, 0));
        return 1;
      }

    std::vector<bool> held(is_held);
    held.resize(n, false);
    if (begins_without_stiffness())
      return solve_for_penetrations(response, free_penetration, held, pressure);

    // Murty's rule needs at most 2^n changes in theory and about n in
    // practice; a body that needs this many has lost its P-matrix to rounding.
    const unsigned int max_block_iterations  = 20;
    const unsigned int max_single_iterations = 100 * n;

    std::vector<bool> is_active(n);
    for (unsigned int i = 0; i < n; ++i)
      is_active[i] = held[i] || pressure[i] > 0.;
    for (unsigned int iteration = 1;
         iteration <= max_block_iterations + max_single_iterations;
         ++iteration)
      {
        solve_on_active_set(response, free_penetration, is_active, pressure);
        if (!update_active_set(response,
                               free_penetration,
                               pressure,
                               held,
                               iteration > max_block_iterations,
                               is_active))
          {
            for (unsigned int i = 0; i < n; ++i)
              if (!held[i])
                pressure[i] = std::max(pressure[i], 0.);
            return iteration;
          }
      }
    throw ComputationError(
      "the active set of " + std::to_string(n) +
      " contact nodes did not settle\n  remedy:  a larger Contact/Compliance "
      "or a smaller Time/Step size");
  }
} // namespace ThermoContact
