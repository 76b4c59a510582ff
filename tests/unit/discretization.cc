// SPDX-License-Identifier: LGPL-2.1-or-later
//
// Mesh, projection and matrices against what they are by definition.
//
// 1. Counts: n cells of degree p, m across, have (np + 1) (mp + 1)^(dim-1)
//    nodes, of which (mp + 1)^(dim-1) meet the obstacle; their weights add up
//    to the cross-section.
// 2. P_E in 1-D interpolates at the vertices, for every degree, also on a
//    graded mesh; what it loses is orthogonal: (w - P_E w)_x against the
//    derivative of any function of the space. It keeps a polynomial of the
//    space.
// 3. 1' M 1 = volume; theta_s' (K + kB) theta_s for theta_s = A + B x is
//    (B^2 + k (A + B)^2) times the cross-section; for u = x e_1,
//    (1, div u) = volume and u' S u = volume (P-wave modulus one, plane strain,
//    every Poisson ratio); for the shear u = y e_1 in 2-D u' S u = mu volume,
//    mu = (1 - 2 nu)/(2 (1 - nu)).
// 4. The stage matrix times rates is what the blocks give, and rows of the
//    fixed end are those of the identity.

#include <thermocontact/space/assembled_space.h>
#include <thermocontact/space/discretization.h>
#include <thermocontact/space/h1_projection.h>
#include <thermocontact/space/thermoviscoelastic_operator.h>

#include <deal.II/base/function_lib.h>
#include <deal.II/base/mpi.h>

#include <deal.II/numerics/vector_tools.h>

#include <cmath>

#include "../tests.h"

using namespace ThermoContact;

namespace
{
  // not dealii's templates of that name
  using ThermoContact::LinearMap;
  using ThermoContact::Vector;

  /** 1 + dim components, each a given function of the point. */
  template <int dim>
  class Fields : public Function<dim>
  {
  public:
    using Component = std::function<double(const Point<dim> &)>;

    Fields(const Component &temperature, const Component &axial_displacement)
      : Function<dim>(1 + dim)
      , temperature(temperature)
      , axial_displacement(axial_displacement)
    {}

    double
    value(const Point<dim> &point, const unsigned int c) const override
    {
      return c == 0 ? temperature(point) :
                      (c == 1 ? axial_displacement(point) : 0.);
    }

  private:
    const Component temperature;
    const Component axial_displacement;
  };



  template <int dim>
  Parameters
  make_parameters(const unsigned int degree)
  {
    Parameters parameters;
    parameters.dimension              = dim;
    parameters.mesh.degree            = degree;
    parameters.mesh.cells             = 4;
    parameters.mesh.cells_across      = 2;
    parameters.mesh.width             = 0.5;
    parameters.solver.linear_solver   = "direct"; // for its matrices
    parameters.contact.massless_nodes = "off";
    parameters.boundary.heat_exchange = 3.;
    parameters.model.poisson_ratio    = dim == 1 ? 0. : 0.3;
    return parameters;
  }



  template <int dim>
  void
  test_counts(const unsigned int degree)
  {
    const Parameters          parameters = make_parameters<dim>(degree);
    const Scene               scene(parameters);
    const Discretization<dim> space(scene, MPI_COMM_SELF);
    double                    sum = 0.;
    for (const auto &node : space.contact_end().nodes())
      sum += node.weight;
    deallog << dim << "-D, degree " << degree << ": nodes "
            << space.n_temperature_dofs() << ", at the contact end "
            << space.contact_end().nodes().size()
            << ", weights add up to the cross-section "
            << within(std::abs(sum / space.geometry().cross_section() - 1.),
                      1e-14)
            << std::endl;
  }



