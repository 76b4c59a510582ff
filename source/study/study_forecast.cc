// SPDX-License-Identifier: LGPL-2.1-or-later

#include <thermocontact/base/exceptions.h>
#include <thermocontact/base/machine_memory.h>
#include <thermocontact/base/text.h>
#include <thermocontact/forecast/forecast.h>
#include <thermocontact/space/load_scan.h>
#include <thermocontact/study/study.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <vector>

namespace ThermoContact
{
  namespace
  {
    /** As many scenes are read before a study; that takes a second. */
    constexpr unsigned int max_checked = 2000;



    struct RunMemory
    {
      std::string name;
      double      bytes;
    };



    /** Forecasts from the scenes of some runs and of the reference. */
    struct StudyForecast
    {
      std::vector<RunMemory> runs; ///< runs that have no row yet
      double                 bytes_of_reference = 0.;
      bool                   has_bodies         = false;
      double                 steps              = 0.;
      unsigned int           n_refused          = 0;
      std::string            refused; ///< the first ones, and why
    };



    template <int dim>
    LoadHistory
    loads_of(const Scene &scene)
    {
      std::vector<std::string> warnings; // the run will tell them
      return load_history(scene, ProblemData<dim>(scene), warnings);
    }



    /** Throws if the run of the scene cannot be run. */
    LoadHistory
    loads_of(const Scene &scene)
    {
      const unsigned int dim = scene.parameters.dimension;
      return dim == 1 ? loads_of<1>(scene) :
             dim == 2 ? loads_of<2>(scene) :
                        loads_of<3>(scene);
    }



    StudyForecast
    read_scenes(const StudyTable &table, const std::vector<unsigned int> &runs)
    {
      const StudyPlan &plan = table.plan;
      SceneReader      reader(plan.assignments);
      StudyForecast    forecast;
      const auto       read = [&](const Overrides &overrides) {
        auto scene = plan.read_scene(overrides, reader);
        forecast.has_bodies |= scene->parameters.dimension > 1;
        return scene;
      };
      for (const unsigned int run : runs)
        try
          {
            const auto scene = read(plan.overrides(run));
            if (!table.has(run))
              forecast.runs.push_back(
                {plan.description(run), expected_memory(*scene, 1)});
            forecast.steps += expected_cost(*scene, loads_of(*scene)).steps;
          }
        catch (const InputError &error)
          {
            if (++forecast.n_refused <= 3)
              forecast.refused +=
                "\n  " + plan.description(run) + ": " + error.what();
          }
      if (plan.reference)
        forecast.bytes_of_reference =
          expected_memory(*read(*plan.reference), 1);
      return forecast;
    }



    /** check_study_memory() of the forecast; collective. */
    std::string
    describe_memory(StudyForecast forecast)
    {
      const MPI_Comm     communicator       = MPI_COMM_WORLD;
      auto              &runs               = forecast.runs;
      const double       bytes_of_reference = forecast.bytes_of_reference;
      const SharedMemory memory             = scarcest_memory(communicator);
      if (!forecast.has_bodies)
        return "";
      const auto        n_here    = static_cast<std::size_t>(std::round(
        memory.share * Utilities::MPI::n_mpi_processes(communicator)));
      const std::size_t n_at_once = std::min(n_here, runs.size());

      std::stable_sort(runs.begin(),
                       runs.end(),
                       [](const RunMemory &a, const RunMemory &b) {
                         return a.bytes > b.bytes;
                       });
      double bytes = 0.;
      for (std::size_t i = 0; i < n_at_once; ++i)
        bytes += runs[i].bytes;
      std::vector<std::string> words;
      if (n_at_once > 0)
        words.push_back(gigabytes(runs[0].bytes) + " for " + runs[0].name);
      if (n_at_once > 1)
        words.push_back(text(gigabytes(bytes),
                             " for the ",
                             n_at_once,
                             " largest runs, which may be under way at the "
                             "same time"));
      if (bytes_of_reference > 0.)
        words.push_back(gigabytes(bytes_of_reference) + " for the reference");
      const std::string what        = join_words(words);
      const double      needed      = std::max(bytes, bytes_of_reference);
      const std::string fewer_ranks = n_at_once > 1 ? "fewer ranks, " : "";
      if (needed > 2. * memory.bytes)
        throw InputError(text(
          bytes > 2. * memory.bytes ? "Study/Vary" : "Study/Reference",
          ": the study takes, of memory here, about ",
          what,
          "; there are ",
          gigabytes(memory.bytes),
          "\n  allowed: less than twice the memory that there is, since the "
          "forecast may be off by as much\n  remedy:  ",
          fewer_ranks,
          "fewer Mesh/Cells, a lower Mesh/Degree, Solver/Linear solver = "
          "iterative"));
      std::string lines =
        "  memory    about " + what + "; here are " + gigabytes(memory.bytes);
      if (needed > memory.bytes)
        lines += text("\n  warning:  that may not be enough memory; ",
                      n_at_once > 1 ? "fewer ranks or " : "",
                      "Solver/Linear solver = iterative take less");
      return lines;
    }



    /** False if all runs are rods. */
    bool
    has_bodies(const StudyPlan &plan)
    {
      const auto &varied = plan.varied;
      return SceneReader(plan.assignments).scene().dimension > 1 ||
             std::find(varied.begin(), varied.end(), "Dimension") !=
               varied.end() ||
             plan.reference;
    }
  } // namespace



  std::string
  check_study_memory(const StudyTable &table)
  {
    std::vector<unsigned int> runs = table.missing_runs();
    if (runs.empty() || !has_bodies(table.plan))
      return "";
    runs.resize(std::min<std::size_t>(runs.size(), max_checked));
    return describe_memory(read_scenes(table, runs));
  }



  void
  check_any_run(const StudyTable &table)
  {
    const StudyPlan &plan = table.plan;
    SceneReader      reader(plan.assignments);
    std::string      first;
    for (unsigned int run = 0; run < plan.n_runs(); ++run)
      try
        {
          loads_of(*plan.read_scene(plan.overrides(run), reader));
          return;
        }
      catch (const InputError &error)
        {
          if (first.empty())
            first = plan.description(run) + ": " + error.what();
        }
    throw InputError("Study/Vary: no run can be run\n  " + first);
  }



  void
  check_study(const StudyTable      &table,
              const StudyParameters &parameters,
              Log                   &log)
  {
    const unsigned int n_runs = table.plan.n_runs();
    log.line(
      text("  study     ", n_runs, " runs, reference: ", parameters.reference));
    std::vector<unsigned int> runs(std::min(n_runs, max_checked));
    std::iota(runs.begin(), runs.end(), 0);
    const StudyForecast forecast = read_scenes(table, runs);
    if (const auto n = runs.size() - forecast.n_refused; n > 0)
      log.line(text("  expected  ",
                    about(forecast.steps * parameters.repetitions),
                    " steps, about, of ",
                    n,
                    " runs"));
    if (table.size() < n_runs)
      if (const std::string lines = describe_memory(forecast); !lines.empty())
        log.line(lines);
    if (runs.size() < n_runs)
      log.line(text("  checked   the first ", runs.size(), " runs"));
    if (forecast.n_refused > 0)
      throw InputError(text("Study/Vary: ",
                            forecast.n_refused,
                            " of ",
                            runs.size(),
                            " runs cannot be run",
                            forecast.refused,
                            forecast.n_refused > 3 ? "\n  and others" : "",
                            "\n  remedy:  leave them out, in sets of their own "
                            "between ';;'"));
  }
} // namespace ThermoContact
