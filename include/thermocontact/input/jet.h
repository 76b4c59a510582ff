// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef thermocontact_input_jet_h
#define thermocontact_input_jet_h

#include <thermocontact/base/special_numbers.h>
#include <thermocontact/base/tolerances.h>

#include <boost/logic/tribool.hpp>

#include <algorithm>
#include <array>
#include <cmath>

namespace ThermoContact
{
  /**
   * All numbers between two, which may be infinite. An operation on intervals
   * contains what it gives in doubles for any doubles in them: sums and
   * products of doubles are monotone as they are rounded, and functions of the
   * library are widened by their rounding.
   */
  struct Interval
  {
    double low = 0., high = 0.;

    Interval() = default;

    Interval(const double number)
      : low(number)
      , high(number)
    {}

    Interval(const double low, const double high)
      : low(low)
      , high(high)
    {}

    static Interval
    everything()
    {
      return {-infinity, infinity};
    }

    double
    width() const
    {
      return high - low;
    }

    double
    middle() const
    {
      return 0.5 * (low + high);
    }

    /** Largest absolute value. */
    double
    magnitude() const
    {
      return std::max(-low, high);
    }

    bool
    is_finite() const
    {
      return std::isfinite(low) && std::isfinite(high);
    }

    bool
    contains(const double number) const
    {
      return low <= number && number <= high;
    }
  };



  /** The smallest interval that contains both. */
  inline Interval
  hull(const Interval &a, const Interval &b)
  {
    return {std::min(a.low, b.low), std::max(a.high, b.high)};
  }



  /** Between two numbers in any order, widened by the rounding of functions. */
  inline Interval
  widened(const double a, const double b)
  {
    if (!(a == a && b == b))
      return Interval::everything();
    return {std::nextafter(std::min(a, b), -infinity),
            std::nextafter(std::max(a, b), infinity)};
  }



  inline Interval
  operator-(const Interval &a)
  {
    return {-a.high, -a.low};
  }



  inline Interval
  operator+(const Interval &a, const Interval &b)
  {
    const Interval sum(a.low + b.low, a.high + b.high);
    return sum.low <= sum.high ? sum : Interval::everything();
  }



  inline Interval
  operator-(const Interval &a, const Interval &b)
  {
    return a + -b;
  }



  inline Interval
  operator*(const Interval &a, const Interval &b)
  {
    // 0 times infinity is 0: a zero is exact here
    const auto product = [](const double x, const double y) {
      return x == 0. || y == 0. ? 0. : x * y;
    };
    const std::array<double, 4> products{{product(a.low, b.low),
                                          product(a.low, b.high),
                                          product(a.high, b.low),
                                          product(a.high, b.high)}};
    const auto [low, high] =
      std::minmax_element(products.begin(), products.end());
    return {*low, *high};
  }



  inline Interval
  operator/(const Interval &a, const Interval &b)
  {
    if (b.contains(0.))
      return Interval::everything();
    const std::array<double, 4> quotients{
      {a.low / b.low, a.low / b.high, a.high / b.low, a.high / b.high}};
    const auto [low, high] =
      std::minmax_element(quotients.begin(), quotients.end());
    return *low <= *high ? Interval(*low, *high) : Interval::everything();
  }



  /** Never negative, as the product of @p a with itself could be. */
  inline Interval
  square(const Interval &a)
  {
    const double low = std::abs(a.low), high = std::abs(a.high);
    return {a.contains(0.) ? 0. : std::min(low, high) * std::min(low, high),
            std::max(low, high) * std::max(low, high)};
  }



  inline double
  square(const double a)
  {
    return a * a;
  }



  /** Relations that all numbers of intervals have, or none, or some. */
  inline boost::tribool
  operator<(const Interval &a, const Interval &b)
  {
    if (a.high < b.low)
      return true;
    if (a.low >= b.high)
      return false;
    return boost::indeterminate;
  }

  inline boost::tribool
  operator==(const Interval &a, const Interval &b)
  {
    if (a.high < b.low || b.high < a.low)
      return false;
    if (a.low == b.high && a.high == b.low)
      return true;
    return boost::indeterminate;
  }



  /** A monotone function of a number, */
  inline double
  monotone(double (*function)(double), const double a)
  {
    return function(a);
  }

  /** or of an interval; everything where it is not defined at its ends. */
  inline Interval
  monotone(double (*function)(double), const Interval &a)
  {
    return widened(function(a.low), function(a.high));
  }



  inline Interval
  exp(const Interval &a)
  {
    const Interval value = monotone(std::exp, a);
    // a value that is rounded to 0 is 0
    return {a.high < -746. ? 0. : std::max(value.low, 0.),
            a.high < -746. ? 0. : value.high};
  }



  /** $\cos$ of $a$ plus @p quarters times $\pi/2$. */
  inline Interval
  wave(const Interval &a, const int quarters)
  {
    constexpr double half_turn = 3.14159265358979323846;
    const auto       value     = [quarters](const double x) {
      return quarters % 2 == 0 ? (quarters == 0 ? 1 : -1) * std::cos(x) :
                                           (quarters == 3 ? 1 : -1) * std::sin(x);
    };
    if (!(a.width() < 2. * half_turn) || a.magnitude() > 1e15)
      return {-1., 1.};
    Interval result = widened(value(a.low), value(a.high));
    // extrema are at multiples of half a turn
    const double shift = 0.5 * quarters,
                 slack = Tolerances::rounding * (4. + a.magnitude());
    for (double n = std::ceil((a.low - slack) / half_turn + shift);
         n <= (a.high + slack) / half_turn + shift;
         ++n)
      (std::fmod(n, 2.) == 0. ? result.high : result.low) =
        std::fmod(n, 2.) == 0. ? 1. : -1.;
    return {std::max(result.low, -1.), std::min(result.high, 1.)};
  }



