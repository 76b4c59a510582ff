// SPDX-License-Identifier: LGPL-2.1-or-later

// The entries of the files that --units reads.

#include <thermocontact/input/number_or_word.h>
#include <thermocontact/input/parameter_text.h>
#include <thermocontact/input/scales.h>
#include <thermocontact/input/units.h>
#include <thermocontact/input/words_of_kinds.h>

#include <deal.II/base/patterns.h>

namespace ThermoContact
{
  namespace
  {
    using dealii::ParameterHandler;
    using namespace dealii::Patterns;

    const Double positive(1e-30, 1e30);
    const Double not_negative(0., 1e30);
    const Double any_sign(-1e30, 1e30);
    const Double temperature(-273.15, 1e6);



    /** The entry with how long a load lasts. */
    void
    add_duration(ParameterHandler      &prm,
                 const std::string     &name,
                 const std::string     &text,
                 std::optional<double> &duration)
    {
      add_number_or_word(
        prm, name, "infinity", text, [&duration](const double *value) {
          duration = value ? std::optional<double>(*value) : std::nullopt;
        });
    }
  } // namespace



  void
  RodInUnits::add_parameters(ParameterHandler &prm)
  {
    prm.add_parameter("Title", title, "Title of the scene.");
    prm.add_parameter(
      "Small terms",
      small_terms,
      "Inertia b and viscosity zeta below 1e-6 are dropped, or "
      "kept; inertia stays if there is an initial velocity, a base that "
      "moves, a rear stop, or, up to 1e5 waves, an obstacle that moves.",
      Selection("dropped|kept"));

    add_rod(prm);
    add_temperatures(prm);
    add_obstacle(prm);
    add_sides(prm);
    add_loads(prm);

    prm.enter_subsection("Time");
    prm.add_parameter("Unit",
                      time_unit,
                      "Unit of the times in this file and in the results. "
                      "automatic: s here, there s, ms or us by the end time.",
                      Selection("automatic|" + names_of(time_units())));
    prm.add_parameter("End time", end_time, "End time.", not_negative);
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
    prm.add_parameter("Unit",
                      temperature_unit,
                      "Unit of the temperatures in this file and in the "
                      "results: K, or C for degrees Celsius. automatic: K, but "
                      "what looks like degrees Celsius is refused.",
                      Selection("automatic|" + names_of(temperature_units())));
    prm.add_parameter("Reference",
                      reference_temperature,
                      "Temperature of the rod without stress.",
                      temperature);
    prm.add_parameter("Initial",
                      initial_temperature,
                      "Temperature of the rod at t = 0.",
                      temperature);
    const auto add_varying = [&prm](const std::string &name,
                                    const std::string &text,
                                    double            &value,
                                    std::string       &in_time) {
      add_number_or_expression(
        prm,
        name,
        value,
        "t",
        text + "; an expression in t, which is in the unit of times.",
        [&](const double number, const std::string &expression) {
          value   = number;
          in_time = expression;
        },
        true);
    };
    add_varying("Fixed end",
                "Temperature of the fixed end",
                fixed_end_temperature,
                fixed_end_expression);
    add_varying("Obstacle",
                "Temperature of the obstacle",
                obstacle_temperature,
                obstacle_expression);
    prm.add_parameter("Surroundings",
                      surrounding_temperature,
                      "Temperature of the surroundings of the lateral sides.",
                      temperature);
    prm.leave_subsection();
  }



  void
  RodInUnits::add_obstacle(ParameterHandler &prm)
  {
    prm.enter_subsection("Obstacle");
    add_number_or_expression(
      prm,
      "Gap",
      gap,
      "t",
      "Gap between the rod without stress, at the reference temperature, and "
      "the obstacle, m; an expression in t, which is in the unit of times, "
      "moves the obstacle.",
      [this](const double number, const std::string &expression) {
        gap            = number;
        gap_expression = expression;
      },
      true);
    add_number_or_word(
      prm,
      "Rear gap",
      "none",
      "Gap to a second obstacle of the same stiffness behind the end, m; none: "
      "there is no such obstacle.",
      [this](const double *value) {
        rear_gap = value ? std::optional<double>(*value) : std::nullopt;
      });
    add_number_or_word(
      prm,
      "Stiffness",
      "infinity",
      "Stiffness of the obstacle, force over penetration, N/m, or over its "
      "power Exponent, N/m^m; infinity: rigid.",
      [this](const double *value) {
        stiffness = value ? std::optional<double>(*value) : std::nullopt;
      });
    prm.add_parameter("Exponent",
                      exponent,
                      "Exponent m: force = Stiffness * penetration^m; 1.5 is "
                      "Hertz's contact of a rounded end.",
                      Double(1., 10.));
    prm.add_parameter("Damping",
                      damping,
                      "Damping of the obstacle, s/m: its force is multiplied "
                      "by 1 + Damping times the velocity into it.",
                      not_negative);
    prm.add_parameter("Exchange coefficient",
                      exchange_coefficient,
                      "Heat exchange between the end and the obstacle, "
                      "W/(m^2 K).",
                      not_negative);
    prm.leave_subsection();
  }



  void
  RodInUnits::add_sides(ParameterHandler &prm)
  {
    prm.enter_subsection("Sides");
    prm.add_parameter("Exchange coefficient",
                      side_coefficient,
                      "Heat exchange between the lateral sides and their "
                      "surroundings, W/(m^2 K); 0: none.",
                      not_negative);
    prm.add_parameter("Perimeter",
                      perimeter,
                      "Perimeter of the cross-section, m.",
                      positive);
    prm.leave_subsection();
  }



  void
  RodInUnits::add_loads(ParameterHandler &prm)
  {
    prm.enter_subsection("Loads");
    prm.add_parameter("Base motion",
                      base_motion,
                      "Displacement of the fixed end, m, zero at t = 0: an "
                      "expression in t, which is in the unit of times.");
    prm.add_parameter("Initial velocity",
                      initial_velocity,
                      "Velocity of the contact end at t = 0, m/s, towards the "
                      "obstacle; in the rod it falls linearly to 0 at the "
                      "fixed end.",
                      any_sign);
    prm.add_parameter("Body force",
                      body_force.value,
                      "Force per volume along the rod, N/m^3, positive towards "
                      "the obstacle: rho times 9.81 for weight.",
                      any_sign);
    add_duration(prm,
                 "Body force duration",
                 "How long it acts, from t = 0 on.",
                 body_force.duration);
    prm.add_parameter("Heater power",
                      heater.value,
                      "Power that heats the rod, evenly over its volume, W.",
                      any_sign);
    add_duration(prm,
                 "Heater duration",
                 "How long it heats, from t = 0 on.",
                 heater.duration);
    prm.leave_subsection();
  }



  double
  RodInUnits::in_kelvin(const double temperature) const
  {
    return temperature_unit == "automatic" ?
             temperature :
             temperature +
               ThermoContact::temperature_unit(temperature_unit).zero_in_kelvin;
  }



  double
  RodInUnits::in_seconds(const double time) const
  {
    return time_unit == "automatic" ?
             time :
             time * ThermoContact::time_unit(time_unit).seconds;
  }
} // namespace ThermoContact
