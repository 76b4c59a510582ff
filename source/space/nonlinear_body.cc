// SPDX-License-Identifier: LGPL-2.1-or-later

#include <thermocontact/base/collective.h>
#include <thermocontact/base/exceptions.h>
#include <thermocontact/space/cell_matrices.h>
#include <thermocontact/space/massless_contact.h>
#include <thermocontact/space/nonlinear_body.h>

#include <deal.II/base/quadrature_lib.h>

#include <deal.II/fe/fe_values.h>

namespace ThermoContact
{
  /** The points of the mass and all others. */
  template <int dim>
  struct NonlinearBody<dim>::Rules
  {
    /** Points of a cell with the basis functions there. */
    struct Rule
    {
      Rule(const Discretization<dim> &discretization,
           const Quadrature<dim>     &quadrature)
        : discretization(discretization)
        , values(discretization.mapping(),
                 discretization.finite_element(),
                 quadrature,
                 update_values | update_gradients | update_quadrature_points |
                   update_JxW_values)
        , basis(quadrature.size(),
                std::vector<CellBasis<dim>>(
                  discretization.finite_element().dofs_per_cell))
      {}

      void
      reinit(const Cell &cell)
      {
        values.reinit(cell);
        if (has_last_integrals(discretization, values))
          return;
        for (unsigned int q = 0; q < basis.size(); ++q)
          evaluate_basis(discretization, values, q, basis[q]);
      }

      const Discretization<dim>               &discretization;
      FEValues<dim>                            values;
      std::vector<std::vector<CellBasis<dim>>> basis;
    };

    Rules(const Discretization<dim> &discretization, const bool has_lumped_mass)
      : mass(discretization,
             mass_quadrature<dim>(discretization.degree(), has_lumped_mass))
      , rest(discretization, QGauss<dim>(discretization.degree() + 1))
    {}

    Rule mass, rest;
  };



  template <int dim>
  struct NonlinearBody<dim>::Point
  {
    double                             weight;
    const std::vector<CellBasis<dim>> &basis;
    const Material                    &material;
    const Elasticity                  &elasticity;
    EquationTangents                   beyond{};

    double         theta = 0., rate = 0.;
    Tensor<1, dim> gradient{};
    Strain         strain{}, strain_rate{};

    SymmetricTensor<2, 3>
    stress(const EquationFactors &coefficients) const
    {
      return stress_of(material,
                       coefficients,
                       theta * unit_symmetric_tensor<3>(),
                       elastic_stress(elasticity, strain),
                       elastic_stress(elasticity, strain_rate));
    }
  };



  template <int dim>
  NonlinearBody<dim>::NonlinearBody(const Scene    &scene,
                                    const Operator &equations)
    : fields(scene.fields)
    , material(scene.material)
    , equations(equations)
    , discretization(equations.space())
    , rules(std::make_unique<Rules>(discretization, scene.has_lumped_mass))
  {
    const auto &fe = discretization.finite_element();
    for (unsigned int i = 0; i < fe.dofs_per_cell; ++i)
      places[fields.has_temperature &&
                 fe.system_to_component_index(i).first == 0 ?
               Field::temperature :
               Field::displacement]
        .push_back(i);
    for_each_cell([&](const Cell &cell) {
      for (typename Rules::Rule *const rule : {&rules->mass, &rules->rest})
        {
          rule->reinit(cell);
          for (const auto &place : rule->values.get_quadrature_points())
            {
              const auto inside  = discretization.inside(cell, place);
              const auto at_zero = discretization.of_material(cell, place);
              known.push_back({inside,
                               discretization.material()->values(inside),
                               at_zero,
                               elasticity_of(at_zero.poisson_ratio)});
            }
        }
    });
  }



  template <int dim>
  NonlinearBody<dim>::~NonlinearBody() = default;



  template <int dim>
  void
  NonlinearBody<dim>::for_each_cell(const AtCell &action) const
  {
    for (const auto &cell :
         discretization.dof_handler().active_cell_iterators())
      if (cell->is_locally_owned() && !discretization.is_gap(cell))
        action(cell);
  }



