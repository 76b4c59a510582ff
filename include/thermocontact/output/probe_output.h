// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef thermocontact_output_probe_output_h
#define thermocontact_output_probe_output_h

#include <thermocontact/output/csv_file.h>
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
    explicit ProbeOutput(const Body<dim> &body);

    /** As CsvFile::open(), with the places of the probes at the top. */
    void
    open(const std::string  &directory,
         const std::string  &comments,
         const std::uint64_t size);

    /** Adds a row. Collective. A fault shows when file() is flushed. */
    void
    write(const State &state);

    /** probes.csv; open on rank 0 alone. */
    TableFile &
    file()
    {
      return csv_file.file;
    }

  private:
    /** What a row is made of: values as PointValues gives them. */
    struct Record
    {
      double                     time;
      const std::vector<double> &values;
    };

    const OutputUnits             units;
    const std::vector<Place<dim>> places;
    PointValues<dim>              point_values;
    CsvFile<Record>               csv_file;

    /** The columns of @p n_places probes. */
    static CsvColumns<Record>
    make_columns(const unsigned int n_places);
  };
} // namespace ThermoContact

#endif
