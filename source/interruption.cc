// SPDX-License-Identifier: LGPL-2.1-or-later

#include "interruption.h"

#include <csignal>

namespace ThermoContact
{
  namespace
  {
    volatile std::sig_atomic_t last_signal = 0;

    extern "C" void
    note_signal(const int signal)
    {
      last_signal = signal;
    }



    void
    set_action(void (*action)(int), const int flags)
    {
      struct sigaction settings = {};
      settings.sa_handler       = action;
      settings.sa_flags         = flags;
      for (const int signal : {SIGTERM, SIGINT})
        sigaction(signal, &settings, nullptr);
    }
  } // namespace



  SignalWatch::SignalWatch()
  {
    last_signal = 0;
    set_action(note_signal, SA_RESETHAND | SA_RESTART);
  }



  SignalWatch::~SignalWatch()
  {
    set_action(SIG_DFL, 0);
  }



  int
  SignalWatch::signal() const
  {
    return last_signal;
  }



  std::string
  name_of_signal(const int signal)
  {
    return signal == SIGINT ? "SIGINT" : "SIGTERM";
  }
} // namespace ThermoContact
