// SPDX-License-Identifier: LGPL-2.1-or-later
//
// What a Simulation saves of itself, for checkpoints, and how it goes on.

#include <thermocontact/base/collective_errors.h>
#include <thermocontact/base/exceptions.h>
#include <thermocontact/base/parallel_file.h>
#include <thermocontact/base/text.h>
#include <thermocontact/input/quantity_units.h>
#include <thermocontact/simulation/simulation.h>
#include <thermocontact/space/state_serialiser.h>

#include <boost/archive/binary_iarchive.hpp>
#include <boost/archive/binary_oarchive.hpp>
#include <boost/serialization/string.hpp>
#include <boost/serialization/vector.hpp>

#include <sstream>

namespace ThermoContact
{
  template <int dim>
  template <class Archive>
  void
  Simulation<dim>::archive_progress(Archive &archive)
  {
    archive &state_ &history_;
    archive &controller &error_norm &energy_monitor &spatial_error_monitor
      &tracker;
  }



  template <int dim>
  SavedRun
  Simulation<dim>::save() const
  {
    std::ostringstream stream;
    {
      boost::archive::binary_oarchive archive(stream,
                                              boost::archive::no_header);
      // one function says what is written and read; writing changes nothing
      const_cast<Simulation<dim> *>(this)->archive_progress(archive);
      const RetainedFactorizations retained =
        integrator->stage_solver().retained();
      const SolverCounters of_integrator = integrator->own_counters();
      const SolverCounters of_reset      = reset.counters();
      archive << retained << of_integrator << of_reset;
    }
    return {stream.str(), StateSerialiser<dim>(discretization()).save(state_)};
  }



  template <int dim>
  void
  Simulation<dim>::restore(const std::string                        &progress,
                           const unsigned int                        n_ranks,
                           const std::function<bool(std::string &)> &next_nodes)
  {
    const MPI_Comm         communicator = discretization().communicator();
    const unsigned int     n = Utilities::MPI::n_mpi_processes(communicator);
    RetainedFactorizations retained;
    SolverCounters         of_integrator, of_reset;
    std::string            fault;
    const StateSerialiser<dim> values(discretization());
    std::size_t                n_set = 0, n_saved = 0;
    const std::size_t          n_nodes =
      n == n_ranks ? values.n_nodes() :
                              Utilities::MPI::sum(values.n_nodes(), communicator);
    try
      {
        std::istringstream              stream(progress);
        boost::archive::binary_iarchive archive(stream,
                                                boost::archive::no_header);
        archive_progress(archive);
        archive >> retained >> of_integrator >> of_reset;
        for (std::string nodes; next_nodes(nodes);)
          {
            n_set += values.restore(nodes, state_);
            n_saved += values.n_nodes_of(nodes);
          }
        if (n_set != values.n_nodes() || n_saved != n_nodes)
          fault = "vectors of another discretisation";
      }
    catch (const std::exception &error)
      {
        fault = error.what();
      }
    fault = first_fault(fault, communicator); // perhaps on one rank alone
    if (!fault.empty())
      throw InputError("--resume: the checkpoint does not fit this scene: " +
                       fault + "\n  remedy:  run without --resume");
    integrator->stage_solver().restore(retained);
    integrator->restore_own_counters(of_integrator);
    reset.restore(of_reset);
    if (n != n_ranks)
      history_.warnings.push_back(
        text("resumed at t = ",
             QuantityUnits(parameters()).text("time", state_.time),
             " on another number of ranks, ",
             n,
             " instead of ",
             n_ranks,
             ": from there on equal to an uninterrupted run to the tolerance "
             "of the solver, not bit for bit"));
    is_restored = true;
  }



  template <int dim>
  void
  Simulation<dim>::make_up_for_jump()
  {
    StepResult result;
    result.state  = state_;
    result.energy = record().energy_terms;
    if (state_.time == state_.jump_time || !jump(result))
      return;
    state_.swap(result.state);
    measurements.measure(state_, load_time(), history_.record);
    history_.add_jump(result);
    history_.add_maxima(scene_, gap_rate());
    error_norm.add(result.energy);
    controller.restart_after_jump();
  }



#define INSTANTIATE(dim)                                 \
  template SavedRun Simulation<dim>::save() const;       \
  template void     Simulation<dim>::make_up_for_jump(); \
  template void     Simulation<dim>::restore(            \
    const std::string &,                             \
    const unsigned int,                              \
    const std::function<bool(std::string &)> &)

  INSTANTIATE(1);
  INSTANTIATE(2);
  INSTANTIATE(3);

#undef INSTANTIATE
} // namespace ThermoContact
