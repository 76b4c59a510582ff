// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef thermocontact_space_field_matrices_h
#define thermocontact_space_field_matrices_h

#include <thermocontact/base/types.h>
#include <thermocontact/rod/rod_matrices.h>
#include <thermocontact/scene/spatial_scene.h>
#include <thermocontact/space/discretization.h>

#include <array>
#include <functional>
#include <memory>
#include <vector>

namespace ThermoContact
{
  /** Of rows and columns of a matrix. */
  std::array<Field::Block, 2>
  fields_of(const FieldMatrix::Kind kind);



  /**
   * The matrices of both fields, doc/discretisation.md section 1, made once
   * without constraints, in the numbering of their fields: of a rod cell by
   * cell, of a body assembled.
   *
   * The mass matrices may be lumped, and in the cells of the contact end that
   * of the displacement may be such that the contact nodes have no mass,
   * doc/contact-in-time.md (C1.1).
   */
  template <int dim>
  class FieldMatrices : public FieldMatrix
  {
  public:
    /** @param discretization borrowed */
    FieldMatrices(const SpatialScene        &scene,
                  const Discretization<dim> &discretization);

    ~FieldMatrices();

    /** Whether the scene has such a matrix. */
    bool
    has(const Kind kind) const
    {
      return has_[kind];
    }

    /** Of a body; empty if the scene does not have it. */
    const SparseMatrix &
    operator[](const Kind kind) const
    {
      return matrices[kind];
    }

    /** All of them, of a rod; else null. */
    const RodMatrices *
    rod() const
    {
      return rod_.get();
    }

    using Cell = typename DoFHandler<dim>::active_cell_iterator;

    /** Adds the matrix of a cell, in all of its degrees of freedom. */
    using AddPart = std::function<
      void(const Kind kind, const Cell &cell, const FullMatrix<double> &part)>;

    /** Of a body: these matrices and all that @p add_parts adds to them. */
    std::unique_ptr<const FieldMatrices>
    with(const std::function<void(const AddPart &add)> &add_parts) const;

  private:
    FieldMatrices(const FieldMatrices &other);

    const SpatialScene                   scene;
    const Discretization<dim>           &discretization;
    std::array<bool, n_matrices>         has_{};
    std::array<SparseMatrix, n_matrices> matrices;
    std::unique_ptr<const RodMatrices>   rod_;

    /** Places of the unknowns of a field among those of a cell. */
    std::array<std::vector<std::size_t>, 2> places;

    /** Quadrature in cells, and what was found in the last one. */
    struct Integrals;

    std::unique_ptr<Integrals> integrals; ///< while matrices are made

    /** Of the present cell of a rod: matrix by matrix, column by column. */
    std::vector<double> rod_entries;

    /** The unknowns of a field in a cell. */
    std::vector<types::global_dof_index>
    dofs(const Cell &cell, const Field::Block field) const;

    /** An empty matrix of the right pattern. */
    void
    setup(const Kind kind);

    /** Of a body. */
    void
    assemble();

    /** After parts of cells were added. */
    void
    compress();

    /**
     * Not from assembled matrices: in a row of those the parts of two cells
     * cannot be told apart, and cells that differ by rounding could not be
     * treated as the same without forces on a rod that does not move.
     */
    void
    make_rod();

    /** Mass, spring and dashpot of an obstacle that moves by itself. */
    void
    add_obstacle();

    // The parts of a cell.

    /** Adds a factor times the matrix of a cell, in all of its degrees of
     * freedom. */
    void
    add(const Kind                kind,
        const Cell               &cell,
        const FullMatrix<double> &cell_matrix,
        const double              factor = 1.);

    /** The factor of a coefficient in a cell of a row, (M10.1); else 1. */
    double
    factor(const Kind kind, const Cell &cell) const;

    void
    add_mass(const Cell &cell);

    void
    add_stiffness(const Cell &cell);

    /** Springs, dashpots and masses of the ends of a rod. */
    void
    add_attached(const Cell &cell);

    /** Masses and contacts of a row in one of its gaps. */
    void
    add_gap(const Cell &cell);

    /** Of the contact end, and with the surroundings. */
    void
    add_heat_exchange(const Cell &cell);
  };
} // namespace ThermoContact

#endif
