// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef thermocontact_space_thermoviscoelastic_operator_h
#define thermocontact_space_thermoviscoelastic_operator_h

#include <thermocontact/base/types.h>
#include <thermocontact/scene/scene.h>
#include <thermocontact/space/discretization.h>
#include <thermocontact/space/field_maps.h>
#include <thermocontact/space/field_matrices.h>
#include <thermocontact/space/state.h>

namespace ThermoContact
{
  /**
   * The semidiscrete equations, doc/discretisation.md (D1.1), (D1.2):
   * @f[
   *   M\theta' + (K+kB)\theta + aDv = \ell_\theta(t), \quad
   *   bM_u v' + Su + \zeta Sv - aD^T\theta = \ell_u(t) - N p .
   * @f]
   *
   * A field that the scene does not have has no matrices, and $a$ is zero then;
   * $a$ of the first equation is zero if thermoelastic heating is off.
   *
   * Field matrices are assembled once, without constraints, or not at all if
   * the scene has an iterative solver; the constrained rows of stage matrices
   * and right-hand sides say that rates vanish. Vectors come from
   * Discretization::make_vector().
   */
  template <int dim>
  class ThermoviscoelasticOperator
  {
  public:
    /**
     * All arguments are borrowed and must outlive this object.
     *
     * @param shared the matrices of such a scene; null: they are assembled
     */
    ThermoviscoelasticOperator(const Scene               &scene,
                               const Discretization<dim> &discretization,
                               const FieldMatrices<dim>  *shared = nullptr);

    ~ThermoviscoelasticOperator();

    /** $M$, $\int\eta_i\eta_j$. */
    const LinearMap &
    heat_mass() const
    {
      return *maps.heat_mass;
    }

    /** $K+kB+L$, $\int\nabla\eta_i\cdot\nabla\eta_j +
     * k\int_{\Gamma_C}\eta_i\eta_j$ and the lateral heat exchange. */
    const LinearMap &
    conduction() const
    {
      return *maps.conduction;
    }

    /** $L$; of scenes with a lateral heat exchange, (D1.5). */
    const LinearMap &
    lateral_exchange() const
    {
      return *maps.lateral_exchange;
    }

    /** $D$, $\int\eta_i\,\mathrm{div}\,\varphi_j$; temperature rows,
     * displacement columns. */
    const LinearMap &
    divergence() const
    {
      return *maps.divergence;
    }

    /** $D^T$; displacement rows, temperature columns. */
    const LinearMap &
    thermal_stress() const
    {
      return *maps.thermal_stress;
    }

    /** $M_u$, without the inertia coefficient $b$. */
    const LinearMap &
    momentum_mass() const
    {
      return *maps.momentum_mass;
    }

    /** $S$, $\int C{:}\varepsilon(\varphi_i){:}\varepsilon(\varphi_j)$. */
    const LinearMap &
    stiffness() const
    {
      return *maps.stiffness;
    }

    /**
     * $S_\zeta$, without the viscosity $\zeta$: $S$, but where the contact
     * nodes have no viscous stress (C6.1).
     */
    const LinearMap &
    viscous_stiffness() const
    {
      return has_own_viscous_stiffness ? *maps.viscous_stiffness : stiffness();
    }

    /** The matrices; of scenes that have them. */
    const FieldMatrices<dim> &
    field_matrices() const
    {
      return *matrices;
    }

    /** Products without matrices; null for scenes that have matrices. */
    const MatrixFreeOperator<dim> *
    matrix_free() const
    {
      return matrix_free_.get();
    }

    /** The matrices of a rod in one process; else null. */
    const RodMatrices *
    rod() const
    {
      return matrices != nullptr ? matrices->rod.get() : nullptr;
    }

    /** Whether stage matrices are to be eliminated by the blocks of rod(). */
    bool
    is_eliminated_along_rod() const
    {
      return rod() != nullptr && is_along_rod;
    }

