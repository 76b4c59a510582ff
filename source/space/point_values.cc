// SPDX-License-Identifier: LGPL-2.1-or-later

#include <thermocontact/base/collective.h>
#include <thermocontact/base/exceptions.h>
#include <thermocontact/base/special_numbers.h>
#include <thermocontact/base/tolerances.h>
#include <thermocontact/space/cell_shape.h>
#include <thermocontact/space/point_values.h>
#include <thermocontact/space/shown_fields.h>

#include <algorithm>
#include <map>
#include <tuple>

namespace ThermoContact
{
  template <int dim>
  std::vector<Place<dim>>
  places_on_axis(const Discretization<dim> &discretization)
  {
    const auto on_axis = [&](const double x) {
      return discretization.geometry().on_axis(x);
    };
    std::vector<std::pair<double, double>> intervals;
    for (const auto &cell :
         discretization.dof_handler().active_cell_iterators())
      if (cell->is_locally_owned() && !discretization.is_gap(cell))
        if (const auto interval = CellShape<dim>(cell).interval(on_axis(0.)))
          intervals.push_back(*interval);
    std::vector<std::pair<double, double>> all;
    for (const auto &of_rank :
         all_gather(discretization.communicator(), intervals))
      all.insert(all.end(), of_rank.begin(), of_rank.end());
    std::sort(all.begin(), all.end());

    std::vector<Place<dim>> places;
    const unsigned int      p        = discretization.degree();
    double                  last_mid = 0.;
    for (const auto &[left, right] : all)
      if (left >= last_mid) // else the same interval, on the other side
        {
          // cells on different sides may round the place where they meet
          const double begin =
            places.empty() ||
                left - places.back().position[0] >
                  Tolerances::rounding_of_data * discretization.row().length() ?
              left :
              places.back().position[0];
          last_mid = 0.5 * (left + right);
          for (unsigned int i = 0; i <= p; ++i)
            places.push_back(
              {on_axis(i == p ? right : begin + (right - begin) * i / p),
               on_axis(last_mid)});
        }
    return places;
  }



  template <int dim>
  PointValues<dim>::PointValues(const Scene                   &scene,
                                const Discretization<dim>     &discretization,
                                const std::vector<Place<dim>> &places)
    : scene(scene)
    , discretization(discretization)
    , n_places(places.size())
    , values(n_quantities * places.size())
    , axial_values(places.size())
  {
    std::vector<Share> shares;
    visit_cells(places, [&](const Cell &cell, const unsigned int place) {
      add_shares(cell, places[place].position, place, shares);
    });
    const auto all_shares = all_gather(discretization.communicator(), shares);

    // a share of form n_forms counts the cells of a place
    std::vector<double> n_cells(n_places, 0.);
    for (const auto &of_rank : all_shares)
      for (const Share &share : of_rank)
        if (share.form == n_forms)
          n_cells[share.place] += share.weight;
    Assert(std::count(n_cells.begin(), n_cells.end(), 0.) == 0,
           ExcMessage("a place is not in the body"));

    using Key = std::tuple<unsigned int, unsigned int, unsigned int>;
    std::map<Key, double> weights;
    for (const auto &of_rank : all_shares)
      for (const Share &share : of_rank)
        if (share.form != n_forms)
          {
            const IndexSet &owned =
              discretization.owned_by_block()[share.form == temperature_form ||
                                                  share.form == thermal_form ?
                                                Field::temperature :
                                                Field::displacement];
            if (owned.is_element(share.dof))
              weights[{
                share.form, share.place, owned.index_within_set(share.dof)}] +=
                share.weight / n_cells[share.place];
          }
    for (const auto &[key, weight] : weights)
      terms[std::get<0>(key)].push_back(
        {std::get<1>(key), std::get<2>(key), weight});
    if (scene.sources.has_nonlinear_terms && scene.fields.has_displacement)
      find_nonlinear_places(places, n_cells);
  }



