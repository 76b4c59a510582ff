// SPDX-License-Identifier: LGPL-2.1-or-later

#include <thermocontact/base/dealii_versions.h>
#include <thermocontact/base/tolerances.h>
#include <thermocontact/space/cell_shape.h>
#include <thermocontact/space/discretization.h>

#include <deal.II/base/mpi.h>

#include <deal.II/dofs/dof_renumbering.h>
#include <deal.II/dofs/dof_tools.h>

#include <deal.II/fe/fe_q.h>

#include <deal.II/grid/grid_generator.h>

#include <deal.II/numerics/vector_tools_boundary.h>

#include <algorithm>

namespace ThermoContact
{
  namespace
  {
    /** A body whose coefficients are those of the scene. */
    const EquationFactors one_everywhere{1., 1., 1., 1., 1., 1., 1.};



    /** Several ranks share the cells; p4est takes time. */
    template <int dim>
    std::unique_ptr<Triangulation<dim>>
    make_triangulation(const MPI_Comm communicator)
    {
      if constexpr (dim > 1)
        if (Utilities::MPI::n_mpi_processes(communicator) > 1)
          return std::make_unique<parallel::distributed::Triangulation<dim>>(
            communicator);
      return std::make_unique<Triangulation<dim>>();
    }
  } // namespace



  template <int dim>
  Discretization<dim>::Discretization(const SpatialScene &scene,
                                      const MPI_Comm      all)
    : communicator_(DimensionTraits<dim>::communicator(all))
    , geometry_(scene)
    , triangulation(make_triangulation<dim>(communicator_))
    , finite_element_(FE_Q<dim>(scene.mesh.degree),
                      scene.fields.n_components(dim))
    , mapping_(1)
    , dof_handler_(*triangulation)

    , constrained_entries_(2)
    , is_held_left_{{scene.row.begins_with_mass() ||
                       scene.has_given_temperature,
                     scene.row.begins_with_mass() || !scene.has_free_end}}
    , is_held_right_{{scene.has_right_temperature, scene.has_clamped_right}}
    , row_(scene.row)
    , profile(scene.profile)
    , elasticity_(scene.material.elasticity())
    , exchange_coefficient_(scene.exchange_coefficient)
  {
    make_grid(scene);
    distribute_dofs(scene.fields);
    if (scene.obstacle_mass)
      find_obstacle();
    constraints_ =
      make_constraints(held_components(scene), scene.has_pins, false);
    collect_constrained();
    collect_nodal_values();
    if (dim > 1)
      add_ghosts_of_cells();
    contact_end_ = std::make_unique<const ContactEnd<dim>>(*this);
  }



  template <int dim>
  double
  Discretization<dim>::largest_constrained(const Field::Block field,
                                           const Vector      &vector,
                                           const double       value,
                                           const double       at_right) const
  {
    double largest = 0.;
    for (const unsigned int entry : constrained_entries(field))
      largest = std::max(largest,
                         std::abs(vector.begin()[entry] -
                                  (is_right_end(entry) ? at_right : value)));
    return Utilities::MPI::max(largest, communicator());
  }



  namespace
  {
    /** The cells of bodies before their refinements; faces have their ids. */
    template <int dim>
    void
    make_boxes(const SpatialScene &scene,
               const Point<dim>   &corner,
               Triangulation<dim> &grid)
    {
      const MeshParameters            &mesh     = scene.mesh;
      const bool                       colorize = true;
      std::vector<std::vector<double>> sizes(dim);
      if (scene.row.is_given())
        for (const RowCell &cell : scene.row.cells)
          sizes[0].push_back(cell.size);
      else if (mesh.has_equal_cells())
        {
          std::vector<unsigned int> repetitions(dim,
                                                mesh.n_cells_across() >>
                                                  scene.n_halvings);
          repetitions[0] = mesh.cells >> scene.n_halvings;
          GridGenerator::subdivided_hyper_rectangle(
            grid, repetitions, Point<dim>(), corner, colorize);
          return;
        }
      else
        {
          sizes.assign(dim, mesh.cell_sizes_across());
          sizes[0] = mesh.cell_sizes();
        }
      GridGenerator::subdivided_hyper_rectangle(
        grid, sizes, Point<dim>(), corner, colorize);
    }
  } // namespace