  void
  test_projection(const unsigned int degree, const double grading)
  {
    Parameters parameters   = make_parameters<1>(degree);
    parameters.mesh.grading = grading;
    const Scene             scene(parameters);
    const Discretization<1> space(scene, MPI_COMM_SELF);
    H1Projection<1>         projection(space);
    const auto              w = [](const Point<1> &x) {
      return std::exp(x[0]) * std::sin(3. * x[0]);
    };
    const auto polynomial = [degree](const Point<1> &x) {
      return x[0] * std::pow(1. - 2. * x[0], static_cast<double>(degree - 1));
    };
    State state = space.make_state();
    projection.project(Fields<1>(w, polynomial),
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



  template <int dim>
  double
  form(const LinearMap &matrix, const Vector &left, const Vector &right)
  {
    Vector product(left);
    matrix.vmult(product, right);
    return left * product;
  }



  template <int dim>
  void
  test_matrices()
  {
    const Parameters                      parameters = make_parameters<dim>(2);
    const Scene                           scene(parameters);
    const AssembledSpace<dim>             assembled(scene, MPI_COMM_SELF);
    const Discretization<dim>            &space = assembled.discretization;
    const ThermoviscoelasticOperator<dim> op(scene,
                                             space,
                                             assembled.matrices.get());
    const auto interpolate = [&](const Fields<dim> &fields) {
      State state  = space.make_state();
      auto  system = space.make_system_vector();
      VectorTools::interpolate(space.mapping(),
                               space.dof_handler(),
                               fields,
                               system);
      space.split(system, state.temperature, state.displacement);
      return state;
    };
    const auto one = [](const Point<dim> &) { return 1.; };
    const auto x   = [](const Point<dim> &p) { return p[0]; };
    const auto y   = [](const Point<dim> &p) { return p[dim - 1]; };

    const State unit   = interpolate(Fields<dim>(one, x));
    const State linear = interpolate(
      Fields<dim>([](const Point<dim> &p) { return 2. - 3. * p[0]; }, y));
    const double volume = space.geometry().cross_section();
    const double k      = parameters.boundary.heat_exchange;
    const double nu     = parameters.model.poisson_ratio;
    const double mu     = 0.5 * (1. - 2. * nu) / (1. - nu);
    const auto   equal  = [volume](const double value, const double expected) {
      return std::abs(value / volume - expected) < 1e-13;
    };
    deallog
      << dim << "-D: M "
      << equal(form<dim>(op.heat_mass, unit.temperature, unit.temperature), 1.)
      << ", K + kB "
      << equal(form<dim>(op.conduction, linear.temperature, linear.temperature),
               9. + k)
      << ", D "
      << equal(form<dim>(op.divergence, unit.temperature, unit.displacement),
               1.)
      << ", D^T "
      << equal(form<dim>(op.thermal_stress,
                         unit.displacement,
                         unit.temperature),
               1.)
      << ", S stretch "
      << equal(form<dim>(op.stiffness, unit.displacement, unit.displacement),
               1.)
      << ", S shear "
      << equal(form<dim>(op.stiffness,
                         linear.displacement,
                         linear.displacement),
               dim == 1 ? 1. : mu)
      << ", M_u "
      << equal(form<dim>(op.momentum_mass,
                         unit.displacement,
                         unit.displacement),
               1. / 3.)
      << std::endl;
  }



  template <int dim>
  void
  test_stage_matrix()
  {
    const Parameters                      parameters = make_parameters<dim>(2);
    const Scene                           scene(parameters);
    const AssembledSpace<dim>             assembled(scene, MPI_COMM_SELF);
    const Discretization<dim>            &space = assembled.discretization;
    const ThermoviscoelasticOperator<dim> op(scene,
                                             space,
                                             assembled.matrices.get());
    const double                          tau = 0.3;
    const ModelParameters                &m   = parameters.model;

    // rates of a made-up but irregular kind, zero where constrained
    State rates = space.make_state();
    for (unsigned int i = 0; i < rates.temperature.size(); ++i)
      rates.temperature[i] = std::sin(1. + i);
    for (unsigned int i = 0; i < rates.displacement.size(); ++i)
      rates.displacement[i] = std::cos(2. * i);
    op.zero_constrained(Field::temperature, rates.temperature);
    op.zero_constrained(Field::displacement, rates.displacement);

    auto system = space.make_system_vector(), product(system);
    space.join(rates.temperature, rates.displacement, system);
    op.stage_matrix(tau).vmult(product, system);
    State result = space.make_state();
    space.split(product, result.temperature, result.displacement);

    Vector heat         = space.make_vector(Field::temperature),
           momentum     = space.make_vector(Field::displacement);
    const auto subtract = [](const LinearMap &matrix,
                             const double     factor,
                             const Vector    &source,
                             Vector          &target) {
      Vector scratch(target);
      matrix.vmult(scratch, source);
      target.add(-factor, scratch);
    };
    subtract(op.heat_mass, 1., rates.temperature, result.temperature);
    subtract(op.conduction, tau, rates.temperature, result.temperature);
    subtract(op.divergence,
             tau * m.coupling,
             rates.displacement,
             result.temperature);
    subtract(op.momentum_mass,
             m.inertia,
             rates.displacement,
             result.displacement);
    subtract(op.stiffness,
             tau * m.viscosity + tau * tau,
             rates.displacement,
             result.displacement);
    subtract(op.thermal_stress,
             -tau * m.coupling,
             rates.temperature,
             result.displacement);
    op.zero_constrained(Field::temperature, result.temperature);
    op.zero_constrained(Field::displacement, result.displacement);

    // identity rows: the product has the rates themselves, zero, there
    double constrained = 0.;
    space.split(product, heat, momentum);
    for (const unsigned int e : space.constrained_entries(Field::temperature))
      raise(constrained, std::abs(heat[e]));
    for (const unsigned int e : space.constrained_entries(Field::displacement))
      raise(constrained, std::abs(momentum[e]));
    deallog << dim << "-D: constrained temperatures "
            << space.constrained_entries(Field::temperature).size()
            << ", displacements "
            << space.constrained_entries(Field::displacement).size()
            << "; stage matrix is its blocks "
            << (result.temperature.linfty_norm() < 1e-13 &&
                result.displacement.linfty_norm() < 1e-13)
            << ", constrained rows " << (constrained == 0.) << std::endl;
  }
} // namespace



void
main_discretization()
{
  initlog();
  for (const unsigned int degree : {1, 3})
    {
      test_counts<1>(degree);
      test_counts<2>(degree);
      test_counts<3>(degree);
    }
  for (const unsigned int degree : {1, 2, 3, 5})
    for (const double grading : {1., 10.})
      test_projection(degree, grading);
  test_matrices<1>();
  test_matrices<2>();
  test_matrices<3>();
  test_stage_matrix<1>();
  test_stage_matrix<2>();
  test_stage_matrix<3>();
}
