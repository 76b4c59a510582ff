// SPDX-License-Identifier: LGPL-2.1-or-later

#include <thermocontact/base/exceptions.h>
#include <thermocontact/base/number_text.h>
#include <thermocontact/input/measured_table.h>
#include <thermocontact/input/unit_text.h>
#include <thermocontact/input/unknown_names.h>

#include <deal.II/base/utilities.h>

// pchip.hpp of boost 1.74 lacks the isnan that it calls
// clang-format off
#include <boost/math/special_functions/fpclassify.hpp>
#include <boost/math/interpolators/pchip.hpp>
// clang-format on

#include <algorithm>
#include <optional>
#include <sstream>

namespace ThermoContact
{
  namespace
  {
    using dealii::Utilities::trim;

    /** In SI base units, or those that are made of them without a factor. */
    std::optional<double>
    in_base_units(const double number, const std::string &unit)
    {
      if (unit.empty())
        return number;
      std::istringstream bases(
        "s m K N Pa 1 kg J W Hz m/s m/s^2 N/m N/m^3 W/m^2 W/m^3");
      for (std::string base; bases >> base;)
        if (const auto converted = convert_unit(number, unit, base))
          return converted;
      return std::nullopt;
    }



    /** "time [ms]" as its name and its unit. */
    struct Heading
    {
      explicit Heading(const std::string &text)
        : name(trim(text.substr(0, text.find('['))))
      {
        if (const auto open = text.find('['); open != std::string::npos)
          unit = trim(text.substr(open + 1, text.find(']') - open - 1));
      }

      std::string name, unit;
    };
  } // namespace



  MeasuredTable::MeasuredTable(const std::string &file_name,
                               const std::string &column,
                               const bool         is_smooth,
                               const bool         has_units)
    : file_name(file_name)
  {
    read(column, has_units);
    if (!is_smooth)
      return;
    if (arguments.size() < 4)
      throw InputError(quote(file_name) +
                       ": fewer than four rows\n  allowed: four rows or more "
                       "for smooth(), two for table()");
    std::vector<double> x(arguments), y(values); // it takes them
    const boost::math::interpolators::pchip<std::vector<double>> cubic(
      std::move(x), std::move(y));
    for (const double argument : arguments)
      slopes.push_back(cubic.prime(argument));
  }



  std::vector<std::string>
  table_files(const std::string &text)
  {
    std::vector<std::string> files;
    for (const std::string name : {"table", "smooth"})
      for (auto at = text.find(name); at != std::string::npos;
           at      = text.find(name, at + 1))
        {
               const auto open  = text.find_first_not_of(" \t", at + name.size());
               const auto comma = text.find(',', at);
               if (open != std::string::npos && text[open] == '(' &&
              comma != std::string::npos)
            files.push_back(trim(text.substr(open + 1, comma - open - 1)));
        }
    return files;
  }



  std::string
  folder_of_tables(const std::vector<Assignment> &assignments)
  {
    // that of a file that is included begins with it
    std::optional<std::string> folder;
    for (const Assignment &assignment : assignments)
      if (const auto file = assignment.place.rfind(", line ");
          file != std::string::npos)
        {
          const std::string name  = assignment.place.substr(0, file);
          const auto        slash = name.rfind('/');
          const std::string own =
            slash == std::string::npos ? "" : name.substr(0, slash);
          if (!folder || own.size() < folder->size())
            folder = own;
        }
    return folder.value_or("");
  }



