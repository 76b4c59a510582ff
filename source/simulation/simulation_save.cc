// SPDX-License-Identifier: LGPL-2.1-or-later
//
// What a Simulation saves of itself, for checkpoints.

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
    archive &state_                               &history_;
    archive &controller &error_norm &energy_watch &tracker;
  }



  template <int dim>
  std::string
  Simulation<dim>::save() const
  {
    std::ostringstream              stream;
    boost::archive::binary_oarchive archive(stream, boost::archive::no_header);
    // one function says what is written and read; writing changes nothing
    const_cast<Simulation<dim> *>(this)->archive_progress(archive);
    const RetainedFactorizations retained =
      integrator->stage_solver().retained();
    const SolverCounters of_integrator = integrator->own_counters();
    const SolverCounters of_tracker    = tracker.counters();
    archive << retained << of_integrator << of_tracker;
    return stream.str();
  }



  template <int dim>
  void
  Simulation<dim>::restore(const std::string &saved)
  {
    RetainedFactorizations retained;
    SolverCounters         of_integrator, of_tracker;
    std::string            fault;
    try
      {
        std::istringstream              stream(saved);
        boost::archive::binary_iarchive archive(stream,
                                                boost::archive::no_header);
        archive_progress(archive);
        archive >> retained >> of_integrator >> of_tracker;
      }
    catch (const std::exception &error)
      {
        fault = error.what();
      }
    // perhaps on one rank alone
    const auto faults =
      Utilities::MPI::all_gather(discretization().communicator(), fault);
    for (const std::string &message : faults)
      if (!message.empty())
        throw InputError("--resume: the checkpoint does not fit this scene: " +
                         message + "\n  remedy:  run without --resume");
    integrator->stage_solver().restore(retained);
    integrator->restore_own_counters(of_integrator);
    tracker.restore(of_tracker);
    is_restored = true;
  }



#define INSTANTIATE(dim)                              \
  template std::string Simulation<dim>::save() const; \
  template void        Simulation<dim>::restore(const std::string &)

  INSTANTIATE(1);
  INSTANTIATE(2);
  INSTANTIATE(3);

#undef INSTANTIATE
} // namespace ThermoContact
