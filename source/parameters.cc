// SPDX-License-Identifier: LGPL-2.1-or-later

#include "parameters.h"

#include <deal.II/base/patterns.h>

#include <cmath>
#include <limits>
#include <sstream>

#include "butcher_tableau.h"
#include "exceptions.h"

namespace ThermoContact
{
  namespace
  {
    using namespace dealii::Patterns;

    // Beyond 1e15 a coefficient leaves nothing of the others in a sum.
    const Double coefficient(0., 1e15);
    const Double signed_coefficient(-1e15, 1e15);
    const Double duration(0., 1e15);
    const Double any_number(-std::numeric_limits<double>::max(),
                            std::numeric_limits<double>::max());

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
  ModelParameters::add_parameters(ParameterHandler &prm)
  {
    prm.enter_subsection("Model");
    prm.add_parameter("Inertia",
                      inertia,
                      "Inertia coefficient b > 0 of the momentum equation.",
                      coefficient);
    prm.add_parameter("Viscosity",
                      viscosity,
                      "Kelvin-Voigt viscosity zeta >= 0.",
                      coefficient);
    prm.add_parameter("Coupling",
                      coupling,
                      "Thermoelastic coupling a: thermal stress -a theta and "
                      "heating -a div u_t.",
                      signed_coefficient);
    prm.add_parameter("Poisson ratio",
                      poisson_ratio,
                      "Poisson ratio nu, for Dimension > 1; the P-wave modulus "
                      "is one for every nu.",
                      Double(-1., 0.5));
    prm.leave_subsection();
  }



  void
  BoundaryParameters::add_parameters(ParameterHandler &prm)
  {
    prm.enter_subsection("Boundary");
    prm.add_parameter("Fixed end temperature",
                      fixed_end_temperature,
                      "Temperature theta_A of the fixed end x = 0.",
                      any_number);
    prm.add_parameter("Heat exchange",
                      heat_exchange,
                      "Heat exchange coefficient k >= 0 of the contact end: "
                      "-d theta/dn = k (theta - theta_obs).",
                      coefficient);
    prm.add_parameter("Obstacle temperature",
                      obstacle_temperature,
                      "Temperature theta_obs of the obstacle.",
                      any_number);
    prm.add_parameter("Lateral support",
                      lateral_support,
                      "Lateral faces, for Dimension > 1: rollers (no normal "
                      "displacement) or free; adiabatic in both cases.",
                      Selection("rollers|free"));
    prm.leave_subsection();
  }



  void
  ContactParameters::add_parameters(ParameterHandler &prm)
  {
    prm.enter_subsection("Contact");
    prm.add_parameter("Condition",
                      condition,
                      "Contact end x = 1: normal compliance (elastic "
                      "obstacle), rigid (Signorini) or none (free end).",
                      Selection("normal compliance|rigid|none"));
    prm.add_parameter("Compliance",
                      compliance,
                      "Compliance epsilon > 0 of an elastic obstacle: pressure "
                      "= penetration / epsilon.",
                      coefficient);
    prm.add_parameter("Gap",
                      gap,
                      "Initial gap g between the undeformed rod and the "
                      "obstacle; negative is a preload.",
                      any_number);
    prm.leave_subsection();
  }



  void
  InitialValuesParameters::add_parameters(ParameterHandler &prm)
  {
    const std::string variables =
      " Expression in x (y, z); pi and theta_A are known.";
    prm.enter_subsection("Initial values");
    prm.add_parameter("Temperature",
                      temperature,
                      "Temperature theta_0." + variables);
    prm.add_parameter("Displacement",
                      displacement,
                      "Displacement u_0, zero at x = 0; components separated "
                      "by ';', one alone is the axial one." +
                        variables);
    prm.add_parameter("Velocity",
                      velocity,
                      "Velocity u_1, zero at x = 0; components separated by "
                      "';', one alone is the axial one." +
                        variables);
    prm.leave_subsection();
  }



  void
  SourceParameters::add_parameters(ParameterHandler &prm)
  {
    const std::string variables =
      " Expression in x (y, z), t; pi and theta_A are known.";
    prm.enter_subsection("Sources");
    prm.add_parameter("Heat source",
                      heat_source,
                      "Heat source q per volume." + variables);
    prm.add_parameter("Body force",
                      body_force,
                      "Body force f per volume; components separated by ';', "
                      "one alone is the axial one." +
                        variables);
    prm.add_parameter("End traction",
                      end_traction,
                      "Traction t on the contact end, positive outward: the "
                      "end stress is -pressure + t." +
                        variables);
    prm.add_parameter("End heat flux",
                      end_heat_flux,
                      "Heat flux h into the contact end: -d theta/dn = "
                      "k (theta - theta_obs) - h." +
                        variables);
    prm.leave_subsection();
  }



