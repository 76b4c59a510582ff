// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef thermocontact_study_study_report_h
#define thermocontact_study_study_report_h

#include <thermocontact/base/log.h>
#include <thermocontact/study/study_table.h>

#include <string>

namespace ThermoContact
{
  /**
   * Writes study.txt, tables with observed orders for the entry that is
   * refined: the one of step size, tolerance and number of cells that was named
   * last; and study.md, one table of what was varied and of the key results.
   * Rank 0 writes; collective.
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
   * Tells how many runs failed, and the cheapest one whose largest error of the
   * displacement of the end is at most @p target, if that is not 0. Collective.
   *
   * @throw ComputationError if a run failed
   */
  void
  report_study(const StudyTable &study, const double target, Log &log);
} // namespace ThermoContact

#endif
