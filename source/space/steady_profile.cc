// SPDX-License-Identifier: LGPL-2.1-or-later

#include <thermocontact/space/energy.h>
#include <thermocontact/space/linear_system.h>

namespace ThermoContact
{
  template <int dim>
  void
  Energy<dim>::set_steady_profile()
  {
    Vector     &profile      = steady_profile_;
    const auto &nodal_values = discretization.nodal_values(Field::temperature);
    if (discretization.has_bodies())
      {
        // the rest does work; the last body has a given temperature
        profile = heat.fixed_end_temperature;
        if (heat.right_temperature)
          {
            const BodyRow &row  = discretization.row();
            const double   from = row.begin_of_last_part();
            for (unsigned int i = 0; i < nodal_values.size(); ++i)
              if (const double x = nodal_values[i].node[0];
                  from == 0.) // one part alone
                profile.local_element(i) +=
                  (*heat.right_temperature - heat.fixed_end_temperature) * x /
                  row.length();
              else if (x >= from)
                profile.local_element(i) = *heat.right_temperature;
          }
        discretization.set_zero_in_gaps(Field::temperature, profile);
        if (const auto entry =
              discretization.obstacle_entry(Field::temperature))
          profile.begin()[*entry] = heat.fixed_end_temperature;
        return;
      }
    for (unsigned int i = 0; i < nodal_values.size(); ++i)
      profile.local_element(i) =
        heat.steady_temperature(nodal_values[i].node[0]);
    if (heat.has_linear_profile())
      return;

    // where the matrices have no exchange, that of the nodes
    const ContactEnd<dim> &end = discretization.contact_end();
    Vector                 exchange(profile), residual(profile);
    exchange = 0.;
    if (!heat.exchange->is_in_matrices())
      end.subtract_load(Field::temperature,
                        std::vector<double>(end.n_nodes(),
                                            -heat.reference_coefficient),
                        1.,
                        exchange);
    LinearSystem<dim> system_at_rest(stage_operator, heat_at_rest, &exchange);
    // the second time of the rounding of the first solution
    for (unsigned int i = 0; i < 2; ++i)
      {
        stage_operator.conduction.vmult(residual, profile);
        residual.sadd(-1., loads.outer_heat());
        if (!heat.exchange->is_in_matrices())
          {
            end.get_values(Field::temperature, profile, steady_end);
            for (unsigned int i = 0; i < end.n_nodes(); ++i)
              steady_end[i] = heat.reference_coefficient *
                              (steady_end[i] - surroundings.reference(i));
            end.subtract_load(Field::temperature, steady_end, 1., residual);
          }
        stage_operator.zero_constrained(Field::temperature, residual);
        system_at_rest.solve(heat_scratch, residual);
        stage_operator.zero_constrained(Field::temperature, heat_scratch);
        profile += heat_scratch;
      }
  }



  template void
  Energy<1>::set_steady_profile();
  template void
  Energy<2>::set_steady_profile();
  template void
  Energy<3>::set_steady_profile();
} // namespace ThermoContact