  void
  MeshParameters::add_parameters(ParameterHandler &prm)
  {
    prm.enter_subsection("Mesh");
    prm.add_parameter("Cells",
                      cells,
                      "Number of cells along the rod; the paper: 250.",
                      Integer(1, 10000000));
    prm.add_parameter("Degree",
                      degree,
                      "Polynomial degree p of both fields; the paper: 1.",
                      Integer(1, 30));
    prm.add_parameter("Refinements",
                      refinements,
                      "Global refinements of that mesh.",
                      Integer(0, 30));
    prm.add_parameter("Grading",
                      grading,
                      "Size of the first cell over size of the last, in "
                      "geometric progression; 1 is uniform.",
                      Double(1e-8, 1e8));
    prm.add_parameter("Width",
                      width,
                      "Width (and height) of the body, for Dimension > 1; its "
                      "length is 1.",
                      Double(1e-3, 1e3));
    prm.add_parameter("Cells across",
                      cells_across,
                      "Number of cells across the body, for Dimension > 1.",
                      Integer(1, 100000));
    prm.leave_subsection();
  }



  void
  TimeParameters::add_parameters(ParameterHandler &prm)
  {
    prm.enter_subsection("Time");
    prm.add_parameter(
      "Scheme",
      scheme,
      "Time integrator: backward euler (order 1, the paper's), "
      "or the L-stable schemes sdirk2, sdirk3, sdirk4 of orders "
      "2, 3, 4 with 2, 3, 5 solves per step.",
      Selection(scheme_names()));
    prm.add_parameter("Start",
                      start,
                      "First step: paper (the end of the step is u_0 + dt u_1, "
                      "then the heat equation alone), consistent (a step like "
                      "all others), automatic (paper for backward euler).",
                      Selection("automatic|paper|consistent"));
    prm.add_parameter("End time", end_time, "End time T >= 0.", duration);
    prm.add_parameter("Step size",
                      step_size,
                      "Time step dt > 0; the last step is shortened to end at "
                      "T. The paper: 0.001.",
                      duration);
    prm.leave_subsection();
  }



  void
  SolverParameters::add_parameters(ParameterHandler &prm)
  {
    prm.enter_subsection("Solver");
    prm.add_parameter("Step solver",
                      step_solver,
                      "monolithic: one coupled solve with exact contact; fixed "
                      "point: the iteration (3.3)-(3.4) of the paper, which "
                      "converges for small steps only.",
                      Selection("monolithic|fixed point"));
    prm.add_parameter("Fixed point tolerance",
                      fixed_point_tolerance,
                      "Largest change of a displacement in the last iteration, "
                      "relative to the largest displacement.",
                      Double(1e-16, 1.));
    prm.add_parameter("Fixed point iterations",
                      fixed_point_iterations,
                      "Iterations per step after which the run stops with an "
                      "error.",
                      Integer(1, 1000000));
    prm.leave_subsection();
  }



  void
  OutputParameters::add_parameters(ParameterHandler &prm)
  {
    prm.enter_subsection("Output");
    prm.add_parameter("Directory",
                      directory,
                      "Output directory; empty: results/<name of the "
                      "parameter file>.");
    prm.add_parameter("Fields interval",
                      fields_interval,
                      "Fields (VTU) are written at the first step end at or "
                      "after each multiple of this time, and at T; 0: none.",
                      duration);
    prm.add_parameter("Contact interval",
                      contact_interval,
                      "Rows of contact.csv are written at the first step end "
                      "at or after each multiple of this time, and at T; 0: "
                      "every step.",
                      duration);
    prm.leave_subsection();
  }



  void
  Parameters::add_parameters(ParameterHandler &prm)
  {
    prm.add_parameter("Title",
                      title,
                      "Title of the run, for the log and the CSV files.");
    prm.add_parameter("Dimension",
                      dimension,
                      "Space dimension: 1 is the rod; in 2 (plane strain) and "
                      "3 the body is a box of length 1.",
                      Integer(1, 3));
    model.add_parameters(prm);
    boundary.add_parameters(prm);
    contact.add_parameters(prm);
    initial_values.add_parameters(prm);
    sources.add_parameters(prm);
    mesh.add_parameters(prm);
    time.add_parameters(prm);
    solver.add_parameters(prm);
    output.add_parameters(prm);
  }



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
    if (!(time.step_size > 0.))
      refuse("Time/Step size",
             time.step_size,
             "dt > 0",
             "the paper uses 0.001");
    if (time.start == "paper" && time.scheme != "backward euler")
      refuse("Time/Start",
             time.start,
             "consistent or automatic, since Time/Scheme = " + time.scheme,
             "the prescribed first step of the paper is of order 1");
    if (time.end_time / time.step_size > 1e9)
      refuse("Time/Step size",
             time.step_size,
             "at most 1e9 steps up to Time/End time",
             "enlarge the step or shorten the run");
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
    if (!solver.is_fixed_point())
      for (const char *path :
           {"Solver/Fixed point tolerance", "Solver/Fixed point iterations"})
        unused.push_back({path, "Solver/Step solver = monolithic"});
    return unused;
  }
} // namespace ThermoContact
