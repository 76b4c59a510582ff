// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef thermocontact_study_study_h
#define thermocontact_study_study_h

#include <thermocontact/base/log.h>
#include <thermocontact/study/study_table.h>

#include <string>

namespace ThermoContact
{
  /**
   * Makes the runs of a study that have no row in @p table yet, the reference
   * first. They are dealt over the ranks, each run on one, and each rank
   * appends the row of a run as it ends. Collective on MPI_COMM_WORLD;
   * afterwards rank 0 has read all rows.
   *
   * @param directory where single runs leave their files, if they are asked
   *   for, in folders run-0, run-1, ...
   * @param table its file is there; rank 0 has read its rows
   * @param log shows how far the study is, and runs that fail
   * @throw ComputationError if the reference fails, or a row cannot be written
   * @throw Interruption if a signal has come; no row is lost
   */
  void
  run_study(const StudyParameters &parameters,
            const std::string     &directory,
            StudyTable            &table,
            Log                   &log);

} // namespace ThermoContact

#endif
