// SPDX-License-Identifier: LGPL-2.1-or-later

#include <thermocontact/space/energy.h>

namespace ThermoContact
{
  template <int dim>
  const std::vector<double> &
  Energy<dim>::elastic_pressures(const State         &state,
                                 std::vector<double> &scratch) const
  {
    if (law.damping() == 0.)
      return state.contact_pressure;
    discretization.contact_end().get_penetrations(state, scratch);
    for (double &value : scratch) // penetrations so far
      value = law.pressure(value);
    if (!rear_gap)
      return scratch;
    discretization.contact_end().get_rear_penetrations(state.displacement,
                                                       *rear_gap,
                                                       rear_penetration);
    for (unsigned int i = 0; i < scratch.size(); ++i)
      scratch[i] -= law.pressure(rear_penetration[i]);
    return scratch;
  }



  template <int dim>
  double
  Energy<dim>::damping_rate(const State &state) const
  {
    if (law.damping() == 0.)
      return 0.;
    const ContactEnd<dim>     &end     = discretization.contact_end();
    const std::vector<double> &elastic = elastic_pressures(state, end_pressure);
    end.get_approach(state, approach);
    double rate = 0.;
    for (unsigned int i = 0; i < elastic.size(); ++i)
      rate +=
        end.share(i) * (state.contact_pressure[i] - elastic[i]) * approach[i];
    return rate;
  }



  template <int dim>
  double
  Energy<dim>::obstacle_power(const State &state) const
  {
    const ContactEnd<dim> &end   = discretization.contact_end();
    double                 power = 0.;
    for (unsigned int i = 0; i < state.gap_rate.size(); ++i)
      power -= end.share(i) * state.contact_pressure[i] * state.gap_rate[i];
    return power;
  }



  template <int dim>
  double
  Energy<dim>::contact_dissipation(const State &old_state,
                                   const State &state) const
  {
    const ContactEnd<dim> &end = discretization.contact_end();
    end.get_values(Field::displacement, state.displacement, end_displacement);
    end.get_values(Field::displacement,
                   old_state.displacement,
                   old_end_displacement);
    end.get_penetrations(old_state, old_penetration);
    const std::vector<double> &old_pressure =
      elastic_pressures(old_state, old_end_pressure);
    const std::vector<double> &pressure =
      elastic_pressures(state, end_pressure);
    double sum = 0.;
    for (unsigned int i = 0; i < pressure.size(); ++i)
      {
        const double change = end_displacement[i] - old_end_displacement[i] -
                              (state.gap[i] - old_state.gap[i]);
        sum +=
          end.share(i) *
          (rear_gap && pressure[i] < 0. ? // mirrored
             law.numerical_dissipation(-change,
                                       -old_end_displacement[i] - *rear_gap,
                                       -old_pressure[i],
                                       -pressure[i]) :
             law.numerical_dissipation(
               change, old_penetration[i], old_pressure[i], pressure[i]));
      }
    return sum;
  }



#define INSTANTIATE(dim)                                              \
  template const std::vector<double> &Energy<dim>::elastic_pressures( \
    const State &, std::vector<double> &) const;                      \
  template double Energy<dim>::damping_rate(const State &) const;     \
  template double Energy<dim>::obstacle_power(const State &) const;   \
  template double Energy<dim>::contact_dissipation(const State &,     \
                                                   const State &) const

  INSTANTIATE(1);
  INSTANTIATE(2);
  INSTANTIATE(3);

#undef INSTANTIATE
} // namespace ThermoContact
