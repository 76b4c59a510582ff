// SPDX-License-Identifier: LGPL-2.1-or-later

#include <thermocontact/output/output_page.h>
#include <thermocontact/output/output_units.h>

#include <deal.II/base/exceptions.h>

#include <fnmatch.h>

#include <sstream>
#include <vector>

namespace ThermoContact
{
  namespace
  {
    /** A row of a table of the page. */
    struct Row
    {
      std::string file, name, kind;
    };



    std::vector<Row>
    read_page()
    {
      std::vector<Row>   rows;
      std::istringstream page(output_page);
      std::string        line, file;
      while (std::getline(page, line))
        if (line.rfind("## ", 0) == 0)
          file = line.substr(3);
        else if (line.rfind("| `", 0) == 0)
          {
            const auto name_end = line.find("` | "), kind = name_end + 4;
            rows.push_back({file,
                            line.substr(3, name_end - 3),
                            line.substr(kind, line.find(" | ", kind) - kind)});
          }
      return rows;
    }
  } // namespace



  const std::string &
  kind_of(const std::string &file, const std::string &name)
  {
    static const std::vector<Row> rows = read_page();
    for (const Row &row : rows)
      if (row.file == file && fnmatch(row.name.c_str(), name.c_str(), 0) == 0)
        return row.kind;
    AssertThrow(false, dealii::ExcMessage(file + ": " + name + " has no text"));
    return file; // not reached
  }
} // namespace ThermoContact
