// SPDX-License-Identifier: LGPL-2.1-or-later

#include "scene_report.h"

#include "scene_terms.h"
#include "text.h"

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
  } // namespace



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
    report_warnings(simulation.warnings(), 0, log);
  }



#define INSTANTIATE(dim) \
  template void report_scene<dim>(const Simulation<dim> &, Log &)

  INSTANTIATE(1);
  INSTANTIATE(2);
  INSTANTIATE(3);

#undef INSTANTIATE
} // namespace ThermoContact
