// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef thermocontact_base_interruption_h
#define thermocontact_base_interruption_h

#include <thermocontact/base/exceptions.h>

#include <string>
#include <vector>

namespace ThermoContact
{
  /** A signal has ended a run or a study, which can go on with --resume. */
  class Interruption : public ComputationError
  {
  public:
    using ComputationError::ComputationError;
  };



  /**
   * Takes note of SIGTERM, SIGINT and SIGHUP as long as it lives, instead of
   * ending the program; a second signal, of either kind, ends it at once.
   * Signals that are ignored stay ignored. At most one at a time.
   */
  class SignalWatch
  {
  public:
    SignalWatch();

    ~SignalWatch();

    SignalWatch(const SignalWatch &) = delete;
    SignalWatch &
    operator=(const SignalWatch &) = delete;

    /** The signal that has come, or 0. */
    int
    signal() const;
  };



  /**
   * The signals among these that who started the process ignores, as nohup
   * does. Libraries that start with it or with MPI take them over.
   */
  std::vector<int>
  ignored_signals();



  /** "SIGTERM", "SIGINT", "SIGHUP". */
  std::string
  name_of_signal(const int signal);
} // namespace ThermoContact

#endif
