// SPDX-License-Identifier: LGPL-2.1-or-later

#include <thermocontact/simulation/mesh_samples.h>

#include <algorithm>
#include <utility>

namespace ThermoContact
{
  namespace
  {
    /** Of steps of one size, one in so many is looked at. */
    constexpr unsigned int largest_stride = 8;

    /** Of the first of them, all. */
    constexpr unsigned int n_first_samples = 64;
  } // namespace



  MeshSamples::MeshSamples(const bool takes_all)
    : takes_all(takes_all)
  {}



  bool
  MeshSamples::take(const double step_size, const bool is_in_contact)
  {
    ++n_steps;
    n_since_event = is_in_contact != in_contact ? 0 : n_since_event + 1;
    in_contact    = is_in_contact;
    const unsigned int stride =
      takes_all ? 1 : std::min(largest_stride, n_steps / n_first_samples);
    if (n_since_event <= largest_stride || n_skipped + 1 >= stride)
      {
        n_skipped = 0;
        return true;
      }
    ++n_skipped;
    time_skipped += step_size;
    return false;
  }



  bool
  MeshSamples::is_at_event() const
  {
    return n_since_event == 0;
  }



  double
  MeshSamples::skipped_time() const
  {
    return time_skipped;
  }



  double
  MeshSamples::take_skipped_time()
  {
    return std::exchange(time_skipped, 0.);
  }
} // namespace ThermoContact
