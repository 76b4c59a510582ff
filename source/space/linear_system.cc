// SPDX-License-Identifier: LGPL-2.1-or-later

#include <thermocontact/base/exceptions.h>
#include <thermocontact/base/number_text.h>
#include <thermocontact/base/text.h>
#include <thermocontact/base/tolerances.h>
#include <thermocontact/contact/interface_problem.h>
#include <thermocontact/space/cell_products.h>
#include <thermocontact/space/conjugate_gradients.h>
#include <thermocontact/space/linear_system.h>
#include <thermocontact/space/system_matrix.h>

#include <deal.II/base/mpi.h>

#include <deal.II/lac/diagonal_matrix.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace ThermoContact
{
  template <int dim>
  LinearSystem<dim>::LinearSystem(
    const ThermoviscoelasticOperator<dim> &equations,
    const SystemCoefficients              &coefficients,
    const Vector                          *diagonal,
    const Rows                             rows,
    Preconditioner *const                  preconditioner)
    : equations(equations)
    , coefficients(coefficients)
    , rows(rows)
    , scale(std::sqrt(coefficients.thermal_stress / coefficients.heating))
    , preconditioner(preconditioner)
  {
    if (diagonal != nullptr)
      this->diagonal = *diagonal;
    const bool is_direct = has_factors() && rows == Rows::all;
    if (!is_direct && coefficients.conduction == 0. &&
        has(Field::temperature) && has(Field::displacement))
      {
        heat         = std::make_unique<Elimination>();
        heat->system = std::make_unique<const LinearSystem<dim>>(
          equations, coefficients.of(Field::temperature));
        heat->sources     = equations.space().make_vector(Field::temperature);
        heat->temperature = heat->sources;
      }
    if (!has_factors())
      return;
    if (rows == Rows::contact_end)
      invert();
    else if (!equations.is_eliminated_along_rod() || diagonal != nullptr ||
             !factorize_rod())
      factorize_sparse();
    if (dim == 1 && is_direct && diagonal == nullptr && !is_along_rod())
      correction = std::make_unique<Correction>();
  }



  template <int dim>
  LinearSystem<dim>::LinearSystem(
    std::unique_ptr<const ThermoviscoelasticOperator<dim>> own,
    const SystemCoefficients                              &coefficients,
    const Rows                                             rows)
    : LinearSystem(*own, coefficients, nullptr, rows)
  {
    this->own = std::move(own);
  }



  template <int dim>
  bool
  LinearSystem<dim>::factorize_rod()
  {
    const RodMatrices &matrices = *equations.rod();
    const Material    &material = equations.coefficients();
    const auto         block    = [&](const Field::Block field) {
      return rod_block(coefficients, material, field);
    };
    double     growth = 0.;
    const auto held   = [&](const Field::Block field, const unsigned int end) {
      return equations.space().are_ends_held(field)[end];
    };
    if (is_whole())
      {
        const CouplingFactors coupling =
          coupling_factors(coefficients, material);
        const RodFactors<2>::Block heating{
          {coupling.heating, RodMatrices::divergence}};
        const RodFactors<2>::Block stress{
          {coupling.thermal_stress, RodMatrices::thermal_stress}};
        rod_whole = std::make_unique<const RodFactors<2>>(
          matrices,
          RodFactors<2>::Blocks{{{{block(Field::temperature), heating}},
                                 {{stress, block(Field::displacement)}}}},
          RodFactors<2>::Held{
            {held(Field::temperature, 0), held(Field::displacement, 0)}},
          RodFactors<2>::Held{
            {held(Field::temperature, 1), held(Field::displacement, 1)}});
        growth = rod_whole->growth();
      }
    else
      for (const Field::Block field : all_fields)
        if (has(field))
          {
            rod_fields[field] = std::make_unique<const RodFactors<1>>(
              matrices,
              RodFactors<1>::Blocks{{{{block(field)}}}},
              RodFactors<1>::Held{{held(field, 0)}},
              RodFactors<1>::Held{{held(field, 1)}});
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
        const SystemVector prototype = equations.space().make_system_vector();
        whole.reset(new Whole{
          DirectSolver(whole_matrix(equations, coefficients.scaled(scale))),
          prototype,
          prototype});
        return;
      }
    for (const Field::Block field : all_fields)
      if (has(field))
        {
          SparseMatrix matrix = field_matrix(equations, coefficients, field);
          if (diagonal)
            for (const types::global_dof_index dof :
                 diagonal->locally_owned_elements())
              matrix.add(dof, dof, (*diagonal)(dof));
          matrix.compress(VectorOperation::add);
          fields[field] = std::make_unique<DirectSolver>(std::move(matrix));
        }
  }



  template <int dim>
  void
  LinearSystem<dim>::invert()
  {
    const ContactEnd<dim> &end = equations.space().contact_end();
    Vector unit = equations.space().make_vector(own_field()), column(unit);
    inverse = end.all_response_matrix([&](const unsigned int node) -> Vector & {
      std::vector<double> unit_value(end.n_all_nodes(), 0.);
      unit_value[node] = 1.;
      end.set_all_values(own_field(), unit_value, unit);
      product(column, unit);
      return column;
    });
    inverse.gauss_jordan();
  }



  template <int dim>
  const Vector &
  LinearSystem<dim>::row_diagonal() const
  {
    if (matrix_diagonal)
      return *matrix_diagonal;
    const auto [mass, stiffness] =
      mass_and_stiffness(coefficients, equations.coefficients(), own_field());
    if constexpr (dim > 1)
      matrix_diagonal =
        equations.cell_products()->diagonal(own_field(), mass, stiffness);
    if (diagonal)
      *matrix_diagonal += *diagonal;
    return *matrix_diagonal;
  }



  template <int dim>
  void
  LinearSystem<dim>::set_springs(const std::vector<double> &new_springs,
                                 const std::vector<double> &new_relaxed)
  {
    Assert(!has_factors() || new_springs.empty(), ExcNotImplemented());
    springs = new_springs;
    relaxed = new_relaxed;
    if (preconditioner != nullptr)
      preconditioner->set_springs(springs);
  }



  template <int dim>
  void
  LinearSystem<dim>::restrict_rows(Vector &vector) const
  {
    equations.zero_constrained(own_field(), vector);
    if (rows == Rows::all)
      return;
    const auto &entries =
      equations.space().contact_end().all_entries(own_field());
    std::vector<double> kept;
    for (const auto &[node, entry] : entries)
      kept.push_back(vector.begin()[entry]);
    vector = 0.;
    for (unsigned int i = 0; i < kept.size(); ++i)
      vector.begin()[entries[i].second] = kept[i];
  }



  template <int dim>
  void
  LinearSystem<dim>::heat_of_motion(Vector       &temperature,
                                    const Vector &displacement) const
  {
    heat->sources = 0.;
    equations.add_heating(displacement, -coefficients.heating, heat->sources);
    heat->system->solve(temperature, heat->sources);
  }



  template <int dim>
  void
  LinearSystem<dim>::product(Vector &y, const Vector &x) const
  {
    bool is_at_end = false;
    if constexpr (dim > 1)
      if (rows == Rows::contact_end && !has_factors())
        {
          equations.cell_products()->contact_stiffness(y, x);
          y *= mass_and_stiffness(coefficients,
                                  equations.coefficients(),
                                  own_field())
                 .stiffness;
          is_at_end = true;
        }
    if (!is_at_end)
      equations.product(coefficients, own_field(), x, y);
    if (heat)
      {
        heat_of_motion(heat->temperature, x);
        equations.add_thermal_stress(heat->temperature,
                                     -coefficients.thermal_stress,
                                     y);
      }
    if (diagonal)
      for (unsigned int i = 0; i < y.locally_owned_size(); ++i)
        y.local_element(i) += diagonal->local_element(i) * x.local_element(i);
    restrict_rows(y);
  }



  template <int dim>
  void
  LinearSystem<dim>::residual(Vector       &left,
                              const Vector &solution,
                              const Vector &rhs) const
  {
    product(left, solution);
    left.sadd(-1., rhs);
  }



  template <int dim>
  void
  LinearSystem<dim>::vmult(Vector &y, const Vector &x) const
  {
    product(y, x);
    if (!springs.empty())
      for (const auto &[node, entry] :
           equations.space().contact_end().entries(own_field()))
        y.local_element(entry) =
          is_held(node) ?
            0. :
            y.local_element(entry) + springs[node] * x.local_element(entry);
  }



  template <int dim>
  void
  LinearSystem<dim>::solve_by_iterations(const Field::Block field,
                                         Vector            &solution,
                                         const Vector      &rhs,
                                         const double       tolerance) const
  {
    // the rest beside relaxed springs: forces of stiff ones are no measure
    Vector rest(rhs), at_rest(rhs);
    at_rest = 0.;
    if (!springs.empty())
      {
        const auto &entries = equations.space().contact_end().entries(field);
        for (const auto &[node, entry] : entries)
          if (springs[node] > 0.)
            at_rest.local_element(entry) = relaxed[node];
        residual(rest, at_rest, rhs);
        for (const auto &[node, entry] : entries)
          if (is_held(node))
            rest.local_element(entry) = 0.;
      }
    const auto solve = [&](const auto &about_inverse) {
      n_iterations_ += conjugate_gradients(
        rows == Rows::contact_end    ? "the equilibrium of the contact nodes" :
        field == Field::displacement ? "the motion of the body" :
        coefficients.conduction > 0. ? "the temperature" :
                                       "the temperature of a body that is "
                                       "heated at once",
        *this,
        solution,
        rest,
        about_inverse,
        std::max(tolerance, this->tolerance()));
    };
    if (preconditioner != nullptr)
      {
        struct OfField
        {
          const Preconditioner &blocks;
          const Field::Block    field;

          void
          vmult(Vector &z, const Vector &r) const
          {
            blocks.vmult(field, z, r);
          }
        };
        solve(OfField{*preconditioner, field});
      }
    else
      {
        Vector inverse_diagonal(row_diagonal());
        if (!springs.empty())
          for (const auto &[node, entry] :
               equations.space().contact_end().entries(field))
            if (!is_held(node))
              inverse_diagonal.local_element(entry) += springs[node];
        for (double &entry : inverse_diagonal)
          entry = 1. / entry;
        solve(DiagonalMatrix<Vector>(inverse_diagonal));
      }
    solution += at_rest;
  }



  namespace
  {
    constexpr unsigned int max_gmres_iterations = 300;
  } // namespace



  template <int dim>
  void
  LinearSystem<dim>::restart()
  {
    if (!krylov)
      {
        krylov = std::make_unique<Krylov>();
        for (BlockVector *vector :
             {&krylov->left, &krylov->scaled, &krylov->correction})
          vector->reinit(equations.space().make_block_vector());
      }
    krylov->has_left         = false;
    krylov->largest_residual = 0.;
  }



  template <int dim>
  void
  LinearSystem<dim>::set_conductance(const std::vector<double> &new_conductance)
  {
    conductance      = new_conductance;
    krylov->has_left = false;
  }



  template <int dim>
  void
  LinearSystem<dim>::apply(BlockVector &y, const BlockVector &x) const
  {
    equations.product(coefficients,
                      x.block(Field::temperature),
                      x.block(Field::displacement),
                      y.block(Field::temperature),
                      y.block(Field::displacement));
    if (!conductance.empty())
      for (const auto &[node, entry] :
           equations.space().contact_end().entries(Field::temperature))
        y.block(Field::temperature).local_element(entry) +=
          conductance[node] * x.block(Field::temperature).local_element(entry);
  }



  template <int dim>
  const BlockVector &
  LinearSystem<dim>::left(const BlockVector &solution, const BlockVector &rhs)
  {
    if (!krylov->has_left)
      {
        apply(krylov->left, solution);
        krylov->left.sadd(-1., 1., rhs);
        krylov->has_left = true;
      }
    return krylov->left;
  }



  template <int dim>
  double
  LinearSystem<dim>::compute_scaled(const BlockVector &solution,
                                    const BlockVector &rhs,
                                    const Weights     &weights)
  {
    krylov->scaled         = left(solution, rhs);
    Vector       &r        = krylov->scaled.block(Field::displacement);
    const Vector &v        = solution.block(Field::displacement);
    const Vector &w        = weights.weights.block(Field::displacement);
    double        rounding = 0.;
    for (const auto &[node, entry] :
         equations.space().contact_end().entries(Field::displacement))
      if (is_held(node))
        r.local_element(entry) = 0.;
      else if (springs[node] != 0.)
        {
          // the force of the spring beside the body
          r.local_element(entry) -= spring_force(node, v.local_element(entry));
          const double size =
            std::max(std::abs(relaxed[node]), std::abs(v.local_element(entry)));
          rounding += Utilities::fixed_power<2>(w.local_element(entry) *
                                                springs[node] * size);
        }
    krylov->scaled.scale(weights.weights);
    return 4. * std::numeric_limits<double>::epsilon() *
           std::sqrt(Utilities::MPI::sum(rounding, r.get_mpi_communicator()));
  }



  /** The matrix with springs, rows weighted. */
  template <int dim>
  class LinearSystem<dim>::WeightedMatrix
  {
  public:
    /** Both are borrowed. */
    WeightedMatrix(const LinearSystem &system, const Weights &weights)
      : system(system)
      , weights(weights)
    {}

    void
    vmult(BlockVector &y, const BlockVector &x) const
    {
      system.apply(y, x);
      Vector       &y_u = y.block(Field::displacement);
      const Vector &x_u = x.block(Field::displacement);
      for (const auto &[node, entry] :
           system.equations.space().contact_end().entries(Field::displacement))
        if (system.is_held(node))
          y_u.local_element(entry) = x_u.local_element(entry);
        else
          y_u.local_element(entry) +=
            system.springs[node] * x_u.local_element(entry);
      y.scale(weights.weights);
    }

  private:
    const LinearSystem &system;
    const Weights      &weights;
  };



  /** By blocks, the temperature first; rows weighted back. */
  template <int dim>
  class LinearSystem<dim>::WeightedPreconditioner
  {
  public:
    /** @param scratch of the layout of the unknowns; all are borrowed */
    WeightedPreconditioner(const LinearSystem &system,
                           const Weights      &weights,
                           BlockVector        &scratch)
      : system(system)
      , weights(weights)
      , rhs(scratch.block(Field::displacement))
      , heat_rhs(scratch.block(Field::temperature))
    {}

    void
    vmult(BlockVector &z, const BlockVector &r) const
    {
      Vector &z_theta = z.block(Field::temperature);
      if (system.has(Field::temperature))
        {
          weigh_back(Field::temperature, r, heat_rhs);
          system.preconditioner->vmult(Field::temperature, z_theta, heat_rhs);
        }
      if (!system.has(Field::displacement))
        return;
      weigh_back(Field::displacement, r, rhs);
      if (system.has(Field::temperature))
        {
          system.equations.add_thermal_stress(
            z_theta, system.coefficients.thermal_stress, rhs);
          // held rows keep their residual, which is zero
          for (const auto &[node, entry] :
               system.equations.space().contact_end().entries(
                 Field::displacement))
            if (system.is_held(node))
              rhs.local_element(entry) = 0.;
        }
      system.preconditioner->vmult(Field::displacement,
                                   z.block(Field::displacement),
                                   rhs);
    }

  private:
    const LinearSystem &system;
    const Weights      &weights;
    Vector             &rhs;
    Vector             &heat_rhs;

    void
    weigh_back(const Field::Block field, const BlockVector &r, Vector &to) const
    {
      const double *const of_rows = r.block(field).begin();
      const double *const inverse = weights.inverses.block(field).begin();
      double *const       result  = to.begin();
      for (unsigned int i = 0; i < to.locally_owned_size(); ++i)
        result[i] = of_rows[i] * inverse[i];
    }
  };



  template <int dim>
  FlexibleGmres::Result
  LinearSystem<dim>::add_correction(BlockVector   &solution,
                                    const Weights &weights,
                                    const double   tolerance)
  {
    krylov->has_left = false; // its place is used
    const FlexibleGmres::Result result =
      krylov->gmres.solve(WeightedMatrix(*this, weights),
                          WeightedPreconditioner(*this, weights, krylov->left),
                          tolerance,
                          max_gmres_iterations,
                          krylov->scaled,
                          krylov->correction);
    solution += krylov->correction;
    return result;
  }



  template <int dim>
  typename LinearSystem<dim>::Iterations
  LinearSystem<dim>::solve(BlockVector       &solution,
                           const BlockVector &rhs,
                           const Weights     &weights,
                           const double       tolerance,
                           const bool         is_relative)
  {
    Vector &v = solution.block(Field::displacement);
    for (const auto &[node, entry] :
         equations.space().contact_end().entries(Field::displacement))
      if (is_held(node))
        v.local_element(entry) = relaxed[node];
    for (const double spring : springs)
      if (std::isinf(spring))
        krylov->has_left = false; // on all ranks, whoever has the node

    double       rounding = compute_scaled(solution, rhs, weights);
    Iterations   result{0, krylov->scaled.l2_norm()};
    const double allowed =
      is_relative ? tolerance * result.residual : tolerance;
    // velocities that a short stage prescribes have larger terms than all else
    krylov->largest_residual =
      std::max(krylov->largest_residual, result.residual);
    // GMRES estimates its residual, and takes its rounding for progress: the
    // residual is computed, and once more is tried
    for (unsigned int attempt = 0; attempt < 2; ++attempt)
      {
        const FlexibleGmres::Result found =
          add_correction(solution, weights, allowed);
        result.n += found.n_iterations;
        rounding        = compute_scaled(solution, rhs, weights);
        result.residual = krylov->scaled.l2_norm();
        if (result.residual <= 2. * allowed + rounding +
                                 Tolerances::rounding_of_sum *
                                   std::max(1., krylov->largest_residual))
          return result;
        if (found.residual > allowed)
          give_up(result.residual, allowed, result.n);
      }
    if (result.residual > Tolerances::loose_residual)
      give_up(result.residual, allowed, result.n);
    result.is_rounding = true;
    return result;
  }



  template <int dim>
  void
  LinearSystem<dim>::give_up(const double       residual,
                             const double       tolerance,
                             const unsigned int n_iterations) const
  {
    throw ComputationError(
      text("the iterative solver reached a relative residual of ",
           significant(residual, few_digits),
           " instead of ",
           significant(tolerance, few_digits),
           " in ",
           n_iterations,
           " iterations, for a stage of length ",
           significant(coefficients.conduction, few_digits),
           "\n  remedy:  Solver/Linear solver = direct, a larger "
           "Solver/Linear tolerance, cells that are cubes, a larger "
           "Contact/Compliance, or a Model/Poisson ratio farther from 1/2"));
  }



  template <int dim>
  void
  LinearSystem<dim>::solve_field(const Field::Block field,
                                 Vector            &solution,
                                 const Vector      &rhs,
                                 const double       tolerance) const
  {
    if (rod_fields[field])
      rod_fields[field]->solve({{rhs.begin()}}, {{solution.begin()}});
    else if (fields[field])
      fields[field]->solve(solution, rhs);
    else if (has_factors())
      {
        const ContactEnd<dim> &end = equations.space().contact_end();
        std::vector<double>    values;
        end.get_all_values(field, rhs, values);
        solution = 0.;
        end.set_all_values(field,
                           ThermoContact::product(inverse, values),
                           solution);
      }
    else
      solve_by_iterations(field, solution, rhs, tolerance);
  }



  template <int dim>
  void
  LinearSystem<dim>::solve_once(Vector &heat,
                                Vector &momentum,
                                Vector &temperature,
                                Vector &displacement) const
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
        equations.space().join(heat, momentum, whole->rhs);
        whole->factors.solve(whole->solution, whole->rhs);
        equations.space().split(whole->solution, temperature, displacement);
        temperature /= scale;
        // prescribed rates are zero: pivots off the diagonal leave rounding of
        // the largest rates there, which adds up where nothing restores them
        equations.zero_constrained(Field::temperature, temperature);
        equations.zero_constrained(Field::displacement, displacement);
      }
    else
      {
        if (has(Field::temperature))
          solve_field(Field::temperature,
                      temperature,
                      heat,
                      Tolerances::rounding_of_solution);
        if (!has(Field::displacement))
          return;
        if (has(Field::temperature))
          equations.add_thermal_stress(temperature,
                                       coefficients.thermal_stress,
                                       momentum);
        solve_field(Field::displacement,
                    displacement,
                    momentum,
                    Tolerances::rounding_of_solution);
      }
  }



  template <int dim>
  void
  LinearSystem<dim>::solve(Vector &heat,
                           Vector &momentum,
                           Vector &temperature,
                           Vector &displacement) const
  {
    if (!correction)
      {
        solve_once(heat, momentum, temperature, displacement);
        return;
      }
    Correction &c   = *correction;
    c.heat_residual = c.heat = heat;
    c.momentum_residual = c.momentum = momentum;
    solve_once(heat, momentum, temperature, displacement);
    equations.product(
      coefficients, temperature, displacement, c.heat, c.momentum);
    if (has(Field::temperature))
      c.heat_residual -= c.heat;
    if (has(Field::displacement))
      c.momentum_residual -= c.momentum;
    solve_once(c.heat_residual, c.momentum_residual, c.heat, c.momentum);
    if (has(Field::temperature))
      temperature += c.heat;
    if (has(Field::displacement))
      displacement += c.momentum;
  }



  template <int dim>
  void
  LinearSystem<dim>::solve(Vector       &solution,
                           const Vector &rhs,
                           const double  tolerance) const
  {
    if (!rod_whole && !whole)
      return solve_field(own_field(), solution, rhs, tolerance);
    Vector heat = equations.space().make_vector(Field::temperature);
    Vector momentum(rhs), temperature(heat);
    solve(heat, momentum, temperature, solution);
  }



  template class LinearSystem<1>;
  template class LinearSystem<2>;
  template class LinearSystem<3>;
} // namespace ThermoContact
