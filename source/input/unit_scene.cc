// SPDX-License-Identifier: LGPL-2.1-or-later

#include <thermocontact/base/exceptions.h>
#include <thermocontact/base/text.h>
#include <thermocontact/input/scales.h>
#include <thermocontact/input/scene_text.h>
#include <thermocontact/input/unit_scene.h>
#include <thermocontact/input/unit_tables.h>

#include <algorithm>
#include <cmath>
#include <regex>
#include <utility>

namespace ThermoContact
{
  namespace
  {
    // Below this, inertia and viscosity are ringing of relative size b^(1/4)
    // after sudden changes, in steps far below those of heat.
    constexpr double small_term = 1e-6;

    // A wave passes a cell in a step: the peak force of an impact is off by
    // less than 0.1 per cent.
    constexpr unsigned int cells_of_impact = 2000;

    // Times of a wave along the rod after which an impact is not followed wave
    // by wave.
    constexpr double waves_of_impact = 100.;

    // Times of a wave after which what an obstacle that moves excites is not
    // followed: slow motions of hot rods, where a run would never end.
    constexpr double waves_of_motion = 1e5;



    std::string
    number(const double value)
    {
      return significant(value, 12);
    }



    /** Which terms the scene has. */
    struct Terms
    {
      bool inertia, viscosity;

      Terms(const RodInUnits &rod, const ScaledRod &scaled)
      {
        const bool drops = rod.small_terms == "dropped";
        const bool follows_obstacle =
          rod.has_moving_obstacle() &&
          scaled.end_time <= waves_of_motion * std::sqrt(scaled.inertia);
        inertia = !(drops && scaled.inertia < small_term) ||
                  rod.initial_velocity != 0. || rod.has_moving_base() ||
                  follows_obstacle || rod.rear_gap.has_value();
        viscosity = !(drops && scaled.viscosity < small_term);
      }
    };



    void
    add_model(const ScaledRod &scaled, const Terms &terms, SceneText &scene)
    {
      const auto add = [&](const std::string &path,
                           const std::string &symbol,
                           const double       value,
                           const bool         is_kept) {
        scene.set(path,
                  is_kept ? number(value) : "0",
                  symbol + (is_kept ? "" :
                                      " = " + number(value) +
                                        ", dropped; kept by Small terms = "
                                        "kept"));
      };
      add("Model/Inertia", "b", scaled.inertia, terms.inertia);
      add("Model/Viscosity", "zeta", scaled.viscosity, terms.viscosity);
      scene.set("Model/Coupling", number(scaled.coupling), "a");
    }



    /** An expression of the file in the time of the scene. */
    std::string
    in_scene_time(const RodInUnits &rod, const std::string &expression)
    {
      static const std::regex time("\\bt\\b");
      const double factor = UnitScales(rod).time / rod.in_seconds(1.);
      return std::regex_replace(expression, time, "(" + number(factor) + "*t)");
    }



    std::string
    time_unit_of_file(const RodInUnits &rod)
    {
      return rod.time_unit == "automatic" ? "s" : rod.time_unit;
    }



    /** A length that varies, with what the file says. */
    void
    add_length(const std::string &path,
               const std::string &symbol,
               const RodInUnits  &rod,
               const std::string &expression,
               SceneText         &scene)
    {
      scene.set(path,
                "(" + in_scene_time(rod, expression) + ")/" +
                  number(rod.length),
                symbol + "; " + expression + " m, t in " +
                  time_unit_of_file(rod));
    }



