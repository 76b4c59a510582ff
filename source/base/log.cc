// SPDX-License-Identifier: LGPL-2.1-or-later

#include <thermocontact/base/log.h>

#include <sys/ioctl.h>
#include <unistd.h>

#include <iostream>
#include <utility>

namespace ThermoContact
{
  namespace
  {
    /**
     * Columns of the terminal behind standard output; 0 if it is none or does
     * not say, as that of mpirun, which may lead to a file.
     */
    unsigned int
    terminal_width()
    {
      winsize size{};
      return isatty(STDOUT_FILENO) == 1 &&
                 ioctl(STDOUT_FILENO, TIOCGWINSZ, &size) == 0 ?
               size.ws_col :
               0;
    }
  } // namespace



  Log::Log(const bool is_writer, const bool is_quiet)
    : is_writer(is_writer)
    , is_quiet(is_quiet)
    , has_live_line(is_writer && !is_quiet && terminal_width() > 0)
    , is_live(false)
  {}



  Log::~Log()
  {
    erase_live_line();
  }



  std::string
  Log::open_file(const std::string &file_name, const bool append)
  {
    if (is_writer)
      file.open(file_name, append ? std::ios::app : std::ios::out);
    if (file.is_open())
      file << std::exchange(early_lines, "") << std::flush;
    return file ?
             "" :
             file_name +
               ": cannot be opened\n  remedy:  check free space and rights";
  }



  void
  Log::line(const std::string &text)
  {
    if (!is_writer)
      return;
    erase_live_line();
    if (!is_quiet)
      std::cout << text << std::endl;
    file_line(text);
  }



  void
  Log::file_line(const std::string &text)
  {
    if (file.is_open())
      file << text << std::endl;
    else
      early_lines += text + '\n';
  }



  void
  Log::milestone(const std::string &text)
  {
    if (has_live_line)
      file_line(text);
    else
      line(text);
  }



  void
  Log::failure(const std::string &text)
  {
    if (has_live_line && isatty(STDERR_FILENO) == 1)
      {
        erase_live_line();
        file_line(text);
      }
    else
      line(text);
  }



  void
  Log::live_line(const std::string &text)
  {
    const unsigned int width = has_live_line ? terminal_width() : 0;
    if (width == 0)
      return;
    // the last column stays free: some terminals would go to the next line
    std::cout << '\r' << text.substr(0, width - 1) << "\033[K" << std::flush;
    is_live = true;
  }



  void
  Log::erase_live_line()
  {
    if (is_live)
      std::cout << "\r\033[K" << std::flush;
    is_live = false;
  }
} // namespace ThermoContact
