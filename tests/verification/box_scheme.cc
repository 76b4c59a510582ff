// SPDX-License-Identifier: LGPL-2.1-or-later
//
// Elastic impact without dispersion: Time/Scheme = box, dt = h sqrt(b). The rod
// starts with u_1 = 20 x (x - 1)^2 at g = 0.1, to T = 3 sqrt(b), past the
// return of the wave that the impact makes.
//
// With s = t/sqrt(b), u = sqrt(b) U, G = g/sqrt(b), d'Alembert says of the end
// U' = V - P, P = [U - G]_+/eps or the pressure that holds U = G, with
//   V = q_1 = 20 (1 - s) s^2              until s = 1,
//       q_2 = -20 (s - 1) (2 - s)^2       until s = 2,
//       -V(s - 2) + 2 P(s - 2)            from then on.
// Contact from A(s_1) = G on, A = integral of V. In it, on an obstacle of
// compliance eps, U - G = w with w' = V - w/eps:
//   w = eps (q - eps q' + eps^2 q'' - eps^3 q''') + C exp(-s/eps),
// from w(s_1) = 0 up to s = 1 with q_1 and on with q_2 until w = 0; on a rigid
// one U = G until s = 1. Then the rod is free, U' = V, and from s = 2 on
// U(s) = U(2) + A(s - 2) - 2 U(s - 2).
//
// 1. u(1) at all step ends, 200 cells, b = 0.01, 1, 4: exact on a rigid
//    obstacle, as the scheme passes means of cells on, with which it starts:
//    1e-12, rounding of 600 steps. On one of eps = 1e-6, which the mesh does
//    not resolve, within its largest penetration, eps 3 b^(1/2). For eps = 0.1
//    and 0.01 error at most 2e-4 (a prototype in numpy: at most 1.1e-4), and
//    its order from 200 to 400 cells at least 1.8.
// 2. The pressure is the discrete gradient where eps >= h/2: the energy is that
//    of the start to 1e-12. Elsewhere it never grows by more than that in a
//    step. 100, 200, 400 cells: what rounding does to the state in each of 3 *
//    400 steps, 2.2e-16 of the energy, adds up to 2.7e-13 (measured 1.1e-13),
//    and its energy is a sum of squares.
// 3. The same with a step of 0.9 h sqrt(b) warns, and is worse by ten times at
//    least.
// 4. A rod that is heated by its motion, a = 0.5, and b = 1, rigid: the energy
//    balance E + D closes to 1e-12 of the first energy.
// 5. The mirror image of each run is the run, but for rounding.

#include <thermocontact/simulation/simulation.h>

#include <deal.II/base/mpi.h>

#include <cmath>
#include <string>

#include "../mirror_image.h"

using namespace ThermoContact;

namespace
{
  /** The end of the rod by d'Alembert, in the units above. */
  class Exact
  {
  public:
    Exact(const double gap, const double compliance)
      : gap(gap)
      , compliance(compliance)
      , first(root(0., 1., [&](const double s) { return area(s) - gap; }))
      , last(compliance == 0. ? 1. : root(1., 2., [&](const double s) {
        return -late(s);
      }))
    {}

    double
    displacement(const double s) const
    {
      if (s < first)
        return area(s);
      if (s < last)
        return compliance == 0. ? gap : gap + (s < 1. ? early(s) : late(s));
      if (s < 2.)
        return gap + area(s) - area(last);
      return displacement(2. - 1e-15) + area(s - 2.) -
             2. * displacement(s - 2.);
    }

  private:
    const double gap, compliance, first, last;

    template <typename Function>
    static double
    root(double low, double high, const Function &rising)
    {
      for (unsigned int i = 0; i < 60; ++i)
        (rising(0.5 * (low + high)) < 0. ? low : high) = 0.5 * (low + high);
      return low;
    }

    /** Integral of V from 0, for s up to 2. */
    static double
    area(const double s)
    {
      const auto cubic = [](const double y) {
        return 20. * y * y * y * (1. / 3. - y / 4.);
      };
      if (s <= 1.)
        return cubic(s);
      return cubic(1.) - (cubic(1.) - cubic(2. - s)); // q_2(s) = -q_1(2 - s)
    }

