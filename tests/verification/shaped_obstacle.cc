// SPDX-License-Identifier: LGPL-2.1-or-later
//
// Contact/Gap as an expression: rigid obstacles with a shape against a static
// body (b = zeta = 0, no heat), pressed together by a negative gap. With the
// mean pressure P that the program finds, theory says where there is contact
// and how large the pressure is. nu = 0.3, E* = 4 mu (lambda + mu) = 40/49.
//
// 1. Westergaard (1939): a wavy obstacle, g = g_0 + D (1 - cos(2 pi y/L)),
//    against a half of one wave, 0 <= y <= L/2 = 1/4, on rollers. With
//      sin^2(pi a/L) = P/P_1,  P_1 = pi E* D/L,
//      p(y) = 2 P cos(pi y/L) sqrt(s^2 - sin^2(pi y/L))/s^2,  s = sin(pi a/L),
//    for y < a. (Of the clamped end in the depth 1 = 2 L there remains 1e-9.)
// 2. Hertz (1881), plane: g = g_0 + y^2/(2 R), the half y >= 0 on rollers, with
//    the force 2 F on both: a^2 = 8 F R/(pi E*), p = p_0 sqrt(1 - y^2/a^2),
//    p_0 = 4 F/(pi a).
// 3. Hertz, a sphere on a round rod, free sides: a^3 = 3 F R/(4 E*),
//    p_0 = 3 F/(2 pi a^2).
// Of each: the last node in contact and the next one are on both sides of a,
// but for one node; p(0) within 1 % (Westergaard) or 2 % (Hertz, whose bodies
// are no half-spaces); the largest error of p at the nodes with y < 0.9 a in
// parts of p(0) within 2 %, and that of Westergaard smaller on the finer mesh.
// Measured: p(0) to 0.1 % and 0.2 %, profiles to 0.9 %.
// 4. The columns of the face, from the pressures at its nodes. A block in 3-D,
//    3 x 3 cells of degree 1 across, against an oblique obstacle: a node weighs
//    1/36 for each cell that it belongs to; area, largest pressure and moments
//    to 1e-12, the moments those of an end that is pressed where y and z are
//    small. The sphere: no moment, and an area between the circles through the
//    last node in contact and the next one.

#include <thermocontact/simulation/simulation.h>

#include <deal.II/base/mpi.h>

#include <algorithm>
#include <cmath>

#include "../tests.h"

using namespace ThermoContact;

namespace
{
  const double pi = numbers::PI, modulus = 40. / 49.;

  /** What is found: nodes with their pressures, and the mean pressure. */
  struct Contact
  {
    std::vector<double> y, pressure;
    double              mean;
    StepRecord          face;
  };



  Contact
  press(const std::string &file, const std::vector<std::string> &overrides)
  {
    Simulation<2> simulation(read_parameters("verification/" + file + ".prm",
                                             overrides),
                             MPI_COMM_SELF);
    Contact       contact;
    const auto    observe = [&](const Simulation<2> &s) {
      contact.mean = s.record().contact_force;
      contact.face = s.record();
      for (const auto &node : s.discretization().contact_end().nodes())
        contact.y.push_back(node.position[1]);
      contact.pressure = s.state().contact.pressure;
    };
    simulation.run({observe});
    return contact;
  }



  /** Prints the verdicts; returns the largest error of the profile. */
  template <typename Profile>
  double
  compare(const std::string &name,
          const Contact     &contact,
          const double       a,
          const double       peak_bound,
          const Profile     &profile)
  {
    unsigned int n = 0;
    while (n < contact.y.size() && contact.pressure[n] > 0.)
      ++n;
    bool is_open_beyond = true;
    for (unsigned int i = n; i < contact.y.size(); ++i)
      is_open_beyond &= contact.pressure[i] == 0.;
    const bool is_radius = n > 2 && n + 2 < contact.y.size() &&
                           contact.y[n - 2] < a && a < contact.y[n + 1];
    const double peak  = profile(contact.y[0]);
    double       error = 0.;
    for (unsigned int i = 0; i < n; ++i)
      if (contact.y[i] < 0.9 * a)
        raise(error,
              std::abs(contact.pressure[i] - profile(contact.y[i])) / peak);
    const double peak_error = std::abs(contact.pressure[0] / peak - 1.);
    deallog << name << ": one patch " << is_open_beyond << ", its size "
            << is_radius << ", peak within " << peak_bound << ' '
            << within(peak_error, peak_bound) << ", profile "
            << within(error, 0.02) << std::endl;
    if (!is_radius || !(peak_error <= peak_bound) || !(error <= 0.02))
      deallog << "  a = " << a << ", " << n << " nodes to "
              << contact.y[n > 0 ? n - 1 : 0] << ", peak " << peak_error
              << ", profile " << error << std::endl;
    return error;
  }



