// SPDX-License-Identifier: LGPL-2.1-or-later

#include <thermocontact/base/exceptions.h>
#include <thermocontact/input/parameter_file.h>
#include <thermocontact/input/probe_positions.h>
#include <thermocontact/scene/contact_checks.h>
#include <thermocontact/scene/drive_checks.h>
#include <thermocontact/scene/mass_checks.h>
#include <thermocontact/scene/refusal.h>
#include <thermocontact/scene/scales_checks.h>
#include <thermocontact/scene/scene.h>
#include <thermocontact/scene/scene_checks.h>
#include <thermocontact/scene/time_checks.h>

#include <algorithm>
#include <cmath>
#include <sstream>

namespace ThermoContact
{
  namespace
  {
    void
    check_scheme(const Scene &scene)
    {
      const Parameters     &parameters = scene.parameters;
      const TimeParameters &time       = parameters.time;
      if (!scene.scheme.needs_inertia.empty() && !scene.material.has_inertia())
        refuse("Time/Scheme",
               time.scheme,
               "a scheme of another name, since Model/Inertia = 0",
               "Time/Scheme = " + default_scheme().name + ": " +
                 scene.scheme.needs_inertia);
      if (!scene.contact.law->is_active())
        return;
      if (scene.scheme.needs_massless_contact && !scene.has_midpoint_mass &&
          parameters.contact.massless_nodes == "off")
        refuse("Contact/Massless nodes",
               parameters.contact.massless_nodes,
               "on or automatic, since Time/Scheme = " + time.scheme,
               "Contact/Massless nodes = automatic");
      check_scheme_fits_law(scene.scheme,
                            contact_law(parameters.contact.condition),
                            *scene.contact.law);
      if (!scene.scheme.cannot_hold_contact.empty() &&
          time.locates_contact_events())
        refuse("Time/Locate contact events",
               time.locate_contact_events,
               "false or automatic, since Time/Scheme = " + time.scheme,
               scene.scheme.cannot_hold_contact + "; " + default_scheme().name +
                 " can end its steps at events");
    }



    /** An exchange that depends on the contact needs contact. */
    void
    check_exchange(const Scene &scene)
    {
      const Parameters  &parameters = scene.parameters;
      const std::string &expression = parameters.boundary.exchange_expression;
      if (scene.heat.exchange->is_constant())
        return;
      if (!scene.contact.law->is_active())
        refuse("Boundary/Heat exchange",
               expression,
               "a number, since " +
                 (scene.fields.has_displacement ?
                    "Contact/Condition = " + parameters.contact.condition :
                    "Model/Fields = " + parameters.model.fields),
               "there is neither gap nor pressure");
      if (!parameters.boundary.obstacle_expression.empty())
        refuse("Boundary/Obstacle temperature",
               parameters.boundary.obstacle_expression,
               "a number, since Boundary/Heat exchange is an expression",
               "a number for one of them");
      if (!scene.scheme.needs_constant_exchange.empty())
        refuse("Boundary/Heat exchange",
               expression,
               "a number, since Time/Scheme = " + scene.scheme.name,
               "Time/Scheme = " + default_scheme().name + ": " +
                 scene.scheme.needs_constant_exchange);
    }



    void
    check_fixed_point(const Scene &scene)
    {
      const Parameters &parameters   = scene.parameters;
      const auto        refuse_since = [&](const std::string &reason,
                                    const std::string &remedy) {
        refuse("Solver/Step solver",
               parameters.solver.step_solver,
               "monolithic, since " + reason,
               remedy);
      };
      if (!scene.scheme.is_of_paper)
        refuse_since("Time/Scheme = " + scene.scheme.name,
                     "the iteration of the paper belongs to Time/Scheme = " +
                       find_scheme([](const Scheme &s) {
                         return s.is_of_paper;
                       })->name);
      if (scene.contact.law->is_rigid() || !scene.contact.law->is_linear())
        refuse_since("Contact/Condition = " + parameters.contact.condition,
                     "the iteration of the paper needs an elastic obstacle");
      if (!scene.fields.has_temperature || !scene.material.has_inertia())
        refuse_since(
          !scene.material.has_inertia() ?
            "Model/Inertia = 0" :
            "Model/Fields = " + parameters.model.fields,
          "Solver/Step solver = monolithic: the iteration of the paper "
          "belongs to its full model");
      if (!scene.heat.exchange->is_constant())
        refuse_since("Boundary/Heat exchange is an expression",
                     "the iteration of the paper has a constant one");
      if (parameters.time.locates_contact_events())
        refuse("Time/Locate contact events",
               parameters.time.locate_contact_events,
               "false or automatic, since Solver/Step solver = fixed point",
               "Solver/Step solver = monolithic, which can hold a contact "
               "state fixed");
    }



    void
    check_number_of_unknowns(const MeshParameters &mesh, const unsigned int dim)
    {
      if ((1. + dim) * mesh.n_nodes(dim) > 1e9)
        refuse("Mesh/Cells",
               mesh.cells,
               "at most 1e9 unknowns with Mesh/Degree = " +
                 std::to_string(mesh.degree) +
                 ", Mesh/Refinements = " + std::to_string(mesh.refinements) +
                 (dim > 1 ? ", Mesh/Cells across = " +
                              std::to_string(mesh.cells_across) :
                            ""),
               "a coarser mesh");
    }



