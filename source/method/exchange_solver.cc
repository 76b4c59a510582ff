// SPDX-License-Identifier: LGPL-2.1-or-later

#include <thermocontact/base/exceptions.h>
#include <thermocontact/method/bracketed_root.h>
#include <thermocontact/method/exchange_solver.h>

#include <deal.II/lac/vector.h>

#include <algorithm>
#include <cmath>

namespace ThermoContact
{
  namespace
  {
    using dealii::FullMatrix;
    using Values = ExchangeStage::Values;



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
          if (old_defect <= 1e-15)
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
          for (; damping > 1e-3; damping *= 0.5)
            {
              for (unsigned int i = 0; i < n; ++i)
                trial[i] = std::max(0., k[i] + damping * step(i));
              law_there  = end.law_at(trial);
              new_defect = defect(trial, law_there);
              if (new_defect < old_defect)
                break;
            }
          if (!(new_defect < old_defect))
            return old_defect <= 1e-12; // the rounding of a steep law
          k   = trial;
          law = law_there;
        }
      return defect(k, law) <= 1e-12;
    }



    /** Bisection of $k/(1+k)$ of all nodes at once; true if it converged. */
    bool
    bisect(ExchangeStage &end, Values &k)
    {
      const unsigned int n = end.n;
      Values             low(n, 0.), high(n, 1.);
      const auto         coefficients = [](Values parts) {
        for (double &c : parts)
          c = c < 1. ? c / (1. - c) : 1e300;
        return parts;
      };
      for (unsigned int iteration = 0; iteration < 60; ++iteration)
        {
          Values middle(n);
          for (unsigned int i = 0; i < n; ++i)
            middle[i] = 0.5 * (low[i] + high[i]);
          k                = coefficients(middle);
          const Values law = end.law_at(k);
          for (unsigned int i = 0; i < n; ++i)
            (k[i] < law[i] ? low : high)[i] = middle[i];
        }
      // each node crosses the law there, whatever the others have done since
      const Values below = coefficients(low), above = coefficients(high);
      const Values law_below = end.law_at(below), law_above = end.law_at(above);
      bool         is_solution = true;
      for (unsigned int i = 0; i < n; ++i)
        is_solution &= below[i] <= (1. + 1e-12) * law_below[i] &&
                       above[i] >= (1. - 1e-12) * law_above[i];
      return is_solution;
    }



    /**
     * Sweeps that go on as the last two did, each less than the one before by
     * the same factor, end that much farther on (Aitken).
     */
    void
    extrapolate(const Values &before_last, const Values &last, Values &k)
    {
      double product = 0., square = 0.;
      for (unsigned int i = 0; i < k.size(); ++i)
        {
          product += (k[i] - last[i]) * (last[i] - before_last[i]);
          square += std::pow(last[i] - before_last[i], 2);
        }
      if (!(product > 0. && product < square))
        return;
      const double factor = product / (square - product);
      for (unsigned int i = 0; i < k.size(); ++i)
        k[i] = std::max(0., k[i] + factor * (k[i] - last[i]));
    }



    /** Node by node, and all when they are near; true if it converged. */
    bool
    relax(ExchangeStage &end, Values &k)
    {
      constexpr unsigned int n_sweeps = 60, n_to_extrapolate = 5;
      if (end.n > 32)
        return false; // takes too long
      Values before_last(k), last(k);
      for (unsigned int sweep = 1; sweep <= n_sweeps; ++sweep)
        {
          before_last.swap(last);
          last = k;
          for (unsigned int i = 0; i < end.n; ++i)
            k[i] = solve_node(end, k, i);
          if (defect(k, last) <= 1e-14)
            return true;
          Values trial(k);
          if (solve_smooth(end, trial))
            {
              k = trial;
              return true;
            }
          if (sweep % n_to_extrapolate == 0 && sweep < n_sweeps)
            extrapolate(before_last, last, k);
        }
      // pressures that are small differences leave no more digits, and those
      // that are rounding none, between the sides of a jump
      end.law_at(k);
      for (unsigned int i = 0; i < end.n; ++i)
        if (!(std::abs(k[i] - last[i]) <= 1e-9 * k[i] ||
              end.has_rounded_pressure(i)))
          return false;
      return true;
    }
  } // namespace



  ExchangeSolver::ExchangeSolver(const ContactLaw   &law,
                                 const HeatExchange &exchange)
    : law(law)
    , exchange(exchange)
  {}



  unsigned int
  ExchangeSolver::solve(const EndResponse       &response,
                        const ContactMode        mode,
                        EndExchange             &end,
                        const std::vector<bool> &is_held,
                        const NodesInMotion     &motion) const
  {
    ExchangeStage stage(
      law, exchange, response, mode, is_held, end.pressure, motion);
    if (stage.n == 1)
      end.coefficient[0] = solve_node(stage, end.coefficient, 0);
    else if (!solve_smooth(stage, end.coefficient) &&
             !bisect(stage, end.coefficient) && !relax(stage, end.coefficient))
      give_up(stage.n);
    stage.law_at(end.coefficient);
    end.pressure = stage.pressure;
    end.flux     = stage.flux;
    return stage.n_iterations;
  }
} // namespace ThermoContact
