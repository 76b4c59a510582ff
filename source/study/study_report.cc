// SPDX-License-Identifier: LGPL-2.1-or-later

#include <thermocontact/base/exceptions.h>
#include <thermocontact/base/version.h>
#include <thermocontact/output/output_directory.h>
#include <thermocontact/study/study_report.h>

#include <deal.II/base/convergence_table.h>
#include <deal.II/base/revision.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <fstream>
#include <functional>
#include <limits>
#include <map>
#include <set>
#include <sstream>

namespace ThermoContact
{
  namespace
  {
    const double nan = std::numeric_limits<double>::quiet_NaN();

    /** A field of a CSV row; quoted where it has to be. */
    std::string
    field(std::string text)
    {
      for (char &c : text)
        if (c == '\n')
          c = ' ';
      if (text.find_first_of(",\"") == std::string::npos)
        return text;
      std::string quoted = "\"";
      for (const char c : text)
        quoted += c == '"' ? std::string("\"\"") : std::string(1, c);
      return quoted + '"';
    }



    std::string
    number(const double value)
    {
      char text[32];
      std::snprintf(text, sizeof(text), "%.17g", value);
      return text;
    }



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
    const Trajectory::Quantity columns[] = {Trajectory::displacement_end,
                                            Trajectory::velocity_end,
                                            Trajectory::contact_force,
                                            Trajectory::temperature_end};



    void
    write_header(const Study &study, std::ostream &file)
    {
      file << "run";
      for (const std::string &path : study.varied())
        file << ',' << field(path);
      file << ",status,dofs,steps,rejected_steps,factorizations,solves,"
              "loop_seconds";
      for (const auto q : columns)
        file << ",error_" << Trajectory::names[q];
      file << ",error_first_contact_time,error_energy,loop_seconds_median";
      for (const auto q : columns)
        file << ",final_error_" << Trajectory::names[q];
      file << ",final_error_energy\n";
    }



    void
    write_row(const unsigned int i, const StudyRun &run, std::ostream &file)
    {
      const Trajectory::Difference error = error_of(run);
      file << i;
      for (const std::string &value : run.entries)
        file << ',' << field(value);
      file << ','
           << (run.failure.empty() ? "done" : field("failed: " + run.failure))
           << ',' << run.n_dofs << ',' << run.n_steps << ','
           << run.n_rejected_steps << ',' << run.n_factorizations << ','
           << run.n_solves << ',' << number(minimum(run.loop_seconds));
      for (const auto q : columns)
        file << ',' << number(error.maximum[q]);
      file << ',' << number(error.first_contact_time) << ','
           << number(error.maximum[Trajectory::energy]) << ','
           << number(median(run.loop_seconds));
      for (const auto q : columns)
        file << ',' << number(error.final_value[q]);
      file << ',' << number(error.final_value[Trajectory::energy]) << '\n';
    }



    /** The number that @p text is; NaN if it is none. */
    double
    to_number(const std::string &text)
    {
      std::istringstream stream(text);
      double             value = 0.;
      return stream >> value && stream.peek() == EOF ? value : nan;
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
      for (const auto q : columns)
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
        write_header(study, csv);
        for (unsigned int i = 0; i < study.runs().size(); ++i)
          write_row(i, study.runs()[i], csv);

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
    std::ostringstream line;
    line << "  study     " << study.runs().size() << " runs, " << n_failed
         << " failed";
    log.line(line.str());
    if (!(study.parameters().target_error > 0.))
      return;

    line.str("");
    line << "  cheapest  ";
    if (const StudyRun *best = cheapest(study); best != nullptr)
      {
        line << "The cheapest run with an error of displacement_end of at most "
             << study.parameters().target_error << " has";
        for (unsigned int e = 0; e < best->entries.size(); ++e)
          line << (e > 0 ? ", " : " ") << study.varied()[e] << " = "
               << best->entries[e];
        line << ": error " << best->error->maximum[Trajectory::displacement_end]
             << ", " << best->n_solves << " solves, "
             << minimum(best->loop_seconds) << " s.";
      }
    else
      line << "No run has an error of displacement_end of at most "
           << study.parameters().target_error << '.';
    log.line(line.str());
  }
} // namespace ThermoContact
