// SPDX-License-Identifier: LGPL-2.1-or-later

#include <thermocontact/base/exceptions.h>
#include <thermocontact/base/long_message.h>
#include <thermocontact/output/output.h>
#include <thermocontact/output/output_directory.h>
#include <thermocontact/scene/scene_checks.h>
#include <thermocontact/simulation/simulation.h>
#include <thermocontact/study/study.h>

#include <deal.II/base/timer.h>

#include <boost/serialization/array.hpp>
#include <boost/serialization/string.hpp>
#include <boost/serialization/vector.hpp>

#include <algorithm>
#include <set>
#include <sstream>

namespace ThermoContact
{
  namespace
  {
    using Overrides = std::vector<std::pair<std::string, std::string>>;

    const char *const notation =
      "\n  allowed: Section/Entry = value | value ; Section/Entry = value | ...";



    /** The parts of @p text between separators, trimmed. */
    std::vector<std::string>
    split_at(const std::string &text, const std::string &separator)
    {
      std::vector<std::string> parts;
      std::size_t              begin = 0;
      while (true)
        {
          const auto end = text.find(separator, begin);
          parts.push_back(Utilities::trim(text.substr(begin, end - begin)));
          if (end == std::string::npos)
            return parts;
          begin = end + separator.size();
        }
    }



    /** An entry and the values that it is to have, one after the other. */
    struct Variation
    {
      std::string              path;
      std::vector<std::string> values;
    };

    Variation
    read_variation(const std::string &entry, const std::string &text)
    {
      const auto fail = [&](const std::string &fault) {
        throw InputError("Study/" + entry + ": " + fault + " in '" +
                         quote(text) + "'" + notation);
      };
      const auto equal_sign = text.find('=');
      if (equal_sign == std::string::npos)
        fail("no '='");
      const Variation variation = {Utilities::trim(text.substr(0, equal_sign)),
                                   split_at(text.substr(equal_sign + 1), "|")};
      if (variation.path.empty() || variation.path.back() == '/')
        fail("no entry before '='");
      if (variation.path.rfind("Study/", 0) == 0 ||
          variation.path == "Output/Directory")
        fail("an entry that is the study's own");
      for (const std::string &value : variation.values)
        if (value.empty())
          fail("an empty value");
      return variation;
    }



    /** All combinations of the values, the last entry varying fastest. */
    std::vector<Overrides>
    combine(const std::vector<Variation> &variations)
    {
      std::vector<Overrides> combinations(1);
      for (const Variation &variation : variations)
        {
          std::vector<Overrides> longer;
          for (const Overrides &combination : combinations)
            for (const std::string &value : variation.values)
              {
                longer.push_back(combination);
                longer.back().emplace_back(variation.path, value);
              }
          combinations.swap(longer);
        }
      return combinations;
    }



    /** The value of an entry "Section/Entry". */
    std::string
    value_of(const std::string &path, ParameterHandler &prm)
    {
      const auto slash = path.find('/');
      if (slash == std::string::npos)
        return prm.get(path);
      prm.enter_subsection(path.substr(0, slash));
      const std::string value = prm.get(path.substr(slash + 1));
      prm.leave_subsection();
      return value;
    }



    /** Checks a scene; what a run overrides must have an effect in it. */
    void
    check_run(const StudyRun &run, const Parameters &scene)
    {
      for (const auto &unused : unused_entries(scene))
        for (const auto &[path, value] : run.overrides)
          if (unused.path == path)
            throw InputError(path + " = " + value + " has no effect, since " +
                             unused.reason);
      check_scene(scene);
    }



    /** What used.prm of a single run leaves out: the study is not its own. */
    std::set<std::string>
    foreign_entries(const Parameters &scene)
    {
      std::set<std::string> paths = {"Study/Vary",
                                     "Study/Reference",
                                     "Study/Repetitions",
                                     "Study/Target error",
                                     "Study/Keep files"};
      for (const auto &unused : unused_entries(scene))
        paths.insert(unused.path);
      return paths;
    }



    /** Runs a scene once. */
    template <int dim>
    void
    run_scene(const Parameters  &parameters,
              const std::string &directory,
              StudyRun          &run)
    {
      Simulation<dim>              simulation(parameters, MPI_COMM_SELF);
      std::unique_ptr<Output<dim>> output;
      run.trajectory                                = Trajectory();
      typename Simulation<dim>::Observers observers = {
        [&](const Simulation<dim> &s) { run.trajectory.add(s.record()); }};
      if (!directory.empty())
        {
          output = std::make_unique<Output<dim>>(directory, simulation);
          observers.push_back(
            [&](const Simulation<dim> &s) { output->observe(s); });
        }

      const Timer timer;
      const auto  finish = [&]() {
        const double seconds =
          timer.wall_time() - (output ? output->output_seconds() : 0.);
        run.loop_seconds.push_back(seconds);
        run.n_dofs  = simulation.discretization().dof_handler().n_dofs();
        run.n_steps = simulation.record().step;
        run.n_rejected_steps = simulation.history().n_rejected_steps;
        run.n_factorizations = simulation.counters().factorizations;
        run.n_solves         = simulation.counters().solves;
        run.trajectory.set_events(simulation.events());
      };
      try
        {
          simulation.run(observers);
          if (output)
            output->finish();
        }
      catch (const ComputationError &)
        {
          finish();
          if (output)
            output->observe_failure(simulation);
          throw;
        }
      finish();
    }
  } // namespace



