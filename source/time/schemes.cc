// SPDX-License-Identifier: LGPL-2.1-or-later

#include <thermocontact/time/schemes.h>

#include <deal.II/base/exceptions.h>

#include <algorithm>
#include <utility>

namespace ThermoContact
{
  const std::vector<Scheme> &
  schemes()
  {
    static const std::vector<Scheme> list = [] {
      std::vector<Scheme> all = dirk_schemes();
      all.push_back(energy_conserving_scheme());
      all.push_back(box_scheme());
      return all;
    }();
    return list;
  }



  const Scheme *
  find_scheme(const std::function<bool(const Scheme &)> &is_wanted)
  {
    const auto found =
      std::find_if(schemes().begin(), schemes().end(), is_wanted);
    return found == schemes().end() ? nullptr : &*found;
  }



  const Scheme &
  scheme(const std::string &name)
  {
    const Scheme *const found =
      find_scheme([&name](const Scheme &s) { return s.name == name; });
    Assert(found != nullptr, dealii::ExcInternalError());
    return *found;
  }



  const Scheme &
  default_scheme()
  {
    return *std::max_element(
      schemes().begin(), schemes().end(), [](const Scheme &a, const Scheme &b) {
        return std::make_pair(a.has_error_estimate, a.order) <
               std::make_pair(b.has_error_estimate, b.order);
      });
  }
} // namespace ThermoContact
