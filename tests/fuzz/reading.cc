// SPDX-License-Identifier: LGPL-2.1-or-later

#include <thermocontact/base/exceptions.h>
#include <thermocontact/input/parameter_file.h>
#include <thermocontact/input/units.h>
#include <thermocontact/output/output.h>
#include <thermocontact/output/output_directory.h>
#include <thermocontact/report/scene_report.h>
#include <thermocontact/report/summary.h>
#include <thermocontact/scene/scales_checks.h>
#include <thermocontact/scene/scene_checks.h>
#include <thermocontact/study/error_bars.h>
#include <thermocontact/study/study_plan.h>

#include "reading.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <sstream>
#include <stdexcept>

namespace ThermoContact
{
  namespace
  {
    namespace fs = std::filesystem;

    constexpr unsigned int n_first_steps = 20;



    std::vector<Assignment>
    parse(const std::string &text)
    {
      std::istringstream stream(text);
      return read_assignments(stream, "fuzz.prm");
    }



    /** All entries of a scene with their values, as used.prm has them. */
    std::string
    all_entries(const std::vector<Assignment> &assignments)
    {
      Parameters       parameters;
      ParameterHandler prm;
      parameters.add_parameters(prm);
      assign_entries(assignments, prm);
      std::ostringstream all;
      write_entries(declared_entries(prm), {}, all);
      return all.str();
    }



    /** Matrices that take long, and are not what is tested here. */
    bool
    is_large(const Parameters &parameters)
    {
      const MeshParameters &mesh = parameters.mesh;
      const double          n_cells =
        std::ldexp(mesh.cells, mesh.refinements) *
        std::pow(std::ldexp(mesh.cells_across, mesh.refinements),
                 parameters.dimension - 1.);
      const double n_per_cell =
        std::pow(mesh.degree + 1., parameters.dimension) *
        (1. + parameters.dimension);
      return n_cells * n_per_cell * n_per_cell > 2e6;
    }



    /** Ends a run from an observer. */
    struct Enough
    {};



    /** The first steps, with all files; those of repeats, too. */
    void
    begin_run(Simulation<1> &simulation, const std::string &directory)
    {
      fs::remove_all(directory);
      fs::create_directories(directory);
      const auto count = [n = 0u]() mutable {
        if (++n > n_first_steps)
          throw Enough();
      };
      {
        Output<1> output(directory, simulation);
        try
          {
            simulation.run(
              {[&](const Simulation<1> &s) { output.observe(s); },
               [tick = count](const Simulation<1> &) mutable { tick(); }});
            output.finish();
          }
        catch (const Enough &)
          {}
      }
      write_summary(directory + "/summary.json", "done", simulation, {});
      if (!simulation.parameters().output.has_error_bars)
        return;
      Log quiet(false, true);
      try
        {
          error_bars<1>(
            simulation, [tick = count]() mutable { tick(); }, quiet);
        }
      catch (const Enough &)
        {}
    }



    template <int dim>
    void
    set_up(const Parameters &parameters, const std::string &, Reading &)
    {
      Log quiet(false, true);
      report_scene(Simulation<dim>(parameters, MPI_COMM_SELF), quiet);
    }

    template <>
    void
    set_up<1>(const Parameters  &parameters,
              const std::string &scratch,
              Reading           &reading)
    {
      Simulation<1> simulation(parameters, MPI_COMM_SELF);
      Log           quiet(false, true);
      report_scene(simulation, quiet);
      if (scratch.empty())
        return;
      reading.has_begun = true;
      begin_run(simulation, scratch);
    }



    void
    check_one(const Parameters       &parameters,
              const ParameterHandler &prm,
              const std::string      &scratch,
              Reading                &reading)
    {
      check_unused_entries(parameters, prm);
      check_scene(parameters);
      reading.is_large = is_large(parameters);
      if (reading.is_large)
        return;
      if (parameters.dimension == 1)
        set_up<1>(parameters, scratch, reading);
      else if (parameters.dimension == 2)
        set_up<2>(parameters, scratch, reading);
      else
        set_up<3>(parameters, scratch, reading);
    }



    /** The first runs of a study, none of them made. */
    void
    check_plan(const Parameters              &parameters,
               const std::vector<Assignment> &assignments)
    {
      check_scales(parameters);
      check_error_bars(parameters);
      const StudyPlan plan(assignments, parameters.study);
      SceneReader     reader(plan.scene_assignments());
      for (unsigned int run = 0; run < std::min(plan.n_runs(), 10u); ++run)
        plan.read_scene(plan.overrides(run), reader);
    }



    void
    check(const std::vector<Assignment> &assignments,
          const std::string             &scratch,
          Reading                       &reading)
    {
      Parameters       parameters;
      ParameterHandler prm;
      parameters.add_parameters(prm);
      assign_entries(assignments, prm);
      try
        {
          reading.is_study = parameters.study.is_active();
          if (reading.is_study)
            check_plan(parameters, assignments);
          else
            check_one(parameters, prm, scratch, reading);
          if (!parameters.output.directory.empty())
            check_output_directory(parameters.output.directory, MPI_COMM_SELF);
        }
      catch (const InputError &error)
        {
          throw InputError(complete_message(error.what(), assignments, prm));
        }
    }
  } // namespace



  std::vector<std::string>
  valid_files()
  {
    std::vector<fs::path> paths;
    for (const auto &entry : fs::recursive_directory_iterator(PRM_DIR))
      if (entry.path().extension() == ".prm")
        paths.push_back(entry.path());
    std::sort(paths.begin(), paths.end());
    std::vector<std::string> texts, scenes;
    for (const fs::path &path : paths)
      {
        texts.push_back(read_text(path));
        if (const auto rod = parse(texts.back()); is_rod_in_units(rod))
          scenes.push_back(scene_from_units(path, rod).text);
      }
    texts.insert(texts.end(), scenes.begin(), scenes.end());

    const Assignment plane{"", "Dimension", "2"};
    texts.push_back(all_entries({}));
    texts.push_back(all_entries({plane}));
    texts.push_back(all_entries(parse(scenes.front())));
    for (const char *const path : {"paper/experiment-1.prm",
                                   "examples/shaken-base.prm",
                                   "units/steel-impact.prm"})
      texts.push_back(read_text(fs::path(PRM_DIR) / path) +
                      "subsection Output\n  set Error bars = true\nend\n");
    return texts;
  }



  Reading
  read_as_program(const std::string &text, const std::string &scratch)
  {
    Reading                 reading;
    std::vector<Assignment> assignments = parse(text);
    reading.is_rod_in_units             = is_rod_in_units(assignments);
    if (reading.is_rod_in_units)
      assignments = scene_from_units("fuzz.prm", assignments).assignments;
    check(assignments, scratch, reading);
    const std::string written = all_entries(assignments);
    if (all_entries(parse(written)) != written)
      throw std::logic_error("used.prm reads differently:\n" + written);
    return reading;
  }
} // namespace ThermoContact
