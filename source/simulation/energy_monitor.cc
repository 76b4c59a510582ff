// SPDX-License-Identifier: LGPL-2.1-or-later

#include <thermocontact/base/exceptions.h>
#include <thermocontact/base/text.h>
#include <thermocontact/base/tolerances.h>
#include <thermocontact/input/quantity_units.h>
#include <thermocontact/scene/scene_checks.h>
#include <thermocontact/simulation/energy_monitor.h>

#include <algorithm>

namespace ThermoContact
{
  namespace
  {
    /** Whether the scene may have a scheme, with steps and nodes that suit it.
     */
    bool
    can_have(const Scene &scene, const Scheme &scheme)
    {
      Parameters parameters  = scene.parameters;
      parameters.time.scheme = scheme.name;
      if (!parameters.time.step_size)
        parameters.time.step_size = parameters.time.end_time;
      if (scheme.needs_massless_contact)
        parameters.contact.massless_nodes = "automatic";
      try
        {
          check_scene(parameters);
        }
      catch (const InputError &)
        {
          return false;
        }
      return true;
    }



    /** The energy that a run may create, in parts of the largest one; what
     * residuals leave of responses to pressures is in no sum of a run. */
    double
    allowed_energy(const Scene &scene)
    {
      // the fronts of a row are sharp where all rods have the same passage, and
      // the same coefficients in all cells, and waves do not heat them; others
      // ring, and what the end meets of them may give energy
      const bool can_create =
        scene.scheme.can_create_energy ||
        (scene.scheme.has_no_dispersion &&
         (has_dispersion(scene) || stiffness_by_heat(scene) > 0. ||
          scene.row.has_varying_rods()));
      return (can_create && !scene.parameters.time.has_error_control() ?
                Tolerances::energy_of_fixed_steps :
                Tolerances::energy_of_rounding) +
             (scene.linear_solver.is_iterative ? scene.linear_solver.tolerance :
                                                 0.);
    }



    std::string
    remedy_for(const Scene &scene)
    {
      if (scene.scheme.has_no_dispersion)
        return "more Mesh/Cells";
      std::string remedy = scene.parameters.time.has_error_control() ?
                             "a smaller Time/Tolerance" :
                             "a smaller Time/Step size";
      if (!scene.contact.law->is_active())
        return remedy;
      if (scene.contact.has_mass())
        remedy += ", Contact/Massless nodes = on";
      const Scheme *const conserving = find_scheme(
        [](const Scheme &s) { return !s.can_create_energy && s.order > 1; });
      if (conserving != nullptr && &scene.scheme != conserving &&
          can_have(scene, *conserving))
        remedy +=
          ", or Time/Scheme = " + conserving->name + " with fixed steps";
      return remedy;
    }
  } // namespace



  EnergyMonitor::EnergyMonitor(const Scene &scene)
    : scene(scene)
    , is_active(!scene.has_work())
    , gives_back(scene.scheme.has_no_dispersion && scene.contact.has_rigid())
    , allowed_per_run(allowed_energy(scene))
    , allowed_per_step(scene.parameters.time.has_error_control() ?
                         2. * scene.parameters.time.tolerance :
                         0.)
    , smallest(0.)
    , scale(0.)
    , brought_in(0.)
    , n_steps(0)
    , has_warned(false)
  {}



  void
  EnergyMonitor::start(const EnergyTerms &terms)
  {
    smallest   = terms.sum();
    scale      = terms.magnitude();
    brought_in = 0.;
    n_steps    = 0;
  }



  std::string
  EnergyMonitor::add(const unsigned int step,
                     const double       time,
                     const EnergyTerms &terms,
                     const double       algebraic)
  {
    scale = std::max(scale, terms.magnitude());
    smallest += algebraic;
    brought_in += algebraic;
    const double created = terms.sum() - smallest;
    ++n_steps;
    if (created <= 0. && !gives_back)
      {
        smallest = terms.sum();
        n_steps  = 0;
      }
    const double allowed =
      (allowed_per_run + n_steps * allowed_per_step) * scale;
    const double by_residuals = Tolerances::energy_of_fixed_steps * scale;
    if (!is_active || has_warned ||
        (created <= allowed && brought_in <= by_residuals))
      return "";
    has_warned = true;
    const QuantityUnits units(scene.parameters);
    const std::string   place =
      text("step ", step, ", t = ", units.text("time", time));
    if (created <= allowed)
      return text(place,
                  ": residuals of linear systems have brought in the energy ",
                  units.text("energy", brought_in),
                  "; remedy: a smaller Solver/Linear tolerance");
    return text(place,
                ": the scheme has created the energy ",
                units.text("energy", created),
                ", more than its accuracy explains (",
                units.text("energy", allowed),
                "); remedy: ",
                remedy_for(scene));
  }
} // namespace ThermoContact
