// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef thermocontact_space_nonlinear_body_h
#define thermocontact_space_nonlinear_body_h

#include <thermocontact/space/nonlinear_terms.h>

#include <array>
#include <functional>
#include <vector>

namespace ThermoContact
{
  /** NonlinearTerms of a body in two or three dimensions, (M10.9). */
  template <int dim>
  class NonlinearBody : public NonlinearTerms<dim>
  {
  public:
    using typename NonlinearTerms<dim>::Instant;
    using typename NonlinearTerms<dim>::Operator;

    /** All arguments are borrowed. */
    NonlinearBody(const Scene &scene, const Operator &equations);

    void
    subtract(const Instant &instant,
             Vector        &heat,
             Vector        &momentum) const override;

    std::unique_ptr<const Operator>
    tangents(const Instant &instant) const override
    {
      return operator_at(instant, true);
    }

    std::unique_ptr<const Operator>
    at(const Vector &temperature) const override;

  private:
    const SceneFields         &fields;
    const Material            &material;
    const bool                 has_lumped_mass;
    const Operator            &equations;
    const Discretization<dim> &discretization;

    /** Places of the unknowns of a field among those of a cell. */
    std::array<std::vector<unsigned int>, 2> places;

    /** A point of a cell, and the body there. */
    struct Point;

    using AtPoint = std::function<void(const Point &)>;
    using AtCell =
      std::function<void(const typename FieldMatrices<dim>::Cell &)>;

    /** Calls the functions at all points of each cell of this rank, those of
     * the mass and all others, and after these for the cell. */
    void
    visit(const Instant &instant,
          const AtPoint &at_mass,
          const AtPoint &at_rest,
          const AtCell  &at_cell) const;

    /** @param with_slopes with the derivatives of the coefficients */
    std::unique_ptr<const Operator>
    operator_at(const Instant &instant, const bool with_slopes) const;
  };
} // namespace ThermoContact

#endif
