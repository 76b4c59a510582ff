// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef thermocontact_base_exceptions_h
#define thermocontact_base_exceptions_h

#include <stdexcept>

namespace ThermoContact
{
  /**
   * The input or the command line is wrong: the message names the place, the
   * value, what is allowed and the remedy. Exit status 2. Thrown on all ranks.
   */
  class InputError : public std::runtime_error
  {
  public:
    using std::runtime_error::runtime_error;
  };



  /**
   * A computation or a file operation failed: the message says where and what
   * to try. Exit status 1. Thrown on all ranks.
   */
  class ComputationError : public std::runtime_error
  {
  public:
    using std::runtime_error::runtime_error;
  };
} // namespace ThermoContact

#endif
