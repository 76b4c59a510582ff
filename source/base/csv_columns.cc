// SPDX-License-Identifier: LGPL-2.1-or-later

#include <thermocontact/base/csv_columns.h>

namespace ThermoContact
{
  void
  append_field(std::string &row, const std::string_view words)
  {
    const bool is_quoted = words.find_first_of(",\"") != words.npos;
    if (is_quoted)
      row += '"';
    for (const char letter : words)
      {
        if (letter == '"')
          row += '"';
        row += letter == '\n' ? ' ' : letter;
      }
    if (is_quoted)
      row += '"';
  }
} // namespace ThermoContact
