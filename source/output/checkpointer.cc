// SPDX-License-Identifier: LGPL-2.1-or-later

#include <thermocontact/base/text.h>
#include <thermocontact/base/version.h>
#include <thermocontact/output/checkpoint.h>
#include <thermocontact/output/checkpointer.h>
#include <thermocontact/output/output_units.h>

#include <utility>

namespace ThermoContact
{
  template <int dim>
  Checkpointer<dim>::Checkpointer(
    const std::string                        &directory,
    const std::map<std::string, std::string> &parameters,
    const Simulation<dim>                    &simulation,
    Output<dim>                              &output)
    : directory(directory)
    , parameters(parameters)
    , interval(simulation.parameters().output.checkpoint_interval)
    , end_time(simulation.parameters().time.end_time)
    , output(output)
    , communicator(simulation.discretization().communicator())
  {
    timer.reset();
  }



  template <int dim>
  int
  Checkpointer<dim>::common(const int number) const
  {
    return Utilities::MPI::n_mpi_processes(communicator) == 1 ?
             number :
             Utilities::MPI::max(number, communicator);
  }



  template <int dim>
  bool
  Checkpointer<dim>::is_due(const StepRecord &record) const
  {
    return interval > 0. &&
           (record.step == 0 || record.time >= end_time ||
            common(Utilities::MPI::this_mpi_process(communicator) == 0 &&
                   since_last.wall_time() >= interval));
  }



  template <int dim>
  void
  Checkpointer<dim>::observe(const Simulation<dim> &simulation)
  {
    const StepRecord &record = simulation.record();
    const int         signal = common(signals.signal());
    if (signal == 0 && !is_due(record))
      return;
    timer.start();
    SavedRun   saved = simulation.save();
    Checkpoint checkpoint;
    checkpoint.time       = record.time;
    checkpoint.step       = record.step;
    checkpoint.version    = version();
    checkpoint.n_ranks    = Utilities::MPI::n_mpi_processes(communicator);
    checkpoint.parameters = parameters;
    checkpoint.output     = output.sync();
    checkpoint.progress   = std::move(saved.progress);
    checkpoint.nodes      = std::move(saved.nodes);
    write_checkpoint(directory, checkpoint, communicator);
    timer.stop();
    since_last.restart();
    if (signal != 0)
      throw Interruption(
        text(name_of_signal(signal),
             " at t = ",
             OutputUnits(simulation.parameters()).text("time", record.time),
             ", step ",
             record.step,
             "; the checkpoint is written"));
  }



  template <int dim>
  void
  Checkpointer<dim>::observe_signal(const Simulation<dim> &simulation)
  {
    if (common(signals.signal()) != 0)
      observe(simulation);
  }



  template class Checkpointer<1>;
  template class Checkpointer<2>;
  template class Checkpointer<3>;
} // namespace ThermoContact
