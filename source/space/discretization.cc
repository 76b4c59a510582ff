// SPDX-License-Identifier: LGPL-2.1-or-later

#include <thermocontact/base/dealii_versions.h>
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
    , exchange_coefficient_(scene.exchange_coefficient)
  {
    make_grid(scene.mesh, scene.n_halvings);
    distribute_dofs(scene.fields);
    constraints_ = make_constraints(held_components(scene), scene.has_pins);
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



  template <int dim>
  void
  Discretization<dim>::make_grid(const MeshParameters &mesh,
                                 const unsigned int    n_halvings)
  {
    std::vector<unsigned int> repetitions(dim,
                                          mesh.n_cells_across() >> n_halvings);
    repetitions[0]          = mesh.cells >> n_halvings;
    const Point<dim> corner = geometry_.corner();

    const bool colorize = true;
    if (row_.is_given())
      {
        std::vector<std::vector<double>> sizes(dim);
        for (const RowCell &cell : row_.cells)
          sizes[0].push_back(cell.size);
        GridGenerator::subdivided_hyper_rectangle(
          *triangulation, sizes, Point<dim>(), corner, colorize);
        return;
      }
    if (mesh.grading == 1. && mesh.grading_across == 1.)
      GridGenerator::subdivided_hyper_rectangle(
        *triangulation, repetitions, Point<dim>(), corner, colorize);
    else
      {
        std::vector<std::vector<double>> sizes(dim, mesh.cell_sizes_across());
        sizes[0] = mesh.cell_sizes();
        GridGenerator::subdivided_hyper_rectangle(
          *triangulation, sizes, Point<dim>(), corner, colorize);
      }
    triangulation->refine_global(mesh.refinements + n_halvings);
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
                                        const bool           has_pins) const
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
          const Point<dim> &lower = cell->vertex(0);
          const Point<dim> &upper =
            cell->vertex(GeometryInfo<dim>::vertices_per_cell - 1);
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
                for (unsigned int d = 0; d < dim; ++d)
                  value.node[d] =
                    (1. - points[i][d]) * lower[d] + points[i][d] * upper[d];
              }
        }
  }



  template <int dim>
  State
  Discretization<dim>::make_state() const
  {
    State state;
    state.temperature  = make_vector(Field::temperature);
    state.displacement = make_vector(Field::displacement);
    state.velocity     = make_vector(Field::displacement);
    state.contact_pressure.assign(contact_end_->n_nodes(), 0.);
    state.exchange_coefficient = state.contact_pressure;
    state.gap                  = state.contact_pressure;
    state.gap_rate             = state.contact_pressure;
    return state;
  }



  template <int dim>
  void
  Discretization<dim>::set_zero_in_gaps(const Field::Block field,
                                        Vector            &vector) const
  {
    if (dim > 1 || !row_.is_given() || !has_field(field))
      return;
    const unsigned int                   first_inner = 2;
    std::vector<types::global_dof_index> dofs(finite_element_.dofs_per_cell);
    for (const auto &cell : dof_handler_.active_cell_iterators())
      if (is_gap(cell->active_cell_index()))
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
