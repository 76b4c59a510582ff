// SPDX-License-Identifier: LGPL-2.1-or-later

#include <thermocontact/base/exceptions.h>
#include <thermocontact/input/command_line.h>

#include <getopt.h>

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
  --resume                     go on from the newest checkpoint in the output
                               directory
  --units                      FILE.prm is a rod in SI units: print its scene, with
                               the factors that turn results into SI units
  --quiet                      print nothing but errors
  --help, --version

Exit status: 0 done, 1 the computation failed, 2 the input is wrong.
)";
  }



  CommandLine
  parse_command_line(const int argc, char **argv)
  {
    enum Option
    {
      set = 1,
      output,
      check,
      print_parameters,
      resume,
      units,
      quiet,
      help,
      version
    };
    const option options[] = {
      {"set", required_argument, nullptr, set},
      {"output", required_argument, nullptr, output},
      {"check", no_argument, nullptr, check},
      {"print-parameters", optional_argument, nullptr, print_parameters},
      {"resume", no_argument, nullptr, resume},
      {"units", no_argument, nullptr, units},
      {"quiet", no_argument, nullptr, quiet},
      {"help", no_argument, nullptr, help},
      {"version", no_argument, nullptr, version},
      {nullptr, 0, nullptr, 0}};
    const std::string place  = std::string(command_line_place) + ": ";
    const std::string remedy = "\n  remedy:  --help lists the options";

    CommandLine command_line;
    command_line.program_name = argv[0];
    opterr                    = 0; // messages are ours
    optind                    = 1;
    for (int o; (o = getopt_long(argc, argv, ":", options, nullptr)) != -1;)
      switch (o)
        {
          case set:
            command_line.overrides.push_back(parse_override(optarg));
            break;
          case output:
            command_line.overrides.push_back(
              {command_line_place, "Output/Directory", optarg});
            break;
          case check:
            command_line.check_only = true;
            break;
          case print_parameters:
            command_line.print_parameters = optarg != nullptr ? optarg : "prm";
            break;
          case resume:
            command_line.is_resumed = true;
            break;
          case units:
            command_line.reads_units = true;
            break;
          case quiet:
            command_line.is_quiet = true;
            break;
          case help:
            command_line.show_help = true;
            break;
          case version:
            command_line.show_version = true;
            break;
          case ':':
            throw InputError(place + quote(argv[optind - 1]) +
                             ": its argument is missing" + remedy);
          default:
            throw InputError(place + quote(argv[optind - 1]) +
                             ": unknown or ambiguous option" + remedy);
        }

    if (argc - optind > 1)
      throw InputError(place + quote(argv[optind + 1]) +
                       ": only one parameter file is read" + remedy);
    if (optind < argc)
      command_line.file_name = argv[optind];

    const std::string &format = command_line.print_parameters;
    if (!format.empty() && format != "prm" && format != "json" &&
        format != "description" && format != "markdown")
      throw InputError(
        place + "--print-parameters=" + quote(format) +
        ": unknown format\n  allowed: prm | json | description | markdown");
    return command_line;
  }
} // namespace ThermoContact
