// SPDX-License-Identifier: LGPL-2.1-or-later

#include <thermocontact/base/exceptions.h>
#include <thermocontact/base/text.h>
#include <thermocontact/input/declared_entries.h>
#include <thermocontact/input/number_or_word.h>
#include <thermocontact/input/parameter_file.h>
#include <thermocontact/input/parameters.h>
#include <thermocontact/input/units.h>

#include <deal.II/base/patterns.h>

#include <algorithm>
#include <cmath>
#include <sstream>

namespace ThermoContact
{
  namespace
  {
    using namespace dealii::Patterns;

    const Double positive(1e-30, 1e30);
    const Double not_negative(0., 1e30);
    const Double any_sign(-1e30, 1e30);
    const Double kelvin(1e-3, 1e6);

    // Below this, inertia and viscosity are ringing of relative size b^(1/4)
    // after sudden changes, in steps far below those of heat.
    constexpr double small_term = 1e-6;



    /** Refuses to take a value of the example for one that is not given. */
    void
    check_complete(const std::string             &file_name,
                   const std::vector<Assignment> &assignments,
                   const ParameterHandler        &prm)
    {
      const auto is_optional = [](const std::string &path) {
        return path == "Title" || path == "Small terms" ||
               path == "Rod/Lateral sides";
      };
      for (const DeclaredEntry &entry : declared_entries(prm))
        if (!is_optional(entry.path) &&
            std::none_of(assignments.begin(),
                         assignments.end(),
                         [&](const Assignment &assignment) {
                           return assignment.path == entry.path;
                         }))
          throw InputError(
            quote(file_name) + ": " + entry.path +
            " is not given\n  allowed: " + describe_pattern(entry.pattern) +
            "\n  meaning: " + entry.text + " Steel: " + entry.default_value);
    }



    std::string
    number(const double value)
    {
      return significant(value, 12);
    }



    /** A line of a table: name, number, unit, all in a comment. */
    std::string
    row(const std::string &name, const double value, const std::string &unit)
    {
      return text("#   ",
                  align_left(name, 38),
                  ' ',
                  align_left(number(value), 20),
                  ' ',
                  unit,
                  '\n');
    }



    std::string
    write_scales(const UnitScales &scales)
    {
      return "# One unit of the scene is\n" +
             row("length, displacement", scales.length, "m") +
             row("time", scales.time, "s") +
             row("temperature above the reference", scales.temperature, "K") +
             row("velocity", scales.velocity, "m/s") +
             row("stress, pressure", scales.stress, "Pa") +
             row("force", scales.force, "N") +
             row("heat flux", scales.heat_flux, "W/m^2") +
             row("energy", scales.energy, "J") + "#\n";
    }



    std::string
    write_factors(const RodInUnits &rod, const UnitScales &scales)
    {
      return "# Columns of contact.csv in SI units: multiply by\n" +
             row("time, step_size", scales.time, "s") +
             row("displacement_*, gap, penetration", scales.length, "m") +
             row("velocity_end", scales.velocity, "m/s") +
             row("stress_end", scales.stress, "Pa") +
             row("contact_force", scales.force, "N") +
             row("contact_impulse", scales.force * scales.time, "N s") +
             row("temperature_*, then add " + number(rod.reference_temperature),
                 scales.temperature,
                 "K") +
             row("heat_flux_end", scales.heat_flux, "W/m^2") +
             row("energy, work, *dissipation", scales.energy, "J") + "\n";
    }



