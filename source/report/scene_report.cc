// SPDX-License-Identifier: LGPL-2.1-or-later

#include <thermocontact/base/exceptions.h>
#include <thermocontact/base/machine_memory.h>
#include <thermocontact/base/special_numbers.h>
#include <thermocontact/base/text.h>
#include <thermocontact/input/si_scene.h>
#include <thermocontact/output/output_units.h>
#include <thermocontact/report/scene_report.h>
#include <thermocontact/scene/coarser_scenes.h>

#include <algorithm>
#include <cmath>

namespace ThermoContact
{
  namespace
  {
    // a run of a day, a disk of a phone
    constexpr double most_steps = 1e8, most_bytes = 1e10;



    /** The bodies of a row, from the left. */
    std::string
    describe_row(const Scene &scene, const OutputUnits &units)
    {
      std::vector<std::string> bodies;
      for (const BodyParameters &body : scene.parameters.row.bodies)
        bodies.push_back(body.name +
                         (body.is_mass() ?
                            " (mass " + units.text("mass", body.mass) + ")" :
                            text(" (rod of length ",
                                 units.text("position", body.length),
                                 ", ",
                                 body.cells,
                                 " cells",
                                 RodProfile(scene.parameters, body).varies() ?
                                   ", coefficients vary" :
                                   "",
                                 ")")));
      return join_words({join_words(bodies),
                         text("degree ", scene.parameters.mesh.degree),
                         scene.fields.has_displacement && scene.has_free_end ?
                           "x = 0: free" :
                           ""});
    }



    /** The mass that is the obstacle. */
    std::string
    describe_obstacle(const Scene &scene, const OutputUnits &units)
    {
      const ObstacleMass &mass = *scene.obstacle_mass;
      const auto          part =
        [&units](const char *name, const char *kind, const double value) {
          return value == 0. ? "" : name + units.text(kind, value);
        };
      return join_words(
        {scene.parameters.obstacle_mass()->name + " of " +
           units.text("mass", mass.mass),
         part("velocity ", "velocity", mass.velocity),
         mass.heat_capacity ?
           "temperature " + units.text("temperature", mass.temperature) :
           "",
         part("spring ", "spring", mass.spring),
         part("dashpot ", "dashpot", mass.dashpot)});
    }



    std::string
    describe_body(const Scene &scene, const OutputUnits &units)
    {
      const MeshParameters &mesh = scene.parameters.mesh;
      const unsigned int    dim  = scene.parameters.dimension;
      return join_words(
        {scene.geometry->description([&units](const double length) {
           return units.text("position", length);
         }),
         text(significant(mesh.n_cells(dim), 12),
              " cells of degree ",
              mesh.degree,
              dim == 1 ? "" :
                         text(", sides 1 : ",
                              significant(mesh.cell_aspect(), few_digits))),
         dim == 1 ? "" :
                    "lateral faces: " + scene.parameters.boundary.sides.support,
         scene.has_sliding_end ? "fixed end: sliding" : "",
         scene.fields.has_displacement && scene.has_free_end ? "x = 0: free" :
                                                               "",
         scene.has_pins() ? "held across, without force, at corners of it" :
                            ""});
    }



    std::string
    describe_unknowns(const Scene &scene)
    {
      const unsigned int dim = scene.parameters.dimension;
      const double       n   = scene.parameters.mesh.n_nodes(dim);
      std::string        line;
      if (scene.fields.has_temperature)
        line = significant(n, 12) + " temperature";
      if (scene.fields.has_displacement)
        line += (line.empty() ? "" : " + ") + significant(dim * n, 12) +
                " displacement";
      return line;
    }