  template <int dim>
  void
  NonlinearBody<dim>::visit(const State   &state,
                            const Rates   &rates,
                            const AtPoint &at_mass,
                            const AtPoint &at_rest,
                            const AtCell  &at_cell) const
  {
    const BlockVector values = discretization.with_ghosts(state.temperature,
                                                          state.displacement),
                      rate_values =
                        discretization.with_ghosts(rates.temperature_rate,
                                                   rates.velocity);
    const unsigned int n = discretization.finite_element().dofs_per_cell;
    std::vector<types::global_dof_index> dofs(n);
    std::vector<double>                  value(n), rate(n);
    auto                                 next = known.begin();
    CollectedErrors<InputError>          errors;
    for_each_cell([&](const Cell &cell) {
      cell->get_dof_indices(dofs);
      for (unsigned int i = 0; i < n; ++i)
        {
          value[i] = values(dofs[i]);
          rate[i]  = rate_values(dofs[i]);
        }
      for (const auto &[rule, at] : {std::pair(&rules->mass, &at_mass),
                                     std::pair(&rules->rest, &at_rest)})
        {
          rule->reinit(cell);
          for (unsigned int q = 0; q < rule->basis.size(); ++q, ++next)
            {
              Point point{discretization.geometry().weight(rule->values, q),
                          rule->basis[q],
                          material,
                          next->elasticity};
              for (unsigned int i = 0; i < n; ++i)
                {
                  const CellBasis<dim> &f = point.basis[i];
                  point.theta += value[i] * f.theta;
                  point.rate += rate[i] * f.theta;
                  point.gradient += value[i] * f.grad_theta;
                  point.strain.add(value[i], f.strain);
                  point.strain_rate.add(rate[i], f.strain);
                }
              errors.collect([&]() {
                point.beyond =
                  discretization.material()->tangents(next->place,
                                                      point.theta,
                                                      &next->values);
                point.beyond.value -= next->at_zero;
              });
              (*at)(point);
            }
        }
      at_cell(cell);
    });
    errors.throw_on_all_ranks(discretization.communicator());
  }



  template <int dim>
  void
  NonlinearBody<dim>::add_mass_residual(const Point            &at,
                                        dealii::Vector<double> &residual) const
  {
    const double rate = at.weight * at.beyond.value.heat_mass * at.rate;
    for (const unsigned int i : places[Field::temperature])
      residual[i] += rate * at.basis[i].theta;
  }



  template <int dim>
  void
  NonlinearBody<dim>::add_residual(const Point            &at,
                                   dealii::Vector<double> &residual) const
  {
    const EquationFactors &beyond = at.beyond.value;
    const Tensor<1, dim>   flux   = at.weight * beyond.conduction * at.gradient;
    const double           source =
      at.weight * material.heating * beyond.coupling * at.strain_rate.trace;
    const SymmetricTensor<2, 3> stress = at.weight * at.stress(beyond);
    for (const unsigned int i : places[Field::temperature])
      residual[i] += flux * at.basis[i].grad_theta + source * at.basis[i].theta;
    for (const unsigned int i : places[Field::displacement])
      residual[i] += stress * at.basis[i].strain.tensor;
  }



  template <int dim>
  class NonlinearBody<dim>::Residual
  {
  public:
    explicit Residual(const Discretization<dim> &discretization)
      : of_cell(discretization.finite_element().dofs_per_cell)
      , discretization(discretization)
      , sum(discretization.make_ghosted_vector())
      , dofs(of_cell.size())
    {
      unconstrained.close();
    }

    dealii::Vector<double> of_cell;

    /** Takes what is of the cell, which becomes zero. */
    void
    take(const Cell &cell)
    {
      cell->get_dof_indices(dofs);
      unconstrained.distribute_local_to_global(of_cell, dofs, sum);
      of_cell = 0.;
    }

