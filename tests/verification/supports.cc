// SPDX-License-Identifier: LGPL-2.1-or-later
//
// Bodies that nothing but a sliding end holds, and halves of symmetric bodies.
// lambda = nu/(1 - nu), lambda + 2 mu = 1, W = 2 c the width.
//
// 1. Pure bending by the end traction m (y - c), without inertia and viscosity:
//    the stress is m (y - c) along x alone. With k = m/(1 - lambda^2) in plane
//    strain and k = m/E, E = (1 + nu)(1 - 2 nu)/(1 - nu), of a block
//      strip: u_x = k x (y - c),
//             u_y = -k x^2/2 - lambda k (y^2 - W y)/2,
//      block: u_x = k x (y - c),
//             u_y = -k x^2/2 - nu k (y^2 - W y - z^2)/2,
//             u_z = -nu k z (y - c):
//    u_x = 0 at x = 0, and the corners that are held are where they were. Cells
//    of degree 2 contain it: 1e-6 of the largest displacement, 1e-8 by factors.
// 2. Free expansion by theta = theta_A: u = e (x, y, z) with (1 + lambda) e = a
//    theta_A in plane strain, (1 + 2 lambda) e = a theta_A of a block.
// 3. Half of a strip and a quarter of a block, thrown at a rounded obstacle
// that
//    a part of the end touches: all columns but the displacement of the middle
//    of the mesh are those of the whole body, to 1e-8 of the largest value of
//    the column.
// 4. Widths one unit in the last place off: which nodes are corners is not a
//    matter of rounding. Bent blocks and strips as above, 1e-8 by factors, of
//    widths 0.1 to 1 and their neighbours with 5, 6 and 7 cells across; 1e-6 by
//    iterations. A block whose corner is missed turns about its axis.
// 5. Flat cells of a nearly incompressible block at rest, which multigrid
//    hardly smoothes: the solution of the direct solver to 1e-6.

#include <thermocontact/simulation/simulation.h>

#include <deal.II/base/function.h>
#include <deal.II/base/mpi.h>

#include <deal.II/numerics/vector_tools_interpolate.h>

#include <algorithm>
#include <cmath>
#include <sstream>

#include "../tests.h"

#include "../overrides.h"

using namespace ThermoContact;

namespace
{
  const double nu = 0.3, lambda = nu / (1. - nu);

  /** A displacement behind the temperature, which is left out. */
  template <int dim>
  class Exact : public dealii::Function<dim>
  {
  public:
    Exact(const unsigned int n_components, const bool is_bent, const double W)
      : dealii::Function<dim>(n_components)
      , is_bent(is_bent)
      , W(W)
    {}

    double
    value(const dealii::Point<dim> &p, const unsigned int c) const override
    {
      if (c + dim < this->n_components)
        return 0.;
      const unsigned int d = c + dim - this->n_components;
      const double       e = 0.017 * 10. / (1. + (dim - 1) * lambda);
      if (!is_bent)
        return e * p[d];
      const double x = p[0], y = p[1], z = dim == 3 ? p[dim - 1] : 0.;
      const double E      = (1. + nu) * (1. - 2. * nu) / (1. - nu);
      const double k      = 0.01 / (dim == 2 ? 1. - lambda * lambda : E);
      const double across = dim == 2 ? lambda : nu;
      if (d == 0)
        return k * x * (y - W / 2.);
      return d == 1 ?
               -k * x * x / 2. - across * k * (y * y - W * y - z * z) / 2. :
               -nu * k * z * (y - W / 2.);
    }

  private:
    const bool   is_bent;
    const double W;
  };



  /** The error of a body at rest, over its largest displacement. */
  template <int dim>
  double
  error_at_rest(const std::string &solver,
                const bool         is_bent,
                const double       width,
                const unsigned int n_across,
                const unsigned int n_along)
  {
    std::ostringstream traction, digits;
    digits.precision(17);
    traction.precision(17);
    digits << width;
    traction << "0.01*(y-" << width / 2. << ')';
    const Overrides scene = {"Dimension=" + std::to_string(dim),
                             "Model/Inertia=0",
                             "Model/Viscosity=0",
                             "Model/Poisson ratio=0.3",
                             "Contact/Condition=none",
                             "Boundary/sides/Support=free",
                             "Boundary/left/Support=sliding",
                             "Mesh/Width=" + digits.str(),
                             "Mesh/Cells=" + std::to_string(n_along),
                             "Mesh/Cells across=" + std::to_string(n_across),
                             "Mesh/Degree=2",
                             "Time/Scheme=sdirk2",
                             "Time/Step size=0.1",
                             "Time/End time=0.1",
                             "Solver/Linear solver=" + solver};
    const Overrides load =
      is_bent ? Overrides{"Model/Fields=displacement",
                          "Boundary/right/Traction=" + traction.str()} :
                Overrides{"Initial values/Temperature=theta_A",
                          "Boundary/right/Heat exchange=0"};
    Simulation<dim> simulation(read_parameters("", scene + load),
                               MPI_COMM_SELF);
    simulation.run({});
    const auto  &space = simulation.discretization();
    SystemVector all   = space.make_system_vector();
    dealii::VectorTools::interpolate(space.mapping(),
                                     space.dof_handler(),
                                     Exact<dim>(space.n_components(),
                                                is_bent,
                                                width),
                                     all);
    ThermoContact::Vector theta = space.make_vector(Field::temperature),
                          u     = space.make_vector(Field::displacement);
    space.split(all, theta, u);
    const double largest = u.linfty_norm();
    u -= simulation.state().displacement;
    return u.linfty_norm() / largest;
  }



