// SPDX-License-Identifier: LGPL-2.1-or-later

#include <thermocontact/base/tolerances.h>
#include <thermocontact/space/cell_products.h>
#include <thermocontact/space/conjugate_gradients.h>
#include <thermocontact/space/linear_system.h>
#include <thermocontact/space/system_matrix.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace ThermoContact
{
  template <int dim>
  LinearSystem<dim>::LinearSystem(
    const ThermoviscoelasticOperator<dim> &equations,
    const SystemCoefficients              &coefficients,
    const Vector                          *diagonal,
    const Rows                             rows)
    : equations(equations)
    , coefficients(coefficients)
    , rows(rows)
    , scale(std::sqrt(coefficients.thermal_stress / coefficients.heating))
  {
    if (diagonal != nullptr)
      this->diagonal = *diagonal;
    if (equations.cell_products() != nullptr)
      set_inverse_diagonal();
    else if (!equations.is_eliminated_along_rod() || diagonal != nullptr ||
             !factorize_rod())
      factorize_sparse();
    is_corrected = dim == 1 && diagonal == nullptr && !is_along_rod();
  }



  template <int dim>
  bool
  LinearSystem<dim>::factorize_rod()
  {
    const RodMatrices &matrices = *equations.rod();
    const Material    &material = equations.coefficients();
    const auto         block    = [&](const Field::Block field) {
      const BlockTerms terms = block_terms(coefficients, material, field);
      return RodFactors<1>::Block(terms.begin(), terms.end());
    };
    double     growth  = 0.;
    const auto is_held = [&](const Field::Block field) {
      return !equations.space().constrained_entries(field).empty();
    };
    if (is_whole())
      {
        const RodFactors<2>::Block heating{
          {coefficients.heating * material.heating, RodMatrices::divergence}};
        const RodFactors<2>::Block stress{
          {-coefficients.thermal_stress * material.thermal_stress,
           RodMatrices::thermal_stress}};
        rod_whole = std::make_unique<const RodFactors<2>>(
          matrices,
          RodFactors<2>::Blocks{{{{block(Field::temperature), heating}},
                                 {{stress, block(Field::displacement)}}}},
          RodFactors<2>::Held{
            {is_held(Field::temperature), is_held(Field::displacement)}});
        growth = rod_whole->growth();
      }
    else
      for (const Field::Block field : all_fields)
        if (has(field))
          {
            rod_fields[field] = std::make_unique<const RodFactors<1>>(
              matrices,
              RodFactors<1>::Blocks{{{{block(field)}}}},
              RodFactors<1>::Held{{is_held(field)}});
            growth = std::max(growth, rod_fields[field]->growth());
          }
    if (growth <= Tolerances::tolerated_cancellation)
      return true;
    refused_growth_ = growth;
    rod_whole.reset();
    rod_fields = {};
    return false;
  }



  template <int dim>
  void
  LinearSystem<dim>::factorize_sparse()
  {
    if (is_whole())
      {
        whole = std::make_unique<DirectSolver>(
          whole_matrix(equations, coefficients, scale));
        system_rhs      = equations.space().make_system_vector();
        system_solution = system_rhs;
        return;
      }
    for (const Field::Block field : all_fields)
      if (has(field))
        {
          SparseMatrix matrix = field_matrix(equations, coefficients, field);
          for (const types::global_dof_index dof :
               diagonal.locally_owned_elements())
            matrix.add(dof, dof, diagonal(dof));
          matrix.compress(VectorOperation::add);
          fields[field] = std::make_unique<DirectSolver>(std::move(matrix));
        }
  }



  template <int dim>
  void
  LinearSystem<dim>::set_inverse_diagonal()
  {
    Assert(!(has(Field::temperature) && has(Field::displacement)),
           ExcNotImplemented());
    const auto [mass, stiffness] =
      mass_and_stiffness(coefficients, equations.coefficients(), own_field());
    if constexpr (dim > 1)
      inverse_diagonal =
        equations.cell_products()->diagonal(own_field(), mass, stiffness);
    if (diagonal.size() > 0)
      inverse_diagonal += diagonal;
    for (double &entry : inverse_diagonal)
      entry = 1. / entry;
  }



  template <int dim>
  void
  LinearSystem<dim>::vmult(Vector &y, const Vector &x) const
  {
    equations.product(coefficients, own_field(), x, y);
    if (diagonal.size() > 0)
      for (unsigned int i = 0; i < y.locally_owned_size(); ++i)
        y.local_element(i) += diagonal.local_element(i) * x.local_element(i);
    equations.zero_constrained(own_field(), y);
    if (rows == Rows::off_contact)
      for (const auto &[node, entry] :
           equations.space().contact_end().entries(own_field()))
        y.local_element(entry) = 0.;
  }



  template <int dim>
  void
  LinearSystem<dim>::solve_field(const Field::Block field,
                                 Vector            &solution,
                                 const Vector      &rhs) const
  {
    constexpr unsigned int max_iterations = 100000;
    if (rod_fields[field])
      rod_fields[field]->solve({{rhs.begin()}}, {{solution.begin()}});
    else if (fields[field])
      fields[field]->solve(solution, rhs);
    else
      conjugate_gradients(field == Field::displacement ?
                            "velocities or accelerations of the body" :
                          coefficients.conduction > 0. ?
                            "the steady profile" :
                            "the temperature of a body that is heated at once",
                          *this,
                          solution,
                          rhs,
                          inverse_diagonal,
                          Tolerances::rounding_of_solution,
                          max_iterations);
  }



  template <int dim>
  void
  LinearSystem<dim>::solve_once(Vector &heat,
                                Vector &momentum,
                                Vector &temperature,
                                Vector &displacement)
  {
    if (rod_whole)
      rod_whole->solve({{heat.begin(), momentum.begin()}},
                       {{temperature.begin(), displacement.begin()}});
    else if (whole)
      {
        // The unknowns of the whole matrix are tau theta' and v: pivots that
        // mix rows would otherwise lose v beside the large theta' of short
        // steps.
        heat *= scale;
        equations.space().join(heat, momentum, system_rhs);
        whole->solve(system_solution, system_rhs);
        equations.space().split(system_solution, temperature, displacement);
        temperature /= scale;
        // prescribed rates are zero: pivots off the diagonal leave rounding of
        // the largest rates there, which adds up where nothing restores them
        equations.zero_constrained(Field::temperature, temperature);
        equations.zero_constrained(Field::displacement, displacement);
      }
    else
      {
        if (has(Field::temperature))
          solve_field(Field::temperature, temperature, heat);
        if (!has(Field::displacement))
          return;
        if (has(Field::temperature))
          equations.add_thermal_stress(temperature,
                                       coefficients.thermal_stress,
                                       momentum);
        solve_field(Field::displacement, displacement, momentum);
      }
  }



  template <int dim>
  void
  LinearSystem<dim>::solve(Vector &heat,
                           Vector &momentum,
                           Vector &temperature,
                           Vector &displacement)
  {
    if (!is_corrected)
      {
        solve_once(heat, momentum, temperature, displacement);
        return;
      }
    heat_residual = heat_correction = heat;
    momentum_residual = momentum_correction = momentum;
    solve_once(heat, momentum, temperature, displacement);
    equations.product(coefficients,
                      temperature,
                      displacement,
                      heat_correction,
                      momentum_correction);
    if (has(Field::temperature))
      heat_residual -= heat_correction;
    if (has(Field::displacement))
      momentum_residual -= momentum_correction;
    solve_once(heat_residual,
               momentum_residual,
               heat_correction,
               momentum_correction);
    if (has(Field::temperature))
      temperature += heat_correction;
    if (has(Field::displacement))
      displacement += momentum_correction;
  }



  template class LinearSystem<1>;
  template class LinearSystem<2>;
  template class LinearSystem<3>;
} // namespace ThermoContact
