// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef thermocontact_report_key_errors_h
#define thermocontact_report_key_errors_h

#include <thermocontact/simulation/simulation.h>

#include <array>
#include <string>
#include <vector>

namespace ThermoContact
{
  /** Number of key results that have error bars. */
  constexpr unsigned int n_key_errors = 6;

  /** Place of the largest force among them. */
  constexpr unsigned int max_contact_force = 1;

  /**
   * Names of key results that have error bars, as in key_result_names; the keys
   * of summary.json add "_time_error" and "_space_error".
   */
  extern const std::array<const char *, n_key_errors> key_error_names;

  /** Values of them; NaN for what there is not. */
  using KeyValues = std::array<double, n_key_errors>;

  /** Error bars of the key results of a run. */
  struct KeyErrors
  {
    KeyValues                time;  ///< NaN: not known
    KeyValues                space; ///< NaN: not known
    std::vector<std::string> remarks;
    unsigned int             n_repeats = 0;
  };



  /** What the key results are of a run, as summary.json has them. */
  template <int dim>
  KeyValues
  key_values(const Simulation<dim> &simulation);

  /**
   * The same, but with the largest force and penetration between step ends as
   * far as the step ends tell, (M.87): what changes with the accuracy of a run
   * without the luck of where steps end.
   */
  template <int dim>
  KeyValues
  smooth_key_values(const Simulation<dim> &simulation);
} // namespace ThermoContact

#endif
