// SPDX-License-Identifier: LGPL-2.1-or-later

#include <thermocontact/forecast/first_impact.h>
#include <thermocontact/forecast/steady_state.h>
#include <thermocontact/space/problem_data.h>

#include <deal.II/base/quadrature_lib.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace ThermoContact
{
  namespace
  {
    constexpr unsigned int n_modes = 64;

    /**
     * What the estimate of one implicit stage is multiplied with: the peak of
     * the exact response of a long rod to a steady approach is 1.6 times the
     * stage's if viscous, between 1 and that otherwise. Measured: doc/model.md.
     */
    constexpr double stage_factor = 1.5;



    /**
     * The time at which the free end reaches the obstacle, or NaN: the first of
     * 500 instants at which it is beyond, refined by bisection.
     */
    double
    arrival(const FreeMotion &motion, const double gap, const double horizon)
    {
      constexpr unsigned int n_instants = 500;
      for (unsigned int i = 1; i <= n_instants; ++i)
        if (motion.end_values(horizon * i / n_instants).first >= gap)
          {
            double before = horizon * (i - 1) / n_instants;
            double after  = horizon * i / n_instants;
            for (unsigned int j = 0; j < 50; ++j)
              {
                const double middle = 0.5 * (before + after);
                (motion.end_values(middle).first >= gap ? after : before) =
                  middle;
              }
            return after;
          }
      return std::numeric_limits<double>::quiet_NaN();
    }
  } // namespace



  FreeMotion::FreeMotion(const Parameters &parameters)
    : modes(n_modes)
    , initial_expansion_(0.)
  {
    const ModelParameters &model = parameters.model;
    const ProblemData<1>   data(parameters);
    const unsigned int     axial = model.has_temperature() ? 1 : 0;
    const double           a     = model.thermal_stress();

    std::array<double, n_modes> displacement{}, velocity{};
    const QIterated<1>          quadrature(QGauss<1>(4), 2 * n_modes);
    for (unsigned int q = 0; q < quadrature.size(); ++q)
      {
        const Point<1> &x      = quadrature.point(q);
        const double    weight = quadrature.weight(q);
        const double    strain =
          a == 0. ? 0. : a * data.initial_fields().value(x, 0);
        const double u = data.initial_fields().value(x, axial);
        const double v = data.initial_velocity().value(x, axial);
        initial_expansion_ += weight * strain;
        for (unsigned int n = 0; n < n_modes; ++n)
          {
            const double k = (n + 0.5) * numbers::PI;
            // the deviation from u_th with u_th' = a theta_0, by parts
            displacement[n] +=
              2. * weight *
              (u * std::sin(k * x[0]) - strain * std::cos(k * x[0]) / k);
            velocity[n] += 2. * weight * v * std::sin(k * x[0]);
          }
      }

    const double b    = model.inertia;
    double       sign = 1., sum = 0.;
    for (unsigned int n = 0; n < n_modes; ++n, sign = -sign)
      {
        const double         k       = (n + 0.5) * numbers::PI;
        const double         damping = model.viscosity * k * k / (2. * b);
        std::complex<double> root =
          std::sqrt(std::complex<double>(damping * damping - k * k / b));
        if (std::abs(root) < 1e-7 * k / std::sqrt(b))
          root = 1e-7 * k / std::sqrt(b); // critical damping, nearly
        auto &[rates, amplitudes] = modes[n];
        // the small rate of a strongly damped mode without cancellation
        rates[1]      = -damping - root;
        rates[0]      = k * k / b / rates[1];
        amplitudes[0] = sign * (velocity[n] - rates[1] * displacement[n]) /
                        (rates[0] - rates[1]);
        amplitudes[1] = sign * displacement[n] - amplitudes[0];
        sum += sign * displacement[n];
      }
    offset = data.initial_fields().value(Point<1>(1.), axial) - sum;
  }



  std::pair<double, double>
  FreeMotion::end_values(const double time) const
  {
    double displacement = offset, velocity = 0.;
    for (const Mode &mode : modes)
      for (unsigned int i = 0; i < 2; ++i)
        {
          const std::complex<double> value =
            mode.amplitudes[i] * std::exp(mode.rates[i] * time);
          displacement += value.real();
          velocity += (mode.rates[i] * value).real();
        }
    return {displacement, velocity};
  }



  double
  rod_response(const ModelParameters &model, const double tau)
  {
    const double b = model.inertia, damped = tau + model.viscosity;
    return tau * std::sqrt(tau / (b * damped)) *
           std::tanh(std::sqrt(b / (tau * damped)));
  }



  std::optional<FirstImpact>
  first_impact(const Parameters &parameters)
  {
    const ModelParameters &model = parameters.model;
    const ContactLaw       law   = parameters.contact_law();
    if (!law.is_active || model.inertia == 0. || parameters.dimension > 1 ||
        has_sources(parameters))
      return {};
    const FreeMotion motion(parameters);
    // a wave has run four times through the rod, or the rod has crept
    const double horizon =
      std::min(parameters.time.end_time,
               4. * (std::sqrt(model.inertia) + model.viscosity));
    if (!(horizon > 0.) || motion.end_values(0.).first >= law.gap)
      return {};
    FirstImpact impact;
    impact.time = arrival(motion, law.gap, horizon);
    if (!std::isfinite(impact.time))
      return {};
    impact.velocity = motion.end_values(impact.time).second;

    // the longest stage and the largest stroke of the free motion
    constexpr unsigned int n_stages = 200;
    double                 stroke   = 0.;
    for (unsigned int i = 0; i <= n_stages; ++i)
      {
        const double tau =
          horizon * std::pow(1e-6, 1. - static_cast<double>(i) / n_stages);
        const double beyond =
          motion.end_values(impact.time + tau).first - law.gap;
        stroke = std::max(stroke, beyond);
        if (law.compliance > 0.)
          impact.penetration =
            std::max(impact.penetration,
                     stage_factor * beyond * law.compliance /
                       (law.compliance + rod_response(model, tau)));
      }

    // The series keeps the initial temperature. By the time of the impact,
    // heat has made the part 1 - exp(-pi^2/4 t) of its way at least.
    const double heat_shift =
      model.thermal_stress() == 0. ?
        0. :
        std::abs(free_expansion(parameters) - motion.initial_expansion()) *
          -std::expm1(-0.25 * numbers::PI * numbers::PI * impact.time);
    if (!(impact.velocity > 0.) || !(stroke > 2. * heat_shift))
      return {};
    return impact;
  }
} // namespace ThermoContact
