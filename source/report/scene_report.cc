// SPDX-License-Identifier: LGPL-2.1-or-later

#include <thermocontact/base/text.h>
#include <thermocontact/forecast/first_impact.h>
#include <thermocontact/forecast/forecast.h>
#include <thermocontact/forecast/steady_state.h>
#include <thermocontact/report/scene_report.h>
#include <thermocontact/scene/scene_terms.h>

#include <cmath>

namespace ThermoContact
{
  namespace
  {
    template <int dim>
    std::string
    describe_body(const Simulation<dim> &simulation)
    {
      const MeshParameters &mesh = simulation.parameters().mesh;
      const unsigned int    n    = simulation.discretization().n_active_cells();
      if (dim == 1)
        return text("rod of length 1, ", n, " cells of degree ", mesh.degree);
      return text(dim,
                  "-D body of length 1 and width ",
                  mesh.width,
                  ", ",
                  n,
                  " cells of degree ",
                  mesh.degree,
                  ", lateral faces: ",
                  simulation.parameters().boundary.lateral_support);
    }



    std::string
    join_words(const std::vector<std::string> &words)
    {
      std::string line;
      for (const std::string &word : words)
        line += (line.empty() ? "" : ", ") + word;
      return line;
    }



    template <int dim>
    std::string
    describe_unknowns(const Simulation<dim> &simulation)
    {
      const auto &space = simulation.discretization();
      std::string line;
      if (space.has_field(0))
        line = text(space.n_temperature_dofs(), " temperature");
      if (space.has_field(1))
        line += text(line.empty() ? "" : " + ",
                     space.n_displacement_dofs(),
                     " displacement");
      return line +
             text("; factorised at once: ", simulation.n_factorized_unknowns());
    }



    std::string
    describe_contact(const Parameters &parameters)
    {
      const ContactLaw law = parameters.contact_law();
      if (!law.is_active)
        return "none: free end";
      const std::string nodes =
        parameters.has_massless_contact() ? ", massless contact nodes" : "";
      if (law.compliance == 0.)
        return text("rigid obstacle, g = ", law.gap, nodes);
      return text("elastic obstacle, epsilon = ",
                  law.compliance,
                  ", g = ",
                  law.gap,
                  nodes);
    }



    std::string
    describe_time(const Parameters &parameters)
    {
      const TimeParameters &time = parameters.time;
      const std::string     steps =
        time.has_error_control() ?
              text("error-controlled steps, tolerance ", time.tolerance) :
              text("dt = ", *time.step_size, ", ", time.n_steps(), " steps");
      return text(time.scheme,
                  ", ",
                  steps,
                  ", T = ",
                  time.end_time,
                  time.locates_contact_events() &&
                      parameters.contact_law().is_active ?
                    ", contact events located" :
                    "",
                  ", ",
                  parameters.has_prescribed_start() ? "start of the paper" :
                                                      "consistent start",
                  ", ",
                  parameters.solver.step_solver,
                  " solver");
    }



    std::string
    describe_scales(const Parameters &parameters)
    {
      std::vector<std::string> words;
      for (const auto &[name, value] : time_scales(parameters))
        words.push_back(text(name, ' ', value));
      return join_words(words);
    }



    std::string
    describe_rest(const Parameters &parameters)
    {
      const SteadyForecast forecast = steady_state(parameters);
      if (!forecast.state)
        return forecast.remark;
      return describe_steady_state(*forecast.state, parameters) +
             (forecast.remark.empty() ? "" : "; " + forecast.remark);
    }



    /** With two significant digits. */
    std::string
    about(const double value)
    {
      return significant(round_to_digits(value, 2), 12);
    }



    std::string
    describe_impact(const FirstImpact &impact, const double compliance)
    {
      std::string line = "about t = " + about(impact.time) + ", velocity " +
                         about(impact.velocity);
      if (impact.penetration > 0.)
        line += ", peak penetration " + about(impact.penetration) +
                ", peak force " + about(impact.penetration / compliance);
      return line;
    }



    std::string
    describe_critical_step(const double critical, const Parameters &parameters)
    {
      const TimeParameters &time  = parameters.time;
      const bool            fails = parameters.solver.is_fixed_point() &&
                         !time.has_error_control() &&
                         *time.step_size > critical;
      return text("the paper's iteration fails in contact for dt > ",
                  critical,
                  fails ? text(", as the ", *time.step_size, " of this run") :
                  parameters.solver.is_fixed_point() ?
                          "" :
                          "; monolithic has no such limit");
    }



