// SPDX-License-Identifier: LGPL-2.1-or-later

#include <thermocontact/base/csv_columns.h>
#include <thermocontact/base/version.h>

#include <deal.II/base/revision.h>

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



  std::string
  csv_comments(const std::string &title)
  {
    return (title.empty() ? "#" : "# " + title) + "\n# thermocontact " +
           version() + ", deal.II " + DEAL_II_PACKAGE_VERSION + '\n';
  }



  std::string
  csv_row(const std::vector<std::string> &words)
  {
    std::string row;
    for (const std::string &word : words)
      {
        append_field(row, word);
        row += ',';
      }
    row.back() = '\n';
    return row;
  }



  std::vector<std::string>
  split_row(const std::string_view row)
  {
    std::vector<std::string> fields(1);
    bool                     is_quoted = false;
    for (std::size_t i = 0; i < row.size(); ++i)
      if (row[i] == '"' && is_quoted && i + 1 < row.size() && row[i + 1] == '"')
        fields.back() += row[i++];
      else if (row[i] == '"')
        is_quoted = !is_quoted;
      else if (row[i] == ',' && !is_quoted)
        fields.emplace_back();
      else
        fields.back() += row[i];
    return fields;
  }
} // namespace ThermoContact