  template <int dim>
  void
  Discretization<dim>::make_grid(const SpatialScene &scene)
  {
    const Point<dim> corner = geometry_.corner();
    if (!scene.obstacle_mass)
      make_boxes(scene, corner, *triangulation);
    else
      {
        Triangulation<dim> body, obstacle;
        make_boxes(scene, corner, body);
        Point<dim> lower, upper(corner); // anywhere beside the body
        lower[0] = 2. * corner[0];
        upper[0] = 3. * corner[0];
        GridGenerator::hyper_rectangle(obstacle, lower, upper);
        GridGenerator::merge_triangulations(body, obstacle, *triangulation);
        auto of_body = body.begin();
        for (const auto &cell : triangulation->cell_iterators_on_level(0))
          {
            const bool is_of_body = of_body != body.end();
            if (!is_of_body)
              cell->set_material_id(obstacle_material);
            for (const unsigned int face : cell->face_indices())
              if (cell->face(face)->at_boundary())
                cell->face(face)->set_boundary_id(
                  is_of_body ? of_body->face(face)->boundary_id() :
                               obstacle_boundary);
            if (is_of_body)
              ++of_body;
          }
      }
    if (!scene.row.is_given())
      triangulation->refine_global(scene.mesh.refinements + scene.n_halvings);
  }



  template <int dim>
  void
  Discretization<dim>::find_obstacle()
  {
    // a vertex of its first cell moves, all other nodes mean nothing
    std::vector<types::global_dof_index> dofs(finite_element_.dofs_per_cell);
    // 1 + index; 0: another rank knows
    std::array<types::global_dof_index, 2> place{};
    of_obstacle.set_size(dof_handler_.n_dofs());
    for (const auto &cell : dof_handler_.active_cell_iterators())
      if (!cell->is_artificial() && is_gap(cell))
        {
          cell->get_dof_indices(dofs);
          of_obstacle.add_indices(dofs.begin(), dofs.end());
          if (cell->vertex(0).norm() <= 2. * geometry_.corner()[0])
            for (const Field::Block field : all_fields)
              if (has_field(field))
                place[field] =
                  1 + cell->vertex_dof_index(0, first_component(field));
        }
    of_obstacle.compress();
    for (const Field::Block field : all_fields)
      if (has_field(field))
        obstacle_dof_[field] =
          Utilities::MPI::max(place[field], communicator_) - 1 -
          first_dof(field);
  }



  template <int dim>
  void
  Discretization<dim>::distribute_dofs(const SceneFields &fields)
  {
    dof_handler_.distribute_dofs(finite_element_);
    std::vector<unsigned int> field_of_component(n_components(), 0);
    if (fields.has_temperature)
      std::fill(field_of_component.begin() + 1, field_of_component.end(), 1);
    DoFRenumbering::component_wise(dof_handler_, field_of_component);

    // all components have as many
    const types::global_dof_index n_dofs = dof_handler_.n_dofs();
    const types::global_dof_index n_temperatures =
      fields.has_temperature ? n_dofs / n_components() : 0;
    owned_    = dof_handler_.locally_owned_dofs();
    relevant_ = DoFTools::extract_locally_relevant_dofs(dof_handler_);
    for (const auto &[first, last] :
         {std::pair(types::global_dof_index(0), n_temperatures),
          std::pair(n_temperatures, n_dofs)})
      {
        owned_by_block_.push_back(owned_.get_view(first, last));
        relevant_by_block_.push_back(relevant_.get_view(first, last));
        prototypes.emplace_back(owned_by_block_.back(), communicator_);
      }
    system_prototype.reinit(owned_, communicator_);
  }



