// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef thermocontact_tests_overrides_h
#define thermocontact_tests_overrides_h

#include <sstream>
#include <string>
#include <vector>

namespace ThermoContact
{
  /** 'Section/Entry=value' each, as read_parameters() takes them. */
  using Overrides = std::vector<std::string>;

  /** Both; of two for one entry the second one's wins. */
  inline Overrides
  operator+(Overrides first, const Overrides &second)
  {
    first.insert(first.end(), second.begin(), second.end());
    return first;
  }



  /** @p value as an override that is read back without loss. */
  inline std::string
  number(const double value)
  {
    std::ostringstream text;
    text.precision(17);
    text << value;
    return text.str();
  }



  /** An override that sets an entry to @p value. */
  inline std::string
  entry(const std::string &path, const double value)
  {
    return path + '=' + number(value);
  }



  /** Overrides of a body of a row, of 'Entry=value' each. */
  inline Overrides
  body(const std::string &name, const Overrides &entries)
  {
    Overrides result;
    for (const std::string &one : entries)
      result.push_back("Bodies/" + name + "/" + one);
    return result;
  }
} // namespace ThermoContact

#endif
