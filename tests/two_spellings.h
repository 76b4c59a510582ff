// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef thermocontact_tests_two_spellings_h
#define thermocontact_tests_two_spellings_h

#include <array>
#include <string>

#include "recorded_run.h"

namespace ThermoContact
{
  /** The runs of a rod with < and with <= for each @ in the entries: a load
   * that jumps has the old value at that time, or the new one. */
  inline std::array<RecordedRun, 2>
  run_both_spellings(const Overrides &entries)
  {
    std::array<RecordedRun, 2> runs;
    for (const unsigned int i : {0, 1})
      {
        Overrides spelled;
        for (std::string entry : entries)
          {
            for (auto at = entry.find('@'); at != std::string::npos;
                 at      = entry.find('@'))
              entry.replace(at, 1, i == 0 ? "<" : "<=");
            spelled.push_back(entry);
          }
        runs[i] = run<1>("", spelled);
      }
    return runs;
  }
} // namespace ThermoContact

#endif
