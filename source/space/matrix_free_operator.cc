// SPDX-License-Identifier: LGPL-2.1-or-later

#include <thermocontact/space/matrix_free_operator.h>

#include <deal.II/matrix_free/tools.h>

#include <algorithm>

namespace ThermoContact
{
  namespace
  {
    constexpr auto on_all = [](const unsigned int) { return true; };
  } // namespace



  template <int dim>
  MatrixFreeOperator<dim>::MatrixFreeOperator(
    const Scene               &scene,
    const Discretization<dim> &discretization)
    : discretization(discretization)
    , geometry(discretization.geometry())
    , has_uniform_weight(geometry.has_uniform_weight())
    , material(scene.material)
    , spaces(discretization.matrix_free())
    , has_lumped_mass(scene.has_lumped_mass)
    , contact_cells(scene, discretization)
    , input(dim * Utilities::fixed_power<dim>(discretization.degree() + 1))
  {}



  template <int dim>
  template <int n_components>
  void
  MatrixFreeOperator<dim>::add_lumped_mass(const unsigned int      batch,
                                           const Field::Block      field,
                                           const MassOfComponents &factors,
                                           const VectorizedArray<double> *x,
                                           VectorizedArray<double> *y) const
  {
    FEEvaluation<dim, -1, 0, n_components, double> values(
      spaces.cells(), spaces.index(field), MatrixFreeSpaces<dim>::nodes);
    values.reinit(batch);
    values.evaluate(x, EvaluationFlags::values);
    for (unsigned int q = 0; q < values.n_q_points; ++q)
      {
        auto mass = weight(values, q) * values.get_value(q);
        if constexpr (n_components == 1)
          mass *= factors[0];
        else
          for (unsigned int d = 0; d < n_components; ++d)
            mass[d] *= factors[d > 0];
        values.submit_value(mass, q);
      }
    values.integrate(EvaluationFlags::values, y, true);
  }



  template <int dim>
  void
  MatrixFreeOperator<dim>::heat_on_cell(const HeatFactors &factors,
                                        Scalar            &theta) const
  {
    const unsigned int       batch  = theta.get_current_cell_index();
    VectorizedArray<double> *values = theta.begin_dof_values();
    const unsigned int       n      = theta.dofs_per_cell;
    std::copy(values, values + n, input.begin());

    const bool has_bulk_mass = !has_lumped_mass && factors.mass != 0.;
    theta.evaluate(input.begin(),
                   EvaluationFlags::values | EvaluationFlags::gradients);
    for (unsigned int q = 0; q < theta.n_q_points; ++q)
      {
        const VectorizedArray<double> w =
          factors.is_laplacian ? 1. : weight(theta, q);
        theta.submit_value((has_bulk_mass ? factors.mass : 0.) * w *
                             theta.get_value(q),
                           q);
        theta.submit_gradient(factors.conduction * w * theta.get_gradient(q),
                              q);
      }
    theta.integrate(EvaluationFlags::values | EvaluationFlags::gradients,
                    values);
    if (has_lumped_mass && factors.mass != 0.)
      add_lumped_mass<1>(batch,
                         Field::temperature,
                         {{factors.mass, factors.mass}},
                         input.begin(),
                         values);
    if (!factors.is_laplacian)
      contact_cells.add_heat_exchange(batch,
                                      factors.conduction,
                                      input.begin(),
                                      values);
  }



  template <int dim>
  void
  MatrixFreeOperator<dim>::integrate_momentum(const MomentumFactors  &factors,
                                              const MassOfComponents &mass,
                                              const VectorizedArray<double> *x,
                                              Vectorial &u) const
  {
    const bool has_hoop =
      dim == 2 && !has_uniform_weight && factors.laplacian == 0.;
    const bool needs_values =
      mass[1][0] != 0. || has_hoop; // all lanes have the same
    const EvaluationFlags::EvaluationFlags flags =
      needs_values ? EvaluationFlags::values | EvaluationFlags::gradients :
                     EvaluationFlags::gradients;
    const VectorizedArray<double> mu =
      0.5 * factors.stiffness * material.two_mu;
    const VectorizedArray<double> lambda = factors.stiffness * material.lambda;
    u.evaluate(x, flags);
    for (unsigned int q = 0; q < u.n_q_points; ++q)
      {
        Tensor<2, dim, VectorizedArray<double>> gradient = u.get_gradient(q);
        if (factors.laplacian != 0.)
          {
            u.submit_gradient(gradient * factors.laplacian, q);
            continue;
          }
        VectorizedArray<double> dilatation = trace(gradient);
        if (needs_values)
          {
            Tensor<1, dim, VectorizedArray<double>> force = u.get_value(q);
            VectorizedArray<double>                 hoop_stress = 0.;
            if (has_hoop)
              {
                const VectorizedArray<double> c      = hoop(u, q);
                const VectorizedArray<double> strain = c * force[dim - 1];
                dilatation += strain;
                hoop_stress = c * (2. * mu * strain + lambda * dilatation);
              }
            for (unsigned int d = 0; d < dim; ++d)
              force[d] *= mass[d > 0];
            force[dim - 1] += hoop_stress;
            u.submit_value(has_uniform_weight ? force : force * weight(u, q),
                           q);
          }

        // the stress, in place of the gradient
        for (unsigned int d = 0; d < dim; ++d)
          {
            gradient[d][d] = 2. * mu * gradient[d][d] + lambda * dilatation;
            for (unsigned int e = d + 1; e < dim; ++e)
              gradient[d][e] = gradient[e][d] =
                mu * (gradient[d][e] + gradient[e][d]);
          }
        if (!has_uniform_weight)
          gradient *= weight(u, q);
        u.submit_gradient(gradient, q);
      }
    u.integrate(flags, u.begin_dof_values());
  }



