// SPDX-License-Identifier: LGPL-2.1-or-later

#include <thermocontact/base/exceptions.h>
#include <thermocontact/base/tolerances.h>
#include <thermocontact/forecast/forecast.h>
#include <thermocontact/simulation/simulation.h>

#include <algorithm>
#include <cmath>

namespace ThermoContact
{
  namespace
  {
    constexpr unsigned int n_cells   = 16;
    constexpr double       tolerance = Tolerances::forecast_run;



    /** The last cell over the first: short contacts compress a short part. */
    double
    size_of_last_cell(const ContactLaw &law)
    {
      return std::clamp(law.compliance().value_or(0.1),
                        Tolerances::steepest_grading,
                        0.1);
    }



    /** The scene, (M8.3), in error-controlled steps to @p end_time. */
    Parameters
    coarse_scene(const Scene &scene, const double end_time)
    {
      Parameters parameters     = scene.parameters;
      parameters.mesh           = MeshParameters();
      parameters.mesh.cells     = n_cells;
      parameters.mesh.grading   = 1. / size_of_last_cell(*scene.contact.law);
      parameters.time           = TimeParameters();
      parameters.time.scheme    = default_scheme().name;
      parameters.time.end_time  = end_time;
      parameters.time.tolerance = tolerance;
      parameters.solver         = SolverParameters();
      parameters.output         = OutputParameters();
      return parameters;
    }
  } // namespace



  std::optional<FirstImpact>
  first_impact(const Scene &scene)
  {
    const Material   &material = scene.material;
    const ContactLaw &law      = *scene.contact.law;
    if (!law.is_active() || law.is_damped() || scene.contact.is_two_sided() ||
        scene.row.is_given() || !material.has_inertia() ||
        scene.parameters.dimension > 1 || scene.sources.any())
      return {};
    // a wave has run four times through the rod, or the rod has crept
    const double waves =
      4. * (std::sqrt(material.inertia) + material.viscosity);
    const double end_time =
      std::min(scene.parameters.time.end_time, 2. * waves);
    if (!(end_time > 0.) || !std::isfinite(end_time))
      return {};
    try
      {
        Simulation<1> rod(coarse_scene(scene, end_time), MPI_COMM_SELF);
        const auto   &events = rod.events();
        if (!events.empty()) // in contact from the start
          return {};
        while (events.empty() && rod.record().time < waves && rod.step())
          ;
        if (events.empty() || events[0].time >= waves ||
            !(events[0].velocity > 0.))
          return {};
        FirstImpact impact{events[0].time, events[0].velocity};
        if (law.is_rigid())
          return impact;
        while (events.size() == 1 && rod.record().time < impact.time + waves &&
               rod.step())
          ;
        if (const double peak = rod.history().peak_penetration(); peak > 0.)
          {
            impact.penetration = peak;
            impact.force       = rod.history().peak_force();
          }
        return impact;
      }
    catch (const ComputationError &)
      {
        return {}; // the run will say why
      }
  }
} // namespace ThermoContact
