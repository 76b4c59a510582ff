// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef thermocontact_base_log_h
#define thermocontact_base_log_h

#include <fstream>
#include <string>

namespace ThermoContact
{
  /**
   * The text on the screen, kept in log.txt as well. Writes on one rank only.
   *
   * On a terminal the last line may be live: it is rewritten in place, gives
   * way to every other line, and is not in the file.
   */
  class Log
  {
  public:
    /**
     * @param is_writer true on the rank that prints
     * @param is_quiet true: nothing on the screen, the file all the same
     */
    Log(const bool is_writer, const bool is_quiet);

    /** Erases the live line. */
    ~Log();

    Log(const Log &) = delete;

    Log &
    operator=(const Log &) = delete;

    /**
     * Also writes to @p file_name, or at its end: all lines printed so far, and
     * all that follow.
     *
     * @return the fault, with path and remedy, or nothing
     */
    std::string
    open_file(const std::string &file_name, const bool append = false);

    /** Prints @p text and a line break, on the screen at once. */
    void
    line(const std::string &text = "");

    /** As line(), but for the file alone if there are live lines. */
    void
    milestone(const std::string &text);

    /**
     * As line(), but if both standard output and standard error are terminals,
     * for the file alone: the program prints the reason there when it ends.
     */
    void
    failure(const std::string &text);

    /**
     * Shows @p text, cut to the width of the terminal, in place of the last
     * live line. Without a terminal it does nothing.
     */
    void
    live_line(const std::string &text);

  private:
    const bool    is_writer;
    const bool    is_quiet;
    const bool    has_live_line; ///< standard output is a terminal
    bool          is_live;       ///< a live line is on the screen
    std::ofstream file;
    std::string   early_lines; ///< before there is a file

    /** Writes @p text and a line break to the file alone. */
    void
    file_line(const std::string &text);

    void
    erase_live_line();
  };
} // namespace ThermoContact

#endif
