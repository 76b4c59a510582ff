// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef thermocontact_study_error_bars_h
#define thermocontact_study_error_bars_h

#include <thermocontact/base/log.h>
#include <thermocontact/report/key_results.h>
#include <thermocontact/simulation/simulation.h>

#include <functional>

namespace ThermoContact
{
  /**
   * Error bars of a run that has ended, by repeats of its scene with larger
   * steps and on coarser meshes, from its start, without files, (D9.3) and
   * (D9.4). Collective on the ranks of the run.
   *
   * A repeat that cannot be made leaves its errors unknown, and a remark.
   *
   * @param look_up called after each step of a repeat; may throw
   * @param log for the live line
   */
  template <int dim>
  KeyErrors
  error_bars(const Simulation<dim>       &simulation,
             const std::function<void()> &look_up,
             Log                         &log);
} // namespace ThermoContact

#endif