    /** How linear systems are solved, and what of this machine that takes. */
    void
    report_solver(const Scene &scene, const MPI_Comm communicator, Log &log)
    {
      const LinearSolver &solver = scene.linear_solver;
      log.line(text("  solver    ",
                    solver.name(),
                    ", since ",
                    solver.reason,
                    solver.is_iterative ?
                      text("; relative residual ", solver.tolerance) :
                      ""));
      const double expected =
        share_of_ranks_here(communicator) *
        expected_memory(scene, Utilities::MPI::n_mpi_processes(communicator));
      const double available = machine_memory();
      log.line("  memory    about " + gigabytes(expected) + ", here are " +
               gigabytes(available));
      if (expected > available)
        log.line(text("  warning:  that may not be enough memory",
                      solver.is_iterative ?
                        "" :
                        "; Solver/Linear solver = iterative takes less"));
    }



    std::string
    describe_time(const Scene &scene, const OutputUnits &units)
    {
      const TimeParameters &time = scene.parameters.time;
      return join_words(
        {time.scheme,
         time.has_error_control() ?
           text("error-controlled steps, tolerance ", time.tolerance) :
           text("dt = ",
                units.text("time", *time.step_size),
                ", ",
                time.n_steps(),
                " steps"),
         "T = " + units.text("time", time.end_time),
         scene.contact.locates_events ? "contact events located" : "",
         scene.has_prescribed_start ? "start of the paper" : "consistent start",
         scene.parameters.solver.step_solver + " solver"});
    }



    /** A number of things that have a plural in s. */
    std::string
    count(const std::size_t n, const std::string &name)
    {
      return text(n, ' ', name, n == 1 ? "" : "s");
    }



    /** The features of the loads that steps follow. */
    std::string
    describe_loads(const LoadHistory &loads, const OutputUnits &units)
    {
      const auto number = [&](const bool are_jumps) {
        return std::count_if(loads.breaks.begin(),
                             loads.breaks.end(),
                             [=](const LoadBreak &at) {
                               return at.ends_steps && at.is_jump == are_jumps;
                             });
      };
      std::string line = "steps end at " + count(number(true), "jump") +
                         " and " + count(number(false), "kink");
      double smallest = infinity;
      for (const LoadStretch &stretch : loads.stretches)
        smallest = std::min(smallest, stretch.width);
      if (!loads.stretches.empty())
        line += ", and are at most " + units.text("time", smallest) +
                " where loads change";
      return line;
    }



    /** A line for each steady state. */
    std::string
    describe_rest(const SteadyForecast &rest, const Scene &scene)
    {
      if (rest.states.empty())
        return rest.remark;
      std::string lines;
      for (const SteadyState &state : rest.states)
        lines += (lines.empty() ? "" : "\n            ") +
                 describe_steady_state(state, scene) +
                 (scene.heat.exchange->is_in_matrices() ? "" :
                  state.is_stable                       ? ", stable" :
                                                          ", unstable");
      return lines + (rest.remark.empty() ? "" : "; " + rest.remark);
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
      if (!std::isnan(impact.penetration))
        line += ", peak penetration " + about_in("length", impact.penetration) +
                ", peak force " + about_in("force", impact.force);
      return line;
    }



