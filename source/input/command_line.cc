// SPDX-License-Identifier: LGPL-2.1-or-later

#include <thermocontact/base/exceptions.h>
#include <thermocontact/base/text.h>
#include <thermocontact/input/command_line.h>
#include <thermocontact/input/unknown_names.h>

#include <getopt.h>

#include <algorithm>
#include <cstring>
#include <filesystem>
#include <iterator>

namespace ThermoContact
{
  std::string
  help_text()
  {
    return R"(Usage: thermocontact [OPTIONS] FILE.prm

Dynamic contact of a thermoviscoelastic rod with an elastic or rigid obstacle.
FILE.prm may be -, the standard input.

  --set 'Section/Entry=value'  override one entry of FILE.prm; repeatable
  --output DIR                 short for --set Output/Directory=DIR
  --check                      read and check everything, print the scene, stop
  --print-parameters[=FORMAT]  print all entries; FORMAT: prm, json, description,
                               markdown; with FILE.prm, its values
  --print-output               print what the files of a run hold, in Markdown
  --resume                     go on from the newest checkpoint in the output
                               directory
  --units                      print the scene of FILE.prm, whose section Rod makes
                               it one in SI units, without units, stop
  --force                      run even if the disk of the results is too small
  --quiet                      print nothing but errors
  --help, --version

Exit status: 0 done, 1 the computation failed, 2 the input is wrong.
)";
  }



  namespace
  {
    /** An option, and what it sets if it has no argument. */
    struct Option
    {
      const char *name;
      int         argument; ///< as getopt_long() wants it
      bool CommandLine::*flag;
    };

    const Option all_options[] = {
      {"set", required_argument, nullptr},
      {"output", required_argument, nullptr},
      {"print-parameters", optional_argument, nullptr},
      {"check", no_argument, &CommandLine::check_only},
      {"print-output", no_argument, &CommandLine::show_output},
      {"resume", no_argument, &CommandLine::is_resumed},
      {"units", no_argument, &CommandLine::prints_scene},
      {"force", no_argument, &CommandLine::is_forced},
      {"quiet", no_argument, &CommandLine::is_quiet},
      {"help", no_argument, &CommandLine::show_help},
      {"version", no_argument, &CommandLine::show_version}};

    constexpr int n_options = std::size(all_options); // letters are larger



    const std::string remedy_for_directory =
      "--output DIR names the directory of the run; --resume stands alone";



    [[noreturn]] void
    refuse_argument(const std::string &argument,
                    const std::string &fault,
                    const std::string &remedy = "--help lists the options")
    {
      throw InputError(std::string(command_line_place) + ": " +
                       quote(argument) + ": " + fault +
                       "\n  remedy:  " + remedy);
    }



    std::vector<std::string>
    names_of_options()
    {
      std::vector<std::string> names;
      for (const Option &one : all_options)
        names.push_back(std::string("--") + one.name);
      return names;
    }



    /** True for an option with a value that it does not take. */
    bool
    has_needless_value(const std::string &word)
    {
      return std::any_of(std::begin(all_options),
                         std::end(all_options),
                         [&word](const Option &one) {
                           return one.argument == no_argument &&
                                  begins_with(word,
                                              std::string("--") + one.name +
                                                "=");
                         });
    }



    /**
     * @param option its number in all_options, from 1, or getopt_long()'s sign
     * @param argument of the option, or null
     * @param word as typed
     */
    void
    apply_option(const int          option,
                 const char        *argument,
                 const std::string &word,
                 CommandLine       &command_line)
    {
      if (option == ':')
        refuse_argument(word, "its argument is missing");
      if (has_needless_value(word))
        refuse_argument(word,
                        "the option takes no value",
                        begins_with(word, "--resume") ?
                          remedy_for_directory :
                          word.substr(0, word.find('=')));
      if (option < 1 || option > n_options)
        refuse_argument(word,
                        word.compare(0, 2, "--") == 0 ?
                          "unknown or ambiguous option" +
                            did_you_mean(word, names_of_options()) :
                          "no option; a file of that name is ./" + word);
      const auto &[name, has_argument, flag] = all_options[option - 1];
      if (has_argument == no_argument)
        command_line.*flag = true;
      else if (has_argument == optional_argument)
        command_line.print_parameters = argument ? argument : "prm";
      else if (std::strcmp(name, "set") == 0)
        command_line.overrides.push_back(parse_override(argument));
      else
        command_line.overrides.push_back(
          {command_line_place, "Output/Directory", argument});
    }



    /** The argument that the last call of getopt_long() was about. */
    std::string
    last_word(const int argc, char **argv)
    {
      // in letters behind one '-', getopt stops before it goes on in argv
      if (optopt > n_options)
        for (int i = 1; i < argc; ++i)
          if (argv[i][0] == '-' && argv[i][1] != '-' &&
              std::strchr(argv[i], optopt) != nullptr)
            return argv[i];
      return argv[optind - 1];
    }



    void
    check_format(const std::string &format)
    {
      if (!format.empty() && format != "prm" && format != "json" &&
          format != "description" && format != "markdown")
        throw InputError(
          std::string(command_line_place) +
          ": --print-parameters=" + quote(format) +
          ": unknown format\n  allowed: prm | json | description | markdown");
    }
  } // namespace



  CommandLine
  parse_command_line(const int argc, char **argv)
  {
    CommandLine command_line;
    command_line.program_name = argv[0];
    std::vector<option> options;
    for (const Option &one : all_options)
      options.push_back({one.name,
                         one.argument,
                         nullptr,
                         static_cast<int>(options.size()) + 1});
    options.push_back({nullptr, 0, nullptr, 0});
    opterr = 0; // messages are ours
    for (int o;
         optopt = 0,
         (o = getopt_long(argc, argv, ":", options.data(), nullptr)) != -1;)
      apply_option(o, optarg, last_word(argc, argv), command_line);

    // a directory behind --resume is taken for a file
    for (int i = optind; i < argc && argc - optind > 1; ++i)
      if (command_line.is_resumed && std::filesystem::is_directory(argv[i]))
        refuse_argument(argv[i], "no parameter file", remedy_for_directory);
    if (argc - optind > 1)
      refuse_argument(argv[optind + 1], "only one parameter file is read");
    if (optind < argc)
      command_line.file_name = argv[optind];
    check_format(command_line.print_parameters);
    return command_line;
  }
} // namespace ThermoContact
