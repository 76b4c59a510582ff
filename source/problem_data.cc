// SPDX-License-Identifier: LGPL-2.1-or-later

#include "problem_data.h"

#include <deal.II/base/numbers.h>
#include <deal.II/base/utilities.h>

#include <cmath>
#include <map>

#include "exceptions.h"

namespace ThermoContact
{
  namespace
  {
    constexpr bool with_time    = true;
    constexpr bool without_time = false;

    /**
     * Splits a vector expression at ';' and fills it up with zeros: one
     * component alone is the axial one.
     */
    std::string
    complete_components(const std::string &path,
                        const std::string &expression,
                        const unsigned int dim)
    {
      const unsigned int n_components =
        Utilities::split_string_list(expression, ';').size();
      if (n_components != 1 && n_components != dim)
        throw InputError(path + " = " + expression + ": " +
                         std::to_string(n_components) +
                         " components\n  allowed: 1 (axial) or " +
                         std::to_string(dim) + ", separated by ';'");
      std::string completed = expression;
      for (unsigned int c = n_components; c < dim; ++c)
        completed += "; 0";
      return completed;
    }



    /** Evaluates @p function on a few points along the body's axis. */
    template <int dim>
    void
    check_evaluation(const std::string         &path,
                     const std::string         &expression,
                     const FunctionParser<dim> &function,
                     const BoundaryParameters  &boundary)
    {
      const std::string place = path + " = " + expression;
      for (unsigned int i = 0; i <= 16; ++i)
        {
          Point<dim> point;
          point[0]     = i / 16.;
          double value = 0.;
          for (unsigned int c = 0; c < function.n_components; ++c)
            try
              {
                value += function.value(point, c);
              }
            catch (const ExceptionBase &exception)
              {
                // deal.II repeats muParser's own words in its message
                std::ostringstream reason;
                exception.print_info(reason);
                throw InputError(
                  place + ": cannot be evaluated\n" + reason.str() +
                  "  allowed: an expression in the coordinates (and t for a "
                  "source), pi and theta_A, e.g. theta_A*cos(2*pi*x)");
              }
          if (!std::isfinite(value))
            throw InputError(
              place + ": not finite at x = " + std::to_string(point[0]) +
              ", theta_A = " + std::to_string(boundary.fixed_end_temperature) +
              "\n  allowed: expressions that are finite on 0 <= x <= 1");
        }
    }



    template <int dim>
    std::unique_ptr<FunctionParser<dim>>
    parse(const std::string        &path,
          const std::string        &expression,
          const unsigned int        n_components,
          const bool                is_time_dependent,
          const BoundaryParameters &boundary)
    {
      static const std::map<int, std::string> coordinates = {{1, "x"},
                                                             {2, "x,y"},
                                                             {3, "x,y,z"}};
      const std::map<std::string, double>     constants   = {
              {"pi", numbers::PI}, {"theta_A", boundary.fixed_end_temperature}};

      auto function = std::make_unique<FunctionParser<dim>>(n_components);
      function->initialize(coordinates.at(dim) +
                             (is_time_dependent ? ",t" : ""),
                           expression,
                           constants,
                           is_time_dependent);
      check_evaluation(path, expression, *function, boundary);
      return function;
    }



    /** Like parse(), but nullptr for the expression 0. */
    template <int dim>
    std::unique_ptr<FunctionParser<dim>>
    parse_source(const std::string        &path,
                 const std::string        &expression,
                 const unsigned int        n_components,
                 const BoundaryParameters &boundary)
    {
      if (Utilities::trim(expression) == "0")
        return nullptr;
      return parse<dim>(path, expression, n_components, with_time, boundary);
    }
  } // namespace



  template <int dim>
  ProblemData<dim>::ProblemData(const Parameters &parameters)
  {
    const BoundaryParameters &boundary = parameters.boundary;
    const auto               &initial  = parameters.initial_values;
    const auto               &sources  = parameters.sources;

    const std::string displacement =
      complete_components("Initial values/Displacement",
                          initial.displacement,
                          dim);
    const std::string velocity =
      complete_components("Initial values/Velocity", initial.velocity, dim);
    const std::string body_force =
      complete_components("Sources/Body force", sources.body_force, dim);

    // each expression alone first, so that a message names its entry
    parse<dim>("Initial values/Temperature",
               initial.temperature,
               1,
               without_time,
               boundary);
    parse<dim>(
      "Initial values/Displacement", displacement, dim, without_time, boundary);

    initial_fields_   = parse<dim>("Initial values",
                                 initial.temperature + ";" + displacement,
                                 1 + dim,
                                 without_time,
                                 boundary);
    initial_velocity_ = parse<dim>("Initial values/Velocity",
                                   "0;" + velocity,
                                   1 + dim,
                                   without_time,
                                   boundary);
    heat_source_      = parse_source<dim>("Sources/Heat source",
                                     sources.heat_source,
                                     1,
                                     boundary);
    if (Utilities::trim(sources.body_force) != "0")
      body_force_ =
        parse_source<dim>("Sources/Body force", body_force, dim, boundary);
    end_traction_  = parse_source<dim>("Sources/End traction",
                                      sources.end_traction,
                                      1,
                                      boundary);
    end_heat_flux_ = parse_source<dim>("Sources/End heat flux",
                                       sources.end_heat_flux,
                                       1,
                                       boundary);
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
