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
    if (!(model.inertia > 0.))
      refuse("Model/Inertia",
             model.inertia,
             "b > 0",
             "give a small inertia, e.g. 1e-6, for a slow process");
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
    if (time.start == "paper" && time.scheme != "backward euler")
      refuse("Time/Start",
             time.start,
             "consistent or automatic, since Time/Scheme = " + time.scheme,
             "the prescribed first step of the paper is of order 1");
    if (solver.is_fixed_point() && time.scheme != "backward euler")
      refuse("Solver/Step solver",
             solver.step_solver,
             "monolithic, since Time/Scheme = " + time.scheme,
             "the iteration of the paper belongs to Time/Scheme = backward "
             "euler");
    if (solver.is_fixed_point() && contact.is_rigid())
      refuse("Solver/Step solver",
             solver.step_solver,
             "monolithic, since Contact/Condition = rigid",
             "the iteration of the paper needs an elastic obstacle");
    if (solver.is_fixed_point() && time.locates_contact_events())
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
        if (!butcher_tableau(time.scheme).has_error_estimate())
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



  std::vector<Parameters::UnusedEntry>
  Parameters::unused_entries() const
  {
    std::vector<UnusedEntry> unused;
    if (dimension == 1)
      for (const char *path : {"Model/Poisson ratio",
                               "Boundary/Lateral support",
                               "Mesh/Width",
                               "Mesh/Cells across"})
        unused.push_back({path, "Dimension = 1"});
    if (contact.is_none() || contact.is_rigid())
      unused.push_back(
        {"Contact/Compliance", "Contact/Condition = " + contact.condition});
    if (contact.is_none())
      unused.push_back({"Contact/Gap", "Contact/Condition = none"});
    if (boundary.heat_exchange == 0.)
      unused.push_back(
        {"Boundary/Obstacle temperature", "Boundary/Heat exchange = 0"});
    if (!time.has_error_control())
      for (const char *path : {"Time/Tolerance",
                               "Time/First step size",
                               "Time/Minimum step size",
                               "Time/Maximum step size"})
        unused.push_back({path, "Time/Step size = a number"});
    if (contact.is_none())
      unused.push_back(
        {"Time/Locate contact events", "Contact/Condition = none"});
    if (output.fields_interval == 0. && output.contact_interval == 0.)
      unused.push_back({"Output/Land on output times",
                        "Output/Contact interval = 0 and Fields interval = 0"});
    if (!study.is_active())
      for (const char *path : {"Study/Reference",
                               "Study/Repetitions",
                               "Study/Target error",
                               "Study/Keep files"})
        unused.push_back({path, "Study/Vary = (empty)"});
    if (!solver.is_fixed_point())
      for (const char *path :
           {"Solver/Fixed point tolerance", "Solver/Fixed point iterations"})
        unused.push_back({path, "Solver/Step solver = monolithic"});
    return unused;
  }
} // namespace ThermoContact
