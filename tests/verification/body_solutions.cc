// SPDX-License-Identifier: LGPL-2.1-or-later
//
// Static bodies in two dimensions with solutions in closed form. nu = 0.3,
// lambda + 2 mu = 1, rollers at the sides.
//
// 1. Full contact with a wavy rigid obstacle, clamped at x = 0. For u = (f(x)
//    cos ky, h(x) sin ky) the dilatation div u = (C cosh kx + S sinh kx) cos ky
//    is harmonic, and with K = (lambda + mu)/(2 mu) Navier's equations and f(0)
//    = h(0) = 0 leave
//      f = C ((1 + K) sinh(kx)/k - K x cosh kx) - S K x sinh kx,
//      h = C K x sinh kx + S ((1 + K) sinh(kx)/k + K x cosh kx).
//    f(1) = D, the amplitude of the obstacle, and h'(1) = k f(1), no shear
//    stress, determine C and S. The pressure is -g_0 - (f'(1) + lambda k h(1))
//    cos ky with the compression u = (g_0 x, 0) that keeps the contact closed.
//    Orders: p + 1 in L2 for the displacement. A nodal pressure is <q, phi_i>/
//    w_i of the pressure q, which the Gauss-Lobatto rule, exact for degree 2p -
//    1, makes q(y_i) for q of degree p - 1: order p, but 2 for p = 1, whose
//    hats are even. Measured to 0.13; the orders of the pressure come up from
//    below, 3.75 on coarse meshes of degree 4. Degree 8 with 2 x 2 cells: both
//    relative to their amplitudes at most 1e-6 (2e-9 and 4e-8 measured).
// 2. Dundurs (1974): a steady temperature deforms a body without stress if
//    nothing holds it. A heat flux k cos ky into the end and theta = 0 at x = 0
//    make theta = sinh kx/cosh k cos ky, and with c = a/(2 (lambda + mu)) = a
//    (1
//    - nu) the displacement c/(k cosh k) (cosh kx cos ky, sinh kx sin ky) has
//    the strain c theta I, whose stress cancels -a theta I. A free end gets u_n
//    = c/k cos ky: its curvature is -c times the flux. (The sliding end x = 0
//    would have to move by 1/cosh k = 1e-8 of that.) u_n, and the axial stress
//    in units of a, at most 1e-6 (1e-9, 1e-8). One step of 1e9 leads there.

#include <thermocontact/simulation/simulation.h>
#include <thermocontact/space/point_values.h>

#include <deal.II/base/function.h>
#include <deal.II/base/mpi.h>
#include <deal.II/base/quadrature_lib.h>

#include <deal.II/numerics/vector_tools_integrate_difference.h>

#include <array>
#include <cmath>
#include <functional>

#include "../tests.h"

using namespace ThermoContact;

namespace
{
  using Overrides = std::vector<std::string>;

  const double pi = numbers::PI, nu = 0.3, lambda = nu / (1. - nu),
               mu = 0.5 * (1. - lambda);



  void
  run(Overrides                                         overrides,
      const Overrides                                  &more,
      const std::function<void(const Simulation<2> &)> &observe)
  {
    overrides.insert(overrides.end(), more.begin(), more.end());
    overrides.push_back("Dimension=2");
    overrides.push_back("Model/Poisson ratio=0.3");
    Simulation<2> simulation(read_parameters("", overrides), MPI_COMM_SELF);
    simulation.run({observe});
  }



  // ------------------------------------------------- 1. a wavy obstacle

  /** The solution of 1. for k = pi. */
  class FullContact : public Function<2>
  {
  public:
    FullContact(const double mean, const double amplitude)
      : Function<2>(2)
      , mean(mean)
    {
      // h'(1) = k f(1) and f(1) = amplitude
      const double s = std::sinh(k), c = std::cosh(k), K = kappa;
      const double f_C = (1. + K) * s / k - K * c, f_S = -K * s;
      const double h_C = K * (s + k * c), h_S = (1. + 2. * K) * c + K * k * s;
      const double ratio = -(h_C - k * f_C) / (h_S - k * f_S);
      C                  = amplitude / (f_C + f_S * ratio);
      S                  = C * ratio;
    }

    double
    value(const Point<2> &point, const unsigned int component) const override
    {
      const double x = point[0], s = std::sinh(k * x), c = std::cosh(k * x);
      const double sum = (1. + kappa) * s / k, product = kappa * x;
      return component == 0 ?
               mean * x + (C * (sum - product * c) - S * product * s) *
                            std::cos(k * point[1]) :
               (C * product * s + S * (sum + product * c)) *
                 std::sin(k * point[1]);
    }

    double
    pressure(const double y) const
    {
      const double s = std::sinh(k), c = std::cosh(k), K = kappa;
      const double h       = C * K * s + S * ((1. + K) * s / k + K * c);
      const double f_prime = C * (c - K * k * s) - S * K * (s + k * c);
      return -mean - (f_prime + lambda * k * h) * std::cos(k * y);
    }

