// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef thermocontact_space_expression_function_h
#define thermocontact_space_expression_function_h

#include <thermocontact/input/expression.h>

#include <deal.II/base/function.h>

#include <array>
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

    double
    value(const Point<dim>  &place,
          const unsigned int component = 0) const override
    {
      std::array<double, 4> variables{};
      for (unsigned int d = 0; d < dim; ++d)
        variables[d] = place[d];
      variables.back() = this->get_time();
      return components_[component].evaluate(variables.data());
    }

  private:
    const std::vector<Expression> components_;
  };
} // namespace ThermoContact

#endif
