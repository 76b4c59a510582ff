// SPDX-License-Identifier: LGPL-2.1-or-later

#include <thermocontact/base/collective.h>
#include <thermocontact/base/csv_columns.h>
#include <thermocontact/base/exceptions.h>
#include <thermocontact/base/special_numbers.h>
#include <thermocontact/base/writable_file.h>
#include <thermocontact/input/si_scene.h>
#include <thermocontact/study/study_table.h>

#include <fcntl.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cmath>
#include <cstring>
#include <fstream>

namespace ThermoContact
{
  namespace
  {
    /** The middle of numbers in order of size; NaN if there are none. */
    double
    median(const std::vector<double> &sorted)
    {
      const auto n = sorted.size();
      return n == 0 ? nan : 0.5 * (sorted[(n - 1) / 2] + sorted[n / 2]);
    }



    /** In a field of study.csv. */
    const std::string between_warnings = " | ";



    /** The parts of a row of study.csv. */
    struct StudyRow
    {
      unsigned int             number; ///< of the run
      std::vector<std::string> entries;
      const StudyRun          &run;
    };



    /** The columns of study.csv. */
    CsvColumns<StudyRow>
    make_columns(const StudyPlan &plan)
    {
      CsvColumns<StudyRow> columns = {{"run", &StudyRow::number}};
      for (unsigned int e = 0; e < plan.varied.size(); ++e)
        columns.emplace_back(plan.varied[e], [e](const StudyRow &row) {
          return row.entries[e];
        });
      columns.emplace_back("status", [](const StudyRow &row) {
        return row.run.failure.empty() ? "done" : "failed: " + row.run.failure;
      });
      for (const std::string name :
           {"dofs", "steps", "rejected_steps", "factorizations", "solves"})
        columns.emplace_back(name, [name](const StudyRow &row) {
          const auto found = row.run.counts.find(name);
          return found == row.run.counts.end() ? 0u : found->second;
        });
      columns.emplace_back("loop_seconds", [](const StudyRow &row) {
        return row.run.loop_seconds.empty() ? nan :
                                              row.run.loop_seconds.front();
      });
      const auto add_largest = [&columns](const unsigned int q) {
        columns.emplace_back(std::string("error_") + Trajectory::names[q],
                             [q](const StudyRow &row) {
                               return row.run.error.maximum[q];
                             });
      };
      for (unsigned int q = 0; q < Trajectory::energy; ++q)
        add_largest(q);
      columns.emplace_back("error_first_contact_time", [](const StudyRow &row) {
        return row.run.error.first_contact_time;
      });
      add_largest(Trajectory::energy);
      columns.emplace_back("loop_seconds_median", [](const StudyRow &row) {
        return median(row.run.loop_seconds);
      });
      for (unsigned int q = 0; q < Trajectory::n_quantities; ++q)
        columns.emplace_back(std::string("final_error_") + Trajectory::names[q],
                             [q](const StudyRow &row) {
                               return row.run.error.final_value[q];
                             });
      for (const std::string &name : key_result_names())
        columns.emplace_back(name, [name](const StudyRow &row) {
          const auto found = row.run.key_results.find(name);
          return found == row.run.key_results.end() ? nan : found->second;
        });
      columns.emplace_back("warnings", [](const StudyRow &row) {
        return static_cast<unsigned int>(row.run.warnings.size());
      });
      columns.emplace_back("warning_texts", [](const StudyRow &row) {
        std::string texts;
        for (const std::string &warning : row.run.warnings)
          texts += (texts.empty() ? "" : between_warnings) + warning;
        return texts;
      });
      return columns;
    }



    /** Of its columns; entries are in SI base units if the file is in SI. */
    Conversions
    conversions_of(const StudyPlan &plan, const Parameters &parameters)
    {
      Conversions conversions =
        OutputUnits(parameters).of_columns("study.csv", make_columns(plan));
      if (!conversions.empty() && parameters.rod.is_given())
        for (unsigned int i = 0; i < plan.varied.size(); ++i)
          conversions[i + 1].unit = unit_of_entry(plan.varied[i]);
      return conversions;
    }
  } // namespace



  StudyTable::StudyTable(const StudyPlan   &plan,
                         const std::string &file_name,
                         const Parameters  &parameters)
    : names(names_of(make_columns(plan)))
    , plan(plan)
    , units(parameters)
    , file_name(file_name)
    , parameters(parameters)
    , head(csv_comments(parameters.title) +
           csv_head(make_columns(plan), conversions_of(plan, parameters)))
  {}