  private:
    const double mean;
    const double k = pi, kappa = 0.5 * (lambda + mu) / mu;
    double       C, S;
  };



  /** Of the displacement in L2 and of the pressure, relative to amplitudes. */
  std::array<double, 2>
  errors_of_full_contact(const unsigned int degree, const unsigned int cells)
  {
    const double          mean = -0.1, amplitude = 0.01;
    const FullContact     exact(mean, amplitude);
    std::array<double, 2> errors{};
    run({"Model/Fields=displacement",
         "Model/Inertia=0",
         "Model/Viscosity=0",
         "Contact/Condition=rigid",
         "Contact/Gap=-0.1+0.01*cos(pi*y)",
         "Mesh/Width=1",
         "Time/End time=0"},
        {"Mesh/Cells=" + std::to_string(cells),
         "Mesh/Cells across=" + std::to_string(cells),
         "Mesh/Degree=" + std::to_string(degree)},
        [&](const Simulation<2> &s) {
          const auto  &space    = s.discretization();
          const State &state    = s.state();
          SystemVector solution = space.make_system_vector();
          space.join(state.temperature, state.displacement, solution);
          dealii::Vector<double> of_cells;
          VectorTools::integrate_difference(space.mapping(),
                                            space.dof_handler(),
                                            solution,
                                            exact,
                                            of_cells,
                                            QGauss<2>(degree + 3),
                                            VectorTools::L2_norm);
          errors[0] = of_cells.l2_norm() / amplitude;
          for (unsigned int i = 0; i < state.contact.pressure.size(); ++i)
            {
              const double y = space.contact_end().nodes()[i].position[1];
              raise(errors[1],
                    std::abs((state.contact.pressure[i] - exact.pressure(y)) /
                             (exact.pressure(0.) + mean)));
            }
        });
    return errors;
  }



  void
  check_full_contact()
  {
    const auto rounded = [](const double order) {
      return std::abs(order - std::round(order)) <= 0.15 ? std::round(order) :
                                                           order;
    };
    for (const unsigned int degree : {1, 2, 3, 4})
      {
        const unsigned int cells  = degree < 3 ? 16 : 8;
        const auto         coarse = errors_of_full_contact(degree, cells);
        const auto         fine   = errors_of_full_contact(degree, 2 * cells);
        deallog << "full contact, degree " << degree << ": displacement "
                << rounded(std::log2(coarse[0] / fine[0])) << ", pressure "
                << rounded(std::log2(coarse[1] / fine[1])) << std::endl;
      }
    const auto errors = errors_of_full_contact(8, 2);
    deallog << "full contact, degree 8: " << within(errors[0], 1e-6) << ' '
            << within(errors[1], 1e-6) << std::endl;
  }


  // ------------------------------------------------- 2. Dundurs' surface

  void
  check_dundurs()
  {
    const double k = 6. * pi, a = 0.5, largest = a * (1. - nu) / k;
    double       error = 0., stress = 0.;
    run({"Model/Inertia=0",
         "Model/Viscosity=0",
         "Model/Coupling=0.5",
         "Boundary/left/Support=sliding",
         "Boundary/left/Temperature=0",
         "Boundary/right/Heat exchange=0",
         "Contact/Condition=none",
         "Initial values/Temperature=0",
         "Boundary/right/Heat flux=6*pi*cos(6*pi*y)",
         "Mesh/Width=0.16666666666666666",
         "Mesh/Cells=8",
         "Mesh/Grading=8",
         "Mesh/Cells across=2",
         "Mesh/Degree=8",
         "Time/Scheme=backward euler",
         "Time/Start=consistent",
         "Time/Step size=1e9",
         "Time/End time=1e9"},
        {},
        [&](const Simulation<2> &s) {
          if (s.record().time == 0.)
            return;
          const auto         &end = s.discretization().contact_end();
          std::vector<double> u;
          end.get_values(Field::displacement, s.state().displacement, u);
          for (unsigned int i = 0; i < u.size(); ++i)
            raise(error,
                  std::abs(u[i] / largest -
                           std::cos(k * end.nodes()[i].position[1])));
          std::vector<Place<2>> places;
          for (const double x : {0.2, 0.5, 0.8, 0.99, 1.})
            for (const double y : {0., 0.06, 0.1})
              places.push_back({Point<2>(x, y), Point<2>(x, y)});
          PointValues<2> values(s.scene(), s.discretization(), places);
          const auto    &v = values.evaluate(s.state());
          for (unsigned int i = 0; i < places.size(); ++i)
            raise(stress,
                  std::abs(v[PointValues<2>::stress * places.size() + i]) / a);
        });
    deallog << "Dundurs: displacement " << within(error, 1e-6) << ", no stress "
            << within(stress, 1e-6) << std::endl;
  }
} // namespace



void
main_body_solutions()
{
  initlog();
  check_full_contact();
  check_dundurs();
}
