// SPDX-License-Identifier: LGPL-2.1-or-later

// The section that says what the end of the rod meets.

#include <thermocontact/input/number_or_word.h>
#include <thermocontact/input/parameters.h>
#include <thermocontact/input/words_of_kinds.h>

#include <deal.II/base/patterns.h>

namespace ThermoContact
{
  namespace
  {
    using namespace dealii::Patterns;

    // Beyond 1e15 a coefficient leaves nothing of the others in a sum.
    const Double coefficient_of_contact(0., 1e15);
  } // namespace



  void
  ContactParameters::add_parameters(ParameterHandler &prm)
  {
    prm.enter_subsection("Contact");
    prm.add_parameter("Condition",
                      condition,
                      "Contact end x = 1: " +
                        in_words(contact_laws(),
                                 [](const auto &law) {
                                   return " (" + law.text + ")";
                                 }) +
                        ".",
                      Selection(names_of(contact_laws())));
    prm.add_parameter("Compliance",
                      compliance,
                      "Compliance epsilon > 0 of an elastic obstacle: pressure "
                      "= penetration / epsilon, or a power of it.",
                      coefficient_of_contact);
    add_number_or_word(
      prm,
      "Stiffness",
      "none",
      "The other word for Compliance in a file with section Rod: force over "
      "penetration, N/m, or over its power Exponent, N/m^m.",
      [this](const double *number) {
        stiffness = number ? std::optional<double>(*number) : std::nullopt;
      });
    prm.add_parameter(
      "Exponent",
      exponent,
      "Exponent m >= 1 of a power law: pressure = (penetration "
      "/ epsilon)^m; 1.5 is Hertz's contact of a rounded end, 1 "
      "is normal compliance.",
      Double(1., 10.));
    prm.add_parameter(
      "Damping",
      damping,
      "Damping c >= 0 of an elastic obstacle (Hunt and Crossley): its pressure "
      "is multiplied by 1 + c times the velocity into it, and never negative.",
      coefficient_of_contact);
    add_number_or_expression(
      prm,
      "Gap",
      gap,
      "y, z, t",
      "Gap g between the undeformed rod and the obstacle; negative is a "
      "preload. An expression in t moves the obstacle, e.g. 0.1-0.02*sin(3*t); "
      "one in y, z, for Dimension > 1, is its shape, at each contact node its "
      "gap, e.g. 0.1+(y-0.05)^2/2.",
      [this](const double number, const std::string &expression) {
        gap            = number;
        gap_expression = expression;
      },
      true);
    add_number_or_word(
      prm,
      "Rear gap",
      "none",
      "Gap g_2 to a second obstacle behind the end x = 1, u(1) >= -g_2, with "
      "the same law; none: no such obstacle. Its pressures are negative.",
      [this](const double *gap_2) {
        rear_gap = gap_2 ? std::optional<double>(*gap_2) : std::nullopt;
      });
    prm.add_parameter("Massless nodes",
                      massless_nodes,
                      "The mass of the contact nodes is moved to their "
                      "neighbours, for impacts without oscillations; "
                      "automatic: where the viscosity does not damp the "
                      "oscillation of one node, on a rigid obstacle if "
                      "Dimension > 1, and for the scheme energy conserving.",
                      Selection("automatic|on|off"));
    prm.leave_subsection();
  }
} // namespace ThermoContact
