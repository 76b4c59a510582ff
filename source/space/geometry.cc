// SPDX-License-Identifier: LGPL-2.1-or-later

#include <thermocontact/space/geometry.h>

#include <cmath>

namespace ThermoContact
{
  template <int dim>
  Geometry<dim>::Geometry(const MeshParameters &mesh)
    : width(mesh.width)
    , cross_section_(std::pow(mesh.width, dim - 1))
  {}



  template <int dim>
  dealii::Point<dim>
  Geometry<dim>::corner() const
  {
    dealii::Point<dim> corner;
    for (unsigned int d = 0; d < dim; ++d)
      corner[d] = d == 0 ? 1. : width;
    return corner;
  }



  template <int dim>
  dealii::Point<dim>
  Geometry<dim>::on_axis(const double x) const
  {
    dealii::Point<dim> point;
    point[0] = x;
    for (unsigned int d = 1; d < dim; ++d)
      point[d] = 0.5 * width;
    return point;
  }



  template class Geometry<1>;
  template class Geometry<2>;
  template class Geometry<3>;
} // namespace ThermoContact
