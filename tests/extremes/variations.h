// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef thermocontact_extremes_variations_h
#define thermocontact_extremes_variations_h

#include <thermocontact/base/exceptions.h>
#include <thermocontact/method/butcher_tableau.h>

#include <iomanip>

#include "checks.h"

namespace ThermoContact
{
  /** What a run leaves for comparison. */
  struct RunResult
  {
    enum Status
    {
      done,
      enough, ///< ended by EnoughSteps
      stopped ///< ComputationError
    };

    Status                        status = done;
    std::string                   message;
    std::map<std::string, double> failures;
    Scales                        scales;
    StepRecord                    last;
    std::vector<ContactEvent>     events;
    std::vector<std::string>      warnings;
    bool                          has_contact   = false;
    bool                          has_underflow = false; ///< of pressures
    double                        growth        = 0.;
  };



  /** @throw InputError if the scene is refused. */
  template <int dim>
  RunResult
  run_scene(const Parameters &parameters, const unsigned int max_steps)
  {
    RunResult       result;
    StepChecks<dim> checks(max_steps);
    Simulation<dim> simulation(parameters, MPI_COMM_SELF);
    const auto      observe = [&checks](const Simulation<dim> &s) {
      checks.observe(s);
    };
    try
      {
        simulation.run({observe});
      }
    catch (const EnoughSteps &)
      {
        result.status = RunResult::enough;
      }
    catch (const ComputationError &error)
      {
        result.status  = RunResult::stopped;
        result.message = error.what();
      }
    result.failures      = checks.failures;
    result.scales        = checks.scales;
    result.last          = simulation.record();
    result.events        = simulation.events();
    result.warnings      = simulation.history().warnings;
    result.has_contact   = checks.has_contact;
    result.growth        = checks.growth;
    result.has_underflow = checks.has_underflow;
    if (!are_in_order(result.events))
      result.failures["events out of order"] = 1.;
    return result;
  }



  inline RunResult
  run_scene(const Parameters &parameters, const unsigned int max_steps)
  {
    return parameters.dimension == 1 ? run_scene<1>(parameters, max_steps) :
                                       run_scene<2>(parameters, max_steps);
  }



  /** factor * (expression), each component of a vector. */
  inline std::string
  times(const double factor, std::string expression, const double theta_A)
  {
    std::ostringstream value, result;
    value << std::setprecision(17) << "(" << theta_A << ")";
    const std::string name = "theta_A";
    for (std::size_t at = expression.find(name); at != std::string::npos;
         at             = expression.find(name, at))
      expression.replace(at, name.size(), value.str());

    std::istringstream components(expression);
    std::string        component;
    for (unsigned int i = 0; std::getline(components, component, ';'); ++i)
      result << std::setprecision(17) << (i > 0 ? ";" : "") << factor << "*("
             << component << ")";
    return result.str();
  }



  /** The variable times a factor in place of it. */
  inline void
  replace_name(const std::string &name,
               const double       factor,
               std::string       &expression)
  {
    std::ostringstream text;
    text << std::setprecision(17) << "(" << factor << "*" << name << ")";
    for (std::size_t at = expression.find(name); at != std::string::npos;
         at             = expression.find(name, at + text.str().size()))
      expression.replace(at, name.size(), text.str());
  }



  /**
   * The scene with thermal and mechanical data multiplied by a factor each. An
   * expression that is 0 stays absent, and one that is multiplied by 1 as it
   * is: the parser rounds others. (epsilon p^(1/m) is a displacement, and c v a
   * number.)
   */
  inline Parameters
  scaled(Parameters parameters, const double thermal, const double mechanical)
  {
    // in expressions, where it may be one itself
    const double theta_A = Scene(parameters).heat.fixed_end_temperature;
    const auto   scale   = [theta_A](const double factor, std::string &text) {
      if (factor != 1. && text != "0")
        text = times(factor, text, theta_A);
    };
    scale(thermal, parameters.initial_values.temperature);
    scale(mechanical, parameters.initial_values.displacement);
    scale(mechanical, parameters.initial_values.velocity);
    scale(thermal, parameters.sources.heat_source);
    scale(thermal, parameters.sources.end_heat_flux);
    scale(mechanical, parameters.sources.body_force);
    scale(mechanical, parameters.sources.end_traction);
    BoundaryParameters &boundary = parameters.boundary;
    boundary.fixed_end_temperature *= thermal;
    boundary.obstacle_temperature *= thermal;
    boundary.ambient_temperature *= thermal;
    scale(mechanical, boundary.fixed_end_displacement);
    if (!boundary.fixed_end_expression.empty())
      scale(thermal, boundary.fixed_end_expression);
    if (!boundary.obstacle_expression.empty())
      scale(thermal, boundary.obstacle_expression);
    if (!boundary.exchange_expression.empty())
      for (const char *name : {"gap", "pressure"})
        replace_name(name, 1. / mechanical, boundary.exchange_expression);
    parameters.contact.gap *= mechanical;
    if (parameters.contact.rear_gap)
      *parameters.contact.rear_gap *= mechanical;
    if (!parameters.contact.gap_expression.empty())
      scale(mechanical, parameters.contact.gap_expression);
    if (parameters.contact.condition == "power law")
      parameters.contact.compliance *=
        std::pow(mechanical, 1. - 1. / parameters.contact.exponent);
    parameters.contact.damping /= mechanical;
    return parameters;
  }



