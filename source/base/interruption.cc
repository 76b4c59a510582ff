// SPDX-License-Identifier: LGPL-2.1-or-later

#include <thermocontact/base/interruption.h>

#include <algorithm>
#include <array>
#include <csignal>

namespace ThermoContact
{
  namespace
  {
    volatile std::sig_atomic_t last_signal = 0;

    constexpr std::array<int, 3> watched_signals = {{SIGTERM, SIGINT, SIGHUP}};

    bool
    is_ignored(const int signal)
    {
      struct sigaction present = {};
      return sigaction(signal, nullptr, &present) != 0 ||
             present.sa_handler == SIG_IGN;
    }



    void
    set_action(void (*action)(int))
    {
      struct sigaction settings = {};
      settings.sa_handler       = action;
      settings.sa_flags         = SA_RESTART;
      for (const int signal : watched_signals)
        // one that the caller ignores, as in the background, stays ignored
        if (!is_ignored(signal))
          sigaction(signal, &settings, nullptr);
    }



    /** Of the watched signals, when the process began. */
    std::array<bool, watched_signals.size()> are_ignored;

    void
    note_ignored(int, char **, char **)
    {
      std::transform(watched_signals.begin(),
                     watched_signals.end(),
                     are_ignored.begin(),
                     is_ignored);
    }

    // Called before the constructors of shared libraries, one of which takes
    // SIGHUP: UCX, with the Open MPI of Debian 13.
    [[gnu::used, gnu::section(".preinit_array")]] void (
      *first_call)(int, char **, char **) = note_ignored;



    extern "C" void
    note_signal(const int signal)
    {
      last_signal = signal;
      set_action(SIG_DFL); // the next one ends the program
    }
  } // namespace



  SignalWatch::SignalWatch()
  {
    last_signal = 0;
    set_action(note_signal);
  }



  SignalWatch::~SignalWatch()
  {
    set_action(SIG_DFL);
  }



  int
  SignalWatch::signal() const
  {
    return last_signal;
  }



  std::vector<int>
  ignored_signals()
  {
    std::vector<int> signals;
    for (unsigned int i = 0; i < watched_signals.size(); ++i)
      if (are_ignored[i])
        signals.push_back(watched_signals[i]);
    return signals;
  }



  std::string
  name_of_signal(const int signal)
  {
    return signal == SIGINT ? "SIGINT" :
           signal == SIGHUP ? "SIGHUP" :
                              "SIGTERM";
  }
} // namespace ThermoContact