    /** w of the particular solution, for q = 20 (y^2 - y^3). */
    double
    particular(const double y, const double direction) const
    {
      // q_1(s): y = s; q_2(s) = -q(2 - s): y = 2 - s, derivatives alternate
      const double e = compliance * direction;
      return direction * compliance *
             (20. * (y * y - y * y * y) - e * 20. * (2. * y - 3. * y * y) +
              e * e * 20. * (2. - 6. * y) - e * e * e * 20. * -6.);
    }

    double
    early(const double s) const
    {
      return particular(s, 1.) -
             particular(first, 1.) * std::exp(-(s - first) / compliance);
    }

    double
    late(const double s) const
    {
      return particular(2. - s, -1.) + (early(1.) - particular(1., -1.)) *
                                         std::exp(-(s - 1.) / compliance);
    }
  };



  MirrorImages images;



  struct Result
  {
    double       error      = 0.; ///< of u(1)
    double       change     = 0.; ///< of the energy, relative
    double       growth     = 0.; ///< of it in a step
    double       imbalance  = 0.;
    unsigned int n_warnings = 0;
  };



  Result
  run(const unsigned int n_cells,
      const double       inertia,
      const double       compliance,
      const double       size     = 1.,
      const double       coupling = 0.)
  {
    std::vector<std::string> entries = {
      coupling == 0. ? "Model/Fields=displacement" :
                       entry("Model/Coupling", coupling),
      "Model/Viscosity=0",
      entry("Model/Inertia", inertia),
      compliance == 0. ? "Contact/Condition=rigid" :
                         entry("Contact/Compliance", compliance),
      "Mesh/Degree=1",
      "Mesh/Cells=" + std::to_string(n_cells),
      "Time/Scheme=box",
      entry("Time/Step size", size * std::sqrt(inertia) / n_cells),
      entry("Time/End time", 3. * std::sqrt(inertia))};
    if (compliance > 0.)
      entries.push_back("Contact/Condition=normal compliance");
    const Parameters parameters = read_parameters("", entries);
    const double     scale      = std::sqrt(inertia);
    const Exact      exact(parameters.contact.gap / scale, compliance);

    Simulation<1> simulation(parameters, MPI_COMM_SELF);
    Result        result;
    double        first = 0., last = 0.;
    const auto    observe = [&](const Simulation<1> &s) {
      const StepRecord &r = s.record();
      if (r.step == 0)
        first = last = r.energy;
      raise(result.error,
            std::abs(r.displacement_end -
                     scale * exact.displacement(r.time / scale)));
      raise(result.change, std::abs(r.energy / first - 1.));
      raise(result.growth, (r.energy - last) / first);
      raise(result.imbalance,
            std::abs(r.energy + r.dissipation + r.numerical_dissipation -
                     first) /
              first);
      last = r.energy;
    };
    images.run(simulation, {observe});
    result.n_warnings = simulation.history().warnings.size();
    return result;
  }



  void
  check(const double inertia, const double compliance)
  {
    const Result coarse      = run(100, inertia, compliance);
    const Result middle      = run(200, inertia, compliance);
    const Result fine        = run(400, inertia, compliance);
    const double order       = std::log2(middle.error / fine.error);
    const bool   is_gradient = compliance >= 0.5 / 100.;
    const double bound       = compliance == 0. ? 1e-12 :
                               is_gradient      ? 2e-4 :
                                             3. * std::sqrt(inertia) * compliance;
    double       energy      = 0.;
    for (const Result &result : {coarse, middle, fine})
      raise(energy, is_gradient ? result.change : result.growth);
    deallog << "b = " << inertia << ", compliance " << compliance << ": u(1) "
            << within(middle.error, bound);
    if (is_gradient)
      deallog << ", order 1.8 " << (order >= 1.8);
    deallog << (is_gradient ? ", energy kept " : ", no growth ")
            << within(energy, 1e-12) << ", warnings " << middle.n_warnings
            << std::endl;
  }
} // namespace



void
main_box_scheme()
{
  initlog();
  for (const double inertia : {0.01, 1., 4.})
    for (const double compliance : {0., 0.1, 0.01, 1e-6})
      check(inertia, compliance);

  const Result best = run(200, 1., 0.), other = run(200, 1., 0., 0.9);
  deallog << "0.9 of the step: warnings " << other.n_warnings
          << ", ten times worse " << (other.error >= 10. * best.error)
          << std::endl;

  const Result heated = run(200, 1., 0., 1., 0.5);
  deallog << "heated by its motion: balance closes "
          << within(heated.imbalance, 1e-12) << std::endl;
  deallog << images.words(1e-12) << std::endl;
}
