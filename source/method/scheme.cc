// SPDX-License-Identifier: LGPL-2.1-or-later

#include <thermocontact/base/named.h>
#include <thermocontact/method/butcher_tableau.h>
#include <thermocontact/method/scheme.h>

#include <algorithm>
#include <utility>

namespace ThermoContact
{
  namespace
  {
    std::vector<Scheme>
    dirk_schemes()
    {
      std::vector<Scheme> schemes;
      for (const ButcherTableau &tableau : butcher_tableaus())
        {
          Scheme scheme;
          scheme.name               = tableau.name;
          scheme.order              = tableau.order;
          scheme.n_stages           = tableau.n_stages();
          scheme.has_error_estimate = tableau.has_error_estimate();
          scheme.is_backward_euler  = tableau.n_stages() == 1;
          scheme.can_create_energy  = !scheme.is_backward_euler;
          scheme.step_exponent      = 1. / tableau.order;
          scheme.text =
            scheme.is_backward_euler ?
              "the paper's" :
              "L-stable, " + std::to_string(tableau.n_stages()) +
                " solves per step" +
                (scheme.has_error_estimate ? ", with error estimate" : "");
          schemes.push_back(scheme);
        }
      return schemes;
    }



    Scheme
    energy_conserving_scheme()
    {
      Scheme scheme;
      scheme.name                   = "energy conserving";
      scheme.text                   = "for impacts of elastic bodies";
      scheme.order                  = 2;
      scheme.can_create_energy      = false;
      scheme.needs_massless_contact = true;
      scheme.has_mean_velocity      = true;
      scheme.has_viscous_contact    = false;
      scheme.needs_inertia =
        "without inertia there is no energy of motion to conserve";
      scheme.needs_linear_contact =
        "the scheme knows the potential of linear laws only";
      scheme.needs_constant_exchange =
        "the scheme finds its pressures before it knows the temperatures";
      scheme.needs_resting_end =
        "its midpoint rule would let the velocity of a moving end alternate";
      scheme.cannot_hold_contact =
        "the scheme conserves energy through contact in steps of any size";
      scheme.step_exponent = 0.5;
      scheme.integrator    = IntegratorKind::energy_conserving;
      return scheme;
    }



    Scheme
    box_scheme()
    {
      Scheme scheme;
      scheme.name = "box";
      scheme.text =
        "for waves in a rod, without dispersion in steps of h sqrt(b)";
      scheme.order               = 2;
      scheme.can_create_energy   = false;
      scheme.has_no_dispersion   = true;
      scheme.needs_inertia       = "without inertia there are no waves";
      scheme.cannot_hold_contact = "a wave passes a cell in each of its steps";
      scheme.step_exponent       = 0.5;
      scheme.integrator          = IntegratorKind::box;
      return scheme;
    }
  } // namespace



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
    return named(name, schemes());
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
