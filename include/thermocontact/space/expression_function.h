// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef thermocontact_space_expression_function_h
#define thermocontact_space_expression_function_h

#include <thermocontact/input/expression.h>
#include <thermocontact/input/jet.h>

#include <deal.II/base/function.h>

#include <array>
#include <cmath>
#include <utility>
#include <vector>

namespace ThermoContact
{
  using dealii::Function;
  using dealii::Point;

  /** Expressions in x, y, z, t as a function of deal.II, one each component. */
  template <int dim>
  class ExpressionFunction : public Function<dim>
  {
  public:
    explicit ExpressionFunction(std::vector<Expression> components)
      : Function<dim>(components.size())
      , components_(std::move(components))
    {}

    const std::vector<Expression> &
    components() const
    {
      return components_;
    }

    /** Whether values are those of the derivatives in time, 0 for infinite. */
    void
    set_is_rate(const bool is_rate)
    {
      this->is_rate = is_rate;
    }

    double
    value(const Point<dim>  &place,
          const unsigned int component = 0) const override
    {
      if (!is_rate)
        return evaluate(place, component, this->get_time());
      const double rate =
        evaluate(place, component, NumberJet(this->get_time(), 1., 0.)).first;
      return std::isfinite(rate) ? rate : 0.;
    }

  private:
    const std::vector<Expression> components_;
    bool                          is_rate = false;

    template <typename Number>
    Number
    evaluate(const Point<dim>  &place,
             const unsigned int component,
             const Number      &time) const
    {
      std::array<Number, 4> variables;
      for (unsigned int d = 0; d < 3; ++d)
        variables[d] = Number(d < dim ? place[d < dim ? d : 0] : 0.);
      variables.back() = time;
      return components_[component].evaluate(variables.data());
    }
  };
} // namespace ThermoContact

#endif