    std::string
    describe_critical_step(const double       critical,
                           const Scene       &scene,
                           const OutputUnits &units)
    {
      const TimeParameters &time = scene.parameters.time;
      const bool fails = scene.is_fixed_point && !time.has_error_control() &&
                         *time.step_size > critical;
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
        return (cost.is_least  ? "at least " :
                cost.is_driven ? "perhaps " :
                                 "about ") +
               about(n);
      };
      std::string line = count(cost.steps) +
                         " steps; contact.csv: " + count(cost.rows) +
                         " rows, " + describe_bytes(cost.row_bytes);
      if (cost.snapshots > 0.)
        line += "; fields: " + count(cost.snapshots) + " snapshots, " +
                describe_bytes(cost.snapshot_bytes);
      if (cost.face_bytes > 0.)
        line += "; contact face: as many, " + describe_bytes(cost.face_bytes);
      if (cost.cpu_seconds > 0.)
        line += "; processor time: about " + (cost.cpu_seconds < 100. ?
                                                about(cost.cpu_seconds) + " s" :
                                                clock_time(cost.cpu_seconds));
      return line;
    }
  } // namespace



  std::string
  at_end(const std::string &field, const Scene &scene)
  {
    return field + (scene.row.is_given() ? "(right end)" : "(1)");
  }



  std::string
  describe_steady_state(const SteadyState &state, const Scene &scene)
  {
    const OutputUnits        units(scene.parameters);
    std::vector<std::string> words;
    if (scene.fields.has_displacement)
      words.push_back(at_end("u", scene) + " = " +
                      units.text("length", state.displacement_end));
    if (scene.fields.has_temperature)
      words.push_back(at_end("theta", scene) + " = " +
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



  void
  report_scene(const Scene                   &scene,
               const LoadHistory             &loads,
               const Forecast                &forecast,
               const std::vector<Assignment> &assignments,
               const MPI_Comm                 communicator,
               Log                           &log)
  {
    const Material    &material = scene.material;
    const unsigned int dim      = scene.parameters.dimension;
    const OutputUnits  units(scene.parameters);
    const bool         has_units  = units.is_si() && is_in_si(assignments);
    const auto         as_written = [&](const std::string &path,
                                const std::string &in_scene) {
      const Assignment *const given = last_assignment(assignments, path);
      return has_units && given != nullptr ? given->value : in_scene;
    };
    if (!scene.parameters.title.empty())
      log.line(scene.parameters.title);
    if (units.is_si())
      log.line("  units     " + units.description());
    if (scene.row.is_given())
      log.line("  row       " + describe_row(scene, units));
    else
      log.line("  body      " + describe_body(scene, units));
    std::vector<std::string> coefficients;
    if (scene.profile)
      for (const auto &[name, value] :
           scene.profile->coefficients().own_entries())
        coefficients.push_back(
          name + " = " +
          as_written("Bodies/" + scene.parameters.row.bodies[0].name + "/" +
                       name,
                     value));
    if (!coefficients.empty())
      log.line("  material  " + join_words(coefficients));
    if (scene.obstacle_mass)
      log.line("  mass      " + describe_obstacle(scene, units));
    log.line("  unknowns  " + describe_unknowns(scene));
    if (dim > 1)
      report_solver(scene, communicator, log);
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
      {
        const SceneHeat  &heat = scene.heat;
        const std::string exchange =
          as_written("Boundary/right/Heat exchange", "");
        log.line(
          "  heat      " +
          join_words(
            {heat.has_given_temperature ?
               "theta_A = " +
                 (scene.sources.has_driven_temperature ?
                    as_written("Boundary/left/Temperature",
                               heat.fixed_end_drive->expression.text()) :
                    units.text("temperature", heat.fixed_end_temperature)) :
             heat.left_exchange > 0. ?
               "k_A = " + units.text("heat exchange", heat.left_exchange) +
                 ", theta_sA = " +
                 units.text("temperature", heat.fixed_end_temperature) :
             scene.sources.has_left_heat_flux ? "" :
                                                "x = 0: insulated",
             exchange.empty() ? heat.exchange->description() :
                                "k = " + exchange,
             scene.obstacle_mass ? "" : // it has one of its own
                                   "theta_obs = " +
                 (heat.obstacle_drive ?
                    as_written(
                      "Boundary/right/Surroundings",
                      scene.parameters.boundary.right.surroundings_expression) :
                    units.text("temperature", heat.obstacle_temperature)),
             heat.has_lateral_exchange() ?
               text("m = ",
                    heat.lateral_exchange,
                    ", theta_inf = ",
                    units.text("temperature", heat.ambient_temperature)) :
               ""}));
      }
    if (scene.sources.has_moving_end)
      log.line("  fixed end u_A = " +
               as_written("Boundary/left/Displacement",
                          scene.fixed_end_motion->expression.text()));
    if (scene.fields.has_displacement)
      {
        const SceneContact &contact = scene.contact;
        const bool          is_one  = contact.has_uniform_gap();
        std::string gap = is_one ? units.text("length", contact.gap) : "";
        if (scene.row.is_given())
          {
            std::vector<std::string> gaps;
            for (const RowContact &one : scene.row.contacts)
              gaps.push_back(units.text("length", one.gap) + " of " + one.name);
            if (scene.row.meets_obstacle)
              gaps.push_back(gap + " before the obstacle");
            gap = join_words(gaps);
          }
        if (!is_one || scene.sources.has_moving_obstacle)
          gap =
            as_written("Contact/Gap", scene.parameters.contact.gap_expression) +
            (is_one ? " (" + gap + " at t = 0)" : "");
        std::vector<std::string> pairs; // with laws of their own
        for (unsigned int i = 0; i < contact.pair_laws.size(); ++i)
          if (contact.pair_laws[i])
            pairs.push_back(scene.row.contacts[i].name + " " +
                            contact.pair_laws[i]->description());
        log.line(
          "  contact   " +
          join_words(
            {scene.row.is_given() && !contact.law->is_active() ?
               "none: bodies do not meet" :
             scene.parameters.uses_general_law() ? contact.law->description() :
                                                   "",
             contact.law->is_active() ? "g = " + gap : "",
             contact.law->is_active() && contact.is_two_sided() ?
               "g_2 = " + units.text("length", contact.rear_gap) :
               "",
             contact.rear_law ? "behind " + contact.rear_law->description() :
                                "",
             join_words(pairs),
             contact.law->is_active() && contact.has_massless_nodes ?
               "massless contact nodes" :
               ""}));
      }
    if (!scene.scheme_choice.reason.empty())
      log.line("  scheme    " + scene.scheme.name + ", since " +
               scene.scheme_choice.reason);
    log.line("  time      " + describe_time(scene, units));
    if (!loads.is_empty())
      log.line("  loads     " + describe_loads(loads, units));
    std::vector<std::string> scales;
    for (const auto &[name, value] : time_scales(scene))
      scales.push_back(name + ' ' + units.text("time", value));
    if (!scales.empty())
      log.line("  scales    " + join_words(scales) +
               (coefficients.empty() ? "" : ", of coefficients 1"));
    log.line("  steady    " + describe_rest(forecast.rest, scene));
    if (forecast.impact)
      log.line("  impact    " + describe_impact(*forecast.impact, units));
    if (forecast.critical_step)
      log.line("  limit     " +
               describe_critical_step(*forecast.critical_step, scene, units));
    log.line("  expected  " + describe_cost(forecast.cost));
    if (scene.parameters.output.has_error_bars)
      log.line("  repeats   " + describe_repeats(scene.parameters));
  }



  template <int dim>
  void
  report_set_up(const Simulation<dim> &simulation,
                const double           seconds,
                Log                   &log)
  {
    const Scene      &scene = simulation.scene();
    const OutputUnits units(scene.parameters);
    if (dim > 1)
      {
        log.line(text("  set up    in ",
                      significant(seconds, 2),
                      " s, factorised ",
                      scene.linear_solver.is_iterative ?
                        "on the coarsest level: " :
                        "at once: ",
                      simulation.n_factorized_unknowns()));
      }
    if (scene.contact.law->is_active() && !scene.contact.has_uniform_gap())
      {
        const auto &gaps = simulation.body().obstacle.gaps_at_start();
        const auto [smallest, largest] =
          std::minmax_element(gaps.begin(), gaps.end());
        log.line("  gap       " + units.text("length", *smallest) + " to " +
                 units.text("length", *largest) + " at the contact nodes" +
                 (scene.sources.has_moving_obstacle ? ", at t = 0" : ""));
      }
    report_warnings(simulation.history().warnings, 0, log);
  }



  void
  check_cost(const ExpectedCost &cost,
             const double        free_bytes,
             const bool          is_forced,
             Log                &log)
  {
    const double bytes = cost.row_bytes + cost.snapshot_bytes + cost.face_bytes;
    const std::string remedy =
      "Output/Contact interval and a larger Fields interval";
    if (cost.steps > most_steps)
      log.line("  doubt     about " + about(cost.steps) +
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
  report_set_up<1>(const Simulation<1> &, const double, Log &);
  template void
  report_set_up<2>(const Simulation<2> &, const double, Log &);
  template void
  report_set_up<3>(const Simulation<3> &, const double, Log &);
} // namespace ThermoContact
