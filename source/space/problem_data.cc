// SPDX-License-Identifier: LGPL-2.1-or-later

#include <thermocontact/base/number_text.h>
#include <thermocontact/space/problem_data.h>

#include <deal.II/base/function.h>

#include <algorithm>
#include <array>

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



    /** A function of the bodies of a row, each in its own coordinate. */
    class RowFunction : public EnclosedFunction<1>
    {
    public:
      RowFunction(const BodyRow                         &row,
                  std::vector<std::vector<Expression>> &&of_bodies,
                  const std::vector<double>             &before)
        : EnclosedFunction<1>(before.size())
        , row(row)
        , of_bodies(std::move(of_bodies))
        , before(before)
      {}

      double
      value(const Point<1> &place, const unsigned int component) const override
      {
        if (place[0] < row.bodies.front().begin)
          return before[component]; // the vertex before a first mass
        return evaluate<double>(place[0], component, [&](const double begin) {
          return place[0] - begin;
        });
      }

      bool
      varies_along(const unsigned int, const unsigned int) const override
      {
        return true; // from body to body
      }

      NumberJet
      derivatives(const Point<1> &place,
                  const unsigned int,
                  const unsigned int component) const override
      {
        return evaluate<NumberJet>(place[0],
                                   component,
                                   [&](const double begin) {
                                     return NumberJet(place[0] - begin, 1., 0.);
                                   });
      }

      IntervalJet
      enclosure(const BoundingBox<1> &box,
                const unsigned int,
                const unsigned int component) const override
      {
        return evaluate<IntervalJet>(
          box.center()[0], component, [&](const double begin) {
            return IntervalJet(Interval(box.lower_bound(0) - begin,
                                        box.upper_bound(0) - begin),
                               1.,
                               0.);
          });
      }

      /** Of all bodies, each in its own length. */
      double
      bound(const BoundingBox<1> &, const unsigned int component) const override
      {
        double bound = 0.;
        for (const RowBody &body : row.bodies)
          bound = std::max(bound,
                           EnclosedFunction<1>::bound({{Point<1>(body.begin),
                                                        Point<1>(body.end)}},
                                                      component));
        return bound;
      }

    private:
      const BodyRow                             &row;
      const std::vector<std::vector<Expression>> of_bodies;
      const std::vector<double>                  before;

      /** @param own the coordinate of a body that begins there */
      template <typename Number, typename Own>
      Number
      evaluate(const double       x,
               const unsigned int component,
               const Own         &own) const
      {
        const RowBody              &body      = row.body_at(x);
        const std::array<Number, 4> variables = {{own(body.begin)}};
        return of_bodies[&body - row.bodies.data()][component].evaluate(
          variables.data());
      }
    };



    /** The same of a row, (M10.1). */
    std::unique_ptr<EnclosedFunction<1>>
    initial_function_of_row(const Scene &scene, const bool is_rate)
    {
      std::vector<std::vector<Expression>> all;
      std::vector<double>                  before;
      for (const RowBody &body : scene.row.bodies)
        {
          std::vector<Expression> components;
          before.clear();
          const auto add = [&](const std::string &entry,
                               const std::string &text,
                               const double       value_before) {
            const std::string path = "Bodies/" + body.name + "/" + entry;
            components.emplace_back(path, text, scene.parameters.names(path));
            before.push_back(value_before);
          };
          if (scene.fields.has_temperature)
            add("Temperature",
                is_rate ? "0" : body.temperature,
                is_rate ? 0. : scene.heat.fixed_end_temperature);
          if (scene.fields.has_displacement && is_rate)
            add("Velocity",
                scene.material.has_inertia() ? body.velocity : "0",
                0.);
          else if (scene.fields.has_displacement)
            add("Displacement",
                scene.material.is_static() ? "0" : body.displacement,
                0.);
          all.push_back(std::move(components));
        }
      return std::make_unique<RowFunction>(scene.row, std::move(all), before);
    }



    /** Initial values of the fields, or their rates, one after the other. */
    template <int dim>
    std::unique_ptr<EnclosedFunction<dim>>
    initial_function(const Scene &scene, const bool is_rate)
    {
      if constexpr (dim == 1)
        if (scene.row.is_given())
          return initial_function_of_row(scene, is_rate);
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
  contact_gap(const Scene &scene)
  {
    if (!scene.contact.law->is_active() ||
        (scene.contact.has_uniform_gap() && !scene.sources.has_moving_obstacle))
      return std::make_unique<Functions::ConstantFunction<dim>>(
        scene.contact.gap);
    return std::make_unique<ExpressionFunction<dim>>(
      std::vector<Expression>{*scene.gap_expression});
  }



  namespace
  {
    /** A source, or null where it does not act. */
    template <int dim>
    std::unique_ptr<ExpressionFunction<dim>>
    source(const Scene       &scene,
           const bool         acts,
           const std::string &entry,
           const std::string &text,
           const unsigned int n_components = 1)
    {
      if (!acts)
        return nullptr;
      return std::make_unique<ExpressionFunction<dim>>(
        read_entry(scene, entry, text, n_components));
    }



    template <int dim>
    std::unique_ptr<ExpressionFunction<dim>>
    warming(const Scene &scene)
    {
      if (!scene.sources.has_varying_obstacle)
        return nullptr;
      const Expression &temperature = *scene.heat.obstacle_drive;
      return std::make_unique<ExpressionFunction<dim>>(std::vector<Expression>{
        Expression(temperature.path(),
                   "(" + temperature.text() + ") - (" +
                     significant(scene.heat.obstacle_temperature, all_digits) +
                     ")",
                   scene.parameters.names(temperature.path()))});
    }



    template <int dim>
    std::vector<ExpressionFunction<dim> *>
    nonzero_sources(
      const std::vector<const typename ProblemData<dim>::Data *> &sources)
    {
      std::vector<ExpressionFunction<dim> *> all;
      for (const auto *const source : sources)
        if (*source)
          all.push_back(source->get());
      return all;
    }
  } // namespace



  template <int dim>
  ProblemData<dim>::ProblemData(const Scene &scene)
    : initial_fields(initial_function<dim>(scene, false))
    , initial_velocity(initial_function<dim>(scene, true))
    , heat_source(source<dim>(scene,
                              scene.sources.has_heat_source,
                              "Sources/Heat source",
                              scene.parameters.sources.heat_source))
    , body_force(source<dim>(scene,
                             scene.sources.has_body_force,
                             "Sources/Body force",
                             scene.parameters.sources.body_force,
                             dim))
    , end_traction(source<dim>(scene,
                               scene.sources.has_end_traction,
                               "Boundary/right/Traction",
                               scene.parameters.boundary.right.traction))
    , end_heat_flux(source<dim>(scene,
                                scene.sources.has_end_heat_flux,
                                "Boundary/right/Heat flux",
                                scene.parameters.boundary.right.heat_flux))
    , left_traction(source<dim>(scene,
                                scene.sources.has_left_traction,
                                "Boundary/left/Traction",
                                scene.parameters.boundary.left.traction))
    , left_heat_flux(source<dim>(scene,
                                 scene.sources.has_left_heat_flux,
                                 "Boundary/left/Heat flux",
                                 scene.parameters.boundary.left.heat_flux))
    , obstacle_warming(warming<dim>(scene))
    , sources(nonzero_sources<dim>({&heat_source,
                                    &body_force,
                                    &end_traction,
                                    &end_heat_flux,
                                    &left_traction,
                                    &left_heat_flux,
                                    &obstacle_warming}))
  {}



  template <int dim>
  bool
  ProblemData<dim>::is_along_axis() const
  {
    std::vector<const Function<dim> *> functions(sources.begin(),
                                                 sources.end());
    functions.push_back(initial_fields.get());
    functions.push_back(initial_velocity.get());
    for (const Function<dim> *const any : functions)
      {
        const auto *const function =
          dynamic_cast<const ExpressionFunction<dim> *>(any);
        if (function == nullptr)
          continue; // of a row
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
    for (ExpressionFunction<dim> *const source : sources)
      source->set_time(time);
  }



  template std::unique_ptr<Function<1>>
  contact_gap(const Scene &);
  template std::unique_ptr<Function<2>>
  contact_gap(const Scene &);
  template std::unique_ptr<Function<3>>
  contact_gap(const Scene &);

  template struct ProblemData<1>;
  template struct ProblemData<2>;
  template struct ProblemData<3>;
} // namespace ThermoContact