  double
  bound(const std::string &solver)
  {
    return solver == "direct" ? 1e-8 : 1e-6;
  }



  template <int dim>
  void
  check_rest(const std::string &solver, const bool is_bent)
  {
    deallog << dim << "-D, " << solver
            << (is_bent ? ", bent: " : ", expanded: ")
            << within(error_at_rest<dim>(solver, is_bent, 0.4, 2, 5),
                      bound(solver))
            << std::endl;
  }



  template <int dim>
  void
  check_widths(const std::string               &solver,
               const std::vector<double>       &widths,
               const std::vector<unsigned int> &n_across)
  {
    double error = 0.;
    for (const double width : widths)
      for (const double side : {0., width, 2. * width})
        for (const unsigned int n : n_across)
          raise(error,
                error_at_rest<dim>(
                  solver, true, std::nextafter(width, side), n, 2));
    deallog << dim << "-D, " << solver
            << ", bent, widths beside others: " << within(error, bound(solver))
            << std::endl;
  }



  template <int dim>
  std::vector<std::array<double, 18>>
  rows(const Overrides &scene)
  {
    std::vector<std::array<double, 18>> result;
    Simulation<dim> simulation(read_parameters("", scene), MPI_COMM_SELF);
    simulation.run({[&](const Simulation<dim> &s) {
      result.push_back(all_columns(s.record()));
    }});
    return result;
  }



  template <int dim>
  void
  check_half(const std::string &solver)
  {
    const unsigned int middle = 3, numerical_dissipation = 14, energy = 12;
    const std::string  of_z    = dim == 3 ? "+(z-0.2)^2" : "";
    const std::string  of_half = dim == 3 ? "+z^2" : "";
    const Overrides    scene   = {"Dimension=" + std::to_string(dim),
                                  "Model/Poisson ratio=0.3",
                                  "Initial values/Velocity=x",
                                  "Mesh/Cells=4",
                                  "Mesh/Degree=2",
                                  "Time/Scheme=sdirk2",
                                  "Time/Step size=0.01",
                                  "Time/End time=0.1",
                                  "Solver/Linear solver=" + solver};
    const Overrides    tight   = solver == "direct" ?
                                   Overrides{} :
                                   Overrides{"Solver/Linear tolerance=1e-12"};
    const auto         whole =
      rows<dim>(scene + tight +
                Overrides{"Boundary/sides/Support=free",
                          "Contact/Gap=0.01+0.3*((y-0.2)^2" + of_z + ")",
                          "Mesh/Width=0.4",
                          "Mesh/Cells across=4"});
    const auto half =
      rows<dim>(scene + tight +
                Overrides{"Boundary/sides/Support=symmetric",
                          "Contact/Gap=0.01+0.3*(y^2" + of_half + ")",
                          "Mesh/Width=0.2",
                          "Mesh/Cells across=2"});
    double error = whole.size() == half.size() ? 0. : 1., force = 0.;
    for (unsigned int c = 0; c < 18; ++c)
      {
        double largest = 0., difference = 0.;
        for (unsigned int i = 0; i < std::min(whole.size(), half.size()); ++i)
          {
            raise(largest, std::abs(whole[i][c]));
            raise(difference, std::abs(whole[i][c] - half[i][c]));
            raise(force, whole[i][8]);
            if (c == numerical_dissipation)
              raise(largest, std::abs(whole[i][energy]));
          }
        if (c != middle && difference > 0.)
          raise(error, difference / largest);
      }
    deallog << dim << "-D, " << solver << ", touches " << (force > 0.)
            << ", half and whole " << within(error, 1e-8) << std::endl;
  }



  void
  check_flat_cells()
  {
    double u[2];
    for (const std::string solver : {"direct", "iterative"})
      {
        Simulation<3> simulation(read_parameters("",
                                                 {"Dimension=3",
                                                  "Model/Inertia=0",
                                                  "Model/Poisson ratio=0.4999",
                                                  "Contact/Gap=1",
                                                  "Boundary/sides/Support=free",
                                                  "Mesh/Width=4",
                                                  "Mesh/Cells=8",
                                                  "Mesh/Cells across=2",
                                                  "Mesh/Degree=2",
                                                  "Time/Scheme=sdirk2",
                                                  "Time/Step size=0.1",
                                                  "Time/End time=0.1",
                                                  "Solver/Linear solver=" +
                                                    solver}),
                                 MPI_COMM_SELF);
        simulation.run({});
        u[solver == "iterative"] = simulation.record().displacement_end;
      }
    deallog << "flat cells, as direct "
            << within(std::abs(u[1] / u[0] - 1.), 1e-6) << std::endl;
  }
} // namespace



void
main_supports()
{
  initlog();
  for (const std::string solver : {"direct", "iterative"})
    for (const bool is_bent : {true, false})
      {
        check_rest<2>(solver, is_bent);
        check_rest<3>(solver, is_bent);
      }
  for (const std::string solver : {"direct", "iterative"})
    {
      check_half<2>(solver);
      check_half<3>(solver);
    }
  check_widths<2>("direct",
                  {0.1, 0.2, 0.25, 0.4, 0.5, 0.7, 0.8, 1.},
                  {5, 6, 7});
  check_widths<3>("direct", {0.1, 0.25, 0.4, 0.7}, {5, 6});
  check_widths<3>("iterative", {0.4}, {6});
  check_flat_cells();
}
