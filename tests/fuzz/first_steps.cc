// SPDX-License-Identifier: LGPL-2.1-or-later

#include <thermocontact/base/exceptions.h>
#include <thermocontact/output/output.h>
#include <thermocontact/report/progress.h>
#include <thermocontact/report/result_report.h>
#include <thermocontact/report/summary.h>
#include <thermocontact/study/error_bars.h>

#include "first_steps.h"

#include <filesystem>

namespace ThermoContact
{
  namespace
  {
    /** Ends a run from an observer. */
    struct Enough
    {};



    /** Throws in the step after the last that is wanted. */
    class StepLimit
    {
    public:
      explicit StepLimit(const unsigned int dim)
        : n_left(dim == 1 ? 20 : 5)
      {}

      void
      count()
      {
        if (n_left-- == 0)
          throw Enough();
      }

    private:
      unsigned int n_left;
    };



    /** A run to its end, and what the program says of it then. */
    template <int dim>
    void
    run_observed(Simulation<dim> &simulation, Output<dim> &output, Log &log)
    {
      StepLimit limit(dim);
      Progress  progress(simulation.scene(), simulation.history(), log);
      simulation.run(
        {[&](const Simulation<dim> &s) { output.observe(s); },
         [&](const Simulation<dim> &s) { progress.observe(s.history()); },
         [&](const Simulation<dim> &) { limit.count(); }});
      output.finish();
      report_result(simulation.scene(),
                    simulation.history(),
                    simulation.counters(),
                    RunTimes(),
                    progress.initial_energy(),
                    log);
    }



    template <int dim>
    void
    make_error_bars(const Simulation<dim> &simulation, Log &log)
    {
      StepLimit limit(dim);
      try
        {
          report_errors(simulation.scene(),
                        simulation.history(),
                        error_bars<dim>(
                          simulation, [&]() { limit.count(); }, log),
                        log);
        }
      catch (const Enough &)
        {}
    }
  } // namespace



  template <int dim>
  void
  take_first_steps(Simulation<dim> &simulation, const std::string &directory)
  {
    std::filesystem::remove_all(directory);
    std::filesystem::create_directories(directory);
    const std::string summary = directory + "/summary.json";
    Log               quiet(false, true);
    Output<dim>       output(directory, simulation);
    try
      {
        run_observed(simulation, output, quiet);
      }
    catch (const Enough &)
      {}
    catch (const ComputationError &error)
      {
        output.observe_failure(simulation);
        write_summary(summary, error.what(), simulation, {});
        throw;
      }
    write_summary(summary, "done", simulation, {});
    if (simulation.parameters().output.has_error_bars)
      make_error_bars(simulation, quiet);
  }



  template void
  take_first_steps(Simulation<1> &, const std::string &);
  template void
  take_first_steps(Simulation<2> &, const std::string &);
  template void
  take_first_steps(Simulation<3> &, const std::string &);
} // namespace ThermoContact
