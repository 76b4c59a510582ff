// SPDX-License-Identifier: LGPL-2.1-or-later

#include <thermocontact/base/multiples.h>
#include <thermocontact/forecast/forecast.h>
#include <thermocontact/method/bracketed_root.h>

#include <algorithm>
#include <cmath>

namespace ThermoContact
{
  namespace
  {
    /**
     * Error-controlled steps, in units of tolerance^(-e) with the exponent e of
     * the scheme: a fit to 190 runs, doc/accuracy.md. Heat conduction, which
     * takes as many steps in each decade of time, and the start of a rod have a
     * number of their own; each run of a wave through
     * the rod until viscosity or heat conduction has damped it takes another,
     * more the less the viscosity damps what is short and the stiffer the
     * obstacle is.
     */
    double
    scaled_steps(const Scene &scene)
    {
      const Material   &material = scene.material;
      const ContactLaw &law      = *scene.contact.law;
      const double      T        = scene.parameters.time.end_time;
      double            sum      = 0.;
      if (scene.fields.has_temperature)
        sum += 0.38 * std::log1p(std::min(10., T) / 3e-4);
      if (scene.fields.has_displacement)
        sum += 1.7 * std::min(1., std::sqrt(T));
      if (scene.fields.has_displacement && material.has_inertia())
        {
          const double b = material.inertia, wave = std::sqrt(b);
          const double rate =
            material.viscosity / b +
            0.5 * material.heating * material.thermal_stress / (b + 0.4);
          const double n_runs = std::min(T, 1. / rate) / wave;
          const double damped =
            0.05 * wave / (material.viscosity + 3e-4 * wave);
          const double contact =
            law.is_active() ? 0.5 / (1. + 5. * law.tangent(1.)) : 0.;
          sum += (0.55 + contact) * n_runs * (1. + std::pow(damped, 0.4));
        }
      return sum;
    }



    /**
     * Error-controlled steps of a body that heat moves from one equilibrium to
     * the next, where the error estimate of any scheme has order 2: a fit,
     * doc/accuracy.md.
     */
    double
    equilibrium_steps(const Scene &scene)
    {
      const TimeParameters &time = scene.parameters.time;
      return scene.fields.has_temperature && scene.fields.has_displacement &&
                 !scene.material.has_inertia() &&
                 !scene.material.has_viscosity() ?
               4. * std::cbrt(std::min(1., time.end_time) / time.tolerance) :
               0.;
    }



    /** scaled_steps() for loads: half a step in each width. */
    double
    scaled_steps(const LoadHistory &loads)
    {
      double sum = 0.;
      for (const LoadStretch &stretch : loads.stretches)
        sum += 0.5 * (stretch.end - stretch.begin) / stretch.width;
      return sum;
    }



    /** One file of the contact face; a cell between nodes has its own points.
     */
    double
    contact_face_bytes(const Parameters &parameters)
    {
      const unsigned int dim = parameters.dimension;
      return 1900. +
             8. * std::pow(2., dim - 1.) * parameters.mesh.n_contact_nodes(dim);
    }



    /** Rows or snapshots at the first step end at or after each multiple. */
    double
    n_outputs(const double interval, const double T, const double n_steps)
    {
      return std::min(n_steps + 1., intervals_until(interval, T) + 1.);
    }



    /**
     * Displacement that the end of a rod loses per unit pressure in a stage of
     * length @p tau, $\chi(\tau)$ of doc/discretisation.md (D7.2), without coupling.
     */
    double
    rod_response(const Material &material, const double tau)
    {
      const double b = material.inertia, damped = tau + material.viscosity;
      return tau * std::sqrt(tau / (b * damped)) *
             std::tanh(std::sqrt(b / (tau * damped)));
    }
  } // namespace



