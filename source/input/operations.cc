// SPDX-License-Identifier: LGPL-2.1-or-later

#include <thermocontact/input/operations.h>

#include <deal.II/base/numbers.h>

#include <type_traits>

namespace ThermoContact
{
  namespace
  {
    // ---------------------------------------------------- powers and angles

    /** Whole powers that are small are products. */
    double
    power(const double a, const double b)
    {
      return b == 2. ? a * a :
             b == 3. ? a * a * a :
             b == 4. ? a * a * a * a :
                       std::pow(a, b);
    }

    template <typename Number>
    Jet<Number>
    power(const Jet<Number> &a, const Jet<Number> &b)
    {
      using std::exp;
      if (Interval(b.value).width() == 0. && Interval(b.first).width() == 0. &&
          Interval(b.first).contains(0.))
        return constant_power(a, Interval(b.value).low);
      const Number slope = 1. / a.value;
      const auto   exponent =
        b *
        chain(a, monotone(std::log, a.value), slope, Number(-square(slope)));
      const Number value  = exp(exponent.value);
      Jet<Number>  result = chain(exponent, value, value, value);
      if constexpr (std::is_same_v<Number, double>)
        result.value = std::pow(a.value, b.value);
      return result;
    }

    double
    angle(const double y, const double x)
    {
      return std::atan2(y, x);
    }

    Interval
    angle(const Interval &y, const Interval &x)
    {
      if (x.low <= 0. && y.contains(0.))
        return Interval::everything(); // the origin, or the branch cut
      return hull(widened(std::atan2(y.low, x.low), std::atan2(y.high, x.high)),
                  widened(std::atan2(y.low, x.high),
                          std::atan2(y.high, x.low)));
    }

    template <typename Number>
    Jet<Number>
    angle(const Jet<Number> &y, const Jet<Number> &x)
    {
      const Number n  = x.value * y.first - y.value * x.first;
      const Number n1 = x.value * y.second - y.value * x.second;
      const Number r  = square(x.value) + square(y.value);
      const Number r1 = 2. * (x.value * x.first + y.value * y.first);
      return {angle(y.value, x.value), n / r, (n1 * r - n * r1) / square(r)};
    }



    // ------------------------------------------------------- jumps and kinks

    double
    value_of(const double x)
    {
      return x;
    }

    template <typename Number>
    const Number &
    value_of(const Jet<Number> &x)
    {
      return x.value;
    }

    /** False for one that is the same all along the variable. */
    bool
    varies(const IntervalJet &x)
    {
      return x.first.low != 0. || x.first.high != 0.;
    }

    /**
     * One or the other; where @p takes_a is open both. If nothing that it
     * depends on varies along the variable there is no jump: all along it is
     * the one or all along the other.
     */
    IntervalJet
    choose(const boost::tribool takes_a,
           const IntervalJet   &a,
           const IntervalJet   &b,
           const bool           may_jump)
    {
      if (!boost::indeterminate(takes_a))
        return takes_a ? a : b;
      if (may_jump)
        return {hull(a.value, b.value),
                Interval::everything(),
                Interval::everything()};
      return {hull(a.value, b.value),
              hull(a.first, b.first),
              hull(a.second, b.second)};
    }

    template <typename Number>
    const Number &
    choose(const boost::tribool takes_a,
           const Number        &a,
           const Number        &b,
           const bool)
    {
      return takes_a ? a : b;
    }

    /** A number decides. */
    template <typename Number>
    bool
    varies(const Number &)
    {
      return false;
    }

    /** The smaller or the larger one of two. */
    template <typename Number>
    Number
    extremum(const Number &a, const Number &b, const bool is_larger)
    {
      const boost::tribool takes_b =
        is_larger ? value_of(a) < value_of(b) : value_of(b) < value_of(a);
      if constexpr (std::is_same_v<Number, IntervalJet>)
        if (boost::indeterminate(takes_b))
          {
            const auto of = [is_larger](const double x, const double y) {
              return is_larger ? std::max(x, y) : std::min(x, y);
            };
            return {{of(a.value.low, b.value.low),
                     of(a.value.high, b.value.high)},
                    hull(a.first, b.first),
                    varies(a - b) ? Interval::everything() :
                                    hull(a.second, b.second)};
          }
      return takes_b ? b : a;
    }



    // ------------------------------------------------------------- the list

    /** The operations while they are listed. */
    struct OperationList
    {
      std::vector<Operation> operations;

      /** @param form of any kind of number */
      template <typename Form>
      void
      add(const std::string &name,
          const unsigned int n_operands,
          const unsigned int level,
          const Form        &form)
      {
        operations.push_back({name, n_operands, level, {form, form, form}});
      }

