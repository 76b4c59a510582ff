// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef thermocontact_space_nonlinear_rod_h
#define thermocontact_space_nonlinear_rod_h

#include <thermocontact/rod/rod_matrices.h>
#include <thermocontact/space/nonlinear_terms.h>

#include <vector>

namespace ThermoContact
{
  /** NonlinearTerms of rods of a row. */
  class NonlinearRod : public NonlinearTerms<1>
  {
  public:
    /** Both are borrowed. */
    NonlinearRod(const Scene &scene, const Operator &equations);

    void
    subtract(const State &state,
             const Rates &rates,
             Vector      &heat,
             Vector      &momentum) const override;

    std::unique_ptr<const Operator>
    linearize(const State &state,
              const Rates &rates,
              Vector      &heat,
              Vector      &momentum) const override
    {
      subtract(state, rates, heat, momentum);
      return operator_at(state, rates, true);
    }

    std::unique_ptr<const Operator>
    at(const Vector &temperature) const override;

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
      std::vector<EquationFactors> of_mass, of_rest;
    };

    const SceneFields &fields;
    const BodyRow     &row;
    const Material    &material;
    const Operator    &equations;
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
    visit(const Cell   &cell,
          const State  &state,
          const Rates  &rates,
          const bool    with_slopes,
          const AtMass &at_mass,
          const AtRest &at_rest) const;

    /** @param with_slopes with the derivatives of the coefficients */
    std::unique_ptr<const Operator>
    operator_at(const State &state,
                const Rates &rates,
                const bool   with_slopes) const;
  };
} // namespace ThermoContact

#endif
