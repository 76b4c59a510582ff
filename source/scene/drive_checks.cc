// SPDX-License-Identifier: LGPL-2.1-or-later

#include <thermocontact/base/exceptions.h>
#include <thermocontact/base/text.h>
#include <thermocontact/base/tolerances.h>
#include <thermocontact/input/parameter_text.h>
#include <thermocontact/scene/drive_checks.h>

#include <cmath>

namespace ThermoContact
{
  namespace
  {
    [[noreturn]] void
    refuse_motion(const TimeFunction &motion,
                  const std::string  &allowed,
                  const std::string  &remedy)
    {
      throw InputError(
        "Boundary/Fixed end displacement = " + quote(motion.text()) +
        "\n  allowed: " + allowed + "\n  remedy:  " + remedy);
    }
  } // namespace



  namespace
  {
    [[noreturn]] void
    refuse_gap(const Scene       &scene,
               const std::string &allowed,
               const std::string &remedy)
    {
      throw InputError(
        "Contact/Gap = " + quote(scene.parameters.contact.gap_expression) +
        "\n  allowed: " + allowed + "\n  remedy:  " + remedy);
    }



    void
    check_moving_obstacle(const Scene &scene)
    {
      const double       half = 0.5 * scene.parameters.mesh.width;
      const TimeFunction in_the_middle(*scene.gap_expression,
                                       dealii::Point<3>(1., half, half));
      if (in_the_middle.starts_with_unbounded_rate(
            scene.parameters.time.end_time))
        refuse_gap(scene,
                   "a velocity that stays finite at t = 0",
                   "a motion that begins like t or t^2");
      if (scene.parameters.time.start == "paper")
        refuse_gap(scene,
                   "an expression without t, since Time/Start = paper",
                   "Time/Start = automatic: the paper prescribes the first "
                   "step before an obstacle that rests");
      if (scene.contact.is_two_sided())
        refuse_gap(scene,
                   "an expression without t, since Contact/Rear gap is not "
                   "none",
                   "Boundary/Fixed end displacement: the base moves between "
                   "stops that rest");
    }
  } // namespace



  void
  check_drives(const Scene &scene)
  {
    if (scene.sources.has_moving_obstacle)
      check_moving_obstacle(scene);
    const TimeParameters &time = scene.parameters.time;
    if (!scene.sources.has_moving_end)
      return;
    const TimeFunction &motion = *scene.fixed_end_motion;
    const double        start  = motion.value(0.);
    if (std::abs(start) >
        Tolerances::rounding_of_data * motion.largest_value(time.end_time))
      refuse_motion(motion,
                    text("zero at t = 0, where it is ", start),
                    "subtract that: displacements are relative to where the "
                    "end is at the start");
    if (motion.starts_with_unbounded_rate(time.end_time))
      refuse_motion(motion,
                    "a velocity that stays finite at t = 0",
                    "a motion that begins like t or t^2");
    if (!scene.scheme.needs_resting_end.empty())
      refuse_motion(motion,
                    "0, since Time/Scheme = " + scene.scheme.name,
                    "Time/Scheme = " + default_scheme().name + ": " +
                      scene.scheme.needs_resting_end);
    if (time.start == "paper")
      refuse_motion(motion,
                    "0, since Time/Start = paper",
                    "Time/Start = automatic: the paper prescribes the first "
                    "step of a body whose end rests");
  }
} // namespace ThermoContact
