// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef thermocontact_space_geometry_h
#define thermocontact_space_geometry_h

#include <thermocontact/scene/scene.h>

#include <deal.II/base/point.h>
#include <deal.II/base/symmetric_tensor.h>
#include <deal.II/base/tensor.h>

#include <deal.II/fe/fe_values.h>

namespace ThermoContact
{
  /** Strain of a displacement at a point. */
  template <int dim>
  struct Strain
  {
    dealii::SymmetricTensor<2, dim> tensor;
    double                          trace = 0.; ///< divergence
  };



  /**
   * How the mesh $(0,1)\times(0,\text{width})^{dim-1}$ stands for a body in
   * space: what its points weigh in an integral, and which strains a
   * displacement makes. All integrals of the
   * equations and all stresses come from here.
   * Nondimensional.
   */
  template <int dim>
  class Geometry
  {
  public:
    explicit Geometry(const MeshParameters &mesh);

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
      return values.JxW(q);
    }

    /** The strain of a displacement with this gradient and value at a point. */
    Strain<dim>
    strain(const dealii::Tensor<2, dim> &gradient,
           const dealii::Tensor<1, dim> &,
           const dealii::Point<dim> &) const
    {
      const dealii::SymmetricTensor<2, dim> tensor =
        dealii::symmetrize(gradient);
      return {tensor, dealii::trace(tensor)};
    }

  private:
    const double width;
    const double cross_section_;
  };



  /** $C\varepsilon:\varepsilon'$ of the elasticity (M.6). */
  template <int dim>
  double
  elastic_product(const Material    &material,
                  const Strain<dim> &first,
                  const Strain<dim> &second)
  {
    return material.lambda * first.trace * second.trace +
           material.two_mu * (first.tensor * second.tensor);
  }



  /** Component of the elastic stress $C\varepsilon$. */
  template <int dim>
  double
  elastic_stress(const Material    &material,
                 const Strain<dim> &strain,
                 const unsigned int d,
                 const unsigned int e)
  {
    return material.two_mu * strain.tensor[d][e] +
           (d == e ? material.lambda * strain.trace : 0.);
  }
} // namespace ThermoContact

#endif