  template <int dim>
  void
  Discretization<dim>::add_ghosts_of_cells()
  {
    const IndexSet active = DoFTools::extract_locally_active_dofs(dof_handler_);
    for (const Field::Block field : all_fields)
      if (has_field(field))
        {
          const IndexSet &owned = owned_by_block_[field];
          prototypes[field].reinit(
            owned,
            active.get_view(first_dof(field), first_dof(field) + owned.size()),
            communicator_);
        }
  }



  template <int dim>
  ComponentMask
  Discretization<dim>::held_components(const SpatialScene &scene) const
  {
    ComponentMask held(n_components(), true);
    if (row_.begins_with_mass())
      return held;
    if (has_field(Field::temperature) && !scene.has_given_temperature)
      held.set(first_component(Field::temperature), false);
    if (has_field(Field::displacement))
      for (unsigned int d = 0; d < dim; ++d)
        if (scene.has_free_end || (scene.has_sliding_end && d > 0))
          held.set(first_component(Field::displacement) + d, false);
    return held;
  }



  template <int dim>
  AffineConstraints<double>
  Discretization<dim>::make_constraints(const ComponentMask &held,
                                        const bool           has_pins,
                                        const bool holds_obstacle) const
  {
    AffineConstraints<double> constraints =
      make_unconstrained(owned_, relevant_);

    const Functions::ZeroFunction<dim> zero(n_components());
    if (held.n_selected_components(n_components()) > 0)
      VectorTools::interpolate_boundary_values(
        mapping_, dof_handler_, fixed_boundary_id, zero, constraints, held);
    if constexpr (dim == 1)
      {
        ComponentMask right(n_components(), false);
        for (const Field::Block field : all_fields)
          if (has_field(field) && is_held_right_[field])
            right.set(first_component(field), true);
        if (right.n_selected_components(n_components()) > 0)
          VectorTools::interpolate_boundary_values(mapping_,
                                                   dof_handler_,
                                                   contact_boundary_id,
                                                   zero,
                                                   constraints,
                                                   right);
      }
    for (unsigned int d = 1; has_field(Field::displacement) && d < dim; ++d)
      {
        ComponentMask normal(n_components(), false);
        normal.set(first_component(Field::displacement) + d, true);
        for (const types::boundary_id face : {2 * d, 2 * d + 1})
          if (geometry_.is_held(face))
            VectorTools::interpolate_boundary_values(
              mapping_, dof_handler_, face, zero, constraints, normal);
      }
    if (has_pins)
      add_pins(constraints);
    for (const types::global_dof_index dof : of_obstacle)
      if (holds_obstacle || std::none_of(std::begin(all_fields),
                                         std::end(all_fields),
                                         [&](const Field::Block field) {
                                           return has_field(field) &&
                                                  dof == obstacle_dof_[field] +
                                                           first_dof(field);
                                         }))
        constraints.add_line(dof);
    constraints.close();
    return constraints;
  }



  template <int dim>
  void
  Discretization<dim>::add_pins(AffineConstraints<double> &constraints) const
  {
    // Corners of the body, each of one cell; those at z = 0 alone.
    const auto pin = [&](const auto        &cell,
                         const unsigned int vertex,
                         const unsigned int direction) {
      constraints.add_line(cell->vertex_dof_index(
        vertex, first_component(Field::displacement) + direction));
    };
    for (const auto &cell : dof_handler_.active_cell_iterators())
      if (!cell->is_artificial() && cell->at_boundary(0) &&
          (dim < 3 || cell->at_boundary(4)))
        {
          // no translation across; and of a block, no rotation about x
          if (cell->at_boundary(2))
            for (unsigned int d = 1; d < dim; ++d)
              pin(cell, 0, d);
          if (dim == 3 && cell->at_boundary(3))
            pin(cell, 2, 2);
        }
  }