  Study::Study(const std::vector<Assignment> &assignments,
               const StudyParameters         &parameters)
    : assignments(assignments)
    , parameters_(parameters)
  {
    unsigned int n_sets = 0;
    for (const std::string &set : split_at(parameters.vary, ";;"))
      {
        std::vector<Variation> variations;
        for (const std::string &text : split_at(set, ";"))
          {
            variations.push_back(read_variation("Vary", text));
            const std::string &path = variations.back().path;
            if (std::find(varied_.begin(), varied_.end(), path) ==
                varied_.end())
              varied_.push_back(path);
          }
        for (const Overrides &overrides : combine(variations))
          {
            runs_.emplace_back();
            runs_.back().overrides = overrides;
            runs_.back().set       = n_sets;
          }
        ++n_sets;
      }
    if (parameters.reference == "none")
      {
        if (parameters.target_error > 0.)
          throw InputError("Study/Target error: there is no reference to "
                           "measure errors against\n  remedy:  Study/Reference "
                           "= Time/Tolerance = 1e-9, or another run that is "
                           "much more accurate");
      }
    else
      {
        reference.emplace();
        for (const std::string &text : split_at(parameters.reference, ";"))
          {
            const Variation variation = read_variation("Reference", text);
            if (variation.values.size() > 1)
              throw InputError("Study/Reference: several values in '" +
                               quote(text) +
                               "'\n  allowed: one value per entry");
            reference->overrides.emplace_back(variation.path,
                                              variation.values[0]);
          }
      }

    double longest = 0.;
    for (StudyRun &run : runs_)
      {
        Parameters       scene;
        ParameterHandler prm;
        scene.add_parameters(prm);
        assign(run, prm);
        longest = std::max(longest, scene.time.end_time);
        for (const std::string &path : varied_)
          run.entries.push_back(value_of(path, prm));
      }
    if (reference)
      check_reference(longest);
  }



  void
  Study::check_reference(const double longest) const
  {
    Parameters       scene;
    ParameterHandler prm;
    scene.add_parameters(prm);
    assign(*reference, prm);
    try
      {
        check_run(*reference, scene);
      }
    catch (const InputError &error)
      {
        throw InputError(std::string("Study/Reference: ") + error.what());
      }
    if (scene.time.end_time < longest)
      throw InputError(
        "Study/Reference: it ends at t = " + value_of("Time/End time", prm) +
        ", before the longest run\n  remedy:  give it the "
        "largest Time/End time of all runs");
  }



  void
  Study::assign(const StudyRun &run, ParameterHandler &prm) const
  {
    const bool is_reference =
      reference && run.overrides == reference->overrides;
    const std::string place = is_reference ? "Study/Reference" : "Study/Vary";
    std::set<std::string>   overridden;
    std::vector<Assignment> all;
    for (const auto &[path, value] : run.overrides)
      if (!overridden.insert(path).second)
        throw InputError(place + ": " + quote(path) +
                         " twice in one run\n  remedy:  name each entry once");
    for (const Assignment &assignment : assignments)
      if (overridden.count(assignment.path) == 0)
        all.push_back(assignment);
    for (const auto &[path, value] : run.overrides)
      all.push_back({place, path, value});
    assign_entries(all, prm);
  }



  void
  Study::execute(StudyRun          &run,
                 const unsigned int n_repetitions,
                 const std::string &directory) const
  {
    try
      {
        Parameters       scene;
        ParameterHandler prm;
        scene.add_parameters(prm);
        assign(run, prm);
        check_run(run, scene);
        if (!directory.empty())
          {
            prepare_output_directory(directory, MPI_COMM_SELF);
            write_used_parameters(directory,
                                  foreign_entries(scene),
                                  prm,
                                  MPI_COMM_SELF);
          }
        for (unsigned int i = 0; i < n_repetitions; ++i)
          if (scene.dimension == 1)
            run_scene<1>(scene, directory, run);
          else if (scene.dimension == 2)
            run_scene<2>(scene, directory, run);
          else
            run_scene<3>(scene, directory, run);
      }
    catch (const InputError &error)
      {
        run.failure = error.what();
      }
    catch (const ComputationError &error)
      {
        run.failure = error.what();
      }
    std::sort(run.loop_seconds.begin(), run.loop_seconds.end());
  }



  void
  Study::run(const std::string &directory)
  {
    const MPI_Comm     communicator = MPI_COMM_WORLD;
    const unsigned int n_ranks = Utilities::MPI::n_mpi_processes(communicator);
    const unsigned int this_rank =
      Utilities::MPI::this_mpi_process(communicator);

    // The reference is the longest run: first, and the last rank's, so that the
    // others begin with the rest.
    if (reference && this_rank == n_ranks - 1)
      execute(*reference, 1, "");
    for (unsigned int i = this_rank; i < runs_.size(); i += n_ranks)
      execute(runs_[i],
              parameters_.repetitions,
              parameters_.keep_files ? directory + "/run-" + std::to_string(i) :
                                       "");

    for (unsigned int i = 0; i < runs_.size(); ++i)
      send_object_to_first(i % n_ranks, runs_[i], communicator);
    if (reference)
      send_object_to_first(n_ranks - 1, *reference, communicator);
    std::string fault;
    if (this_rank == 0 && reference && !reference->failure.empty())
      fault = "Study/Reference: the run failed: " + reference->failure;
    throw_everywhere<ComputationError>(fault, communicator);
    if (reference && this_rank == 0)
      for (StudyRun &run : runs_)
        if (run.failure.empty())
          run.error = run.trajectory.compare(reference->trajectory);
  }
} // namespace ThermoContact
