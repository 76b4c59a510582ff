// SPDX-License-Identifier: LGPL-2.1-or-later

// The section that says what the end of the rod meets.

#include <thermocontact/input/parameters.h>
#include <thermocontact/input/section_of_entries.h>

#include <deal.II/base/patterns.h>

namespace ThermoContact
{
  void
  ContactParameters::add_parameters(ParameterHandler &prm)
  {
    using namespace dealii::Patterns;
    SectionOfEntries entry(prm, "Contact");
    entry("Condition", condition, Selection(names_of(contact_laws())))
      .means("Contact end x = 1: " +
             in_words(contact_laws(),
                      [](const auto &law) { return " (" + law.text + ")"; }) +
             ".");
    for (const ContactLawEntry &one : contact_law_entries())
      entry(one.name,
            one.default_value,
            Double(one.smallest, one.largest),
            [this, name = one.name](const double value) { law[name] = value; })
        .means(one.text, one.kind);
    entry("Stiffness", stiffness, NumberOrText::word("none"))
      .means("The other word for Compliance in a file with section Rod: force "
             "over penetration, N/m, or over its power Exponent, N/m^m.",
             "stiffness");
    entry("Gap",
          gap,
          gap_expression,
          NumberOrText::number_or_expression("y, z, t", true))
      .means("Gap g between the undeformed rod and the obstacle; negative is a "
             "preload. An expression in t moves the obstacle, e.g. "
             "0.1-0.02*sin(3*t); one in y, z, for Dimension > 1, is its shape, "
             "at each contact node its gap, e.g. 0.1+(y-0.05)^2/2.",
             "length");
    entry("Rear gap", rear_gap, NumberOrText::word("none"))
      .means("Gap g_2 to a second obstacle behind the end x = 1, u(1) >= -g_2, "
             "with the same law; none: no such obstacle. Its pressures are "
             "negative.",
             "length");
    entry("Massless nodes", massless_nodes, Selection("automatic|on|off"))
      .means(
        "The mass of the contact nodes is moved to their neighbours, for "
        "impacts without oscillations; automatic: where the viscosity does "
        "not damp the oscillation of one node, on a rigid obstacle if "
        "Dimension > 1, and for the scheme energy conserving.");
  }
} // namespace ThermoContact
