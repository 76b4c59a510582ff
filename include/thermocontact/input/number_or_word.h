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

  /**
   * Declares an entry whose value is a number, @p number if it is not given, or
   * else an expression, whose text is not looked at.
   *
   * @param names that the expression may use, in words
   * @param assign called with the number and an empty text, or with the
   *   expression
   * @param is_signed the number may be negative
   */
  void
  add_number_or_expression(
    dealii::ParameterHandler                                     &prm,
    const std::string                                            &name,
    const double                                                  number,
    const std::string                                            &names,
    const std::string                                            &text,
    const std::function<void(const double, const std::string &)> &assign,
    const bool is_signed = false);
} // namespace ThermoContact

#endif
