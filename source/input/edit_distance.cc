// SPDX-License-Identifier: LGPL-2.1-or-later

#include <thermocontact/input/edit_distance.h>

#include <algorithm>
#include <cctype>
#include <numeric>
#include <vector>

namespace ThermoContact
{
  unsigned int
  edit_distance(const std::string &a, const std::string &b)
  {
    std::vector<unsigned int> row(b.size() + 1);
    std::iota(row.begin(), row.end(), 0u);
    for (unsigned int i = 0; i < a.size(); ++i)
      {
        unsigned int diagonal = row[0]++;
        for (unsigned int j = 0; j < b.size(); ++j)
          {
            const unsigned int substituted =
              diagonal + (std::tolower(a[i]) == std::tolower(b[j]) ? 0 : 1);
            diagonal   = row[j + 1];
            row[j + 1] = std::min({substituted, row[j] + 1, row[j + 1] + 1});
          }
      }
    return row.back();
  }
} // namespace ThermoContact
