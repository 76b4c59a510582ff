// SPDX-License-Identifier: LGPL-2.1-or-later

#include <thermocontact/base/local_sums.h>
#include <thermocontact/space/cell_matrices.h>
#include <thermocontact/space/loads.h>

#include <deal.II/base/function.h>
#include <deal.II/base/quadrature_lib.h>

#include <deal.II/fe/fe_tools.h>

namespace ThermoContact
{
  namespace
  {
    /** Sources are no polynomials: more points than the products need. */
    template <int dim>
    unsigned int
    n_points(const Discretization<dim> &discretization)
    {
      return discretization.degree() + 3;
    }



    template <int dim>
    bool
    depends_on_time(const std::vector<ExpressionFunction<dim> *> &sources)
    {
      for (const ExpressionFunction<dim> *const source : sources)
        for (const Expression &component : source->components())
          if (component.depends_on("t"))
            return true;
      return false;
    }
  } // namespace



  template <int dim>
  Loads<dim>::Loads(const Scene               &scene,
                    const Discretization<dim> &discretization,
                    ProblemData<dim>          &data)
    : discretization(discretization)
    , data(data)
    , exchange_coefficient(scene.heat.linear_coefficient())
    , inertia(scene.material.inertia)
    , obstacle_mass(scene.obstacle_mass ? scene.obstacle_mass->mass : 0.)
    , has_nonlinear_terms(scene.sources.has_nonlinear_terms)
    , is_steady(!depends_on_time(data.sources))
    , fe_values(discretization.mapping(),
                discretization.finite_element(),
                QGauss<dim>(data.heat_source || data.body_force ?
                              n_points(discretization) :
                              1), // tables of high degrees are large
                update_values | update_quadrature_points | update_JxW_values)
    , face_values(discretization.mapping(),
                  discretization.finite_element(),
                  QGauss<dim - 1>(n_points(discretization)),
                  update_values | update_quadrature_points | update_JxW_values)
    , along_axis(Polynomials::generate_complete_Lagrange_basis(
        QGaussLobatto<1>(discretization.degree() + 1).get_points()))
    , lexicographic(FETools::hierarchic_to_lexicographic_numbering<dim>(
        discretization.degree()))
    , sources(discretization.make_ghosted_vector())
    , cell_load(discretization.finite_element().dofs_per_cell)
    , outer_heat_(discretization.make_vector(Field::temperature))
  {
    unconstrained.close();
    if (!scene.fields.has_temperature)
      return;
    integrate_face(contact_boundary_id,
                   Field::temperature,
                   nullptr,
                   scene.heat.obstacle_heat());
    if (scene.heat.left_exchange > 0.)
      integrate_face(fixed_boundary_id,
                     Field::temperature,
                     nullptr,
                     scene.heat.left_exchange *
                       scene.heat.fixed_end_temperature);
    HeatExchangeFaces<dim> faces(scene, discretization);
    if (scene.heat.has_lateral_exchange())
      for (const auto &cell :
           discretization.dof_handler().active_cell_iterators())
        if (cell->is_locally_owned() && !discretization.is_gap(cell))
          faces.visit(cell,
                      [&](const CellMatrix &exchange, const bool is_lateral) {
                        cell_load = 0.;
                        for (unsigned int i = 0; i < exchange.dofs.size(); ++i)
                          for (unsigned int j = 0;
                               is_lateral && j < exchange.dofs.size();
                               ++j)
                            cell_load(exchange.dofs[i]) +=
                              scene.heat.ambient_temperature *
                              exchange.matrix(i, j);
                        distribute(cell);
                      });
    sources.compress(VectorOperation::add);
    add_sources(Field::temperature, outer_heat_);
  }



