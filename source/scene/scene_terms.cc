// SPDX-License-Identifier: LGPL-2.1-or-later

#include <thermocontact/scene/scene_terms.h>

namespace ThermoContact
{
  namespace
  {
    /** Words that are said under a condition. */
    class Words
    {
    public:
      std::vector<std::string> list;

      void
      add_if(const bool condition, const std::string &word)
      {
        if (condition)
          list.push_back(word);
      }
    };
  } // namespace



  std::vector<std::string>
  scene_fields(const Scene &scene)
  {
    Words fields;
    fields.add_if(scene.fields.has_temperature, "temperature");
    fields.add_if(scene.fields.has_displacement, "displacement");
    return fields.list;
  }



  std::vector<std::string>
  scene_terms(const Scene &scene)
  {
    const Material &material         = scene.material;
    const bool      has_temperature  = scene.fields.has_temperature;
    const bool      has_displacement = scene.fields.has_displacement;
    Words           terms;
    terms.add_if(has_temperature, "heat conduction");
    terms.add_if(has_temperature && scene.heat.has_exchange(), "heat exchange");
    terms.add_if(has_temperature && scene.heat.has_lateral_exchange(),
                 "lateral heat exchange");
    terms.add_if(has_displacement && material.has_inertia(), "inertia");
    terms.add_if(has_displacement, "elasticity");
    terms.add_if(has_displacement && material.has_viscosity(), "viscosity");
    terms.add_if(material.has_thermal_stress(), "thermal stress");
    terms.add_if(material.has_heating(), "thermoelastic heating");
    const ContactLaw &law = *scene.contact.law;
    terms.add_if(law.is_active() && law.is_rigid(), "rigid contact");
    terms.add_if(law.is_active() && !law.is_rigid(),
                 scene.parameters.contact.condition);
    terms.add_if(law.damping() > 0., "damped contact");
    terms.add_if(scene.contact.is_two_sided(), "two stops");
    terms.add_if(scene.contact.has_massless_nodes, "massless contact nodes");
    terms.add_if(scene.has_lumped_mass &&
                   (has_temperature || material.has_inertia()),
                 "lumped mass");
    terms.add_if(scene.has_midpoint_mass && material.has_inertia(),
                 "midpoint mass");
    terms.add_if(scene.sources.has_heat_source, "heat source");
    terms.add_if(scene.sources.has_body_force, "body force");
    terms.add_if(scene.sources.has_end_traction, "end traction");
    terms.add_if(scene.sources.has_end_heat_flux, "end heat flux");
    terms.add_if(scene.sources.has_varying_obstacle,
                 "varying temperature of the obstacle");
    terms.add_if(scene.sources.has_driven_temperature,
                 "varying temperature of the fixed end");
    terms.add_if(scene.sources.has_moving_end, "moving fixed end");
    terms.add_if(scene.sources.has_moving_obstacle, "moving obstacle");
    return terms.list;
  }
} // namespace ThermoContact
