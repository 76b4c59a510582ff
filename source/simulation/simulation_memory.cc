// SPDX-License-Identifier: LGPL-2.1-or-later
//
// What a Simulation remembers, for checkpoints.

#include <thermocontact/base/exceptions.h>
#include <thermocontact/simulation/simulation.h>

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
    archive &state_ &record_ &events_               &warnings_;
    archive &n_rejected_steps_                      &n_retakes;
    archive &max_energy_increase_ &max_penetration_ &max_contact_force_;
    archive &controller &error_norm &energy_watch   &event_locator;
  }



  template <int dim>
  std::string
  Simulation<dim>::memory() const
  {
    std::ostringstream              stream;
    boost::archive::binary_oarchive archive(stream, boost::archive::no_header);
    // one function says what is written and read; writing changes nothing
    const_cast<Simulation<dim> *>(this)->archive_progress(archive);
    const SolverMemory   solver        = step_solver->memory();
    const SolverCounters of_integrator = integrator->counters();
    const SolverCounters of_transition = transition.counters();
    archive << solver << of_integrator << of_transition;
    return stream.str();
  }



  template <int dim>
  void
  Simulation<dim>::restore(const std::string &memory)
  {
    SolverMemory   solver;
    SolverCounters of_integrator, of_transition;
    std::string    fault;
    try
      {
        std::istringstream              stream(memory);
        boost::archive::binary_iarchive archive(stream,
                                                boost::archive::no_header);
        archive_progress(archive);
        archive >> solver >> of_integrator >> of_transition;
      }
    catch (const std::exception &error)
      {
        fault = error.what();
      }
    // perhaps on one rank alone
    const auto faults =
      Utilities::MPI::all_gather(discretization_.communicator(), fault);
    for (const std::string &message : faults)
      if (!message.empty())
        throw InputError("--resume: the checkpoint does not fit this scene: " +
                         message + "\n  remedy:  run without --resume");
    step_solver->restore(solver);
    integrator->restore(of_integrator);
    transition.restore(of_transition);
    is_restored = true;
  }



#define INSTANTIATE(dim)                                \
  template std::string Simulation<dim>::memory() const; \
  template void        Simulation<dim>::restore(const std::string &)

  INSTANTIATE(1);
  INSTANTIATE(2);
  INSTANTIATE(3);

#undef INSTANTIATE
} // namespace ThermoContact
