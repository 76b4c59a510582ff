// SPDX-License-Identifier: LGPL-2.1-or-later

// What is refused of a rod in units.

#include <thermocontact/base/exceptions.h>
#include <thermocontact/base/number_text.h>
#include <thermocontact/base/text.h>
#include <thermocontact/input/parameter_text.h>
#include <thermocontact/input/time_function.h>
#include <thermocontact/input/units.h>

#include <deal.II/base/numbers.h>

#include <cmath>

namespace ThermoContact
{
  namespace
  {
    const ExpressionNames names_of_time{{"", "", "", "t"}, {}, "0.1*t"};



    /** Intervals of the run at whose ends expressions are looked at. */
    constexpr unsigned int n_checks = 97;

    /** Colder than any rod but in a cryostat: rather degrees Celsius. */
    constexpr double lowest_plain_kelvin = 150.;

    /** Perimeter over that of a circle: a ribbon of 2800 times its thickness.
     */
    constexpr double largest_perimeter = 30.;
  } // namespace



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
        const TimeFunction function(
          Expression(path, expression, names_of_time));
        for (unsigned int i = 0; i <= n_checks; ++i)
          look(function.value(end_time * i / n_checks));
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
  RodInUnits::check_gap() const
  {
    if (gap_expression.empty())
      return;
    const TimeFunction motion(
      Expression("Obstacle/Gap", gap_expression, names_of_time));
    for (unsigned int i = 0; i <= n_checks; ++i)
      if (!std::isfinite(motion.value(end_time * i / n_checks)))
        throw InputError(text("Obstacle/Gap = ",
                              quote(gap_expression),
                              " is not finite\n  allowed: finite from t = 0 to "
                              "Time/End time\n  remedy:  a value for each "
                              "time"));
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
    const TimeFunction motion(
      Expression("Loads/Base motion", base_motion, names_of_time));
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
    check_gap();
    check_sides();
    check_base_motion();
  }
} // namespace ThermoContact
