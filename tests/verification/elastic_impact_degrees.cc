// SPDX-License-Identifier: LGPL-2.1-or-later
//
// Impacts of an elastic rod (zeta = 0, no heat) with u_1 = 20 x (x - 1)^2 on a
// rigid obstacle, 8 cells of high degree, error-controlled steps of tolerance
// 1e-6. At an event the massless contact node moves by the margin that is left,
// at once, in a step of any size; that must not stop the steps: all runs go on
// to T = 3.3, past the second impact.
//
// By d'Alembert, with G(t) = 20 (t^3/3 - t^4/4), the integral of u_1 from 1 - t
// to 1, and I(s) = 20 (s^2/2 - 2 s^3/3 + s^4/4), that from 0 to s:
//   u(1) = G(t)                 until G(t_1) = g, the first impact,
//          g                    until t = 1, where p = 20 (1 - t) t^2 ends,
//          g - I(t - 1)         until t = 2,
//          g - 5/3 - G(t - 2)   until t = 2 + t_1 (the jump has come back),
//          -5/3 + G(t - 2) - g  until t = 3,
//          I(t - 3) - g         until I(t_2 - 3) = 2 g, the second impact,
//          g                    from then on.
// The first impact is that of a smooth motion: its time is right to 30
// tolerances (measured 6 with degree 8, else 2 at most, errors of the mesh).
// From then on the jump of the velocity travels through the rod, and the mesh
// resolves that to h/p only: u(1) within 0.01 at all times (measured 8e-3 with
// degree 8, else 5e-3), and the second contact begins within h/p = 1/128 of t_2
// (measured 9e-4). The energy never exceeds the first one by more than a
// thousandth.

#include <thermocontact/base/exceptions.h>
#include <thermocontact/simulation/simulation.h>

#include <deal.II/base/mpi.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "../tests.h"

using namespace ThermoContact;

namespace
{
  const double tolerance = 1e-6;

  /** The integral of u_1 from 1 - t to 1. */
  double
  from_end(const double t)
  {
    return 20. * t * t * t * (1. / 3. - t / 4.);
  }



  /** The integral of u_1 from 0 to s. */
  double
  from_start(const double s)
  {
    return 20. * s * s * (0.5 - 2. * s / 3. + s * s / 4.);
  }



  /** Where a function that rises from 0 to 1 has a value. */
  double
  inverse(double (*const function)(double), const double value)
  {
    double low = 0., high = 1.;
    for (unsigned int i = 0; i < 60; ++i)
      (function(0.5 * (low + high)) < value ? low : high) = 0.5 * (low + high);
    return low;
  }



  /** u(1) up to the second impact and while contact lasts then. */
  double
  exact_displacement(const double t, const double gap)
  {
    const double t_1 = inverse(from_end, gap);
    const double t_2 = 3. + inverse(from_start, 2. * gap);
    return t < t_1      ? from_end(t) :
           t < 1.       ? gap :
           t < 2.       ? gap - from_start(t - 1.) :
           t < 2. + t_1 ? gap - 5. / 3. - from_end(t - 2.) :
           t < 3.       ? -5. / 3. + from_end(t - 2.) - gap :
           t < t_2      ? from_start(t - 3.) - gap :
                          gap;
  }



  void
  check(const unsigned int degree, const std::string &gap)
  {
    const Parameters parameters =
      read_parameters("",
                      {"Model/Fields=displacement",
                       "Model/Viscosity=0",
                       "Contact/Condition=rigid",
                       "Contact/Gap=" + gap,
                       "Mesh/Degree=" + std::to_string(degree),
                       "Time/Tolerance=1e-6",
                       "Time/End time=3.3"});
    const double g   = parameters.contact.gap;
    const double t_1 = inverse(from_end, g);
    const double t_2 = 3. + inverse(from_start, 2. * g);

    double        displacement_error = 0., growth = 0., first_energy = 0.;
    Simulation<1> simulation(parameters, MPI_COMM_SELF);
    const auto    observe = [&](const Simulation<1> &s) {
      const StepRecord &r = s.record();
      if (r.step == 0)
        first_energy = r.energy;
      raise(growth, r.energy / first_energy);
      raise(displacement_error,
            std::abs(r.displacement_end - exact_displacement(r.time, g)));
    };
    std::string end = "ends at T";
    try
      {
        simulation.run({observe});
      }
    catch (const ComputationError &error)
      {
        end = error.what();
      }

    const auto  &events = simulation.events();
    const double first  = events.empty() ? INFINITY : events[0].time - t_1;
    const bool   is_second_in_time =
      std::any_of(events.begin(), events.end(), [&](const ContactEvent &event) {
        return event.kind == ContactEvent::begin &&
               std::abs(event.time - t_2) <= 1. / 128.;
      });
    deallog << "degree " << degree << ", gap " << gap << ": " << end
            << ", first impact to 30 tolerances "
            << (std::abs(first) <= 30. * tolerance) << ", second to 1/128 "
            << is_second_in_time << ", u(1) to 0.01 "
            << (displacement_error <= 0.01) << ", energy at most 1.001 "
            << (growth <= 1.001) << std::endl;
  }
} // namespace



int
main(int argc, char **argv)
{
  dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  initlog();
  check(8, "0.1137");
  check(16, "0.05");
  check(16, "0.1137");
  check(16, "0.2");
  check(20, "0.1137");
}