  template <int dim>
  void
  MatrixFreeOperator<dim>::momentum_on_cell(const MomentumFactors &factors,
                                            Vectorial             &u) const
  {
    const unsigned int       batch     = u.get_current_cell_index();
    const bool               is_at_end = contact_cells.contain(batch);
    VectorizedArray<double> *values    = u.begin_dof_values();
    const unsigned int       n         = u.dofs_per_cell;
    std::copy(values, values + n, input.begin());

    MassOfComponents mass{{factors.mass, factors.mass}};
    if (is_at_end)
      mass[0] *= contact_cells.share_of_axial_mass(batch);
    integrate_momentum(factors,
                       has_lumped_mass ? MassOfComponents{{0., 0.}} : mass,
                       input.begin(),
                       u);
    if (has_lumped_mass && factors.mass != 0.)
      add_lumped_mass<dim>(
        batch, Field::displacement, mass, input.begin(), values);
    if (is_at_end && factors.mass != 0.)
      contact_cells.add_axial_mass(batch, factors.mass, input.begin(), values);
  }



  template <int dim>
  template <typename Evaluation, typename Acts, typename OnCell>
  void
  MatrixFreeOperator<dim>::apply(const Field::Block field,
                                 Vector            &y,
                                 const Vector      &x,
                                 const Acts        &acts_on,
                                 const OnCell      &on_cell) const
  {
    spaces.cells().template cell_loop<Vector, Vector>(
      [&](
        const auto &cells, Vector &dst, const Vector &src, const auto &range) {
        Evaluation values(cells, spaces.index(field));
        for (unsigned int batch = range.first; batch < range.second; ++batch)
          if (acts_on(batch))
            {
              values.reinit(batch);
              values.read_dof_values(src);
              on_cell(values);
              values.distribute_local_to_global(dst);
            }
      },
      y,
      x,
      true);
  }



  template <int dim>
  void
  MatrixFreeOperator<dim>::heat(const HeatFactors &factors,
                                Vector            &y,
                                const Vector      &x) const
  {
    apply<Scalar>(Field::temperature, y, x, on_all, [&](Scalar &theta) {
      heat_on_cell(factors, theta);
    });
  }



  template <int dim>
  void
  MatrixFreeOperator<dim>::momentum(const MomentumFactors &factors,
                                    Vector                &y,
                                    const Vector          &x) const
  {
    apply<Vectorial>(Field::displacement, y, x, on_all, [&](Vectorial &u) {
      momentum_on_cell(factors, u);
    });
  }



  template <int dim>
  void
  MatrixFreeOperator<dim>::contact_stiffness(Vector &y, const Vector &x) const
  {
    apply<Vectorial>(
      Field::displacement,
      y,
      x,
      [&](const unsigned int batch) { return contact_cells.contain(batch); },
      [&](Vectorial &u) {
        momentum_on_cell({0., 1.}, u);
      });
  }



  template <int dim>
  void
  MatrixFreeOperator<dim>::lateral_exchange(Vector &y, const Vector &x) const
  {
    const auto acts_on = [&](const unsigned int batch) {
      return contact_cells.exchange_laterally(batch);
    };
    apply<Scalar>(Field::temperature, y, x, acts_on, [&](Scalar &theta) {
      const unsigned int       batch  = theta.get_current_cell_index();
      VectorizedArray<double> *values = theta.begin_dof_values();
      std::copy(values, values + theta.dofs_per_cell, input.begin());
      std::fill(values, values + theta.dofs_per_cell, 0.);
      contact_cells.add_lateral_exchange(batch, 1., input.begin(), values);
    });
  }



