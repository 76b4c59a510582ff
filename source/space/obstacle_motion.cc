// SPDX-License-Identifier: LGPL-2.1-or-later

#include <thermocontact/base/exceptions.h>
#include <thermocontact/base/text.h>
#include <thermocontact/input/parameter_text.h>
#include <thermocontact/space/obstacle_motion.h>
#include <thermocontact/space/problem_data.h>

#include <cmath>

namespace ThermoContact
{
  namespace
  {
    /** An expression may be finite at the axis and not at a node. */
    template <int dim>
    void
    check_gap(const double gap, const Point<dim> &place)
    {
      if (dim == 1 || std::isfinite(gap))
        return;
      throw InputError(
        text("Contact/Gap: not finite at y = ",
             place[dim > 1 ? 1 : 0],
             dim > 2 ? text(", z = ", place[dim - 1]) : "",
             "\n  allowed: an expression that is finite on the contact end"));
    }
  } // namespace



  template <int dim>
  ObstacleMotion<dim>::ObstacleMotion(const Scene           &scene,
                                      const ContactEnd<dim> &end)
    : n_nodes(end.n_nodes())
    , contact(scene.contact)
  {
    const auto gap = contact_gap<dim>(scene);
    for (const ContactNode<dim> &node : end.all_nodes())
      {
        gaps_at_start_.push_back(
          gaps_at_start_.size() < scene.row.contacts.size() ?
            scene.row.contacts[gaps_at_start_.size()].gap : // come first
            gap->value(node.position));
        check_gap(gaps_at_start_.back(), node.position);
      }
    if (!scene.sources.has_moving_obstacle)
      return;
    for (const ContactNode<dim> &node : end.nodes())
      if (node.has_partner(Field::displacement))
        {
          gaps_of_bodies.push_back(
            TimeDerivatives(gaps_at_start_[gaps_of_bodies.size()]));
          continue;
        }
      else
        {
          gaps.emplace_back(*scene.gap_expression, node.position);
          if (scene.contact.has_uniform_gap())
            break;
        }
  }



  template <int dim>
  void
  ObstacleMotion<dim>::get_derivatives(
    const double                  time,
    std::vector<TimeDerivatives> &derivatives) const
  {
    const unsigned int first = gaps_of_bodies.size();
    derivatives.assign(gaps_of_bodies.begin(), gaps_of_bodies.end());
    derivatives.resize(n_nodes);
    for (unsigned int i = first; i < n_nodes; ++i)
      derivatives[i] = i - first < gaps.size() ?
                         gaps[i - first].derivatives(time) :
                         derivatives[first];
    const auto fail = [&](const std::string &fault, const std::string &remedy) {
      throw ComputationError(text("Contact/Gap = ",
                                  quote(gaps.front().expression.text()),
                                  ": ",
                                  fault,
                                  " at t = ",
                                  time,
                                  "\n  remedy:  ",
                                  remedy));
    };
    for (unsigned int i = 0; i < n_nodes; ++i)
      if (const double gap = derivatives[i].value; !std::isfinite(gap))
        fail("is not finite", "a function that is finite up to Time/End time");
      else if (contact.stops_overlap(i, gap))
        fail("the stops overlap", "a larger Contact/Rear gap");
  }



  template <int dim>
  void
  ObstacleMotion<dim>::place(const double time,
                             const double rate_time,
                             State       &state) const
  {
    if (!is_active())
      return;
    get_derivatives(time, scratch);
    for (unsigned int i = 0; i < n_nodes; ++i)
      state.gap[i] = scratch[i].value;
    set_rates(rate_time, state);
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
