// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef thermocontact_space_contact_end_h
#define thermocontact_space_contact_end_h

#include <thermocontact/base/types.h>
#include <thermocontact/space/state.h>

#include <deal.II/base/function.h>

#include <deal.II/dofs/dof_handler.h>

#include <deal.II/lac/full_matrix.h>

#include <array>
#include <cmath>
#include <utility>
#include <vector>

namespace ThermoContact
{
  template <int dim>
  class Discretization;



  /** A node of the contact end. */
  template <int dim>
  struct ContactNode
  {
    Point<dim> position;

    /**
     * Temperature and normal displacement there, each within its block;
     * invalid for a field that the scene does not have.
     */
    std::array<types::global_dof_index, 2> dofs;

    /** $w_i=\int_{\Gamma_C}\varphi_i$, the lumped boundary mass. */
    double weight;

    /** $k$ of a contact of a row if that is a number, which matrices contain.
     */
    double own_exchange = 0.;

    /**
     * What moves by itself and this node can meet, the neighbour in a row or
     * an obstacle that has a mass: values of the field at the node are those
     * relative to the partner, and loads act on both, (M10.2). Invalid: it can
     * meet an obstacle whose values are given.
     */
    std::array<types::global_dof_index, 2> partner{
      {numbers::invalid_dof_index, numbers::invalid_dof_index}};

    bool
    has_partner(const Field::Block field) const
    {
      return partner[field] != numbers::invalid_dof_index;
    }
  };



  /**
   * The contact end $x=1$ of the body, or where the bodies of a row can meet:
   * its nodes, and what fields are there.
   * Contact nodes are few: all ranks know their positions, weights and
   * pressures, in an order that does not depend on the number of ranks.
   */
  template <int dim>
  class ContactEnd
  {
  public:
    /**
     * @param discretization borrowed; its degrees of freedom are distributed
     */
    explicit ContactEnd(const Discretization<dim> &discretization);

    /**
     * The nodes that can meet the obstacle, in order of their position; on all
     * ranks.
     */
    const std::vector<ContactNode<dim>> &
    nodes() const
    {
      return nodes_;
    }

    unsigned int
    n_nodes() const
    {
      return nodes_.size();
    }

    /**
     * All nodes of the end. Behind the list of nodes() come nodes whose weight
     * vanishes, as on an axis of symmetry: a pressure on them does nothing, so
     * that they have none.
     */
    const std::vector<ContactNode<dim>> &
    all_nodes() const
    {
      return all_nodes_;
    }

    unsigned int
    n_all_nodes() const
    {
      return all_nodes_.size();
    }

    /**
     * Locally owned nodes: index of the node, position of its value (for the
     * displacement: of the normal one) in the local part of a vector of
     * @p field. Partners are not among them.
     */
    const std::vector<std::pair<unsigned int, unsigned int>> &
    entries(const Field::Block field) const
    {
      return entries_[field];
    }

    /** The same for all nodes of the end. */
    const std::vector<std::pair<unsigned int, unsigned int>> &
    all_entries(const Field::Block field) const
    {
      return all_entries_[field];
    }

    /**
     * Values at the nodes, gathered on all ranks.
     *
     * @param field of which @p vector is; of displacements and velocities the
     *   normal component is taken
     * @param values out: one per node; zeros if the field is absent
     */
    void
    get_values(const Field::Block   field,
               const Vector        &vector,
               std::vector<double> &values) const;

    /** The same for all nodes of the end. */
    void
    get_all_values(const Field::Block   field,
                   const Vector        &vector,
                   std::vector<double> &values) const;

    /**
     * Adds to the value of a node: half of it each to the node and, with the
     * other sign, its partner if it has one.
     */
    void
    add_to_value(const Field::Block field,
                 const unsigned int node,
                 const double       change,
                 Vector            &vector) const;

    /** Sets the locally owned values of a vector, one for each of all nodes. */
    void
    set_all_values(const Field::Block         field,
                   const std::vector<double> &values,
                   Vector                    &vector) const;