  template <int dim>
  void
  Discretization<dim>::collect_constrained()
  {
    for (const Field::Block field : all_fields)
      {
        const IndexSet &owned = owned_by_block_[field];
        constrained_.emplace_back(owned.size());
        for (const types::global_dof_index dof : owned)
          if (constraints_.is_constrained(dof + first_dof(field)))
            {
              constrained_[field].add_index(dof);
              if (!of_obstacle.is_element(dof + first_dof(field)))
                constrained_entries_[field].push_back(
                  owned.index_within_set(dof));
            }
        constrained_[field].compress();
      }
  }



  template <int dim>
  void
  Discretization<dim>::collect_nodal_values()
  {
    for (const Field::Block field : all_fields)
      nodal_values_[field].resize(owned_by_block_[field].n_elements());
    const std::vector<Point<dim>> &points =
      finite_element_.get_unit_support_points();
    std::vector<types::global_dof_index> dofs(points.size());
    for (const auto &cell : dof_handler_.active_cell_iterators())
      if (cell->is_locally_owned())
        {
          const CellShape<dim> shape(cell);
          cell->get_dof_indices(dofs);
          for (unsigned int i = 0; i < dofs.size(); ++i)
            if (owned_.is_element(dofs[i]))
              {
                const Field::Block field =
                  all_fields[dofs[i] >= n_temperature_dofs()];
                NodalValue<dim> &value =
                  nodal_values_[field][owned_by_block_[field].index_within_set(
                    dofs[i] - first_dof(field))];
                value.component =
                  finite_element_.system_to_component_index(i).first -
                  first_component(field);
                value.node = shape.point(points[i]);
              }
        }
  }



  template <int dim>
  std::optional<unsigned int>
  Discretization<dim>::obstacle_entry(const Field::Block field) const
  {
    const IndexSet &owned = owned_by_block_[field];
    if (of_obstacle.size() == 0 || !has_field(field) ||
        !owned.is_element(obstacle_dof_[field]))
      return {};
    return owned.index_within_set(obstacle_dof_[field]);
  }



  template <int dim>
  double
  Discretization<dim>::obstacle_value(const Field::Block field,
                                      const Vector      &vector) const
  {
    const auto entry = obstacle_entry(field);
    return Utilities::MPI::sum(entry ? vector.begin()[*entry] : 0.,
                               communicator_);
  }



  template <int dim>
  State
  Discretization<dim>::make_state() const
  {
    State state;
    state.temperature  = make_vector(Field::temperature);
    state.displacement = make_vector(Field::displacement);
    state.velocity     = make_vector(Field::displacement);
    state.contact.pressure.assign(contact_end_->n_nodes(), 0.);
    state.contact.exchange_coefficient = state.contact.pressure;
    state.gap                          = state.contact.pressure;
    state.gap_rate                     = state.contact.pressure;
    return state;
  }



  template <int dim>
  EquationFactors
  Discretization<dim>::in_equations(const Cell       &cell,
                                    const Point<dim> &place,
                                    const double      theta) const
  {
    if (row_.is_given())
      return row_.in_equations(cell->active_cell_index(), place[0], theta);
    return of_material(cell, place, theta);
  }



  template <int dim>
  EquationFactors
  Discretization<dim>::of_material(const Cell       &cell,
                                   const Point<dim> &place,
                                   const double      theta) const
  {
    if (row_.is_given())
      return row_.of_rod(cell->active_cell_index(), place[0], theta);
    return profile ? profile->at(inside(cell, place), theta) : one_everywhere;
  }



  template <int dim>
  Elasticity
  Discretization<dim>::elasticity(const Cell       &cell,
                                  const Point<dim> &place) const
  {
    return profile ? elasticity_of(of_material(cell, place).poisson_ratio) :
                     elasticity_;
  }



