// SPDX-License-Identifier: LGPL-2.1-or-later

#include <thermocontact/base/exceptions.h>
#include <thermocontact/base/tolerances.h>
#include <thermocontact/contact/exchange_solver.h>
#include <thermocontact/method/bracketed_root.h>

#include <deal.II/lac/vector.h>

#include <algorithm>
#include <cmath>

namespace ThermoContact
{
  namespace
  {
    using dealii::FullMatrix;
    using Values = ExchangeStage::Values;

    constexpr unsigned int max_sweeps = 60;



    [[noreturn]] void
    give_up(const unsigned int n)
    {
      throw ComputationError(
        "the heat exchange coefficients of " + std::to_string(n) +
        " contact nodes were not found\n  remedy:  a smaller Time/Step size, "
        "or a Boundary/Heat exchange without jumps");
    }



    /** The root of node @p i, next to its @p k in the direction of the law. */
    double
    solve_node(ExchangeStage &end, Values k, const unsigned int i)
    {
      // Pressures are found from those that are nearby, up to rounding, and
      // where the law jumps with the pressure its sign counts: from the same
      // ones, each coefficient always has the same excess.
      const Values nearby(end.pressure);
      const auto   excess = [&](const double x) {
        k[i]         = x;
        end.pressure = nearby;
        return x - end.law_at(k)[i];
      };
      double a = k[i], excess_a = excess(a);
      if (excess_a == 0.)
        return a;
      double stride = -excess_a;
      for (unsigned int n = 0; n < 200; ++n, stride *= 2.)
        {
          // not positive at 0, and the law is bounded
          const double b        = std::max(0., a + stride);
          const double excess_b = excess(b);
          if (excess_b == 0.)
            return b;
          if ((excess_a < 0.) != (excess_b < 0.))
            return a < b ?
                     bracketed_root(excess, a, b, excess_a, excess_b).first :
                     bracketed_root(excess, b, a, excess_b, excess_a).first;
          a        = b;
          excess_a = excess_b;
        }
      give_up(end.n);
    }



    /** Largest difference of @p k to the law, relative to both. */
    double
    defect(const Values &k, const Values &law)
    {
      double largest = 0.;
      for (unsigned int i = 0; i < k.size(); ++i)
        if (k[i] != law[i])
          largest =
            std::max(largest, std::abs(k[i] - law[i]) / std::max(k[i], law[i]));
      return largest;
    }



    /** Newton's method with damping; true if it converged. */
    bool
    solve_smooth(ExchangeStage &end, Values &k)
    {
      const unsigned int n   = end.n;
      Values             law = end.law_at(k);
      for (unsigned int iteration = 0; iteration < 30; ++iteration)
        {
          const double old_defect = defect(k, law);
          if (old_defect <= Tolerances::rounding)
            return true;
          FullMatrix<double> matrix = end.derivative();
          matrix *= -1.;
          dealii::Vector<double> rhs(n), step(n);
          for (unsigned int i = 0; i < n; ++i)
            {
              matrix(i, i) += 1.;
              rhs(i) = law[i] - k[i];
            }
          matrix.gauss_jordan();
          matrix.vmult(step, rhs);

          Values trial(n), law_there;
          double damping = 1., new_defect = old_defect;
          for (; damping > Tolerances::shortest_newton_step; damping *= 0.5)
            {
              for (unsigned int i = 0; i < n; ++i)
                trial[i] = std::max(0., k[i] + damping * step(i));
              law_there  = end.law_at(trial);
              new_defect = defect(trial, law_there);
              if (new_defect < old_defect)
                break;
            }
          if (!(new_defect < old_defect))
            // the rounding of a steep law
            return old_defect <= Tolerances::rounding_of_data;
          k   = trial;
          law = law_there;
        }
      return defect(k, law) <= Tolerances::rounding_of_data;
    }



    /**
     * Where Newton's method stalls, as where laws jump, one node after another
     * meets its law, and Newton's method again; true if it converged.
     */
    bool
    solve_by_sweeps(ExchangeStage &end, Values &k)
    {
      for (unsigned int sweep = 1; sweep <= max_sweeps; ++sweep)
        {
          const Values last(k);
          for (unsigned int i = 0; i < end.n; ++i)
            k[i] = solve_node(end, k, i);
          if (defect(k, last) <= Tolerances::rounding_of_sum)
            return true;
          Values trial(k);
          if (solve_smooth(end, trial))
            {
              k = trial;
              return true;
            }
        }
      return false;
    }
  } // namespace



  ExchangeSolver::ExchangeSolver(const HeatExchange &exchange)
    : exchange(exchange)
  {}



  unsigned int
  ExchangeSolver::solve(const EndResponse          &response,
                        const std::vector<NodeLaw> &laws,
                        EndExchange                &end) const
  {
    ExchangeStage stage(exchange, response, laws, end.pressure);
    if (stage.n == 1)
      end.coefficient[0] = solve_node(stage, end.coefficient, 0);
    else if (!solve_smooth(stage, end.coefficient) &&
             !solve_by_sweeps(stage, end.coefficient))
      give_up(stage.n);
    stage.law_at(end.coefficient);
    end.pressure = stage.pressure;
    end.flux     = stage.flux;
    return stage.n_iterations;
  }
} // namespace ThermoContact