    /** The mass of massless nodes moves to neighbours. */
    void
    check_neighbours(const Scene &scene)
    {
      const Parameters     &parameters = scene.parameters;
      const MeshParameters &mesh       = parameters.mesh;
      if (mesh.n_nodes(1) == 2. && scene.contact.law->is_active() &&
          scene.material.has_inertia() &&
          (parameters.contact.massless_nodes == "on" ||
           (scene.scheme.needs_massless_contact && !scene.has_midpoint_mass)))
        refuse("Mesh/Cells",
               mesh.cells,
               "at least 2, or Mesh/Degree above 1, for massless contact nodes",
               "a finer mesh: their mass moves to nodes that are not held");
    }



    /** What needs factors has to have them; a tolerance has to be reached. */
    void
    check_linear_solver(const Scene &scene)
    {
      const Parameters &parameters = scene.parameters;
      if (parameters.solver.linear_tolerance &&
          !(*parameters.solver.linear_tolerance >= 1e-14 &&
            *parameters.solver.linear_tolerance < 1e-2))
        refuse("Solver/Linear tolerance",
               *parameters.solver.linear_tolerance,
               "at least 1e-14 and below 0.01",
               "Solver/Linear tolerance = automatic");
      if (scene.linear_solver.is_iterative &&
          !scene.linear_solver.needs_factors.empty())
        refuse("Solver/Linear solver",
               "iterative",
               "direct or automatic, since " +
                 scene.linear_solver.needs_factors,
               "Solver/Linear solver = automatic");
    }
  } // namespace



  void
  check_scheme_fits_law(const Scheme         &scheme,
                        const ContactLawKind &kind,
                        const ContactLaw     &law)
  {
    if (!scheme.needs_linear_contact.empty() && !law.is_linear())
      refuse("Time/Scheme",
             scheme.name,
             "a scheme of another name, since Contact/Condition = " + kind.name,
             "Time/Scheme = " + default_scheme().name + ": " +
               scheme.needs_linear_contact);
  }



  void
  check_error_bars(const Parameters &parameters)
  {
    if (parameters.output.has_error_bars && parameters.study.is_active())
      refuse("Output/Error bars",
             "true",
             "false, since Study/Vary makes a study",
             "Study/Reference, to which the errors of all runs are measured");
  }



  namespace
  {
    /** A rod has one gap, which has no y. */
    void
    check_gap(const Parameters &parameters)
    {
      const std::string &gap = parameters.contact.gap_expression;
      if (parameters.dimension == 1 &&
          (depends_on(gap, "y") || depends_on(gap, "z")))
        refuse("Contact/Gap",
               gap,
               "a number or an expression in t, since Dimension = 1",
               "Dimension = 2 or 3 for an obstacle with a shape");
    }



    /** Something has to keep the body from moving across its axis. */
    void
    check_support(const Scene &scene)
    {
      if (scene.fields.has_displacement && scene.has_sliding_end &&
          !scene.has_rollers && !scene.geometry->has_axis_at_side() &&
          !scene.material.has_inertia())
        refuse("Boundary/Fixed end support",
               scene.parameters.boundary.fixed_end_support,
               "clamped, since Boundary/Lateral support = free and "
               "Model/Inertia = 0",
               "clamped, or Boundary/Lateral support = rollers: without "
               "inertia nothing holds the body across its axis");
    }
  } // namespace



  void
  check_scene(const Parameters &parameters)
  {
    check_gap(parameters);
    const Scene  scene(parameters);
    const double nu = parameters.model.poisson_ratio;
    if (!(nu > -1. && nu < 0.5))
      refuse("Model/Poisson ratio",
             nu,
             "-1 < nu < 0.5",
             "stay below 0.5, the incompressible limit");
    const auto &entries = contact_law(parameters.contact.condition).entries;
    if (std::find(entries.begin(), entries.end(), "Compliance") !=
          entries.end() &&
        !(parameters.contact.compliance > 0.))
      refuse("Contact/Compliance",
             parameters.contact.compliance,
             "epsilon > 0",
             "for a rigid obstacle set Contact/Condition = rigid");
    check_scales(parameters);
    check_mass_matrix(scene);
    check_damping(scene);
    check_rear_gap(scene);
    check_number_of_unknowns(parameters.mesh, parameters.dimension);
    parse_probe_positions(parameters.output.probes,
                          parameters.dimension,
                          parameters.mesh.width);
    check_step_sizes(scene);
    check_start(scene);
    check_exchange(scene);
    check_drives(scene);
    if (scene.is_fixed_point)
      check_fixed_point(scene);
    check_scheme(scene);
    check_neighbours(scene);
    check_support(scene);
    check_linear_solver(scene);
    check_error_bars(parameters);
  }



  void
  check_assignments(const std::vector<Assignment> &assignments)
  {
    Parameters       parameters;
    ParameterHandler prm;
    parameters.add_parameters(prm);
    assign_entries(assignments, prm);
    try
      {
        check_unused_entries(parameters, prm);
        check_scene(parameters);
      }
    catch (const InputError &error)
      {
        throw InputError(complete_message(error.what(), assignments, prm));
      }
  }
} // namespace ThermoContact
