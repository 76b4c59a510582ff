// SPDX-License-Identifier: LGPL-2.1-or-later

#include <thermocontact/space/cell_products.h>
#include <thermocontact/space/field_maps.h>
#include <thermocontact/space/thermoviscoelastic_operator.h>

#include <utility>

namespace ThermoContact
{
  template <int dim>
  ThermoviscoelasticOperator<dim>::ThermoviscoelasticOperator(
    const Scene               &scene,
    const Discretization<dim> &discretization,
    const FieldMatrices<dim>  *matrices)
    : discretization(discretization)
    , material(scene.material)
    , is_along_rod(scene.linear_solver.is_along_rod)
    , matrices_(matrices)
    , cell_products_(matrices == nullptr ?
                       make_cell_products(scene, discretization) :
                       nullptr)
    , heat_scratch(discretization.make_vector(Field::temperature))
    , momentum_scratch(discretization.make_vector(Field::displacement))
  {
    FieldMaps &maps = *this;
    if (matrices != nullptr)
      maps = FieldMaps(*matrices, matrices->rod());
    else if constexpr (dim > 1)
      maps = FieldMaps(*cell_products_);
  }



  template <int dim>
  ThermoviscoelasticOperator<dim>::ThermoviscoelasticOperator(
    const ThermoviscoelasticOperator  &other,
    std::unique_ptr<const RodMatrices> rod)
    : discretization(other.discretization)
    , material(other.material)
    , is_along_rod(other.is_along_rod)
    , matrices_(other.matrices_)
    , own_rod(std::move(rod))
    , heat_scratch(discretization.make_vector(Field::temperature))
    , momentum_scratch(discretization.make_vector(Field::displacement))
  {
    FieldMaps &maps = *this;
    maps            = FieldMaps(*matrices_, own_rod.get());
  }



  template <int dim>
  ThermoviscoelasticOperator<dim>::ThermoviscoelasticOperator(
    const ThermoviscoelasticOperator         &other,
    std::unique_ptr<const FieldMatrices<dim>> matrices)
    : discretization(other.discretization)
    , material(other.material)
    , is_along_rod(other.is_along_rod)
    , own_matrices(std::move(matrices))
    , matrices_(own_matrices.get())
    , heat_scratch(discretization.make_vector(Field::temperature))
    , momentum_scratch(discretization.make_vector(Field::displacement))
  {
    FieldMaps &maps = *this;
    maps            = FieldMaps(*matrices_, nullptr);
  }



  template <int dim>
  ThermoviscoelasticOperator<dim>::~ThermoviscoelasticOperator() = default;



  template <int dim>
  void
  ThermoviscoelasticOperator<dim>::set_sum(const std::array<Term, 3> &terms,
                                           const double               factor,
                                           const Vector              *base,
                                           const Field::Block         field,
                                           Vector                    &y) const
  {
    if (rod() != nullptr)
      {
        std::array<RodMatrices::Term, 3> present{};
        unsigned int                     n = 0;
        for (const Term &term : terms)
          if (term.factor != 0.)
            present[n++] = {term.factor, term.map->of_rod, term.x->begin()};
        const RodMatrices  &products = *rod();
        const double *const b = base != nullptr ? base->begin() : nullptr;
        if (n == 1)
          products.combine<1>({{present[0]}}, factor, b, y.begin());
        else if (n == 2)
          products.combine<2>({{present[0], present[1]}}, factor, b, y.begin());
        else if (n == 3)
          products.combine<3>(present, factor, b, y.begin());
        if (n > 0)
          return;
      }
    if (base != nullptr)
      y.equ(factor, *base);
    else
      y = 0.;
    for (const Term &term : terms)
      if (term.factor != 0.)
        term.map->add(term.factor,
                      *term.x,
                      y,
                      field == Field::temperature ? heat_scratch :
                                                    momentum_scratch);
  }



  template <int dim>
  void
  ThermoviscoelasticOperator<dim>::product(
    const SystemCoefficients &coefficients,
    const Field::Block        field,
    const Vector             &x,
    Vector                   &y) const
  {
    const BlockTerms terms   = block_terms(coefficients, material, field);
    const bool       is_heat = field == Field::temperature;
    if constexpr (dim > 1)
      if (cell_products_ != nullptr)
        {
          const auto [mass, stiffness] =
            mass_and_stiffness(coefficients, material, field);
          cell_products_->vmult(field, mass, stiffness, y, x);
          if (!is_heat && terms[1].first != 0.)
            cell_products_->add_contact_viscosity(terms[1].first, y, x);
        }
    if (matrices_ != nullptr)
      set_sum({{{terms[0].first, is_heat ? &heat_mass : &momentum_mass, &x},
                {terms[1].first, &viscous_stiffness, &x},
                {terms[2].first, is_heat ? &conduction : &stiffness, &x}}},
              0.,
              nullptr,
              field,
              y);
    zero_constrained(field, y);
  }



