// SPDX-License-Identifier: LGPL-2.1-or-later
//
// Free vibrations of a body in two dimensions between an end that slides and a
// rigid obstacle, on rollers, with l = 2 pi for a width of 1/2; nu = 0.3, b =
// 2, zeta = 0.05.
//
// 1. Shear waves,
//      u = (l sin kx cos ly, -k cos kx sin ly) Re exp(zt),
//      b z^2 + mu (k^2 + l^2) (1 + zeta z) = 0,
//    have no dilatation, and no shear stress at the walls.
// 2. Coupled thermoelastic waves, a = 1, insulated at x = 1, and theta = 0 at
//    x = 0. With xi = 1 - x and j = 1, 2
//      u = grad phi, phi = sum phi_j cos k_j xi cos ly exp(zt),
//      a theta = -sum G(K_j) phi_j cos k_j xi cos ly exp(zt),
//      G(K) = b z^2 + (1 + zeta z) K, K_j = k_j^2 + l^2,
//    satisfy (M1.1) and (M1.2) if K_1, K_2 are the roots of (Chadwick 1960)
//      G(K) (z + K) + a^2 K z = 0,
//    and have no flux, shear stress and displacement u_n at xi = 0. u_n = 0 and
//    theta = 0 at xi = 1 (and with them no shear stress) leave
//      k_1 sin k_1 G(K_2) cos k_2 = k_2 sin k_2 G(K_1) cos k_1,
//    two of whose roots are, by Newton's method,
//      z = -0.807542070715 + 4.915177287027 i,
//          -1.202972010422 + 6.182118948954 i.
// All on top of a compression that keeps the end on the obstacle. Values at
// (1/2, 0) at 101 times up to t = 1, to 1e-6 of the amplitude, and the decay
// and the frequency that these values have (least squares for x_{n+1} = s x_n -
// q x_{n-1}), to 1e-6. Measured: 3e-8, 6e-8. With contact nodes without mass,
// the default, the rule (C1.1) leaves an error that falls with about the fifth
// power of the cell size for any degree, so that 1e-6 takes more cells.

#include <thermocontact/base/number_text.h>
#include <thermocontact/simulation/simulation.h>
#include <thermocontact/space/point_values.h>

#include <deal.II/base/mpi.h>

#include <array>
#include <cmath>
#include <complex>
#include <memory>

#include "../tests.h"

using namespace ThermoContact;

namespace
{
  using Complex   = std::complex<double>;
  using Overrides = std::vector<std::string>;

  const double pi = numbers::PI, b = 2., zeta = 0.05, l = 2. * pi;
  const double step = 0.01;



  /** An expression for the real part of c cos(k(1-x)), or of c sin(k(1-x)). */
  std::string
  real_part(const Complex c, const Complex k, const bool is_cosine)
  {
    const std::string p = "(" + significant(k.real(), 17) + "*(1-x))",
                      q = "(" + significant(k.imag(), 17) + "*(1-x))";
    return "(" + significant(c.real(), 17) + "*" + (is_cosine ? "cos" : "sin") +
           p + "*cosh" + q + "+" +
           significant((is_cosine ? 1. : -1.) * c.imag(), 17) + "*" +
           (is_cosine ? "sin" : "cos") + p + "*sinh" + q + ")";
  }



  /** A field of a mode over time at the probe, and its decay and frequency. */
  void
  compare(const std::string         &name,
          const std::vector<double> &series,
          const Complex              rate,
          const Complex              amplitude)
  {
    // x_{n+1} = s x_n - q x_{n-1}, with the least squares
    double error = 0., s11 = 0., s12 = 0., s22 = 0., r1 = 0., r2 = 0.;
    for (unsigned int n = 0; n < series.size(); ++n)
      {
        raise(error,
              std::abs(
                series[n] -
                std::real(amplitude * std::exp(rate * (step * double(n))))));
        if (n < 2)
          continue;
        s11 += series[n - 1] * series[n - 1];
        s12 -= series[n - 1] * series[n - 2];
        s22 += series[n - 2] * series[n - 2];
        r1 += series[n] * series[n - 1];
        r2 -= series[n] * series[n - 2];
      }
    const double  determinant = s11 * s22 - s12 * s12;
    const double  s           = (r1 * s22 - r2 * s12) / determinant;
    const double  q           = (s11 * r2 - s12 * r1) / determinant;
    const Complex found =
      std::log(0.5 * (s + std::sqrt(Complex(s * s - 4. * q)))) / step;
    deallog << name << ", " << series.size() << " values "
            << within(error / std::abs(amplitude), 1e-6) << ", decay "
            << within(std::abs(found.real() / rate.real() - 1.), 1e-6)
            << ", frequency "
            << within(std::abs(found.imag() / rate.imag() - 1.), 1e-6)
            << std::endl;
  }



