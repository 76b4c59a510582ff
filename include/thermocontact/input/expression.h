// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef thermocontact_input_expression_h
#define thermocontact_input_expression_h

#include <thermocontact/input/operations.h>

#include <array>
#include <map>
#include <memory>
#include <string>
#include <vector>

namespace ThermoContact
{
  class MeasuredTable;

  /** The meaning of names in an expression. */
  struct ExpressionNames
  {
    /**
     * In the order of the values with which it is evaluated; an empty name is
     * none that could be used.
     */
    std::vector<std::string> variables;

    std::map<std::string, double> constants; ///< beside pi

    std::string folder = ""; ///< of the files of tables

    bool has_units = false; ///< tables may have units in their headers

    /** Units of the variables and of the value; empty: they are not known. */
    std::vector<std::string> units = {};

    /** Values that are not finite are refused. */
    bool checks_values = true;
  };



  /**
   * An expression of the parameter file in the language of deal.II's
   * FunctionParser, read once. It is evaluated with numbers, or with jets for
   * derivatives in time and for all that it does in a span of time; that
   * allocates nothing.
   *
   * Operators, from the last to the first that binds: `? :`; `||` and `|`; `&&`
   * and `&`; `< <= > >= == !=`; `+ -`; `* /` and signs; `^` from the right.
   * Numbers but 0 are true. table(FILE, t) and table(FILE, COLUMN, t) are
   * linear between the rows of a table, smooth() is a monotone cubic. Where the
   * formula has branches its derivatives belong to the branch that holds; a
   * step has the derivative 0.
   */
  class Expression
  {
  public:
    /**
     * @param path of the entry, for messages
     * @param begin, end of what is read in the text
     * @throw InputError with the place of the fault and the names that there
     *   are, if it cannot be read
     */
    Expression(const std::string     &path,
               const std::string     &text,
               const ExpressionNames &names,
               const std::size_t      begin = 0,
               const std::size_t      end   = std::string::npos);

    /** The names of functions that there are. */
    static std::vector<std::string>
    function_names();

    /** As it was written. */
    const std::string &
    text() const
    {
      return text_;
    }

    const std::string &
    path() const
    {
      return path_;
    }

    /** Whether it is made of the same operations on the same numbers. */
    bool
    operator==(const Expression &other) const;

    /** Whether it names a variable that there is. */
    bool
    depends_on(const std::string &variable) const;

    /** Whether it names none. */
    bool
    is_constant() const
    {
      return named.empty();
    }

    /** Its text with @p others for the names of its variables. */
    std::string
    with_variables(const std::vector<std::string> &others) const;

    /** The files of tables whose rows end before an argument that these values
     * of the variables give them. */
    std::vector<std::string>
    tables_left(const double *variables) const;

    /** The doubt about one of tables_left(): @p where it has no row. */
    std::string
    doubt_beyond(const std::string &file, const std::string &where) const;

    /** Doubts about its tables, for the user to look at. */
    std::vector<std::string>
    doubts_of_tables() const;

    /**
     * @tparam Number double, NumberJet or IntervalJet
     * @param variables one value for each
     */
    template <typename Number>
    Number
    evaluate(const Number *variables) const
    {
      return evaluate_part(parts.size() - 1, variables);
    }

  private:
    static constexpr unsigned int max_operands = 3;

    /** A number, a variable, or an operation on earlier parts. */
    struct Part
    {
      enum Kind
      {
        number,
        variable,
        table,
        operation_on_parts
      };

      Kind             kind;
      double           value      = 0.; ///< of a number
      const Operation *operation  = nullptr;
      unsigned int     n_operands = 0;

      /** Earlier parts; the index of a variable; behind its argument a table.
       */
      std::array<unsigned int, max_operands> operands{};

      unsigned int n_levels = 1;
    };

    class Reader;

    /** Where a variable is named. */
    struct NamedVariable
    {
      unsigned int index;
      std::size_t  position; ///< in the text
    };

    std::string                path_;
    std::string                text_;
    std::vector<std::string>   variable_names;
    std::vector<NamedVariable> named; ///< in the order of the text
    std::vector<Part>          parts; ///< the whole at the end

    /** Which copies of the expression share, since they only read it. */
    std::vector<std::shared_ptr<const MeasuredTable>> tables_;

    /**
     * @param position of the part that is not finite, for messages
     * @throw InputError if it is not finite at one of 17 points of the first
     *   variable from 0 to 1, where all others are 0
     */
    void
    check_values(const std::size_t position) const;

    template <typename Number>
    Number
    evaluate_part(const unsigned int index, const Number *variables) const;
  };



  /** The names in a text, whatever they mean. */
  std::vector<std::string>
  identifiers_in(const std::string &text);

  /**
   * Components of a vector that @p text separates by ';'.
   *
   * @param n_components largest number of components: one alone is the first
   *   one, the others are 0
   * @throw InputError as Expression, or if there are neither one nor
   *   @p n_components
   */
  std::vector<Expression>
  read_components(const std::string     &path,
                  const std::string     &text,
                  const unsigned int     n_components,
                  const ExpressionNames &names);
} // namespace ThermoContact

#endif