  template <int dim>
  void
  PointValues<dim>::find_nonlinear_places(const std::vector<Place<dim>> &places,
                                          const std::vector<double> &n_cells)
  {
    visit_cells(places, [&](const Cell &cell, const unsigned int place) {
      const Point<dim> &position = places[place].position;
      NonlinearPlace    one{place, cell, position, 1. / n_cells[place], {}, {}};
      for (const BasisAt &f : basis_at(cell, position))
        {
          one.value.push_back(f.theta);
          one.stress.push_back(f.stress);
        }
      nonlinear_places.push_back(one);
    });
  }



  template <int dim>
  void
  PointValues<dim>::add_nonlinear_stress(const State &state)
  {
    const ShownFields<dim>               shown(scene, discretization, state);
    std::vector<types::global_dof_index> dofs(
      discretization.finite_element().dofs_per_cell);
    CollectedErrors<InputError> errors;
    for (const NonlinearPlace &one : nonlinear_places)
      {
        one.cell->get_dof_indices(dofs);
        double theta = 0., elastic = 0., of_rate = 0.;
        for (unsigned int i = 0; i < dofs.size(); ++i)
          {
            theta += one.value[i] * shown.values()(dofs[i]);
            elastic += one.stress[i] * shown.values()(dofs[i]);
            of_rate += one.stress[i] * shown.velocities()(dofs[i]);
          }
        errors.collect([&]() {
          values[stress * n_places + one.place] +=
            one.weight *
            shown.stress(
              one.cell, one.position, theta, theta, elastic, of_rate);
        });
      }
    errors.throw_on_all_ranks(discretization.communicator());
  }



  template <int dim>
  void
  PointValues<dim>::add_linear_stress(const State  &state,
                                      const Vector &velocity)
  {
    add_values(strain_form, state.displacement, 1., stress);
    const Material &material   = scene.material;
    const bool      has_bodies = discretization.has_bodies();
    if (material.has_viscosity())
      add_values(has_bodies ? viscous_form : strain_form,
                 velocity,
                 material.viscosity,
                 stress);
    if (material.has_thermal_stress())
      add_values(has_bodies ? thermal_form : temperature_form,
                 state.temperature,
                 -material.thermal_stress,
                 stress);
  }



  template <int dim>
  template <typename Visit>
  void
  PointValues<dim>::visit_cells(const std::vector<Place<dim>> &places,
                                const Visit                   &visit) const
  {
    // by x, so that the places of a cell are found among many
    std::multimap<double, unsigned int> by_x;
    for (unsigned int place = 0; place < n_places; ++place)
      by_x.emplace(places[place].cell_point[0], place);
    for (const auto &cell :
         discretization.dof_handler().active_cell_iterators())
      if (cell->is_locally_owned() && !discretization.is_gap(cell))
        {
          const CellShape<dim> shape(cell);
          const auto [left, right] = shape.range();
          for (auto place = by_x.lower_bound(left);
               place != by_x.end() && place->first <= right;
               ++place)
            if (shape.contains(places[place->second].cell_point))
              visit(cell, place->second);
        }
  }



  template <int dim>
  std::vector<typename PointValues<dim>::BasisAt>
  PointValues<dim>::basis_at(const Cell &cell, const Point<dim> &position) const
  {
    const CellShape<dim>      shape(cell);
    const Point<dim>          unit_point = shape.unit_point(position);
    const FiniteElement<dim> &fe         = discretization.finite_element();
    const FiniteElement<dim> &base       = fe.base_element(0);
    const unsigned int        first =
      discretization.first_component(Field::displacement);
    const auto rounded = [](const double value) {
      const double node_value = std::round(value);
      return std::abs(value - node_value) < Tolerances::rounding_of_solution ?
               node_value :
               value;
    };
    const Elasticity     elasticity = discretization.elasticity(cell, position);
    std::vector<BasisAt> all(fe.dofs_per_cell);
    for (unsigned int i = 0; i < all.size(); ++i)
      {
        const auto [component, node] = fe.system_to_component_index(i);
        const double value           = base.shape_value(node, unit_point);
        if (discretization.has_field(Field::temperature) && component == 0)
          {
            all[i].theta = rounded(value);
            continue;
          }
        const unsigned int d = component - first;
        if (d == 0)
          all[i].displacement = rounded(value);
        Tensor<1, dim> values;
        Tensor<2, dim> gradient;
        values[d]     = value;
        gradient[d]   = shape.gradient(base, node, unit_point);
        all[i].stress = elastic_stress(
          elasticity,
          discretization.geometry().strain(gradient, values, position))[0][0];
      }
    return all;
  }



