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
   * The field matrices are those of FieldMaps, without constraints; the
   * constrained rows of stage matrices and right-hand sides say that rates
   * vanish. Vectors come from Discretization::make_vector().
   */
  template <int dim>
  class ThermoviscoelasticOperator : public FieldMaps
  {
  public:
    /**
     * All arguments are borrowed and must outlive this object.
     *
     * @param matrices null for scenes that have none
     */
    ThermoviscoelasticOperator(const Scene               &scene,
                               const Discretization<dim> &discretization,
                               const FieldMatrices<dim>  *matrices);

    ~ThermoviscoelasticOperator();

    /** Products without matrices; null for scenes that have matrices. */
    const CellProducts<dim, double> *
    cell_products() const
    {
      return cell_products_.get();
    }

    /** The matrices of a rod; else null. */
    const RodMatrices *
    rod() const
    {
      return matrices != nullptr ? matrices->rod() : nullptr;
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
     * Matrix of the heat block of a stage, @p mass $M+\tau(K+kB+L)$,
     * doc/discretisation.md (D2.2), with constrained rows.
     */
    SparseMatrix
    heat_stage_matrix(const double tau, const double mass = 1.) const;

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
     * Right-hand side of a stage (D2.2) without contact, with constrained rows
     * zero.
     *
     * @param heat becomes $\ell_\theta-(K+kB)\tilde\theta$
     * @param momentum becomes
     *   $bM_u\tilde v+\tau(\ell_u-S\tilde u+aD^T\tilde\theta)$
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
    const Discretization<dim> &discretization;
    const Material            &material;
    const bool                 has_own_viscous_stiffness;
    const bool                 is_along_rod;
    /** One of the two is there. */
    const FieldMatrices<dim> *const                        matrices;
    const std::unique_ptr<const CellProducts<dim, double>> cell_products_;
    mutable Vector                                         heat_scratch;
    mutable Vector                                         momentum_scratch;

    /** stage_rhs() by one pass over the rod for each field. */
    void
    rod_stage_rhs(const State  &known,
                  const double  tau,
                  const Vector &heat_load,
                  const Vector &momentum_load,
                  Vector       &heat,
                  Vector       &momentum) const;

    /** Weighted sum of matrices of a field, with constrained rows. */
    SparseMatrix
    sum(const Field::Block                                       field,
        const std::vector<std::pair<double, FieldMatrix::Kind>> &terms) const;
  };
} // namespace ThermoContact

#endif
