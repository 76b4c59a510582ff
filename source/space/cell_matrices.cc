// SPDX-License-Identifier: LGPL-2.1-or-later

#include <thermocontact/space/cell_matrices.h>

#include <utility>

namespace ThermoContact
{
  template <int dim>
  CellMatrix
  mass_between(const Discretization<dim>      &discretization,
               const std::vector<std::size_t> &dofs,
               const FEValuesBase<dim>        &values,
               const CoefficientAt<dim>       &coefficient)
  {
    FullMatrix<double> matrix(dofs.size(), dofs.size());
    // few functions differ from zero at points that are nodes along a direction
    std::vector<std::pair<unsigned int, double>> present;
    for (const unsigned int q : values.quadrature_point_indices())
      {
        present.clear();
        for (unsigned int i = 0; i < dofs.size(); ++i)
          if (const double value = values.shape_value(dofs[i], q); value != 0.)
            present.emplace_back(i, value);
        const double weight = coefficient(values.quadrature_point(q)) *
                              discretization.geometry().weight(values, q);
        for (const auto &[i, first] : present)
          for (const auto &[j, second] : present)
            matrix(i, j) += weight * first * second;
      }
    return {dofs, matrix};
  }



  template <int dim>
  void
  evaluate_basis(const Discretization<dim>   &discretization,
                 const FEValues<dim>         &fe_values,
                 const unsigned int           q,
                 std::vector<CellBasis<dim>> &basis)
  {
    if (discretization.has_field(Field::temperature))
      {
        const auto &theta = fe_values[discretization.temperature_extractor()];
        for (const unsigned int i : fe_values.dof_indices())
          {
            basis[i].theta      = theta.value(i, q);
            basis[i].grad_theta = theta.gradient(i, q);
          }
      }
    if (discretization.has_field(Field::displacement))
      {
        const auto &u = fe_values[discretization.displacement_extractor()];
        for (const unsigned int i : fe_values.dof_indices())
          basis[i].strain =
            discretization.geometry().strain(u.gradient(i, q),
                                             u.value(i, q),
                                             fe_values.quadrature_point(q));
      }
  }



  template <int dim>
  HeatExchangeFaces<dim>::HeatExchangeFaces(
    const SpatialScene        &scene,
    const Discretization<dim> &discretization)
    : discretization(discretization)
    , left_coefficient(scene.left_exchange)
    , end_coefficient(scene.exchange_coefficient)
    , lateral_coefficient(scene.lateral_exchange *
                          (dim == 1 || scene.lateral_exchange == 0. ?
                             1. :
                             discretization.geometry().area_over_perimeter()))
    // cells of bodies are not asked, and their full rule would be large
    , cell_values(discretization.mapping(),
                  discretization.finite_element(),
                  QGauss<dim>(dim == 1 ? discretization.degree() + 1 : 1),
                  update_values | update_quadrature_points | update_JxW_values)
    , face_values(discretization.mapping(),
                  discretization.finite_element(),
                  QGauss<dim - 1>(discretization.degree() + 1),
                  update_values | update_quadrature_points | update_JxW_values)
  {}



  template <int dim>
  double
  HeatExchangeFaces<dim>::coefficient(
    const typename DoFHandler<dim>::face_iterator &face) const
  {
    if (!face->at_boundary())
      return 0.;
    if (face->boundary_id() == fixed_boundary_id)
      return left_coefficient;
    if (face->boundary_id() == contact_boundary_id)
      return discretization.has_right_temperature() ? 0. : end_coefficient;
    return face->boundary_id() == first_lateral_id &&
               discretization.geometry().has_axis_at_side() ?
             0. :
             lateral_coefficient;
  }



  template <int dim>
  void
  HeatExchangeFaces<dim>::visit(
    const typename DoFHandler<dim>::active_cell_iterator &cell,
    const Visit                                          &visit)
  {
    if (!discretization.has_field(Field::temperature))
      return;
    const FiniteElement<dim> &fe   = discretization.finite_element();
    const auto                give = [&](const FEValuesBase<dim>  &values,
                          const CoefficientAt<dim> &factor,
                          const bool                is_lateral,
                          const auto               &is_there) {
      std::vector<std::size_t> dofs;
      for (unsigned int i = 0; i < fe.dofs_per_cell; ++i)
        if (fe.system_to_component_index(i).first == 0 && is_there(i))
          dofs.push_back(i);
      visit(mass_between(discretization, dofs, values, factor), is_lateral);
    };
    for (const unsigned int f : cell->face_indices())
      if (const double factor = coefficient(cell->face(f)); factor > 0.)
        {
          face_values.reinit(cell, f);
          give(
            face_values,
            [factor](const Point<dim> &) { return factor; },
            cell->face(f)->boundary_id() >= first_lateral_id,
            [&](const unsigned int i) { return fe.has_support_on_face(i, f); });
        }
    if (dim == 1 && lateral_coefficient > 0.)
      {
        cell_values.reinit(cell);
        give(
          cell_values,
          [&](const Point<dim> &place) {
            return lateral_coefficient *
                   discretization.in_equations(cell, place).section;
          },
          true,
          [](const unsigned int) { return true; });
      }
  }



#define INSTANTIATE(dim)                                             \
  template CellMatrix mass_between(const Discretization<dim> &,      \
                                   const std::vector<std::size_t> &, \
                                   const FEValuesBase<dim> &,        \
                                   const CoefficientAt<dim> &);      \
  template void       evaluate_basis(const Discretization<dim> &,    \
                                     const FEValues<dim> &,          \
                                     const unsigned int,             \
                                     std::vector<CellBasis<dim>> &); \
  template class HeatExchangeFaces<dim>

  INSTANTIATE(1);
  INSTANTIATE(2);
  INSTANTIATE(3);

#undef INSTANTIATE
} // namespace ThermoContact
