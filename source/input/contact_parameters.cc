// SPDX-License-Identifier: LGPL-2.1-or-later

// The section that says what the end of the rod meets.

#include <thermocontact/input/parameters.h>
#include <thermocontact/input/section_of_entries.h>
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
    SectionOfEntries entry(prm, "Contact");
    entry("Condition", condition, Selection(names_of(contact_laws())))
      .means("Contact end x = 1: " +
             in_words(contact_laws(),
                      [](const auto &law) { return " (" + law.text + ")"; }) +
             ".");
    entry("Compliance", compliance, coefficient_of_contact)
      .means("Compliance epsilon > 0 of an elastic obstacle: pressure = "
             "penetration / epsilon, or a power of it.");
    entry("Stiffness", stiffness, NumberOrText::word("none"))
      .means("The other word for Compliance in a file with section Rod: force "
             "over penetration, N/m, or over its power Exponent, N/m^m.");
    entry("Exponent", exponent, Double(1., 10.))
      .means("Exponent m >= 1 of a power law: pressure = (penetration / "
             "epsilon)^m; 1.5 is Hertz's contact of a rounded end, 1 is normal "
             "compliance.");
    entry("Damping", damping, coefficient_of_contact)
      .means("Damping c >= 0 of an elastic obstacle (Hunt and Crossley): its "
             "pressure is multiplied by 1 + c times the velocity into it, and "
             "never negative.");
    entry("Gap", gap, gap_expression, NumberOrText::expression("y, z, t", true))
      .means("Gap g between the undeformed rod and the obstacle; negative is a "
             "preload. An expression in t moves the obstacle, e.g. "
             "0.1-0.02*sin(3*t); one in y, z, for Dimension > 1, is its shape, "
             "at each contact node its gap, e.g. 0.1+(y-0.05)^2/2.");
    entry("Rear gap", rear_gap, NumberOrText::word("none"))
      .means("Gap g_2 to a second obstacle behind the end x = 1, u(1) >= -g_2, "
             "with the same law; none: no such obstacle. Its pressures are "
             "negative.");
    entry("Massless nodes", massless_nodes, Selection("automatic|on|off"))
      .means(
        "The mass of the contact nodes is moved to their neighbours, for "
        "impacts without oscillations; automatic: where the viscosity does "
        "not damp the oscillation of one node, on a rigid obstacle if "
        "Dimension > 1, and for the scheme energy conserving.");
  }
} // namespace ThermoContact
