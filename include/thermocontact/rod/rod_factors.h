// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef thermocontact_rod_rod_factors_h
#define thermocontact_rod_rod_factors_h

#include <thermocontact/rod/rod_matrices.h>

#include <utility>
#include <vector>

namespace ThermoContact
{
  /**
   * The factors of a linear system, doc/discretisation.md (D2.2), of a rod for
   * @p n_fields unknowns at a node; those that are held vanish at an end. Inner
   * nodes are eliminated cell by cell, once for all cells of a run; there
   * remains a block-tridiagonal system of the vertices, which is eliminated
   * from both ends at once: two chains of operations that do not wait for each
   * other.
   *
   * Blocks are eliminated without pivots between them, which is stable if the
   * symmetric part of the matrix is definite, as that of every stage is.
   * growth() tells how well it went.
   */
  template <unsigned int n_fields>
  class RodFactors
  {
  public:
    /** A block of the system, as a sum of matrices. */
    using Block  = std::vector<std::pair<double, RodMatrices::Matrix>>;
    using Blocks = std::array<std::array<Block, n_fields>, n_fields>;

    /** Arrays of all nodes, one for each field. */
    using Right    = std::array<const double *, n_fields>;
    using Solution = std::array<double *, n_fields>;

    /** Which fields are held at an end. */
    using Held = std::array<bool, n_fields>;

    RodFactors(const RodMatrices &matrices,
               const Blocks      &blocks,
               const Held        &held,
               const Held        &held_right = {});

    /**
     * Held values of the right-hand side at node 0 are not read, and those at
     * the right end are zero.
     */
    void
    solve(const Right &right, const Solution &solution) const;

    /**
     * How much larger intermediate values were than what they were computed
     * from: solutions satisfy a system that differs from the right one by as
     * many roundings. Infinite if a pivot vanishes.
     */
    double
    growth() const
    {
      return growth_;
    }

  private:
    static constexpr unsigned int n_entries = n_fields * n_fields;

    /** By rows. */
    using NodeBlock = std::array<double, n_entries>;

    /** The blocks of a vertex in both sweeps. */
    struct Vertex
    {
      NodeBlock elimination;  ///< times the neighbour that is eliminated before
      NodeBlock inverse;      ///< of its own block
      NodeBlock substitution; ///< times the neighbour that is known before
    };

    /** A small matrix by columns. */
    using Matrix = std::vector<double>;

    /** How the inner nodes of a cell of a run follow from its vertices. */
    struct Cell
    {
      std::vector<double> inner_inverse;     ///< by columns
      std::vector<double> vertices_to_inner; ///< by columns
      std::vector<double> inner_to_vertices; ///< by rows
    };

    const RodLayout                      layout;
    const std::vector<RodMatrices::Run>  runs;
    const unsigned int                   n_inner; ///< unknowns of a cell
    const unsigned int                   middle;  ///< vertex that is last
    const Held                           held;
    const bool                           has_left; ///< not all are held
    const Held                           held_right;
    std::vector<Cell>                    cells; ///< one for each run
    std::vector<Vertex>                  vertices;
    NodeBlock                            from_left, from_right;
    Vertex                               left; ///< node 0, if it has unknowns
    mutable std::array<double, n_fields> left_values;
    mutable std::vector<double>          vertex_values;
    mutable std::vector<double>          inner_values;
    double                               growth_;

    /**
     * Makes a cell of its system, vertices first.
     *
     * @return the system of its vertices that is left
     */
    Matrix
    eliminate_inner_nodes(const Matrix &system, Cell &cell);

    void
    note_growth(const double growth);

    /** @param systems of the vertices of a cell, for each run */
    void
    factorize_vertices(const std::vector<Matrix> &systems);

    /** @p right of cell @p i, its inner nodes eliminated, into vertex_values.
     */
    template <unsigned int fixed_degree>
    void
    condense(const Right &right) const;

    template <unsigned int fixed_degree>
    void
    solve_inner_nodes(const Solution &solution) const;

    /**
     * @param value of a vertex and field on the right
     * @param set_value takes vertex, field, value
     */
    template <typename Value, typename SetValue>
    void
    solve_vertices(const Value &value, const SetValue &set_value) const;
  };
} // namespace ThermoContact

#endif
