// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef thermocontact_space_field_maps_h
#define thermocontact_space_field_maps_h

#include <thermocontact/space/field_matrices.h>
#include <thermocontact/space/linear_map.h>

namespace ThermoContact
{
  template <int dim, typename Number>
  class CellProducts;



  /** Products with the field matrices; products that a scene does not have are
   * empty. */
  struct FieldMaps
  {
    FieldMaps() = default;

    /**
     * By matrices, or by those of a rod in their place; borrowed.
     *
     * @param rod null: there is none
     */
    template <int dim>
    FieldMaps(const FieldMatrices<dim> &matrices, const RodMatrices *rod);

    /** Without matrices; @p products are borrowed. */
    template <int dim>
    explicit FieldMaps(const CellProducts<dim, double> &products);

    /** $M$, $\int\eta_i\eta_j$. */
    LinearMap heat_mass;

    /** $K+kB+L$, $\int\nabla\eta_i\cdot\nabla\eta_j +
     * k\int_{\Gamma_C}\eta_i\eta_j$ and the lateral heat exchange. */
    LinearMap conduction;

    /** $L$; of scenes with a lateral heat exchange, (D1.5). */
    LinearMap lateral_exchange;

    /** $D$, $\int\eta_i\,\mathrm{div}\,\varphi_j$; temperature rows,
     * displacement columns. */
    LinearMap divergence;

    /** $D^T$; displacement rows, temperature columns. */
    LinearMap thermal_stress;

    /** $M_u$, without the inertia coefficient $b$. */
    LinearMap momentum_mass;

    /** $S$, $\int C{:}\varepsilon(\varphi_i){:}\varepsilon(\varphi_j)$. */
    LinearMap stiffness;

    /**
     * $S_\zeta$, without the viscosity $\zeta$: $S$, but where the contact
     * nodes have no viscous stress (C6.1).
     */
    LinearMap viscous_stiffness;
  };

} // namespace ThermoContact

#endif