  template <int dim>
  void
  PointValues<dim>::add_shares(const Cell         &cell,
                               const Point<dim>   &position,
                               const unsigned int  place,
                               std::vector<Share> &shares) const
  {
    const std::vector<BasisAt>           basis = basis_at(cell, position);
    std::vector<types::global_dof_index> dofs(basis.size());
    cell->get_dof_indices(dofs);
    const types::global_dof_index offset =
      discretization.first_dof(Field::displacement);
    const auto add = [&](const Form                    form,
                         const types::global_dof_index dof,
                         const double                  weight) {
      if (weight != 0.)
        shares.push_back({form, place, dof, weight});
    };
    const bool            has_bodies = discretization.has_bodies();
    const bool            is_linear  = !scene.sources.has_nonlinear_terms;
    const EquationFactors in_equations =
      discretization.in_equations(cell, position);
    const double section = discretization.of_material(cell, position).section;
    for (unsigned int i = 0; i < dofs.size(); ++i)
      {
        const BasisAt &f = basis[i];
        add(temperature_form, dofs[i], f.theta);
        add(displacement_form, dofs[i] - offset, f.displacement);
        if (is_linear)
          add(strain_form,
              dofs[i] - offset,
              f.stress * in_equations.stiffness / section);
        if (!is_linear || !has_bodies)
          continue;
        add(thermal_form, dofs[i], f.theta * in_equations.coupling / section);
        add(viscous_form,
            dofs[i] - offset,
            f.stress * in_equations.viscosity / section);
      }
    shares.push_back({n_forms, place, 0, 1.});
  }



  template <int dim>
  void
  PointValues<dim>::add_values(const Form     form,
                               const Vector  &vector,
                               const double   factor,
                               const Quantity quantity)
  {
    const double *const local  = vector.begin();
    double *const       result = values.data() + quantity * n_places;
    for (const Term &term : terms[form])
      result[term.place] += factor * term.weight * local[term.entry];
  }



  template <int dim>
  const std::vector<double> &
  PointValues<dim>::evaluate(const State &state)
  {
    std::fill(values.begin(), values.end(), 0.);
    add_values(temperature_form, state.temperature, 1., temperature);
    add_values(displacement_form, state.displacement, 1., displacement);
    const Vector &v = shown_velocity(scene, state, velocity_memory);
    add_values(displacement_form, v, 1., velocity);
    if (scene.sources.has_nonlinear_terms && scene.fields.has_displacement)
      add_nonlinear_stress(state);
    else
      add_linear_stress(state, v);
    if (Utilities::MPI::n_mpi_processes(discretization.communicator()) > 1)
      Utilities::MPI::sum(values, discretization.communicator(), values);

    if (!scene.fields.has_temperature)
      set_absent(temperature);
    for (const Quantity quantity : {displacement, velocity, stress})
      if (!scene.fields.has_displacement)
        set_absent(quantity);
    if (scene.material.is_static() && state.was_moved_at_once())
      set_absent(velocity);
    return values;
  }



  template <int dim>
  const std::vector<double> &
  PointValues<dim>::evaluate_axial(const Vector &vector)
  {
    std::fill(axial_values.begin(), axial_values.end(), 0.);
    for (const Term &term : terms[displacement_form])
      axial_values[term.place] += term.weight * vector.begin()[term.entry];
    if (Utilities::MPI::n_mpi_processes(discretization.communicator()) > 1)
      Utilities::MPI::sum(axial_values,
                          discretization.communicator(),
                          axial_values);
    return axial_values;
  }



  template <int dim>
  void
  PointValues<dim>::set_absent(const Quantity quantity)
  {
    std::fill_n(values.begin() + quantity * n_places, n_places, nan);
  }



  template class PointValues<1>;
  template class PointValues<2>;
  template class PointValues<3>;

  template std::vector<Place<1>>
  places_on_axis(const Discretization<1> &);
  template std::vector<Place<2>>
  places_on_axis(const Discretization<2> &);
  template std::vector<Place<3>>
  places_on_axis(const Discretization<3> &);
} // namespace ThermoContact
