// SPDX-License-Identifier: LGPL-2.1-or-later

#include "log.h"

#include <iostream>

namespace ThermoContact
{
  Log::Log(const bool is_writer, const bool is_quiet)
    : is_writer(is_writer)
    , is_quiet(is_quiet)
  {}



  void
  Log::open_file(const std::string &file_name, const bool append)
  {
    if (is_writer)
      file.open(file_name, append ? std::ios::app : std::ios::out);
  }



  void
  Log::line(const std::string &text)
  {
    if (!is_writer)
      return;
    if (!is_quiet)
      std::cout << text << std::endl;
    if (file.is_open())
      file << text << std::endl;
  }
} // namespace ThermoContact
