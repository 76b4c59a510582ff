// SPDX-License-Identifier: LGPL-2.1-or-later

#include <thermocontact/scene/scene_terms.h>

namespace ThermoContact
{
  std::vector<std::string>
  scene_fields(const Scene &scene)
  {
    std::vector<std::string> fields;
    if (scene.fields.has_temperature)
      fields.emplace_back("temperature");
    if (scene.fields.has_displacement)
      fields.emplace_back("displacement");
    return fields;
  }



  std::vector<std::string>
  scene_terms(const Scene &scene)
  {
    const Material          &material         = scene.material;
    const bool               has_temperature  = scene.fields.has_temperature;
    const bool               has_displacement = scene.fields.has_displacement;
    std::vector<std::string> terms;
    const auto add_if = [&terms](const bool has, const std::string &word) {
      if (has)
        terms.push_back(word);
    };
    add_if(has_temperature, "heat conduction");
    add_if(has_temperature && scene.heat.has_exchange(), "heat exchange");
    add_if(has_temperature && scene.heat.has_lateral_exchange(),
           "lateral heat exchange");
    add_if(has_displacement && material.has_inertia(), "inertia");
    add_if(has_displacement, "elasticity");
    add_if(has_displacement && material.has_viscosity(), "viscosity");
    add_if(material.has_thermal_stress(), "thermal stress");
    add_if(material.has_heating(), "thermoelastic heating");
    const ContactLaw &law = *scene.contact.law;
    add_if(law.is_active() && law.is_rigid(), "rigid contact");
    add_if(law.is_active() && !law.is_rigid(),
           scene.parameters.contact.condition);
    add_if(law.damping() > 0., "damped contact");
    add_if(scene.contact.is_two_sided(), "two stops");
    add_if(scene.contact.has_massless_nodes, "massless contact nodes");
    add_if(scene.has_lumped_mass && (has_temperature || material.has_inertia()),
           "lumped mass");
    add_if(scene.has_midpoint_mass && material.has_inertia(), "midpoint mass");
    add_if(scene.sources.has_heat_source, "heat source");
    add_if(scene.sources.has_body_force, "body force");
    add_if(scene.sources.has_end_traction, "end traction");
    add_if(scene.sources.has_end_heat_flux, "end heat flux");
    add_if(scene.sources.has_varying_obstacle,
           "varying temperature of the obstacle");
    add_if(scene.sources.has_driven_temperature,
           "varying temperature of the fixed end");
    add_if(scene.sources.has_moving_end, "moving fixed end");
    add_if(scene.sources.has_moving_obstacle, "moving obstacle");
    return terms;
  }
} // namespace ThermoContact
