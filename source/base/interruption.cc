// SPDX-License-Identifier: LGPL-2.1-or-later

#include <thermocontact/base/interruption.h>

#include <algorithm>
#include <array>
#include <csignal>
#include <iterator>

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
    std::copy_if(watched_signals.begin(),
                 watched_signals.end(),
                 std::back_inserter(signals),
                 is_ignored);
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
