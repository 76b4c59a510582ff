// SPDX-License-Identifier: LGPL-2.1-or-later

#include <thermocontact/base/collective.h>
#include <thermocontact/base/tolerances.h>
#include <thermocontact/space/contact_end.h>
#include <thermocontact/space/discretization.h>

#include <deal.II/base/mpi.h>

#include <deal.II/fe/fe_values.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <tuple>

namespace ThermoContact
{
  namespace
  {
    // dofs, weight and position of every face share; nodes between cells and
    // between ranks collect several
    using Dofs = std::array<types::global_dof_index, 2>;

    template <int dim>
    using Share = std::tuple<Dofs, double, Point<dim>>;



    /** The dof of a field at the node of the cell's basis function @p i. */
    template <int dim>
    types::global_dof_index
    dof_of_field(const Discretization<dim>                  &discretization,
                 const std::vector<types::global_dof_index> &cell_dofs,
                 const unsigned int                          i,
                 const Field::Block                          field)
    {
      if (!discretization.has_field(field))
        return numbers::invalid_dof_index;
      const FiniteElement<dim> &fe = discretization.finite_element();
      return cell_dofs[fe.component_to_system_index(
               discretization.first_component(field),
               fe.system_to_component_index(i).second)] -
             discretization.first_dof(field);
    }



    /** The shares of the cells that this rank owns. */
    template <int dim>
    std::vector<Share<dim>>
    local_shares(const Discretization<dim> &discretization)
    {
      const FiniteElement<dim> &fe = discretization.finite_element();
      FEFaceValues<dim>         face_values(
        discretization.mapping(),
        fe,
        discretization.geometry().node_weight_quadrature(fe.degree),
        update_values | update_quadrature_points | update_JxW_values);
      std::vector<types::global_dof_index> dofs(fe.dofs_per_cell);
      std::vector<Share<dim>>              shares;
      for_each_face<dim>(
        contact_boundary_id,
        discretization.dof_handler(),
        [&](const auto &cell, const unsigned int f) {
          face_values.reinit(cell, f);
          cell->get_dof_indices(dofs);
          for (unsigned int i = 0; i < dofs.size(); ++i)
            {
              if (fe.system_to_component_index(i).first != 0 ||
                  !fe.has_support_on_face(i, f))
                continue;
              double weight = 0., face_weight = 0.;
              for (const unsigned int q :
                   face_values.quadrature_point_indices())
                {
                  const double point_weight =
                    discretization.geometry().weight(face_values, q);
                  weight +=
                    face_values.shape_value_component(i, q, 0) * point_weight;
                  face_weight += point_weight;
                }
              if (std::abs(weight) < Tolerances::rounding_of_data * face_weight)
                weight = 0.; // exactly
              Dofs node_dofs;
              for (const Field::Block field : all_fields)
                node_dofs[field] = dof_of_field(discretization, dofs, i, field);
              shares.emplace_back(
                node_dofs,
                weight,
                discretization.mapping().transform_unit_to_real_cell(
                  cell, fe.unit_support_point(i)));
            }
        });
      return shares;
    }
  } // namespace



  template <int dim>
  unsigned int
  contact_face(const typename DoFHandler<dim>::active_cell_iterator &cell)
  {
    for (const unsigned int f : cell->face_indices())
      if (cell->face(f)->at_boundary() &&
          cell->face(f)->boundary_id() == contact_boundary_id)
        return f;
    return numbers::invalid_unsigned_int;
  }



  template <int dim>
  ContactEnd<dim>::ContactEnd(const Discretization<dim> &discretization)
    : communicator(discretization.communicator())
    , cross_section(discretization.geometry().cross_section())
    , all_nodes_(discretization.row().is_given() ?
                   find_nodes_of_row(discretization) :
                   find_nodes(discretization))
    , nodes_(all_nodes_)
  {
    for (const Field::Block field : all_fields)
      for (unsigned int i = 0;
           discretization.has_field(field) && i < nodes_.size();
           ++i)
        if (const IndexSet &owned = discretization.owned_by_block()[field];
            owned.is_element(nodes_[i].dofs[field]))
          {
            all_entries_[field].emplace_back(
              i, owned.index_within_set(nodes_[i].dofs[field]));
            if (nodes_[i].weight > 0.)
              entries_[field].push_back(all_entries_[field].back());
          }
    for (const Field::Block field : all_fields)
      for (unsigned int i = 0; i < nodes_.size(); ++i)
        if (nodes_[i].weight > 0. && nodes_[i].has_partner(field))
          if (const IndexSet &owned = discretization.owned_by_block()[field];
              owned.is_element(nodes_[i].partner[field]))
            partners_[field].emplace_back(
              i, owned.index_within_set(nodes_[i].partner[field]));
    while (nodes_.back().weight == 0.)
      nodes_.pop_back();
  }