    void
    subtract_from(Vector &heat, Vector &momentum)
    {
      sum.compress(VectorOperation::add);
      for (const auto &[field, target] :
           {std::pair(Field::temperature, &heat),
            std::pair(Field::displacement, &momentum)})
        if (discretization.has_field(field))
          {
            const auto &part = sum.block(discretization.ghosted_block(field));
            for (unsigned int i = 0; i < target->locally_owned_size(); ++i)
              target->local_element(i) -= part.local_element(i);
          }
    }

  private:
    const Discretization<dim>           &discretization;
    BlockVector                          sum;
    std::vector<types::global_dof_index> dofs;
    AffineConstraints<double>            unconstrained;
  };



  template <int dim>
  void
  NonlinearBody<dim>::subtract(const State &state,
                               const Rates &rates,
                               Vector      &heat,
                               Vector      &momentum) const
  {
    Residual residual(discretization);
    visit(
      state,
      rates,
      [&](const Point &at) { add_mass_residual(at, residual.of_cell); },
      [&](const Point &at) { add_residual(at, residual.of_cell); },
      [&](const Cell &cell) { residual.take(cell); });
    residual.subtract_from(heat, momentum);
  }



  template <int dim>
  std::unique_ptr<const typename NonlinearBody<dim>::Operator>
  NonlinearBody<dim>::linearize(const State &state,
                                const Rates &rates,
                                Vector      &heat,
                                Vector      &momentum) const
  {
    Residual residual(discretization);
    auto     tangents = operator_at(state, rates, true, &residual);
    residual.subtract_from(heat, momentum);
    return tangents;
  }



  template <int dim>
  std::unique_ptr<const typename NonlinearBody<dim>::Operator>
  NonlinearBody<dim>::at(const Vector &temperature) const
  {
    State state;
    state.temperature = temperature;
    return operator_at(state, Rates(), false, nullptr);
  }



  template <int dim>
  std::unique_ptr<const typename NonlinearBody<dim>::Operator>
  NonlinearBody<dim>::operator_at(const State    &state,
                                  const Rates    &rates,
                                  const bool      with_slopes,
                                  Residual *const residual) const
  {
    const unsigned int n = discretization.finite_element().dofs_per_cell;
    FullMatrix<double> mass(n, n), rest(n, n), viscous(n, n);
    const auto         at_mass = [&](const Point &at) {
      if (residual != nullptr)
        add_mass_residual(at, residual->of_cell);
      const double value = at.weight * at.beyond.value.heat_mass,
                   slope = with_slopes ?
                                     at.weight * at.beyond.slope.heat_mass * at.rate :
                                     0.;
      for (const unsigned int i : places[Field::temperature])
        for (const unsigned int j : places[Field::temperature])
          {
            const double product = at.basis[i].theta * at.basis[j].theta;
            mass(i, j) += value * product;
            rest(i, j) += slope * product;
          }
    };
    const auto at_rest = [&](const Point &at) {
      if (residual != nullptr)
        add_residual(at, residual->of_cell);
      const EquationFactors &value = at.beyond.value,
                            slope =
                              with_slopes ? at.beyond.slope : EquationFactors();
      const double source =
        material.heating * slope.coupling * at.strain_rate.trace;
      // derivative of the stress in the temperature, over -a
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
                at.weight * (value.conduction * (f.grad_theta * g.grad_theta) +
                             (slope.conduction * (f.grad_theta * at.gradient) +
                              source * f.theta) *
                               g.theta);
            }
          for (const unsigned int i : places[Field::displacement])
            {
              const Strain &f = at.basis[i].strain;
              rest(i, j) += at.weight * (thermal * f.tensor) * g.theta;
              rest(j, i) += at.weight * value.coupling * f.trace * g.theta;
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
    };
    using Add = typename FieldMatrices<dim>::AddPart;
    return std::make_unique<const Operator>(
      equations, equations.matrices()->with([&](const Add &add) {
        visit(state, rates, at_mass, at_rest, [&](const Cell &cell) {
          if (residual != nullptr)
            residual->take(cell);
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
