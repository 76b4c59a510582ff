// SPDX-License-Identifier: LGPL-2.1-or-later

#include <thermocontact/input/expression.h>
#include <thermocontact/space/problem_data.h>

#include <deal.II/base/numbers.h>

namespace ThermoContact
{
  template <int dim>
  ProblemData<dim>::ProblemData(const Parameters &parameters)
  {
    const ModelParameters &model = parameters.model;
    ExpressionNames        names;
    names.constants["pi"] = numbers::PI;
    if (model.has_temperature())
      names.constants["theta_A"] = parameters.boundary.fixed_end_temperature;

    const auto &initial = parameters.initial_values;
    std::string fields, rates;
    if (model.has_temperature())
      {
        fields = check_expression<dim>(
          {"Initial values/Temperature", initial.temperature}, 1, names);
        rates = "0";
      }
    const auto append = [&](const std::string &entry,
                            const std::string &expression,
                            std::string       &text) {
      text += (text.empty() ? "" : ";") +
              check_expression<dim>({"Initial values/" + entry, expression},
                                    dim,
                                    names);
    };
    if (model.has_displacement())
      {
        append("Displacement",
               model.is_static() ? "0" : initial.displacement,
               fields);
        append("Velocity", model.inertia == 0. ? "0" : initial.velocity, rates);
      }
    initial_fields_   = make_function<dim>(fields, names);
    initial_velocity_ = make_function<dim>(rates, names);

    names.has_time         = true;
    const auto make_source = [&](const bool         is_used,
                                 const Expression  &expression,
                                 const unsigned int n_components) {
      return !is_used || expression.is_zero() ?
               nullptr :
               make_function<dim>(
                 check_expression<dim>(expression, n_components, names), names);
    };
    const auto &sources = parameters.sources;
    heat_source_        = make_source(model.has_temperature(),
                               {"Sources/Heat source", sources.heat_source},
                               1);
    body_force_         = make_source(model.has_displacement(),
                              {"Sources/Body force", sources.body_force},
                              dim);
    end_traction_       = make_source(model.has_displacement(),
                                {"Sources/End traction", sources.end_traction},
                                1);
    end_heat_flux_ =
      make_source(model.has_temperature(),
                  {"Sources/End heat flux", sources.end_heat_flux},
                  1);
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
