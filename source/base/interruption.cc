// SPDX-License-Identifier: LGPL-2.1-or-later

#include <thermocontact/base/interruption.h>

#include <csignal>

namespace ThermoContact
{
  namespace
  {
    volatile std::sig_atomic_t last_signal = 0;

    void
    set_action(void (*action)(int))
    {
      struct sigaction settings = {}, present = {};
      settings.sa_handler = action;
      settings.sa_flags   = SA_RESTART;
      for (const int signal : {SIGTERM, SIGINT, SIGHUP})
        // one that the caller ignores, as in the background, stays ignored
        if (sigaction(signal, nullptr, &present) == 0 &&
            present.sa_handler != SIG_IGN)
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



  std::string
  name_of_signal(const int signal)
  {
    return signal == SIGINT ? "SIGINT" :
           signal == SIGHUP ? "SIGHUP" :
                              "SIGTERM";
  }
} // namespace ThermoContact