  template <int dim>
  void
  Loads<dim>::assemble(const double time, Vector &heat, Vector &momentum)
  {
    set_equal(heat, outer_heat_);
    set_zero(momentum);
    if (!has_sources())
      return;
    if (steady_loads)
      {
        set_equal(heat, steady_loads->first);
        set_equal(momentum, steady_loads->second);
        return;
      }

    data.set_time(time);
    if (const auto entry = discretization.obstacle_entry(Field::displacement);
        entry && data.body_force)
      momentum.begin()[*entry] =
        obstacle_mass / inertia * sum_over_end(*data.body_force);
    if (data.heat_source || data.body_force || data.end_heat_flux ||
        data.left_heat_flux || data.left_traction || data.obstacle_warming ||
        (data.end_traction && discretization.row().is_given()))
      {
        sources = 0.;
        integrate_end(contact_boundary_id);
        integrate_end(fixed_boundary_id);
        if (data.heat_source || data.body_force)
          integrate_volume();
        sources.compress(VectorOperation::add);
        add_sources(Field::temperature, heat);
        add_sources(Field::displacement, momentum);
      }
    add_end_traction(momentum);
    if (is_steady)
      steady_loads.emplace(heat, momentum);
  }



  template <int dim>
  template <typename At>
  void
  Loads<dim>::add_up(const MeanOfTimes &times,
                     const At          &at,
                     Vector            &heat,
                     Vector            &momentum) const
  {
    at(times.front().time, heat, momentum);
    if (times.size() == 1 || is_steady)
      return;
    heat *= times.front().weight;
    momentum *= times.front().weight;
    Vector heat_then(heat), momentum_then(momentum);
    for (unsigned int i = 1; i < times.size(); ++i)
      {
        at(times[i].time, heat_then, momentum_then);
        heat.add(times[i].weight, heat_then);
        momentum.add(times[i].weight, momentum_then);
      }
  }



  template <int dim>
  void
  Loads<dim>::assemble(const MeanOfTimes &times, Vector &heat, Vector &momentum)
  {
    add_up(
      times,
      [this](const double time, Vector &h, Vector &m) { assemble(time, h, m); },
      heat,
      momentum);
  }



  template <int dim>
  double
  Loads<dim>::sum_over_end(const Function<dim> &load) const
  {
    double sum = 0.;
    for (const ContactNode<dim> &node : discretization.contact_end().nodes())
      sum += node.weight * load.value(node.position);
    return sum;
  }



  template <int dim>
  void
  Loads<dim>::add_end_traction(Vector &momentum) const
  {
    if (!data.end_traction || discretization.row().is_given())
      return;
    if (obstacle_mass > 0.)
      {
        if (const auto entry =
              discretization.obstacle_entry(Field::displacement))
          momentum.begin()[*entry] += sum_over_end(*data.end_traction);
      }
    else
      for (const auto &[node, entry] :
           discretization.contact_end().entries(Field::displacement))
        {
          const ContactNode<dim> &n =
            discretization.contact_end().nodes()[node];
          momentum.begin()[entry] +=
            n.weight * data.end_traction->value(n.position);
        }
  }



  template <int dim>
  void
  Loads<dim>::integrate_end(const types::boundary_id part)
  {
    if (part == contact_boundary_id)
      {
        if (data.end_heat_flux)
          integrate_face(part, Field::temperature, data.end_heat_flux.get());
        if (data.end_traction && discretization.row().is_given())
          integrate_face(part, Field::displacement, data.end_traction.get());
        if (data.obstacle_warming)
          integrate_face(part,
                         Field::temperature,
                         data.obstacle_warming.get(),
                         exchange_coefficient);
        return;
      }
    if (data.left_heat_flux)
      integrate_face(part, Field::temperature, data.left_heat_flux.get());
    if (data.left_traction) // outward is against x
      integrate_face(part, Field::displacement, data.left_traction.get(), -1.);
  }



