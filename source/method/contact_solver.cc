// SPDX-License-Identifier: LGPL-2.1-or-later

#include <thermocontact/base/exceptions.h>
#include <thermocontact/method/contact_solver.h>
#include <thermocontact/method/nodal_contact.h>

#include <deal.II/lac/vector.h>

#include <algorithm>
#include <cmath>
#include <utility>

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
    /** The same law at all nodes, as a function of the penetration. */
    class LawOfPenetrations : public NodalLaws
    {
    public:
      LawOfPenetrations(const ContactLaw &law, const std::vector<bool> &is_held)
        : law(law)
        , is_held(is_held)
      {}

      double
      pressure(const unsigned int i, const double penetration) const override
      {
        return is_held[i] && penetration < 0. ? -law.pressure(-penetration) :
                                                law.pressure(penetration);
      }

      double
      stiffness(const unsigned int,
                const double,
                const double pressure) const override
      {
        return 1. / law.tangent(pressure);
      }

      double
      local_pressure(const unsigned int i,
                     const double       free_penetration,
                     const double       receptance) const override
      {
        return is_held[i] ?
                 law.local_closed_pressure(free_penetration, receptance) :
                 law.local_pressure(free_penetration, receptance);
      }

      double
      position(const unsigned int,
               const double free_penetration,
               const double,
               const double pressure) const override
      {
        return pressure != 0. ? law.penetration(pressure) : free_penetration;
      }

    private:
      const ContactLaw        &law;
      const std::vector<bool> &is_held;
    };
  } // namespace



  unsigned int
  ContactSolver::solve_for_penetrations(
    const dealii::FullMatrix<double> &response,
    const std::vector<double>        &free_penetration,
    const std::vector<bool>          &is_held,
    std::vector<double>              &pressure) const
  {
    std::vector<double> penetration;
    for (unsigned int i = 0; i < pressure.size(); ++i)
      penetration.push_back(pressure[i] != 0. ? law.penetration(pressure[i]) :
                                                free_penetration[i] -
                                                  loss(response, pressure, i));
    return solve_nodal_contact(LawOfPenetrations(law, is_held),
                               response,
                               free_penetration,
                               std::move(penetration),
                               pressure);
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
