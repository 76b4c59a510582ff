// SPDX-License-Identifier: LGPL-2.1-or-later

#include <thermocontact/space/cell_matrices.h>
#include <thermocontact/space/massless_contact.h>
#include <thermocontact/space/nonlinear_body.h>

#include <deal.II/base/quadrature_lib.h>

#include <deal.II/fe/fe_values.h>

namespace ThermoContact
{
  template <int dim>
  NonlinearBody<dim>::NonlinearBody(const Scene    &scene,
                                    const Operator &equations)
    : fields(scene.fields)
    , material(scene.material)
    , has_lumped_mass(scene.has_lumped_mass)
    , equations(equations)
    , discretization(equations.space())
  {
    const auto &fe = discretization.finite_element();
    for (unsigned int i = 0; i < fe.dofs_per_cell; ++i)
      places[fields.has_temperature &&
                 fe.system_to_component_index(i).first == 0 ?
               Field::temperature :
               Field::displacement]
        .push_back(i);
  }



  template <int dim>
  struct NonlinearBody<dim>::Point
  {
    double                             weight = 0.;
    const std::vector<CellBasis<dim>> &basis;
    const Material                    &material;
    RodTangents                        beyond;
    Elasticity                         elasticity;

    double         theta = 0., rate = 0.;
    Tensor<1, dim> gradient{};
    Strain         strain{}, strain_rate{};

    /** Of these coefficients. */
    SymmetricTensor<2, 3>
    stress(const RodCoefficients &of) const
    {
      return of.stiffness * elastic_stress(elasticity, strain) +
             material.viscosity * of.viscosity *
               elastic_stress(elasticity, strain_rate) -
             material.thermal_stress * of.coupling * theta *
               unit_symmetric_tensor<3>();
    }
  };



  template <int dim>
  void
  NonlinearBody<dim>::visit(const Instant &instant,
                            const AtPoint &at_mass,
                            const AtPoint &at_rest,
                            const AtCell  &at_cell) const
  {
    const BlockVector values = discretization.with_ghosts(instant.temperature,
                                                          instant.displacement),
                      rates =
                        discretization.with_ghosts(instant.temperature_rate,
                                                   instant.velocity);
    const auto       &fe    = discretization.finite_element();
    const UpdateFlags flags = update_values | update_gradients |
                              update_quadrature_points | update_JxW_values;
    const unsigned int degree = discretization.degree();
    FEValues<dim>      of_mass(discretization.mapping(),
                          fe,
                          mass_quadrature<dim>(degree, has_lumped_mass),
                          flags),
      of_rest(discretization.mapping(), fe, QGauss<dim>(degree + 1), flags);
    std::vector<types::global_dof_index> dofs(fe.dofs_per_cell);
    std::vector<CellBasis<dim>>          basis(fe.dofs_per_cell);
    std::vector<double>                  value(dofs.size()), rate(dofs.size());
    for (const auto &cell :
         discretization.dof_handler().active_cell_iterators())
      {
        if (!cell->is_locally_owned() || discretization.is_gap(cell))
          continue;
        cell->get_dof_indices(dofs);
        for (unsigned int i = 0; i < dofs.size(); ++i)
          {
            value[i] = values(dofs[i]);
            rate[i]  = rates(dofs[i]);
          }
        for (const auto &[points, at] :
             {std::pair(&of_mass, &at_mass), std::pair(&of_rest, &at_rest)})
          {
            points->reinit(cell);
            for (const unsigned int q : points->quadrature_point_indices())
              {
                evaluate_basis(discretization, *points, q, basis);
                Point point{
                  discretization.geometry().weight(*points, q),
                  basis,
                  material,
                  {},
                  discretization.elasticity(cell, points->quadrature_point(q))};
                for (unsigned int i = 0; i < dofs.size(); ++i)
                  {
                    point.theta += value[i] * basis[i].theta;
                    point.rate += rate[i] * basis[i].theta;
                    point.gradient += value[i] * basis[i].grad_theta;
                    point.strain.add(value[i], basis[i].strain);
                    point.strain_rate.add(rate[i], basis[i].strain);
                  }
                point.beyond =
                  discretization.beyond_zero(cell,
                                             points->quadrature_point(q),
                                             point.theta);
                (*at)(point);
              }
          }
        at_cell(cell);
      }
  }



