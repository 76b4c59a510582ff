// SPDX-License-Identifier: LGPL-2.1-or-later

#include <thermocontact/base/number_text.h>

#include <deal.II/base/exceptions.h>

#include <cmath>
#include <iterator>
#include <limits>

namespace ThermoContact
{
  namespace
  {
    /** Sign, point, exponent "e-308" and more digits than anybody asks for. */
    constexpr unsigned int max_digits = 40;
    constexpr unsigned int max_length = max_digits + 16;
  } // namespace



  void
  append_number(std::string       &line,
                const double       value,
                const unsigned int digits)
  {
    AssertIndexRange(digits, max_digits + 1);
    char       number[max_length];
    const auto end = digits == all_digits ?
                       std::to_chars(number, std::end(number), value) :
                       std::to_chars(number,
                                     std::end(number),
                                     value + 0., // no reader asks for -0
                                     std::chars_format::general,
                                     digits);
    line.append(number, end.ptr);
  }



  std::string
  significant(const double value, const unsigned int digits)
  {
    std::string line;
    append_number(line, value, digits);
    return line;
  }



  std::string
  fixed_point(const double value, const unsigned int decimals)
  {
    AssertIndexRange(decimals, max_digits + 1);
    char       number[std::numeric_limits<double>::max_exponent10 + max_length];
    const auto end = std::to_chars(number,
                                   std::end(number),
                                   value,
                                   std::chars_format::fixed,
                                   decimals)
                       .ptr;
    return std::string(number, end);
  }



  double
  round_to_digits(const double value, const unsigned int digits)
  {
    return parse_number(significant(value, digits)).value_or(value);
  }



  std::string
  about(const double value)
  {
    return significant(round_to_digits(value, 2), 12);
  }



  std::string
  gigabytes(const double bytes)
  {
    return about(bytes / 1e9) + " GB";
  }



  std::optional<double>
  parse_number(std::string_view text)
  {
    if (text.find('+') == 0 && text.find('-') != 1)
      text.remove_prefix(1);
    double     value = 0.;
    const auto end   = text.data() + text.size();
    const auto read  = std::from_chars(text.data(), end, value);
    if (read.ec != std::errc() || read.ptr != end || !std::isfinite(value))
      return std::nullopt;
    return value;
  }
} // namespace ThermoContact