    const Material &
    coefficients() const
    {
      return material;
    }

    /** True if the motion heats the body: one stage matrix for both fields. */
    bool
    is_coupled() const
    {
      return material.has_heating();
    }

    /**
     * Matrix of the heat block of a stage, $M+\tau(K+kB)$,
     * doc/discretisation.md (D2.2).
     */
    SparseMatrix
    heat_stage_matrix(const double tau) const;

    /** $K+kB+L$ with constrained rows, of scenes that have matrices. */
    SparseMatrix
    conduction_matrix() const;

    /** Matrix of the momentum block, $bM_u+\tau\zeta S_\zeta+\tau^2S$. */
    SparseMatrix
    momentum_stage_matrix(const double tau) const;

    /**
     * The whole stage matrix in the numbering of the whole system, of a scene
     * with thermal stress: (D2.2) for the unknowns $(\tau\theta',v)$ with its
     * first row times $\tau$.
     */
    SparseMatrix
    stage_matrix(const double tau) const;

    /**
     * Right-hand side of a stage (D2.2) without contact: @p heat
     * $\ell_\theta-(K+kB)\tilde\theta$ and @p momentum $bM_u\tilde v +
     * \tau(\ell_u-S\tilde u+aD^T\tilde\theta)$; constrained rows are zero.
     */
    void
    stage_rhs(const State  &known,
              const double  tau,
              const Vector &heat_load,
              const Vector &momentum_load,
              Vector       &heat,
              Vector       &momentum) const;

    /**
     * What is left of the momentum equation (D1.2) without contact,
     * $\ell_u-Su+aD^T\theta-\zeta S_\zeta v-bM_uv'$, in all rows: in
     * constrained ones it is minus the force that moves them.
     *
     * @param velocity,acceleration null: their terms are left out
     */
    void
    momentum_residual(const State  &state,
                      const Vector *velocity,
                      const Vector *acceleration,
                      const Vector &momentum_load,
                      Vector       &residual) const;

    /**
     * Takes the product of the matrix of a stage of length @p tau, (D2.1), with
     * rates from its right-hand side; constrained rows become zero.
     */
    void
    subtract_stage_product(const double  tau,
                           const Vector &temperature_rate,
                           const Vector &velocity,
                           Vector       &heat,
                           Vector       &momentum) const;

    /** @p heat $-= aDv$, with zero constrained rows. */
    void
    subtract_heating(const Vector &velocity, Vector &heat) const;

    /** @p momentum $+=$ @p factor $aD^T\theta$, with zero constrained rows. */
    void
    add_thermal_stress(const Vector &temperature,
                       const double  factor,
                       Vector       &momentum) const;

    /** Sets the entries of constrained degrees of freedom to zero. */
    void
    zero_constrained(const Field::Block field, Vector &vector) const;

  private:
    const Discretization<dim>                      &discretization;
    const Material                                 &material;
    const bool                                      has_own_viscous_stiffness;
    const bool                                      is_along_rod;
    const std::unique_ptr<const FieldMatrices<dim>> own_matrices;
    /** One of the two is there. */
    const FieldMatrices<dim> *const                      matrices;
    const std::unique_ptr<const MatrixFreeOperator<dim>> matrix_free_;
    const FieldMaps                                      maps;
    mutable Vector                                       heat_scratch;
    mutable Vector                                       momentum_scratch;

    /** stage_rhs() by one pass over the rod for each field. */
    void
    rod_stage_rhs(const State  &known,
                  const double  tau,
                  const Vector &heat_load,
                  const Vector &momentum_load,
                  Vector       &heat,
                  Vector       &momentum) const;

    /** Weighted sum of two matrices of a block, with constrained rows. */
    SparseMatrix
    combine(const SparseMatrix &first,
            const double        first_factor,
            const SparseMatrix &second,
            const double        second_factor,
            const Field::Block  field) const;
  };
} // namespace ThermoContact

#endif
