// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef thermocontact_space_expression_function_h
#define thermocontact_space_expression_function_h

#include <thermocontact/input/expression.h>
#include <thermocontact/space/enclosed_function.h>

#include <array>
#include <cmath>
#include <utility>
#include <vector>

namespace ThermoContact
{
  /** Expressions in x, y, z, t as a function of deal.II, one each component. */
  template <int dim>
  class ExpressionFunction : public EnclosedFunction<dim>
  {
  public:
    explicit ExpressionFunction(std::vector<Expression> components)
      : EnclosedFunction<dim>(components.size())
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
        return evaluate<double>(component,
                                this->get_time(),
                                [&](const unsigned int d) { return place[d]; });
      const double rate =
        evaluate<NumberJet>(component,
                            NumberJet(this->get_time(), 1., 0.),
                            [&](const unsigned int d) {
                              return NumberJet(place[d]);
                            })
          .first;
      return std::isfinite(rate) ? rate : 0.;
    }

    bool
    varies_along(const unsigned int direction,
                 const unsigned int component) const override
    {
      return components_[component].depends_on({"xyz"[direction]});
    }

    NumberJet
    derivatives(const Point<dim>  &place,
                const unsigned int direction,
                const unsigned int component) const override
    {
      return evaluate<NumberJet>(
        component, NumberJet(this->get_time()), [&](const unsigned int d) {
          return NumberJet(place[d], d == direction ? 1. : 0., 0.);
        });
    }

    IntervalJet
    enclosure(const BoundingBox<dim> &box,
              const unsigned int      direction,
              const unsigned int      component) const override
    {
      return evaluate<IntervalJet>(
        component, IntervalJet(this->get_time()), [&](const unsigned int d) {
          return IntervalJet(Interval(box.lower_bound(d), box.upper_bound(d)),
                             d == direction ? 1. : 0.,
                             0.);
        });
    }

  private:
    const std::vector<Expression> components_;
    bool                          is_rate = false;

    /** @param coordinate the value of each */
    template <typename Number, typename Coordinate>
    Number
    evaluate(const unsigned int component,
             const Number      &time,
             const Coordinate  &coordinate) const
    {
      std::array<Number, 4> variables{};
      for (unsigned int d = 0; d < dim; ++d)
        variables[d] = coordinate(d);
      variables.back() = time;
      return components_[component].evaluate(variables.data());
    }
  };
} // namespace ThermoContact

#endif