    /** One of the surroundings of the rod, with what the file says. */
    void
    add_temperature(const RodInUnits  &rod,
                    const std::string &path,
                    const std::string &symbol,
                    const double       scaled_value,
                    const double       value,
                    const std::string &expression,
                    SceneText         &scene)
    {
      const std::string unit =
        temperature_unit(
          rod.temperature_unit == "automatic" ? "K" : rod.temperature_unit)
          .symbol;
      if (expression.empty())
        scene.set(path,
                  number(scaled_value),
                  symbol + "; " + number(value) + ' ' + unit);
      else
        scene.set(path,
                  "((" + in_scene_time(rod, expression) + ") - (" +
                    number(rod.reference_temperature) + "))/" +
                    number(UnitScales(rod).temperature),
                  symbol + "; " + expression + ' ' + unit + ", t in " +
                    time_unit_of_file(rod));
    }



    void
    add_surroundings(const RodInUnits &rod,
                     const ScaledRod  &scaled,
                     SceneText        &scene)
    {
      add_temperature(rod,
                      "Boundary/Fixed end temperature",
                      "theta_A",
                      scaled.fixed_end_temperature,
                      rod.fixed_end_temperature,
                      rod.fixed_end_expression,
                      scene);
      if (rod.has_moving_base())
        add_length("Boundary/Fixed end displacement",
                   "u_A",
                   rod,
                   rod.base_motion,
                   scene);
      scene.set("Boundary/Heat exchange", number(scaled.heat_exchange), "k");
      if (scaled.heat_exchange > 0.)
        add_temperature(rod,
                        "Boundary/Obstacle temperature",
                        "theta_obs",
                        scaled.obstacle_temperature,
                        rod.obstacle_temperature,
                        rod.obstacle_expression,
                        scene);
      if (scaled.lateral_exchange > 0.)
        {
          scene.set("Boundary/Lateral heat exchange",
                    number(scaled.lateral_exchange),
                    "m");
          add_temperature(rod,
                          "Boundary/Ambient temperature",
                          "theta_inf",
                          scaled.ambient_temperature,
                          rod.surrounding_temperature,
                          "",
                          scene);
        }
    }



    void
    add_obstacle(const RodInUnits &rod,
                 const ScaledRod  &scaled,
                 SceneText        &scene)
    {
      const bool is_power_law = rod.exponent != 1.;
      if (!rod.stiffness)
        scene.set("Contact/Condition", "rigid");
      else if (is_power_law)
        scene.set("Contact/Condition", "power law");
      if (rod.stiffness)
        scene.set("Contact/Compliance",
                  number(scaled.compliance),
                  "epsilon; " + number(*rod.stiffness) + " N/m" +
                    (is_power_law ? "^" + number(rod.exponent) : ""));
      if (is_power_law)
        scene.set("Contact/Exponent", number(rod.exponent), "m");
      if (rod.damping != 0.)
        scene.set("Contact/Damping",
                  number(scaled.damping),
                  "c; " + number(rod.damping) + " s/m");
      if (rod.gap_expression.empty())
        scene.set("Contact/Gap",
                  number(scaled.gap),
                  "g; " + number(rod.gap) + " m");
      else
        add_length("Contact/Gap", "g", rod, rod.gap_expression, scene);
      if (rod.rear_gap)
        scene.set("Contact/Rear gap",
                  number(scaled.rear_gap),
                  "g_2; " + number(*rod.rear_gap) + " m");
      add_temperature(rod,
                      "Initial values/Temperature",
                      "theta_0",
                      scaled.initial_temperature,
                      rod.initial_temperature,
                      "",
                      scene);
    }



    /** A load from t = 0 on; its end is a break of the steps. */
    void
    add_load(const std::string        &path,
             const double              value,
             const double              duration,
             const std::string        &comment,
             const double              end_time,
             std::vector<std::string> &breaks,
             SceneText                &scene)
    {
      if (value == 0.)
        return;
      const bool ends = duration < end_time;
      scene.set(
        path,
        ends ? text("if(t < ", number(duration), ", ", number(value), ", 0)") :
               number(value),
        comment);
      if (ends && std::find(breaks.begin(), breaks.end(), number(duration)) ==
                    breaks.end())
        breaks.push_back(number(duration));
    }



