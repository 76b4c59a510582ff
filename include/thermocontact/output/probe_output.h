// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef thermocontact_output_probe_output_h
#define thermocontact_output_probe_output_h

#include <thermocontact/base/csv_columns.h>
#include <thermocontact/base/table_file.h>
#include <thermocontact/output/output_units.h>
#include <thermocontact/space/body.h>
#include <thermocontact/space/point_values.h>

#include <string>

namespace ThermoContact
{
  /**
   * Histories at the positions of Output/Probes: probes.csv, with a row for
   * each row of contact.csv.
   */
  template <int dim>
  class ProbeOutput
  {
  public:
    /** @param body borrowed */
    ProbeOutput(const std::string &directory, const Body<dim> &body);

    /**
     * Begins the file, or goes on behind its first @p size bytes if that is not
     * 0. On rank 0.
     *
     * @param comments lines at the top, each with its end
     */
    void
    open(const std::string &comments, const std::uint64_t size);

    /** Adds a row. Collective. A fault shows when file() is flushed. */
    void
    write(const State &state);

    /** probes.csv; open on rank 0 alone. */
    TableFile &
    file()
    {
      return table_file;
    }

  private:
    const std::string             path;
    const bool                    is_writer;
    const std::vector<Place<dim>> places;
    PointValues<dim>              point_values;
    TableFile                     table_file;

    /** What a row is made of: values as PointValues gives them. */
    struct Record
    {
      double                     time;
      const std::vector<double> &values;
    };

    const OutputUnits        units;
    const CsvColumns<Record> columns;
    const Conversions        conversions; ///< of the columns

    /** The columns of @p n_places probes. */
    static CsvColumns<Record>
    make_columns(const unsigned int n_places);
  };
} // namespace ThermoContact

#endif
