// SPDX-License-Identifier: LGPL-2.1-or-later

#include <thermocontact/base/exceptions.h>
#include <thermocontact/input/parameters.h>
#include <thermocontact/input/probe_positions.h>
#include <thermocontact/method/butcher_tableau.h>

#include <cmath>
#include <sstream>

namespace ThermoContact
{
  namespace
  {
    /**
     * Throws for an entry whose value a pattern accepts but the program does
     * not.
     */
    template <typename Value>
    [[noreturn]] void
    refuse(const std::string &path,
           const Value       &value,
           const std::string &allowed,
           const std::string &remedy)
    {
      std::ostringstream message;
      message << path << " = " << value << "\n  allowed: " << allowed
              << "\n  remedy:  " << remedy;
      throw InputError(message.str());
    }
  } // namespace



  void
  Parameters::check() const
  {
    if (!(model.poisson_ratio > -1. && model.poisson_ratio < 0.5))
      refuse("Model/Poisson ratio",
             model.poisson_ratio,
             "-1 < nu < 0.5",
             "stay below 0.5, the incompressible limit");
    if (!contact.is_none() && !contact.is_rigid() && !(contact.compliance > 0.))
      refuse("Contact/Compliance",
             contact.compliance,
             "epsilon > 0",
             "for a rigid obstacle set Contact/Condition = rigid");
    const double n_nodes =
      (mesh.degree * std::ldexp(mesh.cells, mesh.refinements) + 1.) *
      std::pow(mesh.degree * std::ldexp(mesh.cells_across, mesh.refinements) +
                 1.,
               dimension - 1.);
    if ((1. + dimension) * n_nodes > 1e9)
      refuse("Mesh/Cells",
             mesh.cells,
             "at most 1e9 unknowns with Mesh/Degree = " +
               std::to_string(mesh.degree) +
               ", Mesh/Refinements = " + std::to_string(mesh.refinements) +
               (dimension > 1 ?
                  ", Mesh/Cells across = " + std::to_string(mesh.cells_across) :
                  ""),
             "a coarser mesh");
    parse_probe_positions(output.probes, dimension, mesh.width);
    check_steps();
    check_scheme();
    const bool has_one_node =
      mesh.degree * std::ldexp(mesh.cells, mesh.refinements) == 1.;
    if (has_one_node && contact_law().is_active && model.inertia > 0. &&
        (contact.massless_nodes == "on" || time.is_energy_conserving()))
      refuse("Mesh/Cells",
             mesh.cells,
             "at least 2, or Mesh/Degree above 1, for massless contact nodes",
             "a finer mesh: their mass moves to nodes that are not held");
  }



  void
  Parameters::check_scheme() const
  {
    if (time.start == "paper" && time.scheme != "backward euler")
      refuse("Time/Start",
             time.start,
             "consistent or automatic, since Time/Scheme = " + time.scheme,
             "the prescribed first step of the paper is of order 1");
    if (time.start == "paper" && model.inertia == 0.)
      refuse("Time/Start",
             time.start,
             "consistent or automatic, since Model/Inertia = 0",
             "Time/Start = automatic: a body without inertia has no velocity "
             "to start with");
    if (time.start == "paper" && contact.massless_nodes == "on")
      refuse("Time/Start",
             time.start,
             "consistent or automatic, since Contact/Massless nodes = on",
             "Contact/Massless nodes = automatic, which leaves the paper's "
             "start its mass");
    if (solver.is_fixed_point())
      check_fixed_point();
    if (!time.is_energy_conserving())
      return;
    if (model.inertia == 0.)
      refuse("Time/Scheme",
             time.scheme,
             "a scheme of another name, since Model/Inertia = 0",
             "Time/Scheme = sdirk4: without inertia there is no energy of "
             "motion to conserve");
    if (contact.massless_nodes == "off" && contact_law().is_active)
      refuse("Contact/Massless nodes",
             contact.massless_nodes,
             "on or automatic, since Time/Scheme = " + time.scheme,
             "Contact/Massless nodes = automatic");
    if (time.locates_contact_events() && contact_law().is_active)
      refuse("Time/Locate contact events",
             time.locate_contact_events,
             "false or automatic, since Time/Scheme = " + time.scheme,
             "the scheme conserves energy through contact in steps of any "
             "size; sdirk4 can end its steps at events");
  }



  void
  Parameters::check_fixed_point() const
  {
    const auto refuse_since = [this](const std::string &reason,
                                     const std::string &remedy) {
      refuse("Solver/Step solver",
             solver.step_solver,
             "monolithic, since " + reason,
             remedy);
    };
    if (time.scheme != "backward euler")
      refuse_since("Time/Scheme = " + time.scheme,
                   "the iteration of the paper belongs to Time/Scheme = "
                   "backward euler");
    if (contact.is_rigid())
      refuse_since("Contact/Condition = rigid",
                   "the iteration of the paper needs an elastic obstacle");
    if (!model.has_temperature() || model.inertia == 0.)
      refuse_since(
        model.inertia == 0. ? "Model/Inertia = 0" :
                              "Model/Fields = " + model.fields,
        "Solver/Step solver = monolithic: the iteration of the paper "
        "belongs to its full model");
    if (time.locates_contact_events())
      refuse("Time/Locate contact events",
             time.locate_contact_events,
             "false or automatic, since Solver/Step solver = fixed point",
             "Solver/Step solver = monolithic, which can hold a contact state "
             "fixed");
  }



  void
  Parameters::check_steps() const
  {
    if (time.has_error_control())
      {
        if (time.is_energy_conserving() ||
            !butcher_tableau(time.scheme).has_error_estimate())
          refuse("Time/Step size",
                 "automatic",
                 "a number, since Time/Scheme = " + time.scheme +
                   " has no error estimate",
                 "Time/Step size = 0.001, or Time/Scheme = sdirk4");
        if (time.first_step_size && !(*time.first_step_size > 0.))
          refuse("Time/First step size",
                 *time.first_step_size,
                 "dt > 0",
                 "Time/First step size = automatic");
        if (time.first_step_size &&
            *time.first_step_size < time.minimum_step_size)
          refuse("Time/First step size",
                 *time.first_step_size,
                 "not below Time/Minimum step size",
                 "Time/First step size = automatic");
        if (!(time.maximum_step_size > 0.) ||
            time.maximum_step_size < time.minimum_step_size)
          refuse("Time/Maximum step size",
                 time.maximum_step_size,
                 "positive and not below Time/Minimum step size",
                 "Time/Maximum step size = infinity");
        return;
      }
    if (!(*time.step_size > 0.))
      refuse("Time/Step size",
             *time.step_size,
             "dt > 0, or automatic",
             "the paper uses 0.001");
    if (time.end_time / *time.step_size > 1e9)
      refuse("Time/Step size",
             *time.step_size,
             "at most 1e9 steps up to Time/End time",
             "enlarge the step or shorten the run");
  }
} // namespace ThermoContact
