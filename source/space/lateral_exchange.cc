// SPDX-License-Identifier: LGPL-2.1-or-later

#include <thermocontact/space/lateral_exchange.h>

namespace ThermoContact
{
  template <int dim>
  LateralExchange<dim>::LateralExchange(
    const SpatialScene        &scene,
    const Discretization<dim> &discretization)
    : discretization(discretization)
    , coefficient_(scene.lateral_exchange *
                   (dim == 1 || scene.lateral_exchange == 0. ?
                      1. :
                      discretization.geometry().area_over_perimeter()))
    , has_axis_at_side(discretization.geometry().has_axis_at_side())
  {}



  template <int dim>
  bool
  LateralExchange<dim>::acts_on(
    const typename DoFHandler<dim>::face_iterator &face) const
  {
    constexpr types::boundary_id first_lateral = 2; // y = 0, its axis if any
    return dim > 1 && coefficient_ > 0. && face->at_boundary() &&
           face->boundary_id() >= first_lateral &&
           !(has_axis_at_side && face->boundary_id() == first_lateral);
  }



  template <int dim>
  void
  LateralExchange<dim>::for_each_place(const Visit &visit) const
  {
    if (!(coefficient_ > 0.))
      return;
    const unsigned int n = discretization.degree() + 1;
    const UpdateFlags  flags =
      update_values | update_quadrature_points | update_JxW_values;
    const FiniteElement<dim> &fe = discretization.finite_element();
    FEValues<dim> values(discretization.mapping(), fe, QGauss<dim>(n), flags);
    FEFaceValues<dim> face_values(discretization.mapping(),
                                  fe,
                                  QGauss<dim - 1>(n),
                                  flags);
    for (const auto &cell :
         discretization.dof_handler().active_cell_iterators())
      {
        if (!cell->is_locally_owned())
          continue;
        if (dim == 1)
          {
            values.reinit(cell);
            visit(cell, values);
            continue;
          }
        for (const unsigned int f : cell->face_indices())
          if (acts_on(cell->face(f)))
            {
              face_values.reinit(cell, f);
              visit(cell, face_values);
            }
      }
  }



  template <int dim>
  void
  LateralExchange<dim>::integrate(const FEValuesBase<dim> &values,
                                  FullMatrix<double>      &cell_matrix) const
  {
    const auto &theta = values[discretization.temperature_extractor()];
    cell_matrix       = 0.;
    for (const unsigned int q : values.quadrature_point_indices())
      for (const unsigned int i : values.dof_indices())
        for (const unsigned int j : values.dof_indices())
          cell_matrix(i, j) += coefficient_ * theta.value(i, q) *
                               theta.value(j, q) *
                               discretization.geometry().weight(values, q);
  }



  template <int dim>
  void
  LateralExchange<dim>::integrate(const FEValuesBase<dim> &values,
                                  const double             factor,
                                  dealii::Vector<double>  &cell_load) const
  {
    const auto &theta = values[discretization.temperature_extractor()];
    cell_load         = 0.;
    for (const unsigned int q : values.quadrature_point_indices())
      for (const unsigned int i : values.dof_indices())
        cell_load(i) += factor * coefficient_ * theta.value(i, q) *
                        discretization.geometry().weight(values, q);
  }



  template class LateralExchange<1>;
  template class LateralExchange<2>;
  template class LateralExchange<3>;
} // namespace ThermoContact
