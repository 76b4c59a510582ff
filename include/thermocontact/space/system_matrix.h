// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef thermocontact_space_system_matrix_h
#define thermocontact_space_system_matrix_h

#include <thermocontact/space/system_coefficients.h>
#include <thermocontact/space/thermoviscoelastic_operator.h>

namespace ThermoContact
{
  /**
   * The rows of a field of a system without the other field, in the numbering
   * of the field; constrained rows say that the unknown vanishes.
   *
   * @param equations of a scene that has matrices
   */
  template <int dim>
  SparseMatrix
  field_matrix(const ThermoviscoelasticOperator<dim> &equations,
               const SystemCoefficients              &coefficients,
               const Field::Block                     field);

  /**
   * The whole system in the numbering of both fields, of a scene with thermal
   * stress.
   */
  template <int dim>
  SparseMatrix
  whole_matrix(const ThermoviscoelasticOperator<dim> &equations,
               const SystemCoefficients              &coefficients);
} // namespace ThermoContact

#endif
