// SPDX-License-Identifier: LGPL-2.1-or-later
//
// What the error estimate of a step sees, and what not: doc/discretisation.md
// (D3.4), (D6.1).
//
// 1. A viscous rod on a moving base, b = 0.04, zeta = 1.9, u_A = sin(w t), w =
//    16, without contact. With kappa^2 = b w^2 / (1 + i zeta w)
//      u = Im(U exp(i w t)), U = cos(kappa (1-x)) / cos(kappa) ,
//    from which it starts. A scheme of order 4 takes tolerance^(-1/4) steps:
//    from 1e-4 to 1e-8 ten times as many, to a factor 2 (45 times if velocities
//    of the end do not follow its accelerations as those of the nodes do). u(1)
//    is right to 30 tolerances of the largest |u| = 1.
// 2. The same rod, at rest at its fixed end, whose other end a rigid obstacle
//    holds that moves as g = -1/10 + sin(8 t)^2 / 50: no more than 14 times as
//    many (21 times).
// 3. A body so heavy that it keeps its initial velocity V x, V = 1, whatever
//    b: its heat equation is that of a rod with the source -a V, which before
//    heat has come from x = 0 has at the end with heat exchange k, of initial
//    temperature 1,
//      theta(1) = w - a V (w - 1 + 2 k sqrt(t/pi)) / k^2 ,
//      w = exp(k^2 t) erfc(k sqrt(t)) .
//    For b = 1e2 to 1e10 the error is below 10 tolerances (more than 1000 if
//    temperatures are weighed by a sqrt(E)).
// 4. First steps of heat alone, whose initial temperature fits the ends or not,
//    with a source and without, also from the temperature of the end: the first
//    attempt is accepted, and its error is no less than 1e-3 of what is
//    allowed. (D3.6) is a bound for all of them.

#include <thermocontact/simulation/simulation.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <string>

#include "../recorded_run.h"

using namespace ThermoContact;

namespace
{
  const Overrides viscous_rod{"Model/Fields=displacement",
                              "Model/Inertia=0.04",
                              "Model/Viscosity=1.9"};



  /** $A\cos(\kappa(1-x))$, its real part, as the program reads it. */
  std::string
  real_cosine(const std::complex<double> factor,
              const std::complex<double> kappa)
  {
    const std::string re = number(kappa.real()) + "*(1-x)",
                      im = number(kappa.imag()) + "*(1-x)";
    return '(' + number(factor.real()) + ")*cos(" + re + ")*cosh(" + im +
           ")+(" + number(factor.imag()) + ")*sin(" + re + ")*sinh(" + im + ')';
  }



  void
  check_moving_base()
  {
    const double               w = 16.;
    const std::complex<double> i_unit(0., 1.);
    const std::complex<double> kappa =
      w * std::sqrt(0.04 / (1. + i_unit * 1.9 * w));
    const std::complex<double> end = 1. / std::cos(kappa);
    double                     n_steps[2];
    double                     error = 0.;
    for (const unsigned int k : {0, 1})
      {
        const double      tolerance = k == 0 ? 1e-4 : 1e-8;
        const RecordedRun run_of =
          run<1>("",
                 viscous_rod + Overrides{"Contact/Condition=none",
                                         "Boundary/left/Displacement=sin(16*t)",
                                         "Initial values/Displacement=" +
                                           real_cosine(-i_unit * end, kappa),
                                         "Initial values/Velocity=" +
                                           real_cosine(w * end, kappa),
                                         "Mesh/Degree=6",
                                         entry("Time/Tolerance", tolerance),
                                         "Time/End time=2"});
        n_steps[k] = run_of.rows.size() - 1.;
        for (const StepRecord &r : run_of.rows)
          raise(error,
                std::abs(r.displacement_end -
                         (end * std::exp(i_unit * w * r.time)).imag()) /
                  tolerance);
      }
    deallog << "moving base: steps " << within(n_steps[1] / n_steps[0], 20.)
            << ", tolerances " << within(error, 30.) << std::endl;
  }



  void
  check_moving_obstacle()
  {
    double n_steps[2];
    for (const unsigned int k : {0, 1})
      n_steps[k] =
        run<1>("",
               viscous_rod +
                 Overrides{"Contact/Condition=rigid",
                           "Contact/Gap=-0.1+sin(8*t)^2/50",
                           "Initial values/Displacement=-0.1*x",
                           "Initial values/Velocity=0",
                           entry("Time/Tolerance", k == 0 ? 1e-4 : 1e-8),
                           "Time/End time=1"})
          .rows.size() -
        1.;
    deallog << "moving obstacle: steps " << within(n_steps[1] / n_steps[0], 14.)
            << std::endl;
  }



  void
  check_heavy_body()
  {
    const double a = 0.3, k = 2., tolerance = 1e-6;
    double       error = 0.;
    for (const char *const b : {"1e2", "1e4", "1e6", "1e10"})
      for (const StepRecord &r :
           run<1>("",
                  {std::string("Model/Inertia=") + b,
                   "Model/Viscosity=0.15",
                   entry("Model/Coupling", a),
                   "Boundary/left/Temperature=1",
                   entry("Boundary/right/Heat exchange", k),
                   "Contact/Condition=none",
                   "Initial values/Temperature=1",
                   "Initial values/Velocity=x",
                   "Mesh/Degree=8",
                   entry("Time/Tolerance", tolerance),
                   "Time/First step size=1e-3",
                   "Time/End time=1e-3"})
             .rows)
        {
          const double s = k * std::sqrt(r.time);
          const double w = std::exp(s * s) * std::erfc(s);
          const double theta =
            w - a * (w - 1. + 2. * s / std::sqrt(numbers::PI)) / (k * k);
          if (r.time == 1e-3)
            raise(error, std::abs(r.temperature_end - theta) / tolerance);
        }
    deallog << "heavy body: tolerances " << within(error, 10.) << std::endl;
  }



  void
  check_first_steps()
  {
    unsigned int n_rejected = 0, n = 0;
    double       smallest = 1.;
    for (const char *const initial : {"0*x",
                                      "10",
                                      "10*cos(3*x)",
                                      "10*(cos(2*pi*x)-sin(pi*x/2))",
                                      "10*(x>0.5)",
                                      "10*(1-x)+sin(20*pi*x)"})
      for (const char *const k : {"0", "1", "100"})
        for (const char *const mesh : {"1", "4", "9"})
          for (const char *const tolerance : {"1e-3", "1e-7"})
            for (const char *const scheme : {"sdirk3", "sdirk4"})
              for (const char *const source : {"0", "5"})
                {
                  Simulation<1> simulation(
                    read_parameters(
                      "",
                      {"Model/Fields=temperature",
                       std::string("Sources/Heat source=") + source,
                       std::string("Initial values/Temperature=") + initial,
                       std::string("Boundary/right/Heat exchange=") + k,
                       std::string("Mesh/Degree=") + mesh,
                       std::string("Time/Tolerance=") + tolerance,
                       std::string("Time/Scheme=") + scheme}),
                    MPI_COMM_SELF);
                  simulation.step();
                  const auto &attempts = simulation.history().attempts;
                  ++n;
                  n_rejected += attempts.size() - 1;
                  // a body at rest has no error
                  if (attempts.front().error > 0.)
                    smallest = std::min(smallest, attempts.front().error);
                }
    deallog << "first steps: rejected " << n_rejected << " of " << n
            << ", not too short " << (smallest > 1e-3) << std::endl;
  }
} // namespace



void
main_error_estimates()
{
  initlog();
  check_moving_base();
  check_moving_obstacle();
  check_heavy_body();
  check_first_steps();
}
