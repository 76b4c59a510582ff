// SPDX-License-Identifier: LGPL-2.1-or-later

#include <thermocontact/base/exceptions.h>
#include <thermocontact/base/text.h>
#include <thermocontact/input/unit_text.h>

#include <deal.II/base/utilities.h>

#include <udunits2.h>

#include <cctype>
#include <charconv>
#include <limits>
#include <memory>
#include <string_view>

namespace ThermoContact
{
  namespace
  {
    using Unit = std::unique_ptr<ut_unit, void (*)(ut_unit *)>;

    /** Null for one that UDUNITS-2 does not know. */
    Unit
    parse_unit(const std::string &text)
    {
      static const auto system = []() {
        ut_set_error_message_handler(ut_ignore);
        std::unique_ptr<ut_system, void (*)(ut_system *)> units(
          ut_read_xml(nullptr), ut_free_system);
        if (!units)
          throw ComputationError(
            "UDUNITS-2 does not find its list of units\n  remedy:  install "
            "libudunits2-data, or set UDUNITS2_XML_PATH to udunits2.xml");
        return units;
      }();
      return {ut_parse(system.get(), text.c_str(), UT_UTF8), ut_free};
    }



    /**
     * True for numbers that UDUNITS-2 takes for factors: the 5 of N/m^1.5 and
     * of "um 5". Powers stand behind letters, ^ or a sign, 1 before /.
     */
    bool
    has_factor(const std::string &unit)
    {
      for (std::size_t i = 0; i < unit.size(); ++i)
        if (std::isdigit(static_cast<unsigned char>(unit[i])) != 0)
          {
            const char before = i > 0 ? unit[i - 1] : ' ';
            if (std::string_view(" ./*(").find(before) !=
                  std::string_view::npos &&
                !(unit[i] == '1' && i + 1 < unit.size() && unit[i + 1] == '/'))
              return true;
          }
      return false;
    }
  } // namespace



  std::optional<NumberWithUnit>
  split_unit(const std::string &text)
  {
    const std::size_t sign = begins_with(text, "+") ? 1 : 0;
    double            number;
    const auto        end  = text.data() + text.size();
    const auto        read = std::from_chars(text.data() + sign, end, number);
    if (read.ec != std::errc())
      return std::nullopt;
    const std::string behind(read.ptr, end),
      unit = dealii::Utilities::trim(behind);
    if (unit.empty())
      return NumberWithUnit{number, ""};
    const unsigned char first = unit[0];
    // no expression has a name or a number behind a number
    if (std::isalpha(first) != 0 || first >= 0x80 ||
        (std::isdigit(first) != 0 && behind[0] == ' '))
      return NumberWithUnit{number, unit};
    return std::nullopt;
  }



  bool
  is_unit(const std::string &text)
  {
    return !has_factor(text) && parse_unit(text) != nullptr;
  }



  std::optional<double>
  convert_unit(const double       number,
               const std::string &unit,
               const std::string &other)
  {
    if (!is_unit(unit))
      return std::nullopt;
    const Unit from = parse_unit(unit), to = parse_unit(other);
    // for UDUNITS-2 hertz can be converted to seconds
    const Unit ratio(ut_divide(from.get(), to.get()), ut_free);
    if (!ratio || ut_is_dimensionless(ratio.get()) == 0)
      return std::nullopt;
    const std::unique_ptr<cv_converter, void (*)(cv_converter *)> converter(
      ut_get_converter(from.get(), to.get()), cv_free);
    // 3e-05 for 30e-6, not 2.9999999999999997e-05
    return round_to_digits(cv_convert_double(converter.get(), number),
                           std::numeric_limits<double>::digits10);
  }
} // namespace ThermoContact
