// SPDX-License-Identifier: LGPL-2.1-or-later
//
// Bodies in two and three dimensions with solutions in closed form; lambda + 2
// mu = 1.
//
// 1. Full contact on a wavy rigid obstacle, static, between an end that slides
//    and rollers. With u = (f(x) cos ky, h(x) sin ky), e = div u = C cosh kx
//    cos ky is harmonic, and Navier's equations, u_x = 0 at x = 0 and u_x = D
//    cos ky, no shear stress at x = 1 leave
//      f = A sinh kx + P x cosh kx,  P = -(lambda + mu) C/(2 mu),
//      k h = C cosh kx - f',  f(1) = D,  h'(1) = k f(1),
//    and the pressure -g_0 - f'(1) cos ky - lambda k h(1) cos ky. Largest error
//    at the contact nodes relative to the amplitude: at most 1e-5 with degree
//    4 and 16 x 8 cells, and smaller by the power degree of the cell size, at
//    least, from half as many cells on, for degrees 1, 2 and 4.
// 2. Dundurs: a temperature exp(-k (1 - x)) cos ky with k = 8 pi, steady but
//    for exp(-k) = 1e-11 at the other end, makes u_n = a (1 - nu) cos(ky)/k of
//    a free surface, without stress. Relative error at most 1e-6 with degree 4.
// 3. Shear waves between walls without friction, e(u) free of dilatation,
//      u = (l sin kx cos ly, -k cos kx sin ly) q(t),
//      b z^2 + mu (k^2 + l^2) (1 + zeta z) = 0,  z = -a + iw,
//    on top of a compression that keeps the end on a rigid obstacle. From
//    q(0) = 1, q'(0) = -a on q = exp(-at) cos(wt): u_x at (0.5, 0) up to t = 1
//    to 1e-6 of its amplitude.
// 4. Free sides and nu = 0: the rod. u(1), force, temperature and energy of
//    every step through impact and release, 1e-8 of the largest.
// 5. Free sides, nu = 0.3, impact with V = 1/10 on a rigid obstacle, zeta = 0:
//    the pressure in the middle of the end is sqrt(b) V until waves from the
//    sides arrive, W/2 after the impact. Mean over the middle of that time, 2
//    %.
// 6. A block with symmetric data stays so: pressures of nodes that y <-> W - y,
//    z <-> W - z, y <-> z map to each other agree to 1e-10 of the largest.

#include <thermocontact/base/number_text.h>
#include <thermocontact/simulation/simulation.h>
#include <thermocontact/space/point_values.h>

#include <deal.II/base/mpi.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <iostream>
#include <memory>

#include "../tests.h"

using namespace ThermoContact;

namespace
{
  using Overrides = std::vector<std::string>;

  const double pi = numbers::PI, nu = 0.3, lambda = nu / (1. - nu),
               mu = 0.5 * (1. - lambda);

  template <int dim>
  void
  run(const Overrides                                    &overrides,
      const std::function<void(const Simulation<dim> &)> &observe)
  {
    Simulation<dim> simulation(read_parameters("", overrides), MPI_COMM_SELF);
    simulation.run({observe});
  }



  Overrides
  joined(Overrides first, const Overrides &second)
  {
    first.insert(first.end(), second.begin(), second.end());
    return first;
  }



  const Overrides plane_elastic{"Dimension=2",
                                "Model/Fields=displacement",
                                "Model/Poisson ratio=0.3",
                                "Boundary/Lateral support=rollers",
                                "Boundary/Fixed end support=sliding"};

  const Overrides static_body{"Model/Inertia=0",
                              "Model/Viscosity=0",
                              "Time/End time=0"};



  /** The amplitude of the pressure of 1. for D = 1. */
  double
  amplitude_of_pressure(const double k)
  {
    // rows f(1) = 1 and h'(1) = k f(1), for A and C
    const double c = std::cosh(k), s = std::sinh(k);
    const double P   = -(lambda + mu) / (2. * mu); // per C
    const double a11 = s, a12 = P * c;
    // k h = (C - A k - P) cosh kx - P k x sinh kx
    const double a21 = -k * s, a22 = s - 2. * P * s - P * k * c;
    const double b1 = 1., b2 = k;
    const double det   = a11 * a22 - a12 * a21;
    const double A     = (b1 * a22 - a12 * b2) / det;
    const double C     = (a11 * b2 - a21 * b1) / det;
    const double slope = A * k * c + P * C * (c + k * s);
    return -slope - lambda * (C * c - slope);
  }



  double
  error_of_full_contact(const unsigned int degree, const unsigned int cells)
  {
    const double k = 4. * pi, D = 0.001, g_0 = -0.1;
    double       error = 0.;
    run<2>(joined(joined(plane_elastic, static_body),
                  {"Contact/Condition=rigid",
                   "Contact/Gap=-0.1+0.001*cos(4*pi*y)",
                   "Mesh/Width=0.25",
                   "Mesh/Cells=" + std::to_string(2 * cells),
                   "Mesh/Cells across=" + std::to_string(cells),
                   "Mesh/Degree=" + std::to_string(degree)}),
           [&](const Simulation<2> &s) {
             const auto  &nodes     = s.discretization().contact_end().nodes();
             const double amplitude = D * amplitude_of_pressure(k);
             for (unsigned int i = 0; i < nodes.size(); ++i)
               raise(error,
                     std::abs((s.state().contact_pressure[i] + g_0) /
                                amplitude -
                              std::cos(k * nodes[i].position[1])));
           });
    return error;
  }



