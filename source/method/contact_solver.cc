// SPDX-License-Identifier: LGPL-2.1-or-later

#include <thermocontact/base/exceptions.h>
#include <thermocontact/method/contact_solver.h>

#include <deal.II/lac/vector.h>

#include <algorithm>
#include <cmath>

namespace ThermoContact
{
  ContactSolver::ContactSolver(const ContactLaw &law)
    : law(law)
  {}



  void
  ContactSolver::solve_on_active_set(
    const dealii::FullMatrix<double> &response,
    const std::vector<double>        &free_displacement,
    const std::vector<bool>          &is_active,
    std::vector<double>              &pressure) const
  {
    std::vector<unsigned int> active;
    for (unsigned int i = 0; i < is_active.size(); ++i)
      if (is_active[i])
        active.push_back(i);

    std::fill(pressure.begin(), pressure.end(), 0.);
    if (active.empty())
      return;

    const unsigned int         n = active.size();
    dealii::FullMatrix<double> matrix(n, n);
    dealii::Vector<double>     rhs(n), solution(n);
    for (unsigned int i = 0; i < n; ++i)
      {
        for (unsigned int j = 0; j < n; ++j)
          matrix(i, j) = response(active[i], active[j]);
        matrix(i, i) += law.compliance;
        rhs(i) = free_displacement[active[i]] - law.gap;
      }
    matrix.gauss_jordan();
    matrix.vmult(solution, rhs);
    for (unsigned int i = 0; i < n; ++i)
      pressure[active[i]] = solution(i);
  }



  void
  ContactSolver::solve_closed(const dealii::FullMatrix<double> &response,
                              const std::vector<double> &free_displacement,
                              std::vector<double>       &pressure) const
  {
    const unsigned int n = free_displacement.size();
    pressure.resize(n);
    if (n == 1)
      pressure[0] =
        (free_displacement[0] - law.gap) / (law.compliance + response(0, 0));
    else
      solve_on_active_set(response,
                          free_displacement,
                          std::vector<bool>(n, true),
                          pressure);
  }



  unsigned int
  ContactSolver::solve(const dealii::FullMatrix<double> &response,
                       const std::vector<double>        &free_displacement,
                       std::vector<double>              &pressure) const
  {
    const unsigned int n = free_displacement.size();
    if (!law.is_active)
      {
        std::fill(pressure.begin(), pressure.end(), 0.);
        return 0;
      }
    if (n == 1)
      {
        pressure[0] = law.pressure(free_displacement[0], response(0, 0));
        return 1;
      }

    // Murty's rule needs at most 2^n changes in theory and about n in
    // practice; a body that needs this many has lost its P-matrix to rounding.
    const unsigned int max_block_iterations  = 20;
    const unsigned int max_single_iterations = 100 * n;

    // A node that touches without pressure must not flip for ever.
    double largest = std::abs(law.gap);
    for (const double u : free_displacement)
      largest = std::max(largest, std::abs(u));
    const double rounding = 1e-14 * largest;

    std::vector<bool> is_active(n);
    for (unsigned int i = 0; i < n; ++i)
      is_active[i] = pressure[i] > 0.;

    for (unsigned int iteration = 1;
         iteration <= max_block_iterations + max_single_iterations;
         ++iteration)
      {
        solve_on_active_set(response, free_displacement, is_active, pressure);

        const bool only_the_first = iteration > max_block_iterations;
        bool       changed        = false;
        for (unsigned int i = 0; i < n && !(changed && only_the_first); ++i)
          {
            double reach = free_displacement[i];
            for (unsigned int j = 0; j < n; ++j)
              reach -= response(i, j) * pressure[j];
            const double receptance = response(i, i) + law.compliance;
            const bool   is_wrong   = is_active[i] ?
                                        pressure[i] * receptance < -rounding :
                                        reach - law.gap > rounding;
            if (is_wrong)
              {
                is_active[i] = !is_active[i];
                changed      = true;
              }
          }
        if (!changed)
          {
            for (double &p : pressure)
              p = std::max(p, 0.);
            return iteration;
          }
      }
    throw ComputationError(
      "the active set of " + std::to_string(n) +
      " contact nodes did not settle\n  remedy:  a larger Contact/Compliance "
      "or a smaller Time/Step size");
  }
} // namespace ThermoContact
