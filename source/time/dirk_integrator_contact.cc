// SPDX-License-Identifier: LGPL-2.1-or-later

#include <thermocontact/space/node_laws.h>
#include <thermocontact/time/dirk_integrator.h>

#include <algorithm>

namespace ThermoContact
{
  template <int dim>
  void
  DirkIntegrator<dim>::start_drives(const State    &state,
                                    const TimeStep &time_step)
  {
    const bool obstacle_moves = body.obstacle.is_active();
    if (!driven && !obstacle_moves)
      return;
    StageTimes loads_at{tableau.a, tableau.b(), {}};
    for (unsigned int i = 0; i < tableau.n_stages(); ++i)
      loads_at.times.push_back(load_time(state, time_step, i));
    if (driven)
      driven->start(state, time_step.size, loads_at);
    if (obstacle_moves)
      start_obstacle(state, time_step, loads_at);
  }



  template <int dim>
  void
  DirkIntegrator<dim>::start_obstacle(const State      &state,
                                      const TimeStep   &time_step,
                                      const StageTimes &loads_at)
  {
    const auto derivatives_at = [&](const double time) {
      std::vector<TimeDerivatives> obstacle;
      body.obstacle.get_derivatives(time, obstacle);
      return obstacle;
    };
    const auto rates_of = [](const std::vector<TimeDerivatives> &functions) {
      std::vector<double> rates;
      for (const TimeDerivatives &function : functions)
        rates.push_back(function.first);
      return rates;
    };
    std::vector<std::vector<TimeDerivatives>> functions;
    for (const double time : loads_at.times)
      functions.push_back(derivatives_at(time));
    gaps.start(loads_at, time_step.size, state.gap, functions);
    if (tableau.n_stages() > 1)
      {
        gaps.set_accelerations(rates_of(derivatives_at(time_step.first_loads)),
                               rates_of(functions.back()));
        return;
      }
    std::vector<double> velocity;
    body.contact_end().get_values(Field::displacement,
                                  state.velocity,
                                  velocity);
    gaps.set_accelerations(velocity, gaps.stages().back().rates);
  }



  template <int dim>
  void
  DirkIntegrator<dim>::place_obstacle(const unsigned int i,
                                      const double       tau,
                                      const ContactMode  mode)
  {
    const PrescribedStage &obstacle = gaps.stages()[i];
    known.gap                       = obstacle.values;
    known.gap_rate                  = obstacle.rates;
    known.known_penetration.clear();
    if (mode != ContactMode::closed || !body.scene.contact.has_impacts())
      return;
    for (const auto &[node, entry] :
         body.contact_end().entries(Field::displacement))
      known.velocity.begin()[entry] =
        obstacle.rates[node] - tau * obstacle.accelerations[node];
    known.known_penetration = obstacle.rates;
    for (double &penetration : known.known_penetration) // 0 at the end
      penetration *= -tau;
  }



  template <int dim>
  bool
  DirkIntegrator<dim>::can_change_at_once(const ContactMode mode) const
  {
    const SceneContact &contact = body.scene.contact;
    return contact.law->is_active() && !contact.has_mass() &&
           (mode == ContactMode::unilateral || contact.is_in_equilibrium());
  }



  template <int dim>
  bool
  DirkIntegrator<dim>::holds_closing_nodes(const ContactMode mode) const
  {
    return solver->can_hold_nodes() && mode == ContactMode::unilateral &&
           can_change_at_once(mode) &&
           !body.scene.contact.is_in_equilibrium() &&
           !std::is_sorted(tableau.c.begin(), tableau.c.end());
  }



  template <int dim>
  void
  DirkIntegrator<dim>::choose_stops(const State &state, const ContactMode mode)
  {
    for (StageRates &stage : stages)
      stage.held_at.clear();
    if (mode != ContactMode::closed || !body.scene.contact.rear_gap)
      return;
    std::vector<NodeLaw> laws;
    std::vector<double>  position;
    get_node_laws(body, state, laws, position);
    for (StageRates &stage : stages)
      for (const NodeLaw &law : laws)
        stage.held_at.push_back(law.side);
  }