  void
  MeasuredTable::read(const std::string &column, const bool has_units)
  {
    const auto fail = [&](const std::string &fault, const unsigned int line) {
      throw InputError(
        quote(file_name) + (line > 0 ? ", line " + std::to_string(line) : "") +
        ": " + fault +
        "\n  allowed: a table in CSV: a header with the names of "
        "the columns, then numbers, of which those of the first "
        "column grow");
    };
    std::istringstream   text(read_text(file_name));
    std::vector<Heading> header;
    unsigned int         n_lines = 0, index = 1;
    for (std::string line; std::getline(text, line);)
      {
        ++n_lines;
        line = trim(line);
        if (line.empty() || line[0] == '#')
          continue;
        const std::vector<std::string> cells =
          dealii::Utilities::split_string_list(line, ',');
        if (header.empty())
          {
            std::vector<std::string> names;
            for (const std::string &cell : cells)
              {
                header.emplace_back(cell);
                names.push_back(header.back().name);
                if (parse_number(cell))
                  fail("a number where the names of the columns should stand",
                       n_lines);
                if (!header.back().unit.empty() && !has_units)
                  fail("a unit in the header, and the parameter file has no "
                       "section Rod, from which scales follow",
                       n_lines);
              }
            if (!column.empty())
              index =
                std::find(names.begin(), names.end(), column) - names.begin();
            if (index >= header.size())
              fail(column.empty() ? "one column, where ',' separates columns" :
                                    "there is no column '" + quote(column) +
                                      "'" + did_you_mean(column, names),
                   n_lines);
            unit_of_arguments = header[0].unit;
            unit_of_values    = header[index].unit;
            continue;
          }
        if (cells.size() != header.size())
          fail(std::to_string(cells.size()) + " cells under " +
                 std::to_string(header.size()) + " names",
               n_lines);
        const auto number_at = [&](const unsigned int i) {
          const auto number = parse_number(cells[i]);
          if (!number)
            fail("'" + quote(cells[i]) + "' is no number", n_lines);
          const auto converted = in_base_units(*number, header[i].unit);
          if (!converted)
            fail("'" + quote(header[i].unit) + "' is no unit of a load",
                 n_lines);
          return *converted;
        };
        arguments.push_back(number_at(0));
        values.push_back(number_at(index));
        if (arguments.size() > 1 &&
            !(arguments.back() > arguments[arguments.size() - 2]))
          fail("the first column does not grow", n_lines);
      }
    if (arguments.size() < 2)
      fail("fewer than two rows of numbers", 0);
  }



  unsigned int
  MeasuredTable::row_before(const double argument) const
  {
    const auto next =
      std::upper_bound(arguments.begin(), arguments.end() - 1, argument);
    return next == arguments.begin() ? 0 : next - arguments.begin() - 1;
  }



  template <typename Number>
  Jet<Number>
  MeasuredTable::between(const unsigned int i,
                         const Jet<Number> &argument) const
  {
    const double h     = arguments[i + 1] - arguments[i];
    const double chord = (values[i + 1] - values[i]) / h;
    const auto   s     = argument - Jet<Number>(arguments[i]);
    const auto   times = [](const double factor, const Jet<Number> &jet) {
      return Jet<Number>(factor) * jet;
    };
    if (slopes.empty())
      return Jet<Number>(values[i]) + times(chord, s);
    const double b = (3. * chord - 2. * slopes[i] - slopes[i + 1]) / h;
    const double c = (slopes[i] + slopes[i + 1] - 2. * chord) / (h * h);
    return Jet<Number>(values[i]) +
           s * (Jet<Number>(slopes[i]) + s * (Jet<Number>(b) + times(c, s)));
  }



  NumberJet
  MeasuredTable::evaluate(const NumberJet &argument) const
  {
    if (argument.value < arguments.front())
      return NumberJet(values.front());
    if (argument.value >= arguments.back())
      return NumberJet(values.back());
    return between(row_before(argument.value), argument);
  }



  double
  MeasuredTable::evaluate(const double argument) const
  {
    return evaluate(NumberJet(argument)).value;
  }



  IntervalJet
  MeasuredTable::evaluate(const IntervalJet &argument) const
  {
    const Interval &span = argument.value;
    IntervalJet     result;
    bool            is_first = true;
    const auto      add      = [&](const IntervalJet &part) {
      result   = is_first ? part :
                                      IntervalJet(hull(result.value, part.value),
                                      hull(result.first, part.first),
                                      Interval::everything());
      is_first = false;
    };
    if (span.low < arguments.front())
      add(IntervalJet(values.front()));
    if (span.high >= arguments.front() && span.low <= arguments.back())
      for (unsigned int i = row_before(span.low);
           i + 1 < arguments.size() && arguments[i] <= span.high;
           ++i)
        if (span.low < arguments[i + 1])
          add(between(i,
                      IntervalJet({std::max(span.low, arguments[i]),
                                   std::min(span.high, arguments[i + 1])},
                                  argument.first,
                                  argument.second)));
    if (span.high >= arguments.back())
      add(IntervalJet(values.back()));
    return result;
  }
} // namespace ThermoContact
