// SPDX-License-Identifier: LGPL-2.1-or-later

#include <thermocontact/base/number_text.h>
#include <thermocontact/input/expression.h>
#include <thermocontact/space/problem_data.h>

#include <deal.II/base/function.h>
#include <deal.II/base/numbers.h>

namespace ThermoContact
{
  namespace
  {
    /** Initial values of the fields that a scene has, one text for all. */
    template <int dim>
    class InitialTexts
    {
    public:
      std::string fields;
      std::string rates;

      InitialTexts(const Scene &scene, const ExpressionNames &names)
      {
        const auto &initial = scene.parameters.initial_values;
        if (scene.fields.has_temperature)
          {
            append("Temperature", initial.temperature, 1, names, fields);
            rates = "0";
          }
        if (!scene.fields.has_displacement)
          return;
        append("Displacement",
               scene.material.is_static() ? "0" : initial.displacement,
               dim,
               names,
               fields);
        append("Velocity",
               scene.material.has_inertia() ? initial.velocity : "0",
               dim,
               names,
               rates);
      }

    private:
      static void
      append(const std::string     &entry,
             const std::string     &expression,
             const unsigned int     n_components,
             const ExpressionNames &names,
             std::string           &text)
      {
        text += (text.empty() ? "" : ";") +
                check_expression<dim>({"Initial values/" + entry, expression},
                                      n_components,
                                      names);
      }
    };
  } // namespace



  template <int dim>
  std::unique_ptr<Function<dim>>
  contact_gap(const SpatialScene &scene)
  {
    if (scene.gap_expression.empty())
      return std::make_unique<Functions::ConstantFunction<dim>>(scene.gap);
    ExpressionNames names; // x is known too: it is one on the end
    names.constants["pi"] = numbers::PI;
    names.has_time        = true;
    names.example         = dim > 1 ? "0.1+(y-0.05)^2/2" : "0.1+0.02*sin(t)";
    return make_function<dim>(
      check_expression<dim>({"Contact/Gap", scene.gap_expression}, 1, names),
      names);
  }



  namespace
  {
    template <int dim>
    std::unique_ptr<FunctionParser<dim>>
    make_obstacle_warming(const Scene &scene)
    {
      const ExpressionNames names = obstacle_names();
      const std::string     expression =
        check_expression<dim>({"Boundary/Obstacle temperature",
                               scene.parameters.boundary.obstacle_expression},
                              1,
                              names);
      return make_function<dim>("(" + expression + ")-(" +
                                  significant(scene.heat.obstacle_temperature,
                                              all_digits) +
                                  ")",
                                names);
    }
  } // namespace



  template <int dim>
  ProblemData<dim>::ProblemData(const Scene &scene)
  {
    ExpressionNames names;
    names.constants["pi"] = numbers::PI;
    if (scene.fields.has_temperature)
      names.constants["theta_A"] = scene.heat.fixed_end_temperature;
    const InitialTexts<dim> initial(scene, names);
    initial_fields_   = make_function<dim>(initial.fields, names);
    initial_velocity_ = make_function<dim>(initial.rates, names);

    names.has_time         = true;
    const auto make_source = [&](const bool         acts,
                                 const Expression  &expression,
                                 const unsigned int n_components) {
      return acts ? make_function<dim>(check_expression<dim>(expression,
                                                             n_components,
                                                             names),
                                       names) :
                    nullptr;
    };
    const SourceParameters &sources = scene.parameters.sources;
    heat_source_                    = make_source(scene.sources.has_heat_source,
                               {"Sources/Heat source", sources.heat_source},
                               1);
    body_force_                     = make_source(scene.sources.has_body_force,
                              {"Sources/Body force", sources.body_force},
                              dim);
    end_traction_ = make_source(scene.sources.has_end_traction,
                                {"Sources/End traction", sources.end_traction},
                                1);
    end_heat_flux_ =
      make_source(scene.sources.has_end_heat_flux,
                  {"Sources/End heat flux", sources.end_heat_flux},
                  1);
    if (scene.sources.has_varying_obstacle)
      obstacle_warming_ = make_obstacle_warming<dim>(scene);
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
  const Function<dim> *
  ProblemData<dim>::obstacle_warming() const
  {
    return obstacle_warming_.get();
  }



  template <int dim>
  bool
  ProblemData<dim>::has_sources() const
  {
    return heat_source_ || body_force_ || end_traction_ || end_heat_flux_ ||
           obstacle_warming_;
  }



  template <int dim>
  void
  ProblemData<dim>::set_time(const double time)
  {
    for (FunctionParser<dim> *source : {heat_source_.get(),
                                        body_force_.get(),
                                        end_traction_.get(),
                                        end_heat_flux_.get(),
                                        obstacle_warming_.get()})
      if (source != nullptr)
        source->set_time(time);
  }



  template std::unique_ptr<Function<1>>
  contact_gap(const SpatialScene &);
  template std::unique_ptr<Function<2>>
  contact_gap(const SpatialScene &);
  template std::unique_ptr<Function<3>>
  contact_gap(const SpatialScene &);

  template class ProblemData<1>;
  template class ProblemData<2>;
  template class ProblemData<3>;
} // namespace ThermoContact