  /** Values at (1/2, 0) at all steps of a mode above a compression. */
  std::array<std::vector<double>, 2>
  probe_mode(const std::string &massless_nodes,
             const std::string &cells,
             const std::string &degree,
             Overrides          overrides)
  {
    const Overrides scene = {"Dimension=2",
                             "Model/Inertia=2",
                             "Model/Viscosity=0.05",
                             "Model/Poisson ratio=0.3",
                             "Boundary/left/Support=sliding",
                             "Contact/Condition=rigid",
                             "Contact/Gap=-0.05",
                             "Contact/Massless nodes=" + massless_nodes,
                             "Mesh/Width=0.5",
                             "Mesh/Cells=" + cells,
                             "Mesh/Cells across=1",
                             "Mesh/Degree=" + degree,
                             "Time/Step size=0.01",
                             "Time/End time=1"};
    overrides.insert(overrides.end(), scene.begin(), scene.end());
    Simulation<2> simulation(read_parameters("", overrides), MPI_COMM_SELF);
    std::array<std::vector<double>, 2> series;
    std::unique_ptr<PointValues<2>>    values;
    const auto                         observe = [&](const Simulation<2> &s) {
      const Point<2> point(0.5, 0.);
      if (!values)
        values = std::make_unique<PointValues<2>>(
          s.scene(), s.discretization(), std::vector<Place<2>>{{point, point}});
      const auto &v = values->evaluate(s.state());
      series[0].push_back(v[PointValues<2>::temperature]);
      series[1].push_back(v[PointValues<2>::displacement] + 0.025);
    };
    simulation.run({observe});
    return series;
  }



  void
  check_coupled_mode(const Complex rate)
  {
    const double  a = 1., scale = 1e-4;
    const Complex z     = rate;
    const auto    delta = [&](const Complex K) {
      return b * z * z + K * (1. + zeta * z);
    };
    // the roots K = |k|^2 of delta(K) (z + K) + a^2 K z = 0
    const Complex half =
      0.5 * (b * z * z + z * (1. + zeta * z) + a * a * z) / (1. + zeta * z);
    const Complex root =
      std::sqrt(half * half - b * z * z * z / (1. + zeta * z));
    const std::array<Complex, 2> K = {{-half + root, -half - root}};
    const std::array<Complex, 2> k = {
      {std::sqrt(K[0] - l * l), std::sqrt(K[1] - l * l)}};
    std::array<Complex, 2> phi = {
      {scale, -scale * k[0] * std::sin(k[0]) / (k[1] * std::sin(k[1]))}};

    std::string theta, u_x, u_y, v_x, v_y;
    Complex     theta_probe, u_probe;
    for (unsigned int j = 0; j < 2; ++j)
      {
        const Complex t = -delta(K[j]) * phi[j] / a, u = phi[j] * k[j],
                      w = -l * phi[j];
        theta += "+" + real_part(t, k[j], true);
        u_x += "+" + real_part(u, k[j], false);
        u_y += "+" + real_part(w, k[j], true);
        v_x += "+" + real_part(z * u, k[j], false);
        v_y += "+" + real_part(z * w, k[j], true);
        theta_probe += t * std::cos(0.5 * k[j]);
        u_probe += u * std::sin(0.5 * k[j]);
      }
    const std::string c = ")*cos(2*pi*y)", s = ")*sin(2*pi*y)";
    const auto        series =
      probe_mode("off",
                 "2",
                 "10",
                 {"Model/Coupling=1",
                  "Boundary/left/Temperature=0",
                  "Boundary/right/Heat exchange=0",
                  "Initial values/Temperature=(0" + theta + c,
                  "Initial values/Displacement=-0.05*x+(0" + u_x + c + ";(0" +
                    u_y + s,
                  "Initial values/Velocity=(0" + v_x + c + ";(0" + v_y + s});
    compare("coupled, temperature", series[0], rate, theta_probe);
    compare("coupled, displacement", series[1], rate, u_probe);
  }



  void
  check_shear_mode(const std::string &massless_nodes,
                   const std::string &cells,
                   const std::string &degree)
  {
    const double k = pi, mu = 2. / 7.;
    const double stiffness = mu * (k * k + l * l) / b;
    const double decay     = 0.5 * stiffness * zeta;
    const double frequency = std::sqrt(stiffness - decay * decay);

    const std::string along  = "*2*pi*sin(pi*x)*cos(2*pi*y)";
    const std::string across = "*(-pi)*cos(pi*x)*sin(2*pi*y)";
    const std::string rate   = significant(-0.001 * decay, 17);
    const auto        series = probe_mode(
      massless_nodes,
      cells,
      degree,
      {"Model/Fields=displacement",
              "Initial values/Displacement=-0.05*x+0.001" + along + ";0.001" + across,
              "Initial values/Velocity=" + rate + along + ";" + rate + across});
    compare("shear, massless nodes " + massless_nodes,
            series[1],
            Complex(-decay, frequency),
            0.001 * 2. * pi);
  }
} // namespace



void
main_body_modes()
{
  initlog();
  check_shear_mode("off", "2", "10");
  check_shear_mode("automatic", "16", "8");
  check_coupled_mode({-0.807542070715, 4.915177287027});
  check_coupled_mode({-1.202972010422, 6.182118948954});
}
