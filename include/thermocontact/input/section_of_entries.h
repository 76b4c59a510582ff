// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef thermocontact_input_section_of_entries_h
#define thermocontact_input_section_of_entries_h

#include <deal.II/base/parameter_handler.h>
#include <deal.II/base/patterns.h>

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <variant>
#include <vector>

namespace ThermoContact
{
  /** A pattern of entries that may be a word or an expression. */
  class NumberOrText : public dealii::Patterns::PatternBase
  {
  public:
    /** @p word, or a number that is not negative. */
    static NumberOrText
    word(const std::string &word);

    /** @p word, or any of these numbers. */
    static NumberOrText
    word_or_number(
      const std::string              &word,
      const dealii::Patterns::Double &numbers = dealii::Patterns::Double());

    /** @p word, or a whole number from @p smallest to @p largest. */
    static NumberOrText
    word_or_count(const std::string &word,
                  const int          smallest,
                  const int          largest);

    /**
     * A number, or an expression, whose text is not looked at.
     *
     * @param names that it may use, "y, z, t": DeclaredEntry::variables
     * @param is_signed the number may be negative
     * @param or_word another word that is allowed; empty: there is none
     */
    static NumberOrText
    number_or_expression(const std::string &names,
                         const bool         is_signed,
                         const std::string &or_word = "");

    /** The same with these numbers. */
    static NumberOrText
    number_or_expression(const std::string              &names,
                         const dealii::Patterns::Double &numbers,
                         const std::string              &or_word = "");

    /** An expression alone, which a number is, too. */
    static NumberOrText
    expression(const std::string &names);

    bool
    match(const std::string &text) const override;

    std::string
    description(const OutputStyle style = Machine) const override;

    std::unique_ptr<PatternBase>
    clone() const override;

    /** That stands for the default; empty: it may be an expression. */
    const std::string &
    default_word() const
    {
      return the_word;
    }

  private:
    /** The pattern of a number; none: anything. */
    using Number = std::variant<std::monostate,
                                dealii::Patterns::Double,
                                dealii::Patterns::Integer>;
    std::string the_word;
    std::string names;
    std::string or_word; ///< for the description alone
    Number      number;

    NumberOrText(const std::string &word,
                 const std::string &names,
                 const Number      &number);

    /** Null: anything. */
    const PatternBase *
    pattern_of_number() const;
  };



  /**
   * Declares the entries of a section as long as it lives, and binds them to
   * variables, whose values are the defaults:
   * `entry("Gap", gap, pattern).means("...")`. The name of a section within
   * another one is "Outer/Inner".
   */
  class SectionOfEntries
  {
  public:
    SectionOfEntries(dealii::ParameterHandler &prm, const std::string &name);

    ~SectionOfEntries();

    SectionOfEntries(const SectionOfEntries &) = delete;

    SectionOfEntries &
    operator=(const SectionOfEntries &) = delete;

    /** One that has all but its meaning. */
    struct Entry
    {
      std::function<void(const std::string &)> declare;

      /**
       * @param kind of quantity, if it is one: DeclaredEntry::kind
       */
      void
      means(const std::string &text, const std::string &kind = "") const
      {
        declare(kind.empty() ? text : text + " [" + kind + "]");
      }
    };

    template <typename Value>
    Entry
    operator()(const std::string &name, Value &value)
    {
      return {[this, name, &value](const std::string &text) {
        prm.add_parameter(name, value, text);
      }};
    }

    template <typename Value, typename Pattern>
    Entry
    operator()(const std::string &name, Value &value, const Pattern &pattern)
    {
      return {[this, name, &value, &pattern](const std::string &text) {
        prm.add_parameter(name, value, text, pattern);
      }};
    }

    /** A number, or the word of @p pattern, the default, for none, */
    Entry
    operator()(const std::string     &name,
               std::optional<double> &value,
               const NumberOrText    &pattern);

    /** or for an infinite one, */
    Entry
    operator()(const std::string  &name,
               double             &value,
               const NumberOrText &pattern);

    /** or for a count of 0. */
    Entry
    operator()(const std::string  &name,
               unsigned int       &count,
               const NumberOrText &pattern);

    using Action = std::function<void(const std::string &)>;

    /** One without a variable; @p assign is given its text. */
    Entry
    unbound(const std::string                   &name,
            const std::string                   &default_value,
            const dealii::Patterns::PatternBase &pattern,
            const Action                        &assign = {});

    /** A number that has no variable of its own. */
    Entry
    operator()(const std::string                 &name,
               const double                       default_value,
               const dealii::Patterns::Double    &pattern,
               const std::function<void(double)> &assign);

    /** A number, or else an expression. */
    Entry
    operator()(const std::string  &name,
               double             &number,
               std::string        &expression,
               const NumberOrText &pattern);

  private:
    dealii::ParameterHandler      &prm;
    const std::vector<std::string> names;
  };



  /** The names of all kinds, separated by '|', as a Selection has them. */
  template <typename Kind>
  std::string
  names_of(const std::vector<Kind> &kinds)
  {
    std::string names;
    for (const Kind &kind : kinds)
      names += (names.empty() ? "" : "|") + kind.name;
    return names;
  }



  /** The names of all kinds with what is to be said of each. */
  template <typename Kind, typename Say>
  std::string
  in_words(const std::vector<Kind> &kinds, const Say &say)
  {
    std::string words;
    for (unsigned int i = 0; i < kinds.size(); ++i)
      words += (i == 0                ? "" :
                i + 1 == kinds.size() ? " or " :
                                        ", ") +
               kinds[i].name + say(kinds[i]);
    return words;
  }
} // namespace ThermoContact

#endif
