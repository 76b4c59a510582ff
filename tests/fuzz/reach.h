// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef thermocontact_fuzz_reach_h
#define thermocontact_fuzz_reach_h

#include <iosfwd>
#include <map>
#include <string>
#include <vector>

#include "reading.h"

namespace ThermoContact
{
  /**
   * How often each entry had another value than its default in a file that was
   * accepted, and in which of them: what was tried at all. Processes that are
   * forked later count together.
   */
  class Reach
  {
  public:
    Reach();

    void
    add(const Reading &reading);

    /** A table of all entries. */
    void
    print(std::ostream &output) const;

    /** Entries that had no other value than their default. */
    std::vector<std::string>
    missed() const;

  private:
    std::map<std::string, unsigned int> rows;
    volatile unsigned long             *counts; ///< by row and column
  };
} // namespace ThermoContact

#endif
