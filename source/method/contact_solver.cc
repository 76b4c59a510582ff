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



  std::vector<double>
  ContactSolver::free_of_set(const Problem           &problem,
                             const std::vector<bool> &is_far) const
  {
    std::vector<double> free(problem.free_penetration);
    for (unsigned int i = 0; i < free.size(); ++i)
      if (is_far[i])
        free[i] = -problem.far_penetration[i];
    return free;
  }



  bool
  ContactSolver::update_active_set(const Problem             &problem,
                                   const std::vector<double> &pressure,
                                   const bool                 only_the_first,
                                   std::vector<bool>         &is_active,
                                   std::vector<bool>         &is_far) const
  {
    // A node that touches without pressure must not flip for ever.
    const double rounding = 1e-14 * largest_size(problem.free_penetration);
    bool         changed  = false;
    for (unsigned int i = 0;
         i < pressure.size() && !(changed && only_the_first);
         ++i)
      {
        const double p          = is_far[i] ? -pressure[i] : pressure[i];
        const double receptance = problem.response(i, i) + law.tangent(p);
        const double by_all     = loss(problem.response, pressure, i);
        const double reach      = problem.free_penetration[i] - by_all;
        const double far_reach  = problem.far_penetration.empty() ?
                                    -1. :
                                    problem.far_penetration[i] + by_all;
        const bool   is_beyond  = reach > rounding;
        const bool   is_wrong =
          is_active[i] ? p * receptance < -rounding && !problem.is_held[i] :
                           is_beyond || far_reach > rounding;
        // Newton's method goes on until the law is met
        const bool is_inexact =
          !law.is_linear() && is_active[i] != is_wrong &&
          !(std::abs((is_far[i] ? far_reach : reach) - law.penetration(p)) <=
            10. * rounding);
        if (is_wrong)
          {
            is_active[i] = !is_active[i];
            is_far[i]    = is_active[i] && !is_beyond;
          }
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
      /** @param width between two stops; empty: there is one */
      LawOfPenetrations(const ContactLaw          &law,
                        const std::vector<bool>   &is_held,
                        const std::vector<double> &width)
        : law(law)
        , is_held(is_held)
        , width(width)
      {}

      double
      pressure(const unsigned int i, const double penetration) const override
      {
        return penetration > 0. ? law.pressure(penetration) :
               is_held[i]       ? -law.pressure(-penetration) :
                                  0. - law.pressure(beyond(i, penetration));
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
               free_penetration > 0. ?
                 law.local_pressure(free_penetration, receptance) :
                 0. -
                   law.local_pressure(beyond(i, free_penetration), receptance);
      }

      double
      position(const unsigned int i,
               const double       free_penetration,
               const double,
               const double pressure) const override
      {
        return pressure == 0. ? free_penetration :
               pressure < 0. && !is_held[i] && !width.empty() ?
                                law.penetration(pressure) - width[i] :
                                law.penetration(pressure);
      }

    private:
      const ContactLaw          &law;
      const std::vector<bool>   &is_held;
      const std::vector<double> &width;

      /** The penetration at the second stop. */
      double
      beyond(const unsigned int i, const double penetration) const
      {
        return width.empty() ? -1. : -penetration - width[i];
      }
    };
  } // namespace



  unsigned int
  ContactSolver::solve_for_penetrations(const Problem       &problem,
                                        std::vector<double> &pressure) const
  {
    const unsigned int  n = pressure.size();
    std::vector<double> width(problem.far_penetration), penetration;
    for (unsigned int i = 0; i < width.size(); ++i)
      width[i] = -width[i] - problem.free_penetration[i];
    const LawOfPenetrations laws(law, problem.is_held, width);
    for (unsigned int i = 0; i < n; ++i)
      penetration.push_back(laws.position(i,
                                          problem.free_penetration[i] -
                                            loss(problem.response, pressure, i),
                                          0.,
                                          pressure[i]));
    return solve_nodal_contact(laws,
                               problem.response,
                               problem.free_penetration,
                               std::move(penetration),
                               pressure);
  }



  double
  ContactSolver::pressure_of_node(const Problem &problem) const
  {
    const double free       = problem.free_penetration[0];
    const double receptance = problem.response(0, 0);
    if (!problem.is_held.empty() && problem.is_held[0])
      return law.local_closed_pressure(free, receptance);
    return free > 0. || problem.far_penetration.empty() ?
             law.local_pressure(free, receptance) :
             0. - law.local_pressure(problem.far_penetration[0], receptance);
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
      return solve_for_penetrations({response, free_penetration, {}, all},
                                    pressure);
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
                       const std::vector<bool>          &is_held,
                       const std::vector<double>        &far_penetration) const
  {
    const unsigned int n = free_penetration.size();
    if (!law.is_active())
      {
        std::fill(pressure.begin(), pressure.end(), 0.);
        return 0;
      }
    if (n == 1)
      {
        pressure[0] = pressure_of_node(
          {response, free_penetration, far_penetration, is_held});
        return 1;
      }

    std::vector<bool> held(is_held);
    held.resize(n, false);
    const Problem problem{response, free_penetration, far_penetration, held};
    if (begins_without_stiffness())
      return solve_for_penetrations(problem, pressure);

    // Murty's rule needs at most 2^n changes in theory and about n in
    // practice; a body that needs this many has lost its P-matrix to rounding.
    const unsigned int max_block_iterations  = 20;
    const unsigned int max_single_iterations = 100 * n;

    std::vector<bool> is_active(n), is_far(n);
    for (unsigned int i = 0; i < n; ++i)
      {
        is_far[i]    = !held[i] && !far_penetration.empty() && pressure[i] < 0.;
        is_active[i] = held[i] || is_far[i] || pressure[i] > 0.;
      }
    for (unsigned int iteration = 1;
         iteration <= max_block_iterations + max_single_iterations;
         ++iteration)
      {
        solve_on_active_set(response,
                            free_of_set(problem, is_far),
                            is_active,
                            pressure);
        if (!update_active_set(problem,
                               pressure,
                               iteration > max_block_iterations,
                               is_active,
                               is_far))
          {
            for (unsigned int i = 0; i < n; ++i)
              if (!held[i])
                pressure[i] = is_far[i] ? std::min(pressure[i], 0.) :
                                          std::max(pressure[i], 0.);
            return iteration;
          }
      }
    throw ComputationError(
      "the active set of " + std::to_string(n) +
      " contact nodes did not settle\n  remedy:  a larger Contact/Compliance "
      "or a smaller Time/Step size");
  }
} // namespace ThermoContact
