// SPDX-License-Identifier: LGPL-2.1-or-later

#include "problem_data.h"

#include <deal.II/base/numbers.h>
#include <deal.II/base/utilities.h>

#include <cmath>
#include <iostream>
#include <map>
#include <sstream>

#include "exceptions.h"

namespace ThermoContact
{
  namespace
  {
    /** An expression of the parameter file and the entry it comes from. */
    struct Expression
    {
      std::string path;
      std::string text;
    };



    bool
    is_zero(const Expression &expression)
    {
      return Utilities::trim(expression.text) == "0";
    }



    [[noreturn]] void
    refuse(const Expression  &expression,
           const std::string &fault,
           const std::string &allowed)
    {
      throw InputError(expression.path + " = " + expression.text + ": " +
                       fault + "\n  allowed: " + allowed);
    }



    /**
     * Splits an expression at ';'.
     *
     * @throw InputError if a part is empty or has a ',' that separates no
     *   arguments: muParser would evaluate both sides and keep the last
     */
    std::vector<std::string>
    split_components(const Expression &expression)
    {
      const std::string        text = expression.text + ";";
      std::vector<std::string> components;
      std::string              component;
      int                      depth = 0;
      for (const char letter : text)
        {
          depth += (letter == '(') - (letter == ')');
          if (letter == ',' && depth <= 0)
            refuse(expression,
                   "a ',' outside of parentheses",
                   "a decimal point, and ';' between components");
          if (letter != ';')
            component += letter;
          else if (Utilities::trim(component).empty())
            refuse(expression, "an empty expression", "0 for none");
          else
            {
              components.push_back(component);
              component.clear();
            }
        }
      return components;
    }



    /** The expression of a scalar. */
    std::string
    scalar_component(const Expression &expression)
    {
      if (split_components(expression).size() != 1)
        refuse(expression, "several components", "one expression, without ';'");
      return expression.text;
    }



    /**
     * The components of a vector expression, separated by ';' and filled up
     * with zeros: one component alone is the axial one.
     */
    std::string
    vector_components(const Expression &expression, const unsigned int dim)
    {
      const unsigned int n_components = split_components(expression).size();
      if (n_components != 1 && n_components != dim)
        refuse(expression,
               std::to_string(n_components) + " components",
               dim > 1 ?
                 "1 (axial) or " + std::to_string(dim) + ", separated by ';'" :
                 "1, since Dimension = 1");
      std::string components = expression.text;
      for (unsigned int c = n_components; c < dim; ++c)
        components += "; 0";
      return components;
    }



    /** deal.II prints a parser's fault to std::cerr before it throws. */
    class SilencedErrorStream
    {
    public:
      SilencedErrorStream()
        : old_buffer(std::cerr.rdbuf(nullptr))
      {}

      ~SilencedErrorStream()
      {
        std::cerr.rdbuf(old_buffer);
      }

    private:
      std::streambuf *const old_buffer;
    };



    /** Evaluates @p function, parsed from @p expression, at 17 points, t = 0. */
    template <int dim>
    void
    check_evaluation(const Expression          &expression,
                     const FunctionParser<dim> &function)
    {
      const std::string place = expression.path + " = " + expression.text;
      for (unsigned int i = 0; i <= 16; ++i)
        {
          Point<dim> point;
          point[0]     = i / 16.;
          double value = 0.;
          try
            {
              const SilencedErrorStream silence;
              for (unsigned int c = 0; c < function.n_components; ++c)
                value += function.value(point, c);
            }
          catch (const ExceptionBase &exception)
            {
              // the last words are muParser's own
              std::ostringstream reason;
              exception.print_info(reason);
              const std::string words = reason.str();
              const auto        said  = words.find("said: ");
              throw InputError(
                place + ": cannot be read: " +
                Utilities::trim(
                  said == std::string::npos ? words : words.substr(said + 6)) +
                "\n  allowed: an expression in the coordinates (and t for a "
                "source), pi and theta_A, e.g. theta_A*cos(2*pi*x)");
            }
          if (!std::isfinite(value))
            throw InputError(
              place + ": not finite at x = " + std::to_string(point[0]) +
              ", t = 0" +
              "\n  allowed: expressions that are finite on 0 <= x <= 1");
        }
    }



