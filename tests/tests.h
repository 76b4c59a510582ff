// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef thermocontact_tests_h
#define thermocontact_tests_h

#include <deal.II/base/logstream.h>
#include <deal.II/base/parameter_handler.h>

#include <fstream>
#include <string>
#include <vector>

#include "parameter_file.h"
#include "parameters.h"

using dealii::deallog;

/** Sends deallog into the file that the test harness compares. */
inline void
initlog()
{
  static std::ofstream file("output");
  deallog.attach(file, false);
  deallog.depth_console(0);
}



/**
 * The parameters of a published file, e.g. "paper/experiment-1.prm", with
 * overrides 'Section/Entry=value' and all checks that the program makes.
 */
inline ThermoContact::Parameters
read_parameters(const std::string &             name,
                const std::vector<std::string> &overrides = {})
{
  ThermoContact::Parameters parameters;
  dealii::ParameterHandler  prm;
  parameters.add_parameters(prm);
  if (!name.empty())
    assign_entries(
      ThermoContact::read_parameter_file(std::string(PRM_DIR) + "/" + name),
      prm);
  for (const std::string &text : overrides)
    assign_entries({ThermoContact::parse_override(text)}, prm);
  check_unused_entries(parameters, prm);
  parameters.check();
  return parameters;
}

#endif
