// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef thermocontact_space_matrix_free_spaces_h
#define thermocontact_space_matrix_free_spaces_h

#include <thermocontact/base/types.h>

#include <deal.II/dofs/dof_handler.h>

#include <deal.II/fe/mapping.h>

#include <deal.II/lac/affine_constraints.h>

#include <deal.II/matrix_free/matrix_free.h>

#include <array>
#include <vector>

namespace ThermoContact
{
  template <int dim>
  class Discretization;



  /**
   * The spaces of the single fields, and what products without matrices need of
   * their cells. Each field has a DoFHandler of its own, whose numbers are
   * those of its block in the Discretization, so that vectors are the same.
   */
  template <int dim>
  class MatrixFreeSpaces
  {
  public:
    /** @param discretization borrowed; its degrees of freedom are there */
    explicit MatrixFreeSpaces(const Discretization<dim> &discretization);

    const MatrixFree<dim> &
    cells() const
    {
      return cells_;
    }

    /** Number of a field among those that the scene has. */
    unsigned int
    index(const Field::Block field) const
    {
      return index_[field];
    }

    const DoFHandler<dim> &
    dof_handler(const Field::Block field) const
    {
      return handlers[field];
    }

    /** Homogeneous constraints of the rates of a field. */
    const AffineConstraints<double> &
    constraints(const Field::Block field) const
    {
      return constraints_[field];
    }

    /** A vector of zeros with the ghosts that products need. */
    Vector
    make_vector(const Field::Block field) const;

    /** Rules of the cells: of products, and of masses that are lumped. */
    enum Rule : unsigned int
    {
      gauss,
      nodes
    };

  private:
    std::array<DoFHandler<dim>, 2>           handlers;
    std::array<AffineConstraints<double>, 2> constraints_;
    std::array<unsigned int, 2>              index_;
    AffineConstraints<double>                unconstrained;
    MatrixFree<dim>                          cells_;

    /** Spaces of a field, with the numbers of its block. */
    void
    distribute_dofs(const Discretization<dim> &discretization,
                    const Field::Block         field);

    void
    collect_cells(const Discretization<dim> &discretization);
  };
} // namespace ThermoContact

#endif
