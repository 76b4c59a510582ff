// SPDX-License-Identifier: LGPL-2.1-or-later

#include <thermocontact/space/shown_fields.h>

namespace ThermoContact
{
  const Vector &
  shown_velocity(const Scene &scene, const State &state, Vector &memory)
  {
    if (!scene.has_midpoint_mass)
      return state.velocity;
    memory                      = state.velocity;
    const unsigned int n        = memory.locally_owned_size();
    const double      *v        = state.velocity.begin();
    double            *at       = memory.begin();
    const auto         show_rod = [=](const unsigned int first,
                              const unsigned int last) {
      for (unsigned int i = first + 1; i < last; ++i)
        at[i] = 0.5 * v[i] + 0.25 * (v[i - 1] + v[i + 1]);
      at[first] = 0.5 * (v[first] + v[first + 1]);
    };
    if (!scene.row.is_given())
      show_rod(0, n - 1);
    for (const RowBody &body : scene.row.bodies)
      if (body.n_cells > 0)
        show_rod(body.first_cell, body.first_cell + body.n_cells);
    if (!scene.has_free_end && !scene.row.begins_with_mass())
      at[0] = scene.fixed_end_motion ?
                scene.fixed_end_motion->derivatives(state.load_time).first :
                0.;
    return memory;
  }



  template <int dim>
  ShownFields<dim>::ShownFields(const Scene               &scene,
                                const Discretization<dim> &discretization,
                                const State               &state)
    : scene(scene)
    , discretization(discretization)
    , values_(discretization.with_ghosts(state.temperature, state.displacement))
    , velocities_(
        discretization.with_ghosts(state.temperature,
                                   shown_velocity(scene, state, memory)))
  {}



  template class ShownFields<1>;
  template class ShownFields<2>;
  template class ShownFields<3>;
} // namespace ThermoContact
