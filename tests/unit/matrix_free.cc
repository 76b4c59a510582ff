// SPDX-License-Identifier: LGPL-2.1-or-later
//
// Products without matrices against the assembled matrices of the same body,
// and what a V-cycle has to be as a preconditioner of symmetric blocks.
//
// 1. M, K + kB + L, L, D, D^T, M_u, S times vectors without any symmetry, and
//    the diagonals of the square ones: each entry to 1e-13 of the largest one,
//    since both are the same sums of at most 1e3 terms in another order, with
//    rounding of 1e-16 each. Consistent and lumped mass, contact nodes without
//    mass (C1.1), plane strain, a round rod (M7.1), a block; meshes refined
//    from coarser ones for multigrid, which are numbered otherwise than the
//    same cells made at once, and graded ones. The diagonal of the Laplacian
//    of the mesh against its products with unit vectors; projections with it
//    are orthogonal, (grad (P_E w - w), grad eta) = 0 by another rule for all
//    eta that are not held, to 1e-5: the projection integrates sin(3 x) with
//    five points in linear cells of 0.6, which leaves 6e-7 (measured; 2e-8 with
//    degree 2). grad w is by differences of fourth order, 1e-3 apart. P_E of
//    sin(3 x), which no side but x = 0 holds, is that of a rod: exact at
//    vertices (D1.3).
// 2. The V-cycle B for the blocks A of a stage, M + tau (K + kB) and b M_u +
//    tau (tau + zeta) S (D8.1), without contact, with springs at every second
//    node of the end, softness epsilon = 1e-4, and with these nodes held. The
//    same smoother before and after and exact coarsest factors make it
//    symmetric, r_1' B r_2 = r_2' B r_1, here to 1e-10 of the root of
//    r_1' B r_1 r_2' B r_2, and positive, r' B r > 0. All eigenvalues of B A
//    are to be within 1/2 of 1, which a cycle is that takes half of the error:
//    |r - A B r| < 1/2 |r| in the norm of B. In single precision, as it is
//    used, it is the same to 1e-4: rounding of 6e-8 times the condition of the
//    block, at most some 100 on these meshes, and some roundings each.

#include <thermocontact/multigrid/stage_multigrid.h>
#include <thermocontact/space/cell_products.h>
#include <thermocontact/space/field_matrices.h>
#include <thermocontact/space/h1_projection.h>

#include <deal.II/base/mpi.h>

#include <cmath>
#include <tuple>

#include "../cycle.h"
#include "../matched_spaces.h"

using namespace ThermoContact;

namespace
{
  // not dealii's templates of that name
  using ThermoContact::LinearMap;
  using ThermoContact::SparseMatrix;
  using ThermoContact::Vector;

  Parameters
  make_parameters(const unsigned int dim, const unsigned int degree)
  {
    Parameters parameters;
    parameters.dimension                    = dim;
    parameters.mesh.degree                  = degree;
    parameters.mesh.cells                   = 2;
    parameters.mesh.cells_across            = 2;
    parameters.mesh.width                   = 0.7;
    parameters.boundary.right.heat_exchange = 3.;
    parameters.boundary.sides.heat_exchange = 2.;
    parameters.boundary.sides.support       = "free";
    parameters.contact.massless_nodes       = "off";
    parameters.model.coupling               = 0.5;
    parameters.model.poisson_ratio          = 0.3;
    parameters.initial_values.temperature   = "sin(3*x)";
    parameters.initial_values.displacement =
      dim == 2 ? "sin(2*x)*exp(y); x*cos(3*y)" :
                 "sin(2*x)*exp(y); cos(3*z); y*sin(x)/(2+z)";
    return parameters;
  }



  Parameters
  with_solver(Parameters parameters, const std::string &solver)
  {
    parameters.solver.linear_solver = solver;
    return parameters;
  }



  /** Contact nodes without mass. */
  Parameters
  massless(Parameters parameters)
  {
    parameters.contact.massless_nodes = "on";
    return parameters;
  }



  /** One body with matrices and without. */
  template <int dim>
  class Comparison
  {
  public:
    explicit Comparison(const Parameters &parameters)
      : scene(with_solver(parameters, "direct"))
      , free_scene(with_solver(parameters, "iterative"))
      , space(scene, MPI_COMM_SELF)
      , free_space(free_scene, MPI_COMM_SELF)
      , matrices(scene, space)
      , equations(scene, space, &matrices)
      , free_equations(free_scene, free_space, nullptr)
      , spaces(space, free_space)
    {}

