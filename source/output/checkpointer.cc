// SPDX-License-Identifier: LGPL-2.1-or-later

#include <thermocontact/base/version.h>
#include <thermocontact/output/checkpoint.h>
#include <thermocontact/output/checkpointer.h>

#include <sstream>
#include <utility>

namespace ThermoContact
{
  template <int dim>
  Checkpointer<dim>::Checkpointer(
    const std::string                        &directory,
    const std::map<std::string, std::string> &parameters,
    const double                              interval,
    Output<dim>                              &output,
    const MPI_Comm                            communicator)
    : directory(directory)
    , parameters(parameters)
    , interval(interval)
    , output(output)
    , communicator(communicator)
  {
    timer.reset();
  }



  template <int dim>
  int
  Checkpointer<dim>::common_signal() const
  {
    return Utilities::MPI::n_mpi_processes(communicator) == 1 ?
             signals.signal() :
             Utilities::MPI::max(signals.signal(), communicator);
  }



  template <int dim>
  bool
  Checkpointer<dim>::is_due(const Simulation<dim> &simulation) const
  {
    if (interval == 0.)
      return false;
    const StepRecord &record = simulation.record();
    if (record.step == 0 ||
        record.time >= simulation.parameters().time.end_time)
      return true;
    const bool is_late = since_last.wall_time() >= interval;
    return Utilities::MPI::n_mpi_processes(communicator) == 1 ?
             is_late :
             Utilities::MPI::broadcast(communicator, is_late);
  }



  template <int dim>
  void
  Checkpointer<dim>::observe(const Simulation<dim> &simulation)
  {
    const int signal = common_signal();
    if (signal == 0 && !is_due(simulation))
      return;
    timer.start();
    write(simulation);
    timer.stop();
    since_last.restart();
    if (signal != 0)
      {
        std::ostringstream message;
        message << name_of_signal(signal)
                << " at t = " << simulation.record().time << ", step "
                << simulation.record().step << "; the checkpoint is written";
        throw Interruption(message.str());
      }
  }



  template <int dim>
  void
  Checkpointer<dim>::observe_signal(const Simulation<dim> &simulation)
  {
    if (common_signal() != 0)
      observe(simulation);
  }



  template <int dim>
  void
  Checkpointer<dim>::write(const Simulation<dim> &simulation)
  {
    Checkpoint checkpoint;
    checkpoint.time       = simulation.record().time;
    checkpoint.step       = simulation.record().step;
    checkpoint.version    = version();
    checkpoint.n_ranks    = Utilities::MPI::n_mpi_processes(communicator);
    checkpoint.parameters = parameters;
    checkpoint.output     = output.sync();
    SavedRun saved        = simulation.save();
    checkpoint.progress   = std::move(saved.progress);
    checkpoint.nodes      = std::move(saved.nodes);
    write_checkpoint(directory, checkpoint, communicator);
  }



  template class Checkpointer<1>;
  template class Checkpointer<2>;
  template class Checkpointer<3>;
} // namespace ThermoContact