  /**
   * Largest difference between a run and the run of a scene that was multiplied
   * by @p thermal and @p mechanical, relative to the largest values; of forces
   * that are rounding of the stresses, to the displacements.
   *
   * @param is_exact false: an event that rounding moves past the end of a step
   *   may make one more, of the length of that
   */
  inline double
  difference(const RunResult &run,
             const RunResult &scaled_run,
             const double     thermal,
             const double     mechanical,
             const double     end_time,
             const bool       is_exact)
  {
    double     largest = 0.;
    const auto compare =
      [&](const double x, const double y, const double scale) {
        if (x != y && !(std::isnan(x) && std::isnan(y)))
          raise(largest, std::abs(x - y) / scale);
      };
    const StepRecord &r = run.last, &s = scaled_run.last;
    const Scales     &scales = run.scales;
    compare(run.status, scaled_run.status, 1.);
    if (is_exact)
      compare(r.step, s.step, 1.);
    compare(r.time, s.time, end_time);
    compare(r.displacement_end,
            s.displacement_end / mechanical,
            scales.displacement);
    compare(r.velocity_end, s.velocity_end / mechanical, scales.velocity);
    compare(r.temperature_end, s.temperature_end / thermal, scales.temperature);
    compare(r.contact_force,
            s.contact_force / mechanical,
            std::max(scales.force, 1e-8 * scales.displacement));
    compare(run.events.size(), scaled_run.events.size(), 1.);
    for (unsigned int i = 0;
         i < std::min(run.events.size(), scaled_run.events.size());
         ++i)
      compare(run.events[i].time, scaled_run.events[i].time, end_time);
    return largest;
  }



  /** Temperatures of a rod at rest, (M2.1), (M5.6): its end and its mean. */
  struct TemperaturesAtRest
  {
    double end, mean;

    TemperaturesAtRest(const BoundaryParameters &b,
                       const double              left,
                       const double              k)
    {
      const double c  = k / (k + 1.);
      const double mu = std::sqrt(b.lateral_heat_exchange);
      const double outside =
        b.lateral_heat_exchange > 0. ? b.ambient_temperature : 0.;
      const double cosine    = std::cosh(mu);
      const double sine      = mu > 0. ? std::sinh(mu) / mu : 1.;
      const double C         = mu > 0. ? (cosine - 1.) / (mu * mu) : 0.5;
      const double N         = (1. - c) * cosine + c * sine;
      const double theta_A   = left - outside;
      const double theta_obs = b.obstacle_temperature - outside;
      end = outside + ((1. - c) * theta_A + c * theta_obs * sine) / N;
      mean =
        outside + (((1. - c) * sine + c * C) * theta_A + c * C * theta_obs) / N;
    }
  };



  /**
   * Distance of the last state from (M3.1), with the heat exchange of its own
   * gap and pressure, relative to the largest values of the run and the
   * displacements that its largest temperature and velocity would cause.
   */
  inline double
  distance_from_steady_state(const RunResult &run, const Parameters &parameters)
  {
    const Scene              scene(parameters);
    const StepRecord        &last = run.last;
    const double             a    = parameters.model.coupling;
    const TemperaturesAtRest rest(
      parameters.boundary,
      scene.heat.fixed_end_drive ?
        scene.heat.fixed_end_drive->value(last.time) :
        scene.heat.fixed_end_temperature,
      scene.heat.exchange->coefficient(scene.contact.law->is_active() ?
                                         -last.gap :
                                         0.,
                                       std::abs(last.contact_force)));
    const double free_end = a * rest.mean;
    NodeLaw      law(*scene.contact.law);
    law.play = parameters.contact.gap + scene.contact.rear_gap;
    const double pressure =
      law.resolve(free_end - parameters.contact.gap, 1.).pressure;
    const double length =
      std::max({run.scales.displacement,
                std::abs(a) * run.scales.temperature,
                std::sqrt(parameters.model.inertia) * run.scales.velocity});
    double distance = 0.;
    raise(distance,
          std::abs(last.displacement_end - (free_end - pressure)) / length);
    raise(distance, std::abs(last.contact_force - pressure) / length);
    raise(distance,
          std::abs(last.temperature_end - rest.end) / run.scales.temperature);
    raise(distance, std::abs(last.velocity_end) / run.scales.velocity);
    return distance;
  }



  /**
   * What one step of length @p dt leaves of a mode exp(-rate t), for large
   * rate dt: of a stiffly accurate scheme it is -e_s A^{-1} 1 / (rate dt),
   * which the stage equations A y = 1 give from the first row to the last.
   */
  inline double
  remainder_of_one_step(const std::string &scheme,
                        const double       rate,
                        const double       dt)
  {
    const ButcherTableau &tableau = butcher_tableau(scheme);
    std::vector<double>   y(tableau.n_stages());
    for (unsigned int i = 0; i < y.size(); ++i)
      {
        y[i] = 1.;
        for (unsigned int j = 0; j < i; ++j)
          y[i] -= tableau.a[i][j] * y[j];
        y[i] /= tableau.gamma();
      }
    return std::abs(y.back()) / (rate * dt);
  }
} // namespace ThermoContact

#endif
