// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef thermocontact_space_thermoviscoelastic_operator_h
#define thermocontact_space_thermoviscoelastic_operator_h

#include <thermocontact/base/types.h>
#include <thermocontact/scene/scene.h>
#include <thermocontact/space/discretization.h>
#include <thermocontact/space/field_maps.h>
#include <thermocontact/space/field_matrices.h>
#include <thermocontact/space/state.h>
#include <thermocontact/space/system_coefficients.h>

#include <array>

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
   * constrained rows of systems and right-hand sides say that rates vanish.
   * Vectors come from Discretization::make_vector().
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

    /** The same equations with other matrices, which it takes over: such as
     * tangents of coefficients of the temperature. */
    ThermoviscoelasticOperator(const ThermoviscoelasticOperator  &other,
                               std::unique_ptr<const RodMatrices> rod);

    /** The same of a body of several dimensions. */
    ThermoviscoelasticOperator(
      const ThermoviscoelasticOperator         &other,
      std::unique_ptr<const FieldMatrices<dim>> matrices);

    ~ThermoviscoelasticOperator();

    const Discretization<dim> &
    space() const
    {
      return discretization;
    }

    /** Null for scenes that have none. */
    const FieldMatrices<dim> *
    matrices() const
    {
      return matrices_;
    }

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
      return own_rod              ? own_rod.get() :
             matrices_ != nullptr ? matrices_->rod() :
                                    nullptr;
    }

    /** Whether systems are to be eliminated by the blocks of rod(). */
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
     * The product with the matrix of a system. Rows of a field that is not part
     * of it do not change, and constrained rows become zero.
     *
     * @param temperature,displacement its unknowns, e.g. $\theta'$, $v$
     * @param heat,momentum out
     */
    void
    product(const SystemCoefficients &coefficients,
            const Vector             &temperature,
            const Vector             &displacement,
            Vector                   &heat,
            Vector                   &momentum) const;

    /** The same of a system without the other field, @p y $=A$ @p x. */
    void
    product(const SystemCoefficients &coefficients,
            const Field::Block        field,
            const Vector             &x,
            Vector                   &y) const;

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
     * The residual of the momentum equation (D1.2) without contact,
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
     * The residual of the heat equation (D1.1),
     * $M\theta'+(K+kB)\theta+aDv-\ell_\theta$, in all rows: in constrained ones
     * it is the heat that flows in.
     *
     * @param temperature_rate $\theta'$
     */
    void
    heat_residual(const State  &state,
                  const Vector &temperature_rate,
                  const Vector &heat_load,
                  Vector       &residual) const;

    /** @p heat $+=$ @p factor $aDv$, with zero constrained rows. */
    void
    add_heating(const Vector &velocity,
                const double  factor,
                Vector       &heat) const;

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
    const bool                                      is_along_rod;
    const std::unique_ptr<const FieldMatrices<dim>> own_matrices; ///< or null
    /** One of the two is there. */
    const FieldMatrices<dim> *const                        matrices_;
    const std::unique_ptr<const CellProducts<dim, double>> cell_products_;
    const std::unique_ptr<const RodMatrices>               own_rod; ///< or null
    mutable Vector                                         heat_scratch;
    mutable Vector                                         momentum_scratch;

    /** A product that is added to a sum unless its factor is zero. */
    struct Term
    {
      double           factor = 0.;
      const LinearMap *map    = nullptr;
      const Vector    *x      = nullptr;
    };

    /**
     * @p y = the sum of the terms, and @p factor times @p base where that is
     * not null; in one pass over a rod. @p y is none of the other vectors.
     *
     * @param field of the rows
     */
    void
    set_sum(const std::array<Term, 3> &terms,
            const double               factor,
            const Vector              *base,
            const Field::Block         field,
            Vector                    &y) const;
  };
} // namespace ThermoContact

#endif
