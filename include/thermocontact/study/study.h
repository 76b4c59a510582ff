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



  /**
   * The memory that runs without a row in @p table take on the machine whose
   * ranks have the least: each rank there has one under way, the
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
   * The text of `--check` on a study: its runs, their steps altogether, and
   * that
   * each can be run. All ranks have read the rows of @p table, whose runs take
   * no memory any more.
   *
   * @throw InputError naming the runs that cannot
   */
  void
  check_study(const StudyTable      &table,
              const StudyParameters &parameters,
              Log                   &log);



  /**
   * Writes study.txt, tables with observed orders for the entry that is
   * refined: the one of step size, tolerance and number of cells that was named
   * last; and study.md, one table of what was varied and of the key results,
   * and the warnings, once each with the runs that have them. Rank 0 writes;
   * collective.
   *
   * @param title heading of study.md
   * @param study with the rows of all runs
   * @throw ComputationError naming a file that cannot be written
   */
  void
  write_study_tables(const std::string &directory,
                     const std::string &title,
                     const StudyTable  &study);

  /**
   * Tells the warnings of the runs, how many runs failed, and the cheapest one
   * whose largest error of the
   * displacement of the end is at most @p target, if that is not 0. Collective.
   *
   * @throw ComputationError if a run failed
   */
  void
  report_study(const StudyTable &study, const double target, Log &log);
} // namespace ThermoContact

#endif