  double
  check_westergaard(const std::string &approach, const std::string &cells)
  {
    const double  L = 0.5, D = 0.01;
    const Contact contact =
      press("westergaard",
            {"Mesh/Cells across=" + cells,
             "Contact/Gap=" + approach + "+0.01*(1-cos(4*pi*y))"});
    const double s =
      std::sqrt(std::min(1., contact.mean / (pi * modulus * D / L)));
    return compare("Westergaard, g_0 = " + approach + ", " + cells + " cells",
                   contact,
                   L / pi * std::asin(s),
                   0.01,
                   [&](const double y) {
                     const double sine = std::sin(pi * y / L);
                     return 2. * contact.mean * std::cos(pi * y / L) *
                            std::sqrt(std::max(0., s * s - sine * sine)) /
                            (s * s);
                   });
  }



  void
  check_hertz()
  {
    const Contact line      = press("hertz-sphere",
                               {"Mesh/Geometry=plane strain",
                                     "Boundary/sides/Support=rollers",
                                     "Contact/Gap=-0.01+y^2"});
    const double  R         = 0.5,
                 half_width = std::sqrt(8. * line.mean * R / (pi * modulus));
    compare("Hertz, plane", line, half_width, 0.02, [&](const double y) {
      return 4. * line.mean / (pi * half_width) *
             std::sqrt(std::max(0., 1. - std::pow(y / half_width, 2)));
    });

    const Contact sphere = press("hertz-sphere", {});
    const double  force  = pi * sphere.mean;
    const double  radius = std::cbrt(3. * force * R / (4. * modulus));
    compare("Hertz, sphere", sphere, radius, 0.02, [&](const double y) {
      return 3. * force / (2. * pi * radius * radius) *
             std::sqrt(std::max(0., 1. - std::pow(y / radius, 2)));
    });
    unsigned int n = 0;
    while (n + 1 < sphere.y.size() && sphere.pressure[n] > 0.)
      ++n;
    const double area = sphere.face.contact_area;
    deallog << "  moments " << sphere.face.moment_y << ' '
            << sphere.face.moment_z << ", area between circles "
            << (std::pow(sphere.y[n - 1], 2) < area &&
                area < std::pow(sphere.y[n], 2))
            << std::endl;
  }



  /** Sums over the nodes of 3 x 3 cells of degree 1 on a square of side 0.3. */
  StepRecord
  sum_over_nodes(const std::vector<Point<3>> &nodes,
                 const std::vector<double>   &pressure)
  {
    const auto is_inside = [](const double y) {
      return y > 1e-9 && y < 0.3 - 1e-9;
    };
    StepRecord face;
    for (unsigned int i = 0; i < nodes.size(); ++i)
      if (const double p = pressure[i]; p > 0.)
        {
          const double y = nodes[i][1], z = nodes[i][2];
          const double weight =
            (is_inside(y) ? 2. : 1.) * (is_inside(z) ? 2. : 1.) / 36.;
          face.contact_area += weight;
          raise(face.max_pressure, p);
          face.moment_y += weight * p * (y - 0.15);
          face.moment_z += weight * p * (z - 0.15);
        }
    return face;
  }



  void
  check_face()
  {
    Simulation<3> simulation(read_parameters("verification/westergaard.prm",
                                             {"Dimension=3",
                                              "Mesh/Width=0.3",
                                              "Mesh/Cells=2",
                                              "Mesh/Cells across=3",
                                              "Mesh/Degree=1",
                                              "Contact/Gap=-0.03+y/9+z/8"}),
                             MPI_COMM_SELF);
    StepRecord    found, expected;
    simulation.run({[&](const Simulation<3> &s) {
      std::vector<Point<3>> nodes;
      for (const auto &node : s.discretization().contact_end().nodes())
        nodes.push_back(node.position);
      expected = sum_over_nodes(nodes, s.state().contact.pressure);
      found    = s.record();
    }});
    const auto same = [](const double a, const double b) {
      return std::abs(a - b) <= 1e-12 * std::abs(b);
    };
    deallog << "oblique obstacle: part in contact "
            << (expected.contact_area > 0.1 && expected.contact_area < 0.9)
            << ", area " << same(found.contact_area, expected.contact_area)
            << ", largest pressure "
            << same(found.max_pressure, expected.max_pressure) << ", moments "
            << same(found.moment_y, expected.moment_y) << ' '
            << same(found.moment_z, expected.moment_z) << ", negative "
            << (found.moment_y < 0. && found.moment_z < 0.) << ", different "
            << !same(found.moment_y, found.moment_z) << std::endl;
  }
} // namespace



void
main_shaped_obstacle()
{
  initlog();

  for (const std::string approach : {"-0.005", "-0.015", "-0.03"})
    {
      const double coarse = check_westergaard(approach, "32");
      const double fine   = check_westergaard(approach, "64");
      deallog << "  error falls by " << within(fine / coarse, 1.) << std::endl;
    }
  check_hertz();
  check_face();
}