  template <int dim>
  void
  Loads<dim>::assemble_end(const types::boundary_id part,
                           const double             time,
                           Vector                  &heat,
                           Vector                  &momentum)
  {
    data.set_time(time);
    set_zero(heat);
    set_zero(momentum);
    sources = 0.;
    integrate_end(part);
    sources.compress(VectorOperation::add);
    add_sources(Field::temperature, heat);
    add_sources(Field::displacement, momentum);
    if (part == contact_boundary_id)
      add_end_traction(momentum);
  }



  template <int dim>
  void
  Loads<dim>::assemble_end(const types::boundary_id part,
                           const MeanOfTimes       &times,
                           Vector                  &heat,
                           Vector                  &momentum)
  {
    add_up(
      times,
      [&](const double time, Vector &h, Vector &m) {
        assemble_end(part, time, h, m);
      },
      heat,
      momentum);
  }



  template <int dim>
  Vector
  Loads<dim>::weights_of_end(const types::boundary_id part,
                             const Field::Block       field)
  {
    Vector weights = discretization.make_vector(field);
    sources        = 0.;
    integrate_face(part, field, nullptr);
    sources.compress(VectorOperation::add);
    add_sources(field, weights);
    return weights;
  }



  template <int dim>
  void
  Loads<dim>::assemble_momentum_rate(const double time, Vector &momentum)
  {
    if (is_steady)
      {
        set_zero(momentum);
        return;
      }
    Vector unused(outer_heat_);
    for (ExpressionFunction<dim> *const source : data.sources)
      source->set_is_rate(true);
    assemble(time, unused, momentum);
    for (ExpressionFunction<dim> *const source : data.sources)
      source->set_is_rate(false);
  }



  template <int dim>
  void
  Loads<dim>::add_sources(const Field::Block field, Vector &load) const
  {
    if (!discretization.has_field(field))
      return;
    const Vector &part = sources.block(discretization.ghosted_block(field));
    for (unsigned int i = 0; i < load.locally_owned_size(); ++i)
      load.local_element(i) += part.local_element(i);
  }



  template <int dim>
  template <typename Factor>
  void
  Loads<dim>::add(const FEValuesBase<dim>        &values,
                  const CellShape<dim>           &cell,
                  const BoundingBox<dim>         &box,
                  const Function<dim>            &function,
                  const PiecewiseRule<dim> *const rule,
                  const Field::Block              field,
                  const Factor                   &factor)
  {
    const unsigned int first = discretization.first_component(field);
    for (unsigned int c = 0; c < function.n_components; ++c)
      {
        const auto value_at = [&](const Point<dim> &place,
                                  const double      weight) {
          return factor(place) * function.value(place, c) * weight;
        };
        if (rule != nullptr && !rule->is_smooth(box, c))
          {
            const Quadrature<dim> pieces = (*rule)(box, c);
            for (unsigned int q = 0; q < pieces.size(); ++q)
              {
                const Point<dim> place = pieces.point(q);
                const double     value =
                  value_at(place,
                           pieces.weight(q) *
                             discretization.geometry().weight_at(place));
                if (value != 0.)
                  add_at_point(cell.unit_point(place), first + c, value);
              }
          }
        else
          for (const unsigned int q : values.quadrature_point_indices())
            {
              const double value =
                value_at(values.quadrature_point(q),
                         discretization.geometry().weight(values, q));
              for (const unsigned int i : values.dof_indices())
                cell_load(i) +=
                  value * values.shape_value_component(i, q, first + c);
            }
      }
  }



  template <int dim>
  void
  Loads<dim>::add_at_point(const Point<dim>  &unit_point,
                           const unsigned int component,
                           const double       value)
  {
    const unsigned int n = along_axis.size();
    for (unsigned int d = 0; d < dim; ++d)
      {
        at_point[d].resize(n);
        for (unsigned int i = 0; i < n; ++i)
          at_point[d][i] = along_axis[i].value(unit_point[d]);
      }
    for (unsigned int i = 0; i < lexicographic.size(); ++i)
      {
        double product = value;
        for (unsigned int d = 0, rest = lexicographic[i]; d < dim; ++d)
          {
            product *= at_point[d][rest % n];
            rest /= n;
          }
        cell_load(discretization.finite_element().component_to_system_index(
          component, i)) += product;
      }
  }



