// SPDX-License-Identifier: LGPL-2.1-or-later

#include <thermocontact/contact/contact_law.h>
#include <thermocontact/input/parameter_file.h>
#include <thermocontact/scene/scene_checks.h>

#include "tests.h"

#include <deal.II/base/parameter_handler.h>

#include <fstream>
#include <iomanip>
#include <sstream>

void
initlog()
{
  static std::ofstream file("output");
  deallog.attach(file, false);
  deallog.depth_console(0);
}



std::string
within(const double value, const double bound)
{
  std::ostringstream digits, text;
  digits << std::scientific << std::setprecision(12) << value;
  const std::string all      = digits.str();
  const auto        exponent = all.find('e');
  if (exponent == std::string::npos) // not finite
    text << all;
  else
    text << std::stod(all.substr(0, all.find('.')) + all.substr(exponent));
  text << (value <= bound ? " <= " : " exceeds ") << bound;
  return text.str();
}



std::string
noise_within(const double value, const double bound)
{
  std::ostringstream text;
  text << "rounding <= " << bound;
  return value <= bound ? text.str() : within(value, bound);
}



ThermoContact::Parameters
read_parameters(const std::string              &name,
                const std::vector<std::string> &overrides)
{
  ThermoContact::Parameters parameters;
  dealii::ParameterHandler  prm;
  parameters.add_parameters(prm);
  std::vector<ThermoContact::Assignment> assignments;
  if (!name.empty())
    {
      std::istringstream text(
        ThermoContact::read_text(std::string(PRM_DIR) + "/" + name));
      assignments = ThermoContact::read_assignments(text, name);
    }
  for (const std::string &text : overrides)
    assignments.push_back(ThermoContact::parse_override(text));
  // together: the variables of one follow from others
  ThermoContact::assign_entries(assignments, prm, parameters);
  const ThermoContact::Scene scene(parameters);
  check_unused_entries(scene, assignments, prm);
  check_scene(scene);
  return parameters;
}



std::unique_ptr<const ThermoContact::ContactLaw>
make_law(const double compliance, const double damping)
{
  auto parameters             = ThermoContact::default_law_parameters();
  parameters.at("Compliance") = compliance;
  parameters.at("Damping")    = damping;
  return compliance == 0. ? ThermoContact::rigid_obstacle().make(parameters) :
                            ThermoContact::normal_compliance().make(parameters);
}
