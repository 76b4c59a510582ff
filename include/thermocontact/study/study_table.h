// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef thermocontact_study_study_table_h
#define thermocontact_study_study_table_h

#include <thermocontact/output/output_units.h>
#include <thermocontact/study/study_plan.h>
#include <thermocontact/study/study_run.h>

#include <cstdint>
#include <map>
#include <string>
#include <vector>

namespace ThermoContact
{
  /**
   * study.csv: a row for each run that has ended, whole whatever happens, in
   * the order of their ends while the study runs and of their numbers when it
   * is done. All reports of a study read from here, so that it is the same
   * for a study that was killed and went on.
   */
  class StudyTable
  {
  public:
    /**
     * @param plan borrowed
     * @param parameters of the scene: title, and units of the results
     */
    StudyTable(const StudyPlan   &plan,
               const std::string &file_name,
               const Parameters  &parameters);

    /**
     * Appends the row of a run that has ended, in one piece; any rank.
     *
     * @return the fault, with path and remedy, or nothing
     */
    std::string
    append(const unsigned int run, const StudyRun &result) const;

    /**
     * Reads the rows that were appended since the last call, by all ranks;
     * rows that are not whole are left out, as if their run had not ended.
     *
     * @return their numbers
     * @throw InputError if the file's head is not that of the plan, or the
     *   entries of a row are not those of its run: it is another study's
     */
    std::vector<unsigned int>
    read_on();

    /**
     * Writes the file anew, its head and the rows read by the numbers of the
     * runs. No rank may append meanwhile.
     *
     * @return the fault, with path and remedy, or nothing
     */
    std::string
    sort();

    /** True if the row of @p run is read. */
    bool
    has(const unsigned int run) const
    {
      return rows.count(run) > 0;
    }

    /** Number of rows read. */
    unsigned int
    size() const
    {
      return rows.size();
    }

    /**
     * The runs that have no row on rank 0, the same on all ranks. Collective on
     * MPI_COMM_WORLD.
     */
    std::vector<unsigned int>
    missing_runs() const;

    /** The names of all columns. */
    const std::vector<std::string> names;

    /** The unit of a column; empty: none. */
    std::string
    unit(const std::string &name) const;

    /** A field of a row that is read, as it stands. */
    const std::string &
    words(const unsigned int run, const std::string &name) const;

    /** A field as a number; NaN if it is none. */
    double
    number(const unsigned int run, const std::string &name) const;

    /** Why @p run failed, with "failed: " before it; empty if it is done. */
    std::string
    failure(const unsigned int run) const;

    /** The warnings of @p run, in the order in which they came. */
    std::vector<std::string>
    warnings(const unsigned int run) const;

    const StudyPlan &plan;

    /** Of the scene that the study varies. */
    const OutputUnits units;

  private:
    const std::string                                file_name;
    const Parameters                                 parameters;
    const std::string                                head;
    std::map<unsigned int, std::vector<std::string>> rows;
    std::uint64_t                                    n_read = 0; ///< bytes
  };
} // namespace ThermoContact

#endif
