// SPDX-License-Identifier: LGPL-2.1-or-later

#include <thermocontact/base/text.h>
#include <thermocontact/input/constants.h>
#include <thermocontact/input/parameters.h>
#include <thermocontact/input/section_of_entries.h>
#include <thermocontact/input/unit_text.h>

#include <deal.II/base/patterns.h>

#include <algorithm>

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
    const std::string of_rod = kind_of_coefficients;
    SectionOfEntries  entry(prm, "Model");
    entry("Fields",
          fields,
          Selection("temperature and displacement|temperature|displacement"))
      .means("The fields that the scene has; the other one is absent from the "
             "unknowns, the matrices and the files.");
    entry("Inertia", inertia, coefficient)
      .means("Inertia coefficient b >= 0 of the momentum equation; 0 is "
             "quasi-static.",
             of_rod);
    entry("Viscosity", viscosity, coefficient)
      .means("Kelvin-Voigt viscosity zeta >= 0.", of_rod);
    entry("Coupling", coupling, signed_coefficient)
      .means("Thermoelastic coupling a: thermal stress -a theta and heating -a "
             "div u_t.",
             of_rod);
    entry("Thermoelastic heating", heating)
      .means("The term -a div u_t of the heat equation; false: motion does not "
             "heat the body.");
    entry("Poisson ratio", poisson_ratio, Double(-1., 0.5))
      .means("Poisson ratio nu, for Dimension > 1; the P-wave modulus is one "
             "for every nu.",
             of_rod);
  }



  void
  BoundaryParameters::add_parameters(ParameterHandler &prm)
  {
    const auto add_attached = [](SectionOfEntries  &entry,
                                 Attached          &end,
                                 const std::string &scenes) {
      entry("Spring", end.spring, coefficient)
        .means("Stiffness s >= 0 of a spring between the end and the ground, "
               "for " +
                 scenes + ": force over displacement, per area.",
               "spring");
      entry("Dashpot", end.dashpot, coefficient)
        .means("Coefficient d >= 0 of a dashpot between the end and the "
               "ground, for " +
                 scenes + ": force over velocity, per area.",
               "dashpot");
      entry("Mass", end.mass, coefficient)
        .means("Mass m >= 0 on the end, for Dimension = 1, per area; the body "
               "has the mass b.",
               "mass");
    };
    const NumberOrText load = NumberOrText::expression("x, y, z, t, theta_A");
    {
      SectionOfEntries entry(prm, "Boundary/left");
      entry("Support", left.support, Selection("clamped|sliding|free"))
        .means("The end x = 0: clamped (no displacement), sliding (no axial "
               "displacement, no shear stress, for Dimension > 1) or free "
               "(stress as given below).");
      entry("Displacement", left.displacement, NumberOrText::expression("t"))
        .means("Displacement u_A of the end along the axis, a base that moves: "
               "an expression in t, zero at t = 0, e.g. 0.1*sin(2*pi*t).",
               "length");
      entry("Traction", left.traction, load)
        .means("Traction t_A on a free end, positive outward: the stress "
               "there, but for spring, dashpot and mass.",
               "stress");
      add_attached(entry, left, "Dimension = 1");
      entry("Temperature",
            left.temperature,
            left.temperature_expression,
            NumberOrText::number_or_expression("t", true, "none"))
        .means("Temperature theta_A of the end; an expression in t, e.g. "
               "10*sin(2*pi*t); none: heat flows by the next three.",
               "temperature");
      entry("Heat exchange", left.heat_exchange, coefficient)
        .means("Heat exchange coefficient k_A >= 0 of an end without a given "
               "temperature: d theta/dx = k_A (theta - theta_sA) - h_A.",
               "heat exchange");
      entry("Surroundings", left.surroundings, any_number)
        .means("Temperature theta_sA of the surroundings of that end; also "
               "theta_A of expressions, where no temperature is given.",
               "temperature");
      entry("Heat flux", left.heat_flux, load)
        .means("Heat flux h_A into that end.", "heat flux");
    }
    {
      SectionOfEntries entry(prm, "Boundary/right");
      entry("Support", right.support, Selection("contact|free|clamped"))
        .means("The end x = 1, of a row of bodies its right end: contact (the "
               "obstacle of section Contact stands before it), free (there is "
               "none) or, for Dimension = 1, clamped (no displacement).");
      entry("Temperature",
            right.temperature,
            NumberOrText::word_or_number("none"))
        .means("Temperature theta_B of the end, for Dimension = 1; none: heat "
               "is exchanged there.",
               "temperature");
      entry("Traction", right.traction, load)
        .means("Traction t on the contact end x = 1, positive outward: the end "
               "stress is -pressure + t.",
               "stress");
      add_attached(entry, right, "Dimension = 1 or a mass as the obstacle");
      entry("Heat exchange",
            right.heat_exchange,
            right.exchange_expression,
            NumberOrText::number_or_expression("gap, pressure, theta, "
                                               "theta_obs, t",
                                               false))
        .means("Heat exchange coefficient k >= 0 of the contact end: -d "
               "theta/dn = k (theta - theta_obs); an expression in the local "
               "gap >= 0 and pressure >= 0, e.g. if(pressure > 0, 10 + "
               "5*pressure, 0.1/(0.1 + gap)), in the temperatures theta of the "
               "end and theta_obs, and in t.",
               "heat exchange");
      entry("Surroundings",
            right.surroundings,
            right.surroundings_expression,
            NumberOrText::number_or_expression("y, z, t", true))
        .means("Temperature theta_obs of the obstacle; an expression in t, and "
               "in y, z for Dimension > 1, e.g. 5*sin(2*pi*t).",
               "temperature");
      entry("Heat flux", right.heat_flux, load)
        .means("Heat flux h into the contact end: -d theta/dn = k (theta - "
               "theta_obs) - h.",
               "heat flux");
    }
    {
      SectionOfEntries entry(prm, "Boundary/sides");
      entry("Support", sides.support, Selection("rollers|free|symmetric"))
        .means("Lateral faces, for Dimension > 1: rollers (no normal "
               "displacement), free, or symmetric (a half or a quarter of a "
               "body with free faces: rollers at y = 0 and z = 0).");
      entry("Heat exchange", sides.heat_exchange, coefficient)
        .means("Heat m (theta - theta_inf) that the rod loses to its "
               "surroundings per volume, m >= 0; for Dimension > 1 through its "
               "lateral faces: -d theta/dn = m A/P (theta - theta_inf), A/P "
               "the area of the cross-section over its perimeter.",
               "heat loss");
      entry("Surroundings", sides.surroundings, any_number)
        .means("Temperature theta_inf of the surroundings.", "temperature");
    }
  }



  std::vector<Parameters::OwnLawOfKind>
  Parameters::own_laws() const
  {
    const ContactLawKind     &general = contact_law(contact.condition);
    std::vector<OwnLawOfKind> laws;
    if (contact.has_own_rear_law())
      laws.push_back({&contact.own_rear_law, &general});
    for (const PairParameters &pair : row.pairs)
      if (pair.has_own_law())
        laws.push_back({&pair.own_law, &pair.law_kind(general)});
    return laws;
  }



  std::vector<std::unique_ptr<const ContactLaw>>
  Parameters::make_contact_laws() const
  {
    std::vector<std::unique_ptr<const ContactLaw>> laws;
    if (uses_general_law())
      laws.push_back(contact_law(contact.condition).make(contact.law));
    for (const auto &[own, kind] : own_laws())
      laws.push_back(kind->make(own->instead_of(contact.law)));
    return laws;
  }



  void
  ContactParameters::add_parameters(ParameterHandler &prm)
  {
    SectionOfEntries entry(prm, "Contact");
    entry("Condition", condition, Selection(names_of(contact_laws())))
      .means("Contact end x = 1: " +
             in_words(contact_laws(),
                      [](const auto &law) { return " (" + law.text + ")"; }) +
             ".");
    for (const ContactLawEntry &one : contact_law_entries())
      entry(one.name,
            one.default_value,
            Double(one.smallest, one.largest),
            [this, name = one.name](const double value) { law[name] = value; })
        .means(one.text, one.kind);
    own_rear_law.add_entries(entry, "of the obstacle behind the end");
    entry("Stiffness", stiffness, NumberOrText::word("none"))
      .means("In place of Compliance in a file with section Rod: force over "
             "penetration, N/m, or over its power Exponent, N/m^m.",
             "stiffness");
    entry("Gap",
          gap,
          gap_expression,
          NumberOrText::number_or_expression("y, z, t", true))
      .means("Gap g between the undeformed rod and the obstacle; negative is a "
             "preload. An expression in t moves the obstacle, e.g. "
             "0.1-0.02*sin(3*t); in y, z, for Dimension > 1, it is the shape, "
             "e.g. 0.1+(y-0.05)^2/2.",
             "length");
    entry("Rear gap", rear_gap, NumberOrText::word("none"))
      .means(
        "Gap g_2 to a second obstacle of the same kind behind the end, "
        "u(1) >= -g_2; its pressures are negative. none: no such obstacle.",
        "length");
    entry("Restitution", restitution, NumberOrText::word("none"))
      .means("Coefficient e of restitution, 0 <= e <= 1, where a rigid mass of "
             "section Bodies meets a mass or the obstacle and the contact is "
             "rigid: it leaves with e times the velocity.");
    entry("Massless nodes", massless_nodes, Selection("automatic|on|off"))
      .means(
        "The mass of the contact nodes is moved to their neighbours, for "
        "impacts without oscillations; automatic: where the viscosity does "
        "not damp the oscillation of one node, on a rigid obstacle if "
        "Dimension > 1, and for the scheme energy conserving.");
  }



  const std::vector<ScalesParameters::Scale> &
  ScalesParameters::all()
  {
    using S                                = ScalesParameters;
    static const std::vector<Scale> scales = {
      {"Length", &S::length, false, true, "Length of the rod, m."},
      {"Time",
       &S::time,
       false,
       true,
       "Time in which heat diffuses through the rod, s."},
      {"Displacement",
       &S::displacement,
       false,
       false,
       "Unit of displacement, gap and penetration, m; none: Length."},
      {"Stress", &S::stress, false, true, "Unit of stress and pressure, Pa."},
      {"Area",
       &S::area,
       false,
       true,
       "Area of the cross-section, m^2: a force is a stress times it."},
      {"Temperature",
       &S::temperature,
       true,
       true,
       "Unit of temperatures above the reference, K."},
      {"Reference temperature",
       &S::reference_temperature,
       true,
       true,
       "Absolute temperature of the rod without stress, K, at which the "
       "nondimensional one is 0."}};
    return scales;
  }



  void
  ScalesParameters::add_parameters(ParameterHandler &prm)
  {
    const NumberOrText none = NumberOrText::word("none");
    SectionOfEntries   entry(prm, "Scales");
    for (const Scale &scale : all())
      entry(scale.name, this->*scale.value, none)
        .means(scale.text, kind_of_coefficients);
    entry("Time unit", time_unit, Selection(names_of_time_units))
      .means("Unit of times in files and on the screen.");
    entry("Temperature unit", temperature_unit, Selection("K|C"))
      .means("Unit of temperatures there: kelvin, or C for degrees Celsius.");
  }



  bool
  ScalesParameters::is_given() const
  {
    return std::any_of(all().begin(), all().end(), [this](const Scale &scale) {
      return (this->*scale.value).has_value();
    });
  }



  void
  RodParameters::add_parameters(ParameterHandler &prm)
  {
    const Double     positive(0., 1e30);
    SectionOfEntries entry(prm, "Rod");
    entry("Length", length, positive)
      .means(
        "Length L of the body, m. A file with this section is in SI units; "
        "0: there is none.",
        "length");
    entry.unbound("Cross-section area", "0", positive)
      .means("Area A of the cross-section, m^2.", "area");
    entry("Density", density, positive)
      .means("Density rho, kg/m^3.", "density");
    entry("Young's modulus", youngs_modulus, positive)
      .means("Young's modulus E, Pa.", "stress");
    entry.unbound("Poisson ratio", "0", Double(-0.999, 0.4999))
      .means("Poisson ratio nu, for confined lateral sides and Dimension > 1.");
    entry("Lateral sides", lateral_sides, Selection("free|confined"))
      .means("For Dimension = 1: free, a thin rod, whose stiffness is Young's "
             "modulus; or confined, no lateral strain: the P-wave modulus.");
    entry.unbound("Viscosity", "0", positive)
      .means("Kelvin-Voigt viscosity eta, Pa s: stress eta u_xt.", "viscosity");
    entry.unbound("Linear expansion", "0", Double(-1., 1.))
      .means("Coefficient alpha of linear thermal expansion, 1/K.",
             "thermal expansion");
    entry.unbound("Conductivity", "0", positive)
      .means("Heat conductivity kappa, W/(m K).", "conductivity");
    entry.unbound("Heat capacity", "0", positive)
      .means("Specific heat capacity c, J/(kg K).", "heat capacity");
    entry.unbound("Reference temperature", "0", positive)
      .means("Temperature of the body without stress, K; also of the body, the "
             "obstacle and the surroundings unless they are given.",
             "temperature");
    entry("Small terms", small_terms, Selection("automatic|kept|dropped"))
      .means(
        "Inertia and viscosity: kept, dropped, or automatic: dropped where "
        "their times, of a wave through the body and of relaxation, are "
        "below 1e-5 of the run, which has no initial velocity, moving end or "
        "rear stop.");
  }



  std::vector<double>
  OutputParameters::landing_intervals() const
  {
    std::vector<double> intervals;
    if (land_on_times)
      for (const double interval :
           {fields_interval, contact_interval, space_time_interval})
        if (interval > 0.)
          intervals.push_back(interval);
    if (period > 0.)
      intervals.push_back(period);
    return intervals;
  }



  void
  OutputParameters::add_parameters(ParameterHandler &prm)
  {
    SectionOfEntries entry(prm, "Output");
    entry("Directory", directory)
      .means("Output directory; empty: results/<name of the parameter file>.");
    entry("Fields interval", fields_interval, duration)
      .means("Fields (VTU) are written at the first step end at or after each "
             "multiple of this time, at the first contact, and at T; 0: none.",
             "time");
    entry("Fields cells", fields_cells, Selection("linear|Lagrange"))
      .means("linear: cells of degree p are written as p^d cells of degree 1; "
             "Lagrange, for Dimension > 1: as Lagrange cells of VTK, whose "
             "polynomials ParaView draws.");
    entry("Contact interval", contact_interval, duration)
      .means("Rows of contact.csv are written at the first step end at or "
             "after each multiple of this time, and at T; 0: every step.",
             "time");
    entry("Boundaries", boundaries)
      .means("Write boundaries.csv: heat, momentum and work that come through "
             "the ends and the sides.");
    entry("Probes", probes)
      .means("Positions, separated by ';', the coordinates of each by ',': "
             "histories of the fields there (probes.csv), in the rows of "
             "contact.csv. Empty: none.",
             "length");
    entry("Space-time interval", space_time_interval, duration)
      .means("The fields on the axis are kept at the first step end at or "
             "after each multiple of this time, and at T, for one picture over "
             "x and t (space-time.vtu); 0: none.",
             "time");
    entry("Period", period, duration)
      .means("Period P of a drive: steps end at its multiples, and "
             "poincare.csv has a row of contact.csv for each of them; 0: none.",
             "time");
    entry("Land on output times", land_on_times)
      .means("Steps are shortened to end on the multiples of the intervals; "
             "costs solves.");
    entry("Checkpoint interval", checkpoint_interval, Double(0., 1e9))
      .means("Wall-clock seconds between checkpoints, from which --resume goes "
             "on; also at the start and the end; 0: none, but for one when "
             "SIGTERM, SIGINT or SIGHUP ends the run.",
             "s");
    entry("SI", is_si)
      .means("Files and screen in SI units, if section Rod or Scales is given; "
             "false: nondimensional.");
    entry("Error bars", has_error_bars)
      .means("Repeats the run with larger steps and on coarser meshes, without "
             "files, and says how far the key results may be wrong by either "
             "(screen, summary.json); about three times the time.");
  }



  void
  StudyParameters::add_parameters(ParameterHandler &prm)
  {
    SectionOfEntries entry(prm, "Study");
    entry("Vary", vary)
      .means(
        "Runs the scene for all combinations of values: Section/Entry = "
        "value | value ; Section/Entry = value | ... . Values may be "
        "ranges, 0.6 .. 2.6 (61) or 1e-3 .. 1 (7 log); constants vary, too, "
        "Constants/omega. Entries that go together, as many values of "
        "each, are separated by ',': A = a1 | a2 , B = b1 | b2. "
        "Several sets of combinations are separated by ';;'. Values "
        "cannot hold '|' or ';'. Empty: runs once.");
    entry("Reference", reference)
      .means("none, or overrides Section/Entry = value ; ... for the run that "
             "errors are measured against.");
    entry("Repetitions", repetitions, Integer(1, 1000))
      .means("Number of times that each run is made, for timing.");
    entry("Target error", target_error, duration)
      .means("Largest error of displacement_end that is wanted: the cheapest "
             "run that meets it is named; 0: none.",
             "length");
    entry("Keep files", keep_files)
      .means("Each run writes its files into a folder of its own.");
  }



  void
  InitialValuesParameters::add_parameters(ParameterHandler &prm)
  {
    const NumberOrText field = NumberOrText::expression("x, y, z, theta_A");
    SectionOfEntries   entry(prm, "Initial values");
    entry("Temperature", temperature, field)
      .means("Temperature theta_0.", "temperature");
    entry("Displacement", displacement, field)
      .means(
        "Displacement u_0, zero at an end x = 0 that is held; components separated by ';', "
        "one alone is the axial one.",
        "length");
    entry("Velocity", velocity, field)
      .means(
        "Velocity u_1, zero at an end x = 0 that is held; components separated by ';', one "
        "alone is the axial one.",
        "velocity");
  }



  void
  SourceParameters::add_parameters(ParameterHandler &prm)
  {
    const NumberOrText source = NumberOrText::expression("x, y, z, t, theta_A");
    SectionOfEntries   entry(prm, "Sources");
    entry("Heat source", heat_source, source)
      .means("Heat source q per volume.", "heat source");
    entry("Body force", body_force, source)
      .means("Body force f per volume; components separated by ';', one alone "
             "is the axial one.",
             "body force");
  }



  void
  TimeParameters::add_parameters(ParameterHandler &prm)
  {
    SectionOfEntries entry(prm, "Time");
    entry("Scheme",
          scheme,
          Selection(automatic_scheme + "|" + names_of(schemes())))
      .means("Time integrator: automatic (box where an impact or a jump makes "
             "waves in a rod that its viscosity does not smooth, else " +
             default_scheme().name + "), " +
             in_words(schemes(), describe_scheme) + ".");
    entry("Start", start, Selection("automatic|paper|consistent"))
      .means(
        "First step: paper (the end of the step is u_0 + dt u_1, then the "
        "heat equation alone), consistent (a step like all others), "
        "automatic (paper for " +
        find_scheme([](const Scheme &s) { return s.is_backward_euler; })->name +
        ").");
    entry("End time", end_time, duration).means("End time T >= 0.", "time");
    entry("Step size", step_size, NumberOrText::word("automatic"))
      .means("Time step dt > 0, shorter where a step ends at T, at a contact "
             "event or at an output time; automatic: from the "
             "error estimate of the scheme and the tolerance, or with "
             "Time/Scheme = box the time h sqrt(b) in which a wave passes a "
             "cell. The paper: 0.001.",
             "time");
    entry("Tolerance", tolerance, Double(1e-13, 0.1))
      .means("Tolerance of automatic steps: error per step, relative to the "
             "running maximum of each field; of the automatic cells of "
             "Time/Scheme = box.");
    entry("First step size", first_step_size, NumberOrText::word("automatic"))
      .means("First of the automatic steps.", "time");
    entry("Minimum step size", minimum_step_size, duration)
      .means("An automatic step that would have to be smaller stops the run "
             "with an error; steps to contact events, output times and T may "
             "be smaller.",
             "time");
    entry("Maximum step size",
          maximum_step_size,
          NumberOrText::word("infinity"))
      .means("Largest automatic step.", "time");
    entry("Locate contact events",
          locate_contact_events,
          Selection("automatic|true|false"))
      .means("Steps end where contact begins or ends, which keeps the order of "
             "the scheme; automatic: with automatic steps.");
    entry("Break points", break_points, List(duration, 0, 100000, ";"))
      .means(
        "Times, separated by ';', at which steps end, for loads that jump "
        "or bend there. Automatic steps find jumps and kinks of expressions "
        "in t by themselves. Times after T have no effect.",
        "time");
  }



  void
  SolverParameters::add_parameters(ParameterHandler &prm)
  {
    SectionOfEntries entry(prm, "Solver");
    entry("Step solver", step_solver, Selection("monolithic|fixed point"))
      .means("monolithic: one coupled solve with exact contact; fixed point: "
             "the iteration (3.3)-(3.4) of the paper, which converges for "
             "small steps only.");
    entry("Fixed point tolerance", fixed_point_tolerance, Double(1e-16, 1.))
      .means("Largest change of a displacement in the last iteration, relative "
             "to the largest displacement.");
    entry("Fixed point iterations", fixed_point_iterations, Integer(1, 1000000))
      .means("Iterations per step after which the run stops with an error.");
    entry("Linear solver",
          linear_solver,
          Selection("automatic|direct|iterative"))
      .means("direct: sparse factors of the stage matrix, one set for each "
             "step size; iterative: Krylov and multigrid without matrices, for "
             "large bodies; automatic: blocks along the rod in one dimension "
             "and one process, else iterative beyond 13000 unknowns in two "
             "(energy conserving and fixed point: 130000) and 3000 in three "
             "dimensions.");
    entry("Linear tolerance", linear_tolerance, NumberOrText::word("automatic"))
      .means("Residual at which the iterative solver stops, relative to the "
             "terms of the equations of a stage: at least 1e-14 and below "
             "0.01; automatic: 1e-9.");
  }



  ExpressionNames
  Parameters::names(const std::string &path) const
  {
    const auto      known = entry_of_program(path).variables(dimension);
    ExpressionNames names;
    if (known.front() == "gap")
      {
        names.variables     = known;
        names.checks_values = false; // a scene knows the temperatures
      }
    else
      for (const char *const name : {"x", "y", "z", "t"})
        names.variables.emplace_back(
          std::find(known.begin(), known.end(), name) == known.end() ? "" :
                                                                       name);
    names.constants = constants;
    names.folder    = folder;
    names.has_units = rod.is_given();
    return names;
  }



  const std::vector<DeclaredEntry> &
  entries_of_program()
  {
    static const std::vector<DeclaredEntry> entries = []() {
      Parameters       parameters;
      ParameterHandler prm;
      parameters.add_parameters(prm);
      return declared_entries(prm);
    }();
    return entries;
  }



  const DeclaredEntry *
  find_entry(const std::string &path)
  {
    const auto &entries = entries_of_program();
    const auto  entry =
      std::find_if(entries.begin(),
                   entries.end(),
                   [declared = declared_path(path)](const DeclaredEntry &one) {
                     return one.path == declared;
                   });
    return entry == entries.end() ? nullptr : &*entry;
  }



  const DeclaredEntry &
  entry_of_program(const std::string &path)
  {
    return *find_entry(path);
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
    SectionOfEntries(prm, "Constants")
      .unbound(name_of_constants, "", Anything())
      .means("A constant of any name that means nothing else: a number, or an "
             "expression in other constants, e.g. omega = 2.1, P = 2*pi/omega. "
             "Every expression and every number of the file may name it, e.g. "
             "Time/End time = 40*P.");
    model.add_parameters(prm);
    RowParameters::add_templates(prm);
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