    std::string
    write_scene(const RodInUnits &rod, const ScaledRod &scaled)
    {
      const bool drops         = rod.small_terms == "dropped";
      const bool has_inertia   = !(drops && scaled.inertia < small_term);
      const bool has_viscosity = !(drops && scaled.viscosity < small_term);
      const auto coefficient =
        [](const std::string &symbol, const double value, const bool is_kept) {
          return (is_kept ? number(value) : "0") + " # " + symbol +
                 (is_kept ? "" :
                            " = " + number(value) +
                              ", dropped; kept by Small terms = kept") +
                 '\n';
        };
      std::string text;
      if (!rod.title.empty())
        text += "set Title = " + rod.title + '\n';
      text += "subsection Model\n  set Inertia = " +
              coefficient("b", scaled.inertia, has_inertia) +
              "  set Viscosity = " +
              coefficient("zeta", scaled.viscosity, has_viscosity) +
              "  set Coupling = " + number(scaled.coupling) + " # a\nend\n";
      text += "subsection Boundary\n  set Fixed end temperature = " +
              number(scaled.fixed_end_temperature) + " # theta_A; " +
              number(rod.fixed_end_temperature) +
              " K\n  set Heat exchange = " + number(scaled.heat_exchange) +
              " # k\n";
      if (scaled.heat_exchange > 0.)
        text += "  set Obstacle temperature = " +
                number(scaled.obstacle_temperature) + " # theta_obs; " +
                number(rod.obstacle_temperature) + " K\n";
      text += "end\nsubsection Contact\n";
      text += rod.stiffness ?
                "  set Compliance = " + number(scaled.compliance) +
                  " # epsilon; " + number(*rod.stiffness) + " N/m\n" :
                "  set Condition = rigid\n";
      text += "  set Gap = " + number(scaled.gap) + " # g; " + number(rod.gap) +
              " m\nend\n";
      text += "subsection Initial values\n  set Temperature = " +
              number(scaled.initial_temperature) + " # theta_0; " +
              number(rod.initial_temperature) + " K\n";
      if (has_inertia || has_viscosity)
        text += "  set Displacement = 0\n";
      if (has_inertia)
        text += "  set Velocity = 0\n";
      return text + "end\nsubsection Time\n  set End time = " +
             number(scaled.end_time) + " # T; " + number(rod.end_time) +
             " s\nend\nsubsection Output\n  set Fields interval = " +
             significant(scaled.end_time / 20., 6) + "\nend\n";
    }
  } // namespace



  void
  RodInUnits::add_parameters(ParameterHandler &prm)
  {
    prm.add_parameter("Title", title, "Title of the scene.");
    prm.add_parameter("Small terms",
                      small_terms,
                      "Inertia b and viscosity zeta below 1e-6 are dropped, or "
                      "kept.",
                      Selection("dropped|kept"));

    add_rod(prm);
    add_temperatures(prm);
    add_obstacle(prm);

    prm.enter_subsection("Time");
    prm.add_parameter("End time", end_time, "End time, s.", not_negative);
    prm.leave_subsection();
  }



  void
  RodInUnits::add_rod(ParameterHandler &prm)
  {
    prm.enter_subsection("Rod");
    prm.add_parameter("Length", length, "Length L of the rod, m.", positive);
    prm.add_parameter("Cross-section area",
                      area,
                      "Area A of the cross-section, m^2.",
                      positive);
    prm.add_parameter("Density", density, "Density rho, kg/m^3.", positive);
    prm.add_parameter("Young's modulus",
                      youngs_modulus,
                      "Young's modulus E, Pa.",
                      positive);
    prm.add_parameter("Poisson ratio",
                      poisson_ratio,
                      "Poisson ratio nu, for confined lateral sides.",
                      Double(-0.999, 0.4999));
    prm.add_parameter("Lateral sides",
                      lateral_sides,
                      "free: a thin rod, whose stiffness is Young's modulus; "
                      "confined: no lateral strain, P-wave modulus.",
                      Selection("free|confined"));
    prm.add_parameter("Viscosity",
                      viscosity,
                      "Kelvin-Voigt viscosity eta, Pa s: stress eta u_xt.",
                      not_negative);
    prm.add_parameter("Linear expansion",
                      linear_expansion,
                      "Coefficient alpha of linear thermal expansion, 1/K.",
                      Double(-1., 1.));
    prm.add_parameter("Conductivity",
                      conductivity,
                      "Heat conductivity kappa, W/(m K).",
                      positive);
    prm.add_parameter("Heat capacity",
                      heat_capacity,
                      "Specific heat capacity c, J/(kg K).",
                      positive);
    prm.leave_subsection();
  }



