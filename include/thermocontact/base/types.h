// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef thermocontact_base_types_h
#define thermocontact_base_types_h

#include <deal.II/base/mpi.h>
#include <deal.II/base/quadrature_lib.h>

#include <deal.II/distributed/tria.h>

#include <deal.II/lac/la_parallel_block_vector.h>
#include <deal.II/lac/la_parallel_vector.h>
#include <deal.II/lac/trilinos_block_sparse_matrix.h>
#include <deal.II/lac/trilinos_sparse_matrix.h>
#include <deal.II/lac/trilinos_vector.h>

#include <memory>

/**
 * Dynamic contact of a thermoviscoelastic rod with an obstacle. All
 * quantities are nondimensional; the equations are those of doc/model.md.
 */
namespace ThermoContact
{
  using namespace dealii;

  /**
   * Values of one field (temperature or displacement); of a body with the
   * ghosts that products without matrices need.
   */
  using Vector = LinearAlgebra::distributed::Vector<double>;

  /** Both fields, where something needs values of cells: with ghosts. */
  using BlockVector = LinearAlgebra::distributed::BlockVector<double>;

  /**
   * Both fields in the numbering of the whole system, in which a rank owns two
   * ranges: for matrices of the whole system.
   */
  using SystemVector = TrilinosWrappers::MPI::Vector;

  using SparseMatrix      = TrilinosWrappers::SparseMatrix;
  using BlockSparseMatrix = TrilinosWrappers::BlockSparseMatrix;

  /** The fields, in the order of the blocks. */
  struct Field
  {
    enum Block : unsigned int
    {
      temperature,
      displacement
    };
  };

  constexpr Field::Block all_fields[] = {Field::temperature,
                                         Field::displacement};

  /** Boundary ids that GridGenerator gives to a coloured box. */
  constexpr types::boundary_id fixed_boundary_id   = 0; ///< $x=0$
  constexpr types::boundary_id contact_boundary_id = 1; ///< $x=1$
  constexpr types::boundary_id first_lateral_id    = 2; ///< $y=0$

  /**
   * The differences of one dimension: a face is a point, and the mesh is too
   * small to be shared by ranks.
   */
  template <int dim>
  struct DimensionTraits
  {
    /** The ranks that share the mesh, of those that are there. */
    static MPI_Comm
    communicator(const MPI_Comm all)
    {
      return all;
    }

    /** A factorisation costs about as much as a step, or less. */
    static constexpr bool has_cheap_factors = false;

    /** Gauss-Lobatto rule on a face whose points are the nodes of FE_Q. */
    static Quadrature<dim - 1>
    nodal_face_quadrature(const unsigned int degree)
    {
      return QGaussLobatto<dim - 1>(degree + 1);
    }
  };

  template <>
  struct DimensionTraits<1>
  {
    /** Each rank has the whole rod: the same bits on any number of them. */
    static MPI_Comm
    communicator(const MPI_Comm)
    {
      return MPI_COMM_SELF;
    }

    static constexpr bool has_cheap_factors = true;

    static Quadrature<0>
    nodal_face_quadrature(const unsigned int)
    {
      return QGauss<0>(1);
    }
  };
} // namespace ThermoContact

#endif
