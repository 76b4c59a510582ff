// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef thermocontact_space_nonlinear_rod_h
#define thermocontact_space_nonlinear_rod_h

#include <thermocontact/base/types.h>
#include <thermocontact/rod/rod_matrices.h>
#include <thermocontact/scene/scene.h>

#include <memory>
#include <vector>

namespace ThermoContact
{
  /**
   * The integrand of $R_u$, (M10.8).
   *
   * @param beyond BodyRow::beyond_zero()
   * @param strain,strain_rate $u_x$, $v_x$
   */
  double
  added_stress(const Material        &material,
               const RodCoefficients &beyond,
               const double           theta,
               const double           strain,
               const double           strain_rate);



  /**
   * Rods of a row whose coefficients depend on the temperature, (M10.8). The
   * matrices of the body have the coefficients at $\theta=0$; the difference
   * is here, integrated with the rules of the matrices:
   * @f[
   *   R_\theta = \int (c-c_0)\theta'\eta + (K-K_0)\theta_x\eta_x
   *     + (a-a_0)v_x\eta, \quad
   *   R_u = \int \bigl((E-E_0)u_x + (E\zeta-E_0\zeta_0)v_x
   *     - (a-a_0)\theta\bigr)\varphi_x .
   * @f]
   *
   * All is nondimensional; vectors are those of Discretization::make_vector().
   */
  class NonlinearRod
  {
  public:
    /**
     * @param scene borrowed
     * @param matrices of the body, borrowed
     */
    NonlinearRod(const Scene &scene, const RodMatrices &matrices);

    /** The body at an instant; velocities and rates with those of its ends. */
    struct Instant
    {
      const Vector &temperature;
      const Vector &temperature_rate;
      const Vector &displacement;
      const Vector &velocity;
    };

    /**
     * @p heat $-=R_\theta$, @p momentum $-=R_u$.
     *
     * @throw InputError if a coefficient has a value that is not allowed
     */
    void
    subtract(const Instant &instant, Vector &heat, Vector &momentum) const;

    /**
     * The matrices with all derivatives of $R$, those in $\theta$ and $u$ as
     * conduction, stiffness and thermal stress, so that they make the tangent
     * of a stage as the matrices make the stage. The derivative of the stress
     * in the temperature is left out where there is no thermal stress: the
     * temperature is then known before the motion.
     *
     * @throw InputError as subtract()
     */
    std::unique_ptr<const RodMatrices>
    tangents(const Instant &instant) const
    {
      return matrices_at(instant, true);
    }

    /** The matrices with the coefficients at this temperature. */
    std::unique_ptr<const RodMatrices>
    at(const Vector &temperature) const;

  private:
    /** A quadrature point of a cell, on [0, 1]. */
    struct Point
    {
      double              place, weight;
      std::vector<double> value, slope; ///< of the basis
    };

    /** A cell with such coefficients. */
    struct Cell
    {
      unsigned int number;
      double       size, begin; ///< in the rod

      const RodProfile *profile;

      /** At $\theta=0$, at the points of the mass and of the others. */
      std::vector<RodCoefficients> of_mass, of_rest;
    };

    const SceneFields &fields;
    const BodyRow     &row;
    const Material    &material;
    const RodMatrices &matrices;
    std::vector<Point> mass_points, points;
    std::vector<Cell>  cells;

    /** The body at a point of a cell. */
    struct Local
    {
      double theta, theta_x, rate, strain, strain_rate;
    };

    /**
     * Calls @p at_mass and @p at_rest with the point, its weight, the body
     * there and BodyRow::beyond_zero(), for all points of the cell.
     *
     * @param with_slopes with the derivatives of the coefficients; else 0
     */
    template <typename AtMass, typename AtRest>
    void
    visit(const Cell    &cell,
          const Instant &instant,
          const bool     with_slopes,
          const AtMass  &at_mass,
          const AtRest  &at_rest) const;

    /** @param with_slopes with the derivatives of the coefficients */
    std::unique_ptr<const RodMatrices>
    matrices_at(const Instant &instant, const bool with_slopes) const;
  };
} // namespace ThermoContact

#endif
