// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef thermocontact_study_study_report_h
#define thermocontact_study_study_report_h

#include <thermocontact/base/log.h>
#include <thermocontact/study/study.h>

#include <string>

namespace ThermoContact
{
  /**
   * Writes study.csv, one row per run, and study.txt, tables with observed
   * orders for the entry that is refined: the one of step size, tolerance and
   * number of cells that was named last. Rank 0 writes; collective.
   *
   * @param title first comment line of study.csv
   * @throw ComputationError naming a file that cannot be written
   */
  void
  write_study(const std::string &directory,
              const std::string &title,
              const Study       &study);

  /** Tells what the runs cost and the cheapest one that meets the target. */
  void
  report_study(const Study &study, Log &log);
} // namespace ThermoContact

#endif
