// SPDX-License-Identifier: LGPL-2.1-or-later

#include <thermocontact/base/exceptions.h>
#include <thermocontact/base/machine_memory.h>
#include <thermocontact/base/text.h>
#include <thermocontact/forecast/expected_memory.h>
#include <thermocontact/forecast/first_impact.h>
#include <thermocontact/forecast/forecast.h>
#include <thermocontact/output/output_units.h>
#include <thermocontact/report/scene_report.h>
#include <thermocontact/scene/coarser_scenes.h>
#include <thermocontact/scene/scene_terms.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace ThermoContact
{
  namespace
  {
    // a run of a day, a disk of a phone
    constexpr double most_steps = 1e8, most_bytes = 1e10;



    template <int dim>
    std::string
    describe_body(const Simulation<dim> &simulation)
    {
      const MeshParameters &mesh = simulation.parameters().mesh;
      const unsigned int    n    = simulation.discretization().n_active_cells();
      return join_words(
        {simulation.scene().geometry->description(),
         text(n, " cells of degree ", mesh.degree),
         dim == 1 ?
           "" :
           "lateral faces: " + simulation.parameters().boundary.lateral_support,
         simulation.scene().has_sliding_end ? "fixed end: sliding" : ""});
    }



    template <int dim>
    std::string
    describe_unknowns(const Simulation<dim> &simulation)
    {
      const auto &space = simulation.discretization();
      std::string line;
      if (space.has_field(Field::temperature))
        line = text(space.n_temperature_dofs(), " temperature");
      if (space.has_field(Field::displacement))
        line += text(line.empty() ? "" : " + ",
                     space.n_displacement_dofs(),
                     " displacement");
      const types::global_dof_index n = simulation.n_factorized_unknowns();
      if (!simulation.scene().linear_solver.is_iterative)
        return line + text("; factorised at once: ", n);
      return line + "; on the coarsest level, factorised: " +
             (n > 0 ? text(n) : "none, algebraic multigrid instead");
    }



    std::string
    describe_linear_solver(const LinearSolver &solver)
    {
      return text(solver.name(),
                  ", since ",
                  solver.reason,
                  solver.is_iterative ?
                    text("; relative residual ", solver.tolerance) :
                    "");
    }



    /** Prints what a body is expected to take of the memory of this machine. */
    void
    report_memory(const Scene &scene, const MPI_Comm communicator, Log &log)
    {
      const double expected =
        share_of_ranks_here(communicator) *
        expected_memory(scene, Utilities::MPI::n_mpi_processes(communicator));
      const double available = machine_memory();
      log.line("  memory    about " + gigabytes(expected) + ", here are " +
               gigabytes(available));
      if (expected > available)
        log.line(text("  warning:  that may not be enough memory",
                      scene.linear_solver.is_iterative ?
                        "" :
                        "; Solver/Linear solver = iterative takes less"));
    }



    /** A formula with its values at t = 0, or a length. */
    template <int dim>
    std::string
    describe_gap(const Simulation<dim> &simulation, const OutputUnits &units)
    {
      const Scene &scene  = simulation.scene();
      const bool   moves  = scene.sources.has_moving_obstacle;
      const bool   is_one = scene.contact.has_uniform_gap();
      if (is_one && !moves)
        return units.text("length", scene.contact.gap);
      const auto [smallest, largest] =
        simulation.discretization().contact_end().range_of_gap();
      return text(scene.parameters.contact.gap_expression,
                  " (",
                  units.text("length", smallest),
                  is_one ? "" : " to " + units.text("length", largest),
                  is_one ? "" : " at the contact nodes",
                  moves ? " at t = 0)" : ")");
    }



    template <int dim>
    std::string
    describe_contact(const Simulation<dim> &simulation)
    {
      const SceneContact &contact = simulation.scene().contact;
      const OutputUnits   units(simulation.parameters());
      if (!contact.law->is_active())
        return contact.law->description();
      return join_words(
        {contact.law->description(),
         "g = " + describe_gap(simulation, units),
         contact.is_two_sided() ?
           "g_2 = " + units.text("length", contact.rear_gap) :
           "",
         contact.has_massless_nodes ? "massless contact nodes" : ""});
    }



    std::string
    describe_time(const Scene &scene)
    {
      const TimeParameters &time = scene.parameters.time;
      const OutputUnits     units(scene.parameters);
      const std::string     steps =
        time.has_error_control() ?
              text("error-controlled steps, tolerance ", time.tolerance) :
              text("dt = ",
               units.text("time", *time.step_size),
               ", ",
               time.n_steps(),
               " steps");
      return join_words(
        {time.scheme,
         steps,
         "T = " + units.text("time", time.end_time),
         scene.contact.locates_events ? "contact events located" : "",
         scene.has_prescribed_start ? "start of the paper" : "consistent start",
         scene.parameters.solver.step_solver + " solver"});
    }



    /** What steps follow of the loads. */
    std::string
    describe_loads(const LoadHistory &loads, const OutputUnits &units)
    {
      unsigned int n_jumps = 0;
      for (const LoadBreak &at : loads.breaks)
        n_jumps += at.is_jump;
      std::string line =
        text("steps end at ",
             n_jumps,
             n_jumps == 1 ? " jump and " : " jumps and ",
             loads.breaks.size() - n_jumps,
             loads.breaks.size() - n_jumps == 1 ? " bend" : " bends");
      double smallest = std::numeric_limits<double>::infinity();
      for (const LoadStretch &stretch : loads.stretches)
        smallest = std::min(smallest, stretch.width);
      if (!loads.stretches.empty())
        line += text(", and are at most ",
                     units.text("time", smallest),
                     " where loads change");
      return line;
    }



    std::string
    describe_scales(const Scene &scene)
    {
      std::vector<std::string> words;
      const OutputUnits        units(scene.parameters);
      for (const auto &[name, value] : time_scales(scene))
        words.push_back(text(name, ' ', units.text("time", value)));
      return join_words(words);
    }



    /** A line for each state of rest. */
    std::string
    describe_rest(const Scene &scene)
    {
      const SteadyForecast forecast = steady_state(scene);
      if (forecast.states.empty())
        return forecast.remark;
      std::string lines;
      for (const SteadyState &state : forecast.states)
        lines += (lines.empty() ? "" : "\n            ") +
                 describe_steady_state(state, scene) +
                 (scene.heat.exchange->is_constant() ? "" :
                  state.is_stable                    ? ", stable" :
                                                       ", unstable");
      return lines + (forecast.remark.empty() ? "" : "; " + forecast.remark);
    }



    std::string
    describe_impact(const FirstImpact &impact, const OutputUnits &units)
    {
      const auto about_in = [&units](const char *kind, const double value) {
        const Conversion &unit = units.of(kind);
        return about(unit(value)) + (unit.unit.empty() ? "" : " " + unit.unit);
      };
      std::string line = "about t = " + about_in("time", impact.time) +
                         ", velocity " + about_in("velocity", impact.velocity);
      if (impact.penetration > 0.)
        line += ", peak penetration " + about_in("length", impact.penetration) +
                ", peak force " + about_in("force", impact.force);
      return line;
    }



    std::string
    describe_critical_step(const double critical, const Scene &scene)
    {
      const TimeParameters &time = scene.parameters.time;
      const bool fails = scene.is_fixed_point && !time.has_error_control() &&
                         *time.step_size > critical;
      const OutputUnits units(scene.parameters);
      return text("the paper's iteration fails in contact for dt > ",
                  units.text("time", critical),
                  fails                ? text(", as the ",
                               units.text("time", *time.step_size),
                               " of this run") :
                  scene.is_fixed_point ? "" :
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
        return (cost.is_driven ? "perhaps " : "about ") + about(n);
      };
      std::string line = count(cost.steps) +
                         " steps; contact.csv: " + count(cost.rows) +
                         " rows, " + describe_bytes(cost.row_bytes);
      if (cost.snapshots > 0.)
        line += "; fields: " + count(cost.snapshots) + " snapshots, " +
                describe_bytes(cost.snapshot_bytes);
      if (cost.face_bytes > 0.)
        line += "; contact face: as many, " + describe_bytes(cost.face_bytes);
      return line;
    }



    /** What can be said of a run before it is made. */
    void
    report_forecast(const Scene       &scene,
                    const double       n_cells,
                    const LoadHistory &loads,
                    Log               &log)
    {
      log.line("  scales    " + describe_scales(scene));
      log.line("  at rest   " + describe_rest(scene));
      if (const auto impact = first_impact(scene))
        log.line("  impact    " +
                 describe_impact(*impact, OutputUnits(scene.parameters)));
      if (const auto critical = critical_step_size(scene))
        log.line("  limit     " + describe_critical_step(*critical, scene));
      if (const auto cost = expected_cost(scene, n_cells, &loads))
        log.line("  expected  " + describe_cost(*cost));
      if (scene.parameters.output.has_error_bars)
        log.line("  repeats   " + describe_repeats(scene.parameters));
    }
  } // namespace



  std::string
  describe_steady_state(const SteadyState &state, const Scene &scene)
  {
    const OutputUnits        units(scene.parameters);
    std::vector<std::string> words;
    if (scene.fields.has_displacement)
      words.push_back("u(1) = " + units.text("length", state.displacement_end));
    if (scene.fields.has_temperature)
      words.push_back("theta(1) = " +
                      units.text("temperature", state.temperature_end));
    if (scene.contact.law->is_active())
      words.push_back("force " + units.text("force", state.contact_force) +
                      (state.in_contact ? ", in contact" : ", open"));
    return join_words(words);
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
    const Scene      &scene    = simulation.scene();
    const Material   &material = scene.material;
    const OutputUnits units(scene.parameters);
    if (!scene.parameters.title.empty())
      log.line(scene.parameters.title);
    if (units.is_si())
      log.line("  units     " + units.description());
    log.line("  body      " + describe_body(simulation));
    log.line("  unknowns  " + describe_unknowns(simulation));
    if (dim > 1)
      {
        log.line("  solver    " + describe_linear_solver(scene.linear_solver));
        report_memory(scene, simulation.discretization().communicator(), log);
      }
    log.line("  terms     " + join_words(scene_terms(scene)));
    if (scene.fields.has_displacement)
      log.line(
        "  model     " +
        join_words({scene.fields.has_temperature ?
                      text("a = ", material.thermal_stress) :
                      "",
                    text("b = ", material.inertia),
                    text("zeta = ", material.viscosity),
                    dim == 1 ?
                      "" :
                      text("nu = ", scene.parameters.model.poisson_ratio)}));
    if (scene.fields.has_temperature)
      log.line(
        "  heat      " +
        join_words(
          {"theta_A = " +
             (scene.sources.has_driven_temperature ?
                scene.heat.fixed_end_drive->text() :
                units.text("temperature", scene.heat.fixed_end_temperature)),
           scene.heat.exchange->description(),
           "theta_obs = " +
             (scene.sources.has_varying_obstacle ?
                scene.parameters.boundary.obstacle_expression :
                units.text("temperature", scene.heat.obstacle_temperature)),
           scene.heat.has_lateral_exchange() ?
             text("m = ",
                  scene.heat.lateral_exchange,
                  ", theta_inf = ",
                  units.text("temperature", scene.heat.ambient_temperature)) :
             ""}));
    if (scene.sources.has_moving_end)
      log.line("  fixed end u_A = " + scene.fixed_end_motion->text());
    if (scene.fields.has_displacement)
      log.line("  contact   " + describe_contact(simulation));
    log.line("  time      " + describe_time(scene));
    if (!simulation.loads().is_empty())
      log.line("  loads     " + describe_loads(simulation.loads(), units));
    report_forecast(scene,
                    simulation.discretization().n_active_cells(),
                    simulation.loads(),
                    log);
    report_warnings(simulation.history().warnings, 0, log);
  }



  void
  check_cost(const Scene       &scene,
             const double       n_cells,
             const LoadHistory &loads,
             const double       free_bytes,
             const bool         is_forced,
             Log               &log)
  {
    const auto cost = expected_cost(scene, n_cells, &loads);
    if (!cost)
      return;
    const double bytes =
      cost->row_bytes + cost->snapshot_bytes + cost->face_bytes;
    const std::string remedy =
      "Output/Contact interval and a larger Fields interval";
    if (cost->steps > most_steps)
      log.line("  doubt     about " + about(cost->steps) +
               " steps: is Time/End time that long?");
    if (bytes > free_bytes && !is_forced)
      throw InputError(
        "the files of the run would have " + describe_bytes(bytes) +
        ", and the disk of "
        "Output/Directory has " +
        describe_bytes(free_bytes) + " left\n  remedy:  " + remedy +
        ", or --force if they are taken away meanwhile");
    if (bytes > most_bytes)
      log.line("  doubt     the files of the run will have " +
               describe_bytes(bytes) + ": fewer with " + remedy);
  }



  template void
  report_scene<1>(const Simulation<1> &, Log &);
  template void
  report_scene<2>(const Simulation<2> &, Log &);
  template void
  report_scene<3>(const Simulation<3> &, Log &);
} // namespace ThermoContact
