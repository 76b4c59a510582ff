// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef thermocontact_space_h1_projection_h
#define thermocontact_space_h1_projection_h

#include <thermocontact/scene/scene.h>
#include <thermocontact/space/discretization.h>
#include <thermocontact/space/enclosed_function.h>

#include <array>
#include <memory>
#include <vector>

namespace ThermoContact
{
  template <int dim, typename Number>
  class CellProducts;



  /**
   * The projection $P_E$ of initial data, doc/discretisation.md (D1.3):
   * $(\nabla(P_E w-w),\nabla\eta)=0$ for all $\eta$ that vanish on the fixed
   * end, with $P_E w=w$ there, also if it slides; at rollers the normal
   * component keeps the value of $w$ too.
   *
   * Computed as the nodal interpolant plus a correction, integrated by parts
   * cell by cell, so that only values of $w$ are needed and, in 1-D, the
   * interpolation at the vertices holds to rounding. From degree 2 on the
   * projection on a rod has the mean of $w$ in each cell, which may jump.
   */
  template <int dim>
  class H1Projection
  {
  public:
    /**
     * @param scene,discretization borrowed
     * @param known products for the conjugate gradients of a body, borrowed;
     *   null: it makes its own
     */
    H1Projection(const Scene                     &scene,
                 const Discretization<dim>       &discretization,
                 const CellProducts<dim, double> *known = nullptr);

    ~H1Projection(); // compiled once

    /**
     * Projects @p function, with the components of the FESystem.
     *
     * @param temperature,displacement out: the two blocks of the projection
     */
    void
    project(const EnclosedFunction<dim> &function,
            Vector                      &temperature,
            Vector                      &displacement) const;

  private:
    const Discretization<dim>      &discretization;
    const AffineConstraints<double> constraints;

    const std::unique_ptr<const CellProducts<dim, double>> own_products;
    const CellProducts<dim, double> *const products; ///< null of a rod

    /** Positions of the values of the fields that are kept, in local parts. */
    std::array<std::vector<unsigned int>, 2> kept_entries;

    /** $(\nabla(w-w_h),\nabla\eta)$ of the correction, where $w_h$ has the
     * values of $w$ at the nodes. */
    Vector
    rest_of_interpolant(const EnclosedFunction<dim> &function,
                        const Field::Block           field) const;

    /** Adds the correction of a rod: it is zero at vertices. */
    void
    add_in_cells(const Field::Block field,
                 const Vector      &rhs,
                 Vector            &values) const;
  };
} // namespace ThermoContact

#endif
