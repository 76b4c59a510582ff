// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef thermocontact_space_assembled_space_h
#define thermocontact_space_assembled_space_h

#include <thermocontact/scene/spatial_scene.h>
#include <thermocontact/space/discretization.h>
#include <thermocontact/space/field_matrices.h>

#include <memory>

namespace ThermoContact
{
  /**
   * Mesh, spaces and matrices of a scene, which are those of every scene with
   * the same SpatialScene. Constant.
   */
  template <int dim>
  struct AssembledSpace
  {
    /** Collective. */
    AssembledSpace(const SpatialScene &scene, const MPI_Comm communicator)
      : scene(scene)
      , discretization(scene, communicator)
      , matrices(
          scene.has_matrices ?
            std::make_unique<const FieldMatrices<dim>>(scene, discretization) :
            nullptr)
    {}

    const SpatialScene        scene;
    const Discretization<dim> discretization;

    /** Null for scenes that have none. */
    const std::unique_ptr<const FieldMatrices<dim>> matrices;
  };
} // namespace ThermoContact

#endif
