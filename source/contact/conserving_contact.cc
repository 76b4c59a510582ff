// SPDX-License-Identifier: LGPL-2.1-or-later

#include <thermocontact/base/exceptions.h>
#include <thermocontact/base/special_numbers.h>
#include <thermocontact/base/tolerances.h>
#include <thermocontact/contact/conserving_contact.h>
#include <thermocontact/method/scheme.h>

#include <deal.II/lac/vector.h>

#include <algorithm>
#include <cmath>

namespace ThermoContact
{
  namespace
  {
    using Values = std::vector<double>;

    constexpr unsigned int max_newton_steps = 50;



    double
    largest_entry(const Values &vector)
    {
      double largest = 0.;
      for (const double entry : vector)
        largest = std::max(largest, std::abs(entry));
      return largest;
    }



    Values
    on_way(const Values &start, const Values &end, const double part)
    {
      Values result(start);
      for (unsigned int i = 0; i < result.size(); ++i)
        result[i] += part * (end[i] - start[i]);
      return result;
    }



    /** Newton's step for $p-\bar p(A-2Bp)=0$. */
    void
    newton_update(const dealii::FullMatrix<double> &derivative,
                  const dealii::FullMatrix<double> &receptance,
                  const dealii::Vector<double>     &residual,
                  dealii::Vector<double>           &update)
    {
      const unsigned int         n = residual.size();
      dealii::FullMatrix<double> jacobian(n, n);
      derivative.mmult(jacobian, receptance);
      jacobian *= 2.;
      for (unsigned int i = 0; i < n; ++i)
        jacobian(i, i) += 1.;
      jacobian.gauss_jordan();
      jacobian.vmult(update, residual);
    }



    /** Size of the terms that positions at the end of a step are made of. */
    double
    position_scale(const double                      displacement_scale,
                   const Values                     &start,
                   const Values                     &free_end,
                   const dealii::FullMatrix<double> &receptance,
                   const Values                     &pressure)
    {
      double scale = 0.;
      for (unsigned int i = 0; i < pressure.size(); ++i)
        {
          double sum =
            displacement_scale + std::abs(start[i]) + std::abs(free_end[i]);
          for (unsigned int j = 0; j < pressure.size(); ++j)
            sum += 2. * std::abs(receptance(i, j) * pressure[j]);
          scale = std::max(scale, sum);
        }
      return scale;
    }


    std::unique_ptr<const ContactLaw>
    elastic_obstacle(const double compliance)
    {
      ContactLawParameters parameters = default_law_parameters();
      parameters.at("Compliance")     = compliance;
      return normal_compliance().make(parameters);
    }
  } // namespace



  ConservingContact::ConservingContact(
    const ContactLaw                 &law,
    const dealii::FullMatrix<double> &receptance)
    : static_receptance(receptance)
    , law_of_node(elastic_obstacle(law.tangent(0.) + receptance(0, 0)))
  {}



  void
  ConservingContact::equilibrium(const std::vector<NodeLaw> &laws,
                                 const Values               &s,
                                 Values                     &pressure)
  {
    problem.solve(static_receptance, laws, s, pressure);
  }



