// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef thermocontact_log_h
#define thermocontact_log_h

#include <fstream>
#include <string>

namespace ThermoContact
{
  /**
   * What the screen shows, kept in log.txt as well. Writes on one rank only.
   */
  class Log
  {
  public:
    /**
     * @param is_writer true on the rank that prints
     * @param is_quiet true: nothing on the screen, the file all the same
     */
    Log(const bool is_writer, const bool is_quiet);

    /** Also writes to @p file_name from now on, or at its end. */
    void
    open_file(const std::string &file_name, const bool append = false);

    /** Prints @p text and a line break, on the screen at once. */
    void
    line(const std::string &text = "");

  private:
    const bool    is_writer;
    const bool    is_quiet;
    std::ofstream file;
  };
} // namespace ThermoContact

#endif
