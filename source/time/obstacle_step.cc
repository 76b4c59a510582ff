// SPDX-License-Identifier: LGPL-2.1-or-later

#include <thermocontact/time/obstacle_step.h>

#include <cmath>

namespace ThermoContact
{
  namespace
  {
    /** Parts of a gap by which a step may end beside it: a few digits. */
    constexpr double rounding_of_change = 1e-15;
  } // namespace



  template <int dim>
  ObstacleStep<dim>::ObstacleStep(const Body<dim> &body)
    : body(body)
  {}



  template <int dim>
  void
  ObstacleStep<dim>::start(const State      &state,
                           const double      begin,
                           const double      step_size,
                           const StageTimes &stages)
  {
    const unsigned int         n       = state.gap.size();
    const std::vector<double> &weights = stages.weights;
    size                               = step_size;
    old_gap                            = state.gap;
    velocities.resize(weights.size());
    accelerations.resize(weights.size());
    for (unsigned int i = 0; i < weights.size(); ++i)
      {
        body.obstacle.get_derivatives(stages.times[i], obstacle);
        velocities[i].resize(n);
        accelerations[i].resize(n);
        for (unsigned int node = 0; node < n; ++node)
          {
            velocities[i][node]    = obstacle[node].first;
            accelerations[i][node] = obstacle[node].second;
          }
      }
    if (weights.size() == 1)
      body.contact_end().get_values(Field::displacement,
                                    state.velocity,
                                    old_velocity);
    else
      {
        body.obstacle.get_derivatives(begin, old_obstacle);
        old_velocity.resize(n);
        for (unsigned int node = 0; node < n; ++node)
          old_velocity[node] = old_obstacle[node].first;
      }
    // rates with the mean that leads from the old value to the new one
    const auto shift = [&](std::vector<std::vector<double>> &rates,
                           const unsigned int                node,
                           const double                      change,
                           const double                      rounding) {
      double mean = 0.;
      for (unsigned int i = 0; i < weights.size(); ++i)
        mean += weights[i] * rates[i][node];
      if (std::abs(change - size * mean) > rounding)
        for (std::vector<double> &rate : rates)
          rate[node] += change / size - mean;
    };
    for (unsigned int node = 0; node < n; ++node)
      {
        // the last stage is the end of the step
        const double velocity = obstacle[node].first;
        const double gap      = obstacle[node].value;
        shift(velocities,
              node,
              gap - old_gap[node],
              rounding_of_change * (std::abs(gap) + std::abs(old_gap[node])));
        shift(accelerations,
              node,
              (weights.size() == 1 ? velocities[0][node] : velocity) -
                old_velocity[node],
              0.);
      }
  }



  template <int dim>
  void
  ObstacleStep<dim>::place(const ButcherTableau &tableau,
                           const unsigned int    i,
                           State                &known) const
  {
    known.gap      = old_gap;
    known.gap_rate = velocities[i];
    known.known_penetration.clear();
    for (unsigned int j = 0; j <= i; ++j)
      for (unsigned int node = 0; node < old_gap.size(); ++node)
        known.gap[node] += size * tableau.a[i][j] * velocities[j][node];
    if (i + 1 == velocities.size())
      for (unsigned int node = 0; node < old_gap.size(); ++node)
        known.gap[node] = obstacle[node].value;
  }



  template <int dim>
  void
  ObstacleStep<dim>::hold(const unsigned int i,
                          const double       tau,
                          State             &known) const
  {
    for (const auto &[node, entry] :
         body.contact_end().entries(Field::displacement))
      known.velocity.begin()[entry] =
        velocities[i][node] - tau * accelerations[i][node];
    known.known_penetration = velocities[i];
    for (double &penetration : known.known_penetration) // 0 at the end
      penetration *= -tau;
  }



  template class ObstacleStep<1>;
  template class ObstacleStep<2>;
  template class ObstacleStep<3>;
} // namespace ThermoContact
