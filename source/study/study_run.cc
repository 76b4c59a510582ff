// SPDX-License-Identifier: LGPL-2.1-or-later

#include <thermocontact/base/exceptions.h>
#include <thermocontact/output/output.h>
#include <thermocontact/output/output_directory.h>
#include <thermocontact/report/result_report.h>
#include <thermocontact/report/summary.h>
#include <thermocontact/scene/scene_checks.h>
#include <thermocontact/simulation/simulation.h>
#include <thermocontact/study/study_run.h>

#include <deal.II/base/timer.h>

#include <algorithm>
#include <memory>
#include <set>

namespace ThermoContact
{
  namespace
  {
    /** Entries that used.prm of a single run leaves out: the study is not its
     * own. */
    std::set<std::string>
    foreign_entries(const Scene &scene, const ParameterHandler &prm)
    {
      std::set<std::string> paths = unused_paths(scene);
      for (const auto &[path, value] : entry_values(prm))
        if (path.rfind("Study/", 0) == 0)
          paths.insert(path);
      return paths;
    }



    /** The same as in summary.json of the scene run alone. */
    template <int dim>
    std::vector<std::string>
    all_warnings(const Simulation<dim> &simulation)
    {
      const Scene &scene = simulation.scene();
      return run_warnings(scene,
                          scene.parameters.time.step_size ?
                            first_impact(scene) :
                            std::nullopt,
                          simulation.history());
    }



    /** Runs a scene once. */
    template <int dim>
    void
    run_scene(const Scene       &scene,
              SharedSpaces      &spaces,
              const std::string &directory,
              const SignalWatch &signals,
              StudyRun          &run)
    {
      RunTimes        times;
      const Timer     since_start;
      Simulation<dim> simulation(scene, MPI_COMM_SELF, &spaces.get<dim>(scene));
      times.set_up = since_start.wall_time();
      std::unique_ptr<Output<dim>> output;
      run.trajectory                                = Trajectory();
      typename Simulation<dim>::Observers observers = {
        [&](const Simulation<dim> &s) {
          run.trajectory.add(s.record());
          for (const StepAttempt &attempt : s.history().attempts)
            times.steps += attempt.wall_seconds;
          if (const int signal = signals.signal())
            throw Interruption(name_of_signal(signal));
        }};
      if (!directory.empty())
        {
          output = std::make_unique<Output<dim>>(directory, simulation);
          observers.push_back(
            [&](const Simulation<dim> &s) { output->observe(s); });
        }

      const Timer timer;
      const auto  finish = [&](const std::string &status) {
        times.output = output ? output->output_seconds() : 0.;
        times.loop   = timer.wall_time() - times.output;
        times.wall   = since_start.wall_time();
        run.loop_seconds.push_back(times.loop);
        const SolverCounters counters = simulation.counters();
        run.counts                    = {{"dofs",
                                          simulation.discretization().dof_handler().n_dofs()},
                                         {"steps", simulation.record().step},
                                         {"rejected_steps", simulation.history().n_rejected_steps},
                                         {"factorizations", counters.factorizations},
                                         {"solves", counters.solves}};
        run.trajectory.set_events(simulation.events());
        run.warnings = all_warnings(simulation);
        if (output)
          write_summary(directory + "/summary.json",
                        status,
                        simulation,
                        Forecast(simulation.scene(), simulation.loads()),
                        times);
      };
      try
        {
          simulation.run(observers);
          if (output)
            output->finish();
        }
      catch (const Interruption &)
        {
          throw;
        }
      catch (const ComputationError &error)
        {
          if (output)
            output->observe_failure(simulation);
          try
            {
              finish(std::string("failed: ") + error.what());
            }
          catch (const ComputationError &)
            {} // the first fault is the one to tell, e.g. a full disk
          throw;
        }
      finish("done");
      run.key_results = key_results(simulation.scene(), simulation.history());
    }
  } // namespace



  StudyRun
  StudyRunner::execute(const Overrides   &overrides,
                       const unsigned int n_repetitions,
                       const std::string &directory)
  {
    StudyRun run;
    try
      {
        const auto   own   = plan.read_scene(overrides, reader);
        const Scene &scene = *own;
        run.scales         = scene.parameters.scales;
        if (!directory.empty())
          {
            prepare_output_directory(directory, MPI_COMM_SELF);
            write_used_parameters(directory,
                                  foreign_entries(scene, reader.prm()),
                                  reader.prm(),
                                  reader.assignments(),
                                  scene.scheme_choice,
                                  MPI_COMM_SELF);
          }
        for (unsigned int i = 0; i < n_repetitions; ++i)
          if (scene.parameters.dimension == 1)
            run_scene<1>(scene, spaces, directory, signals, run);
          else if (scene.parameters.dimension == 2)
            run_scene<2>(scene, spaces, directory, signals, run);
          else
            run_scene<3>(scene, spaces, directory, signals, run);
      }
    catch (const Interruption &)
      {
        throw;
      }
    catch (const std::bad_alloc &)
      {
        run.failure = "not enough memory\n  remedy:  a coarser mesh";
      }
    catch (const std::exception &error)
      {
        run.failure = error.what();
      }
    std::sort(run.loop_seconds.begin(), run.loop_seconds.end());
    return run;
  }
} // namespace ThermoContact
