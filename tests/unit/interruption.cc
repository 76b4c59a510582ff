// SPDX-License-Identifier: LGPL-2.1-or-later
//
// Signals, each in a child process. The first SIGTERM, SIGINT or SIGHUP is
// noted, the second one ends the process by itself; a later watch begins anew.
// What the caller ignores is neither; SIGQUIT is not watched. What a library
// takes over before main() begins is tested with the program: app/resume.

#include <thermocontact/base/interruption.h>

#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <optional>

#include "../tests.h"

using namespace ThermoContact;

namespace
{
  /** What ends a process that is sent a signal twice, 0 if nothing does. */
  int
  end_of_process(const int signal, const bool is_ignored)
  {
    const pid_t child = fork();
    if (child == 0)
      {
        std::signal(signal, is_ignored ? SIG_IGN : SIG_DFL);
        std::optional<SignalWatch> watch;
        for (unsigned int i = 0; i < 2; ++i)
          {
            watch.emplace();
            if (watch->signal() != 0)
              _exit(2);
            std::raise(signal);
            if (watch->signal() != (is_ignored ? 0 : signal))
              _exit(1);
          }
        std::raise(signal);
        _exit(0);
      }
    int status = 0;
    waitpid(child, &status, 0);
    return WIFSIGNALED(status) ? WTERMSIG(status) : -WEXITSTATUS(status);
  }
} // namespace



void
main_interruption()
{
  initlog();
  for (const int signal : {SIGTERM, SIGINT, SIGHUP})
    deallog << name_of_signal(signal) << ": ended by "
            << end_of_process(signal, false) << ", ignored "
            << end_of_process(signal, true) << std::endl;
}
