// SPDX-License-Identifier: LGPL-2.1-or-later

#include <thermocontact/base/exceptions.h>
#include <thermocontact/forecast/forecast.h>
#include <thermocontact/simulation/simulation.h>

#include <cmath>

namespace ThermoContact
{
  std::optional<double>
  steps_of_free_waves(const Scene &scene)
  {
    // of the time of the run, which the forecast takes no more of
    constexpr double smallest_number_of_runs = 10.;
    const Material  &material                = scene.material;
    const double     wave                    = std::sqrt(material.inertia);
    const double     end_time                = scene.parameters.time.end_time;
    if (scene.contact.law->is_active() || scene.fields.has_temperature ||
        scene.parameters.dimension > 1 || !material.has_inertia() ||
        material.has_viscosity() || scene.sources.any() ||
        !(end_time >= smallest_number_of_runs * wave))
      return {};
    Parameters parameters    = scene.parameters;
    parameters.time.end_time = 2. * wave;
    parameters.output        = OutputParameters();
    try
      {
        Simulation<1> rod(parameters, MPI_COMM_SELF);
        double        n_first = 0.;
        while (rod.step())
          if (rod.record().time <= wave)
            ++n_first;
        const double n_second = rod.record().step - n_first;
        return n_first + n_second * (end_time / wave - 1.);
      }
    catch (const ComputationError &)
      {
        return {}; // the run will say why
      }
  }
} // namespace ThermoContact