    void
    report() const
    {
      struct Product
      {
        std::string  name;
        Field::Block from, to;
        LinearMap FieldMaps::*map;
      };
      const auto heat = Field::temperature, momentum = Field::displacement;
      deallog << "numbered alike " << spaces.is_complete << "; ";
      for (const Product &of : std::vector<Product>{
             {"M ", heat, heat, &FieldMaps::heat_mass},
             {", K + kB + L ", heat, heat, &FieldMaps::conduction},
             {", L ", heat, heat, &FieldMaps::lateral_exchange},
             {", D ", momentum, heat, &FieldMaps::divergence},
             {", D^T ", heat, momentum, &FieldMaps::thermal_stress},
             {", M_u ", momentum, momentum, &FieldMaps::momentum_mass},
             {", S ", momentum, momentum, &FieldMaps::stiffness}})
        deallog << of.name
                << product(of.from,
                           of.to,
                           equations.*of.map,
                           free_equations.*of.map);
      report_diagonals();
      report_projection();
    }

  private:
    const Scene                           scene, free_scene;
    const Discretization<dim>             space, free_space;
    const FieldMatrices<dim>              matrices;
    const ThermoviscoelasticOperator<dim> equations, free_equations;
    const MatchedSpaces<dim>              spaces;

    /** How much the products differ. */
    std::string
    product(const Field::Block from,
            const Field::Block to,
            const LinearMap   &matrix,
            const LinearMap   &no_matrix) const
    {
      Vector x = space.make_vector(from), free_x = free_space.make_vector(from);
      Vector y = space.make_vector(to), free_y = free_space.make_vector(to);
      spaces.fill(from, x, free_x, 0.);
      free_y = 7.; // what was there is replaced
      matrix.vmult(y, x);
      no_matrix.vmult(free_y, free_x);
      return within(spaces.difference(to, y, free_y, y.linfty_norm()), 1e-13);
    }

    std::string
    diagonal(const Field::Block  field,
             const SparseMatrix &matrix,
             const Vector       &free_diagonal) const
    {
      Vector diagonal = space.make_vector(field);
      for (const auto i : diagonal.locally_owned_elements())
        diagonal[i] = matrix.diag_element(i);
      return ' ' + within(spaces.difference(field,
                                            diagonal,
                                            free_diagonal,
                                            diagonal.linfty_norm()),
                          1e-13);
    }

    void
    report_diagonals() const
    {
      const CellProducts<dim, double> &products =
        *free_equations.cell_products();
      using Kinds     = ThermoContact::FieldMatrix;
      const auto heat = Field::temperature, momentum = Field::displacement;
      deallog << "; diagonals ";
      for (const auto &[field, kind, mass] :
           {std::tuple(heat, Kinds::heat_mass, 1.),
            std::tuple(heat, Kinds::conduction, 0.),
            std::tuple(momentum, Kinds::momentum_mass, 1.),
            std::tuple(momentum, Kinds::stiffness, 0.)})
        deallog << diagonal(field,
                            matrices[kind],
                            products.diagonal(field, mass, 1. - mass));
      double error = 0.; // of the Laplacian
      for (const Field::Block field : all_fields)
        {
          const Vector entries = products.laplacian_diagonal(field);
          Vector       unit(entries), column(entries);
          for (unsigned int i = 0; i < entries.locally_owned_size(); ++i)
            {
              unit                  = 0.;
              unit.local_element(i) = 1.;
              products.laplacian(field, column, unit);
              raise(error, std::abs(column.local_element(i) / entries[i] - 1.));
            }
        }
      deallog << ' ' << within(error, 1e-13);
    }

    /** What the projection of the initial values leaves. */
    void
    report_projection() const
    {
      const ProblemData<dim> data(scene);
      const auto            &initial = *data.initial_fields;
      State                  state   = free_space.make_state();
      H1Projection<dim>(free_scene, free_space, free_equations.cell_products())
        .project(initial, state.temperature, state.displacement);
      double at_vertices = 0.;
      for (const auto &cell : free_space.dof_handler().active_cell_iterators())
        for (const unsigned int v : cell->vertex_indices())
          raise(at_vertices,
                std::abs(state.temperature[cell->vertex_dof_index(v, 0)] -
                         std::sin(3. * cell->vertex(v)[0])));

      // (grad (P_E w - w), grad eta) for all eta that are not held
      const FiniteElement<dim> &fe = free_space.finite_element();
      SystemVector all = free_space.make_system_vector(), misfit(all);
      free_space.join(state.temperature, state.displacement, all);
      FEValues<dim>                            values(fe,
                           QGauss<dim>(fe.degree + 6),
                           update_gradients | update_quadrature_points |
                             update_JxW_values);
      std::vector<std::vector<Tensor<1, dim>>> projected(
        values.n_quadrature_points,
        std::vector<Tensor<1, dim>>(fe.n_components()));
      std::vector<types::global_dof_index> dofs(fe.dofs_per_cell);
      for (const auto &cell : free_space.dof_handler().active_cell_iterators())
        {
          values.reinit(cell);
          values.get_function_gradients(all, projected);
          cell->get_dof_indices(dofs);
          for (unsigned int i = 0; i < dofs.size(); ++i)
            for (const unsigned int q : values.quadrature_point_indices())
              {
                const unsigned int c = fe.system_to_component_index(i).first;
                misfit(dofs[i]) +=
                  (projected[q][c] -
                   gradient(initial, values.quadrature_point(q), c)) *
                  values.shape_grad(i, q) * values.JxW(q);
              }
        }
      double error = 0.;
      for (types::global_dof_index dof = 0; dof < misfit.size(); ++dof)
        if (!free_space.clamped_constraints().is_constrained(dof))
          raise(error, std::abs(misfit(dof)));
      deallog << "; P_E " << within(at_vertices, 1e-12) << ", orthogonal "
              << within(error, 1e-5);
    }

