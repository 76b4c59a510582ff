// SPDX-License-Identifier: LGPL-2.1-or-later
//
// usage: thermocontact_test_driver TEST.prm
//
// Runs the program as the lines of TEST.prm that begin with "#$ " say, e.g.
//
//   #$ FILE --set 'Time/Step size=0.03'
//
// where FILE stands for TEST.prm itself and PRM for the folder of published
// parameter files; without such a line it runs "FILE" once. "#$ -n 2 ..." runs
// on two ranks. Prints each command, what the program wrote to standard error,
// its exit status, and, for an output directory, the names of its files, the
// entries of summary.json that a line "#? key key ..." names, and what the
// script of a line "#! SCRIPT" beside TEST.prm says about it; of a command that
// is refused, with 2 and no file, the message alone, which says what is wrong.
// A line "#% COMMAND" is run by the shell before all others, e.g. to make a
// file that cannot be kept here. Files that a run leaves outside of the output
// directory are named.
//
// A run is a child of thermocontact_forks, which runs this driver again, but
// for those on ranks and those that read the standard input.

#include <nlohmann/json.hpp>
#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <set>
#include <sstream>
#include <string>
#include <vector>

namespace
{
  namespace fs = std::filesystem;

  std::string
  replace_all(std::string text, const std::string &from, const std::string &to)
  {
    for (auto at = text.find(from); at != std::string::npos;
         at      = text.find(from, at + to.size()))
      text.replace(at, from.size(), to);
    return text;
  }



  /** The rests of all lines that begin with @p mark. */
  std::vector<std::string>
  marked_lines(const fs::path &file_name, const std::string &mark)
  {
    std::vector<std::string> lines;
    std::ifstream            file(file_name);
    for (std::string line; std::getline(file, line);)
      if (line.rfind(mark, 0) == 0)
        lines.push_back(line.substr(mark.size()));
    return lines;
  }



  /** Names of the files in the working directory, but for the driver's own. */
  std::set<std::string>
  working_files()
  {
    std::set<std::string> names;
    for (const auto &entry : fs::directory_iterator("."))
      names.insert(entry.path().filename());
    names.erase("results");
    names.erase("stderr");
    return names;
  }



  /**
   * What the program wrote to the file stderr. The meaning of an entry, which
   * is that of doc/parameters.md, is in it the first time.
   */
  std::string
  program_message(std::set<std::string> &meanings)
  {
    // the program's own words: MPI may complain of the machine first, and
    // mpirun of the exit status afterwards, below a line of dashes
    std::ifstream     file("stderr");
    std::stringstream contents;
    contents << file.rdbuf();
    const auto begin = contents.str().find("thermocontact: ");
    if (begin == std::string::npos)
      return "";
    const auto         end = contents.str().find("--------", begin);
    std::istringstream words(contents.str().substr(begin, end - begin));
    std::string        result;
    for (std::string line; std::getline(words, line);)
      if (line.rfind("  meaning: ", 0) != 0 || meanings.insert(line).second)
        result += line + '\n';
    return result;
  }



  /** Its exit status; what it says on standard error is in the file stderr. */
  int
  run_program(const std::string &arguments, const std::string &launcher)
  {
    const std::string options = " --quiet --output results " + arguments;
    std::cout << std::flush;
    const bool forked =
      launcher.empty() && arguments.find(" < ") == std::string::npos;
    const int status = std::system(
      (launcher + (forked ? FORKED : PROGRAM) + options + " > said 2> stderr")
        .c_str());
    std::stringstream said;
    said << std::ifstream("said").rdbuf();
    std::cout << said.str();
    fs::remove("said");
    return WEXITSTATUS(status);
  }



  void
  print_output_directory(const fs::path &directory, const std::string &keys)
  {
    std::vector<std::string> names;
    for (const auto &entry : fs::directory_iterator(directory))
      names.push_back(entry.path().filename());
    std::sort(names.begin(), names.end());
    std::cout << ", files:";
    for (const std::string &name : names)
      std::cout << ' ' << name;
    std::cout << '\n';

    if (!fs::exists(directory / "summary.json"))
      return; // a study
    std::ifstream      file(directory / "summary.json");
    const auto         summary = nlohmann::json::parse(file);
    std::istringstream stream(keys);
    std::string        separator;
    for (std::string key; stream >> key; separator = ", ")
      std::cout << separator << key << ": " << summary.at(key);
    std::cout << (separator.empty() ? "" : "\n");
  }
} // namespace



int
main(int, char **argv)
{
  if (std::getenv("THERMOCONTACT_FORKS") == nullptr)
    return execl(FORKS, FORKS, argv[0], argv[1], nullptr);
  const fs::path        test       = argv[1];
  const std::string     test_dir   = test.parent_path().string() + "/";
  const std::string     prm_dir    = PRM_DIR;
  const auto            questions  = marked_lines(test, "#? ");
  auto                  arguments  = marked_lines(test, "#$ ");
  const fs::path        output_dir = "results";
  std::set<std::string> meanings;
  if (arguments.empty())
    arguments.emplace_back("FILE");

  // In the directory of the test, "NAME.release", what its last run has left;
  // files are its output and written anew.
  std::vector<fs::path> directories;
  if (fs::current_path().stem() == test.stem())
    for (const fs::directory_entry &entry : fs::directory_iterator("."))
      if (entry.is_directory())
        directories.push_back(entry.path());
  for (const fs::path &directory : directories)
    fs::remove_all(directory);

  setenv("THERMOCONTACT", PROGRAM, 1); // for the scripts
  for (const std::string &line : marked_lines(test, "#% "))
    if (const std::string shell_command = replace_all(line, "PRM", prm_dir);
        std::system(shell_command.c_str()) != 0)
      std::cout << shell_command << " failed" << std::endl;
  for (const std::string &argument : arguments)
    {
      fs::remove_all(output_dir);
      const bool        on_ranks = argument.rfind("-n ", 0) == 0;
      const std::string launcher =
        on_ranks ? "mpirun --allow-run-as-root --oversubscribe " +
                     argument.substr(0, 4) + " " :
                   "";
      const auto files_before = working_files();
      const int  status =
        run_program(replace_all(replace_all(on_ranks ? argument.substr(5) :
                                                       argument,
                                            "FILE",
                                            test.string()),
                                "PRM",
                                prm_dir),
                    launcher);
      const bool is_refused = status == 2 && working_files() == files_before &&
                              !fs::exists(output_dir);
      if (!is_refused)
        std::cout << "$ thermocontact " << argument << '\n';
      std::cout << replace_all(
        replace_all(program_message(meanings), test_dir, ""), prm_dir, "prm");
      if (is_refused)
        continue;
      std::cout << "exit status " << status;
      for (const std::string &name : working_files())
        if (files_before.count(name) == 0)
          std::cout << ", new file " << name;
      if (fs::exists(output_dir / "summary.json") ||
          fs::exists(output_dir / "study.csv"))
        {
          print_output_directory(output_dir,
                                 questions.empty() ? "" : questions[0]);
          for (const std::string &script : marked_lines(test, "#! "))
            {
              std::cout << std::flush;
              if (std::system(
                    ("/usr/bin/python3 " + test_dir + script + " results 2>&1")
                      .c_str()) != 0)
                std::cout << script << " failed" << std::endl;
            }
        }
      else
        std::cout << (fs::exists(output_dir) ? "" : ", no output directory")
                  << '\n';
    }
  return 0;
}