  void
  RodInUnits::add_temperatures(ParameterHandler &prm)
  {
    prm.enter_subsection("Temperatures");
    prm.add_parameter("Reference",
                      reference_temperature,
                      "Absolute temperature of the rod without stress, K.",
                      kelvin);
    prm.add_parameter("Initial",
                      initial_temperature,
                      "Temperature of the rod at t = 0, K.",
                      kelvin);
    prm.add_parameter("Fixed end",
                      fixed_end_temperature,
                      "Temperature of the fixed end, K.",
                      kelvin);
    prm.add_parameter("Obstacle",
                      obstacle_temperature,
                      "Temperature of the obstacle, K.",
                      kelvin);
    prm.leave_subsection();
  }



  void
  RodInUnits::add_obstacle(ParameterHandler &prm)
  {
    prm.enter_subsection("Obstacle");
    prm.add_parameter("Gap",
                      gap,
                      "Gap between the rod without stress, at the reference "
                      "temperature, and the obstacle, m.",
                      any_sign);
    add_number_or_word(
      prm,
      "Stiffness",
      "infinity",
      "Stiffness of the obstacle, force over penetration, N/m; infinity: "
      "rigid.",
      [this](const double *value) {
        stiffness = value ? std::optional<double>(*value) : std::nullopt;
      });
    prm.add_parameter("Exchange coefficient",
                      exchange_coefficient,
                      "Heat exchange between the end and the obstacle, "
                      "W/(m^2 K).",
                      not_negative);
    prm.leave_subsection();
  }



  double
  RodInUnits::modulus() const
  {
    const double nu = poisson_ratio;
    return youngs_modulus * (lateral_sides == "confined" ?
                               (1. - nu) / ((1. + nu) * (1. - 2. * nu)) :
                               1.);
  }



  double
  RodInUnits::expansion() const
  {
    return linear_expansion * (lateral_sides == "confined" ?
                                 (1. + poisson_ratio) / (1. - poisson_ratio) :
                                 1.);
  }



  UnitScales::UnitScales(const RodInUnits &rod)
    : length(rod.length)
    , time(rod.density * rod.heat_capacity * rod.length * rod.length /
           rod.conductivity)
    , temperature(std::sqrt(rod.modulus() * rod.reference_temperature /
                            (rod.density * rod.heat_capacity)))
    , stress(rod.modulus())
    , force(stress * rod.area)
    , velocity(length / time)
    , heat_flux(rod.conductivity * temperature / length)
    , energy(force * length)
  {}



  ScaledRod::ScaledRod(const RodInUnits &rod)
  {
    const UnitScales scales(rod);
    const auto       scale_temperature = [&](const double kelvin) {
      return (kelvin - rod.reference_temperature) / scales.temperature;
    };
    coupling  = rod.expansion() * scales.temperature;
    inertia   = rod.density * scales.velocity * scales.velocity / scales.stress;
    viscosity = rod.viscosity / (scales.stress * scales.time);
    heat_exchange = rod.exchange_coefficient * rod.length / rod.conductivity;
    compliance =
      rod.stiffness ? scales.force / (*rod.stiffness * scales.length) : 0.;
    gap                   = rod.gap / scales.length;
    fixed_end_temperature = scale_temperature(rod.fixed_end_temperature);
    obstacle_temperature  = scale_temperature(rod.obstacle_temperature);
    initial_temperature   = scale_temperature(rod.initial_temperature);
    end_time              = rod.end_time / scales.time;
  }



  std::string
  scene_from_units(const std::string             &file_name,
                   const std::vector<Assignment> &assignments)
  {
    RodInUnits       rod;
    ParameterHandler prm;
    rod.add_parameters(prm);
    assign_entries(assignments, prm);
    check_complete(file_name, assignments, prm);
    if (rod.stiffness && !(*rod.stiffness > 0.))
      throw InputError(complete_message(
        "Obstacle/Stiffness = " + number(*rod.stiffness) +
          "\n  allowed: positive, or infinity\n  remedy:  a large Gap for no "
          "obstacle",
        assignments,
        prm));
    const UnitScales  scales(rod);
    const std::string scene = write_scene(rod, ScaledRod(rod));
    return write_scales(scales) + write_factors(rod, scales) + scene;
  }
} // namespace ThermoContact
