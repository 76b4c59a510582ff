// SPDX-License-Identifier: LGPL-2.1-or-later

#include <thermocontact/base/collective.h>
#include <thermocontact/base/exceptions.h>
#include <thermocontact/base/text.h>
#include <thermocontact/base/writable_file.h>
#include <thermocontact/study/study.h>

#include <deal.II/base/convergence_table.h>

#include <algorithm>
#include <filesystem>
#include <map>
#include <regex>
#include <set>
#include <sstream>

namespace ThermoContact
{
  namespace
  {
    /**
     * The entry that a set of runs refines. Errors fall in powers of step
     * size, tolerance and number of cells; of these entries the last one that
     * has several values, all of them numbers. Empty: there is none.
     */
    std::string
    refined_entry(const StudyTable                &study,
                  const std::vector<unsigned int> &runs)
    {
      std::map<std::string, std::set<std::string>> values; // without units
      for (const unsigned int run : runs)
        for (const auto &[path, value] : study.plan.overrides(run))
          values[path].insert(study.words(run, path));
      std::string refined;
      for (const std::string &path : study.plan.varied)
        if ((path == "Time/Step size" || path == "Time/Tolerance" ||
             path == "Mesh/Cells") &&
            values[path].size() > 1 &&
            std::all_of(values[path].begin(),
                        values[path].end(),
                        [](const std::string &value) {
                          return parse_number(value).has_value();
                        }))
          refined = path;
      return refined;
    }



    /** The runs of a set that differ in the refined entry alone, by the rest.
     */
    std::map<std::string, std::vector<unsigned int>>
    group(const StudyPlan                 &plan,
          const std::vector<unsigned int> &runs,
          const std::string               &refined)
    {
      std::map<std::string, std::vector<unsigned int>> groups;
      for (const unsigned int run : runs)
        {
          std::vector<std::string> others;
          for (const auto &[path, value] : plan.overrides(run))
            if (path != refined)
              others.push_back(path + " = " + value);
          groups[join_words(others)].push_back(run);
        }
      return groups;
    }



