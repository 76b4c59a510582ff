// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef thermocontact_study_study_forecast_h
#define thermocontact_study_study_forecast_h

#include <thermocontact/base/log.h>
#include <thermocontact/study/study_table.h>

#include <string>

namespace ThermoContact
{
  /**
   * What the runs that have no row in @p table yet take of the memory of the
   * machine whose ranks have the least: each rank there has one under way, the
   * largest ones at the same time if it comes to the worst; or the reference,
   * alone. With a warning if that is more than there is. Collective on
   * MPI_COMM_WORLD; the table of rank 0 counts.
   *
   * @return lines for the screen; nothing if there are no such runs, or rods
   * @throw InputError if it would not be enough were the forecast twice too
   *   large
   */
  std::string
  check_study_memory(const StudyTable &table);



  /**
   * Refuses a study of which no run can be run.
   *
   * @throw InputError with the message of the first one
   */
  void
  check_any_run(const StudyTable &table);



  /**
   * What `--check` says of a study: its runs, their steps altogether, and that
   * each can be run. All ranks have read the rows of @p table, whose runs take
   * no memory any more.
   *
   * @throw InputError naming the runs that cannot
   */
  void
  check_study(const StudyTable      &table,
              const StudyParameters &parameters,
              Log                   &log);
} // namespace ThermoContact

#endif
