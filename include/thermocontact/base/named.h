// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef thermocontact_base_named_h
#define thermocontact_base_named_h

#include <deal.II/base/exceptions.h>

#include <algorithm>
#include <string>
#include <vector>

namespace ThermoContact
{
  /** The one of a list that has this name. */
  template <typename Named>
  const Named &
  named(const std::string &name, const std::vector<Named> &list)
  {
    const auto found =
      std::find_if(list.begin(), list.end(), [&](const Named &one) {
        return one.name == name;
      });
    Assert(found != list.end(), dealii::ExcInternalError());
    return *found;
  }
} // namespace ThermoContact

#endif
