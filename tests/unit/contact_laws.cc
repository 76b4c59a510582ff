// SPDX-License-Identifier: LGPL-2.1-or-later
//
// Contact laws, and contact of nodes with those that are not linear; no mesh.
//
// 1. Every law of the program, at p between 0.1 and 3: d energy = p ds
//    and ds = tangent dp (central differences of step 1e-4 p, so to 1e-7),
//    pressure(s(p)) = p and penetration_of_energy(energy(p)) = s(p) unless it
//    is rigid, the resolvent solves z - chi p = s(p), odd where it is held,
//    odd penetrations; the mean pressure between two penetrations times their
//    difference is the difference of the energies.
// 2. Power laws with m = 1.2, 1.5, 2, 3, 6, eps = 0.01 to 10: the responses of
//    6 random nodes, W = A^T A + 0.01 I, times 1e-6 to 1e6 for short and long
//    stages, and penetrations s of both signs that are drawn make the free
//    penetrations s + W p(s). The solver has to find p(s), to 1e-9 of the
//    largest, from zero and from large pressures, unilateral and held closed
//    (p odd): 600 problems. One node alone: s_free = s + chi p(s) likewise, to
//    1e-12.

#include <thermocontact/contact/interface_problem.h>

#include <cmath>
#include <random>

#include "../tests.h"


using namespace ThermoContact;
using dealii::FullMatrix;

namespace
{
  void
  test_laws()
  {
    for (const ContactLawKind &kind : contact_laws())
      {
        const auto   law   = kind.make(default_law_parameters());
        const double chi   = 0.3;
        double       worst = 0.;
        for (const double p : {0.1, 1., 3.})
          {
            const double h  = 1e-4 * p;
            const double ds = law->penetration(p + h) - law->penetration(p - h);
            const double dE = law->energy(p + h) - law->energy(p - h);
            const double s  = law->penetration(p);
            raise(worst, std::abs(dE - p * ds) / (2. * h));
            raise(worst, std::abs(ds / (2. * h) - law->tangent(p)));
            raise(worst, std::abs(s + law->penetration(-p)));
            raise(worst, std::abs(law->pressure(-1.)));
            raise(worst, law->resolve(-1., chi).pressure);
            if (!law->is_active())
              continue;
            NodeLaw held(*law);
            held.is_held = true;
            raise(worst, std::abs(law->resolve(s + chi * p, chi).pressure - p));
            raise(worst,
                  std::abs(held.resolve(-s - chi * p, chi).pressure + p));
            if (law->is_rigid())
              continue;
            raise(worst, std::abs(law->pressure(s) - p));
            raise(worst,
                  std::abs(law->penetration_of_energy(law->energy(p)) - s));
            for (const double other : {-0.7 * s, 0.3 * s, 2. * s})
              raise(worst,
                    std::abs(law->mean_pressure(s, other) * (other - s) -
                             law->energy(law->pressure(other)) +
                             law->energy(p)));
          }
        deallog << kind.name << ": consistent " << within(worst, 1e-7)
                << ", linear " << law->is_linear() << std::endl;
      }
  }



  /** Largest error of the pressures of a power law, relative. */
  double
  error_of_power_law(const ContactLaw          &law,
                     const FullMatrix<double>  &response,
                     const std::vector<double> &penetration,
                     const bool                 is_closed,
                     const double               start)
  {
    const unsigned int  n = penetration.size();
    std::vector<double> exact(n), free_penetration(penetration), p(n, start);
    double              largest = 0.;
    for (unsigned int i = 0; i < n; ++i)
      {
        const double s = penetration[i];
        exact[i] = s > 0. || !is_closed ? law.pressure(s) : -law.pressure(-s);
        raise(largest, std::abs(exact[i]));
      }
    for (unsigned int i = 0; i < n; ++i)
      for (unsigned int j = 0; j < n; ++j)
        free_penetration[i] += response(i, j) * exact[j];
    std::vector<NodeLaw> laws(n, NodeLaw(law));
    for (NodeLaw &node : laws)
      node.is_held = is_closed;
    InterfaceProblem().solve(response, laws, free_penetration, p);
    double error = 0.;
    for (unsigned int i = 0; i < n; ++i)
      raise(error, std::abs(p[i] - exact[i]));
    return largest == 0. ? error : error / largest;
  }



  void
  test_power_laws()
  {
    std::mt19937                           generator(3);
    std::uniform_real_distribution<double> uniform(-1., 1.);
    const double                           exponents[] = {1.2, 1.5, 2., 3., 6.};
    double                                 worst = 0., worst_alone = 0.;
    unsigned int                           n_found = 0;
    for (unsigned int k = 0; k < 150; ++k)
      {
        const double eps   = std::pow(10., -2. + 3. * (k % 4) / 3.);
        const double scale = std::pow(10., 6. * uniform(generator));
        const auto   law   = contact_law("power law")
                           .make({{"Compliance", eps},
                                  {"Exponent", exponents[k % 5]},
                                  {"Damping", 0.}});
        const unsigned int n = 6;
        FullMatrix<double> factor(n, n), response(n, n), alone(1, 1);
        for (unsigned int i = 0; i < n; ++i)
          for (unsigned int j = 0; j < n; ++j)
            factor(i, j) = uniform(generator);
        factor.Tmmult(response, factor);
        std::vector<double> penetration(n);
        for (unsigned int j = 0; j < n; ++j)
          {
            response(j, j) += 0.01;
            penetration[j] = eps * 2. * uniform(generator);
          }
        response *= scale;
        alone(0, 0) = scale;
        for (const bool is_closed : {false, true})
          {
            raise(
              worst_alone,
              error_of_power_law(*law, alone, {penetration[0]}, is_closed, 0.));
            for (const double start : {0., 100.})
              {
                const double error = error_of_power_law(
                  *law, response, penetration, is_closed, start);
                raise(worst, error);
                ++n_found;
              }
          }
      }
    deallog << "power laws: " << n_found << " problems, pressures "
            << within(worst, 1e-9) << ", one node "
            << within(worst_alone, 1e-12) << std::endl;
  }
} // namespace



void
main_contact_laws()
{
  initlog();
  test_laws();
  test_power_laws();
}
