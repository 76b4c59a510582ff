// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef thermocontact_input_number_or_word_h
#define thermocontact_input_number_or_word_h

#include <deal.II/base/parameter_handler.h>

#include <functional>
#include <string>

namespace ThermoContact
{
  /**
   * Declares an entry whose value is @p word, the default, or a number that is
   * not negative.
   *
   * @param assign called with the number, or a null pointer for the word
   */
  void
  add_number_or_word(dealii::ParameterHandler                  &prm,
                     const std::string                         &name,
                     const std::string                         &word,
                     const std::string                         &text,
                     const std::function<void(const double *)> &assign);
} // namespace ThermoContact

#endif