  inline Interval
  cos(const Interval &a)
  {
    return wave(a, 0);
  }

  inline Interval
  sin(const Interval &a)
  {
    return wave(a, 3);
  }



  inline Interval
  tan(const Interval &a)
  {
    return wave(a, 0).contains(0.) ? Interval::everything() : sin(a) / cos(a);
  }



  inline Interval
  cosh(const Interval &a)
  {
    const double   low = std::min(std::abs(a.low), std::abs(a.high));
    const Interval value =
      monotone(std::cosh, Interval(a.contains(0.) ? 0. : low, a.magnitude()));
    return {std::max(value.low, 1.), value.high};
  }



  /** A constant power; everything where it is not real or not finite. */
  inline Interval
  pow(const Interval &a, const double exponent)
  {
    const auto at = [exponent](const double x) {
      return std::pow(x, exponent);
    };
    if (exponent == 0.)
      return 1.;
    if (exponent == 1.)
      return a;
    const bool is_whole = exponent == std::floor(exponent);
    if (is_whole ? exponent < 0. && a.contains(0.) :
                   a.low < 0. || (exponent < 0. && a.low <= 0.))
      return Interval::everything();
    Interval result = widened(at(a.low), at(a.high));
    if (is_whole && std::fmod(exponent, 2.) == 0.)
      result.low = a.contains(0.) ? 0. : std::max(result.low, 0.);
    else if (!is_whole)
      result.low = std::max(result.low, 0.);
    return result;
  }



  inline Interval
  sqrt(const Interval &a)
  {
    return pow(a, 0.5);
  }



  /**
   * A value with its first and second derivative in one variable, the time or a
   * coordinate, of numbers or of intervals. One of intervals over a span of the
   * variable, and of others, contains those of the function everywhere in it.
   * Where the function may jump in it both derivatives are everything, where
   * its slope may, the second is.
   */
  template <typename Number>
  struct Jet
  {
    Number value = 0., first = 0., second = 0.;

    Jet() = default;

    Jet(const Number &value, const Number &first, const Number &second)
      : value(value)
      , first(first)
      , second(second)
    {}

    /** A constant. */
    explicit Jet(const double number)
      : value(number)
    {}
  };

  using NumberJet   = Jet<double>;
  using IntervalJet = Jet<Interval>;



  template <typename Number>
  Jet<Number>
  operator-(const Jet<Number> &a)
  {
    return {-a.value, -a.first, -a.second};
  }

  template <typename Number>
  Jet<Number>
  operator+(const Jet<Number> &a, const Jet<Number> &b)
  {
    return {a.value + b.value, a.first + b.first, a.second + b.second};
  }

  template <typename Number>
  Jet<Number>
  operator-(const Jet<Number> &a, const Jet<Number> &b)
  {
    return {a.value - b.value, a.first - b.first, a.second - b.second};
  }

  template <typename Number>
  Jet<Number>
  operator*(const Jet<Number> &a, const Jet<Number> &b)
  {
    return {a.value * b.value,
            a.value * b.first + a.first * b.value,
            a.value * b.second + 2. * (a.first * b.first) + a.second * b.value};
  }

  /** A function with its derivatives $f$, $f'$, $f''$ at @p a. */
  template <typename Number>
  Jet<Number>
  chain(const Jet<Number> &a,
        const Number      &f,
        const Number      &f1,
        const Number      &f2)
  {
    return {f, f1 * a.first, f2 * square(a.first) + f1 * a.second};
  }

  /** The derivative of a power where it is one; at zero it may be infinite. */
  inline double
  slope_of_power(const double a, const double factor, const double exponent)
  {
    const double slope = factor == 0. ? 0. : factor * std::pow(a, exponent);
    return std::isfinite(slope) ? slope : 0.;
  }

  inline Interval
  slope_of_power(const Interval &a, const double factor, const double exponent)
  {
    return factor == 0. ? Interval(0.) : factor * pow(a, exponent);
  }

  template <typename Number>
  Jet<Number>
  constant_power(const Jet<Number> &a, const double exponent)
  {
    using std::pow;
    return chain(a,
                 Number(pow(a.value, exponent)),
                 slope_of_power(a.value, exponent, exponent - 1.),
                 slope_of_power(a.value,
                                exponent * (exponent - 1.),
                                exponent - 2.));
  }



  template <typename Number>
  Jet<Number>
  operator/(const Jet<Number> &a, const Jet<Number> &b)
  {
    const Number inverse = 1. / b.value, inverse_2 = inverse * inverse;
    Jet<Number>  result =
      a * chain(b, inverse, -inverse_2, 2. * (inverse * inverse_2));
    result.value = a.value / b.value;
    return result;
  }
} // namespace ThermoContact

#endif