  void
  check_full_contact()
  {
    for (const unsigned int degree : {1, 2, 4})
      {
        const double coarse = error_of_full_contact(degree, 4);
        const double fine   = error_of_full_contact(degree, 8);
        std::cout << "full contact, degree " << degree << ": " << coarse << ' '
                  << fine << std::endl;
        deallog << "full contact, degree " << degree
                << ": falls with the power " << degree << ' '
                << (fine <= coarse / std::pow(2., degree));
        if (degree == 4)
          deallog << ", at most 1e-5 " << (fine <= 1e-5);
        deallog << std::endl;
      }
  }



  void
  check_dundurs()
  {
    const double k = 8. * pi, a = 0.5;
    double       error = 0.;
    run<2>(joined(static_body,
                  {"Dimension=2",
                   "Model/Poisson ratio=0.3",
                   "Model/Coupling=0.5",
                   "Boundary/Lateral support=rollers",
                   "Boundary/Fixed end support=sliding",
                   "Boundary/Fixed end temperature=0",
                   "Contact/Condition=none",
                   "Initial values/Temperature=exp(-8*pi*(1-x))*cos(8*pi*y)",
                   "Mesh/Width=0.125",
                   "Mesh/Cells=32",
                   "Mesh/Cells across=4",
                   "Mesh/Grading=10",
                   "Mesh/Degree=4"}),
           [&](const Simulation<2> &s) {
             const auto         &end = s.discretization().contact_end();
             std::vector<double> u;
             end.get_values(Field::displacement, s.state().displacement, u);
             for (unsigned int i = 0; i < u.size(); ++i)
               raise(error,
                     std::abs(u[i] * k / (a * (1. - nu)) -
                              std::cos(k * end.nodes()[i].position[1])));
           });
    std::cout << "Dundurs: " << error << std::endl;
    deallog << "Dundurs' surface: at most 1e-6 " << (error <= 1e-6)
            << std::endl;
  }
} // namespace



namespace
{
  void
  check_shear_waves()
  {
    const double k = pi, l = 2. * pi, zeta = 0.05;
    const double stiffness = mu * (k * k + l * l);
    const double decay     = 0.5 * stiffness * zeta;
    const double frequency = std::sqrt(stiffness - decay * decay);

    const std::string mode   = "*2*pi*sin(pi*x)*cos(2*pi*y)";
    const std::string across = "*(-pi)*cos(pi*x)*sin(2*pi*y)";
    const std::string rate   = significant(-0.001 * decay, 17);

    std::unique_ptr<PointValues<2>> values;
    double                          error = 0.;
    run<2>(joined(plane_elastic,
                  {"Model/Viscosity=0.05",
                   "Contact/Condition=rigid",
                   "Contact/Gap=-0.05",
                   "Initial values/Displacement=-0.05*x+0.001" + mode +
                     ";0.001" + across,
                   "Initial values/Velocity=" + rate + mode + ";" + rate +
                     across,
                   "Mesh/Width=0.5",
                   "Mesh/Cells=4",
                   "Mesh/Cells across=2",
                   "Mesh/Degree=6",
                   "Time/Tolerance=1e-8",
                   "Time/End time=1"}),
           [&](const Simulation<2> &s) {
             const Point<2> point(0.5, 0.);
             if (!values)
               values = std::make_unique<PointValues<2>>(s.scene(),
                                                         s.discretization(),
                                                         std::vector<Place<2>>{
                                                           {point, point}});
             const double t = s.record().time;
             const double u =
               values->evaluate(s.state())[PointValues<2>::displacement];
             raise(error,
                   std::abs((u + 0.025) / (0.001 * 2. * pi) -
                            std::exp(-decay * t) * std::cos(frequency * t)));
           });
    std::cout << "shear waves: " << error << std::endl;
    deallog << "shear waves: at most 1e-6 " << (error <= 1e-6) << std::endl;
  }



  /** What is compared with the rod, of all steps. */
  template <int dim>
  std::vector<std::array<double, 4>>
  rows_without_poisson_ratio()
  {
    std::vector<std::array<double, 4>> rows;
    Overrides                          overrides{"Mesh/Cells=8",
                        "Mesh/Degree=2",
                        "Contact/Gap=0.02",
                        "Initial values/Velocity=0.5*x",
                        "Time/Scheme=sdirk2",
                        "Time/Step size=0.01",
                        "Time/End time=1"};
    if (dim > 1)
      overrides = joined(overrides,
                         {"Dimension=" + std::to_string(dim),
                          "Model/Poisson ratio=0",
                          "Boundary/Lateral support=free",
                          "Mesh/Cells across=2"});
    run<dim>(overrides, [&](const Simulation<dim> &s) {
      const StepRecord &r = s.record();
      rows.push_back(
        {{r.displacement_end, r.contact_force, r.temperature_end, r.energy}});
    });
    return rows;
  }