  template <int dim>
  const PiecewiseRule<dim> *
  Loads<dim>::rule(const EnclosedFunction<dim> *const source)
  {
    if (source == nullptr)
      return nullptr;
    const auto [known, is_new] =
      rules.try_emplace(source,
                        *source,
                        BoundingBox<dim>(
                          {Point<dim>(), discretization.geometry().corner()}),
                        n_points(discretization));
    if (!is_new)
      known->second.update();
    return &known->second;
  }



  template <int dim>
  void
  Loads<dim>::integrate_face(const types::boundary_id     part,
                             const Field::Block           field,
                             const EnclosedFunction<dim> *load,
                             const double                 factor)
  {
    const Functions::ConstantFunction<dim> one(1.);
    const Function<dim>                   *function = &one;
    if (load != nullptr)
      function = load;
    const PiecewiseRule<dim> *const in_pieces = rule(load);
    for_each_face<dim>(part,
                       discretization.dof_handler(),
                       [&](const auto &cell, const unsigned int f) {
                         const CellShape<dim> shape(cell);
                         cell_load = 0.;
                         face_values.reinit(cell, f);
                         add(face_values,
                             shape,
                             shape.end_face(f),
                             *function,
                             in_pieces,
                             field,
                             [](const auto &) { return 1.; });
                         cell_load *= factor;
                         distribute(cell);
                       });
  }



  template <int dim>
  void
  Loads<dim>::integrate_volume()
  {
    const auto *const        heat_rule  = rule(data.heat_source.get()),
                      *const force_rule = rule(data.body_force.get());
    for (const auto &cell :
         discretization.dof_handler().active_cell_iterators())
      if (cell->is_locally_owned())
        {
          const auto factor = [&](double EquationFactors::*const part) {
            return [this, &cell, part](const Point<dim> &place) {
              return discretization.in_equations(cell, place).*part;
            };
          };
          cell_load = 0.;
          if (discretization.is_gap(cell))
            add_force_on_mass(cell);
          else
            {
              const CellShape<dim> shape(cell);
              fe_values.reinit(cell);
              if (heat_rule != nullptr)
                add(fe_values,
                    shape,
                    shape.bounding_box(),
                    *data.heat_source,
                    heat_rule,
                    Field::temperature,
                    factor(&EquationFactors::section));
              if (force_rule != nullptr)
                add(fe_values,
                    shape,
                    shape.bounding_box(),
                    *data.body_force,
                    force_rule,
                    Field::displacement,
                    factor(&EquationFactors::inertia));
            }
          distribute(cell);
        }
  }



  template <int dim>
  void
  Loads<dim>::add_force_on_mass(
    const typename DoFHandler<dim>::active_cell_iterator &cell)
  {
    const unsigned int right = 1;
    if (dim > 1)
      return; // of an obstacle it is there
    if (data.body_force && inertia > 0.)
      for (const RowMass &mass : discretization.row().masses)
        if (mass.vertex == cell->active_cell_index() + 1)
          cell_load(discretization.finite_element().component_to_system_index(
            discretization.first_component(Field::displacement), right)) +=
            mass.mass / inertia * data.body_force->value(cell->vertex(right));
  }



  template <int dim>
  void
  Loads<dim>::distribute(
    const typename DoFHandler<dim>::active_cell_iterator &cell)
  {
    std::vector<types::global_dof_index> dofs(cell_load.size());
    cell->get_dof_indices(dofs);
    unconstrained.distribute_local_to_global(cell_load, dofs, sources);
  }



  template class Loads<1>;
  template class Loads<2>;
  template class Loads<3>;
} // namespace ThermoContact