  template <int dim>
  void
  NonlinearBody<dim>::subtract(const Instant &instant,
                               Vector        &heat,
                               Vector        &momentum) const
  {
    AffineConstraints<double> unconstrained;
    unconstrained.close();
    BlockVector            sum = discretization.make_ghosted_vector();
    dealii::Vector<double> part(discretization.finite_element().dofs_per_cell);
    std::vector<types::global_dof_index> dofs(part.size());
    visit(
      instant,
      [&](const Point &at) {
        const double rate = at.weight * at.beyond.value.heat_mass * at.rate;
        for (const unsigned int i : places[Field::temperature])
          part[i] -= rate * at.basis[i].theta;
      },
      [&](const Point &at) {
        const RodCoefficients &beyond = at.beyond.value;
        const Tensor<1, dim> flux = at.weight * beyond.conduction * at.gradient;
        const double         source =
          at.weight * material.heating * beyond.coupling * at.strain_rate.trace;
        const SymmetricTensor<2, 3> stress = at.weight * at.stress(beyond);
        for (const unsigned int i : places[Field::temperature])
          part[i] -= flux * at.basis[i].grad_theta + source * at.basis[i].theta;
        for (const unsigned int i : places[Field::displacement])
          part[i] -= stress * at.basis[i].strain.tensor;
      },
      [&](const auto &cell) {
        cell->get_dof_indices(dofs);
        unconstrained.distribute_local_to_global(part, dofs, sum);
        part = 0.;
      });
    sum.compress(VectorOperation::add);
    for (const auto &[field, target] :
         {std::pair(Field::temperature, &heat),
          std::pair(Field::displacement, &momentum)})
      if (discretization.has_field(field))
        {
          const auto &of_field = sum.block(discretization.ghosted_block(field));
          for (unsigned int i = 0; i < target->locally_owned_size(); ++i)
            target->local_element(i) += of_field.local_element(i);
        }
  }



  template <int dim>
  std::unique_ptr<const typename NonlinearBody<dim>::Operator>
  NonlinearBody<dim>::at(const Vector &temperature) const
  {
    const Vector none;
    return operator_at({temperature, none, none, none}, false);
  }



  template <int dim>
  std::unique_ptr<const typename NonlinearBody<dim>::Operator>
  NonlinearBody<dim>::operator_at(const Instant &instant,
                                  const bool     with_slopes) const
  {
    const unsigned int n = discretization.finite_element().dofs_per_cell;
    FullMatrix<double> mass(n, n), rest(n, n), viscous(n, n);
    using Add = typename FieldMatrices<dim>::AddPart;
    return std::make_unique<const Operator>(
      equations, equations.matrices()->with([&](const Add &add) {
        visit(
          instant,
          [&](const Point &at) {
            const double value = at.weight * at.beyond.value.heat_mass,
                         slope =
                           with_slopes ?
                             at.weight * at.beyond.slope.heat_mass * at.rate :
                             0.;
            for (const unsigned int i : places[Field::temperature])
              for (const unsigned int j : places[Field::temperature])
                {
                  const double product = at.basis[i].theta * at.basis[j].theta;
                  mass(i, j) += value * product;
                  rest(i, j) += slope * product;
                }
          },
          [&](const Point &at) {
            const RodCoefficients &value = at.beyond.value,
                                  slope  = with_slopes ? at.beyond.slope :
                                                         RodCoefficients();
            const double source =
              material.heating * slope.coupling * at.strain_rate.trace;
            // of the stress in the temperature, over -a
            SymmetricTensor<2, 3> thermal =
              value.coupling * unit_symmetric_tensor<3>();
            if (material.has_thermal_stress())
              thermal -= at.stress(slope) / material.thermal_stress;
            for (const unsigned int j : places[Field::temperature])
              {
                const CellBasis<dim> &g = at.basis[j];
                for (const unsigned int i : places[Field::temperature])
                  {
                    const CellBasis<dim> &f = at.basis[i];
                    rest(i, j) +=
                      at.weight *
                      (value.conduction * (f.grad_theta * g.grad_theta) +
                       (slope.conduction * (f.grad_theta * at.gradient) +
                        source * f.theta) *
                         g.theta);
                  }
                for (const unsigned int i : places[Field::displacement])
                  {
                    const Strain &f = at.basis[i].strain;
                    rest(i, j) += at.weight * (thermal * f.tensor) * g.theta;
                    rest(j, i) +=
                      at.weight * value.coupling * f.trace * g.theta;
                  }
              }
            for (const unsigned int j : places[Field::displacement])
              {
                const SymmetricTensor<2, 3> stress =
                  at.weight * elastic_stress(at.elasticity, at.basis[j].strain);
                for (const unsigned int i : places[Field::displacement])
                  {
                    const double product = stress * at.basis[i].strain.tensor;
                    rest(i, j) += value.stiffness * product;
                    viscous(i, j) += value.viscosity * product;
                  }
              }
          },
          [&](const auto &cell) {
            add(FieldMatrix::heat_mass, cell, mass);
            for (const auto kind : {FieldMatrix::conduction,
                                    FieldMatrix::stiffness,
                                    FieldMatrix::divergence,
                                    FieldMatrix::thermal_stress})
              add(kind, cell, rest);
            if (material.has_viscosity())
              add(FieldMatrix::viscous_stiffness, cell, viscous);
            for (FullMatrix<double> *const part : {&mass, &rest, &viscous})
              *part = 0.;
          });
      }));
  }



  template class NonlinearBody<2>;
  template class NonlinearBody<3>;
} // namespace ThermoContact
