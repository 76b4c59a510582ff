// SPDX-License-Identifier: LGPL-2.1-or-later

#include <thermocontact/base/number_text.h>
#include <thermocontact/base/special_numbers.h>
#include <thermocontact/input/section_of_entries.h>

#include <deal.II/base/utilities.h>

#include <limits>

namespace ThermoContact
{
  using dealii::Patterns::Double;
  using dealii::Patterns::Integer;
  using dealii::Utilities::string_to_double;



  NumberOrText::NumberOrText(const std::string &word,
                             const std::string &names,
                             const Number      &number)
    : the_word(word)
    , names(names)
    , number(number)
  {}



  const dealii::Patterns::PatternBase *
  NumberOrText::pattern_of_number() const
  {
    if (const auto *const real = std::get_if<Double>(&number))
      return real;
    return std::get_if<Integer>(&number);
  }



  NumberOrText
  NumberOrText::word(const std::string &word)
  {
    return {word, "", Double(0., 1e15)};
  }



  NumberOrText
  NumberOrText::word_or_number(const std::string              &word,
                               const dealii::Patterns::Double &numbers)
  {
    return {word, "", numbers};
  }



  NumberOrText
  NumberOrText::word_or_count(const std::string &word,
                              const int          smallest,
                              const int          largest)
  {
    return {word, "", Integer(smallest, largest)};
  }



  NumberOrText
  NumberOrText::expression(const std::string &names)
  {
    return {"", names, std::monostate()};
  }



  NumberOrText
  NumberOrText::number_or_expression(const std::string &names,
                                     const bool         is_signed,
                                     const std::string &or_word)
  {
    const double largest = std::numeric_limits<double>::max();
    return number_or_expression(
      names, is_signed ? Double(-largest, largest) : Double(0., 1e15), or_word);
  }



  NumberOrText
  NumberOrText::number_or_expression(const std::string &names,
                                     const Double      &numbers,
                                     const std::string &or_word)
  {
    NumberOrText result("", names, numbers);
    result.or_word = or_word;
    return result;
  }



  bool
  NumberOrText::match(const std::string &text) const
  {
    const PatternBase *const of_number = pattern_of_number();
    return of_number == nullptr || of_number->match(text) ||
           (the_word.empty() ? !(text.empty() || Double().match(text)) :
                               text == the_word);
  }



  std::string
  NumberOrText::description(const OutputStyle style) const
  {
    const PatternBase *const number = pattern_of_number();
    const std::string        words =
      number == nullptr ? "" : number->description(style);
    return the_word.empty() ? "[" + or_word + (or_word.empty() ? "" : ", ") +
                                words + (words.empty() ? "" : " or ") +
                                "an expression in " + names + "]" :
                              "[" + the_word + " or " + words + "]";
  }



  std::unique_ptr<dealii::Patterns::PatternBase>
  NumberOrText::clone() const
  {
    return std::unique_ptr<PatternBase>(new NumberOrText(*this));
  }



  SectionOfEntries::SectionOfEntries(dealii::ParameterHandler &prm,
                                     const std::string        &name)
    : prm(prm)
    , names(dealii::Utilities::split_string_list(name, '/'))
  {
    for (const std::string &one : names)
      prm.enter_subsection(one);
  }



  SectionOfEntries::~SectionOfEntries()
  {
    for (unsigned int i = 0; i < names.size(); ++i)
      prm.leave_subsection();
  }



  SectionOfEntries::Entry
  SectionOfEntries::unbound(const std::string                   &name,
                            const std::string                   &default_value,
                            const dealii::Patterns::PatternBase &pattern,
                            const Action                        &assign)
  {
    return {
      [this, name, default_value, &pattern, assign](const std::string &text) {
        prm.declare_entry(name, default_value, pattern, text);
        if (assign)
          prm.add_action(name, assign);
      }};
  }



  SectionOfEntries::Entry
  SectionOfEntries::operator()(const std::string     &name,
                               std::optional<double> &value,
                               const NumberOrText    &pattern)
  {
    const std::string word = pattern.default_word();
    return unbound(name, word, pattern, [&value, word](const auto &given) {
      value.reset();
      if (given != word)
        value = string_to_double(given);
    });
  }



  SectionOfEntries::Entry
  SectionOfEntries::operator()(const std::string  &name,
                               double             &value,
                               const NumberOrText &pattern)
  {
    const std::string word = pattern.default_word();
    return unbound(name, word, pattern, [&value, word](const auto &given) {
      value = given == word ? infinity : string_to_double(given);
    });
  }



  SectionOfEntries::Entry
  SectionOfEntries::operator()(const std::string  &name,
                               unsigned int       &count,
                               const NumberOrText &pattern)
  {
    const std::string word = pattern.default_word();
    return unbound(name, word, pattern, [&count, word](const auto &given) {
      count = given == word ? 0 : dealii::Utilities::string_to_int(given);
    });
  }



  SectionOfEntries::Entry
  SectionOfEntries::operator()(const std::string                 &name,
                               const double                       default_value,
                               const Double                      &pattern,
                               const std::function<void(double)> &assign)
  {
    return unbound(name,
                   significant(default_value, few_digits),
                   pattern,
                   [assign](const auto &given) {
                     assign(string_to_double(given));
                   });
  }



  SectionOfEntries::Entry
  SectionOfEntries::operator()(const std::string  &name,
                               double             &number,
                               std::string        &expression,
                               const NumberOrText &pattern)
  {
    return unbound(name,
                   significant(number, std::numeric_limits<double>::digits10),
                   pattern,
                   [&number, &expression](const auto &given) {
                     const bool is_number = Double().match(given);
                     number     = is_number ? string_to_double(given) : 0.;
                     expression = is_number ? "" : given;
                   });
  }
} // namespace ThermoContact