  void
  check_rod()
  {
    const auto rod = rows_without_poisson_ratio<1>();
    for (const auto &body :
         {rows_without_poisson_ratio<2>(), rows_without_poisson_ratio<3>()})
      {
        double error   = body.size() == rod.size() ? 0. : 1.;
        bool   touches = false, is_free = false;
        for (unsigned int c = 0; c < 4; ++c)
          {
            double largest = 0., difference = 0.;
            for (unsigned int i = 0; i < std::min(rod.size(), body.size()); ++i)
              {
                raise(largest, std::abs(rod[i][c]));
                raise(difference, std::abs(rod[i][c] - body[i][c]));
                touches |= rod[i][1] > 0.;
                is_free |= touches && rod[i][1] == 0.;
              }
            raise(error, difference / largest);
          }
        std::cout << "rod: " << error << std::endl;
        deallog << "free sides, no lateral contraction: impact " << touches
                << " and release " << is_free << ", the rod to 1e-8 "
                << (error <= 1e-8) << std::endl;
      }
  }



  void
  check_impact()
  {
    const double V = 0.1, impact = 0.002 / V, half = 0.125;
    double       begin = 0., end = 0., sum = 0., last_time = 0.;
    unsigned int middle = 0;
    run<2>({"Dimension=2",
            "Model/Fields=displacement",
            "Model/Poisson ratio=0.3",
            "Model/Viscosity=0",
            "Boundary/Lateral support=free",
            "Contact/Condition=rigid",
            "Contact/Gap=0.002",
            "Initial values/Velocity=0.1",
            "Mesh/Width=0.25",
            "Mesh/Cells=48",
            "Mesh/Cells across=12",
            "Mesh/Degree=2",
            "Time/Scheme=sdirk2",
            "Time/Step size=0.001",
            "Time/End time=0.15"},
           [&](const Simulation<2> &s) {
             const auto &nodes = s.discretization().contact_end().nodes();
             for (unsigned int i = 0; i < nodes.size(); ++i)
               if (std::abs(nodes[i].position[1] - half) < 1e-10)
                 middle = i;
             const double t = s.record().time;
             if (t > impact + 0.25 * half && t < impact + 0.75 * half)
               {
                 sum += (t - last_time) * s.state().contact_pressure[middle];
                 begin = begin > 0. ? begin : last_time;
                 end   = t;
               }
             last_time = t;
           });
    const double mean = sum / (end - begin);
    std::cout << "impact: " << mean / V << " over " << end - begin << std::endl;
    deallog << "impact with free sides: pressure in the middle within 2 % "
            << (std::abs(mean / V - 1.) <= 0.02) << std::endl;
  }



  void
  check_symmetry(const std::string &solver, const Overrides &overrides)
  {
    double error = 0., largest = 0.;
    run<3>(joined({"Dimension=3",
                   "Model/Poisson ratio=0.3",
                   "Boundary/Lateral support=free",
                   "Contact/Gap=0.01+0.05*((y-0.2)^2+(z-0.2)^2)",
                   "Initial values/Velocity=x",
                   "Mesh/Width=0.4",
                   "Mesh/Cells=4",
                   "Mesh/Cells across=4",
                   "Mesh/Degree=2",
                   "Time/Scheme=sdirk2",
                   "Time/Step size=0.005",
                   "Time/End time=0.05",
                   "Solver/Linear solver=" + solver},
                  overrides),
           [&](const Simulation<3> &s) {
             const auto  &nodes = s.discretization().contact_end().nodes();
             const auto  &p     = s.state().contact_pressure;
             const double width = 0.4;
             for (unsigned int i = 0; i < nodes.size(); ++i)
               for (unsigned int j = 0; j < nodes.size(); ++j)
                 {
                   const Point<3> &x = nodes[i].position,
                                  &y = nodes[j].position;
                   const auto is_at  = [&](const double a, const double b) {
                     return std::abs(y[1] - a) + std::abs(y[2] - b) < 1e-10;
                   };
                   if (is_at(width - x[1], x[2]) || is_at(x[1], width - x[2]) ||
                       is_at(x[2], x[1]))
                     raise(error, std::abs(p[i] - p[j]));
                   raise(largest, p[i]);
                 }
           });
    std::cout << "symmetry, " << solver << ": " << error / largest << std::endl;
    deallog << "symmetric block, " << solver << ": contact " << (largest > 0.)
            << ", stays symmetric to 1e-10 " << (error <= 1e-10 * largest)
            << std::endl;
  }
} // namespace



int
main(int argc, char **argv)
{
  Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  initlog();
  check_full_contact();
  check_dundurs();
  check_shear_waves();
  check_rod();
  check_impact();
  check_symmetry("direct", {});
  check_symmetry("iterative", {"Solver/Linear tolerance=1e-12"});
}
