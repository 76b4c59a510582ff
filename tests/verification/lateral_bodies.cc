// SPDX-License-Identifier: LGPL-2.1-or-later
//
// Heat that is lost along rods and through the sides of bodies, doc/model.md
// section 5: decay, thin bodies.
//
// 1. Decay. With theta_A = theta_inf = 0 and k = 0 the slowest mode decays like
//    exp(-lambda t), lambda = pi^2/4 + m in a rod. In a body it has the factor
//    cos(kappa y) about the axis in each direction, or J_0(kappa r), and
//      strip:  lambda = pi^2/4 + kappa^2 ,   kappa tan(kappa W/2) = m W/2 ,
//      block:  lambda = pi^2/4 + 2 kappa^2 , kappa tan(kappa W/2) = m W/4 ,
//      round:  lambda = pi^2/4 + kappa^2 ,   kappa J_1(kappa R)/J_0(kappa R) =
//              m R/2 ,
//    by -d theta/dn = m A/P theta on the lateral faces; kappa by bisection. A
//    step dt of backward Euler divides a mode by 1 + lambda dt, all others by
//    more: twelve steps of dt = 1 leave the slowest. lambda to 1e-10. The
//    lateral part of the dissipation of a rod is m/lambda of the whole.
// 2. Bodies on rollers, strip, block and round, whose temperature varies by
//    m W^2/8 across, are the rod but for O(W^2): all columns of a run with
//    contact, extrapolated from the widths 0.002 and 0.001, to 1e-9 of their
//    largest values, or of 0.1 (1e-10 measured).

#include <deal.II/base/numbers.h>

#include "../tests.h"

#include "../lateral_runs.h"

using namespace ThermoContact;

namespace
{
  template <int dim>
  void
  check_decay(const std::string &name,
              const double       m,
              const double       shift,
              const Overrides   &body)
  {
    const auto rows =
      run<dim>(read_parameters("",
                               Overrides{"Model/Fields=temperature",
                                         "Boundary/left/Temperature=0",
                                         "Boundary/right/Heat exchange=0",
                                         "Boundary/sides/Heat exchange=" +
                                           std::to_string(m),
                                         "Initial values/Temperature=sin(pi*x/"
                                         "2)",
                                         "Mesh/Cells=2",
                                         "Mesh/Degree=8",
                                         "Time/Scheme=backward euler",
                                         "Time/Step size=1",
                                         "Time/End time=12"} +
                                 body));
    const double before = rows[rows.size() - 2].temperature_mean;
    const double rate   = before / rows.back().temperature_mean - 1.;
    const double lambda = 0.25 * numbers::PI * numbers::PI + shift;
    deallog << "decay, " << name << ": rate "
            << within(std::abs(rate - lambda) / lambda, 1e-10);
    if (dim == 1)
      deallog << ", lateral part of the dissipation "
              << rows.back().lateral_dissipation / rows.back().dissipation *
                   lambda / m;
    deallog << std::endl;
  }



  void
  check_decays()
  {
    const double m = 3., W = 0.4;
    const auto   faces = [&](const double part) {
      const double kappa = bisect(
        [&](const double x) {
          return x * std::tan(0.5 * x * W) - part * m * W;
        },
        1e-3,
        3.);
      return kappa * kappa;
    };
    const double radial = bisect(
      [&](const double x) {
        return x * std::cyl_bessel_j(1., x * W) -
               0.5 * m * W * std::cyl_bessel_j(0., x * W);
      },
      1e-3,
      3.);
    const Overrides strip{"Dimension=2",
                          "Mesh/Width=0.4",
                          "Mesh/Cells across=1"};
    check_decay<1>("rod", m, m, {});
    check_decay<1>("rod", 50., 50., {});
    check_decay<2>("strip", m, faces(0.5), strip);
    check_decay<2>("round",
                   m,
                   radial * radial,
                   strip + Overrides{"Mesh/Geometry=axisymmetric"});
    check_decay<3>("block",
                   m,
                   2. * faces(0.25),
                   strip +
                     Overrides{"Dimension=3", "Mesh/Cells=4", "Mesh/Degree=5"});
  }


  /** The columns of a body without a width. */
  template <int dim>
  Columns
  thin(const Overrides &overrides)
  {
    const auto with = [&](const std::string &width) {
      return table_of(
        run<dim>(read_parameters("",
                                 thrown +
                                   Overrides{"Dimension=" + std::to_string(dim),
                                             "Mesh/Width=" + width,
                                             "Mesh/Cells across=1",
                                             "Model/Poisson ratio=0.3"} +
                                   overrides)));
    };
    Columns       result = with("0.001");
    const Columns wide   = with("0.002");
    for (unsigned int i = 0; i < result.size(); ++i)
      for (unsigned int j = 0; j < result[i].size(); ++j)
        result[i][j] += (result[i][j] - wide[i][j]) / 3.;
    return result;
  }



  void
  check_thin()
  {
    const auto rows       = run<1>(read_parameters("", thrown));
    const auto rod        = table_of(rows);
    const auto in_contact = [](const StepRecord &r) { return r.in_contact; };
    deallog << "thin: contact "
            << std::any_of(rows.begin(), rows.end(), in_contact)
            << ", strip, round rod, block equal the rod: "
            << within(difference(rod, thin<2>({})), 1e-9) << ' '
            << within(difference(rod, thin<2>({"Mesh/Geometry=axisymmetric"})),
                      1e-9)
            << ' ' << within(difference(rod, thin<3>({})), 1e-9) << std::endl;
  }
} // namespace



void
main_lateral_bodies()
{
  initlog();
  check_decays();
  check_thin();
}
