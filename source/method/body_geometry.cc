// SPDX-License-Identifier: LGPL-2.1-or-later

#include <thermocontact/base/named.h>
#include <thermocontact/base/special_numbers.h>
#include <thermocontact/base/text.h>
#include <thermocontact/method/body_geometry.h>

#include <cmath>

namespace ThermoContact
{
  std::string
  BodyGeometry::description(
    const std::function<std::string(double)> &length) const
  {
    if (dim == 1)
      return "rod of length " + length(1.);
    return text(
      dim, "-D body of length ", length(1.), " and width ", length(width));
  }



  double
  BodyGeometry::cross_section() const
  {
    return std::pow(width, dim - 1);
  }



  double
  BodyGeometry::area_over_perimeter() const
  {
    return dim == 1 ? infinity : width / (2. * (dim - 1.));
  }



  namespace
  {
    GeometryKind
    plane_strain()
    {
      return {"plane strain",
              "a strip, y runs over its width",
              [](const unsigned int dim, const double width) {
                return std::make_unique<BodyGeometry>(dim, width);
              }};
    }
  } // namespace



  const std::vector<GeometryKind> &
  geometries()
  {
    static const std::vector<GeometryKind> kinds = {plane_strain(),
                                                    axisymmetric()};
    return kinds;
  }



  const GeometryKind &
  geometry(const std::string &name)
  {
    return named(name, geometries());
  }
} // namespace ThermoContact
