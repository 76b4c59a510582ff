// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef thermocontact_space_nonlinear_body_h
#define thermocontact_space_nonlinear_body_h

#include <thermocontact/space/nonlinear_terms.h>

#include <array>
#include <functional>
#include <memory>
#include <vector>

namespace ThermoContact
{
  /** NonlinearTerms of a body in two or three dimensions, (M10.9). */
  template <int dim>
  class NonlinearBody : public NonlinearTerms<dim>
  {
  public:
    using typename NonlinearTerms<dim>::Operator;

    /** All arguments are borrowed. */
    NonlinearBody(const Scene &scene, const Operator &equations);

    ~NonlinearBody() override;

    void
    subtract(const State &state,
             const Rates &rates,
             Vector      &heat,
             Vector      &momentum) const override;

    std::unique_ptr<const Operator>
    linearize(const State &state,
              const Rates &rates,
              Vector      &heat,
              Vector      &momentum) const override;

    std::unique_ptr<const Operator>
    at(const Vector &temperature) const override;

  private:
    const SceneFields         &fields;
    const Material            &material;
    const Operator            &equations;
    const Discretization<dim> &discretization;

    /** Places of the unknowns of a field among those of a cell. */
    std::array<std::vector<unsigned int>, 2> places;

    /** What is known of a point of a cell. */
    struct Known
    {
      std::array<double, 3>        place;
      MaterialCoefficients::Values values;  ///< at $\theta=0$
      EquationFactors              at_zero; ///< likewise
      Elasticity                   elasticity;
    };

    /** For each cell of this rank its points of the mass, then the others. */
    std::vector<Known> known;

    /** A point, and the body there. */
    struct Point;

    /** Quadratures of a cell, with the functions of the last one. */
    struct Rules;

    const std::unique_ptr<Rules> rules;

    using Cell    = typename FieldMatrices<dim>::Cell;
    using AtPoint = std::function<void(const Point &)>;
    using AtCell  = std::function<void(const Cell &)>;

    /** Calls @p action with all cells of the body on this rank. */
    void
    for_each_cell(const AtCell &action) const;

    /** Calls the functions at the points of the mass, then at the others of
     * each cell, then for it. Collective; throws as subtract(). */
    void
    visit(const State   &state,
          const Rates   &rates,
          const AtPoint &at_mass,
          const AtPoint &at_rest,
          const AtCell  &at_cell) const;

    /** Adds the parts of a cell to the residual of its unknowns. */
    void
    add_mass_residual(const Point &at, dealii::Vector<double> &residual) const;

    void
    add_residual(const Point &at, dealii::Vector<double> &residual) const;

    /** A residual that cells are added to. */
    class Residual;

    /**
     * @param with_slopes with the derivatives of the coefficients
     * @param residual is added to; null: none is wanted
     */
    std::unique_ptr<const Operator>
    operator_at(const State &state,
                const Rates &rates,
                const bool   with_slopes,
                Residual    *residual) const;
  };
} // namespace ThermoContact

#endif
