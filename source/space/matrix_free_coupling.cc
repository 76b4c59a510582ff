// SPDX-License-Identifier: LGPL-2.1-or-later

#include <thermocontact/space/matrix_free_operator.h>

namespace ThermoContact
{
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



  template void
  MatrixFreeOperator<2>::divergence(Vector &, const Vector &) const;
  template void
  MatrixFreeOperator<3>::divergence(Vector &, const Vector &) const;
  template void
  MatrixFreeOperator<2>::thermal_stress(Vector &, const Vector &) const;
  template void
  MatrixFreeOperator<3>::thermal_stress(Vector &, const Vector &) const;
} // namespace ThermoContact
