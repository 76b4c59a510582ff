// SPDX-License-Identifier: LGPL-2.1-or-later

#include <thermocontact/base/exceptions.h>
#include <thermocontact/base/text.h>
#include <thermocontact/input/measured_table.h>
#include <thermocontact/input/unit_text.h>
#include <thermocontact/input/unknown_names.h>

#include <deal.II/base/utilities.h>

// pchip.hpp of boost 1.74 lacks the isnan that it calls
// clang-format off
#include <boost/math/special_functions/fpclassify.hpp>
#include <boost/math/interpolators/pchip.hpp>
// clang-format on
#include <boost/locale/utf.hpp>

#include <algorithm>
#include <iterator>
#include <map>
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
      if (unit.empty() || unit == "1") // none, as said
        return number;
      std::istringstream bases(
        "s m K N Pa 1 kg J W Hz m/s m/s^2 N/m N/m^3 W/m^2 W/m^3");
      for (std::string base; bases >> base;)
        if (const auto converted = convert_unit(number, unit, base))
          return converted;
      return std::nullopt;
    }



    /** "time [ms]", "time (ms)" or "time / ms" as its name and its unit. */
    struct Heading
    {
      explicit Heading(const std::string &text)
        : name(text)
      {
        const auto split = [&](const std::size_t name_end,
                               const std::size_t begin,
                               const std::size_t end) {
          name = trim(text.substr(0, name_end));
          unit = trim(text.substr(begin, end - begin));
        };
        const auto open = text.find('['), parenthesis = text.rfind('('),
                   slash = text.rfind(" / ");
        if (open != std::string::npos)
          split(open, open + 1, text.find(']'));
        // a name may have these signs, too
        else if (parenthesis != std::string::npos && text.back() == ')' &&
                 is_unit(
                   text.substr(parenthesis + 1, text.size() - parenthesis - 2)))
          split(parenthesis, parenthesis + 1, text.size() - 1);
        else if (slash != std::string::npos && is_unit(text.substr(slash + 3)))
          split(slash, slash + 3, text.size());
      }

      std::string name, unit;
    };



    /** A text in UTF-8, from one that may be in Latin-1. */
    std::string
    text_in_utf8(const std::string &text)
    {
      namespace utf = boost::locale::utf;
      bool is_utf8  = true;
      for (auto next = text.begin(); is_utf8 && next != text.end();)
        {
          const auto point = utf::utf_traits<char>::decode(next, text.end());
          is_utf8          = point != utf::illegal && point != utf::incomplete;
        }
      if (is_utf8)
        return text;
      std::string result;
      for (const char letter : text)
        utf::utf_traits<char>::encode(static_cast<unsigned char>(letter),
                                      std::back_inserter(result));
      return result;
    }



    /** The cells of a line, without quotes around them. */
    std::vector<std::string>
    split_line(const std::string &line, const char separator)
    {
      std::vector<std::string> cells{""};
      bool                     is_quoted = false;
      for (const char letter : line)
        if (letter == '"')
          is_quoted = !is_quoted;
        else if (letter == separator && !is_quoted)
          cells.emplace_back();
        else
          cells.back() += letter;
      for (std::string &cell : cells)
        cell = trim(cell);
      return cells;
    }



    /** The separator of columns, by the line of their names. */
    char
    separator_of(const std::string &header)
    {
      for (const char separator : {';', '\t'})
        if (split_line(header, separator).size() > 1)
          return separator;
      return ',';
    }



    /** Takes the empty cell behind a separator at the end of a line. */
    void
    take_empty_end(std::vector<std::string> &cells)
    {
      if (cells.size() > 1 && cells.back().empty())
        cells.pop_back();
    }



    /** "12,345" or "12.345", which may be meant as a number of thousands. */
    bool
    may_have_thousands(const std::string &cell)
    {
      const auto comma     = cell.find_first_of(",.");
      const auto first     = cell.find_first_of("123456789");
      const auto is_digits = [&](const std::size_t begin,
                                 const std::size_t end) {
        return cell.find_first_not_of("0123456789", begin) >= end;
      };
      return comma != std::string::npos && first <= 1 && first < comma &&
             comma - first <= 3 && is_digits(first, comma) &&
             cell.size() - comma == 4 && is_digits(comma + 1, cell.size());
    }



    /** A number, which may have a decimal comma where none separates. */
    std::optional<double>
    number_in_cell(std::string cell, const char separator)
    {
      if (separator != ',' && cell.find('.') == std::string::npos)
        std::replace(cell.begin(), cell.end(), ',', '.');
      return parse_number(cell);
    }



    /** An error of a spreadsheet, "#NV", "#DIV/0!", in its first cell. */
    bool
    begins_with_error(const std::string &cell)
    {
      return cell.size() > 2 && cell[0] == '#' &&
             cell.find_first_not_of("ABCDEFGHIJKLMNOPQRSTUVWXYZ/0!?", 1) ==
               std::string::npos;
    }



    /** "28.11.2026", "2026-11-28", "11/28/26", but not "1.000.000". */
    bool
    is_date(const std::string &cell)
    {
      const auto first = cell.find_first_not_of("0123456789");
      const auto last  = cell.find_last_not_of("0123456789");
      return first != std::string::npos && first > 0 && first < last &&
             last + 1 < cell.size() && cell[first] == cell[last] &&
             std::string("./-").find(cell[first]) != std::string::npos &&
             cell.find_first_not_of("0123456789", first + 1) == last &&
             !(last - first == 4 && cell.size() - last == 4);
    }



    /**
     * How to write a cell that is no number.
     *
     * @param may_be_unit in the first row of a file of quantities
     */
    std::string
    remedy_of_cell(const std::string &cell, const bool may_be_unit)
    {
      if (cell.find(':') != std::string::npos)
        return "the time since the first row as a number: times of a clock are "
               "not read";
      if (is_date(cell))
        return "a number, such as the time since the first row: dates are not "
               "read";
      if (cell.find('%') != std::string::npos)
        return "numbers without '%'; in a spreadsheet cells in the format of a "
               "number";
      if (may_be_unit && !cell.empty() && (cell[0] == '[' || is_unit(cell)))
        return "units in the names of the columns, such as 'time [s]', without "
               "a row of their own";
      return "remove the row, of which there is no measurement; numbers have "
             "no separators of thousands, and a decimal comma only where ';' "
             "or a tab separates columns";
    }



    /** Longer than this many of the usual ones a step between rows is a hole.
     */
    constexpr double usual_steps_of_hole = 10.;
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
    // the folder of an included file begins with the folder of the first
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
    const auto fail = [&](const std::string &fault,
                          const unsigned int line,
                          const std::string &remedy = "") {
      throw InputError(
        quote(file_name) + (line > 0 ? ", line " + std::to_string(line) : "") +
        ": " + fault +
        "\n  allowed: a table in CSV: a header with the names of "
        "the columns, then numbers, which grow in the first "
        "column" +
        (remedy.empty() ? "" : "\n  remedy:  " + remedy));
    };
    std::string bytes = read_text(file_name, "a table in CSV");
    if (bytes.find('\0') != std::string::npos)
      throw InputError(
        quote(file_name) +
        ": no text, or one in UTF-16\n  allowed: a table in CSV, "
        "in UTF-8 or Latin-1\n  remedy:  save it as CSV in UTF-8");
    if (begins_with(bytes, "\xEF\xBB\xBF"))
      bytes.erase(0, 3);                       // some programs mark UTF-8 so
    if (bytes.find('\n') == std::string::npos) // some end lines so
      std::replace(bytes.begin(), bytes.end(), '\r', '\n');
    std::istringstream   text(text_in_utf8(bytes));
    std::vector<Heading> header;
    unsigned int         n_lines = 0, index = 1;
    char                 separator = ',';
    std::vector<double>  written; // arguments in the unit of the file
    // a cell of each column whose comma or point may have either meaning
    std::map<unsigned int, std::string> thousands, decimals;
    std::string                         with_comma, with_point; // of any
    for (std::string line; std::getline(text, line);)
      {
        ++n_lines;
        if (trim(line).empty())
          continue;
        std::vector<std::string> cells = split_line(line, separator);
        const bool is_error = !header.empty() && begins_with_error(cells[0]);
        if (trim(line)[0] == '#' && !is_error)
          continue;
        if (!header.empty() &&
            std::all_of(cells.begin(), cells.end(), [](const auto &cell) {
              return cell.empty();
            }))
          continue; // a spreadsheet's last rows
        if (header.empty())
          {
            separator = separator_of(line);
            cells     = split_line(line, separator);
          }
        if (header.empty())
          {
            take_empty_end(cells);
            std::vector<std::string> names;
            for (const std::string &cell : cells)
              {
                header.emplace_back(cell);
                names.push_back(header.back().name);
                if (number_in_cell(cell, separator))
                  fail("a number where the names of the columns should stand",
                       n_lines);
                if (!header.back().unit.empty() && !has_units)
                  fail("a unit in the header, and the parameter file has no "
                       "section Rod, from which scales follow",
                       n_lines);
              }
            if (!column.empty())
              {
                // the whole cell, where several columns have the name
                const auto whole =
                  std::find(cells.begin(), cells.end(), column);
                index = whole != cells.end() ?
                          whole - cells.begin() :
                          std::find(names.begin(), names.end(), column) -
                            names.begin();
                if (std::count(names.begin(), names.end(), column) > 1 ||
                    std::count(cells.begin(), cells.end(), column) > 1)
                  fail("several columns are called '" + quote(column) + "'",
                       n_lines,
                       "another name for each, or the name with its unit");
              }
            if (index >= header.size())
              fail(column.empty() ? "one column, where ',', ';' or a tab "
                                    "separates columns" :
                                    "there is no column '" + quote(column) +
                                      "'" + did_you_mean(column, names),
                   n_lines,
                   column.empty() ? "the names of the columns in the first "
                                    "line, or '#' before the lines above" :
                                    "");
            for (const unsigned int i : {0u, index})
              if (!in_base_units(1., header[i].unit))
                fail("'" + quote(header[i].unit) + "' is no unit of a load",
                     n_lines,
                     "a unit that UDUNITS-2 knows, of a time, length, force, "
                     "pressure, temperature or heat flux; [1] for none");
            unit_of_arguments = header[0].unit;
            unit_of_values    = header[index].unit;
            for (const unsigned int i : {0u, index})
              if (has_units && header[i].unit.empty())
                doubts.push_back(
                  quote(file_name) + ": column '" + quote(header[i].name) +
                  "' has no unit, and its numbers count as SI base units; a "
                  "unit in its header, [1] for none, says that they are right");
            continue;
          }
        if (cells.size() > header.size())
          take_empty_end(cells);
        if (cells.size() != header.size())
          fail(std::to_string(cells.size()) + " cells under " +
                 std::to_string(header.size()) + " names",
               n_lines);
        const auto number_at = [&](const unsigned int i) {
          const auto number = number_in_cell(cells[i], separator);
          if (!number)
            fail("'" + quote(cells[i]) + "' is no number",
                 n_lines,
                 remedy_of_cell(cells[i], arguments.empty() && has_units));
          const bool has_comma = cells[i].find(',') != std::string::npos,
                     has_point = separator != ',' &&
                                 cells[i].find('.') != std::string::npos;
          if (has_comma)
            with_comma = cells[i];
          if (has_point)
            with_point = cells[i];
          if (!with_comma.empty() && !with_point.empty())
            fail("'" + quote(with_point) + "' with a point, '" +
                   quote(with_comma) + "' with a comma",
                 n_lines,
                 "one sign for decimals, and none for thousands");
          if (has_comma || has_point)
            (may_have_thousands(cells[i]) ? thousands : decimals)[i] = cells[i];
          return *number;
        };
        written.push_back(number_at(0));
        arguments.push_back(*in_base_units(written.back(), header[0].unit));
        values.push_back(*in_base_units(number_at(index), header[index].unit));
        if (arguments.size() > 1 &&
            !(arguments.back() > arguments[arguments.size() - 2]))
          fail("the first column does not grow", n_lines);
      }
    if (arguments.size() < 2)
      fail("fewer than two rows of numbers", 0);
    for (const auto &[i, cell] : thousands)
      if (decimals.count(i) == 0)
        doubts.push_back(
          quote(file_name) + ": '" + cell + "' counts as " +
          significant(*number_in_cell(cell, separator), few_digits) +
          (cell.find(',') != std::string::npos ?
             ", with a decimal comma; should it mean thousands, take the "
             "commas out of column '" :
             ", with a decimal point; should it mean thousands, take the "
             "points out of column '") +
          quote(header[i].name) + "'");
    doubt_holes(written, header[0].unit);
  }



  void
  MeasuredTable::doubt_holes(const std::vector<double> &written,
                             const std::string         &unit)
  {
    std::vector<double> steps;
    for (std::size_t i = 1; i < written.size(); ++i)
      steps.push_back(written[i] - written[i - 1]);
    std::vector<double> sorted(steps);
    const auto          middle = sorted.begin() + sorted.size() / 2;
    std::nth_element(sorted.begin(), middle, sorted.end());
    const auto in_unit = [&](const double number) {
      return significant(number, few_digits) + (unit.empty() ? "" : " " + unit);
    };
    for (std::size_t i = 0; i < steps.size(); ++i)
      if (steps[i] > usual_steps_of_hole * *middle)
        {
          doubts.push_back(
            quote(file_name) + ": no row between " + in_unit(written[i]) +
            " and " + in_unit(written[i + 1]) + ", where rows are usually " +
            in_unit(*middle) + " apart: a line joins them");
          return; // one is enough to look at the file
        }
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