    /**
     * Takes from the locally owned values @p factor times the load of nodal
     * densities, $Np$ of pressures or heat fluxes: @p load $-=$ factor
     * $\sum_i w_ip_ie_i$.
     */
    void
    subtract_load(const Field::Block         field,
                  const std::vector<double> &densities,
                  const double               factor,
                  Vector                    &load) const;

    /** @p load becomes that of the density @p value at one node alone. */
    void
    set_load_of_node(const Field::Block field,
                     const unsigned int node,
                     const double       value,
                     Vector            &load) const;

    /** Mean of nodal values over the contact end; of a row their sum. */
    double
    mean(const std::vector<double> &values) const;

    /** Part of the contact end that a node stands for, $w_i$ over its area. */
    double
    share(const unsigned int node) const
    {
      return nodes_[node].weight / cross_section;
    }

    /**
     * The matrix whose column j has the values of the nodes that @p respond
     * returns for a unit load at node j. Collective.
     *
     * @param respond vector of the layout of @p field for a node; valid until
     *   the next call
     */
    template <typename Respond>
    FullMatrix<double>
    response_matrix(const Respond     &respond,
                    const Field::Block field = Field::displacement) const
    {
      FullMatrix<double>  matrix(n_nodes(), n_nodes());
      std::vector<double> column;
      for (unsigned int j = 0; j < n_nodes(); ++j)
        {
          get_values(field, respond(j), column);
          for (unsigned int i = 0; i < n_nodes(); ++i)
            matrix(i, j) = column[i];
        }
      return matrix;
    }

    /** The same for all nodes of the end. */
    template <typename Respond>
    FullMatrix<double>
    all_response_matrix(const Respond &respond) const
    {
      FullMatrix<double>  matrix(n_all_nodes(), n_all_nodes());
      std::vector<double> column;
      for (unsigned int j = 0; j < n_all_nodes(); ++j)
        {
          get_all_values(Field::displacement, respond(j), column);
          for (unsigned int i = 0; i < n_all_nodes(); ++i)
            matrix(i, j) = column[i];
        }
      return matrix;
    }

  private:
    /** Index of a node, local position of its value in a vector. */
    using Entries = std::vector<std::pair<unsigned int, unsigned int>>;

    const MPI_Comm                communicator;
    const double                  cross_section;
    std::vector<ContactNode<dim>> all_nodes_;
    std::vector<ContactNode<dim>> nodes_;
    std::array<Entries, 2>        entries_;
    std::array<Entries, 2>        all_entries_;
    std::array<Entries, 2>        partners_;

    /** Where the bodies of a row can meet, from the left. */
    std::vector<ContactNode<dim>>
    find_nodes_of_row(const Discretization<dim> &discretization) const;

    /** All nodes of the end; those without weight last. */
    std::vector<ContactNode<dim>>
    find_nodes(const Discretization<dim> &discretization) const;

    /** Values at the nodes of @p entries, gathered on all ranks. */
    void
    gather(const Entries       &entries,
           const Field::Block   field,
           const Vector        &vector,
           std::vector<double> &values) const;
  };



  /**
   * The face of @p cell on the contact end, or numbers::invalid_unsigned_int.
   */
  template <int dim>
  unsigned int
  contact_face(const typename DoFHandler<dim>::active_cell_iterator &cell);



  /** True if a face of @p cell belongs to the contact end. */
  template <int dim>
  bool
  touches_contact_end(
    const typename DoFHandler<dim>::active_cell_iterator &cell)
  {
    return contact_face<dim>(cell) != numbers::invalid_unsigned_int;
  }



  /**
   * Calls @p visit(cell, face) for the locally owned faces of a part of the
   * boundary.
   */
  template <int dim, typename Visit>
  void
  for_each_face(const types::boundary_id part,
                const DoFHandler<dim>   &dof_handler,
                const Visit             &visit)
  {
    for (const auto &cell : dof_handler.active_cell_iterators())
      if (cell->is_locally_owned() && cell->at_boundary())
        for (const unsigned int face : cell->face_indices())
          if (cell->face(face)->at_boundary() &&
              cell->face(face)->boundary_id() == part)
            visit(cell, face);
  }
} // namespace ThermoContact

#endif
