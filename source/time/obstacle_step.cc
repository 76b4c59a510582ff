// SPDX-License-Identifier: LGPL-2.1-or-later

#include <thermocontact/time/obstacle_step.h>

namespace ThermoContact
{
  template <int dim>
  ObstacleStep<dim>::ObstacleStep(const Body<dim> &body)
    : body(body)
  {}



  template <int dim>
  void
  ObstacleStep<dim>::start(const State      &state,
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
    body.contact_end().get_values(Field::displacement,
                                  state.velocity,
                                  body_velocity);
    // rates with the mean that leads from the old value to the new one
    const auto shift = [&](std::vector<std::vector<double>> &rates,
                           const unsigned int                node,
                           const double                      change) {
      double mean = 0.;
      for (unsigned int i = 0; i < weights.size(); ++i)
        mean += weights[i] * rates[i][node];
      for (std::vector<double> &rate : rates)
        rate[node] += change / size - mean;
    };
    for (unsigned int node = 0; node < n; ++node)
      {
        // the last stage is the end of the step
        shift(velocities, node, obstacle[node].value - old_gap[node]);
        shift(accelerations,
              node,
              velocities.back()[node] - body_velocity[node]);
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
  }



  template class ObstacleStep<1>;
  template class ObstacleStep<2>;
  template class ObstacleStep<3>;
} // namespace ThermoContact
