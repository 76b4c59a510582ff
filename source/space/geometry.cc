// SPDX-License-Identifier: LGPL-2.1-or-later

#include <thermocontact/base/types.h>
#include <thermocontact/space/geometry.h>

#include <deal.II/base/quadrature_lib.h>

namespace ThermoContact
{
  template <int dim>
  Geometry<dim>::Geometry(const SpatialScene &scene)
    : body(scene.mesh.make_geometry(dim))
    , has_rollers(scene.has_rollers)
    , has_symmetry(scene.has_symmetry)
    , length(scene.row.length())
    , width(scene.mesh.width)
    , cross_section_(body->cross_section())
  {}



  template <int dim>
  dealii::Point<dim>
  Geometry<dim>::corner() const
  {
    dealii::Point<dim> corner;
    for (unsigned int d = 0; d < dim; ++d)
      corner[d] = d == 0 ? length : width;
    return corner;
  }



  template <int dim>
  dealii::Point<dim>
  Geometry<dim>::on_axis(const double x) const
  {
    dealii::Point<dim> point;
    point[0] = x;
    for (unsigned int d = 1; d < dim; ++d)
      point[d] = body->axis();
    return point;
  }



  template <int dim>
  dealii::Quadrature<dim - 1>
  Geometry<dim>::node_weight_quadrature(const unsigned int degree) const
  {
    // with a weight the nodal rule is not exact for degree 1
    if (!body->has_uniform_weight())
      return dealii::QGauss<dim - 1>(degree + 1);
    return DimensionTraits<dim>::nodal_face_quadrature(degree);
  }



  template <int dim>
  bool
  Geometry<dim>::is_held(const dealii::types::boundary_id lateral_face) const
  {
    constexpr dealii::types::boundary_id side_at_zero = 2; // y = 0
    return has_rollers || (has_symmetry && lateral_face % 2 == 0) ||
           (lateral_face == side_at_zero && body->has_axis_at_side());
  }



  template class Geometry<1>;
  template class Geometry<2>;
  template class Geometry<3>;
} // namespace ThermoContact
