// SPDX-License-Identifier: LGPL-2.1-or-later

#include <thermocontact/base/number_text.h>
#include <thermocontact/input/number_or_word.h>

#include <deal.II/base/patterns.h>
#include <deal.II/base/utilities.h>

#include <limits>
#include <memory>

namespace ThermoContact
{
  namespace
  {
    using namespace dealii::Patterns;

    /**
     * A number, or a word that stands for a choice of the program or for no
     * limit.
     */
    class NumberOrWord : public PatternBase
    {
    public:
      explicit NumberOrWord(const std::string &word)
        : word(word)
        , number(0., 1e15)
      {}

      bool
      match(const std::string &text) const override
      {
        return text == word || number.match(text);
      }

      std::string
      description(const OutputStyle style = Machine) const override
      {
        return "[" + word + " or " + number.description(style) + "]";
      }

      std::unique_ptr<PatternBase>
      clone() const override
      {
        return std::make_unique<NumberOrWord>(word);
      }

    private:
      const std::string word;
      const Double      number;
    };



    /** Everything but the numbers that are not allowed. */
    class NumberOrExpression : public PatternBase
    {
    public:
      NumberOrExpression(const std::string &names, const Double &number)
        : names(names)
        , number(number)
      {}

      bool
      match(const std::string &text) const override
      {
        return number.match(text) || !(text.empty() || Double().match(text));
      }

      std::string
      description(const OutputStyle style = Machine) const override
      {
        return "[" + number.description(style) + " or an expression in " +
               names + "]";
      }

      std::unique_ptr<PatternBase>
      clone() const override
      {
        return std::make_unique<NumberOrExpression>(names, number);
      }

    private:
      const std::string names;
      const Double      number;
    };
  } // namespace



  void
  add_number_or_word(dealii::ParameterHandler                  &prm,
                     const std::string                         &name,
                     const std::string                         &word,
                     const std::string                         &text,
                     const std::function<void(const double *)> &assign)
  {
    prm.declare_entry(name, word, NumberOrWord(word), text);
    prm.add_action(name, [word, assign](const std::string &value) {
      if (value == word)
        return assign(nullptr);
      const double number = dealii::Utilities::string_to_double(value);
      assign(&number);
    });
  }



  void
  add_number_or_expression(
    dealii::ParameterHandler                                     &prm,
    const std::string                                            &name,
    const double                                                  number,
    const std::string                                            &names,
    const std::string                                            &text,
    const std::function<void(const double, const std::string &)> &assign,
    const bool                                                    is_signed)
  {
    const double largest = std::numeric_limits<double>::max();
    prm.declare_entry(name,
                      significant(number,
                                  std::numeric_limits<double>::digits10),
                      NumberOrExpression(names,
                                         is_signed ? Double(-largest, largest) :
                                                     Double(0., 1e15)),
                      text);
    prm.add_action(name, [assign](const std::string &value) {
      if (Double().match(value))
        assign(dealii::Utilities::string_to_double(value), "");
      else
        assign(0., value);
    });
  }
} // namespace ThermoContact
