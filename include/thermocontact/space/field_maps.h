// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef thermocontact_space_field_maps_h
#define thermocontact_space_field_maps_h

#include <thermocontact/scene/scene.h>
#include <thermocontact/space/field_matrices.h>
#include <thermocontact/space/linear_map.h>

#include <memory>

namespace ThermoContact
{
  template <int dim>
  class MatrixFreeOperator;



  /** Products with the field matrices; those of absent fields must not be used.
   */
  struct FieldMaps
  {
    std::unique_ptr<const LinearMap> heat_mass, conduction, divergence,
      thermal_stress, momentum_mass, stiffness, viscous_stiffness,
      lateral_exchange;
  };



  /** By @p products if it is there, else by @p rod, else by @p matrices; all are
   * borrowed. */
  template <int dim>
  FieldMaps
  make_field_maps(const Scene                   &scene,
                  const FieldMatrices<dim>      *matrices,
                  const RodMatrices             *rod,
                  const MatrixFreeOperator<dim> *products);
} // namespace ThermoContact

#endif
