// SPDX-License-Identifier: LGPL-2.1-or-later

#include <thermocontact/base/exceptions.h>
#include <thermocontact/input/command_line.h>

#include <getopt.h>

#include <cstring>

namespace ThermoContact
{
  std::string
  help_text()
  {
    return R"(Usage: thermocontact [OPTIONS] FILE.prm

Dynamic contact of a thermoviscoelastic rod with an elastic or rigid obstacle.

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
    enum Option
    {
      set_option = 1,
      output_option,
      check_option,
      print_parameters_option,
      print_output_option,
      resume_option,
      units_option,
      force_option,
      quiet_option,
      help_option,
      version_option,
      option_numbers_end ///< letters are larger
    };

    const option options[] = {
      {"set", required_argument, nullptr, set_option},
      {"output", required_argument, nullptr, output_option},
      {"check", no_argument, nullptr, check_option},
      {"print-parameters", optional_argument, nullptr, print_parameters_option},
      {"print-output", no_argument, nullptr, print_output_option},
      {"resume", no_argument, nullptr, resume_option},
      {"units", no_argument, nullptr, units_option},
      {"force", no_argument, nullptr, force_option},
      {"quiet", no_argument, nullptr, quiet_option},
      {"help", no_argument, nullptr, help_option},
      {"version", no_argument, nullptr, version_option},
      {nullptr, 0, nullptr, 0}};



    [[noreturn]] void
    refuse_argument(const std::string &argument, const std::string &fault)
    {
      throw InputError(std::string(command_line_place) + ": " +
                       quote(argument) + ": " + fault +
                       "\n  remedy:  --help lists the options");
    }



    /**
     * @param argument of the option, or null
     * @param word as typed
     */
    void
    apply_option(const int          option,
                 const char        *argument,
                 const std::string &word,
                 CommandLine       &command_line)
    {
      switch (option)
        {
          case set_option:
            command_line.overrides.push_back(parse_override(argument));
            break;
          case output_option:
            command_line.overrides.push_back(
              {command_line_place, "Output/Directory", argument});
            break;
          case check_option:
            command_line.check_only = true;
            break;
          case print_parameters_option:
            command_line.print_parameters = argument ? argument : "prm";
            break;
          case print_output_option:
            command_line.show_output = true;
            break;
          case resume_option:
            command_line.is_resumed = true;
            break;
          case units_option:
            command_line.prints_scene = true;
            break;
          case force_option:
            command_line.is_forced = true;
            break;
          case quiet_option:
            command_line.is_quiet = true;
            break;
          case help_option:
            command_line.show_help = true;
            break;
          case version_option:
            command_line.show_version = true;
            break;
          case ':':
            refuse_argument(word, "its argument is missing");
          default:
            refuse_argument(word,
                            word.compare(0, 2, "--") == 0 ?
                              "unknown or ambiguous option" :
                              "no option; a file of that name is ./" + word);
        }
    }



    /** The argument that the last call of getopt_long() was about. */
    std::string
    last_word(const int argc, char **argv)
    {
      // in letters behind one '-', getopt stops before it goes on in argv
      if (optopt > option_numbers_end)
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
    opterr                    = 0; // messages are ours
    optind                    = 1;
    for (int o; optopt = 0,
                (o = getopt_long(argc, argv, ":", options, nullptr)) != -1;)
      apply_option(o, optarg, last_word(argc, argv), command_line);

    if (argc - optind > 1)
      refuse_argument(argv[optind + 1], "only one parameter file is read");
    if (optind < argc)
      command_line.file_name = argv[optind];
    check_format(command_line.print_parameters);
    return command_line;
  }
} // namespace ThermoContact
