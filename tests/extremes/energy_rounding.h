// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef thermocontact_extremes_energy_rounding_h
#define thermocontact_extremes_energy_rounding_h

#include <thermocontact/simulation/simulation.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace ThermoContact
{
  /**
   * What rounding does to the energy in a step. A stage of n unknowns is solved
   * up to residuals of the size of epsilon sqrt(n) |S| U of the momentum and
   * epsilon sqrt(n) |S| Theta of the heat equation, |S| the largest row sum of
   * the stiffness, which is large on fine and graded meshes of high degree, or
   * of the lateral heat exchange, and epsilon k Theta at the end; U, Theta, V
   * largest nodal values, divided like the energy by the cross-section. These
   * meet the changes of u and theta, so that the energy of a body that rests at
   * u and theta_s fluctuates. theta itself is stored to epsilon Theta, and in
   * contact u_n = u_free - chi p, with chi < 1.
   */
  template <int dim>
  class EnergyRounding
  {
  public:
    /** For the step to the present state from that of the last call. */
    double
    operator()(const Simulation<dim> &simulation)
    {
      const State       &state     = simulation.state();
      const Scene       &scene     = simulation.scene();
      const auto        &stage     = simulation.body().equations;
      const double       dt        = simulation.record().step_size;
      const auto        &stiffness = stage.field_matrices().stiffness;
      const unsigned int n_fields  = stiffness.n_block_rows();
      const double       epsilon   = std::numeric_limits<double>::epsilon();
      const double       unit =
        epsilon *
        std::sqrt(simulation.discretization().dof_handler().n_dofs()) *
        (stiffness.block(n_fields - 1, n_fields - 1).linfty_norm() +
         lateral_row_sum(simulation)) /
        simulation.body().discretization.geometry().cross_section();
      const Values values = present_values(simulation);
      const double u      = std::max(values.u, last.u);
      const double v      = std::max(values.v, last.v);
      const double theta  = std::max(values.theta, last.theta);
      const double excess = std::max(values.excess, last.excess);
      last                = values;
      const double p =
        scene.fields.has_displacement ? simulation.record().contact_force : 0.;
      double k = scene.heat.reference_coefficient;
      for (const double coefficient : state.exchange_coefficient)
        k = std::max(k, coefficient);
      return 4. * unit *
               (u * u + std::min(dt, 1.) * theta * excess +
                unit * theta * theta + dt * scene.material.viscosity * v * v) +
             4. * epsilon * theta * excess +
             4. * epsilon * dt * k * theta * values.end_excess +
             4. * epsilon * p * (10. * u + p);
    }

  private:
    struct Values
    {
      double u = 0., v = 0., theta = 0., excess = 0.;
      double end_excess = 0.; ///< of the temperature of the end over theta_s
    };

    Values last;

    static Values
    present_values(const Simulation<dim> &simulation)
    {
      const State &state = simulation.state();
      const Scene &scene = simulation.scene();
      Values       values;
      if (scene.fields.has_displacement)
        {
          values.u = state.displacement.linfty_norm();
          values.v = state.velocity.linfty_norm();
        }
      if (scene.fields.has_temperature)
        {
          values.theta = state.temperature.linfty_norm();
          Vector excess(state.temperature);
          excess -= simulation.body().energy.steady_profile();
          values.excess = excess.linfty_norm();
          std::vector<double> end;
          simulation.body().contact_end().get_values(Field::temperature,
                                                     excess,
                                                     end);
          for (const double value : end)
            values.end_excess = std::max(values.end_excess, std::abs(value));
        }
      return values;
    }

    /** Of L; with a lateral heat exchange. */
    static double
    lateral_row_sum(const Simulation<dim> &simulation)
    {
      if (!simulation.scene().fields.has_temperature ||
          !simulation.scene().heat.has_lateral_exchange())
        return 0.;
      Vector ones(simulation.state().temperature), sums(ones);
      ones = 1.;
      simulation.body().equations.lateral_exchange().vmult(sums, ones);
      return sums.linfty_norm();
    }
  };
} // namespace ThermoContact

#endif