    /** One table for runs that differ in the refined entry alone. */
    ConvergenceTable
    make_table(const StudyTable                &study,
               const std::vector<unsigned int> &runs,
               const std::string               &refined)
    {
      // cells become more, steps and tolerances smaller
      const bool        grows = refined.rfind("Mesh/", 0) == 0;
      const std::string key =
        refined.empty() ? "run" : (grows ? "" : "1/") + refined;
      std::vector<std::pair<std::string, std::string>> errors; // name, column
      if (study.plan.reference)
        for (unsigned int q = 0; q < Trajectory::energy; ++q)
          {
            const std::string name = Trajectory::names[q];
            errors.emplace_back(name, "error_" + name);
            errors.emplace_back("final " + name, "final_error_" + name);
          }

      ConvergenceTable table;
      unsigned int     n = 0;
      for (const unsigned int run : runs)
        {
          if (refined.empty())
            table.add_value(key, n++);
          else
            {
              const double value = study.number(run, refined);
              table.add_value(key, grows ? value : 1. / value);
            }
          for (const std::string name : {"dofs", "steps", "solves"})
            table.add_value(name,
                            static_cast<unsigned int>(study.number(run, name)));
          for (const auto &[name, column] : errors)
            table.add_value(name, study.number(run, column));
        }
      for (const auto &[name, column] : errors)
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
    std::string
    text_tables(const StudyTable &study)
    {
      std::ostringstream text;
      for (unsigned int set = 0; set < study.plan.sets.size(); ++set)
        {
          std::vector<unsigned int> of_set;
          for (unsigned int run = 0; run < study.plan.n_runs(); ++run)
            if (study.plan.set_of(run) == set)
              of_set.push_back(run);
          const std::string refined = refined_entry(study, of_set);
          for (const auto &[name, runs] : group(study.plan, of_set, refined))
            {
              text << (name.empty() ? "scene of the file" : name) << '\n';
              std::vector<unsigned int> done;
              for (const unsigned int run : runs)
                if (const std::string failure = study.failure(run);
                    failure.empty())
                  done.push_back(run);
                else
                  text << failure << '\n';
              if (!done.empty())
                make_table(study, done, refined).write_text(text);
              text << '\n';
            }
        }
      return text.str();
    }



    /** A word in a cell of a Markdown table. */
    std::string
    cell(const std::string &word)
    {
      std::string result;
      for (const char letter : word)
        result += letter == '|' ? "\\|" : std::string(1, letter);
      return result + " | ";
    }



    /** Warnings of runs that are the same but for their numbers. */
    struct RepeatedWarning
    {
      std::string               text; ///< of the first of these runs
      std::vector<unsigned int> runs;
      bool                      is_same = true; ///< numbers are, too
    };



    /** The warnings of all runs, in the order in which they came first. */
    std::vector<RepeatedWarning>
    repeated_warnings(const StudyTable &study)
    {
      const std::regex             number(R"([-+]?\b\d+(\.\d+)?(e[-+]?\d+)?)");
      std::vector<RepeatedWarning> kinds;
      std::map<std::string, unsigned int> places;
      for (unsigned int run = 0; run < study.plan.n_runs(); ++run)
        for (const std::string &text : study.warnings(run))
          {
            const auto [place, is_new] =
              places.emplace(std::regex_replace(text, number, "0"),
                             kinds.size());
            if (is_new)
              kinds.push_back({text, {}});
            RepeatedWarning &warning = kinds[place->second];
            warning.is_same &= text == warning.text;
            if (warning.runs.empty() || warning.runs.back() != run)
              warning.runs.push_back(run);
          }
      return kinds;
    }



    /** "run 3", "runs 0 to 5, 7". */
    std::string
    describe_runs(const std::vector<unsigned int> &runs)
    {
      std::vector<std::string> ranges;
      for (std::size_t begin = 0; begin < runs.size();)
        {
          std::size_t end = begin + 1;
          while (end < runs.size() && runs[end] == runs[end - 1] + 1)
            ++end;
          if (end - begin > 2)
            ranges.push_back(text(runs[begin], " to ", runs[end - 1]));
          else
            for (std::size_t i = begin; i < end; ++i)
              ranges.push_back(text(runs[i]));
          begin = end;
        }
      return (runs.size() == 1 ? "run " : "runs ") + join_words(ranges);
    }



    /** A line for each warning, with the runs that have it. */
    std::vector<std::string>
    describe_warnings(const StudyTable &study)
    {
      std::vector<std::string> lines;
      for (const RepeatedWarning &warning : repeated_warnings(study))
        lines.push_back(
          describe_runs(warning.runs) + ": " + warning.text +
          (warning.is_same ?
             "" :
             text(" (numbers of run ", warning.runs.front(), ")")));
      return lines;
    }



    /** A table of what was varied and came out, with links to kept files. */
    std::string
    markdown_table(const StudyTable  &study,
                   const std::string &title,
                   const std::string &directory)
    {
      std::vector<std::string> names = study.plan.varied;
      names.push_back("status");
      for (const std::string &name : key_result_names())
        for (unsigned int i = 0; i < study.plan.n_runs(); ++i)
          if (parse_number(study.words(i, name)))
            {
              names.push_back(name);
              break;
            }
      std::string page =
        "# " + (title.empty() ? "Study" : title) + "\n\n| run | ";
      std::string line = "| --- | ";
      for (const std::string &name : names)
        {
          const std::string unit = study.unit(name);
          page += cell(unit.empty() ? name : name + " [" + unit + "]");
          line += "--- | ";
        }
      page += '\n' + line + '\n';
      for (unsigned int run = 0; run < study.plan.n_runs(); ++run)
        {
          page += std::filesystem::exists(text(directory, "/run-", run)) ?
                    text("| [", run, "](run-", run, "/) | ") :
                    text("| ", run, " | ");
          for (const std::string &name : names)
            {
              const std::string &words  = study.words(run, name);
              const auto         number = name.find('/') == std::string::npos ?
                                            parse_number(words) :
                                            std::nullopt;
              page += cell(number ? significant(*number, 6) : words);
            }
          page += '\n';
        }
      const std::vector<std::string> warnings = describe_warnings(study);
      if (!warnings.empty())
        page += "\n## Warnings\n\n";
      for (const std::string &warning : warnings)
        page += "* " + warning + '\n';
      return page;
    }



    /** Of the run of least time that meets the target. */
    std::string
    describe_cheapest(const StudyTable &study, const double target)
    {
      std::optional<unsigned int> best;
      for (unsigned int run = 0; run < study.plan.n_runs(); ++run)
        if (study.failure(run).empty() &&
            study.number(run, "error_displacement_end") <=
              study.units.of("length")(target) &&
            (!best || study.number(run, "loop_seconds") <
                        study.number(*best, "loop_seconds")))
          best = run;
      if (!best)
        return text("  cheapest  No run has an error of displacement_end of at "
                    "most ",
                    study.units.text("length", target),
                    '.');
      std::vector<std::string> entries;
      for (const std::string &path : study.plan.varied)
        entries.push_back(path + " = " + study.words(*best, path));
      return text("  cheapest  The cheapest run with an error of "
                  "displacement_end of at most ",
                  study.units.text("length", target),
                  " has ",
                  join_words(entries),
                  ": error ",
                  study.number(*best, "error_displacement_end"),
                  study.units.is_si() ? " m" : "",
                  ", ",
                  study.words(*best, "solves"),
                  " solves, ",
                  study.number(*best, "loop_seconds"),
                  " s.");
    }
  } // namespace



  void
  write_study_tables(const std::string &directory,
                     const std::string &title,
                     const StudyTable  &study)
  {
    std::string fault;
    if (Utilities::MPI::this_mpi_process(MPI_COMM_WORLD) == 0)
      {
        fault = write_atomically(directory + "/study.txt", text_tables(study));
        if (fault.empty())
          fault = write_atomically(directory + "/study.md",
                                   markdown_table(study, title, directory));
      }
    throw_everywhere<ComputationError>(fault, MPI_COMM_WORLD);
  }



  void
  report_study(const StudyTable &study, const double target, Log &log)
  {
    std::string fault;
    if (Utilities::MPI::this_mpi_process(MPI_COMM_WORLD) == 0)
      {
        unsigned int n_failed = 0;
        for (unsigned int run = 0; run < study.plan.n_runs(); ++run)
          n_failed += !study.failure(run).empty();
        for (const std::string &warning : describe_warnings(study))
          log.line("  warning:  " + warning);
        log.line(text(
          "  study     ", study.plan.n_runs(), " runs, ", n_failed, " failed"));
        if (target > 0.)
          log.line(describe_cheapest(study, target));
        if (n_failed > 0)
          fault = text(n_failed,
                       " of ",
                       study.plan.n_runs(),
                       " runs failed: the reasons are above and in study.csv");
      }
    throw_everywhere<ComputationError>(fault, MPI_COMM_WORLD);
  }
} // namespace ThermoContact