  template <int dim>
  void
  DirkIntegrator<dim>::hold_closing_nodes(const State       &state,
                                          const unsigned int i)
  {
    std::vector<bool> &is_held = stages[i].is_held;
    std::vector<int>  &held_at = stages[i].held_at;
    is_held.assign(state.contact_pressure.size(), false);
    if (body.scene.contact.rear_gap)
      held_at.assign(is_held.size(), 0);
    for (unsigned int j = 0; j < i; ++j)
      for (unsigned int node = 0; node < is_held.size(); ++node)
        if (const double p = stages[j].pressure[node];
            state.contact_pressure[node] == 0. && p != 0. && !is_held[node])
          {
            is_held[node] = true;
            if (!held_at.empty())
              held_at[node] = p < 0. ? -1 : 1;
          }
  }



  template <int dim>
  bool
  DirkIntegrator<dim>::release_crossing_nodes(const double tau,
                                              StageRates  &stage)
  {
    if (stage.held_at.empty() ||
        std::find(stage.is_held.begin(), stage.is_held.end(), true) ==
          stage.is_held.end())
      return false;
    std::vector<double>  velocity, position;
    std::vector<NodeLaw> laws;
    get_node_laws(body, known, laws, position);
    body.contact_end().get_values(Field::displacement,
                                  stage.velocity,
                                  velocity);
    bool releases = false;
    for (unsigned int node = 0; node < velocity.size(); ++node)
      if (stage.is_held[node])
        {
          const double end = position[node] + tau * velocity[node];
          if ((stage.held_at[node] > 0 ?
                 laws[node].rear_penetration(end) :
                 laws[node].front_penetration(end)) <= 0.)
            continue;
          stage.is_held[node] = false;
          stage.held_at[node] = 0;
          releases            = true;
        }
    return releases;
  }



  template <int dim>
  std::vector<bool>
  DirkIntegrator<dim>::closed_at_end(const ContactMode mode) const
  {
    const StageRates &last = stages.back();
    std::vector<bool> is_closed(last.is_held);
    is_closed.resize(last.pressure.size(), false);
    for (unsigned int i = 0; i < is_closed.size(); ++i)
      if (mode == ContactMode::closed || last.pressure[i] != 0.)
        is_closed[i] = true;
    return is_closed;
  }



  template <int dim>
  void
  DirkIntegrator<dim>::find_closed_nodes(const State      &state,
                                         const ContactMode mode,
                                         StepResult       &result) const
  {
    result.closed_nodes.clear();
    if (!holds_closing_nodes(mode))
      return;
    const std::vector<bool> is_closed = closed_at_end(mode);
    for (unsigned int i = 0; i < is_closed.size(); ++i)
      if (is_closed[i] && state.contact_pressure[i] == 0.)
        {
          result.closed_nodes = is_closed;
          return;
        }
  }



#define INSTANTIATE(dim)                                                     \
  template void DirkIntegrator<dim>::start_drives(const State &,             \
                                                  const TimeStep &);         \
  template void DirkIntegrator<dim>::start_obstacle(const State &,           \
                                                    const TimeStep &,        \
                                                    const StageTimes &);     \
  template void DirkIntegrator<dim>::place_obstacle(const unsigned int,      \
                                                    const double,            \
                                                    const ContactMode);      \
  template bool DirkIntegrator<dim>::can_change_at_once(const ContactMode)   \
    const;                                                                   \
  template bool DirkIntegrator<dim>::holds_closing_nodes(const ContactMode)  \
    const;                                                                   \
  template void DirkIntegrator<dim>::choose_stops(const State &,             \
                                                  const ContactMode);        \
  template void DirkIntegrator<dim>::hold_closing_nodes(const State &,       \
                                                        const unsigned int); \
  template bool DirkIntegrator<dim>::release_crossing_nodes(const double,    \
                                                            StageRates &);   \
  template std::vector<bool> DirkIntegrator<dim>::closed_at_end(             \
    const ContactMode) const;                                                \
  template void DirkIntegrator<dim>::find_closed_nodes(const State &,        \
                                                       const ContactMode,    \
                                                       StepResult &) const

  INSTANTIATE(1);
  INSTANTIATE(2);
  INSTANTIATE(3);

#undef INSTANTIATE
} // namespace ThermoContact
