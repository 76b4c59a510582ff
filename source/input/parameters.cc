// SPDX-License-Identifier: LGPL-2.1-or-later

#include <thermocontact/base/text.h>
#include <thermocontact/input/constants.h>
#include <thermocontact/input/number_or_word.h>
#include <thermocontact/input/parameters.h>
#include <thermocontact/input/words_of_kinds.h>

#include <deal.II/base/patterns.h>

#include <limits>

namespace ThermoContact
{
  namespace
  {
    using namespace dealii::Patterns;

    // Beyond 1e15 a coefficient leaves nothing of the others in a sum.
    const Double coefficient(0., 1e15);
    const Double signed_coefficient(-1e15, 1e15),
      duration(0., 1e15), any_number;



    std::string
    describe_scheme(const Scheme &scheme)
    {
      return text(" (order ", scheme.order, ", ", scheme.text, ")");
    }
  } // namespace



  void
  ModelParameters::add_parameters(ParameterHandler &prm)
  {
    prm.enter_subsection("Model");
    prm.add_parameter("Fields",
                      fields,
                      "The fields that the scene has; the other one is absent "
                      "from the unknowns, the matrices and the files.",
                      Selection("temperature and displacement|temperature|"
                                "displacement"));
    prm.add_parameter("Inertia",
                      inertia,
                      "Inertia coefficient b >= 0 of the momentum equation; 0 "
                      "is quasi-static.",
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
    prm.add_parameter("Thermoelastic heating",
                      heating,
                      "The term -a div u_t of the heat equation; false: motion "
                      "does not heat the body.");
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
    add_number_or_expression(
      prm,
      "Fixed end temperature",
      fixed_end_temperature,
      "t",
      "Temperature theta_A of the fixed end x = 0; an expression in t, e.g. "
      "10*sin(2*pi*t).",
      [this](const double number, const std::string &expression) {
        fixed_end_temperature = number;
        fixed_end_expression  = expression;
      },
      true);
    prm.add_parameter("Fixed end displacement",
                      fixed_end_displacement,
                      "Displacement u_A of the fixed end x = 0 along the axis, "
                      "a base that moves: an expression in t, zero at t = 0, "
                      "e.g. 0.1*sin(2*pi*t).");
    add_number_or_expression(
      prm,
      "Heat exchange",
      heat_exchange,
      "gap, pressure",
      "Heat exchange coefficient k >= 0 of the contact end: -d theta/dn = k "
      "(theta - theta_obs); an expression in the local gap >= 0 and pressure >= "
      "0, e.g. if(pressure > 0, 10 + 5*pressure, 0.1/(0.1 + gap)).",
      [this](const double number, const std::string &expression) {
        heat_exchange       = number;
        exchange_expression = expression;
      });
    add_number_or_expression(
      prm,
      "Obstacle temperature",
      obstacle_temperature,
      "y, z, t",
      "Temperature theta_obs of the obstacle; an expression in t, and in y, z "
      "for Dimension > 1, e.g. 5*sin(2*pi*t), if the heat exchange is a number.",
      [this](const double number, const std::string &expression) {
        obstacle_temperature = number;
        obstacle_expression  = expression;
      },
      true);
    prm.add_parameter("Lateral heat exchange",
                      lateral_heat_exchange,
                      "Heat m (theta - theta_inf) that the rod loses to its "
                      "surroundings per volume, m >= 0; for Dimension > 1 "
                      "through its lateral faces: -d theta/dn = m A/P (theta - "
                      "theta_inf), A/P the area of the cross-section over its "
                      "perimeter.",
                      coefficient);
    prm.add_parameter("Ambient temperature",
                      ambient_temperature,
                      "Temperature theta_inf of the surroundings.",
                      any_number);
    prm.add_parameter("Lateral support",
                      lateral_support,
                      "Lateral faces, for Dimension > 1: rollers (no normal "
                      "displacement) or free.",
                      Selection("rollers|free"));
    prm.add_parameter("Fixed end support",
                      fixed_end_support,
                      "The fixed end x = 0, for Dimension > 1: clamped (no "
                      "displacement) or sliding (no axial displacement, no "
                      "shear stress).",
                      Selection("clamped|sliding"));
    prm.leave_subsection();
  }



  void
  InitialValuesParameters::add_parameters(ParameterHandler &prm)
  {
    const std::string variables =
      " Expression in x (y, z); pi is known, and theta_A where there is a "
      "temperature.";
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
      " Expression in x (y, z), t; pi is known, and theta_A where there is a "
      "temperature.";
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
  TimeParameters::add_parameters(ParameterHandler &prm)
  {
    prm.enter_subsection("Time");
    prm.add_parameter("Scheme",
                      scheme,
                      "Time integrator: " +
                        in_words(schemes(), describe_scheme) + ".",
                      Selection(names_of(schemes())));
    prm.add_parameter(
      "Start",
      start,
      "First step: paper (the end of the step is u_0 + dt u_1, "
      "then the heat equation alone), consistent (a step like "
      "all others), automatic (paper for " +
        find_scheme([](const Scheme &s) { return s.is_of_paper; })->name + ").",
      Selection("automatic|paper|consistent"));
    prm.add_parameter("End time", end_time, "End time T >= 0.", duration);
    add_number_or_word(
      prm,
      "Step size",
      "automatic",
      "Time step dt > 0, the same for all steps but those that end at T, at "
      "a contact event or at an output time; automatic: from the error "
      "estimate of the scheme and the tolerance. The paper: 0.001.",
      [this](const double *dt) {
        step_size = dt ? std::optional<double>(*dt) : std::nullopt;
      });
    prm.add_parameter("Tolerance",
                      tolerance,
                      "Tolerance of automatic steps: error per step, relative "
                      "to the running maximum of each field.",
                      Double(1e-13, 0.1));
    add_number_or_word(prm,
                       "First step size",
                       "automatic",
                       "First of the automatic steps.",
                       [this](const double *dt) {
                         first_step_size =
                           dt ? std::optional<double>(*dt) : std::nullopt;
                       });
    prm.add_parameter("Minimum step size",
                      minimum_step_size,
                      "An automatic step that would have to be smaller stops "
                      "the run with an error; steps to contact events, output "
                      "times and T may be smaller.",
                      duration);
    add_number_or_word(prm,
                       "Maximum step size",
                       "infinity",
                       "Largest automatic step.",
                       [this](const double *dt) {
                         maximum_step_size =
                           dt ? *dt : std::numeric_limits<double>::infinity();
                       });
    prm.add_parameter("Locate contact events",
                      locate_contact_events,
                      "Steps end where contact begins or ends, which keeps the "
                      "order of the scheme; automatic: with automatic steps.",
                      Selection("automatic|true|false"));
    prm.add_parameter(
      "Break points",
      break_points,
      "Times, separated by ';', at which steps end, for loads "
      "that jump or bend there. Automatic steps find those "
      "of expressions in t by themselves. Times after T have no "
      "effect.",
      List(duration, 0, 100000, ";"));
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
    prm.add_parameter(
      "Linear solver",
      linear_solver,
      "direct: sparse factors of the stage matrix, one set for "
      "each step size; iterative: Krylov and multigrid without "
      "matrices, for large bodies in two and three dimensions; "
      "automatic: blocks along the rod in one dimension and one "
      "process, else what is faster for the number of "
      "unknowns.",
      Selection("automatic|direct|iterative"));
    add_number_or_word(prm,
                       "Linear tolerance",
                       "automatic",
                       "Residual at which the iterative solver stops, relative "
                       "to the terms of the equations of a stage: at least "
                       "1e-14 and below 0.01; automatic: 1e-9.",
                       [this](const double *number) {
                         linear_tolerance = number ?
                                              std::optional<double>(*number) :
                                              std::nullopt;
                       });
    prm.leave_subsection();
  }



  ExpressionNames
  Parameters::names(const std::string &,
                    const std::vector<std::string> &variables,
                    const std::string              &example) const
  {
    ExpressionNames names;
    names.variables = variables;
    names.example   = example;
    names.constants = constants;
    names.folder    = folder;
    names.has_units = rod.length > 0.;
    return names;
  }



  std::vector<std::string>
  Parameters::coordinates(const bool has_time) const
  {
    return {"x",
            dimension > 1 ? "y" : "",
            dimension > 2 ? "z" : "",
            has_time ? "t" : ""};
  }



  void
  Parameters::add_parameters(ParameterHandler &prm)
  {
    prm.add_parameter("Title",
                      title,
                      "Title of the run, for the log and the CSV files.");
    prm.add_parameter("Dimension",
                      dimension,
                      "Space dimension: 1 is the rod; in 2 the body is a strip "
                      "or a round rod (Mesh/Geometry), in 3 a box, of length "
                      "1.",
                      Integer(1, 3));
    prm.enter_subsection("Constants");
    prm.declare_entry(
      name_of_constants,
      "",
      Anything(),
      "A constant of any name that means nothing else: a number, "
      "or an expression in other constants, e.g. omega = 2.1, P "
      "= 2*pi/omega. Every expression and every number of the "
      "file may name it, e.g. Time/End time = 40*P.");
    prm.add_action(name_of_constants, [this](const std::string &values) {
      constants = constants_of(values);
      folder    = folder_of(values);
    });
    prm.leave_subsection();
    model.add_parameters(prm);
    boundary.add_parameters(prm);
    contact.add_parameters(prm);
    initial_values.add_parameters(prm);
    sources.add_parameters(prm);
    mesh.add_parameters(prm);
    time.add_parameters(prm);
    solver.add_parameters(prm);
    output.add_parameters(prm);
    scales.add_parameters(prm);
    rod.add_parameters(prm);
    study.add_parameters(prm);
  }
} // namespace ThermoContact
