// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef thermocontact_space_lateral_exchange_h
#define thermocontact_space_lateral_exchange_h

#include <thermocontact/base/types.h>
#include <thermocontact/scene/spatial_scene.h>
#include <thermocontact/space/discretization.h>

#include <deal.II/fe/fe_values.h>

#include <functional>

namespace ThermoContact
{
  /**
   * Where the heat exchange with the surroundings acts, doc/model.md (M5.5),
   * (D1.5): in all cells of a rod, whose sides are not on the mesh, and on the
   * lateral faces of a body, those at its axis of symmetry excepted. The same
   * integral in every dimension, of a body whose cross-section has one
   * temperature.
   */
  template <int dim>
  class LateralExchange
  {
  public:
    /** @param discretization borrowed */
    LateralExchange(const SpatialScene        &scene,
                    const Discretization<dim> &discretization);

    /**
     * $m$ of a rod, $m|A|/|\partial A|$ of a body: heat per volume, or through
     * the faces, and difference of temperatures.
     */
    double
    coefficient() const
    {
      return coefficient_;
    }

    /** True if it acts on a face of the mesh. */
    bool
    acts_on(const typename DoFHandler<dim>::face_iterator &face) const;

    /** A cell, and the points on it, or on one of its faces. */
    using Visit = std::function<
      void(const typename DoFHandler<dim>::active_cell_iterator &cell,
           const FEValuesBase<dim>                              &values)>;

    /** Calls @p visit for the locally owned places; never without exchange. */
    void
    for_each_place(const Visit &visit) const;

    /**
     * $L$: @p cell_matrix $=\int m\,\eta_i\eta_j$ of a place, in all degrees of
     * freedom of the cell.
     */
    void
    integrate(const FEValuesBase<dim> &values,
              FullMatrix<double>      &cell_matrix) const;

    /** $\int m\,\eta_i$ times @p factor. */
    void
    integrate(const FEValuesBase<dim> &values,
              const double             factor,
              dealii::Vector<double>  &cell_load) const;

  private:
    const Discretization<dim> &discretization;
    const double               coefficient_;
    const bool                 has_axis_at_side;
  };
} // namespace ThermoContact

#endif
