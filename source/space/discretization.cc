// SPDX-License-Identifier: LGPL-2.1-or-later

#include <thermocontact/space/discretization.h>

#include <deal.II/base/mpi.h>

#include <deal.II/dofs/dof_renumbering.h>
#include <deal.II/dofs/dof_tools.h>

#include <deal.II/fe/fe_q.h>
#include <deal.II/fe/fe_values.h>

#include <deal.II/grid/grid_generator.h>

#include <deal.II/numerics/vector_tools_boundary.h>

#include <algorithm>
#include <cmath>
#include <map>

namespace ThermoContact
{
  template <int dim>
  Discretization<dim>::Discretization(const Parameters &parameters,
                                      const MPI_Comm    communicator)
    : communicator_(communicator)
    , triangulation(DimensionTraits<dim>::make_triangulation(communicator))
    , finite_element_(FE_Q<dim>(parameters.mesh.degree),
                      parameters.model.n_components(dim))
    , mapping_(1)
    , dof_handler_(*triangulation)
    , cross_section_(std::pow(parameters.mesh.width, dim - 1))
    , constrained_entries_(2)
  {
    make_grid(parameters.mesh);
    distribute_dofs(parameters.model);
    make_constraints(parameters.boundary.lateral_support == "rollers");
    find_contact_nodes();
  }



  template <int dim>
  void
  Discretization<dim>::make_grid(const MeshParameters &mesh)
  {
    std::vector<unsigned int> repetitions(dim, mesh.cells_across);
    repetitions[0] = mesh.cells;
    Point<dim> corner;
    for (unsigned int d = 0; d < dim; ++d)
      corner[d] = d == 0 ? 1. : mesh.width;

    const bool colorize = true;
    if (mesh.grading == 1.)
      GridGenerator::subdivided_hyper_rectangle(
        *triangulation, repetitions, Point<dim>(), corner, colorize);
    else
      {
        std::vector<std::vector<double>> sizes(
          dim,
          std::vector<double>(mesh.cells_across,
                              mesh.width / mesh.cells_across));
        sizes[0] = mesh.cell_sizes();
        GridGenerator::subdivided_hyper_rectangle(
          *triangulation, sizes, Point<dim>(), corner, colorize);
      }
    triangulation->refine_global(mesh.refinements);
  }



  template <int dim>
  void
  Discretization<dim>::distribute_dofs(const ModelParameters &model)
  {
    dof_handler_.distribute_dofs(finite_element_);
    std::vector<unsigned int> field_of_component(n_components(), 0);
    if (model.has_temperature())
      std::fill(field_of_component.begin() + 1, field_of_component.end(), 1);
    DoFRenumbering::component_wise(dof_handler_, field_of_component);

    std::vector<types::global_dof_index> n_dofs =
      DoFTools::count_dofs_per_fe_block(dof_handler_, field_of_component);
    if (n_dofs.size() == 1)
      n_dofs.insert(model.has_temperature() ? n_dofs.end() : n_dofs.begin(), 0);
    owned_ = dof_handler_.locally_owned_dofs();
    DoFTools::extract_locally_relevant_dofs(dof_handler_, relevant_);
    for (const auto &[first, last] :
         {std::pair(types::global_dof_index(0), n_dofs[0]),
          std::pair(n_dofs[0], n_dofs[0] + n_dofs[1])})
      {
        owned_by_block_.push_back(owned_.get_view(first, last));
        relevant_by_block_.push_back(relevant_.get_view(first, last));
        prototypes.emplace_back(owned_by_block_.back(), communicator_);
      }
    system_prototype.reinit(owned_, communicator_);
  }



  template <int dim>
  void
  Discretization<dim>::make_constraints(const bool has_rollers)
  {
    constraints_.reinit(relevant_);

    const Functions::ZeroFunction<dim> zero(n_components());
    VectorTools::interpolate_boundary_values(
      mapping_, dof_handler_, fixed_boundary_id, zero, constraints_);
    for (unsigned int d = 1; has_rollers && has_field(1) && d < dim; ++d)
      {
        ComponentMask normal(n_components(), false);
        normal.set(first_component(1) + d, true);
        for (const types::boundary_id id : {2 * d, 2 * d + 1})
          VectorTools::interpolate_boundary_values(
            mapping_, dof_handler_, id, zero, constraints_, normal);
      }
    constraints_.close();

    for (unsigned int block = 0; block < 2; ++block)
      {
        const types::global_dof_index offset =
          block == 0 ? 0 : n_temperature_dofs();
        constrained_.emplace_back(owned_by_block_[block].size());
        for (const types::global_dof_index dof : owned_by_block_[block])
          if (constraints_.is_constrained(dof + offset))
            {
              constrained_[block].add_index(dof);
              constrained_entries_[block].push_back(
                owned_by_block_[block].index_within_set(dof));
            }
        constrained_[block].compress();
      }
  }



