// SPDX-License-Identifier: LGPL-2.1-or-later

#include <cmath>
#include <sstream>

#include "butcher_tableau.h"
#include "exceptions.h"
#include "parameters.h"

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
             "at most 1e9 unknowns with Degree, Refinements and Cells across",
             "a coarser mesh");
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
             "a body without inertia has no velocity to start with");
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
      refuse_since(model.inertia == 0. ? "Model/Inertia = 0" :
                                         "Model/Fields = " + model.fields,
                   "the iteration of the paper belongs to its full model");
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



  ContactLaw
  Parameters::contact_law() const
  {
    const bool is_elastic = !contact.is_none() && !contact.is_rigid();
    return {!contact.is_none() && model.has_displacement(),
            is_elastic ? contact.compliance : 0.,
            contact.gap};
  }



  bool
  Parameters::has_massless_contact() const
  {
    const bool has_other_nodes =
      mesh.degree * std::ldexp(mesh.cells, mesh.refinements) > 1.;
    if (!contact_law().is_active || model.inertia == 0. || !has_other_nodes)
      return false;
    if (contact.massless_nodes != "automatic")
      return contact.massless_nodes == "on";
    return time.is_energy_conserving() ||
           (dimension > 1 && contact.is_rigid()) ||
           model.viscosity < std::sqrt(model.inertia) * mesh.contact_spacing();
  }



  bool
  Parameters::has_contact_equilibrium() const
  {
    const bool has_viscous_stress =
      model.viscosity > 0. && !time.is_energy_conserving();
    return contact_law().is_active && !has_contact_mass() &&
           !has_viscous_stress;
  }



  bool
  Parameters::has_prescribed_start() const
  {
    return model.has_displacement() && model.inertia > 0. &&
           (time.start == "paper" ||
            (time.start == "automatic" && time.scheme == "backward euler"));
  }



  std::vector<Parameters::UnusedEntry>
  Parameters::unused_entries() const
  {
    std::vector<UnusedEntry> unused;
    add_unused_by_model(unused);
    const auto add = [&unused](const std::vector<const char *> &paths,
                               const std::string               &reason) {
      for (const char *path : paths)
        unused.push_back({path, reason});
    };
    if (dimension == 1)
      add({"Model/Poisson ratio",
           "Boundary/Lateral support",
           "Mesh/Width",
           "Mesh/Cells across"},
          "Dimension = 1");
    const std::string condition = "Contact/Condition = " + contact.condition;
    if (contact.is_none() || contact.is_rigid())
      add({"Contact/Compliance"}, condition);
    if (contact.is_none())
      add({"Contact/Gap",
           "Contact/Massless nodes",
           "Time/Locate contact events"},
          condition);
    if (boundary.heat_exchange == 0.)
      add({"Boundary/Obstacle temperature"}, "Boundary/Heat exchange = 0");
    if (!time.has_error_control())
      add({"Time/Tolerance",
           "Time/First step size",
           "Time/Minimum step size",
           "Time/Maximum step size"},
          "Time/Step size = a number");
    if (output.fields_interval == 0. && output.contact_interval == 0.)
      add({"Output/Land on output times"},
          "Output/Contact interval = 0 and Fields interval = 0");
    if (!study.is_active())
      add({"Study/Reference",
           "Study/Repetitions",
           "Study/Target error",
           "Study/Keep files"},
          "Study/Vary = (empty)");
    if (!solver.is_fixed_point())
      add({"Solver/Fixed point tolerance", "Solver/Fixed point iterations"},
          "Solver/Step solver = monolithic");
    return unused;
  }



  void
  Parameters::add_unused_by_model(std::vector<UnusedEntry> &unused) const
  {
    const auto add = [&unused](const std::vector<const char *> &paths,
                               const std::string               &reason) {
      for (const char *path : paths)
        unused.push_back({path, reason});
    };
    const std::string fields = "Model/Fields = " + model.fields;
    if (!model.has_displacement())
      add({"Model/Inertia",
           "Model/Viscosity",
           "Model/Coupling",
           "Model/Thermoelastic heating",
           "Model/Poisson ratio",
           "Boundary/Lateral support",
           "Contact/Condition",
           "Contact/Compliance",
           "Contact/Gap",
           "Contact/Massless nodes",
           "Initial values/Displacement",
           "Initial values/Velocity",
           "Sources/Body force",
           "Sources/End traction",
           "Time/Start",
           "Time/Locate contact events"},
          fields);
    if (!model.has_temperature())
      add({"Model/Coupling",
           "Model/Thermoelastic heating",
           "Boundary/Fixed end temperature",
           "Boundary/Heat exchange",
           "Boundary/Obstacle temperature",
           "Initial values/Temperature",
           "Sources/Heat source",
           "Sources/End heat flux"},
          fields);
    if (model.coupling == 0.)
      add({"Model/Thermoelastic heating"}, "Model/Coupling = 0");
    if (model.inertia == 0.)
      add({"Initial values/Velocity", "Contact/Massless nodes"},
          "Model/Inertia = 0");
    if (model.is_static())
      add({"Initial values/Displacement"},
          "Model/Inertia = 0 and Viscosity = 0");
  }
} // namespace ThermoContact
