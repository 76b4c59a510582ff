// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef thermocontact_space_matrix_free_operator_h
#define thermocontact_space_matrix_free_operator_h

#include <thermocontact/scene/scene.h>
#include <thermocontact/space/contact_cells.h>
#include <thermocontact/space/discretization.h>
#include <thermocontact/space/matrix_free_spaces.h>

#include <deal.II/matrix_free/fe_evaluation.h>

#include <array>

namespace ThermoContact
{
  /**
   * Products with the matrices of the semidiscrete equations (D1.1), (D1.2),
   * computed cell by cell: those of FieldMatrices to rounding, for bodies whose
   * matrices are too large. Without constraints, as they are. Collective.
   *
   * Vectors come from Discretization::make_vector().
   */
  template <int dim>
  class MatrixFreeOperator
  {
  public:
    /** Both references are borrowed. */
    MatrixFreeOperator(const Scene               &scene,
                       const Discretization<dim> &discretization);

    /** Factors of $M$ and $K+kB+L$. */
    struct HeatFactors
    {
      double mass;
      double conduction;
      bool   is_laplacian = false; ///< of the mesh, instead of that
    };

    /**
     * Factors of $M_u$ and $S$, which is $S_\zeta$ here, and of the vector
     * Laplacian of the mesh.
     */
    struct MomentumFactors
    {
      double mass;
      double stiffness;
      double laplacian = 0.;
    };

    /** @p y = the sum of the matrices with these factors times @p x. */
    void
    heat(const HeatFactors &factors, Vector &y, const Vector &x) const;

    void
    momentum(const MomentumFactors &factors, Vector &y, const Vector &x) const;

    /**
     * @p y $=Sx$ at the nodes of the contact end, for @p x that is zero at all
     * others, by the cells at that end alone.
     */
    void
    contact_stiffness(Vector &y, const Vector &x) const;

    /** The diagonal of $S$ at the nodes of the contact end. */
    Vector
    contact_stiffness_diagonal() const;

    /** @p y $=Lx$, the heat exchange of lateral faces. */
    void
    lateral_exchange(Vector &y, const Vector &x) const;

    /** @p heat $=Du$. */
    void
    divergence(Vector &heat, const Vector &u) const;

    /** @p momentum $=D^T\theta$. */
    void
    thermal_stress(Vector &momentum, const Vector &theta) const;

    /** What differs in the cells at the contact end and at lateral faces. */
    const ContactCells<dim> &
    cells_at_end() const
    {
      return contact_cells;
    }

    /** The diagonals of the sums. */
    Vector
    heat_diagonal(const HeatFactors &factors) const;

    Vector
    momentum_diagonal(const MomentumFactors &factors) const;

  private:
    using Scalar    = FEEvaluation<dim, -1, 0, 1, double>;
    using Vectorial = FEEvaluation<dim, -1, 0, dim, double>;
    using Values    = typename ContactCells<dim>::Values;

    /** Factors of the mass of the first component, and of all others. */
    using MassOfComponents = std::array<VectorizedArray<double>, 2>;

    const Discretization<dim>   &discretization;
    const Geometry<dim>         &geometry;
    const bool                   has_uniform_weight;
    const Material              &material;
    const MatrixFreeSpaces<dim> &spaces;
    const bool                   has_lumped_mass;
    const ContactCells<dim>      contact_cells;
    mutable Values               input; ///< values of a batch

    /** What quadrature points of the present batch weigh beside the mesh. */
    template <typename Evaluation>
    VectorizedArray<double>
    weight(const Evaluation &evaluation, const unsigned int q) const
    {
      if (has_uniform_weight)
        return 1.;
      return at_point(evaluation, q, [this](const Point<dim> &point) {
        return geometry.weight_at(point);
      });
    }

    /** A function of the position of a quadrature point, for all cells. */
    template <typename Evaluation, typename Function>
    VectorizedArray<double>
    at_point(const Evaluation  &evaluation,
             const unsigned int q,
             const Function    &function) const
    {
      const auto              points = evaluation.quadrature_point(q);
      VectorizedArray<double> values = 0.;
      for (unsigned int lane = 0; lane < VectorizedArray<double>::size();
           ++lane)
        {
          Point<dim> point;
          for (unsigned int d = 0; d < dim; ++d)
            point[d] = points[d][lane];
          values[lane] = function(point);
        }
      return values;
    }

    /** The strain across the mesh per displacement along y, if there is one. */
    VectorizedArray<double>
    hoop(const Vectorial &u, const unsigned int q) const
    {
      if (dim != 2 || has_uniform_weight)
        return 0.;
      return at_point(u, q, [this](const Point<dim> &point) {
        return geometry.strain_per_displacement(point);
      });
    }

    /**
     * @p y $=$ the sum over the batches of cells of which @p acts_on is true,
     * of what @p on_cell makes of the values in its argument.
     */
    template <typename Evaluation, typename Acts, typename OnCell>
    void
    apply(const Field::Block field,
          Vector            &y,
          const Vector      &x,
          const Acts        &acts_on,
          const OnCell      &on_cell) const;

    /** The diagonal of such a sum. */
    template <int n_components, typename OnCell>
    Vector
    diagonal(const Field::Block field, const OnCell &on_cell) const;

    /** Replaces the values of a batch by their product. */
    void
    heat_on_cell(const HeatFactors &factors, Scalar &theta) const;

    void
    momentum_on_cell(const MomentumFactors &factors, Vectorial &u) const;

    /**
     * Bulk terms from @p x to the values of @p u.
     *
     * @param mass instead of that of @p factors
     */
    void
    integrate_momentum(const MomentumFactors         &factors,
                       const MassOfComponents        &mass,
                       const VectorizedArray<double> *x,
                       Vectorial                     &u) const;

    /**
     * Adds the product with a lumped mass of a batch to @p y.
     *
     * @param factors of the first component, of the others
     */
    template <int n_components>
    void
    add_lumped_mass(const unsigned int             batch,
                    const Field::Block             field,
                    const MassOfComponents        &factors,
                    const VectorizedArray<double> *x,
                    VectorizedArray<double>       *y) const;
  };
} // namespace ThermoContact

#endif
