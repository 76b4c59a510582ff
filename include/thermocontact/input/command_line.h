// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef thermocontact_input_command_line_h
#define thermocontact_input_command_line_h

#include <thermocontact/input/parameter_text.h>

#include <string>
#include <vector>

namespace ThermoContact
{
  /** The requests of the command line. */
  struct CommandLine
  {
    std::string             file_name; ///< the parameter file, may be empty
    std::vector<Assignment> overrides; ///< --set and --output, in order
    std::string             print_parameters; ///< a format, or "": do not
    std::string             program_name;     ///< argv[0]
    bool                    check_only   = false;
    bool                    is_resumed   = false;
    bool                    prints_scene = false; ///< --units
    bool                    is_forced    = false; ///< --force
    bool                    is_quiet     = false;
    bool                    show_output  = false; ///< --print-output
    bool                    show_help    = false;
    bool                    show_version = false;
  };



  /**
   * Reads the arguments of main().
   *
   * @throw InputError on an unknown option, a missing or a superfluous argument
   */
  CommandLine
  parse_command_line(const int argc, char **argv);

  /** The text of --help. */
  std::string
  help_text();
} // namespace ThermoContact

#endif
