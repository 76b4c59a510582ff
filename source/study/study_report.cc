// SPDX-License-Identifier: LGPL-2.1-or-later

#include <thermocontact/base/csv_columns.h>
#include <thermocontact/base/exceptions.h>
#include <thermocontact/base/text.h>
#include <thermocontact/base/version.h>
#include <thermocontact/output/output_directory.h>
#include <thermocontact/study/study_report.h>

#include <deal.II/base/convergence_table.h>
#include <deal.II/base/revision.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <functional>
#include <limits>
#include <map>
#include <set>

namespace ThermoContact
{
  namespace
  {
    const double nan = std::numeric_limits<double>::quiet_NaN();

    double
    minimum(const std::vector<double> &sorted)
    {
      return sorted.empty() ? nan : sorted.front();
    }



    double
    median(const std::vector<double> &sorted)
    {
      const auto n = sorted.size();
      return n == 0 ? nan : 0.5 * (sorted[(n - 1) / 2] + sorted[n / 2]);
    }



    Trajectory::Difference
    error_of(const StudyRun &run)
    {
      if (run.error)
        return *run.error;
      Trajectory::Difference none;
      none.maximum.fill(nan);
      none.final_value.fill(nan);
      none.first_contact_time = nan;
      return none;
    }



    // study.csv has its errors in this order
    const Trajectory::Quantity quantities[] = {Trajectory::displacement_end,
                                               Trajectory::velocity_end,
                                               Trajectory::contact_force,
                                               Trajectory::temperature_end};



    /** What a row of study.csv is made of. */
    struct StudyRow
    {
      unsigned int           number; ///< of the run
      const StudyRun        &run;
      Trajectory::Difference error;
    };



    /** A column with a member of StudyRun. */
    template <typename Value>
    CsvColumn<StudyRow>
    run_column(const std::string &name, Value StudyRun::*const member)
    {
      return {name, [member](const StudyRow &row) { return row.run.*member; }};
    }



    /** A column with an error of a quantity. */
    CsvColumn<StudyRow>
    error_column(const std::string &prefix,
                 Trajectory::Values Trajectory::Difference::*const error,
                 const Trajectory::Quantity                        quantity)
    {
      return {prefix + Trajectory::names[quantity],
              [error, quantity](const StudyRow &row) {
                return (row.error.*error)[quantity];
              }};
    }



    /** The columns of study.csv. */
    CsvColumns<StudyRow>
    make_columns(const Study &study)
    {
      const auto maximum     = &Trajectory::Difference::maximum;
      const auto final_value = &Trajectory::Difference::final_value;

      CsvColumns<StudyRow> columns = {{"run", &StudyRow::number}};
      for (unsigned int e = 0; e < study.varied().size(); ++e)
        columns.emplace_back(study.varied()[e], [e](const StudyRow &row) {
          return row.run.entries[e];
        });
      columns.emplace_back("status", [](const StudyRow &row) {
        return row.run.failure.empty() ? "done" : "failed: " + row.run.failure;
      });
      columns.push_back(run_column("dofs", &StudyRun::n_dofs));
      columns.push_back(run_column("steps", &StudyRun::n_steps));
      columns.push_back(
        run_column("rejected_steps", &StudyRun::n_rejected_steps));
      columns.push_back(
        run_column("factorizations", &StudyRun::n_factorizations));
      columns.push_back(run_column("solves", &StudyRun::n_solves));
      columns.emplace_back("loop_seconds", [](const StudyRow &row) {
        return minimum(row.run.loop_seconds);
      });
      for (const auto q : quantities)
        columns.push_back(error_column("error_", maximum, q));
      columns.emplace_back("error_first_contact_time", [](const StudyRow &row) {
        return row.error.first_contact_time;
      });
      columns.push_back(error_column("error_", maximum, Trajectory::energy));
      columns.emplace_back("loop_seconds_median", [](const StudyRow &row) {
        return median(row.run.loop_seconds);
      });
      for (const auto q : quantities)
        columns.push_back(error_column("final_error_", final_value, q));
      columns.push_back(
        error_column("final_error_", final_value, Trajectory::energy));
      return columns;
    }



    /** The number that @p text is; NaN if it is none. */
    double
    to_number(const std::string &text)
    {
      return parse_number(text).value_or(nan);
    }



    /**
     * The entry that a set of combinations refines: the last of those in whose
     * powers errors fall that has several values, all of them numbers. Empty
     * if there is none.
     */
    std::string
    refined_entry(const Study &study, const unsigned int set)
    {
      std::map<std::string, std::set<std::string>> values;
      std::string                                  refined;
      for (const StudyRun &run : study.runs())
        if (run.set == set)
          for (const auto &[path, value] : run.overrides)
            values[path].insert(value);
      for (const std::string &path : study.varied())
        if ((path == "Time/Step size" || path == "Time/Tolerance" ||
             path == "Mesh/Cells") &&
            values[path].size() > 1 &&
            std::none_of(values[path].begin(),
                         values[path].end(),
                         [](const std::string &value) {
                           return std::isnan(to_number(value));
                         }))
          refined = path;
      return refined;
    }



    /** The runs of a set that differ in the refined entry alone, by the rest.
     */
    std::map<std::string, std::vector<const StudyRun *>>
    group(const Study       &study,
          const unsigned int set,
          const std::string &refined)
    {
      std::map<std::string, std::vector<const StudyRun *>> groups;
      for (const StudyRun &run : study.runs())
        if (run.set == set)
          {
            std::string name;
            for (const auto &[path, value] : run.overrides)
              if (path != refined)
                name += (name.empty() ? "" : ", ") + path + " = " + value;
            groups[name].push_back(&run);
          }
      return groups;
    }



