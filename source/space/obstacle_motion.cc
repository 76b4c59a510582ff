// SPDX-License-Identifier: LGPL-2.1-or-later

#include <thermocontact/base/exceptions.h>
#include <thermocontact/base/text.h>
#include <thermocontact/input/parameter_text.h>
#include <thermocontact/space/obstacle_motion.h>

#include <cmath>

namespace ThermoContact
{
  template <int dim>
  ObstacleMotion<dim>::ObstacleMotion(const Scene           &scene,
                                      const ContactEnd<dim> &end)
    : formula(scene.parameters.contact.gap_expression)
    , n_nodes(end.n_nodes())
  {
    if (!scene.sources.has_moving_obstacle)
      return;
    const std::string names[] = {"x", "y", "z"};
    for (const ContactNode<dim> &node : end.nodes())
      {
        Place &place = places.emplace_back();
        for (unsigned int d = 0; d < dim; ++d)
          place[names[d]] = node.position[d];
        if (scene.contact.has_uniform_gap())
          break;
      }
    const double end_time = scene.parameters.time.end_time;
    for (const Place &place :
         {places.front(), places[places.size() / 2], places.back()})
      TimeFunction({"Contact/Gap", formula}, place).check(end_time);
  }



  template <int dim>
  void
  ObstacleMotion<dim>::get_derivatives(
    const double                  time,
    std::vector<TimeDerivatives> &derivatives) const
  {
    derivatives.resize(n_nodes);
    for (unsigned int i = 0; i < places.size(); ++i)
      derivatives[i] = differentiate(formula, time, places[i]);
    for (unsigned int i = places.size(); i < n_nodes; ++i)
      derivatives[i] = derivatives.front();
    for (const TimeDerivatives &at : derivatives)
      if (!std::isfinite(at.value))
        throw ComputationError(text("Contact/Gap = ",
                                    quote(formula),
                                    ": is not finite at t = ",
                                    time,
                                    "\n  remedy:  a function that is finite up "
                                    "to Time/End time"));
  }



  template <int dim>
  void
  ObstacleMotion<dim>::place(const double time, State &state) const
  {
    if (!is_active())
      return;
    get_derivatives(time, scratch);
    for (unsigned int i = 0; i < n_nodes; ++i)
      {
        state.gap[i]      = scratch[i].value;
        state.gap_rate[i] = scratch[i].first;
      }
  }



  template <int dim>
  void
  ObstacleMotion<dim>::set_rates(const double time, State &state) const
  {
    if (!is_active())
      return;
    get_derivatives(time, scratch);
    for (unsigned int i = 0; i < n_nodes; ++i)
      state.gap_rate[i] = scratch[i].first;
  }



  template class ObstacleMotion<1>;
  template class ObstacleMotion<2>;
  template class ObstacleMotion<3>;
} // namespace ThermoContact
