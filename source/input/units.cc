// SPDX-License-Identifier: LGPL-2.1-or-later

#include <thermocontact/base/exceptions.h>
#include <thermocontact/base/number_text.h>
#include <thermocontact/base/text.h>
#include <thermocontact/input/declared_entries.h>
#include <thermocontact/input/expression.h>
#include <thermocontact/input/parameter_file.h>
#include <thermocontact/input/parameter_text.h>
#include <thermocontact/input/parameters.h>
#include <thermocontact/input/unit_scene.h>
#include <thermocontact/input/units.h>
#include <thermocontact/input/unknown_names.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <sstream>

namespace ThermoContact
{
  namespace
  {
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



  bool
  RodInUnits::has_moving_obstacle() const
  {
    if (gap_expression.empty())
      return false;
    return Expression("Obstacle/Gap",
                      gap_expression,
                      {{"", "", "", "t"}, {}, "0.1*t"})
      .depends_on("t");
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
