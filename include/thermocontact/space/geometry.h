// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef thermocontact_space_geometry_h
#define thermocontact_space_geometry_h

#include <thermocontact/scene/spatial_scene.h>

#include <deal.II/base/point.h>
#include <deal.II/base/quadrature.h>
#include <deal.II/base/symmetric_tensor.h>
#include <deal.II/base/tensor.h>
#include <deal.II/base/types.h>

#include <deal.II/fe/fe_values.h>

namespace ThermoContact
{
  /** Strain of a displacement at a point, in space whatever the mesh. */
  struct Strain
  {
    dealii::SymmetricTensor<2, 3> tensor;
    double                        trace = 0.; ///< divergence

    void
    add(const double factor, const Strain &other)
    {
      tensor += factor * other.tensor;
      trace += factor * other.trace;
    }
  };



  /**
   * The geometry of a body on its mesh: the weights of quadrature points in an
   * integral, which strains a displacement makes, which lateral faces are held
   * and where contact nodes get their weights. All integrals of the equations
   * and all stresses come from here.
   */
  template <int dim>
  class Geometry
  {
  public:
    explicit Geometry(const SpatialScene &scene);

    /** Area of the contact end (1 in 1-D), by which results are scaled. */
    double
    cross_section() const
    {
      return cross_section_;
    }

    /** The point of the axis of the body at an axial position. */
    dealii::Point<dim>
    on_axis(const double x) const;

    /** Corner of the box of the mesh opposite the origin. */
    dealii::Point<dim>
    corner() const;

    /** Weight of a quadrature point of a cell or face in an integral. */
    double
    weight(const dealii::FEValuesBase<dim> &values, const unsigned int q) const
    {
      if constexpr (dim > 1)
        if (!body->has_uniform_weight())
          return values.JxW(q) * body->weight(values.quadrature_point(q)[1]);
      return values.JxW(q);
    }

    /** True if quadrature points weigh what they do on the mesh. */
    bool
    has_uniform_weight() const
    {
      return body->has_uniform_weight();
    }

    /** Area or length of the body over that of the mesh at a point. */
    double
    weight_at(const dealii::Point<dim> &point) const
    {
      return dim > 1 ? body->weight(point[dim > 1 ? 1 : 0]) : 1.;
    }

    /** Strain across a mesh of two dimensions per unit displacement along y. */
    double
    strain_per_displacement(const dealii::Point<dim> &point) const
    {
      return dim == 2 ? body->strain_across(0., 1., point[dim - 1]) : 0.;
    }

    /**
     * The rule by which the contact nodes of a face get their weights, exact
     * for one basis function.
     */
    dealii::Quadrature<dim - 1>
    node_weight_quadrature(const unsigned int degree) const;

    /** Area of the cross-section over the length of its boundary. */
    double
    area_over_perimeter() const
    {
      return body->area_over_perimeter();
    }

    /** True if the side y = 0 of the mesh is an axis of symmetry. */
    bool
    has_axis_at_side() const
    {
      return body->has_axis_at_side();
    }

    /** True if the normal displacement of a lateral face vanishes. */
    bool
    is_held(const dealii::types::boundary_id lateral_face) const;

    /** The strain of a displacement with this gradient and value at a point. */
    Strain
    strain(const dealii::Tensor<2, dim> &gradient,
           const dealii::Tensor<1, dim> &value,
           const dealii::Point<dim>     &point) const
    {
      Strain strain;
      for (unsigned int d = 0; d < dim; ++d)
        for (unsigned int e = d; e < dim; ++e)
          strain.tensor[d][e] =
            d == e ? gradient[d][d] : 0.5 * (gradient[d][e] + gradient[e][d]);
      if constexpr (dim == 2)
        strain.tensor[2][2] =
          body->strain_across(gradient[1][1], value[1], point[1]);
      strain.trace = dealii::trace(strain.tensor);
      return strain;
    }

  private:
    const std::unique_ptr<const BodyGeometry> body;
    const bool                                has_rollers;
    const bool                                has_symmetry;
    const double                              length;
    const double                              width;
    const double                              cross_section_;
  };



  /** $C\varepsilon:\varepsilon'$ of the elasticity (M1.6). */
  inline double
  elastic_product(const Elasticity &of_body,
                  const Strain     &first,
                  const Strain     &second)
  {
    return of_body.lambda * first.trace * second.trace +
           of_body.two_mu * (first.tensor * second.tensor);
  }



  /** The elastic stress $C\varepsilon$. */
  inline dealii::SymmetricTensor<2, 3>
  elastic_stress(const Elasticity &of_body, const Strain &strain)
  {
    return of_body.two_mu * strain.tensor +
           of_body.lambda * strain.trace * dealii::unit_symmetric_tensor<3>();
  }
} // namespace ThermoContact

#endif
