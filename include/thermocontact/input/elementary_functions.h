// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef thermocontact_input_elementary_functions_h
#define thermocontact_input_elementary_functions_h

#include <thermocontact/input/jet.h>

#include <functional>
#include <string>
#include <vector>

namespace ThermoContact
{
  /** A function of one argument that expressions know. */
  struct ElementaryFunction
  {
    std::string name;
    double (*number)(double);
    std::function<NumberJet(const NumberJet &)>     jet;
    std::function<IntervalJet(const IntervalJet &)> interval_jet;

    double
    operator()(const double x) const
    {
      return number(x);
    }

    NumberJet
    operator()(const NumberJet &x) const
    {
      return jet(x);
    }

    IntervalJet
    operator()(const IntervalJet &x) const
    {
      return interval_jet(x);
    }
  };



  /** All of them; that of an index is always the same one. */
  const std::vector<ElementaryFunction> &
  elementary_functions();
} // namespace ThermoContact

#endif
