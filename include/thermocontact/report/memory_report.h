// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef thermocontact_report_memory_report_h
#define thermocontact_report_memory_report_h

#include <thermocontact/base/log.h>
#include <thermocontact/scene/scene.h>

#include <mpi.h>

#include <string>

namespace ThermoContact
{
  /** Bytes with two significant digits and their unit. */
  std::string
  gigabytes(const double bytes);



  /**
   * Prints how much memory a body in two or three dimensions is expected to
   * take on this machine and how much there is, with a warning if that is less.
   * Collective.
   */
  void
  report_memory(const Scene &scene, const MPI_Comm communicator, Log &log);
} // namespace ThermoContact

#endif
