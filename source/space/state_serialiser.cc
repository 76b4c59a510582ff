// SPDX-License-Identifier: LGPL-2.1-or-later

#include <thermocontact/space/state_serialiser.h>

#include <deal.II/fe/fe_tools.h>

#include <algorithm>
#include <cstring>
#include <stdexcept>

namespace ThermoContact
{
  namespace
  {
    template <int dim>
    using Coordinates = std::array<std::uint64_t, dim>;



    /** Whole coordinates of the cells, and how many there are along each. */
    template <int dim>
    class CellGrid
    {
    public:
      explicit CellGrid(const Triangulation<dim> &mesh)
        : n_levels(mesh.n_global_levels() - 1)
      {
        // All ranks know the coarsest cells, whose corners repeat exactly.
        for (const auto &cell : mesh.cell_iterators_on_level(0))
          for (unsigned int d = 0; d < dim; ++d)
            corners[d].push_back(cell->vertex(0)[d]);
        for (std::vector<double> &values : corners)
          {
            std::sort(values.begin(), values.end());
            values.erase(std::unique(values.begin(), values.end()),
                         values.end());
          }
      }

      std::uint64_t
      n_along(const unsigned int d) const
      {
        return static_cast<std::uint64_t>(corners[d].size()) << n_levels;
      }

      Coordinates<dim>
      operator()(typename Triangulation<dim>::cell_iterator cell) const
      {
        Coordinates<dim> result{};
        unsigned int     n_refinements = 0;
        // child i has the bits of i as its place in the parent
        while (cell->level() > 0)
          {
            const auto parent = cell->parent();
            for (unsigned int i = 0; i < parent->n_children(); ++i)
              if (parent->child_index(i) == cell->index())
                for (unsigned int d = 0; d < dim; ++d)
                  result[d] |= std::uint64_t((i >> d) & 1) << n_refinements;
            ++n_refinements;
            cell = parent;
          }
        for (unsigned int d = 0; d < dim; ++d)
          result[d] |=
            static_cast<std::uint64_t>(std::lower_bound(corners[d].begin(),
                                                        corners[d].end(),
                                                        cell->vertex(0)[d]) -
                                       corners[d].begin())
            << n_refinements;
        return result;
      }

    private:
      const unsigned int                   n_levels;
      std::array<std::vector<double>, dim> corners;
    };
  } // namespace



  template <int dim>
  StateSerialiser<dim>::StateSerialiser(
    const Discretization<dim> &discretization)
    : has_temperature(discretization.has_field(Field::temperature))
    , has_displacement(discretization.has_field(Field::displacement))
    , n_values((has_temperature ? 1 : 0) + (has_displacement ? 2 * dim : 0))
  {
    const FiniteElement<dim>       &fe     = discretization.finite_element();
    const unsigned int              degree = discretization.degree();
    const std::vector<unsigned int> place_of_node =
      FETools::hierarchic_to_lexicographic_numbering<dim>(degree);
    const Triangulation<dim> &mesh =
      discretization.dof_handler().get_triangulation();
    const CellGrid<dim>                  grid(mesh);
    std::vector<types::global_dof_index> dofs(fe.dofs_per_cell);

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
    for (const auto &cell :
         discretization.dof_handler().active_cell_iterators())
      {
        if (!cell->is_locally_owned())
          continue;
        cell->get_dof_indices(dofs);
        const Coordinates<dim> corner =
          grid(typename Triangulation<dim>::cell_iterator(&mesh,
                                                          cell->level(),
                                                          cell->index()));
        for (unsigned int i = 0; i < place_of_node.size(); ++i)
          {
            if (entry(has_temperature ? Field::temperature :
                                        Field::displacement,
                      0,
                      i) == numbers::invalid_dof_index)
              continue;
            Node          node{0, 0, {}};
            std::uint64_t place = place_of_node[i], stride = 1;
            for (unsigned int d = 0; d < dim; ++d)
              {
                node.number +=
                  stride * (corner[d] * degree + place % (degree + 1));
                stride *= grid.n_along(d) * degree + 1;
                place /= degree + 1;
                if (has_displacement)
                  node.displacement[d] = entry(Field::displacement, d, i);
              }
            if (has_temperature)
              node.temperature = entry(Field::temperature, 0, i);
            nodes.push_back(node);
          }
      }
    const auto is_before = [](const Node &a, const Node &b) {
      return a.number < b.number;
    };
    const auto is_same = [](const Node &a, const Node &b) {
      return a.number == b.number;
    };
    std::sort(nodes.begin(), nodes.end(), is_before);
    nodes.erase(std::unique(nodes.begin(), nodes.end(), is_same), nodes.end());
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