  template <int dim>
  std::array<double, 3>
  Discretization<dim>::inside(const Cell &cell, const Point<dim> &place) const
  {
    const Point<dim>      middle = cell->center();
    std::array<double, 3> result{};
    for (unsigned int d = 0; d < dim; ++d)
      result[d] = place[d] + Tolerances::in_cell * (middle[d] - place[d]);
    return result;
  }



  template <int dim>
  bool
  Discretization<dim>::coefficients_vary(const Cell &cell) const
  {
    return row_.is_given() ? row_.cells[cell->active_cell_index()].varies :
                             profile && profile->varies();
  }



  template <int dim>
  void
  Discretization<dim>::set_zero_in_gaps(const Field::Block field,
                                        Vector            &vector) const
  {
    if (!has_field(field))
      return;
    const IndexSet &owned = owned_by_block_[field];
    for (const types::global_dof_index dof : of_obstacle)
      if (dof >= first_dof(field) && dof - first_dof(field) < owned.size() &&
          owned.is_element(dof - first_dof(field)))
        vector.begin()[owned.index_within_set(dof - first_dof(field))] = 0.;
    if (dim > 1 || !row_.is_given())
      return;
    const unsigned int                   first_inner = 2;
    std::vector<types::global_dof_index> dofs(finite_element_.dofs_per_cell);
    for (const auto &cell : dof_handler_.active_cell_iterators())
      if (is_gap(cell))
        {
          cell->get_dof_indices(dofs);
          for (unsigned int i = first_inner; i <= degree(); ++i)
            vector.begin()[dofs[finite_element_.component_to_system_index(
                             first_component(field), i)] -
                           first_dof(field)] = 0.;
        }
  }



  template <int dim>
  void
  Discretization<dim>::set_zero_in_gaps(State &state) const
  {
    set_zero_in_gaps(Field::temperature, state.temperature);
    set_zero_in_gaps(Field::displacement, state.displacement);
    set_zero_in_gaps(Field::displacement, state.velocity);
  }



  template <int dim>
  BlockVector
  Discretization<dim>::make_ghosted_vector() const
  {
    std::vector<IndexSet> owned, relevant;
    for (const Field::Block field : all_fields)
      if (has_field(field))
        {
          owned.push_back(owned_by_block_[field]);
          relevant.push_back(relevant_by_block_[field]);
        }
    return BlockVector(owned, relevant, communicator_);
  }



  template <int dim>
  BlockVector
  Discretization<dim>::with_ghosts(const Vector &temperature,
                                   const Vector &displacement) const
  {
    BlockVector result = make_ghosted_vector();
    for (const auto &[field, values] :
         {std::pair(Field::temperature, &temperature),
          std::pair(Field::displacement, &displacement)})
      if (has_field(field) && values->size() > 0)
        result.block(ghosted_block(field))
          .copy_locally_owned_data_from(*values);
    result.update_ghost_values();
    return result;
  }



  template <int dim>
  BlockVector
  Discretization<dim>::make_block_vector() const
  {
    BlockVector result(2);
    for (const Field::Block field : all_fields)
      result.block(field).reinit(make_vector(field));
    result.collect_sizes();
    return result;
  }



  template <int dim>
  void
  Discretization<dim>::join(const Vector &temperature,
                            const Vector &displacement,
                            SystemVector &system) const
  {
    // Owned indices of the system are those of block 0, then those of block 1.
    std::copy(displacement.begin(),
              displacement.end(),
              std::copy(temperature.begin(),
                        temperature.end(),
                        system.begin()));
  }



  template <int dim>
  void
  Discretization<dim>::split(const SystemVector &system,
                             Vector             &temperature,
                             Vector             &displacement) const
  {
    const auto middle = system.begin() + temperature.locally_owned_size();
    std::copy(system.begin(), middle, temperature.begin());
    std::copy(middle, system.end(), displacement.begin());
  }



  template class Discretization<1>;
  template class Discretization<2>;
  template class Discretization<3>;
} // namespace ThermoContact