      template <typename Form>
      void
      function(const std::string &name,
               const unsigned int n_operands,
               const Form        &form)
      {
        add(name, n_operands, Operation::is_function, form);
      }

      /** @param is_so true, false or undecided, of the values of two operands
       */
      template <typename Condition>
      void
      condition(const std::string &sign,
                const unsigned int level,
                const Condition   &is_so)
      {
        add(sign, 2, level, [is_so](const auto *x) {
          using Number = std::decay_t<decltype(*x)>;
          return Number(choose(is_so(value_of(x[0]), value_of(x[1])),
                               Number(1.),
                               Number(0.),
                               varies(x[0]) || varies(x[1])));
        });
      }

      /**
       * A smooth function.
       *
       * @param derivatives the function, its first and its second derivative at
       *   a number or in an interval
       * @return its form
       */
      template <typename Derivatives>
      auto
      smooth(const std::string &name,
             double (*number)(double),
             const Derivatives &derivatives)
      {
        const auto form = [number, derivatives](const auto *x) {
          if constexpr (std::is_same_v<decltype(x), const double *>)
            return number(*x);
          else
            {
              const auto f = derivatives(x->value);
              return chain(*x, f.value, f.first, f.second);
            }
        };
        function(name, 1, form);
        return form;
      }

      /** A logarithm, whose base has the natural logarithm @p base. */
      void
      logarithm(const std::string &name,
                double (*number)(double),
                const double base)
      {
        smooth(name, number, [number, base](const auto &v) {
          const auto slope = 1. / (base * v);
          return Jet(monotone(number, v), slope, -base * square(slope));
        });
      }

      /** One that is constant but for its jumps, at which it grows. */
      void
      steps(const std::string &name, double (*number)(double))
      {
        function(name, 1, [number](const auto *x) {
          using Number = std::decay_t<decltype(*x)>;
          if constexpr (std::is_same_v<Number, IntervalJet>)
            {
              const Interval value(number(x->value.low), number(x->value.high));
              const Interval slope = value.width() == 0. || !varies(*x) ?
                                       Interval(0.) :
                                       Interval::everything();
              return IntervalJet(value, slope, slope);
            }
          else
            return Number(number(value_of(*x)));
        });
      }
    };



