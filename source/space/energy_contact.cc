// SPDX-License-Identifier: LGPL-2.1-or-later

#include <thermocontact/space/energy.h>

#include <algorithm>
#include <cmath>

namespace ThermoContact
{
  namespace
  {
    /** Parts of what a penetration is a difference of that are rounding. */
    constexpr double rounding_of_penetration = 1e-10;

    /** Factors (1 + c v) by which a pressure is divided without loss. */
    constexpr double smallest_factor = 0.5;



    /**
     * $\varphi(s)$ at a node with the pressure $p = \varphi(s)\,[1+c\,v]_+$,
     * (M.82), seen from its stop. At a hard obstacle s has few digits, and
     * $p-\varphi(s)$ would have none: then it is $p/(1+c\,v)$. A node that goes
     * in without a pressure does not know of the obstacle yet, in a step that
     * is held open and misses the begin of contact by s: zero.
     *
     * @param rounding of s
     */
    double
    elastic_part(const ContactLaw &law,
                 const double      pressure,
                 const double      s,
                 const double      v,
                 const double      rounding)
    {
      const double of_law = law.pressure(s);
      const double factor = 1. + law.damping() * v;
      if (factor < smallest_factor)
        return of_law;
      if (pressure == 0.)
        return v > 0. ? 0. : of_law;
      const double value = pressure / factor;
      return std::abs(law.penetration(value) - s) <= rounding ? value : of_law;
    }
  } // namespace



  template <int dim>
  const std::vector<double> &
  Energy<dim>::elastic_pressures(const State         &state,
                                 std::vector<double> &scratch) const
  {
    if (law.damping() == 0.)
      return state.contact_pressure;
    const ContactEnd<dim> &end = discretization.contact_end();
    end.get_penetrations(state, scratch);
    end.get_approach(state, approach);
    const double size   = state.displacement.linfty_norm();
    const auto   stored = [&](const unsigned int i,
                            const double       s,
                            const double       side) {
      if (material.is_static()) // velocities of what moves at once say nothing
        return law.pressure(s);
      return elastic_part(law,
                          std::max(side * state.contact_pressure[i], 0.),
                          s,
                          side * approach[i],
                          rounding_of_penetration *
                            std::max(size, std::abs(state.gap[i])));
    };
    for (unsigned int i = 0; i < scratch.size(); ++i)
      scratch[i] = stored(i, scratch[i], 1.);
    if (!rear_gap)
      return scratch;
    end.get_rear_penetrations(state.displacement, *rear_gap, rear_penetration);
    for (unsigned int i = 0; i < scratch.size(); ++i)
      scratch[i] -= stored(i, rear_penetration[i], -1.);
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
