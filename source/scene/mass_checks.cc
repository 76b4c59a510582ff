// SPDX-License-Identifier: LGPL-2.1-or-later

#include <thermocontact/base/exceptions.h>
#include <thermocontact/base/number_text.h>
#include <thermocontact/base/text.h>
#include <thermocontact/base/tolerances.h>
#include <thermocontact/scene/mass_checks.h>

#include <cmath>

namespace ThermoContact
{
  namespace
  {
    [[noreturn]] void
    refuse_mass(const Scene       &scene,
                const std::string &reason,
                const std::string &remedy)
    {
      throw InputError(text("Mesh/Mass matrix = ",
                            scene.parameters.mesh.mass_matrix,
                            "\n  allowed: consistent",
                            reason,
                            "\n  remedy:  ",
                            remedy));
    }



    void
    check_midpoint_mass(const Scene &scene)
    {
      const Parameters &parameters = scene.parameters;
      const auto        since      = [](const std::string &fact) {
        return " or lumped, since " + fact;
      };
      const std::string consistent = "Mesh/Mass matrix = consistent";
      if (parameters.dimension > 1)
        refuse_mass(scene,
                    since(text("Dimension = ", parameters.dimension)),
                    consistent + ": the rule is for waves along a rod");
      if (!scene.fields.has_displacement)
        refuse_mass(scene,
                    since("Model/Fields = " + parameters.model.fields),
                    consistent + ": the rule is for waves");
      if (!scene.scheme.has_midpoint_rule)
        refuse_mass(
          scene,
          since("Time/Scheme = " + parameters.time.scheme),
          "Time/Scheme = energy conserving, whose rule in time is that of "
          "the mass in space");
      if (parameters.mesh.degree != 1)
        refuse_mass(scene,
                    since(text("Mesh/Degree = ", parameters.mesh.degree)),
                    "Mesh/Degree = 1: one point to a cell sees no more");
      if (parameters.mesh.grading != 1.)
        refuse_mass(
          scene,
          since(text("Mesh/Grading = ", parameters.mesh.grading)),
          "Mesh/Grading = 1: a wave passes all cells in the same time");
      if (scene.material.has_viscosity())
        refuse_mass(
          scene,
          since(text("Model/Viscosity = ", parameters.model.viscosity)),
          "Model/Viscosity = 0: no step is free of dispersion in a viscous "
          "rod");
      if (parameters.contact.massless_nodes == "on")
        refuse_mass(
          scene,
          since("Contact/Massless nodes = on"),
          "Contact/Massless nodes = automatic: the contact node keeps its "
          "mass");
    }



    /** The time in which a wave passes a cell, $h\sqrt b$. */
    double
    passage(const Scene &scene)
    {
      return scene.parameters.mesh.contact_spacing() *
             std::sqrt(scene.material.inertia);
    }
  } // namespace



  void
  check_mass_matrix(const Scene &scene)
  {
    const Parameters &parameters = scene.parameters;
    if (scene.has_lumped_mass && !scene.geometry->has_uniform_weight())
      refuse_mass(
        scene,
        ", since Mesh/Geometry = " + parameters.mesh.geometry,
        "Mesh/Mass matrix = consistent: lumped nodes on the axis would "
        "have no mass");
    if (scene.has_midpoint_mass)
      check_midpoint_mass(scene);
  }



  std::string
  dispersion_warning(const Scene &scene)
  {
    if (!scene.has_midpoint_mass || !scene.parameters.time.step_size)
      return "";
    const double size = *scene.parameters.time.step_size;
    if (std::abs(size / passage(scene) - 1.) <= Tolerances::same_step_size)
      return "";
    return text("Time/Step size = ",
                significant(size, 6),
                ": with Mesh/Mass matrix = midpoint waves travel without "
                "dispersion in steps of h sqrt(b) = ",
                significant(passage(scene), 15),
                " alone; others are worse than with Mesh/Mass matrix = "
                "consistent");
  }
} // namespace ThermoContact
