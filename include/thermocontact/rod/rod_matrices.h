// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef thermocontact_rod_rod_matrices_h
#define thermocontact_rod_rod_matrices_h

#include <array>
#include <functional>
#include <vector>

namespace ThermoContact
{
  /**
   * Cells of one degree in a row. The nodes of a field are numbered as deal.II
   * does: node 0 is the left end, and cell c adds the degree() nodes from
   * first_node(c) on, its right vertex first, then those within it. A cell has
   * its left vertex, its right vertex, its inner nodes, in this order.
   */
  struct RodLayout
  {
    unsigned int n_cells;
    unsigned int degree;

    unsigned int
    n_nodes() const
    {
      return n_cells * degree + 1;
    }

    unsigned int
    nodes_per_cell() const
    {
      return degree + 1;
    }

    unsigned int
    first_node(const unsigned int cell) const
    {
      return cell * degree + 1;
    }

    unsigned int
    left_vertex(const unsigned int cell) const
    {
      return cell == 0 ? 0 : first_node(cell - 1);
    }

    /** The node of @p cell at place @p i of its own order. */
    unsigned int
    node(const unsigned int cell, const unsigned int i) const
    {
      return i == 0 ? left_vertex(cell) : first_node(cell) + i - 1;
    }
  };



  /** The names of the field matrices, doc/discretisation.md (D1.1), (D1.2). */
  struct FieldMatrix
  {
    enum Kind : unsigned int
    {
      heat_mass,         ///< $M$
      conduction,        ///< $K+kB+L$
      divergence,        ///< $D$, rows of the temperature
      thermal_stress,    ///< its transpose
      momentum_mass,     ///< $M_u$
      stiffness,         ///< $S$
      viscous_stiffness, ///< $S_\zeta$
      heat_exchange, ///< the part of conduction that is lost at constant values
      lateral_exchange, ///< $L$, a part of that
      n_matrices
    };
  };



  /**
   * The field matrices of a rod, doc/discretisation.md (D1.1), (D1.2), cell by
   * cell. Neighbours with the same entries are one run, and those of a uniform
   * rod are read once for all of its cells.
   *
   * Products read the values of nodes and know nothing of constraints. Arrays
   * of a product must not overlap. Vectors are arrays of n_nodes().
   */
  class RodMatrices : public FieldMatrix
  {
  public:
    using Matrix = FieldMatrix::Kind;

    /** The entry of a cell for two of its nodes; 0 for absent fields. */
    using Entry = std::function<double(const Matrix       matrix,
                                       const unsigned int cell,
                                       const unsigned int row,
                                       const unsigned int column)>;

    /**
     * @param tolerance up to which entries of cells are the same, as a part of
     *   the largest one of the matrix in the cell
     * @param carries of each cell whether something is attached to one of its
     *   vertices, of which its entries have a part; empty: of none
     * @param repeats asked of each cell, in order, before its entries: true if
     *   they are those of the cell before and nothing is attached to both;
     *   empty: entries alone say so
     */
    RodMatrices(const RodLayout                               &layout,
                const double                                   tolerance,
                const Entry                                   &entry,
                const std::vector<bool>                       &carries = {},
                const std::function<bool(const unsigned int)> &repeats = {});

    const RodLayout &
    layout() const
    {
      return layout_;
    }

    /** A term of a sum of products. */
    struct Term
    {
      double        factor;
      Matrix        matrix;
      const double *vector;
    };

    /** @p y $=\sum_k$ factor$_k\,A_k\,x_k$ $+$ @p factor @p base, where
     * @p base may be null, in one pass. */
    template <std::size_t n_terms>
    void
    combine(const std::array<Term, n_terms> &terms,
            const double                     factor,
            const double                    *base,
            double                          *y) const;

    /** $x\cdot Ax$ of a symmetric matrix; all terms are added in one order. */
    double
    form(const Matrix matrix, const double *x) const;

    /** $(x-y)\cdot A(x-y)$ of a symmetric matrix. */
    double
    form_of_difference(const Matrix  matrix,
                       const double *x,
                       const double *y) const;

    /** Cells with the same entries. */
    struct Run
    {
      unsigned int begin;
      unsigned int end;
      std::size_t  first_entry; ///< of the first matrix

      /** Conduction without the heat exchange is a stiffness. */
      bool conducts_differences;

      bool loses_heat; ///< by its sides or to an obstacle

      bool carries; ///< something is attached to one of its vertices
    };

    const std::vector<Run> &
    runs() const
    {
      return runs_;
    }

    /**
     * True if the product of the matrix with a constant is zero in exact
     * arithmetic, as for a stiffness. Cells of higher degree then multiply the
     * differences to the left vertex, so that a rod without strain has no
     * force by rounding. The matrix of conduction is one of them where no heat
     * is exchanged, with the obstacle or along the rod.
     */
    bool
    takes_differences(const Run &run, const Matrix matrix) const;

    /**
     * The product of a matrix of differences with the constant 1 in a cell of
     * @p run, as sums of small entries; null if it is zero.
     */
    const double *
    of_constant(const Run &run, const Matrix matrix) const
    {
      return matrix == conduction && run.loses_heat ?
               losses_.data() +
                 run.first_entry / n_matrices / layout_.nodes_per_cell() :
               nullptr;
    }

    /** The entries of a cell of @p run, column by column. */
    const double *
    entries(const Run &run, const Matrix matrix) const
    {
      return entries_.data() + run.first_entry +
             matrix * layout_.nodes_per_cell() * layout_.nodes_per_cell();
    }

  private:
    /** Sets the heat losses of the run of the last entries. */
    void
    set_losses(Run &run);

    const RodLayout     layout_;
    std::vector<Run>    runs_;
    std::vector<double> entries_;
    std::vector<double> losses_; ///< sums of rows of the exchange, by run
  };
} // namespace ThermoContact

#endif
