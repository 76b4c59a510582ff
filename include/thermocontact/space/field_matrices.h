// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef thermocontact_space_field_matrices_h
#define thermocontact_space_field_matrices_h

#include <thermocontact/base/types.h>
#include <thermocontact/scene/spatial_scene.h>
#include <thermocontact/space/discretization.h>
#include <thermocontact/space/rod_cells.h>

#include <memory>

namespace ThermoContact
{
  /** The diagonal block of the displacement. */
  inline const SparseMatrix &
  last_block(const BlockSparseMatrix &matrix)
  {
    return matrix.block(matrix.n_block_rows() - 1, matrix.n_block_cols() - 1);
  }



  /**
   * The matrices of both fields, doc/discretisation.md section 1, assembled
   * once without constraints. The first diagonal block belongs to the
   * temperature, the last to the displacement; a field that the scene does not
   * have has none.
   *
   * The mass matrices may be lumped, and in the cells of the contact end that
   * of the displacement may be such that the contact nodes have no mass,
   * doc/contact-in-time.md (C1.1).
   */
  template <int dim>
  struct FieldMatrices
  {
    /** @param discretization borrowed */
    FieldMatrices(const SpatialScene        &scene,
                  const Discretization<dim> &discretization);

  private:
    const SpatialScene         scene;
    const Discretization<dim> &discretization;

  public:
    BlockSparseMatrix mass;      ///< $M$, $M_u$
    BlockSparseMatrix stiffness; ///< $K+kB+L$, $S$

    /** $D$ in (0, 1), $D^T$ in (1, 0); none without thermal stress. */
    BlockSparseMatrix coupling;

    /** $S_\zeta$ in the last block, where it is not $S$, (C6.1). */
    BlockSparseMatrix viscous_stiffness;

    /** $L$ in the first block, of a scene with lateral heat exchange. */
    BlockSparseMatrix lateral_exchange;

    /** All of them cell by cell, of a rod that one process has; else null. */
    std::unique_ptr<const RodMatrices> rod;

  private:
    std::unique_ptr<RodCells> rod_cells; ///< while they are assembled

    void
    start_rod();

    /** @param couples_fields two blocks off the diagonal, else those on it */
    void
    setup_matrix(const bool couples_fields, BlockSparseMatrix &matrix) const;

    void
    assemble_mass();

    void
    assemble_stiffness();

    /** Adds the heat exchange of the contact end. */
    void
    assemble_contact_end();

    /** Adds the heat exchange with the surroundings. */
    void
    assemble_lateral_exchange();
  };
} // namespace ThermoContact

#endif
