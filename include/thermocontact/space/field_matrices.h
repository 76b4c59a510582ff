// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef thermocontact_space_field_matrices_h
#define thermocontact_space_field_matrices_h

#include <thermocontact/base/types.h>
#include <thermocontact/rod/rod_matrices.h>
#include <thermocontact/scene/spatial_scene.h>
#include <thermocontact/space/discretization.h>

#include <array>
#include <memory>
#include <vector>

namespace ThermoContact
{
  /**
   * The matrices of both fields, doc/discretisation.md section 1, assembled
   * once without constraints, in the numbering of their fields; matrices that
   * the scene does not have are empty.
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

    const SparseMatrix &
    operator[](const Kind kind) const
    {
      return matrices[kind];
    }

    /** All of them cell by cell, of a rod; else null. */
    const RodMatrices *
    rod() const
    {
      return rod_.get();
    }

  private:
    const SpatialScene                 scene;
    const Discretization<dim>         &discretization;
    std::array<SparseMatrix, n_kinds>  matrices;
    std::unique_ptr<const RodMatrices> rod_;

    /** Places of the unknowns of a field among those of a cell. */
    std::array<std::vector<std::size_t>, 2> places;

    /** Of the cells of a rod, while they are assembled: matrix by matrix, cell
     * by cell, column by column. */
    std::vector<double> rod_entries;

    /** The unknowns of a field in a cell. */
    std::vector<types::global_dof_index>
    dofs(const typename DoFHandler<dim>::active_cell_iterator &cell,
         const Field::Block                                    field) const;

    double &
    rod_entry(const Kind         kind,
              const unsigned int cell,
              const unsigned int i,
              const unsigned int j);

    /** An empty matrix of the right pattern. */
    void
    setup(const Kind kind);

    /** Adds a factor times the matrix of a cell, in all of its degrees of
     * freedom. */
    void
    add(const Kind                                            kind,
        const typename DoFHandler<dim>::active_cell_iterator &cell,
        const FullMatrix<double>                             &cell_matrix,
        const double                                          factor = 1.);

    /** The factor of a coefficient in a cell of a row, (M10.1); else 1. */
    double
    factor(const Kind kind, const unsigned int cell) const;

    void
    assemble_mass();

    void
    assemble_stiffness();

    /** Springs, dashpots and masses of the ends of a rod. */
    void
    assemble_attached();

    /** Masses and contacts of a row. */
    void
    assemble_row();

    /** Of the contact end, and with the surroundings. */
    void
    assemble_heat_exchange();

    /**
     * The matrices of the cells of a rod. Not the assembled ones: in a row of
     * those the parts of two cells cannot be told apart, and cells that differ
     * by rounding could not be treated as the same without forces on a rod that
     * does not move.
     */
    void
    make_rod();
  };
} // namespace ThermoContact

#endif
