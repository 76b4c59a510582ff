// SPDX-License-Identifier: LGPL-2.1-or-later

#include <thermocontact/scene/spatial_scene.h>

#include <tuple>

namespace ThermoContact
{
  SpatialScene::SpatialScene(const Scene &scene)
    : mesh(scene.parameters.mesh)
    , fields(scene.fields)
    , material(scene.material)
    , dimension(scene.parameters.dimension)
    , has_rollers(scene.has_rollers)
    , has_symmetry(scene.has_symmetry)
    , has_sliding_end(scene.has_sliding_end)
    , has_pins(scene.has_pins())
    , has_lumped_mass(scene.has_lumped_mass)
    , has_midpoint_mass(scene.has_midpoint_mass)
    , has_massless_nodes(scene.contact.has_massless_nodes)
    , has_elastic_contact_nodes(scene.has_elastic_contact_nodes())
    , has_matrices(!scene.linear_solver.is_iterative)
    , n_halvings(scene.linear_solver.is_iterative ? mesh.n_halvings() : 0)
    , exchange_coefficient(scene.heat.linear_coefficient())
    , lateral_exchange(scene.heat.lateral_exchange)
    , has_free_end(scene.has_free_end)
    , has_given_temperature(scene.heat.has_given_temperature)
    , has_right_temperature(scene.heat.right_temperature.has_value())
    , has_clamped_right(scene.parameters.boundary.right.is_clamped())
    , left_exchange(scene.heat.left_exchange)
    , left(scene.parameters.boundary.left)
    , right(scene.parameters.boundary.right)
    , row(scene.row)
    , profile(scene.profile)
    , obstacle_mass(scene.obstacle_mass ?
                      std::optional(scene.obstacle_mass->without_start()) :
                      std::nullopt)
  {}



  namespace
  {
    // as Material::members()
    auto
    members(const SpatialScene &all)
    {
      const auto &[a,
                   b,
                   c,
                   d,
                   e,
                   f,
                   g,
                   h,
                   i,
                   j,
                   k,
                   l,
                   m,
                   n,
                   o,
                   p,
                   q,
                   r,
                   s,
                   t,
                   u,
                   v,
                   w,
                   x,
                   y,
                   z] = all;
      const auto others =
        std::tie(d, e, f, g, h, i, j, k, l, m, n, o, p, q, r, s, t, u, x, y, z);
      return std::tuple_cat(a.members(),
                            b.members(),
                            c.members(),
                            v.members(),
                            w.members(),
                            others);
    }
  } // namespace



  bool
  SpatialScene::operator==(const SpatialScene &other) const
  {
    return members(*this) == members(other);
  }
} // namespace ThermoContact