  void
  ConservingContact::mean_pressure(const std::vector<NodeLaw> &laws,
                                   const Values               &start,
                                   const Values               &end,
                                   Values                     &mean,
                                   dealii::FullMatrix<double> &derivative)
  {
    const unsigned int n = laws.size();
    mean.assign(n, 0.);
    derivative.reinit(n, n);
    // Where nodes change together, the next branches are taken at a point a
    // little further on; the error up to there is of second order in it. Nodes
    // that move within rounding are not seen to change: then further on.
    double                     lead = Tolerances::simultaneous_changes;
    Values                     pressure(n, 0.);
    dealii::FullMatrix<double> response(n, n), change(n, 1);
    for (double xi = 0.; xi < 1.;)
      {
        const Values ahead = on_way(start, end, xi + lead);
        equilibrium(laws, ahead, pressure);
        const Values slope = problem.slopes();
        for (unsigned int i = 0; i < n; ++i)
          change(i, 0) = end[i] - start[i];
        respond_to_change(static_receptance, slope, change);

        double distance = infinity;
        for (unsigned int i = 0; i < n; ++i)
          {
            double z = ahead[i] - lead * change(i, 0);
            for (unsigned int j = 0; j < n; ++j)
              if (j != i)
                z -= static_receptance(i, j) * pressure[j];
            distance =
              std::min(distance,
                       laws[i].distance_to_branch(z, change(i, 0), lead));
          }
        const double next   = std::min(1., xi + distance);
        const double length = next - xi;
        response            = dealii::IdentityMatrix(n);
        respond_to_change(static_receptance, slope, response);
        for (unsigned int i = 0; i < n; ++i)
          {
            mean[i] += length * (pressure[i] + (0.5 * length - lead) *
                                                 slope[i] * change(i, 0));
            for (unsigned int j = 0; j < n; ++j)
              derivative(i, j) +=
                0.5 * (next * next - xi * xi) * slope[i] * response(i, j);
          }
        lead = next > xi + lead ? Tolerances::simultaneous_changes : 2. * lead;
        xi   = next;
      }
  }



  unsigned int
  ConservingContact::step_pressure(const std::vector<NodeLaw>       &laws,
                                   const Values                     &start,
                                   const Values                     &free_end,
                                   const dealii::FullMatrix<double> &receptance,
                                   const double displacement_scale,
                                   Values      &pressure)
  {
    const unsigned int n = laws.size();
    if (n == 1)
      {
        NodeLaw law(laws[0]);
        law.law       = law_of_node.get();
        law.mean_from = start[0];
        // the rounding of a receptance that vanishes may be negative
        pressure[0] =
          law.resolve(free_end[0], std::max(2. * receptance(0, 0), 0.))
            .pressure;
        return 1;
      }

    Values                     end, mean;
    dealii::FullMatrix<double> derivative;
    dealii::Vector<double>     residual(n), update(n);
    const auto                 evaluate = [&](const Values &p) {
      end = free_end;
      for (unsigned int i = 0; i < n; ++i)
        for (unsigned int j = 0; j < n; ++j)
          end[i] -= 2. * receptance(i, j) * p[j];
      mean_pressure(laws, start, end, mean, derivative);
      for (unsigned int i = 0; i < n; ++i)
        residual(i) = p[i] - mean[i];
      return residual.linfty_norm();
    };
    double norm = evaluate(pressure);
    for (unsigned int iteration = 1; iteration <= max_newton_steps; ++iteration)
      {
        if (norm <= Tolerances::rounding_of_sum *
                      std::max(largest_entry(pressure), largest_entry(mean)))
          return iteration;
        newton_update(derivative, receptance, residual, update);
        const Values old_pressure = pressure;
        const double old_norm     = norm;
        for (double part = 1.; part > Tolerances::shortest_newton_step;
             part *= 0.5)
          {
            for (unsigned int i = 0; i < n; ++i)
              pressure[i] = old_pressure[i] - part * update(i);
            norm = evaluate(pressure);
            if (norm < old_norm)
              break;
          }
        // at the rounding of the displacements no step is an improvement
        if (norm >= old_norm &&
            old_norm <=
              Tolerances::rounding_of_sum *
                (derivative.linfty_norm() * position_scale(displacement_scale,
                                                           start,
                                                           free_end,
                                                           receptance,
                                                           old_pressure) +
                 largest_entry(old_pressure)))
          {
            pressure = old_pressure;
            return iteration;
          }
      }
    throw ComputationError(
      "the pressures of " + std::to_string(n) +
      " contact nodes that conserve energy were not found\n  remedy:  a smaller "
      "Time/Step size, or Time/Scheme = " +
      default_scheme().name);
  }
} // namespace ThermoContact
