// SPDX-License-Identifier: LGPL-2.1-or-later

#include <thermocontact/scene/refusal.h>
#include <thermocontact/scene/time_checks.h>

namespace ThermoContact
{
  void
  check_start(const Scene &scene)
  {
    const Parameters     &parameters = scene.parameters;
    const TimeParameters &time       = parameters.time;
    const bool            is_paper   = time.start == "paper";
    if (is_paper && !scene.scheme.is_of_paper)
      refuse("Time/Start",
             time.start,
             "consistent or automatic, since Time/Scheme = " + time.scheme,
             "the prescribed first step of the paper is of order 1");
    if (is_paper && !scene.material.has_inertia())
      refuse("Time/Start",
             time.start,
             "consistent or automatic, since Model/Inertia = 0",
             "Time/Start = automatic: a body without inertia has no velocity "
             "to start with");
    if (is_paper && !scene.heat.exchange->is_constant())
      refuse("Time/Start",
             time.start,
             "consistent or automatic, since Boundary/Heat exchange is an "
             "expression",
             "Time/Start = automatic: the heat equation alone does not know "
             "the pressure");
    if (is_paper && parameters.contact.massless_nodes == "on")
      refuse("Time/Start",
             time.start,
             "consistent or automatic, since Contact/Massless nodes = on",
             "Contact/Massless nodes = automatic, which leaves the paper's "
             "start its mass");
  }



  namespace
  {
    void
    check_error_control(const Scene &scene)
    {
      const TimeParameters &time = scene.parameters.time;
      if (!scene.scheme.has_error_estimate)
        refuse("Time/Step size",
               "automatic",
               "a number, since Time/Scheme = " + time.scheme +
                 " has no error estimate",
               "Time/Step size = 0.001, or Time/Scheme = " +
                 default_scheme().name);
      if (time.first_step_size && !(*time.first_step_size > 0.))
        refuse("Time/First step size",
               *time.first_step_size,
               "dt > 0",
               "Time/First step size = automatic");
      if (time.first_step_size &&
          *time.first_step_size < time.minimum_step_size)
        refuse("Time/First step size",
               *time.first_step_size,
               "not below Time/Minimum step size",
               "Time/First step size = automatic");
      if (!(time.maximum_step_size > 0.) ||
          time.maximum_step_size < time.minimum_step_size)
        refuse("Time/Maximum step size",
               time.maximum_step_size,
               "positive and not below Time/Minimum step size",
               "Time/Maximum step size = infinity");
    }



    void
    check_fixed_steps(const TimeParameters &time)
    {
      if (!(*time.step_size > 0.))
        refuse("Time/Step size",
               *time.step_size,
               "dt > 0, or automatic",
               "the paper uses 0.001");
      if (time.end_time / *time.step_size > 1e9)
        refuse("Time/Step size",
               *time.step_size,
               "at most 1e9 steps up to Time/End time",
               "enlarge the step or shorten the run");
    }
  } // namespace



  void
  check_step_sizes(const Scene &scene)
  {
    if (scene.parameters.time.has_error_control())
      check_error_control(scene);
    else
      check_fixed_steps(scene.parameters.time);
  }
} // namespace ThermoContact
