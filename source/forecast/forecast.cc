// SPDX-License-Identifier: LGPL-2.1-or-later

#include <thermocontact/base/multiples.h>
#include <thermocontact/forecast/first_impact.h>
#include <thermocontact/forecast/forecast.h>
#include <thermocontact/forecast/steady_state.h>

#include <algorithm>
#include <cmath>

namespace ThermoContact
{
  namespace
  {
    /**
     * Error-controlled steps of sdirk4, in units of tolerance^(-1/4): a fit to
     * 60 runs, doc/accuracy.md. Heat conduction, and the start and the contacts
     * of a rod, take a number of their own; each run of a wave through the rod
     * until viscosity has damped it takes another, more the less the viscosity
     * damps what is short.
     */
    double
    scaled_steps(const Parameters &parameters)
    {
      const ModelParameters &model = parameters.model;
      const double           T     = parameters.time.end_time;
      double                 sum   = 0.;
      if (model.has_temperature())
        sum += 3.4 * std::min(1., std::sqrt(T));
      if (model.has_displacement())
        sum += 2. * std::min(1., std::sqrt(T));
      if (model.has_displacement() && model.inertia > 0.)
        {
          const double wave = std::sqrt(model.inertia);
          const double n_runs =
            model.viscosity > 0. ?
              std::min(T, model.inertia / model.viscosity) / wave :
              T / wave;
          const double damped = 0.05 * wave / (model.viscosity + 3e-4 * wave);
          sum += (parameters.contact_law().is_active ? 1.2 : 0.6) * n_runs *
                 (1. + std::pow(damped, 0.4));
        }
      return sum;
    }



    /** Rows or snapshots at the first step end at or after each multiple. */
    double
    n_outputs(const double interval, const double T, const double n_steps)
    {
      return std::min(n_steps + 1., intervals_until(interval, T) + 1.);
    }
  } // namespace



  std::vector<std::pair<std::string, double>>
  time_scales(const Parameters &parameters)
  {
    std::vector<std::pair<std::string, double>> scales;
    const ModelParameters                      &model = parameters.model;
    const ContactLaw                            law  = parameters.contact_law();
    const double                                wave = std::sqrt(model.inertia);
    if (model.has_temperature())
      scales.emplace_back("heat", 1.);
    if (!model.has_displacement())
      return scales;
    if (model.inertia > 0.)
      scales.emplace_back("wave", wave);
    if (model.viscosity > 0.)
      scales.emplace_back("viscous", model.viscosity);
    if (law.is_active && law.compliance > 0. && model.inertia > 0.)
      scales.emplace_back("contact",
                          std::max(std::cbrt(
                                     std::pow(law.compliance * wave, 2) *
                                     model.viscosity),
                                   law.compliance * wave));
    return scales;
  }



  std::optional<double>
  critical_step_size(const Parameters &parameters)
  {
    const ContactLaw law = parameters.contact_law();
    if (!law.is_active || law.compliance == 0. || law.compliance >= 1. ||
        parameters.model.inertia == 0. || parameters.dimension > 1)
      return {};
    // chi grows from 0 to 1 with the length of the stage
    double lower = 1e-100, upper = 1e100;
    for (unsigned int i = 0; i < 500 && upper > lower * (1. + 1e-12); ++i)
      {
        const double middle = std::sqrt(lower) * std::sqrt(upper);
        (rod_response(parameters.model, middle) < law.compliance ? lower :
                                                                   upper) =
          middle;
      }
    return lower;
  }



  std::optional<ExpectedCost>
  expected_cost(const Parameters &parameters, const double n_cells)
  {
    const TimeParameters   &time   = parameters.time;
    const OutputParameters &output = parameters.output;
    const double            T      = time.end_time;
    ExpectedCost            cost;
    if (time.has_error_control())
      {
        if (has_sources(parameters))
          return {};
        cost.steps = std::ceil(
          std::max(scaled_steps(parameters) / std::pow(time.tolerance, 0.25),
                   T / time.maximum_step_size));
      }
    else
      {
        cost.steps = time.n_steps();
        cost.is_exact =
          !output.land_on_times && (!time.locates_contact_events() ||
                                    !parameters.contact_law().is_active);
      }
    if (output.land_on_times)
      for (const double interval : {output.contact_interval,
                                    output.fields_interval,
                                    output.space_time_interval})
        if (interval > 0.)
          cost.steps += T / interval;

    const bool has_heat = parameters.model.has_temperature();
    const bool moves    = parameters.model.has_displacement();
    cost.rows           = output.contact_interval > 0. ?
                            n_outputs(output.contact_interval, T, cost.steps) :
                            cost.steps + 1.;
    cost.row_bytes      = cost.rows * (has_heat && moves ? 290. :
                                       moves             ? 250. :
                                                           195.);
    if (output.fields_interval > 0.)
      {
        const unsigned int dim = parameters.dimension;
        const double       points =
          n_cells * std::pow(parameters.mesh.degree + 1., dim);
        cost.snapshots = n_outputs(output.fields_interval, T, cost.steps);
        cost.snapshot_bytes =
          cost.snapshots *
          (900. + 500. * (has_heat + moves) +
           points * (dim == 1 ? (moves ? 20. : 10.) : (moves ? 32. : 16.)));
      }
    return cost;
  }
} // namespace ThermoContact