  template <int dim>
  std::vector<ContactNode<dim>>
  ContactEnd<dim>::find_nodes_of_row(
    const Discretization<dim> &discretization) const
  {
    const BodyRow                       &row = discretization.row();
    const FiniteElement<dim>            &fe  = discretization.finite_element();
    std::vector<types::global_dof_index> dofs(fe.dofs_per_cell);
    std::vector<ContactNode<dim>>        nodes;
    const auto dof_at = [&](const unsigned int vertex) {
      Dofs at;
      for (const Field::Block field : all_fields)
        at[field] = discretization.has_field(field) ?
                      dofs[fe.component_to_system_index(
                        discretization.first_component(field), vertex)] -
                        discretization.first_dof(field) :
                      numbers::invalid_dof_index;
      return at;
    };
    const double weight      = cross_section;
    unsigned int next        = 0;
    const auto   exchange_of = [&](const RowContact &contact) {
      return contact.exchange.value_or(discretization.exchange_coefficient());
    };
    for (const auto &cell :
         discretization.dof_handler().active_cell_iterators())
      {
        const unsigned int number = cell->active_cell_index();
        cell->get_dof_indices(dofs);
        if (next < row.contacts.size() && row.contacts[next].cell == number)
          {
            nodes.push_back({cell->vertex(0),
                             dof_at(0),
                             weight,
                             exchange_of(row.contacts[next]),
                             dof_at(1)});
            ++next;
          }
        // where nothing can meet, the end is a node without a law
        if (number + 1 == row.cells.size() &&
            (row.meets_obstacle || row.contacts.empty()))
          nodes.push_back(
            {cell->vertex(1),
             dof_at(1),
             weight,
             row.meets_obstacle ? discretization.exchange_coefficient() : 0.});
      }
    return nodes;
  }



  template <int dim>
  std::vector<ContactNode<dim>>
  ContactEnd<dim>::find_nodes(const Discretization<dim> &discretization) const
  {
    std::map<Dofs, ContactNode<dim>> nodes;
    for (const auto &of_rank :
         all_gather(communicator, local_shares(discretization)))
      for (const auto &[dofs, weight, position] : of_rank)
        {
          ContactNode<dim> &node =
            nodes.emplace(dofs, ContactNode<dim>{position, dofs, 0.})
              .first->second;
          node.weight += weight;
        }
    std::vector<ContactNode<dim>> sorted;
    for (const auto &[dofs, node] : nodes)
      {
        sorted.push_back(node);
        for (const Field::Block field : all_fields)
          sorted.back().partner[field] = discretization.obstacle_dof(field);
      }

    std::sort(sorted.begin(),
              sorted.end(),
              [](const ContactNode<dim> &a, const ContactNode<dim> &b) {
                if ((a.weight > 0.) != (b.weight > 0.))
                  return a.weight > 0.;
                for (unsigned int d = dim - 1; d > 0; --d)
                  if (std::abs(a.position[d] - b.position[d]) >
                      Tolerances::same_coordinate)
                    return a.position[d] < b.position[d];
                return false;
              });
    return sorted;
  }



  template <int dim>
  void
  ContactEnd<dim>::gather(const Entries       &entries,
                          const Field::Block   field,
                          const Vector        &vector,
                          std::vector<double> &values) const
  {
    for (const auto &[node, entry] : entries)
      values[node] = vector.begin()[entry];
    for (const auto &[node, entry] : partners_[field])
      values[node] -= vector.begin()[entry];
    if (Utilities::MPI::n_mpi_processes(communicator) > 1)
      Utilities::MPI::sum(values, communicator, values);
  }



  template <int dim>
  void
  ContactEnd<dim>::get_values(const Field::Block   field,
                              const Vector        &vector,
                              std::vector<double> &values) const
  {
    values.assign(n_nodes(), 0.);
    gather(entries_[field], field, vector, values);
  }



  template <int dim>
  void
  ContactEnd<dim>::get_all_values(const Field::Block   field,
                                  const Vector        &vector,
                                  std::vector<double> &values) const
  {
    values.assign(n_all_nodes(), 0.);
    gather(all_entries_[field], field, vector, values);
  }



  template <int dim>
  void
  ContactEnd<dim>::set_all_values(const Field::Block         field,
                                  const std::vector<double> &values,
                                  Vector                    &vector) const
  {
    for (const auto &[node, entry] : all_entries_[field])
      vector.begin()[entry] = values[node];
  }



  template <int dim>
  void
  ContactEnd<dim>::add_to_value(const Field::Block field,
                                const unsigned int node,
                                const double       change,
                                Vector            &vector) const
  {
    const double part = nodes_[node].has_partner(field) ? 0.5 * change : change;
    for (const auto &[i, entry] : entries_[field])
      if (i == node)
        vector.begin()[entry] += part;
    for (const auto &[i, entry] : partners_[field])
      if (i == node)
        vector.begin()[entry] -= part;
  }



  template <int dim>
  void
  ContactEnd<dim>::subtract_load(const Field::Block         field,
                                 const std::vector<double> &densities,
                                 const double               factor,
                                 Vector                    &load) const
  {
    for (const auto &[node, entry] : entries_[field])
      load.begin()[entry] -= factor * nodes_[node].weight * densities[node];
    for (const auto &[node, entry] : partners_[field])
      load.begin()[entry] += factor * nodes_[node].weight * densities[node];
  }



  template <int dim>
  void
  ContactEnd<dim>::set_load_of_node(const Field::Block field,
                                    const unsigned int node,
                                    const double       value,
                                    Vector            &load) const
  {
    load = 0.;
    for (const auto &[i, entry] : entries_[field])
      if (i == node)
        load.begin()[entry] = value * nodes_[node].weight;
    for (const auto &[i, entry] : partners_[field])
      if (i == node)
        load.begin()[entry] = 0. - value * nodes_[node].weight;
  }



  template <int dim>
  double
  ContactEnd<dim>::mean(const std::vector<double> &values) const
  {
    double sum = 0.;
    for (unsigned int i = 0; i < n_nodes(); ++i)
      sum += nodes_[i].weight * values[i];
    return sum / cross_section;
  }



#define INSTANTIATE(dim)                   \
  template class ContactEnd<dim>;          \
  template unsigned int contact_face<dim>( \
    const typename DoFHandler<dim>::active_cell_iterator &)

  INSTANTIATE(1);
  INSTANTIATE(2);
  INSTANTIATE(3);

#undef INSTANTIATE
} // namespace ThermoContact
