// SPDX-License-Identifier: LGPL-2.1-or-later

#include <thermocontact/scene/spatial_scene.h>

#include <tuple>

namespace ThermoContact
{
  SpatialScene::SpatialScene(const Scene &scene)
    : dimension(scene.parameters.dimension)
    , mesh(scene.parameters.mesh)
    , fields(scene.fields)
    , material(scene.material)
    , has_rollers(scene.has_rollers)
    , has_symmetry(scene.has_symmetry)
    , has_sliding_end(scene.has_sliding_end)
    , has_pins(scene.has_pins())
    , has_lumped_mass(scene.has_lumped_mass)
    , has_midpoint_mass(scene.has_midpoint_mass)
    , has_massless_nodes(scene.contact.has_massless_nodes)
    , has_elastic_contact_nodes(scene.has_elastic_contact_nodes())
    , has_matrices(scene.linear_solver.has_matrices())
    , exchange_coefficient(scene.heat.linear_coefficient())
    , lateral_exchange(scene.heat.lateral_exchange)
    , rear_gap(scene.contact.rear_gap)
    , gap(scene.contact.gap)
  {
    if (scene.contact.law->is_active() &&
        (!scene.contact.has_uniform_gap() || scene.sources.has_moving_obstacle))
      {
        gap            = 0.;
        gap_expression = *scene.gap_expression;
      }
  }



  namespace
  {
    // All members of each record: a binding that leaves one out does not
    // compile.

    auto
    members(const MeshParameters &mesh)
    {
      const auto &[cells,
                   degree,
                   refinements,
                   grading,
                   mass,
                   geometry,
                   width,
                   cells_across,
                   grading_across] = mesh;
      return std::tie(cells,
                      degree,
                      refinements,
                      grading,
                      mass,
                      geometry,
                      width,
                      cells_across,
                      grading_across);
    }



    auto
    members(const SceneFields &fields)
    {
      const auto &[temperature, displacement] = fields;
      return std::tie(temperature, displacement);
    }



    auto
    members(const Material &material)
    {
      const auto &[inertia, viscosity, stress, heating, lambda, two_mu] =
        material;
      return std::tie(inertia, viscosity, stress, heating, lambda, two_mu);
    }



    auto
    members(const SpatialScene &scene)
    {
      const auto &[dimension,
                   mesh,
                   fields,
                   material,
                   rollers,
                   symmetry,
                   sliding,
                   pins,
                   lumped,
                   midpoint,
                   massless,
                   elastic,
                   matrices,
                   exchange,
                   lateral,
                   rear_gap,
                   gap,
                   expression] = scene;
      return std::tuple_cat(members(mesh),
                            members(fields),
                            members(material),
                            std::tie(dimension,
                                     rollers,
                                     symmetry,
                                     sliding,
                                     pins,
                                     lumped,
                                     midpoint,
                                     massless,
                                     elastic,
                                     matrices,
                                     exchange,
                                     lateral,
                                     rear_gap,
                                     gap,
                                     expression));
    }
  } // namespace



  bool
  SpatialScene::operator==(const SpatialScene &other) const
  {
    return members(*this) == members(other);
  }
} // namespace ThermoContact