    double
    value_of(const StudyRun &run, const std::string &path)
    {
      for (const auto &[name, value] : run.overrides)
        if (name == path)
          return to_number(value);
      return nan;
    }



    /** One table for runs that differ in the refined entry alone. */
    ConvergenceTable
    make_table(const std::vector<const StudyRun *> &runs,
               const std::string                   &refined)
    {
      // cells become more, steps and tolerances smaller
      const bool        grows = refined.rfind("Mesh/", 0) == 0;
      const std::string key =
        refined.empty() ? "run" : (grows ? "" : "1/") + refined;
      std::vector<
        std::pair<std::string, std::function<double(const StudyRun &)>>>
        errors;
      for (const auto q : quantities)
        {
          errors.emplace_back(Trajectory::names[q], [q](const StudyRun &run) {
            return run.error->maximum[q];
          });
          errors.emplace_back(std::string("final ") + Trajectory::names[q],
                              [q](const StudyRun &run) {
                                return run.error->final_value[q];
                              });
        }

      ConvergenceTable table;
      unsigned int     n = 0;
      for (const StudyRun *run : runs)
        {
          const double value = refined.empty() ? n++ : value_of(*run, refined);
          table.add_value(key, refined.empty() || grows ? value : 1. / value);
          table.add_value("dofs", run->n_dofs);
          table.add_value("steps", run->n_steps);
          table.add_value("solves", run->n_solves);
          if (run->error)
            for (const auto &[name, error] : errors)
              table.add_value(name, error(*run));
        }
      if (runs[0]->error)
        for (const auto &[name, error] : errors)
          {
            table.set_precision(name, 2);
            table.set_scientific(name, true);
            if (!refined.empty())
              table.evaluate_convergence_rates(
                name, key, ConvergenceTable::reduction_rate_log2, 1);
          }
      return table;
    }



    /** All tables of a study. */
    void
    write_tables(const Study &study, std::ostream &file)
    {
      for (unsigned int set = 0; set <= study.runs().back().set; ++set)
        {
          const std::string refined = refined_entry(study, set);
          for (const auto &[name, runs] : group(study, set, refined))
            {
              file << (name.empty() ? "scene of the file" : name) << '\n';
              std::vector<const StudyRun *> done;
              for (const StudyRun *run : runs)
                if (run->failure.empty())
                  done.push_back(run);
                else
                  file << "failed: " << run->failure << '\n';
              if (!done.empty())
                make_table(done, refined).write_text(file);
              file << '\n';
            }
        }
    }



    /** The run of least time that meets the target; null if there is none. */
    const StudyRun *
    cheapest(const Study &study)
    {
      const StudyRun *best = nullptr;
      for (const StudyRun &run : study.runs())
        if (run.error &&
            run.error->maximum[Trajectory::displacement_end] <=
              study.parameters().target_error &&
            (best == nullptr ||
             minimum(run.loop_seconds) < minimum(best->loop_seconds)))
          best = &run;
      return best;
    }
  } // namespace



  void
  write_study(const std::string &directory,
              const std::string &title,
              const Study       &study)
  {
    const MPI_Comm communicator = MPI_COMM_WORLD;
    std::string    fault;
    if (Utilities::MPI::this_mpi_process(communicator) == 0)
      {
        std::ofstream csv(directory + "/study.csv");
        csv << "# " << title << "\n# thermocontact " << version()
            << ", deal.II " << DEAL_II_PACKAGE_VERSION << '\n';
        const CsvColumns<StudyRow> columns = make_columns(study);
        std::string                rows    = csv_head(columns);
        for (unsigned int i = 0; i < study.runs().size(); ++i)
          append_csv_row(columns,
                         {i, study.runs()[i], error_of(study.runs()[i])},
                         rows);
        csv << rows;

        std::ofstream table(directory + "/study.txt");
        write_tables(study, table);
        for (const auto &[file, name] : {std::make_pair(&csv, "study.csv"),
                                         std::make_pair(&table, "study.txt")})
          if (!file->flush())
            fault = directory + "/" + name +
                    ": cannot be written\n  remedy:  check free space and "
                    "rights";
      }
    throw_everywhere<ComputationError>(fault, communicator);
  }



  void
  report_study(const Study &study, Log &log)
  {
    if (Utilities::MPI::this_mpi_process(MPI_COMM_WORLD) != 0)
      return;
    unsigned int n_failed = 0;
    for (const StudyRun &run : study.runs())
      n_failed += !run.failure.empty();
    log.line(text(
      "  study     ", study.runs().size(), " runs, ", n_failed, " failed"));
    const double target = study.parameters().target_error;
    if (!(target > 0.))
      return;

    const StudyRun *best = cheapest(study);
    if (best == nullptr)
      return log.line(text("  cheapest  No run has an error of "
                           "displacement_end of at most ",
                           target,
                           '.'));
    std::string line = text("  cheapest  The cheapest run with an error of "
                            "displacement_end of at most ",
                            target,
                            " has");
    for (unsigned int e = 0; e < best->entries.size(); ++e)
      line +=
        (e > 0 ? ", " : " ") + study.varied()[e] + " = " + best->entries[e];
    log.line(line + text(": error ",
                         best->error->maximum[Trajectory::displacement_end],
                         ", ",
                         best->n_solves,
                         " solves, ",
                         minimum(best->loop_seconds),
                         " s."));
  }
} // namespace ThermoContact