    void
    add_motion(const RodInUnits &rod,
               const ScaledRod  &scaled,
               const Terms      &terms,
               SceneText        &scene)
    {
      if (terms.inertia || terms.viscosity)
        scene.set("Initial values/Displacement", "0");
      if (terms.inertia && scaled.initial_velocity == 0.)
        scene.set("Initial values/Velocity", "0");
      else if (terms.inertia)
        scene.set("Initial values/Velocity",
                  number(scaled.initial_velocity) + "*x",
                  "u_1; " + number(rod.initial_velocity) + " m/s at x = 1");
    }



    void
    add_times(const RodInUnits &rod,
              const ScaledRod  &scaled,
              const Terms      &terms,
              SceneText        &scene)
    {
      std::vector<std::string> breaks;
      add_load("Sources/Heat source",
               scaled.heat_source,
               scaled.heat_duration,
               "q; " + number(rod.heater.value) + " W",
               scaled.end_time,
               breaks,
               scene);
      add_load("Sources/Body force",
               scaled.body_force,
               scaled.force_duration,
               "f; " + number(rod.body_force.value) + " N/m^3",
               scaled.end_time,
               breaks,
               scene);
      scene.set("Time/End time",
                number(scaled.end_time),
                "T; " + number(rod.end_time) + ' ' + time_unit_of_file(rod));
      if (!breaks.empty())
        scene.suggest("Time/Break points",
                      breaks[0] + (breaks.size() > 1 ? " ; " + breaks[1] : ""));
      const double wave = std::sqrt(scaled.inertia);
      if (scaled.initial_velocity == 0. || terms.viscosity ||
          rod.has_moving_base() || rod.has_moving_obstacle() || rod.rear_gap ||
          rod.exponent != 1. || rod.damping != 0. || scaled.heat_source != 0. ||
          scaled.body_force != 0. || scaled.end_time > waves_of_impact * wave ||
          scene.has_own("Time") || scene.has_own("Mesh"))
        return;
      // an elastic impact, wave by wave
      scene.set("Time/Scheme", "energy conserving");
      scene.set("Time/Step size", number(wave / cells_of_impact));
      scene.set("Mesh/Cells", text(cells_of_impact));
      scene.set("Mesh/Degree", "1");
      scene.set("Mesh/Mass matrix", "midpoint");
    }



    void
    add_scales(const RodInUnits &rod,
               const UnitScales &scales,
               SceneText        &scene)
    {
      scene.set("Scales/Length", number(scales.length), "m");
      scene.set("Scales/Time", number(scales.time), "s");
      scene.set("Scales/Stress", number(scales.stress), "Pa");
      scene.set("Scales/Area", number(rod.area), "m^2");
      scene.set("Scales/Temperature", number(scales.temperature), "K");
      scene.set("Scales/Reference temperature",
                number(rod.in_kelvin(rod.reference_temperature)),
                "K");
      scene.set("Scales/Time unit",
                rod.time_unit == "automatic" ?
                  readable_time_unit(rod.end_time).name :
                  rod.time_unit);
      scene.set("Scales/Temperature unit",
                rod.temperature_unit == "automatic" ? "K" :
                                                      rod.temperature_unit);
    }
  } // namespace



  std::string
  write_scene(const RodInUnits &rod, const std::vector<Assignment> &own)
  {
    const UnitScales scales(rod);
    const ScaledRod  scaled(rod);
    const Terms      terms(rod, scaled);
    SceneText        scene(own);
    if (!rod.title.empty())
      scene.set("Title", rod.title);
    add_model(scaled, terms, scene);
    add_surroundings(rod, scaled, scene);
    add_obstacle(rod, scaled, scene);
    add_motion(rod, scaled, terms, scene);
    add_times(rod, scaled, terms, scene);
    scene.suggest("Output/Fields interval",
                  significant(scaled.end_time / 20., 6));
    add_scales(rod, scales, scene);
    return write_scales(scales) + write_factors(rod, scales) + scene.str();
  }
} // namespace ThermoContact