    std::vector<Operation>
    list_operations()
    {
      using std::cos;
      using std::cosh;
      using std::exp;
      using std::pow;
      using std::sin;
      using std::sqrt;
      using std::tan;
      OperationList list;

      const auto any = [](const auto &a, const auto &b) {
        return !(a == 0.) || !(b == 0.);
      };
      const auto all = [](const auto &a, const auto &b) {
        return !(a == 0.) && !(b == 0.);
      };
      list.condition("||", 0, any);
      list.condition("|", 0, any);
      list.condition("&&", 1, all);
      list.condition("&", 1, all);
      const auto less  = [](const auto &a, const auto &b) { return a < b; };
      const auto equal = [](const auto &a, const auto &b) { return a == b; };
      list.condition("<=", 2, [=](const auto &a, const auto &b) {
        return !less(b, a);
      });
      list.condition(">=", 2, [=](const auto &a, const auto &b) {
        return !less(a, b);
      });
      list.condition("==", 2, equal);
      list.condition("!=", 2, [=](const auto &a, const auto &b) {
        return !equal(a, b);
      });
      list.condition("<", 2, less);
      list.condition(">", 2, [=](const auto &a, const auto &b) {
        return less(b, a);
      });
      const auto plus   = [](const auto *x) { return x[0] + x[1]; };
      const auto raised = [](const auto *x) { return power(x[0], x[1]); };
      list.add("+", 2, 3, plus);
      list.add("-", 2, 3, [](const auto *x) { return x[0] - x[1]; });
      list.add("*", 2, 4, [](const auto *x) { return x[0] * x[1]; });
      list.add("/", 2, 4, [](const auto *x) { return x[0] / x[1]; });
      list.add("^", 2, Operation::n_levels, raised);

      list.function("pow", 2, raised);
      list.function("sum", 0, plus);
      list.function("avg", 0, plus);
      list.function("min", 0, [](const auto *x) {
        return extremum(x[0], x[1], false);
      });
      list.function("max", 0, [](const auto *x) {
        return extremum(x[0], x[1], true);
      });
      list.function("if", 3, [](const auto *x) {
        return std::decay_t<decltype(*x)>(
          choose(!(value_of(x[0]) == 0.), x[1], x[2], varies(x[0])));
      });
      list.function("abs", 1, [](const auto *x) {
        return extremum(*x, std::decay_t<decltype(*x)>(-*x), true);
      });
      list.function("atan2", 2, [](const auto *x) {
        return angle(x[0], x[1]);
      });
      list.smooth("sqrt", std::sqrt, [](const auto &v) {
        return Jet(pow(v, 0.5),
                   slope_of_power(v, 0.5, -0.5),
                   slope_of_power(v, -0.25, -1.5));
      });

      const auto sine   = list.smooth("sin", std::sin, [](const auto &v) {
        return Jet(sin(v), cos(v), -sin(v));
      });
      const auto cosine = list.smooth("cos", std::cos, [](const auto &v) {
        return Jet(cos(v), -sin(v), -cos(v));
      });
      list.smooth("tan", std::tan, [](const auto &v) {
        const auto t = tan(v), slope = 1. + square(t);
        return Jet(t, slope, 2. * (t * slope));
      });
      list.function("sec", 1, [=](const auto *x) {
        return std::decay_t<decltype(*x)>(1.) / cosine(x);
      });
      list.function("csc", 1, [=](const auto *x) {
        return std::decay_t<decltype(*x)>(1.) / sine(x);
      });
      list.function("cot", 1, [=](const auto *x) {
        return cosine(x) / sine(x);
      });
      list.smooth("asin", std::asin, [](const auto &v) {
        const auto d = 1. / sqrt(1. - square(v));
        return Jet(monotone(std::asin, v), d, v * (d * square(d)));
      });
      list.smooth("acos", std::acos, [](const auto &v) {
        const auto d = -1. / sqrt(1. - square(v));
        return Jet(monotone(std::acos, v), d, v * (d * square(d)));
      });
      list.smooth("atan", std::atan, [](const auto &v) {
        const auto d = 1. / (1. + square(v));
        return Jet(monotone(std::atan, v), d, -2. * (v * square(d)));
      });
      list.smooth("sinh", std::sinh, [](const auto &v) {
        const auto value = monotone(std::sinh, v);
        return Jet(value, cosh(v), value);
      });
      list.smooth("cosh", std::cosh, [](const auto &v) {
        return Jet(cosh(v), monotone(std::sinh, v), cosh(v));
      });
      list.smooth("tanh", std::tanh, [](const auto &v) {
        // of intervals 1 - tanh^2 would not vanish far from zero
        const auto t = monotone(std::tanh, v), d = 1. / square(cosh(v));
        return Jet(t, d, -2. * (t * d));
      });
      list.smooth("asinh", std::asinh, [](const auto &v) {
        const auto d = 1. / sqrt(1. + square(v));
        return Jet(monotone(std::asinh, v), d, -v * (d * square(d)));
      });
      list.smooth("acosh", std::acosh, [](const auto &v) {
        const auto d = 1. / sqrt(square(v) - 1.);
        return Jet(monotone(std::acosh, v), d, -v * (d * square(d)));
      });
      list.smooth("atanh", std::atanh, [](const auto &v) {
        const auto d = 1. / (1. - square(v));
        return Jet(monotone(std::atanh, v), d, 2. * (v * square(d)));
      });
      list.smooth("exp", std::exp, [](const auto &v) {
        return Jet(exp(v), exp(v), exp(v));
      });
      list.logarithm("log", std::log, 1.);
      list.logarithm("ln", std::log, 1.);
      list.logarithm("log2", std::log2, std::log(2.));
      list.logarithm("log10", std::log10, std::log(10.));
      const double of_erf = 2. / std::sqrt(dealii::numbers::PI);
      list.smooth("erf", std::erf, [of_erf](const auto &v) {
        const auto d = of_erf * exp(-square(v));
        return Jet(monotone(std::erf, v), d, -2. * (v * d));
      });
      list.smooth("erfc", std::erfc, [of_erf](const auto &v) {
        const auto d = -of_erf * exp(-square(v));
        return Jet(monotone(std::erfc, v), d, -2. * (v * d));
      });
      list.steps("sign",
                 [](const double x) -> double { return (x > 0.) - (x < 0.); });
      list.steps("rint", [](const double x) { return std::floor(x + 0.5); });
      list.steps("int", [](const double x) {
        return std::trunc(x + (x >= 0. ? 0.5 : -0.5));
      });
      list.steps("floor", std::floor);
      list.steps("ceil", std::ceil);
      return list.operations;
    }
  } // namespace



  const std::vector<Operation> &
  operations()
  {
    static const std::vector<Operation> all = list_operations();
    return all;
  }



  const Operation *
  find_operation(const std::string &name)
  {
    const auto found =
      std::find_if(operations().begin(),
                   operations().end(),
                   [&](const Operation &one) { return one.name == name; });
    return found == operations().end() ? nullptr : &*found;
  }
} // namespace ThermoContact
