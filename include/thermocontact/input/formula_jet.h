// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef thermocontact_input_formula_jet_h
#define thermocontact_input_formula_jet_h

#include <boost/math/differentiation/autodiff.hpp>

#include <map>
#include <string>

namespace ThermoContact
{
  /** A value with its first two derivatives in time. */
  using Jet = boost::math::differentiation::autodiff_fvar<double, 2>;

  inline double
  value_of(const Jet &x)
  {
    return static_cast<double>(x);
  }

  /** False where a derivative is no number. */
  inline bool
  is_constant(const Jet &x)
  {
    return x.derivative(1) == 0. && x.derivative(2) == 0.;
  }

  /**
   * A constant power; at zero, where a derivative may be infinite, that one is
   * 0 and the others are what they are.
   */
  Jet
  power(const Jet &base, const double exponent);

  Jet
  power(const Jet &base, const Jet &exponent);

  /** Functions of one argument; those with steps have derivatives 0. */
  const std::map<std::string, Jet (*)(const Jet &)> &
  jet_functions();
} // namespace ThermoContact

#endif
