// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef thermocontact_space_cell_shape_h
#define thermocontact_space_cell_shape_h

#include <thermocontact/base/tolerances.h>
#include <thermocontact/base/types.h>

#include <deal.II/base/bounding_box.h>
#include <deal.II/base/geometry_info.h>

#include <deal.II/dofs/dof_handler.h>

#include <deal.II/fe/fe.h>

#include <cmath>
#include <optional>
#include <utility>

namespace ThermoContact
{
  /**
   * Where a cell of the mesh is, and its map from the unit cell. Cells are
   * boxes along the axes. Sums over one direction after the other, in
   * CellProducts and H1Projection, need such cells; all others ask this class
   * or integrate by FEValues.
   */
  template <int dim>
  class CellShape
  {
  public:
    explicit CellShape(
      const typename DoFHandler<dim>::active_cell_iterator &cell)
      : box({cell->vertex(0),
             cell->vertex(GeometryInfo<dim>::vertices_per_cell - 1)})
    {}

    /** Whether a point is in the cell, with the slack Tolerances::in_cell. */
    bool
    contains(const Point<dim> &point) const
    {
      return box.point_inside(point, Tolerances::in_cell);
    }

    /** All points that the cell contains have an x between these. */
    std::pair<double, double>
    range() const
    {
      const double slack = 2. * Tolerances::in_cell * box.side_length(0);
      return {box.lower_bound(0) - slack, box.upper_bound(0) + slack};
    }

    /** Where the line along x through a point is in the cell, if it is. */
    std::optional<std::pair<double, double>>
    interval(Point<dim> point) const
    {
      point[0] = box.center()[0];
      if (!contains(point))
        return {};
      return std::pair(box.lower_bound(0), box.upper_bound(0));
    }

    /** The point at a point of the unit cell; to the bit at vertices. */
    Point<dim>
    point(const Point<dim> &unit_point) const
    {
      Point<dim> result;
      for (unsigned int d = 0; d < dim; ++d)
        result[d] = (1. - unit_point[d]) * box.lower_bound(d) +
                    unit_point[d] * box.upper_bound(d);
      return result;
    }

    /** The point of the unit cell that is nearest to a point. */
    Point<dim>
    unit_point(const Point<dim> &point) const
    {
      return GeometryInfo<dim>::project_to_unit_cell(box.real_to_unit(point));
    }

    /**
     * The gradient of a basis function of an element at a point of the unit
     * cell; exactly 0 along a direction in which the function is constant.
     */
    Tensor<1, dim>
    gradient(const FiniteElement<dim> &element,
             const unsigned int        function,
             const Point<dim>         &unit_point) const
    {
      Tensor<1, dim> gradient = element.shape_grad(function, unit_point);
      for (unsigned int d = 0; d < dim; ++d)
        gradient[d] =
          std::abs(gradient[d]) <= Tolerances::rounding_of_solution ?
            0. :
            gradient[d] / box.side_length(d);
      return gradient;
    }

    /** The lengths of the sides. */
    Tensor<1, dim>
    sides() const
    {
      return box.get_boundary_points().second - box.get_boundary_points().first;
    }

    const BoundingBox<dim> &
    bounding_box() const
    {
      return box;
    }

    /** The box without length along x of a face at an end of the body. */
    BoundingBox<dim>
    end_face(const unsigned int face) const
    {
      auto corners = box.get_boundary_points();
      (face == 0 ? corners.second : corners.first)[0] = box.vertex(face)[0];
      return {corners};
    }

  private:
    const BoundingBox<dim> box;
  };
} // namespace ThermoContact

#endif