  template <int dim>
  void
  Discretization<dim>::find_contact_nodes()
  {
    const Quadrature<dim - 1> quadrature =
      DimensionTraits<dim>::nodal_face_quadrature(degree());
    FEFaceValues<dim>                    face_values(mapping_,
                                  finite_element_,
                                  quadrature,
                                  update_values | update_JxW_values);
    std::vector<types::global_dof_index> dofs(finite_element_.dofs_per_cell);

    // dof, weight and position of every face share; nodes between cells and
    // between ranks collect several
    using Dofs  = std::array<types::global_dof_index, 2>;
    using Share = std::tuple<Dofs, double, Point<dim>>;
    std::vector<Share> shares;
    for (const auto &cell : dof_handler_.active_cell_iterators())
      if (cell->is_locally_owned())
        for (const unsigned int f : cell->face_indices())
          if (cell->face(f)->at_boundary() &&
              cell->face(f)->boundary_id() == contact_boundary_id)
            {
              face_values.reinit(cell, f);
              cell->get_dof_indices(dofs);
              for (unsigned int i = 0; i < dofs.size(); ++i)
                if (finite_element_.system_to_component_index(i).first == 0 &&
                    finite_element_.has_support_on_face(i, f))
                  {
                    double weight = 0.;
                    for (const unsigned int q :
                         face_values.quadrature_point_indices())
                      weight += face_values.shape_value_component(i, q, 0) *
                                face_values.JxW(q);
                    const auto dof_of_field = [&](const unsigned int block) {
                      return has_field(block) ?
                               dofs[finite_element_.component_to_system_index(
                                 first_component(block),
                                 finite_element_.system_to_component_index(i)
                                   .second)] -
                                 (block == 1 ? n_temperature_dofs() : 0) :
                               numbers::invalid_dof_index;
                    };
                    shares.emplace_back(
                      Dofs{{dof_of_field(0), dof_of_field(1)}},
                      weight,
                      mapping_.transform_unit_to_real_cell(
                        cell, finite_element_.unit_support_point(i)));
                  }
            }

    std::map<Dofs, ContactNode<dim>> nodes;
    for (const auto &of_rank :
         Utilities::MPI::all_gather(communicator_, shares))
      for (const auto &[node_dofs, weight, position] : of_rank)
        {
          ContactNode<dim> &node =
            nodes.emplace(node_dofs, ContactNode<dim>{position, node_dofs, 0.})
              .first->second;
          node.weight += weight;
        }
    for (const auto &[node_dofs, node] : nodes)
      contact_nodes_.push_back(node);

    // the numbering depends on the number of ranks, the position does not
    std::sort(contact_nodes_.begin(),
              contact_nodes_.end(),
              [](const ContactNode<dim> &a, const ContactNode<dim> &b) {
                for (unsigned int d = dim - 1; d > 0; --d)
                  if (std::abs(a.position[d] - b.position[d]) > 1e-12)
                    return a.position[d] < b.position[d];
                return false;
              });

    for (unsigned int block = 0; block < 2; ++block)
      for (unsigned int i = 0; has_field(block) && i < contact_nodes_.size();
           ++i)
        if (const auto dof = contact_nodes_[i].dofs[block];
            owned_by_block_[block].is_element(dof))
          contact_entries_[block].emplace_back(
            i, owned_by_block_[block].index_within_set(dof));
  }



  template <int dim>
  void
  Discretization<dim>::contact_values(const unsigned int   block,
                                      const Vector        &field,
                                      std::vector<double> &values) const
  {
    values.assign(contact_nodes_.size(), 0.);
    for (const auto &[node, entry] : contact_entries_[block])
      values[node] = field.begin()[entry];
    if (Utilities::MPI::n_mpi_processes(communicator_) > 1)
      Utilities::MPI::sum(values, communicator_, values);
  }



  template <int dim>
  double
  Discretization<dim>::contact_mean(const std::vector<double> &values) const
  {
    double sum = 0.;
    for (unsigned int i = 0; i < contact_nodes_.size(); ++i)
      sum += contact_nodes_[i].weight * values[i];
    return sum / cross_section_;
  }



  template <int dim>
  State
  Discretization<dim>::make_state() const
  {
    State state;
    state.temperature  = make_vector(0);
    state.displacement = make_vector(1);
    state.velocity     = make_vector(1);
    state.contact_pressure.assign(contact_nodes_.size(), 0.);
    return state;
  }



  template <int dim>
  void
  Discretization<dim>::join(const Vector &temperature,
                            const Vector &displacement,
                            Vector       &system) const
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
  Discretization<dim>::split(const Vector &system,
                             Vector       &temperature,
                             Vector       &displacement) const
  {
    const auto middle = system.begin() + temperature.locally_owned_size();
    std::copy(system.begin(), middle, temperature.begin());
    std::copy(middle, system.end(), displacement.begin());
  }



  template class Discretization<1>;
  template class Discretization<2>;
  template class Discretization<3>;
} // namespace ThermoContact
