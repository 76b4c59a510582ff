// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef thermocontact_space_enclosed_function_h
#define thermocontact_space_enclosed_function_h

#include <thermocontact/input/jet.h>

#include <deal.II/base/bounding_box.h>
#include <deal.II/base/function.h>
#include <deal.II/base/quadrature_lib.h>

#include <vector>

namespace ThermoContact
{
  using dealii::BoundingBox;
  using dealii::Function;
  using dealii::Point;
  using dealii::Quadrature;

  /** A function of the place that tells what it does in a box. */
  template <int dim>
  class EnclosedFunction : public Function<dim>
  {
  public:
    using Function<dim>::Function;

    /** True if a component may vary along an axis. */
    virtual bool
    varies_along(const unsigned int direction,
                 const unsigned int component) const = 0;

    /** Value of a component with its derivatives along an axis, which may not
     * be finite. */
    virtual NumberJet
    derivatives(const Point<dim>  &place,
                const unsigned int direction,
                const unsigned int component) const = 0;

    /** The same at all places of a box. */
    virtual IntervalJet
    enclosure(const BoundingBox<dim> &box,
              const unsigned int      direction,
              const unsigned int      component) const = 0;

    /** A bound of the component in a box; 0 if there is none. */
    virtual double
    bound(const BoundingBox<dim> &box, const unsigned int component) const;
  };



  /**
   * Rules by which a function is integrated over boxes: Gauss's in pieces. A
   * box is halved, first where most may be missed, until a component is nearly
   * a parabola along each axis of a piece, or 256 pieces are there. Since the
   * values in a piece are enclosed, a load is not overlooked: along one axis
   * down to a width of 1e-12 of the box, in more dimensions as far as its shape
   * is followed by so many boxes. Sides of length 0 count for nothing: a face
   * is a box as well.
   */
  template <int dim>
  class PiecewiseRule
  {
  public:
    /**
     * @param function borrowed
     * @param body a box in which it is needed
     * @param n_points along each axis of a box; one less in each half of it
     */
    PiecewiseRule(const EnclosedFunction<dim> &function,
                  const BoundingBox<dim>      &body,
                  const unsigned int           n_points);

    /** To be called when the time of the function has changed. */
    void
    update();

    /** True if a box is one piece. */
    bool
    is_smooth(const BoundingBox<dim> &box, const unsigned int component) const;

    /** The points in a box and their weights. */
    Quadrature<dim>
    operator()(const BoundingBox<dim> &box, const unsigned int component) const;

  private:
    const EnclosedFunction<dim>   &function;
    const BoundingBox<dim>         body;
    bool                           varies = false; ///< else boxes are smooth
    std::vector<dealii::QGauss<1>> rules;  ///< along boxes, halves, quarters
    std::vector<double>            bounds; ///< of each component
  };
} // namespace ThermoContact

#endif
