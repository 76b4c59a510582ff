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
// 1. The first impact is that of a smooth motion: its time is right to 30
//    tolerances (measured 6 with degree 8, else 2 at most, errors of the mesh).
//    From then on the jump of the velocity travels through the rod, and the
//    mesh resolves that to h/p only: u(1) within 0.01 at all times (measured
//    8e-3 with degree 8, else 5e-3), and the second contact begins within h/p =
//    1/128 of t_2 (measured 9e-4). The energy never exceeds the first one by
//    more than a thousandth.
// 2. What the time steps do to the events, on one mesh: with the tolerances
//    1e-7 and 1e-8 they are as many as with 1e-9, and each is within 30
//    tolerances of it (measured 7; the first within 0.07). With larger
//    tolerances pauses of contact that are shorter than h/p/50 may be missed.
// 3. What the mesh does to the first one. u_1 goes on beyond x = 1 as an even
//    function, whose third derivative jumps there: the order is about 3
//    whatever the degree (measured 3.6, 2.9). Cells of degree 8 at the
//    tolerance 1e-9: from 8 to 16 and from 16 to 32 cells the error of t_1
//    falls with order 2.5 at least, and with 64 cells it is 30 tolerances at
//    most, so that nothing but the mesh keeps it from d'Alembert's.

#include <thermocontact/base/exceptions.h>
#include <thermocontact/simulation/simulation.h>

#include <deal.II/base/mpi.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

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



  Parameters
  impact(const unsigned int n_cells,
         const unsigned int degree,
         const std::string &gap,
         const std::string &tolerance,
         const std::string &end_time)
  {
    return read_parameters("",
                           {"Model/Fields=displacement",
                            "Model/Viscosity=0",
                            "Contact/Condition=rigid",
                            "Contact/Gap=" + gap,
                            "Mesh/Cells=" + std::to_string(n_cells),
                            "Mesh/Degree=" + std::to_string(degree),
                            "Time/Tolerance=" + tolerance,
                            "Time/End time=" + end_time});
  }



  void
  check(const unsigned int degree, const std::string &gap)
  {
    const Parameters parameters = impact(8, degree, gap, "1e-6", "3.3");
    const double     g          = parameters.contact.gap;
    const double     t_1        = inverse(from_end, g);
    const double     t_2        = 3. + inverse(from_start, 2. * g);

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
            << within(std::abs(first) / tolerance, 30.) << ", second to 1/128 "
            << is_second_in_time << ", u(1) "
            << within(displacement_error, 0.01) << ", energy "
            << within(growth, 1.001) << std::endl;
  }



  std::vector<ContactEvent>
  events_of(const Parameters &parameters)
  {
    Simulation<1> simulation(parameters, MPI_COMM_SELF);
    simulation.run();
    return simulation.events();
  }



  void
  check_steps(const unsigned int degree, const std::string &gap)
  {
    const auto best = events_of(impact(8, degree, gap, "1e-9", "3.3"));
    for (const std::string text : {"1e-7", "1e-8"})
      {
        const auto events   = events_of(impact(8, degree, gap, text, "3.3"));
        double     error    = 0.;
        bool       is_alike = events.size() == best.size();
        for (unsigned int i = 0; is_alike && i < best.size(); ++i)
          {
            is_alike = events[i].kind == best[i].kind;
            raise(error, std::abs(events[i].time - best[i].time));
          }
        deallog << "degree " << degree << ", gap " << gap << ", tolerance "
                << text << ": events alike " << is_alike
                << ", to 30 tolerances " << (error <= 30. * std::stod(text))
                << std::endl;
      }
  }



  void
  check_mesh()
  {
    const std::string   gap = "0.1137";
    const double        t_1 = inverse(from_end, std::stod(gap));
    std::vector<double> errors;
    for (const unsigned int n_cells : {8, 16, 32, 64})
      errors.push_back(std::abs(
        events_of(impact(n_cells, 8, gap, "1e-9", "0.3")).at(0).time - t_1));
    for (const unsigned int i : {0, 1})
      deallog << "order 2.5 of the first impact "
              << (std::log2(errors[i] / errors[i + 1]) >= 2.5) << std::endl;
    deallog << "with 64 cells to 30 tolerances of 1e-9 "
            << within(errors[3], 30e-9) << std::endl;
  }
} // namespace



void
main_elastic_impact_degrees()
{
  initlog();
  check(8, "0.1137");
  check(16, "0.05");
  check(16, "0.1137");
  check(16, "0.2");
  check(20, "0.1137");
  for (const std::string gap : {"0.05", "0.2"})
    for (const unsigned int degree : {8, 16})
      check_steps(degree, gap);
  check_steps(24, "0.2");
  check_mesh();
}
