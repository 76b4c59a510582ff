// SPDX-License-Identifier: LGPL-2.1-or-later

#include <thermocontact/forecast/coarse_rod.h>
#include <thermocontact/forecast/first_impact.h>
#include <thermocontact/method/bracketed_root.h>
#include <thermocontact/method/cubic_hermite.h>

#include <algorithm>
#include <cmath>

namespace ThermoContact
{
  namespace
  {
    /**
     * The next step, (M.46): a part of the time @p since a sudden change.
     *
     * @param horizon a few waves
     */
    double
    step_size(const double since, const double horizon)
    {
      return std::clamp(0.05 * since, 1e-6 * horizon, horizon / 400.);
    }



    /**
     * Moves the rod until its end arrives at the obstacle.
     *
     * @return false if it does not before @p horizon
     */
    bool
    arrive(CoarseRod        &rod,
           CoarseRod::State &state,
           const double      gap,
           const double      horizon,
           FirstImpact      &impact)
    {
      CoarseRod::State before = state;
      for (double time = 0., dt; time < horizon; time += dt)
        {
          dt     = step_size(time, horizon);
          before = state;
          rod.step(state, dt, false);
          if (!(state.displacement.back() >= gap))
            continue;
          const CubicHermite beyond(before.displacement.back() - gap,
                                    dt * before.velocity.back(),
                                    state.displacement.back() - gap,
                                    dt * state.velocity.back());
          const double       until =
            dt * bracketed_root([&](const double s) { return beyond.value(s); },
                                0.,
                                1.)
                   .second;
          impact.time = time + until;
          state       = before;
          if (until > 0.)
            rod.step(state, until, false);
          impact.velocity = state.velocity.back();
          return impact.time < horizon;
        }
      return false;
    }



    /** The largest pressure from the impact until the end is free again. */
    double
    largest_pressure(CoarseRod &rod, CoarseRod::State &state, const double span)
    {
      double largest = 0.;
      for (double time = 0., dt; time < span; time += dt)
        {
          dt                    = step_size(time, span);
          const double pressure = rod.step(state, dt, true);
          if (pressure == 0. && largest > 0.)
            break;
          largest = std::max(largest, pressure);
        }
      return largest;
    }
  } // namespace



  double
  rod_response(const Material &material, const double tau)
  {
    const double b = material.inertia, damped = tau + material.viscosity;
    return tau * std::sqrt(tau / (b * damped)) *
           std::tanh(std::sqrt(b / (tau * damped)));
  }



  std::optional<FirstImpact>
  first_impact(const Scene &scene)
  {
    const Material   &material = scene.material;
    const ContactLaw &law      = *scene.contact.law;
    const double      gap      = scene.contact.gap;
    if (!law.is_active() || law.damping() > 0. || scene.contact.rear_gap ||
        !material.has_inertia() || scene.parameters.dimension > 1 ||
        scene.sources.any())
      return {};
    // a wave has run four times through the rod, or the rod has crept
    const double waves =
      4. * (std::sqrt(material.inertia) + material.viscosity);
    const double horizon = std::min(scene.parameters.time.end_time, waves);
    if (!(horizon > 0.) || !std::isfinite(horizon))
      return {};
    CoarseRod        rod(scene);
    CoarseRod::State state = rod.initial_state();
    FirstImpact      impact;
    if (state.displacement.back() >= gap ||
        !arrive(rod, state, gap, horizon, impact) || !(impact.velocity > 0.))
      return {};
    if (!law.is_rigid())
      {
        const double rest =
          std::min(scene.parameters.time.end_time - impact.time, waves);
        impact.force       = largest_pressure(rod, state, rest);
        impact.penetration = law.penetration(impact.force);
        if (!(impact.force > 0.) || !std::isfinite(impact.penetration))
          return {};
      }
    return impact;
  }
} // namespace ThermoContact
