// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef thermocontact_input_measured_table_h
#define thermocontact_input_measured_table_h

#include <thermocontact/input/jet.h>
#include <thermocontact/input/parameter_text.h>

#include <string>
#include <vector>

namespace ThermoContact
{
  /**
   * A column of a CSV file as a function of its first column: linear between
   * the rows, or a monotone cubic, boost's pchip. Beyond the first and the last
   * row it has the value there. Columns are separated by ',', or by ';' or
   * tabs, with which numbers may have a decimal comma.
   */
  class MeasuredTable
  {
  public:
    /**
     * @param column its name in the header without its unit; empty: the second
     * @param is_smooth a cubic
     * @param has_units the header may have units, "time [ms]": numbers are
     *   those in SI base units
     * @throw InputError that names file and row, if it cannot be read, if the
     *   column is not there, if numbers are missing or the first column does
     *   not grow
     */
    MeasuredTable(const std::string &file_name,
                  const std::string &column,
                  const bool         is_smooth,
                  const bool         has_units);

    /** The first argument and the last that it knows. */
    Interval
    range() const
    {
      return {arguments.front(), arguments.back()};
    }

    const std::string file_name;

    /** Of the first column and of the values, as the header has them. */
    std::string unit_of_arguments, unit_of_values;

    /** Doubts for the user to look at: columns without units, holes. */
    std::vector<std::string> doubts;

    double
    evaluate(const double argument) const;

    NumberJet
    evaluate(const NumberJet &argument) const;

    IntervalJet
    evaluate(const IntervalJet &argument) const;

  private:
    std::vector<double> arguments, values, slopes;

    /** The cubic between rows @p i and @p i + 1, or of a line. */
    template <typename Number>
    Jet<Number>
    between(const unsigned int i, const Jet<Number> &argument) const;

    /** The row behind which an argument is; not the last one. */
    unsigned int
    row_before(const double argument) const;

    void
    read(const std::string &column, const bool has_units);

    /**
     * A step between rows that is much longer than usual is doubted.
     *
     * @param written arguments in @p unit, as in the file
     */
    void
    doubt_holes(const std::vector<double> &written, const std::string &unit);
  };



  /** The names of the files of tables in an expression. */
  std::vector<std::string>
  table_files(const std::string &text);

  /** The folder of the parameter file, in which they are looked for. */
  std::string
  folder_of_tables(const std::vector<Assignment> &assignments);
} // namespace ThermoContact

#endif
