// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef thermocontact_space_assembled_space_h
#define thermocontact_space_assembled_space_h

#include <thermocontact/scene/scene.h>
#include <thermocontact/space/discretization.h>
#include <thermocontact/space/field_matrices.h>

#include <memory>

namespace ThermoContact
{
  /**
   * Mesh, spaces and matrices of a scene, which are those of every scene that
   * differs from it in entries that changes_matrices() denies. Constant.
   */
  template <int dim>
  struct AssembledSpace
  {
    /**
     * Collective.
     *
     * @param scene borrowed
     */
    AssembledSpace(const Scene &scene, const MPI_Comm communicator)
      : discretization(scene, communicator)
      , matrices(
          scene.linear_solver.has_matrices() ?
            std::make_unique<const FieldMatrices<dim>>(scene, discretization) :
            nullptr)
    {}

    const Discretization<dim> discretization;

    /** Null for scenes that have none. */
    const std::unique_ptr<const FieldMatrices<dim>> matrices;
  };
} // namespace ThermoContact

#endif
