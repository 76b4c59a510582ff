// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef thermocontact_extremes_test_scene_h
#define thermocontact_extremes_test_scene_h

#include <string>
#include <vector>

#include "../overrides.h"

namespace ThermoContact
{
  /** One run of the campaign: overrides of the defaults and what to expect. */
  struct TestScene
  {
    enum Expectation
    {
      completes, ///< runs to its end time
      warns,     ///< the same, with a warning
      refused    ///< InputError
    };

    std::string name;
    Overrides   overrides;
    Expectation expectation = completes;

    /** refused: the message contains this; warns: the warning does. */
    std::string message = "";

    /** The last state is to be the steady one, (M3.1). */
    bool ends_steady = false;

    /** Accepted steps after which the checks have seen enough. */
    unsigned int max_steps = 400;

    /** Which variations of it are to be the same. */
    enum Variations
    {
      all,
      scaling_alone,
      sign_alone
    };

    Variations variations = all;
  };



  /** Without the names of sections. */
  inline std::string
  join(const Overrides &overrides)
  {
    std::string text;
    for (const std::string &o : overrides)
      text += (text.empty() ? "" : ", ") + o.substr(o.find('/') + 1);
    return text;
  }
} // namespace ThermoContact

#endif
