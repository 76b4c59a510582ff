// SPDX-License-Identifier: LGPL-2.1-or-later

#include <thermocontact/method/body_geometry.h>

namespace ThermoContact
{
  namespace
  {
    /**
     * A round rod: the mesh is the half of a section along its axis, y the
     * radius. Areas and volumes are those of an angle of one, doc/model.md
     * (M7.1).
     */
    class RoundRod : public BodyGeometry
    {
    public:
      RoundRod(const unsigned int dim, const double width)
        : BodyGeometry(dim, width)
      {}

      std::string
      description(
        const std::function<std::string(double)> &length) const override
      {
        return "round rod of length " + length(1.) + " and radius " +
               length(width);
      }

      double
      cross_section() const override
      {
        return 0.5 * width * width;
      }

      double
      area_over_perimeter() const override
      {
        return 0.5 * width;
      }

      double
      axis() const override
      {
        return 0.;
      }

      bool
      has_axis_at_side() const override
      {
        return true;
      }

      bool
      has_uniform_weight() const override
      {
        return false;
      }

      double
      weight(const double y) const override
      {
        return y;
      }

      /** $u_r/r$, on the axis its limit. */
      double
      strain_across(const double derivative,
                    const double displacement,
                    const double y) const override
      {
        return y > 0. ? displacement / y : derivative;
      }
    };
  } // namespace



  GeometryKind
  axisymmetric()
  {
    return {"axisymmetric",
            "a round rod, y is the radius, the axis at y = 0",
            [](const unsigned int dim, const double width) {
              return std::make_unique<RoundRod>(dim, width);
            }};
  }
} // namespace ThermoContact
