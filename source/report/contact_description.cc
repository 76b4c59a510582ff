// SPDX-License-Identifier: LGPL-2.1-or-later

#include <thermocontact/base/text.h>
#include <thermocontact/output/output_units.h>
#include <thermocontact/report/contact_description.h>

namespace ThermoContact
{
  namespace
  {
    /** A formula with its values at t = 0, or a length. */
    template <int dim>
    std::string
    describe_gap(const Simulation<dim> &simulation, const OutputUnits &units)
    {
      const Scene &scene  = simulation.scene();
      const bool   moves  = scene.sources.has_moving_obstacle;
      const bool   is_one = scene.contact.has_uniform_gap();
      if (is_one && !moves)
        return units.text("length", scene.contact.gap);
      const auto [smallest, largest] =
        simulation.discretization().contact_end().range_of_gap();
      return text(scene.parameters.contact.gap_expression,
                  " (",
                  units.text("length", smallest),
                  is_one ? "" : " to " + units.text("length", largest),
                  is_one ? "" : " at the contact nodes",
                  moves ? " at t = 0)" : ")");
    }
  } // namespace



  template <int dim>
  std::string
  describe_contact(const Simulation<dim> &simulation)
  {
    const SceneContact &contact = simulation.scene().contact;
    const OutputUnits   units(simulation.parameters());
    if (!contact.law->is_active())
      return contact.law->description();
    return text(contact.law->description(),
                ", g = ",
                describe_gap(simulation, units),
                contact.is_two_sided() ?
                  ", g_2 = " + units.text("length", contact.rear_gap) :
                  "",
                contact.has_massless_nodes ? ", massless contact nodes" : "");
  }



  template std::string
  describe_contact(const Simulation<1> &);
  template std::string
  describe_contact(const Simulation<2> &);
  template std::string
  describe_contact(const Simulation<3> &);
} // namespace ThermoContact