  std::vector<std::pair<std::string, double>>
  time_scales(const Scene &scene)
  {
    std::vector<std::pair<std::string, double>> scales;
    const Material                             &material = scene.material;
    const double wave = std::sqrt(material.inertia);
    if (scene.fields.has_temperature)
      scales.emplace_back("heat", 1.);
    if (scene.fields.has_temperature && scene.heat.has_lateral_exchange())
      scales.emplace_back("lateral", 1. / scene.heat.lateral_exchange);
    if (!scene.fields.has_displacement)
      return scales;
    if (material.has_inertia())
      scales.emplace_back("wave", wave);
    if (material.has_viscosity())
      scales.emplace_back("viscous", material.viscosity);
    if (const auto compliance = scene.contact.compliance();
        compliance && material.has_inertia())
      {
        const double impedance = *compliance * wave;
        scales.emplace_back("contact",
                            std::max(std::cbrt(impedance * impedance *
                                               material.viscosity),
                                     impedance));
      }
    return scales;
  }



  std::optional<double>
  critical_step_size(const Scene &scene)
  {
    const auto compliance = scene.contact.compliance();
    if (!compliance || *compliance >= 1. || !scene.material.has_inertia() ||
        scene.parameters.dimension > 1 || scene.row.is_given())
      return {};
    // chi grows from 0 to 1 with the length of the stage, here in 200 decades
    const auto excess = [&](const double log_tau) {
      return rod_response(scene.material, std::exp(log_tau)) - *compliance;
    };
    const double smallest = std::log(1e-100), largest = std::log(1e100);
    return std::exp(bracketed_root(excess, smallest, largest).first);
  }



  ExpectedCost
  expected_cost(const Scene &scene, const LoadHistory &loads)
  {
    const Parameters       &parameters = scene.parameters;
    const TimeParameters   &time       = parameters.time;
    const OutputParameters &output     = parameters.output;
    const double            T          = time.end_time;
    ExpectedCost            cost;
    if (time.has_error_control())
      {
        cost.is_driven = scene.sources.any();
        // a node with mass that bounces, on any law; masses alone have no mesh
        const bool has_mesh =
          !scene.row.is_given() || scene.row.middle().has_value();
        cost.is_least =
          has_mesh && !scene.obstacle_mass && scene.material.has_inertia() &&
          scene.contact.law->is_active() && !scene.contact.has_massless_nodes &&
          scene.contact.any([&](const ContactLaw &law) {
            return contact_nodes_oscillate(parameters, law);
          });
        const double scaled =
          scaled_steps(scene) + (cost.is_driven ? scaled_steps(loads) : 0.);
        const auto free = steps_of_free_waves(scene);
        cost.steps      = std::ceil(std::max(
          {free ? *free :
                       scaled / std::pow(time.tolerance, scene.scheme.step_exponent),
           equilibrium_steps(scene),
           T / time.maximum_step_size}));
      }
    else
      {
        cost.steps    = time.n_steps();
        cost.is_exact = !output.land_on_times && output.period == 0. &&
                        time.break_points.empty() &&
                        !scene.sources.has_moving_obstacle &&
                        !scene.contact.locates_events;
        for (const double point : time.break_points)
          cost.steps += point > 0. && point < T;
      }
    for (const double interval : output.landing_intervals())
      cost.steps += T / interval;

    const bool has_heat = scene.fields.has_temperature;
    const bool moves    = scene.fields.has_displacement;
    cost.rows           = output.contact_interval > 0. ?
                            n_outputs(output.contact_interval, T, cost.steps) :
                            cost.steps + 1.;
    cost.row_bytes      = cost.rows * (has_heat && moves ? 290. :
                                       moves             ? 250. :
                                                           195.);
    if (output.fields_interval > 0.)
      {
        const unsigned int dim    = parameters.dimension;
        const double       points = parameters.mesh.n_cells(dim) *
                              std::pow(parameters.mesh.degree + 1., dim);
        cost.snapshots = n_outputs(output.fields_interval, T, cost.steps);
        cost.snapshot_bytes =
          cost.snapshots *
          (900. + 500. * (has_heat + moves) +
           points * (dim == 1 ? (moves ? 20. : 10.) : (moves ? 32. : 16.)));
        if (dim > 1 && scene.contact.law->is_active())
          cost.face_bytes = cost.snapshots * contact_face_bytes(parameters);
      }
    if (parameters.dimension > 1)
      cost.cpu_seconds = expected_cpu_seconds(scene, cost.steps);
    return cost;
  }
} // namespace ThermoContact