    std::string
    describe_bytes(const double bytes)
    {
      const char *const units[] = {"B", "kB", "MB", "GB", "TB"};
      unsigned int      unit    = 0;
      double            value   = bytes;
      for (; value >= 995. && unit < 4; ++unit)
        value /= 1000.;
      return "about " + about(value) + " " + units[unit];
    }



    std::string
    describe_cost(const ExpectedCost &cost)
    {
      const auto count = [&cost](const double n) {
        if (cost.is_exact)
          return significant(n, 12);
        return "about " + about(n);
      };
      std::string line = count(cost.steps) +
                         " steps; contact.csv: " + count(cost.rows) +
                         " rows, " + describe_bytes(cost.row_bytes);
      if (cost.snapshots > 0.)
        line += "; fields: " + count(cost.snapshots) + " snapshots, " +
                describe_bytes(cost.snapshot_bytes);
      return line;
    }



    /** What can be said of a run before it is made. */
    void
    report_forecast(const Parameters &parameters,
                    const double      n_cells,
                    Log              &log)
    {
      log.line("  scales    " + describe_scales(parameters));
      log.line("  at rest   " + describe_rest(parameters));
      if (const auto impact = first_impact(parameters))
        log.line("  impact    " +
                 describe_impact(*impact, parameters.contact_law().compliance));
      if (const auto critical = critical_step_size(parameters))
        log.line("  limit     " +
                 describe_critical_step(*critical, parameters));
      if (const auto cost = expected_cost(parameters, n_cells))
        log.line("  expected  " + describe_cost(*cost));
    }
  } // namespace



  std::string
  describe_steady_state(const SteadyState &state, const Parameters &parameters)
  {
    std::string line;
    const auto  add = [&line](const std::string &part) {
      line += (line.empty() ? "" : ", ") + part;
    };
    if (parameters.model.has_displacement())
      add(text("u(1) = ", state.displacement_end));
    if (parameters.model.has_temperature())
      add(text("theta(1) = ", state.temperature_end));
    if (parameters.contact_law().is_active)
      add(text("force ",
               state.contact_force,
               state.in_contact ? ", in contact" : ", open"));
    return line;
  }



  unsigned int
  report_warnings(const std::vector<std::string> &warnings,
                  const unsigned int              n_reported,
                  Log                            &log)
  {
    for (unsigned int i = n_reported; i < warnings.size(); ++i)
      log.line("  warning:  " + warnings[i]);
    return warnings.size();
  }



  template <int dim>
  void
  report_scene(const Simulation<dim> &simulation, Log &log)
  {
    const Parameters &parameters = simulation.parameters();
    const auto       &model      = parameters.model;
    const auto       &boundary   = parameters.boundary;

    if (!parameters.title.empty())
      log.line(parameters.title);
    log.line("  body      " + describe_body(simulation));
    log.line("  unknowns  " + describe_unknowns(simulation));
    log.line("  terms     " + join_words(scene_terms(parameters)));
    if (model.has_displacement())
      log.line(
        text("  model     ",
             model.has_temperature() ? text("a = ", model.coupling, ", ") : "",
             "b = ",
             model.inertia,
             ", zeta = ",
             model.viscosity,
             dim == 1 ? "" : text(", nu = ", model.poisson_ratio)));
    if (model.has_temperature())
      log.line(text("  heat      theta_A = ",
                    boundary.fixed_end_temperature,
                    ", k = ",
                    boundary.heat_exchange,
                    ", theta_obs = ",
                    boundary.obstacle_temperature));
    if (model.has_displacement())
      log.line("  contact   " + describe_contact(parameters));
    log.line("  time      " + describe_time(parameters));
    report_forecast(parameters,
                    simulation.discretization().n_active_cells(),
                    log);
    report_warnings(simulation.warnings(), 0, log);
  }



#define INSTANTIATE(dim) \
  template void report_scene<dim>(const Simulation<dim> &, Log &)

  INSTANTIATE(1);
  INSTANTIATE(2);
  INSTANTIATE(3);

#undef INSTANTIATE
} // namespace ThermoContact
