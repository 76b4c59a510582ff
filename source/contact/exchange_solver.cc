// SPDX-License-Identifier: LGPL-2.1-or-later

#include <thermocontact/base/exceptions.h>
#include <thermocontact/base/tolerances.h>
#include <thermocontact/contact/exchange_solver.h>

#include <deal.II/lac/vector.h>

#include <algorithm>
#include <cmath>
#include <deque>
#include <numeric>

namespace ThermoContact
{
  namespace
  {
    using dealii::FullMatrix;
    using Values = ExchangeStage::Values;

    constexpr unsigned int max_sweeps = 60;



    /** coefficient_next_to() its @p k, of node @p i. */
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
      return coefficient_next_to(k[i], excess, end.n);
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



    /** Steps of Newton's method by the derivatives of a stage. */
    struct ByDerivatives
    {
      ExchangeStage &end;

      Values
      law_at(const Values &k)
      {
        return end.law_at(k);
      }

      Values
      step(const Values &k, const Values &law)
      {
        FullMatrix<double> matrix = end.derivative();
        matrix *= -1.;
        dealii::Vector<double> rhs(end.n), result(end.n);
        for (unsigned int i = 0; i < end.n; ++i)
          {
            matrix(i, i) += 1.;
            rhs(i) = law[i] - k[i];
          }
        matrix.gauss_jordan();
        matrix.vmult(result, rhs);
        return Values(result.begin(), result.end());
      }
    };



    double
    dot(const Values &a, const Values &b)
    {
      return std::inner_product(a.begin(), a.end(), b.begin(), 0.);
    }

    void
    add(Values &a, const double factor, const Values &b)
    {
      for (unsigned int i = 0; i < a.size(); ++i)
        a[i] += factor * b[i];
    }



    /** The same by what the last steps have changed. */
    class BySecants
    {
    public:
      explicit BySecants(ExchangeOperator &stage)
        : stage(stage)
      {}

      Values
      law_at(const Values &k)
      {
        return stage.law_at(k);
      }

      /** Solves by the secants, and takes the law for the rest. */
      Values
      step(const Values &k, const Values &law)
      {
        Values excess(law);
        add(excess, -1., k);
        if (!last_law.empty())
          {
            Secant secant{excess, law};
            add(secant.excess, -1., last_excess);
            add(secant.law, -1., last_law);
            secants.push_front(secant);
            if (secants.size() > max_secants)
              secants.pop_back();
          }
        last_excess = excess;
        last_law    = law;

        Values              result(excess);
        std::vector<Secant> orthogonal;
        for (Secant secant : secants)
          {
            const double whole = dot(secant.excess, secant.excess);
            for (const Secant &other : orthogonal)
              {
                const double part = dot(secant.excess, other.excess);
                add(secant.excess, -part, other.excess);
                add(secant.law, -part, other.law);
              }
            const double left = dot(secant.excess, secant.excess);
            if (!(left > Tolerances::rounding_of_data * whole))
              continue;
            for (Values *values : {&secant.excess, &secant.law})
              for (double &value : *values)
                value /= std::sqrt(left);
            const double part = dot(secant.excess, excess);
            add(excess, -part, secant.excess);
            add(result, -part, secant.law);
            orthogonal.push_back(secant);
          }
        return result;
      }

    private:
      /** Changes of law - k, and of the law. */
      struct Secant
      {
        Values excess, law;
      };

      static constexpr unsigned int max_secants = 5;

      ExchangeOperator  &stage;
      std::deque<Secant> secants; ///< the last one in front
      Values             last_excess, last_law;
    };



    /** Newton's method with damping; true if it converged. */
    template <typename Stage>
    bool
    solve_smooth(Stage &&stage, const double tolerance, Values &k)
    {
      Values law = stage.law_at(k);
      for (unsigned int iteration = 0; iteration < 30; ++iteration)
        {
          const double old_defect = defect(k, law);
          if (old_defect <= tolerance)
            return true;
          const Values step = stage.step(k, law);
          Values       trial(k.size()), law_there;
          double       damping = 1., new_defect = old_defect;
          for (; damping > Tolerances::shortest_newton_step; damping *= 0.5)
            {
              for (unsigned int i = 0; i < k.size(); ++i)
                trial[i] = std::max(0., k[i] + damping * step[i]);
              law_there  = stage.law_at(trial);
              new_defect = defect(trial, law_there);
              if (new_defect < old_defect)
                break;
            }
          if (!(new_defect < old_defect))
            {
              // the rounding of a steep law
              if (!(old_defect <= Tolerances::rounding_of_data))
                return false;
              stage.law_at(k);
              return true;
            }
          k   = trial;
          law = law_there;
        }
      return defect(k, law) <=
             std::max(tolerance, Tolerances::rounding_of_data);
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
          if (solve_smooth(ByDerivatives{end}, Tolerances::rounding, trial))
            {
              k = trial;
              return true;
            }
        }
      return false;
    }
  } // namespace



  void
  give_up_exchange(const unsigned int n_nodes)
  {
    throw ComputationError(
      "the heat exchange coefficients of the contact nodes (" +
      std::to_string(n_nodes) +
      ") were not found\n  remedy:  a smaller Time/Step size, "
      "or a Boundary/right/Heat exchange without jumps that is less steep");
  }



  unsigned int
  solve_contact_and_exchange(const HeatExchange         &exchange,
                             const EndResponse          &response,
                             const std::vector<NodeLaw> &laws,
                             ObstacleAction             &contact,
                             std::vector<double>        &flux)
  {
    ExchangeStage        stage(exchange, response, laws, contact.pressure);
    std::vector<double> &k = contact.exchange_coefficient;
    if (stage.n == 1)
      k[0] = solve_node(stage, k, 0);
    else if (!solve_smooth(ByDerivatives{stage}, Tolerances::rounding, k) &&
             !solve_by_sweeps(stage, k))
      give_up_exchange(stage.n);
    stage.law_at(k);
    contact.pressure = stage.pressure;
    flux             = stage.flux;
    return stage.n_iterations;
  }



  void
  solve_by_secants(ExchangeOperator    &stage,
                   const double         tolerance,
                   std::vector<double> &coefficient)
  {
    if (!solve_smooth(BySecants(stage), tolerance, coefficient))
      give_up_exchange(coefficient.size());
  }
} // namespace ThermoContact