  template <int dim>
  void
  ThermoviscoelasticOperator<dim>::product(
    const SystemCoefficients &coefficients,
    const Vector             &temperature,
    const Vector             &displacement,
    Vector                   &heat,
    Vector                   &momentum) const
  {
    const auto has = [&](const Field::Block field) {
      return coefficients.has(field) && discretization.has_field(field);
    };
    if (has(Field::temperature))
      {
        product(coefficients, Field::temperature, temperature, heat);
        if (coefficients.heating != 0.)
          add_heating(displacement, coefficients.heating, heat);
      }
    if (!has(Field::displacement))
      return;
    product(coefficients, Field::displacement, displacement, momentum);
    if (has(Field::temperature))
      add_thermal_stress(temperature, -coefficients.thermal_stress, momentum);
  }



  template <int dim>
  void
  ThermoviscoelasticOperator<dim>::stage_rhs(const State  &known,
                                             const double  tau,
                                             const Vector &heat_load,
                                             const Vector &momentum_load,
                                             Vector       &heat,
                                             Vector       &momentum) const
  {
    if (discretization.has_field(Field::temperature))
      {
        set_sum({{{-1., &conduction, &known.temperature}}},
                1.,
                &heat_load,
                Field::temperature,
                heat);
        zero_constrained(Field::temperature, heat);
      }
    if (!discretization.has_field(Field::displacement))
      return;
    set_sum(
      {{{-tau, &stiffness, &known.displacement},
        {material.inertia, &momentum_mass, &known.velocity},
        {tau * material.thermal_stress, &thermal_stress, &known.temperature}}},
      tau,
      &momentum_load,
      Field::displacement,
      momentum);
    zero_constrained(Field::displacement, momentum);
  }



  template <int dim>
  void
  ThermoviscoelasticOperator<dim>::momentum_residual(
    const State  &state,
    const Vector *velocity,
    const Vector *acceleration,
    const Vector &momentum_load,
    Vector       &residual) const
  {
    set_sum({{{-1., &stiffness, &state.displacement},
              {material.thermal_stress, &thermal_stress, &state.temperature},
              {velocity != nullptr ? -material.viscous_factor() : 0.,
               &viscous_stiffness,
               velocity}}},
            1.,
            &momentum_load,
            Field::displacement,
            residual);
    if (acceleration != nullptr && material.has_inertia())
      momentum_mass.add(-material.inertia,
                        *acceleration,
                        residual,
                        momentum_scratch);
  }



  template <int dim>
  void
  ThermoviscoelasticOperator<dim>::heat_residual(const State  &state,
                                                 const Vector &temperature_rate,
                                                 const Vector &heat_load,
                                                 Vector       &residual) const
  {
    set_sum({{{1., &heat_mass, &temperature_rate},
              {1., &conduction, &state.temperature},
              {material.heating, &divergence, &state.velocity}}},
            -1.,
            &heat_load,
            Field::temperature,
            residual);
  }



  template <int dim>
  void
  ThermoviscoelasticOperator<dim>::add_heating(const Vector &velocity,
                                               const double  factor,
                                               Vector       &heat) const
  {
    if (!material.has_heating())
      return;
    divergence.add(factor * material.heating, velocity, heat, heat_scratch);
    zero_constrained(Field::temperature, heat);
  }



  template <int dim>
  void
  ThermoviscoelasticOperator<dim>::add_thermal_stress(const Vector &temperature,
                                                      const double  factor,
                                                      Vector &momentum) const
  {
    if (!material.has_thermal_stress())
      return;
    thermal_stress.add(factor * material.thermal_stress,
                       temperature,
                       momentum,
                       momentum_scratch);
    zero_constrained(Field::displacement, momentum);
  }



  template <int dim>
  void
  ThermoviscoelasticOperator<dim>::zero_constrained(const Field::Block field,
                                                    Vector &vector) const
  {
    for (const unsigned int entry : discretization.constrained_entries(field))
      vector.begin()[entry] = 0.;
  }



  template class ThermoviscoelasticOperator<1>;
  template class ThermoviscoelasticOperator<2>;
  template class ThermoviscoelasticOperator<3>;
} // namespace ThermoContact
