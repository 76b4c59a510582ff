// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef thermocontact_scene_spatial_scene_h
#define thermocontact_scene_spatial_scene_h

#include <thermocontact/scene/scene.h>

#include <optional>

namespace ThermoContact
{
  /**
   * All that mesh, spaces and matrices are made of: their constructors are
   * given nothing else of a scene, so that scenes whose SpatialScene is the
   * same have the same ones, bit for bit. A value.
   */
  struct SpatialScene
  {
    /** Implicit: a scene goes where this is asked for. */
    SpatialScene(const Scene &scene);

    MeshParameters mesh;
    SceneFields    fields;
    Material       material;
    unsigned int   dimension;
    bool           has_rollers;
    bool           has_symmetry;
    bool           has_sliding_end;
    bool           has_pins;
    bool           has_lumped_mass;
    bool           has_midpoint_mass;
    bool           has_massless_nodes;
    bool           has_elastic_contact_nodes;
    bool           has_matrices;
    unsigned int   n_halvings;   ///< of the mesh, for coarser ones
    double exchange_coefficient; ///< $k$ of the contact end, if constant
    double lateral_exchange;     ///< $m$, (M5.5)
    bool   has_free_end;
    bool   has_given_temperature;
    bool   has_right_temperature;
    bool   has_clamped_right;
    double left_exchange; ///< $k_A$ of the end $x=0$
    BoundaryParameters::Attached left, right;
    BodyRow                      row;
    std::optional<BodyProfile>   profile;
    std::optional<ObstacleMass>  obstacle_mass;

    bool
    operator==(const SpatialScene &other) const;
  };
} // namespace ThermoContact

#endif
