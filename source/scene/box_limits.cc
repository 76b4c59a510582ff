// SPDX-License-Identifier: LGPL-2.1-or-later

#include <thermocontact/base/text.h>
#include <thermocontact/method/scheme.h>
#include <thermocontact/scene/box_limits.h>
#include <thermocontact/scene/rod_profile.h>

#include <cmath>

namespace ThermoContact
{
  std::vector<BoxLimit>
  limits_of_box(const Parameters &parameters)
  {
    const MeshParameters     &mesh     = parameters.mesh;
    const TimeParameters     &time     = parameters.time;
    const BoundaryParameters &boundary = parameters.boundary;
    std::vector<BoxLimit>     limits;
    const auto                add = [&](const bool         is_there,
                         const std::string &entry,
                         const std::string &remedy = "") {
      if (is_there)
        limits.push_back({entry, remedy});
    };
    const auto default_scheme_for = [](const std::string &reason) {
      return "Time/Scheme = " + default_scheme().name + ": " + reason;
    };

    add(parameters.dimension > 1,
        text("Dimension = ", parameters.dimension),
        default_scheme_for("that one is for waves along a rod"));
    add(parameters.model.fields == "temperature",
        "Model/Fields = temperature",
        default_scheme_for("that one is for waves"));
    for (const BodyParameters &body : parameters.row.bodies)
      if (parameters.dimension == 1 && !body.is_mass())
        {
          const RodProfile profile(parameters, body);
          for (const Expression *const law : profile.of_temperature())
            add(true,
                law->path() + " = " + quote(law->text()),
                default_scheme_for("that one has constant matrices"));
        }
    add(mesh.degree > 1,
        text("Mesh/Degree = ", mesh.degree),
        "Mesh/Degree = 1: its mass matrix has one point to a cell");
    add(mesh.grading != 1.,
        text("Mesh/Grading = ", mesh.grading),
        "Mesh/Grading = 1: a wave passes all cells in the same time");
    add(mesh.mass_matrix != "consistent",
        "Mesh/Mass matrix = " + mesh.mass_matrix,
        "Mesh/Mass matrix = consistent: the scheme has a mass matrix of its "
        "own");
    for (const auto &[path, value] :
         {std::pair("Boundary/left/Mass",
                    boundary.left.is_free() ? boundary.left.mass : 0.),
          std::pair("Boundary/right/Mass", boundary.right.mass),
          std::pair("Boundary/right/Spring", boundary.right.spring),
          std::pair("Boundary/right/Dashpot", boundary.right.dashpot)})
      add(value > 0.,
          path + std::string(" above 0"),
          default_scheme_for("that one has springs and dashpots on the left "
                             "alone"));
    add(parameters.contact.massless_nodes == "on",
        "Contact/Massless nodes = on",
        "Contact/Massless nodes = automatic: the contact node keeps its mass");

    add(time.step_size.has_value(), "Time/Step size = a number");
    add(time.first_step_size.has_value(), "Time/First step size = a number");
    add(time.minimum_step_size > 0., "Time/Minimum step size = a number");
    add(std::isfinite(time.maximum_step_size),
        "Time/Maximum step size = a number");
    add(time.start == "paper", "Time/Start = paper");
    add(time.locate_contact_events == "true",
        "Time/Locate contact events = true");
    add(!time.break_points.empty(), "Time/Break points");
    add(parameters.solver.step_solver != "monolithic",
        "Solver/Step solver = " + parameters.solver.step_solver);
    add(parameters.solver.linear_solver == "iterative",
        "Solver/Linear solver = iterative");
    add(parameters.output.land_on_times, "Output/Land on output times = true");
    add(parameters.output.period > 0., "Output/Period = a number");
    return limits;
  }
} // namespace ThermoContact
