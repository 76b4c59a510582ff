// SPDX-License-Identifier: LGPL-2.1-or-later

#include <thermocontact/input/parameter_file.h>
#include <thermocontact/scene/scene_terms.h>

#include <deal.II/base/utilities.h>

namespace ThermoContact
{
  std::vector<std::string>
  scene_fields(const ModelParameters &model)
  {
    std::vector<std::string> fields;
    if (model.has_temperature())
      fields.emplace_back("temperature");
    if (model.has_displacement())
      fields.emplace_back("displacement");
    return fields;
  }



  std::vector<std::string>
  scene_terms(const Parameters &parameters)
  {
    std::vector<std::string> terms;
    const auto add_if = [&terms](const bool condition, const char *term) {
      if (condition)
        terms.emplace_back(term);
    };
    const auto is_source = [](const std::string &expression) {
      return !equal_values(expression, "0");
    };
    const ModelParameters  &model            = parameters.model;
    const SourceParameters &sources          = parameters.sources;
    const ContactLaw        law              = parameters.contact_law();
    const bool              has_temperature  = model.has_temperature();
    const bool              has_displacement = model.has_displacement();
    add_if(has_temperature, "heat conduction");
    add_if(has_temperature && parameters.boundary.heat_exchange > 0.,
           "heat exchange");
    add_if(has_displacement && model.inertia > 0., "inertia");
    add_if(has_displacement, "elasticity");
    add_if(has_displacement && model.viscosity > 0., "viscosity");
    add_if(model.thermal_stress() != 0., "thermal stress");
    add_if(model.thermoelastic_heating() != 0., "thermoelastic heating");
    add_if(law.is_active && law.compliance == 0., "rigid contact");
    add_if(law.is_active && law.compliance > 0., "normal compliance");
    add_if(parameters.has_massless_contact(), "massless contact nodes");
    add_if(parameters.mesh.is_lumped() &&
             (has_temperature || model.inertia > 0.),
           "lumped mass");
    add_if(has_temperature && is_source(sources.heat_source), "heat source");
    add_if(has_displacement && is_source(sources.body_force), "body force");
    add_if(has_displacement && is_source(sources.end_traction), "end traction");
    add_if(has_temperature && is_source(sources.end_heat_flux),
           "end heat flux");
    return terms;
  }
} // namespace ThermoContact