    /**
     * Parses and evaluates.
     *
     * @param components what the parser reads, made from @p expression
     * @param constants names that expressions may use, with their values
     */
    template <int dim>
    std::unique_ptr<FunctionParser<dim>>
    parse(const Expression                    &expression,
          const std::string                   &components,
          const bool                           is_time_dependent,
          const std::map<std::string, double> &constants)
    {
      static const std::map<int, std::string> coordinates = {{1, "x"},
                                                             {2, "x,y"},
                                                             {3, "x,y,z"}};

      auto function = std::make_unique<FunctionParser<dim>>(
        Utilities::split_string_list(components, ';').size());
      function->initialize(coordinates.at(dim) +
                             (is_time_dependent ? ",t" : ""),
                           components,
                           constants,
                           is_time_dependent);
      check_evaluation(expression, *function);
      return function;
    }
  } // namespace



  template <int dim>
  ProblemData<dim>::ProblemData(const Parameters &parameters)
  {
    std::map<std::string, double> constants = {{"pi", numbers::PI}};
    if (parameters.model.has_temperature())
      constants["theta_A"] = parameters.boundary.fixed_end_temperature;
    const auto      &initial = parameters.initial_values;
    const Expression temperature{"Initial values/Temperature",
                                 initial.temperature};
    const Expression displacement{"Initial values/Displacement",
                                  initial.displacement};
    const Expression velocity{"Initial values/Velocity", initial.velocity};

    const ModelParameters &model = parameters.model;
    const Expression       nothing{"", "0"};
    std::string            fields, rates;
    if (model.has_temperature())
      {
        // alone first, so that a message names the entry that is wrong
        parse<dim>(temperature,
                   scalar_component(temperature),
                   false,
                   constants);
        fields = temperature.text;
        rates  = "0";
      }
    const auto append = [&](const Expression &expression, std::string &text) {
      const std::string components = vector_components(expression, dim);
      parse<dim>(expression, components, false, constants);
      text += (text.empty() ? "" : ";") + components;
    };
    if (model.has_displacement())
      {
        append(model.is_static() ? nothing : displacement, fields);
        append(model.inertia == 0. ? nothing : velocity, rates);
      }
    initial_fields_   = parse<dim>(nothing, fields, false, constants);
    initial_velocity_ = parse<dim>(nothing, rates, false, constants);

    const auto      &sources = parameters.sources;
    const Expression body_force{"Sources/Body force", sources.body_force};
    if (model.has_displacement() && !is_zero(body_force))
      body_force_ = parse<dim>(body_force,
                               vector_components(body_force, dim),
                               true,
                               constants);
    const auto parse_scalar = [&](const bool        is_used,
                                  const Expression &expression) {
      return !is_used || is_zero(expression) ?
               nullptr :
               parse<dim>(expression,
                          scalar_component(expression),
                          true,
                          constants);
    };
    heat_source_ = parse_scalar(model.has_temperature(),
                                {"Sources/Heat source", sources.heat_source});
    end_traction_ =
      parse_scalar(model.has_displacement(),
                   {"Sources/End traction", sources.end_traction});
    end_heat_flux_ =
      parse_scalar(model.has_temperature(),
                   {"Sources/End heat flux", sources.end_heat_flux});
  }



  template <int dim>
  const Function<dim> &
  ProblemData<dim>::initial_fields() const
  {
    return *initial_fields_;
  }



  template <int dim>
  const Function<dim> &
  ProblemData<dim>::initial_velocity() const
  {
    return *initial_velocity_;
  }



  template <int dim>
  const Function<dim> *
  ProblemData<dim>::heat_source() const
  {
    return heat_source_.get();
  }



  template <int dim>
  const Function<dim> *
  ProblemData<dim>::body_force() const
  {
    return body_force_.get();
  }



  template <int dim>
  const Function<dim> *
  ProblemData<dim>::end_traction() const
  {
    return end_traction_.get();
  }



  template <int dim>
  const Function<dim> *
  ProblemData<dim>::end_heat_flux() const
  {
    return end_heat_flux_.get();
  }



  template <int dim>
  bool
  ProblemData<dim>::has_sources() const
  {
    return heat_source_ || body_force_ || end_traction_ || end_heat_flux_;
  }



  template <int dim>
  void
  ProblemData<dim>::set_time(const double time)
  {
    for (FunctionParser<dim> *source : {heat_source_.get(),
                                        body_force_.get(),
                                        end_traction_.get(),
                                        end_heat_flux_.get()})
      if (source != nullptr)
        source->set_time(time);
  }



  template class ProblemData<1>;
  template class ProblemData<2>;
  template class ProblemData<3>;
} // namespace ThermoContact
