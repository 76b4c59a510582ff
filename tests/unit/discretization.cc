// SPDX-License-Identifier: LGPL-2.1-or-later
//
// P_E in 1-D interpolates at the vertices, for every degree, also on a graded
// mesh; what it loses is orthogonal: (w - P_E w)_x against the derivative of
// any function of the space. It keeps a polynomial of the space. Bodies:
// matrix_free.cc.

#include <thermocontact/space/discretization.h>
#include <thermocontact/space/expression_function.h>
#include <thermocontact/space/h1_projection.h>

#include <deal.II/base/mpi.h>

#include <cmath>

#include "../tests.h"

using namespace ThermoContact;

namespace
{
  void
  test_projection(const unsigned int degree, const double grading)
  {
    Parameters parameters;
    parameters.mesh.degree  = degree;
    parameters.mesh.cells   = 4;
    parameters.mesh.grading = grading;
    const Scene             scene(parameters);
    const Discretization<1> space(scene, MPI_COMM_SELF);
    H1Projection<1>         projection(scene, space);
    const auto              w = [](const Point<1> &x) {
      return std::exp(x[0]) * std::sin(3. * x[0]);
    };
    const auto polynomial = [degree](const Point<1> &x) {
      return x[0] * std::pow(1. - 2. * x[0], static_cast<double>(degree - 1));
    };
    State                 state = space.make_state();
    const ExpressionNames names{{"x", "y", "z", "t"}, {}};
    projection.project(ExpressionFunction<1>(
                         {Expression("w", "exp(x)*sin(3*x)", names),
                          Expression("polynomial",
                                     "x*(1 - 2*x)^" +
                                       std::to_string(degree - 1),
                                     names)}),
                       state.temperature,
                       state.displacement);
    auto system = space.make_system_vector();
    space.join(state.temperature, state.displacement, system);

    // values at the vertices, and the error of the derivative against the
    // derivatives of the space's functions on each cell, which are all
    // polynomials of degree p - 1
    double vertex_error = 0., orthogonality = 0., polynomial_error = 0.;
    const QGauss<1>                  quadrature(degree + 6);
    FEValues<1>                      values(space.finite_element(),
                       quadrature,
                       update_values | update_gradients |
                         update_quadrature_points | update_JxW_values);
    const FEValuesExtractors::Scalar temperature(0), displacement(1);
    std::vector<Tensor<1, 1>>        gradients(quadrature.size());
    std::vector<double>              u(quadrature.size());
    for (const auto &cell : space.dof_handler().active_cell_iterators())
      {
        for (const unsigned int v : cell->vertex_indices())
          raise(vertex_error,
                std::abs(system(cell->vertex_dof_index(v, 0)) -
                         w(cell->vertex(v))));
        values.reinit(cell);
        values[temperature].get_function_gradients(system, gradients);
        values[displacement].get_function_values(system, u);
        for (unsigned int power = 0; power < degree; ++power)
          {
            double integral = 0.;
            for (const unsigned int q : values.quadrature_point_indices())
              {
                const double x = values.quadrature_point(q)[0];
                const double w_x =
                  std::exp(x) * (std::sin(3. * x) + 3. * std::cos(3. * x));
                integral += (gradients[q][0] - w_x) *
                            std::pow(x, static_cast<double>(power)) *
                            values.JxW(q);
              }
            raise(orthogonality, std::abs(integral));
          }
        for (const unsigned int q : values.quadrature_point_indices())
          raise(polynomial_error,
                std::abs(u[q] - polynomial(values.quadrature_point(q))));
      }
    deallog << "P_E, degree " << degree << ", grading " << grading
            << ": interpolates at vertices " << within(vertex_error, 1e-14)
            << ", orthogonal " << within(orthogonality, 1e-9)
            << ", keeps polynomials " << within(polynomial_error, 1e-14)
            << std::endl;
  }
} // namespace



void
main_discretization()
{
  initlog();
  for (const unsigned int degree : {1, 2, 3, 5})
    for (const double grading : {1., 10.})
      test_projection(degree, grading);
}
