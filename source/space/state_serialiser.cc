// SPDX-License-Identifier: LGPL-2.1-or-later

#include <thermocontact/space/state_serialiser.h>

#include <algorithm>
#include <cstring>
#include <map>
#include <stdexcept>

namespace ThermoContact
{
  namespace
  {
    /** A number that a cell has on all ranks, of cells of one level. */
    template <int dim>
    std::uint64_t
    number_of(const typename DoFHandler<dim>::active_cell_iterator &cell)
    {
      // not its id, which p4est gives to several ranks alone
      typename Triangulation<dim>::cell_iterator coarse(cell);
      while (coarse->level() > 0)
        coarse = coarse->parent();
      std::uint64_t number = coarse->index();
      const CellId  id     = cell->id(); // has the cell of the view
      for (const std::uint8_t child : id.get_child_indices())
        number = (number << dim) + child;
      return number;
    }
  } // namespace



  template <int dim>
  StateSerialiser<dim>::StateSerialiser(
    const Discretization<dim> &discretization)
    : has_temperature(discretization.has_field(Field::temperature))
    , has_displacement(discretization.has_field(Field::displacement))
    , n_values((has_temperature ? 1 : 0) + (has_displacement ? 2 * dim : 0))
  {
    const FiniteElement<dim> &fe       = discretization.finite_element();
    const unsigned int        n_places = fe.base_element(0).dofs_per_cell;
    std::map<types::global_dof_index, Node> first_of_entry;
    std::vector<types::global_dof_index>    dofs(fe.dofs_per_cell);

    const auto entry = [&](const Field::Block field,
                           const unsigned int component,
                           const unsigned int node) {
      const types::global_dof_index dof =
        dofs[fe.component_to_system_index(
          discretization.first_component(field) + component, node)] -
        discretization.first_dof(field);
      const IndexSet &owned = discretization.owned_by_block()[field];
      return owned.is_element(dof) ? owned.index_within_set(dof) :
                                     numbers::invalid_dof_index;
    };
    // the first of the cells around a node, all of which its owner knows
    for (const auto &cell :
         discretization.dof_handler().active_cell_iterators())
      {
        if (cell->is_artificial())
          continue;
        cell->get_dof_indices(dofs);
        const std::uint64_t first = number_of<dim>(cell) * n_places;
        for (unsigned int i = 0; i < n_places; ++i)
          {
            Node       node{first + i, 0, {}};
            const auto here =
              entry(has_temperature ? Field::temperature : Field::displacement,
                    0,
                    i);
            if (here == numbers::invalid_dof_index)
              continue;
            for (unsigned int d = 0; has_displacement && d < dim; ++d)
              node.displacement[d] = entry(Field::displacement, d, i);
            if (has_temperature)
              node.temperature = here;
            const auto found = first_of_entry.emplace(here, node).first;
            if (node.number < found->second.number)
              found->second = node;
          }
      }
    for (const auto &[entry, node] : first_of_entry)
      nodes.push_back(node);
    const auto is_before = [](const Node &a, const Node &b) {
      return a.number < b.number;
    };
    std::sort(nodes.begin(), nodes.end(), is_before);
  }



  template <int dim>
  template <typename SomeState, typename Visit>
  void
  StateSerialiser<dim>::for_each_value(const Node  &node,
                                       SomeState   &state,
                                       const Visit &visit) const
  {
    if (has_temperature)
      visit(state.temperature.begin()[node.temperature]);
    for (unsigned int d = 0; has_displacement && d < dim; ++d)
      {
        visit(state.displacement.begin()[node.displacement[d]]);
        visit(state.velocity.begin()[node.displacement[d]]);
      }
  }



  template <int dim>
  std::string
  StateSerialiser<dim>::save(const State &state) const
  {
    std::string bytes(nodes.size() * size_of_node(), '\0');
    char       *next = bytes.data();
    const auto  put  = [&next](const auto &value) {
      static_assert(sizeof(value) == 8);
      std::memcpy(next, &value, 8);
      next += 8;
    };
    for (const Node &node : nodes)
      put(node.number);
    for (const Node &node : nodes)
      for_each_value(node, state, put);
    return bytes;
  }



  template <int dim>
  std::size_t
  StateSerialiser<dim>::restore(const std::string &saved, State &state) const
  {
    if (saved.size() % size_of_node() != 0)
      throw std::length_error("vectors of another discretisation");
    const std::size_t n_saved = n_nodes_of(saved);
    std::size_t       i = 0, n_set = 0;
    for (const Node &node : nodes)
      {
        // both are in the order of the numbers
        std::uint64_t number = 0;
        for (; i < n_saved; ++i)
          {
            std::memcpy(&number, saved.data() + 8 * i, 8);
            if (number >= node.number)
              break;
          }
        if (i == n_saved)
          break;
        if (number != node.number)
          continue;
        const char *next = saved.data() + 8 * (n_saved + i * n_values);
        for_each_value(node, state, [&next](double &value) {
          std::memcpy(&value, next, 8);
          next += 8;
        });
        ++n_set;
      }
    return n_set;
  }



  template class StateSerialiser<1>;
  template class StateSerialiser<2>;
  template class StateSerialiser<3>;
} // namespace ThermoContact