    /** By differences of fourth order. */
    static Tensor<1, dim>
    gradient(const Function<dim> &f, const Point<dim> &p, const unsigned int c)
    {
      constexpr double h = 1e-3;
      Tensor<1, dim>   result;
      for (unsigned int d = 0; d < dim; ++d)
        {
          const auto at = [&](const double part) {
            Point<dim> x(p);
            x[d] += part * h;
            return f.value(x, c);
          };
          result[d] =
            (8. * (at(1.) - at(-1.)) - (at(2.) - at(-2.))) / (12. * h);
        }
      return result;
    }
  };



  template <int dim>
  void
  compare(const std::string &name, const Parameters &parameters)
  {
    deallog << dim << "-D, degree " << parameters.mesh.degree << ", " << name
            << ": ";
    Comparison<dim>(parameters).report();
    deallog << std::endl;
  }



  template <int dim>
  void
  compare_masses(const unsigned int degree)
  {
    Parameters parameters = make_parameters(dim, degree);
    compare<dim>("consistent", parameters);
    parameters.mesh.mass_matrix = "lumped";
    compare<dim>("lumped", parameters);
    parameters = massless(parameters);
    compare<dim>("lumped, massless", parameters);
    parameters.mesh.mass_matrix = "consistent";
    compare<dim>("massless", parameters);
  }



  void
  compare_round_rod(const unsigned int degree)
  {
    Parameters parameters    = make_parameters(2, degree);
    parameters.mesh.geometry = "axisymmetric";
    compare<2>("round rod", parameters);
    parameters = massless(parameters);
    // an odd number, so that a lane is empty
    parameters.mesh.cells        = 3;
    parameters.mesh.cells_across = 1;
    parameters.mesh.grading      = 3.;
    compare<2>("round rod, massless, graded", parameters);
  }



  template <int dim>
  void
  test_cycles(const unsigned int degree,
              const std::string &geometry,
              const double       poisson_ratio = 0.3)
  {
    Parameters parameters          = make_parameters(dim, degree);
    parameters.mesh.width          = 0.5;
    parameters.mesh.cells          = 4;
    parameters.mesh.geometry       = geometry;
    parameters.model.poisson_ratio = poisson_ratio;
    const Scene     scene(with_solver(parameters, "iterative"));
    const Body<dim> body(scene, MPI_COMM_SELF);
    const MultigridLevels<dim, double> levels(body);
    const MultigridLevels<dim, float>  rounded(body);
    for (const double tau : {1e-3, 0.1})
      {
        const ContactRows springs = contact_rows(body, false, tau);
        const ContactRows held    = contact_rows(body, true, tau);
        deallog << dim << "-D, degree " << degree << ", " << geometry << ", nu "
                << poisson_ratio << ", tau = " << tau << ": heat";
        test_cycle<dim>(
          body, levels, rounded, Field::temperature, tau, nullptr);
        deallog << "; momentum";
        test_cycle<dim>(
          body, levels, rounded, Field::displacement, tau, nullptr);
        deallog << "; springs";
        test_cycle<dim>(
          body, levels, rounded, Field::displacement, tau, &springs);
        deallog << "; held";
        test_cycle<dim>(body, levels, rounded, Field::displacement, tau, &held);
        deallog << std::endl;
      }
  }
} // namespace



void
main_matrix_free()
{
  initlog();
  for (const unsigned int degree : {1, 2, 4})
    {
      compare_masses<2>(degree);
      compare_round_rod(degree);
      if (degree < 3) // else 256 unknowns to a cell
        compare_masses<3>(degree);
    }
  for (const unsigned int degree : {1, 2, 4})
    test_cycles<2>(degree, "plane strain");
  test_cycles<2>(2, "axisymmetric");
  test_cycles<3>(1, "plane strain");
  test_cycles<3>(2, "plane strain");
  // with subspaces, and with more steps instead: some, and all
  for (const unsigned int degree : {2, 3, 4})
    test_cycles<2>(degree, "plane strain", 0.46);
  test_cycles<3>(2, "plane strain", 0.46);
  test_cycles<2>(1, "plane strain", 0.46);
  test_cycles<2>(1, "plane strain", 0.4999);
}
