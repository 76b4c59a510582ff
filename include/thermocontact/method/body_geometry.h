// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef thermocontact_method_body_geometry_h
#define thermocontact_method_body_geometry_h

#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace ThermoContact
{
  /**
   * The body for which the box $(0,1)\times(0,\text{width})^{dim-1}$ of the
   * mesh stands: the weights of its points in integrals, the strain that is not
   * in the plane of the mesh, its axis and the support there. No mesh, no
   * matrix. Nondimensional.
   *
   * This class is the box itself: a rod, a strip in plane strain, a block.
   */
  class BodyGeometry
  {
  public:
    BodyGeometry(const unsigned int dim, const double width)
      : dim(dim)
      , width(width)
    {}

    virtual ~BodyGeometry() = default;

    /** The body for the screen. @param length writes one in its unit */
    virtual std::string
    description(const std::function<std::string(double)> &length) const;

    /** Area of the contact end (1 in 1-D), by which results are scaled. */
    virtual double
    cross_section() const;

    /**
     * Area of the cross-section over the length of its lateral boundary;
     * infinity for a mesh of one dimension, which shows none.
     */
    virtual double
    area_over_perimeter() const;

    /** Coordinates y and z of the axis of the body. */
    virtual double
    axis() const
    {
      return 0.5 * width;
    }

    /**
     * True if the side y = 0 of the mesh is an axis of symmetry, across which
     * nothing moves.
     */
    virtual bool
    has_axis_at_side() const
    {
      return false;
    }

    /** True if weight() is one everywhere. */
    virtual bool
    has_uniform_weight() const
    {
      return true;
    }

    /** Area or length of the body over that of the mesh at @p y. */
    virtual double
    weight(const double y) const
    {
      (void)y;
      return 1.;
    }

    /**
     * The normal strain across a mesh of two dimensions.
     *
     * @param derivative of the displacement along y in this direction
     * @param displacement along y
     */
    virtual double
    strain_across(const double derivative,
                  const double displacement,
                  const double y) const
    {
      (void)derivative;
      (void)displacement;
      (void)y;
      return 0.;
    }

  protected:
    const unsigned int dim;
    const double       width;
  };



  /** A kind of geometry: its name and the way to make it. */
  struct GeometryKind
  {
    std::string name; ///< as the user gives it
    std::string text; ///< its meaning, for the parameter reference

    /** @param dim dimension of the mesh, and its width */
    std::function<std::unique_ptr<const BodyGeometry>(const unsigned int dim,
                                                      const double       width)>
      make;
  };



  /**
   * The geometries for which a mesh of two dimensions may stand; the first is
   * the default and the one of other dimensions. To add one: a file that
   * defines its kind, and its name in the list.
   */
  const std::vector<GeometryKind> &
  geometries();

  /** The kind of that name, which exists. */
  const GeometryKind &
  geometry(const std::string &name);

  // the kinds that have files of their own
  GeometryKind
  axisymmetric();
} // namespace ThermoContact

#endif
