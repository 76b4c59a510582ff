// SPDX-License-Identifier: LGPL-2.1-or-later

#include <thermocontact/base/exceptions.h>
#include <thermocontact/forecast/expected_memory.h>
#include <thermocontact/input/parameter_file.h>
#include <thermocontact/input/si_scene.h>
#include <thermocontact/output/output_directory.h>
#include <thermocontact/report/scene_report.h>
#include <thermocontact/scene/scene_checks.h>
#include <thermocontact/study/study_plan.h>

#include "reading.h"

#include <algorithm>
#include <cmath>
#include <sstream>
#include <stdexcept>

#include "entries.h"
#include "first_steps.h"

namespace ThermoContact
{
  namespace
  {
    /** Memory that bodies may need, whatever this machine has. */
    constexpr double bytes_here = 8e9;

    /** About how many entries the matrices have. */
    double
    matrix_size(const Parameters &parameters)
    {
      const MeshParameters &mesh = parameters.mesh;
      const double          n_cells =
        std::ldexp(mesh.cells, mesh.refinements) *
        std::pow(std::ldexp(mesh.cells_across, mesh.refinements),
                 parameters.dimension - 1.);
      const double n_per_cell =
        std::pow(mesh.degree + 1., parameters.dimension) *
        (1. + parameters.dimension);
      return n_cells * n_per_cell * n_per_cell;
    }



    template <int dim>
    void
    set_up(const Parameters  &parameters,
           const std::string &scratch,
           Reading           &reading)
    {
      Simulation<dim> simulation(parameters, MPI_COMM_SELF);
      Log             quiet(false, true);
      report_scene(simulation, quiet);
      if (scratch.empty() || (dim > 1 && matrix_size(parameters) > 3e5))
        return;
      reading.has_begun = true;
      take_first_steps(simulation, scratch);
    }



    /** Unless its matrices take long, which are not what is tested here. */
    void
    set_up_small(const Parameters  &parameters,
                 const std::string &scratch,
                 Reading           &reading)
    {
      reading.dimension = parameters.dimension;
      reading.is_large  = matrix_size(parameters) > 2e6;
      if (reading.is_large)
        return;
      if (parameters.dimension == 1)
        set_up<1>(parameters, scratch, reading);
      else if (parameters.dimension == 2)
        set_up<2>(parameters, scratch, reading);
      else
        set_up<3>(parameters, scratch, reading);
    }



    void
    check_one(const Parameters       &parameters,
              const ParameterHandler &prm,
              const std::string      &scratch,
              Reading                &reading)
    {
      check_unused_entries(parameters, prm);
      check_scene(parameters);
      if (parameters.dimension > 1)
        check_memory(Scene(parameters), 1, bytes_here, 1.);
      set_up_small(parameters, scratch, reading);
    }



    /** The first runs of a study, and the start of the very first. */
    void
    check_plan(const Parameters              &parameters,
               const std::vector<Assignment> &assignments,
               const std::string             &scratch,
               Reading                       &reading)
    {
      check_scales(parameters);
      check_error_bars(parameters);
      const StudyPlan plan(assignments, parameters.study);
      SceneReader     reader(plan.scene_assignments());
      for (unsigned int run = 0; run < std::min(plan.n_runs(), 10u); ++run)
        plan.read_scene(plan.overrides(run), reader);
      plan.read_scene(plan.overrides(0), reader);
      set_up_small(reader.scene(), scratch, reading);
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
            check_plan(parameters, assignments, scratch, reading);
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



    /** A scene that is printed can be read. */
    void
    assign_again(const std::string &scene)
    {
      try
        {
          all_entries(statements(scene));
        }
      catch (const InputError &error)
        {
          throw std::logic_error(error.what() +
                                 ("\nis said of the scene\n" + scene));
        }
    }



    /** Those of a scene with another value than the default. */
    void
    add_entries(const std::vector<Assignment> &assignments, Reading &reading)
    {
      Parameters       parameters;
      ParameterHandler prm;
      parameters.add_parameters(prm);
      assign_entries(assignments, prm);
      for (const DeclaredEntry &entry : declared_entries(prm))
        if (!equal_values(entry.value, entry.default_value))
          reading.entries[entry.path] = entry.value;
    }
  } // namespace



  std::vector<std::string>
  paths_read()
  {
    std::vector<std::string> paths;
    Parameters               parameters;
    ParameterHandler         prm;
    parameters.add_parameters(prm);
    for (const DeclaredEntry &entry : declared_entries(prm))
      paths.push_back(entry.path);
    return paths;
  }



  std::string
  all_entries(const std::vector<Assignment> &assignments)
  {
    Parameters       parameters;
    ParameterHandler prm;
    parameters.add_parameters(prm);
    assign_entries(assignments, prm);
    std::vector<DeclaredEntry> entries = declared_entries(prm);
    if (is_in_si(assignments))
      add_units(assignments, entries);
    std::ostringstream all;
    write_entries(entries, {}, all);
    return all.str();
  }



  std::string
  scene_without_units(const std::vector<Assignment> &assignments)
  {
    Parameters       parameters;
    ParameterHandler prm;
    parameters.add_parameters(prm);
    assign_entries(assignments, prm);
    std::vector<DeclaredEntry> entries = declared_entries(prm);
    remove_units(assignments, entries);
    std::ostringstream scene;
    write_entries(entries, {}, scene);
    return scene.str();
  }



  Reading
  read_as_program(const std::string &text, const std::string &scratch)
  {
    Reading                 reading;
    std::vector<Assignment> assignments = statements(text);
    reading.is_rod_in_units             = is_in_si(assignments);
    if (reading.is_rod_in_units)
      assign_again(scene_without_units(assignments));
    check(assignments, scratch, reading);
    const std::string written = all_entries(assignments);
    if (all_entries(statements(written)) != written)
      throw std::logic_error("used.prm reads differently:\n" + written);
    add_entries(assignments, reading);
    return reading;
  }
} // namespace ThermoContact
