// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef thermocontact_forecast_expected_memory_h
#define thermocontact_forecast_expected_memory_h

#include <thermocontact/scene/scene.h>

namespace ThermoContact
{
  /**
   * Memory of all processes of a run, bytes, in two and three dimensions within
   * a factor of about two, doc/bodies.md: what a process takes before it
   * computes anything, and what the body takes; of the direct solver mostly the
   * factors of the step sizes that are kept. A rod takes next to nothing.
   */
  double
  expected_memory(const Scene &scene, const unsigned int n_ranks);

  /**
   * Processor time of all ranks, seconds, in two and three dimensions within a
   * factor of about two, doc/bodies.md; as measured on the processors of
   * doc/performance.md.
   *
   * @param n_steps of the run
   */
  double
  expected_cpu_seconds(const Scene &scene, const double n_steps);

  /**
   * Refuses a body that would not fit if its forecast were twice too large.
   *
   * @param available bytes, the same on all ranks: so is the decision
   * @param share of the processes that have to do with these
   * @throw InputError with the remedy
   */
  void
  check_memory(const Scene       &scene,
               const unsigned int n_ranks,
               const double       available,
               const double       share);
} // namespace ThermoContact

#endif
