// SPDX-License-Identifier: LGPL-2.1-or-later

#include <thermocontact/base/exceptions.h>
#include <thermocontact/base/number_text.h>
#include <thermocontact/base/text.h>
#include <thermocontact/input/declared_entries.h>
#include <thermocontact/input/parameter_file.h>
#include <thermocontact/input/parameter_text.h>
#include <thermocontact/input/parameters.h>
#include <thermocontact/input/time_function.h>
#include <thermocontact/input/unit_scene.h>
#include <thermocontact/input/units.h>
#include <thermocontact/input/unknown_names.h>

#include <deal.II/base/numbers.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <sstream>

namespace ThermoContact
{
  namespace
  {
    /** Intervals of the run at whose ends temperatures are looked at. */
    constexpr unsigned int n_temperature_checks = 97;

    /** Colder than any rod but in a cryostat: rather degrees Celsius. */
    constexpr double lowest_plain_kelvin = 150.;

    /** Perimeter over that of a circle: a ribbon of 2800 times its thickness.
     */
    constexpr double largest_perimeter = 30.;



    /**
     * Refuses to take a value of the example for one that is not given.
     *
     * @param loses_heat through the lateral sides
     */
    void
    check_complete(const std::string             &file_name,
                   const std::vector<Assignment> &assignments,
                   const ParameterHandler        &prm,
                   const bool                     loses_heat)
    {
      const auto is_given = [&](const std::string &path) {
        return std::any_of(assignments.begin(),
                           assignments.end(),
                           [&](const Assignment &assignment) {
                             return assignment.path == path;
                           });
      };
      const bool has_sides =
        is_given("Sides/Perimeter") || is_given("Temperatures/Surroundings");
      const auto is_optional = [&](const std::string &path) {
        return path == "Title" || path == "Small terms" ||
               path == "Rod/Lateral sides" || path == "Temperatures/Unit" ||
               path == "Time/Unit" || path == "Obstacle/Rear gap" ||
               path == "Obstacle/Exponent" || path == "Obstacle/Damping" ||
               (!has_sides && path == "Sides/Exchange coefficient") ||
               path.rfind("Loads/", 0) == 0 ||
               (!loses_heat && (path == "Sides/Perimeter" ||
                                path == "Temperatures/Surroundings"));
      };
      for (const DeclaredEntry &entry : declared_entries(prm))
        if (!is_optional(entry.path) && !is_given(entry.path))
          throw InputError(
            quote(file_name) + ": " + entry.path +
            " is not given\n  allowed: " + describe_pattern(entry.pattern) +
            "\n  meaning: " + entry.text + " Steel: " + entry.default_value);
    }



    /**
     * True for an entry of a scene, known or not: none of @p of_rod, in a
     * section of a scene.
     */
    class BelongsToScene
    {
    public:
      explicit BelongsToScene(const ParameterHandler &of_rod)
      {
        Parameters       parameters;
        ParameterHandler of_scene;
        parameters.add_parameters(of_scene);
        for (const DeclaredEntry &entry : declared_entries(of_scene))
          {
            paths.insert(entry.path);
            sections.insert(section_of(entry.path));
          }
        sections.erase("");
        for (const DeclaredEntry &entry : declared_entries(of_rod))
          {
            of_the_rod.insert(entry.path);
            of_the_rod.insert(section_of(entry.path) + "/");
          }
      }

      bool
      operator()(const Assignment &assignment) const
      {
        return of_the_rod.count(assignment.path) == 0 &&
               (paths.count(assignment.path) > 0 ||
                sections.count(section_of(assignment.path)) > 0);
      }

    private:
      std::set<std::string> paths, sections, of_the_rod;
    };
  } // namespace



  bool
  RodInUnits::has_moving_base() const
  {
    const auto constant = parse_number(base_motion);
    return !constant || *constant != 0.;
  }



