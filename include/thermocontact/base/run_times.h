// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef thermocontact_base_run_times_h
#define thermocontact_base_run_times_h

namespace ThermoContact
{
  /** Where the wall time of a run went, in seconds. */
  struct RunTimes
  {
    double set_up = 0.;
    double loop   = 0.; ///< steps and CSV rows
    double steps  = 0.; ///< part of loop: all attempts at steps
    double output = 0.; ///< snapshots
    double wall   = 0.; ///< from the start of the program
  };
} // namespace ThermoContact

#endif
