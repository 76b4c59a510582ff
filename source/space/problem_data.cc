// SPDX-License-Identifier: LGPL-2.1-or-later

#include <thermocontact/base/number_text.h>
#include <thermocontact/space/problem_data.h>

#include <deal.II/base/function.h>

namespace ThermoContact
{
  namespace
  {
    /** An entry as components in the coordinates, and in t of sources. */
    std::vector<Expression>
    read_entry(const Scene       &scene,
               const std::string &path,
               const std::string &text,
               const unsigned int n_components)
    {
      ExpressionNames names = scene.parameters.names(path);
      if (scene.fields.has_temperature)
        names.constants["theta_A"] = scene.heat.fixed_end_temperature;
      return read_components(path, text, n_components, names);
    }



    /** Initial values of the fields, or their rates, one after the other. */
    template <int dim>
    std::unique_ptr<ExpressionFunction<dim>>
    initial_function(const Scene &scene, const bool is_rate)
    {
      const InitialValuesParameters &initial = scene.parameters.initial_values;
      std::vector<Expression>        components;
      const auto                     add = [&](const std::string &entry,
                           const std::string &text,
                           const unsigned int n) {
        for (Expression &component :
             read_entry(scene, "Initial values/" + entry, text, n))
          components.push_back(std::move(component));
      };
      if (scene.fields.has_temperature)
        add("Temperature", is_rate ? "0" : initial.temperature, 1);
      if (scene.fields.has_displacement && is_rate)
        add("Velocity",
            scene.material.has_inertia() ? initial.velocity : "0",
            dim);
      else if (scene.fields.has_displacement)
        add("Displacement",
            scene.material.is_static() ? "0" : initial.displacement,
            dim);
      return std::make_unique<ExpressionFunction<dim>>(std::move(components));
    }
  } // namespace



  template <int dim>
  std::unique_ptr<Function<dim>>
  contact_gap(const SpatialScene &scene)
  {
    if (!scene.gap_expression)
      return std::make_unique<Functions::ConstantFunction<dim>>(scene.gap);
    return std::make_unique<ExpressionFunction<dim>>(
      std::vector<Expression>{*scene.gap_expression});
  }



  template <int dim>
  ProblemData<dim>::ProblemData(const Scene &scene)
    : initial_fields_(initial_function<dim>(scene, false))
    , initial_velocity_(initial_function<dim>(scene, true))
  {
    const auto make_source = [&](const bool         acts,
                                 const std::string &entry,
                                 const std::string &text,
                                 const unsigned int n_components) {
      return acts ?
               std::make_unique<ExpressionFunction<dim>>(
                 read_entry(scene, "Sources/" + entry, text, n_components)) :
               nullptr;
    };
    const SourceParameters &sources = scene.parameters.sources;
    heat_source_                    = make_source(scene.sources.has_heat_source,
                               "Heat source",
                               sources.heat_source,
                               1);
    body_force_                     = make_source(scene.sources.has_body_force,
                              "Body force",
                              sources.body_force,
                              dim);
    end_traction_  = make_source(scene.sources.has_end_traction,
                                "End traction",
                                sources.end_traction,
                                1);
    end_heat_flux_ = make_source(scene.sources.has_end_heat_flux,
                                 "End heat flux",
                                 sources.end_heat_flux,
                                 1);
    if (!scene.sources.has_varying_obstacle)
      return;
    const Expression &temperature = *scene.heat.obstacle_drive;
    obstacle_warming_ =
      std::make_unique<ExpressionFunction<dim>>(std::vector<Expression>{
        Expression(temperature.path(),
                   "(" + temperature.text() + ") - (" +
                     significant(scene.heat.obstacle_temperature, all_digits) +
                     ")",
                   scene.parameters.names(temperature.path()))});
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
  const ExpressionFunction<dim> *
  ProblemData<dim>::heat_source() const
  {
    return heat_source_.get();
  }



  template <int dim>
  const ExpressionFunction<dim> *
  ProblemData<dim>::body_force() const
  {
    return body_force_.get();
  }



  template <int dim>
  const ExpressionFunction<dim> *
  ProblemData<dim>::end_traction() const
  {
    return end_traction_.get();
  }



  template <int dim>
  const ExpressionFunction<dim> *
  ProblemData<dim>::end_heat_flux() const
  {
    return end_heat_flux_.get();
  }



  template <int dim>
  const ExpressionFunction<dim> *
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
  bool
  ProblemData<dim>::is_along_axis() const
  {
    for (const ExpressionFunction<dim> *function : {initial_fields_.get(),
                                                    initial_velocity_.get(),
                                                    heat_source_.get(),
                                                    body_force_.get(),
                                                    end_traction_.get(),
                                                    end_heat_flux_.get(),
                                                    obstacle_warming_.get()})
      if (function != nullptr)
        {
          const std::vector<Expression> &components = function->components();
          const std::size_t              n          = components.size();
          for (std::size_t c = 0; c < n; ++c)
            {
              const bool is_across = n >= dim && c > n - dim;
              if (components[c].depends_on("y") ||
                  components[c].depends_on("z") ||
                  (is_across && !(components[c].is_constant() &&
                                  function->value(Point<dim>(), c) == 0.)))
                return false;
            }
        }
    return true;
  }



  template <int dim>
  void
  ProblemData<dim>::set_time(const double time)
  {
    for (ExpressionFunction<dim> *source : {heat_source_.get(),
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
