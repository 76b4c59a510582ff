// SPDX-License-Identifier: LGPL-2.1-or-later

#include <thermocontact/forecast/first_impact.h>
#include <thermocontact/forecast/steady_state.h>
#include <thermocontact/method/bracketed_root.h>
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
     * 500 instants at which it is beyond, refined between the two.
     */
    double
    arrival(const FreeMotion &motion, const double gap, const double horizon)
    {
      constexpr unsigned int n_instants = 500;
      for (unsigned int i = 1; i <= n_instants; ++i)
        if (motion.end_values(horizon * i / n_instants).first >= gap)
          return bracketed_root(
                   [&](const double time) {
                     return motion.end_values(time).first - gap;
                   },
                   horizon * (i - 1) / n_instants,
                   horizon * i / n_instants)
            .second;
      return std::numeric_limits<double>::quiet_NaN();
    }
  } // namespace



  FreeMotion::FreeMotion(const Scene &scene)
    : modes(n_modes)
    , initial_expansion_(0.)
  {
    const Material      &material = scene.material;
    const ProblemData<1> data(scene);
    const unsigned int   axial = scene.fields.has_temperature ? 1 : 0;
    const double         a     = material.thermal_stress;

    std::array<double, n_modes> displacement{}, velocity{};
    const QIterated<1>          quadrature(QGauss<1>(4), 2 * n_modes);
    for (unsigned int q = 0; q < quadrature.size(); ++q)
      {
        const Point<1> &x      = quadrature.point(q);
        const double    weight = quadrature.weight(q);
        const double    strain = material.has_thermal_stress() ?
                                   a * data.initial_fields().value(x, 0) :
                                   0.;
        const double    u      = data.initial_fields().value(x, axial);
        const double    v      = data.initial_velocity().value(x, axial);
        initial_expansion_ += weight * strain;
        // exp(i k x), from each k to the next one
        std::complex<double> wave = std::polar(1., 0.5 * numbers::PI * x[0]);
        const std::complex<double> to_next = std::polar(1., numbers::PI * x[0]);
        for (unsigned int n = 0; n < n_modes; ++n)
          {
            const double k = (n + 0.5) * numbers::PI;
            // the deviation from u_th with u_th' = a theta_0, by parts
            displacement[n] +=
              2. * weight * (u * wave.imag() - strain * wave.real() / k);
            velocity[n] += 2. * weight * v * wave.imag();
            wave = {wave.real() * to_next.real() - wave.imag() * to_next.imag(),
                    wave.real() * to_next.imag() +
                      wave.imag() * to_next.real()};
          }
      }

    const double b    = material.inertia;
    double       sign = 1., sum = 0.;
    for (unsigned int n = 0; n < n_modes; ++n, sign = -sign)
      {
        const double         k       = (n + 0.5) * numbers::PI;
        const double         damping = material.viscosity * k * k / (2. * b);
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
          if (mode.rates[i].real() * time < -50.)
            continue; // nothing is left of it, as of most modes with viscosity
          const std::complex<double> value =
            mode.amplitudes[i] * std::exp(mode.rates[i] * time);
          displacement += value.real();
          velocity += (mode.rates[i] * value).real();
        }
    return {displacement, velocity};
  }



  double
  rod_response(const Material &material, const double tau)
  {
    const double b = material.inertia, damped = tau + material.viscosity;
    return tau * std::sqrt(tau / (b * damped)) *
           std::tanh(std::sqrt(b / (tau * damped)));
  }



  std::optional<FirstImpact>
  first_impact(const Scene &scene)
  {
    const Material   &material = scene.material;
    const ContactLaw &law      = *scene.contact.law;
    const double      gap      = scene.contact.gap;
    if (!law.is_active() || law.damping() > 0. || scene.contact.rear_gap ||
        !material.has_inertia() || scene.parameters.dimension > 1 ||
        scene.sources.any())
      return {};
    const FreeMotion motion(scene);
    // a wave has run four times through the rod, or the rod has crept
    const double horizon =
      std::min(scene.parameters.time.end_time,
               4. * (std::sqrt(material.inertia) + material.viscosity));
    if (!(horizon > 0.) || motion.end_values(0.).first >= gap)
      return {};
    FirstImpact impact;
    impact.time = arrival(motion, gap, horizon);
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
        const double beyond = motion.end_values(impact.time + tau).first - gap;
        stroke              = std::max(stroke, beyond);
        if (!law.is_rigid())
          impact.force =
            std::max(impact.force,
                     law.local_pressure(stage_factor * beyond,
                                        rod_response(material, tau)));
      }
    impact.penetration = law.penetration(impact.force);

    // The series keeps the initial temperature. By the time of the impact,
    // heat has made the part 1 - exp(-(pi^2/4 + m) t) of its way at least.
    const double heat_shift =
      !material.has_thermal_stress() ?
        0. :
        std::abs(free_expansion(scene, scene.heat.steady_drop()) -
                 motion.initial_expansion()) *
          -std::expm1(
            -(0.25 * numbers::PI * numbers::PI + scene.heat.lateral_exchange) *
            impact.time);
    if (!(impact.velocity > 0.) || !(stroke > 2. * heat_shift))
      return {};
    return impact;
  }
} // namespace ThermoContact