  std::string
  StudyTable::append(const unsigned int run, const StudyRun &result) const
  {
    // the scales are those of the run, the units those of the head
    Parameters scene = parameters;
    if (result.scales.is_given())
      scene.scales = result.scales;
    scene.scales.time_unit        = parameters.scales.time_unit;
    scene.scales.temperature_unit = parameters.scales.temperature_unit;
    std::string row;
    append_csv_row(make_columns(plan),
                   {run, plan.entries(run), result},
                   row,
                   conversions_of(plan, scene));
    // one call, so that rows of several ranks do not mix
    const int file  = open(file_name.c_str(), O_WRONLY | O_APPEND | O_CLOEXEC);
    const ssize_t n = file < 0 ? -1 : write(file, row.data(), row.size());
    const int     fault = n < 0 ? errno : ENOSPC;
    if (file >= 0)
      close(file);
    if (n == static_cast<ssize_t>(row.size()))
      return "";
    return file_name + ": cannot be written: " + std::strerror(fault) +
           "\n  remedy:  check free space and rights, then go on with --resume";
  }



  std::vector<unsigned int>
  StudyTable::read_on()
  {
    const auto fail = [this](const std::string &what) {
      throw InputError(file_name + ": " + what +
                       "\n  remedy:  run without --resume, which begins the "
                       "study anew, or give another Output/Directory");
    };
    std::ifstream             file(file_name);
    std::vector<unsigned int> numbers;
    std::string               line;
    if (n_read == 0)
      {
        do
          std::getline(file, line);
        while (file && !line.empty() && line[0] == '#');
        if (split_row(line) != names)
          fail("it has not the columns of this study");
        n_read = file.tellg();
      }
    file.seekg(n_read);
    while (std::getline(file, line) && !file.eof())
      {
        n_read                               = file.tellg();
        const std::vector<std::string> words = split_row(line);
        if (words.size() != names.size())
          continue;
        const double number = parse_number(words[0]).value_or(-1.);
        if (!(number >= 0. && number < plan.n_runs() &&
              number == std::floor(number)))
          fail("run " + words[0] + " is none of this study's");
        const unsigned int             run     = number;
        const std::vector<std::string> entries = plan.entries(run);
        if (!std::equal(entries.begin(), entries.end(), words.begin() + 1))
          fail("run " + words[0] + " has other entries in this study");
        rows[run] = words;
        numbers.push_back(run);
      }
    return numbers;
  }



  std::string
  StudyTable::sort()
  {
    std::string text = head;
    for (const auto &[run, words] : rows)
      text += csv_row(words);
    n_read = text.size();
    return write_atomically(file_name, text);
  }



  std::vector<unsigned int>
  StudyTable::missing_runs() const
  {
    std::vector<unsigned int> runs;
    for (unsigned int run = 0; run < plan.n_runs(); ++run)
      if (!has(run))
        runs.push_back(run);
    return broadcast(MPI_COMM_WORLD, runs);
  }



  const std::string &
  StudyTable::words(const unsigned int run, const std::string &name) const
  {
    const auto column = std::find(names.begin(), names.end(), name);
    return rows.at(run)[column - names.begin()];
  }



  std::string
  StudyTable::unit(const std::string &name) const
  {
    const Conversions conversions = conversions_of(plan, parameters);
    const auto        column      = std::find(names.begin(), names.end(), name);
    return conversions.empty() ? "" : conversions[column - names.begin()].unit;
  }



  double
  StudyTable::number(const unsigned int run, const std::string &name) const
  {
    return parse_number(words(run, name)).value_or(nan);
  }



  std::string
  StudyTable::failure(const unsigned int run) const
  {
    const std::string &status = words(run, "status");
    return status == "done" ? "" : status;
  }



  std::vector<std::string>
  StudyTable::warnings(const unsigned int run) const
  {
    const std::string       &texts = words(run, "warning_texts");
    std::vector<std::string> parts;
    for (std::size_t start = 0; start < texts.size();)
      {
        const std::size_t end =
          std::min(texts.find(between_warnings, start), texts.size());
        parts.push_back(texts.substr(start, end - start));
        start = end + between_warnings.size();
      }
    return parts;
  }
} // namespace ThermoContact
