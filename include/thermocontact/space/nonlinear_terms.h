// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef thermocontact_space_nonlinear_terms_h
#define thermocontact_space_nonlinear_terms_h

#include <thermocontact/base/types.h>
#include <thermocontact/scene/scene.h>
#include <thermocontact/space/state.h>
#include <thermocontact/space/thermoviscoelastic_operator.h>

#include <memory>

namespace ThermoContact
{
  /**
   * Terms of coefficients that depend on the temperature, (M10.8). The matrices
   * of the body have the coefficients at $\theta=0$; the difference is here,
   * integrated with the rules of the matrices:
   * @f[
   *   R_\theta = \int (c-c_0)\theta'\eta + (K-K_0)\nabla\theta\cdot\nabla\eta
   *     + (a-a_0)\,\mathrm{div}\,v\,\eta, \quad
   *   R_u = \int \bigl((E-E_0)\,C\varepsilon(u)
   *     + (E\zeta-E_0\zeta_0)\,C\varepsilon(v)
   *     - (a-a_0)\theta I\bigr):\varepsilon(\varphi) .
   * @f]
   *
   * All is nondimensional; vectors are those of Discretization::make_vector().
   */
  template <int dim>
  class NonlinearTerms
  {
  public:
    virtual ~NonlinearTerms() = default;

    /**
     * @p heat $-=R_\theta$, @p momentum $-=R_u$. Collective.
     *
     * @param state temperature and displacement; vectors without entries, as
     *   in the rates, are zero
     * @param rates of the temperature, and the velocity, with those of driven
     *   ends
     * @throw InputError on all ranks if a value is not allowed; heat and
     *   momentum mean nothing then
     */
    virtual void
    subtract(const State &state,
             const Rates &rates,
             Vector      &heat,
             Vector      &momentum) const = 0;

    using Operator = ThermoviscoelasticOperator<dim>;

    /**
     * subtract(), and the equations with the derivatives of $R$ added, in
     * $\theta$ and $u$ to conduction, stiffness and thermal stress:
     * stage_coefficients() give the tangent of a stage. Collective. The
     * derivative of the stress in the temperature is left out where there is no
     * thermal stress: the temperature is then known before the motion.
     *
     * @throw InputError as subtract()
     */
    virtual std::unique_ptr<const Operator>
    linearize(const State &state,
              const Rates &rates,
              Vector      &heat,
              Vector      &momentum) const = 0;

    /** The equations at this temperature; throws as subtract(). Collective. */
    virtual std::unique_ptr<const Operator>
    at(const Vector &temperature) const = 0;
  };



  /**
   * The stress of these coefficients or a component of it, nondimensional,
   * tension positive: with what they are beyond $\theta=0$ the one in $R_u$.
   *
   * @param thermal $\theta I$, or its component
   * @param elastic,of_rate $C\varepsilon$ of the displacement and the velocity
   */
  template <typename Stress>
  Stress
  stress_of(const Material        &material,
            const EquationFactors &coefficients,
            const Stress          &thermal,
            const Stress          &elastic,
            const Stress          &of_rate)
  {
    return coefficients.stiffness * elastic +
           material.viscosity * coefficients.viscosity * of_rate -
           material.thermal_stress * coefficients.coupling * thermal;
  }



  /**
   * @param equations of the body, borrowed like the scene
   * @return null if no coefficient depends on the temperature
   */
  template <int dim>
  std::unique_ptr<const NonlinearTerms<dim>>
  make_nonlinear_terms(const Scene                           &scene,
                       const ThermoviscoelasticOperator<dim> &equations);
} // namespace ThermoContact

#endif