  void
  RodInUnits::check_temperature(const std::string &name,
                                const double       number,
                                const std::string &expression) const
  {
    const std::string path = "Temperatures/" + name;
    const auto        look = [&](const double value) {
      const std::string entry =
        text(path, " = ", expression.empty() ? text(value) : quote(expression));
      if (!std::isfinite(value))
        throw InputError(text(entry,
                              " is not finite\n  allowed: finite from t = 0 to "
                                     "Time/End time\n  remedy:  a value for each "
                                     "time"));
      if (!(in_kelvin(value) > 0.))
        throw InputError(entry +
                         "\n  allowed: above absolute zero\n  remedy:  "
                                "Temperatures/Unit = C if it is in degrees Celsius");
      if (temperature_unit == "automatic" && value < lowest_plain_kelvin)
        throw InputError(
          text(entry,
               ": ",
               value,
               " K is ",
               value - 273.15,
               " °C; which one is meant?\n  allowed: from ",
               lowest_plain_kelvin,
               " on, or any with Temperatures/Unit\n  remedy:  "
                      "Temperatures/Unit = C if all are in degrees Celsius, K if "
                      "they are in kelvin"));
    };
    if (expression.empty())
      look(number);
    else
      {
        const TimeFunction function({path, expression});
        for (unsigned int i = 0; i <= n_temperature_checks; ++i)
          look(function.value(end_time * i / n_temperature_checks));
      }
  }



  void
  RodInUnits::check_obstacle() const
  {
    if (stiffness && !(*stiffness > 0.))
      throw InputError(text("Obstacle/Stiffness = ",
                            significant(*stiffness, 12),
                            "\n  allowed: positive, or infinity\n  remedy:  a "
                            "large Gap for no obstacle"));
    if (rear_gap && !(*rear_gap > 0.))
      throw InputError(text("Obstacle/Rear gap = ",
                            significant(*rear_gap, 12),
                            "\n  allowed: positive, or none\n  remedy:  the "
                            "distance to the stop behind the end, metres"));
    if (stiffness)
      return;
    const std::string remedy =
      ", since Obstacle/Stiffness = infinity\n  remedy:  a stiffness, or a "
      "rigid obstacle without a law";
    if (exponent != 1.)
      throw InputError(
        text("Obstacle/Exponent = ", exponent, "\n  allowed: 1", remedy));
    if (damping != 0.)
      throw InputError(
        text("Obstacle/Damping = ", damping, "\n  allowed: 0", remedy));
  }



  void
  RodInUnits::check_sides() const
  {
    const double of_circle = 2. * std::sqrt(dealii::numbers::PI * area);
    if (side_coefficient > 0. && perimeter < 0.999 * of_circle)
      throw InputError(text("Sides/Perimeter = ",
                            perimeter,
                            "\n  allowed: at least ",
                            significant(of_circle, 4),
                            " m, that of a circle of Rod/Cross-section area\n"
                            "  remedy:  metres and square metres"));
    if (side_coefficient > 0. && perimeter > largest_perimeter * of_circle)
      throw InputError(
        text("Sides/Perimeter = ",
             perimeter,
             ": is that in metres?\n  allowed: at most ",
             significant(largest_perimeter * of_circle, 4),
             " m, ",
             largest_perimeter,
             " times that of a circle of Rod/Cross-section area\n  remedy:  "
             "metres and square metres; for a ribbon that is as thin, a larger "
             "Sides/Exchange coefficient: only the product matters"));
  }



  void
  RodInUnits::check_base_motion() const
  {
    if (!has_moving_base())
      return;
    const TimeFunction motion({"Loads/Base motion", base_motion});
    if (std::abs(motion.value(0.)) > 1e-12 * motion.largest_value(end_time))
      throw InputError(text("Loads/Base motion = ",
                            quote(base_motion),
                            "\n  allowed: zero at t = 0, where it is ",
                            motion.value(0.),
                            "\n  remedy:  subtract that: displacements are "
                            "relative to where the end is at the start"));
  }



