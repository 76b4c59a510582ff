// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef thermocontact_base_number_text_h
#define thermocontact_base_number_text_h

#include <charconv>
#include <iterator>
#include <optional>
#include <string>
#include <string_view>
#include <type_traits>

namespace ThermoContact
{
  /** As many significant digits as give a double back when it is read, not
   * one more: 0.1, not 0.10000000000000001. */
  constexpr unsigned int all_digits = 0;

  /** Digits of numbers in sentences, those of C++ streams. */
  constexpr unsigned int few_digits = 6;

  /**
   * Appends @p value with @p digits significant ones, as "%.{digits}g" of
   * printf does: 0.1, 1e-05, inf, nan; or with all_digits. The decimal point is
   * one in every locale, and nothing is allocated but by @p line.
   */
  void
  append_number(std::string       &line,
                const double       value,
                const unsigned int digits = all_digits);

  /** Appends a whole number. */
  template <typename Integer>
  std::enable_if_t<std::is_integral<Integer>::value>
  append_number(std::string &line, const Integer value)
  {
    char       digits[24];
    const auto end = std::to_chars(digits, std::end(digits), value).ptr;
    line.append(digits, end);
  }

  /** @p value with @p digits significant ones, as append_number() writes it. */
  std::string
  significant(const double value, const unsigned int digits);

  /** @p value with @p decimals digits behind the point, as "%.{decimals}f". */
  std::string
  fixed_point(const double value, const unsigned int decimals);

  /**
   * The number with @p digits significant ones that is nearest to @p value;
   * not finite values as they are.
   */
  double
  round_to_digits(const double value, const unsigned int digits);

  /** @p value with two significant digits, without exponent below 1e12. */
  std::string
  about(const double value);

  /** Bytes likewise in GB. */
  std::string
  gigabytes(const double bytes);

  /**
   * The number that the whole of @p text is: digits with '.', signs, an
   * exponent, no blanks. Nothing if it is anything else, not finite, or beyond
   * the range of a double.
   */
  std::optional<double>
  parse_number(std::string_view text);
} // namespace ThermoContact

#endif