  template <int dim>
  template <int n_components, typename OnCell>
  Vector
  MatrixFreeOperator<dim>::diagonal(const Field::Block field,
                                    const OnCell      &on_cell) const
  {
    Vector diagonal = spaces.make_vector(field);
    MatrixFreeTools::compute_diagonal<dim,
                                      -1,
                                      0,
                                      n_components,
                                      double,
                                      VectorizedArray<double>,
                                      Vector>(spaces.cells(),
                                              diagonal,
                                              on_cell,
                                              spaces.index(field));
    return diagonal;
  }



  template <int dim>
  Vector
  MatrixFreeOperator<dim>::contact_stiffness_diagonal() const
  {
    return diagonal<dim>(Field::displacement, [&](Vectorial &u) {
      if (contact_cells.contain(u.get_current_cell_index()))
        momentum_on_cell({0., 1.}, u);
      else
        std::fill_n(u.begin_dof_values(), u.dofs_per_cell, 0.);
    });
  }



  template <int dim>
  Vector
  MatrixFreeOperator<dim>::heat_diagonal(const HeatFactors &factors) const
  {
    return diagonal<1>(Field::temperature,
                       [&](Scalar &theta) { heat_on_cell(factors, theta); });
  }



  template <int dim>
  Vector
  MatrixFreeOperator<dim>::momentum_diagonal(
    const MomentumFactors &factors) const
  {
    return diagonal<dim>(Field::displacement,
                         [&](Vectorial &u) { momentum_on_cell(factors, u); });
  }



  template <int dim>
  void
  MatrixFreeOperator<dim>::divergence(Vector &heat, const Vector &u) const
  {
    const EvaluationFlags::EvaluationFlags vector_flags =
      has_uniform_weight ? EvaluationFlags::gradients :
                           EvaluationFlags::values | EvaluationFlags::gradients;
    const auto divergence_at = [&](const Vectorial   &displacement,
                                   const unsigned int q) {
      VectorizedArray<double> result = displacement.get_divergence(q);
      if (!has_uniform_weight)
        result += hoop(displacement, q) * displacement.get_value(q)[dim - 1];
      return result;
    };
    spaces.cells().template cell_loop<Vector, Vector>(
      [&](
        const auto &cells, Vector &dst, const Vector &src, const auto &range) {
        Scalar    theta(cells, spaces.index(Field::temperature));
        Vectorial displacement(cells, spaces.index(Field::displacement));
        for (unsigned int batch = range.first; batch < range.second; ++batch)
          {
            theta.reinit(batch);
            displacement.reinit(batch);
            displacement.gather_evaluate(src, vector_flags);
            for (unsigned int q = 0; q < theta.n_q_points; ++q)
              theta.submit_value(weight(theta, q) *
                                   divergence_at(displacement, q),
                                 q);
            theta.integrate_scatter(EvaluationFlags::values, dst);
          }
      },
      heat,
      u,
      true);
  }



  template <int dim>
  void
  MatrixFreeOperator<dim>::thermal_stress(Vector       &momentum,
                                          const Vector &theta) const
  {
    const EvaluationFlags::EvaluationFlags vector_flags =
      has_uniform_weight ? EvaluationFlags::gradients :
                           EvaluationFlags::values | EvaluationFlags::gradients;
    spaces.cells().template cell_loop<Vector, Vector>(
      [&](
        const auto &cells, Vector &dst, const Vector &src, const auto &range) {
        Scalar    temperature(cells, spaces.index(Field::temperature));
        Vectorial u(cells, spaces.index(Field::displacement));
        for (unsigned int batch = range.first; batch < range.second; ++batch)
          {
            temperature.reinit(batch);
            u.reinit(batch);
            temperature.gather_evaluate(src, EvaluationFlags::values);
            for (unsigned int q = 0; q < u.n_q_points; ++q)
              {
                const VectorizedArray<double> value =
                  weight(u, q) * temperature.get_value(q);
                if (!has_uniform_weight)
                  {
                    Tensor<1, dim, VectorizedArray<double>> force;
                    force[dim - 1] = hoop(u, q) * value;
                    u.submit_value(force, q);
                  }
                u.submit_divergence(value, q);
              }
            u.integrate_scatter(vector_flags, dst);
          }
      },
      momentum,
      theta,
      true);
  }



  template class MatrixFreeOperator<2>;
  template class MatrixFreeOperator<3>;
} // namespace ThermoContact