  void
  RodInUnits::check() const
  {
    check_temperature("Reference", reference_temperature, "");
    check_temperature("Initial", initial_temperature, "");
    check_temperature("Fixed end", fixed_end_temperature, fixed_end_expression);
    check_temperature("Obstacle", obstacle_temperature, obstacle_expression);
    if (side_coefficient > 0.)
      check_temperature("Surroundings", surrounding_temperature, "");
    check_obstacle();
    check_sides();
    check_base_motion();
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
    , temperature(
        std::sqrt(rod.modulus() * rod.in_kelvin(rod.reference_temperature) /
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
    const auto       scale_temperature = [&](const double temperature) {
      return (temperature - rod.reference_temperature) / scales.temperature;
    };
    const auto scale_duration = [&](const LoadInUnits &load) {
      return load.duration ? rod.in_seconds(*load.duration) / scales.time :
                             std::numeric_limits<double>::infinity();
    };
    coupling  = rod.expansion() * scales.temperature;
    inertia   = rod.density * scales.velocity * scales.velocity / scales.stress;
    viscosity = rod.viscosity / (scales.stress * scales.time);
    heat_exchange    = rod.exchange_coefficient * rod.length / rod.conductivity;
    compliance       = rod.stiffness ?
                         std::pow(scales.force / *rod.stiffness, 1. / rod.exponent) /
                     scales.length :
                         0.;
    damping          = rod.damping * scales.velocity;
    lateral_exchange = rod.side_coefficient * rod.perimeter * rod.length *
                       rod.length / (rod.conductivity * rod.area);
    ambient_temperature   = scale_temperature(rod.surrounding_temperature);
    gap                   = rod.gap / scales.length;
    rear_gap              = rod.rear_gap.value_or(0.) / scales.length;
    fixed_end_temperature = scale_temperature(rod.fixed_end_temperature);
    obstacle_temperature  = scale_temperature(rod.obstacle_temperature);
    initial_temperature   = scale_temperature(rod.initial_temperature);
    initial_velocity      = rod.initial_velocity / scales.velocity;
    body_force            = rod.body_force.value * rod.length / scales.stress;
    heat_source = rod.heater.value / (rod.area * rod.length) * scales.time /
                  (rod.density * rod.heat_capacity * scales.temperature);
    end_time       = rod.in_seconds(rod.end_time) / scales.time;
    force_duration = scale_duration(rod.body_force);
    heat_duration  = scale_duration(rod.heater);
  }



  bool
  is_rod_in_units(const std::vector<Assignment> &assignments)
  {
    return std::any_of(assignments.begin(),
                       assignments.end(),
                       [](const Assignment &assignment) {
                         return assignment.path.rfind("Rod/", 0) == 0 &&
                                assignment.place != command_line_place;
                       });
  }



  UnitScene
  scene_from_units(const std::string             &file_name,
                   const std::vector<Assignment> &assignments)
  {
    RodInUnits       rod;
    ParameterHandler prm;
    rod.add_parameters(prm);
    const BelongsToScene    belongs_to_scene(prm);
    std::vector<Assignment> of_rod, of_scene;
    for (const Assignment &assignment : assignments)
      if (!belongs_to_scene(assignment))
        of_rod.push_back(assignment);
      else if (!assignment.is_section())
        of_scene.push_back(assignment);
    assign_entries(of_rod, prm);
    check_complete(file_name, of_rod, prm, rod.side_coefficient > 0.);
    try
      {
        rod.check();
        UnitScene scene;
        scene.text = write_scene(rod, of_scene);
        std::istringstream stream(scene.text);
        scene.assignments = read_assignments(stream, "scene of " + file_name);
        // what the user wrote is where the user wrote it
        for (Assignment &assignment : scene.assignments)
          for (const Assignment &own : of_scene)
            if (own.path == assignment.path)
              assignment.place = own.place;
        return scene;
      }
    catch (const InputError &error)
      {
        throw InputError(complete_message(error.what(), assignments, prm));
      }
  }
} // namespace ThermoContact
