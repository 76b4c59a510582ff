// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef thermocontact_base_text_h
#define thermocontact_base_text_h

#include <thermocontact/base/number_text.h>

#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

namespace ThermoContact
{
  /**
   * Concatenates words, letters and numbers; numbers that are not whole have
   * @ref few_digits.
   */
  template <typename... Parts>
  std::string
  text(const Parts &...parts)
  {
    std::string line;
    const auto  append = [&line](const auto &part) {
      using Part = std::decay_t<decltype(part)>;
      if constexpr (std::is_floating_point<Part>::value)
        append_number(line, part, few_digits);
      else if constexpr (std::is_integral<Part>::value &&
                         !std::is_same<Part, char>::value)
        append_number(line, part);
      else
        line += part;
    };
    (append(parts), ...);
    return line;
  }

  /** Whether @p text has @p start at its begin; every text begins with "". */
  inline bool
  begins_with(const std::string_view text, const std::string_view start)
  {
    return text.substr(0, start.size()) == start;
  }

  /** @p words with blanks behind them, so that there are @p width letters. */
  inline std::string
  align_left(std::string words, const std::size_t width)
  {
    if (words.size() < width)
      words.append(width - words.size(), ' ');
    return words;
  }

  /** @p words with @p fill before them, so that there are @p width letters. */
  inline std::string
  align_right(const std::string &words,
              const std::size_t  width,
              const char         fill = ' ')
  {
    return std::string(words.size() < width ? width - words.size() : 0, fill) +
           words;
  }

  /** The words that are not empty, with commas between them. */
  inline std::string
  join_words(const std::vector<std::string> &words)
  {
    std::string line;
    for (const std::string &word : words)
      if (!word.empty())
        line += (line.empty() ? "" : ", ") + word;
    return line;
  }

  /** A time in seconds: 75 as "1:15", two hours as "2:00:00". */
  inline std::string
  clock_time(const double seconds)
  {
    if (!(seconds < 3.6e6))
      return "1000 h or more";
    const auto whole      = static_cast<unsigned int>(seconds + 0.5);
    const auto two_digits = [](const unsigned int n) {
      return align_right(text(n), 2, '0');
    };
    const unsigned int minutes = whole / 60;
    return (whole < 3600 ? text(minutes) :
                           text(minutes / 60, ':', two_digits(minutes % 60))) +
           ':' + two_digits(whole % 60);
  }
} // namespace ThermoContact

#endif
