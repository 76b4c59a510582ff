// SPDX-License-Identifier: LGPL-2.1-or-later
//
// Order in dt through contact, on a fixed mesh: experiments 1 and 5 of the
// paper, where contact begins at t = 0.185 and ends at 0.897 and 1.587, with
// fixed steps, against sdirk4 with dt = 1/3200.
//
// Steps that end where contact changes: u(1), u_t(1), theta(1), the contact
// force and the two contact times have the order of the tableau, +-0.15, in two
// halvings of dt, at times before, within and after contact. Errors below 1e-11
// are rounding and skipped, and so is the force where it is zero.
//
// These are fixed times. Right after an impact no order above 3/2 can be had in
// u_t(1): the force grows as t - t_0, and with viscosity u_t(1) has a part
// (t - t_0)^{3/2}, of which the first steps make an error of dt^{3/2} that is
// then smoothed away. The maximum over the steps after contact begins therefore
// is of an order below 2, also for sdirk3 and sdirk4, as long as dt is large
// for the fastest modes of the mesh.
//
// Steps that run across: the force has a kink inside a step, whose error is of
// order dt^2 with a factor that depends on where in the step the kink lies. The
// error of sdirk4 is erratic, of order 2 on average, here between dt = 1/50 and
// 1/800 at most 2.5, and at dt = 1/400 at least 1000 times the one above.

#include <thermocontact/simulation/simulation.h>

#include <deal.II/base/mpi.h>

#include <array>
#include <cmath>
#include <vector>

#include "../tests.h"

using namespace ThermoContact;

namespace
{
  const unsigned int end_time = 2;

  /** u(1), u_t(1), theta(1), force. */
  using Quantities = std::array<double, 4>;

  const std::array<const char *, 4> names = {
    {"u(1)", "u_t(1)", "theta(1)", "force"}};

  struct TestCase
  {
    unsigned int          experiment;
    double                compliance;
    std::array<double, 3> times;     ///< multiples of 1/50
    std::array<bool, 3>   is_closed; ///< contact at these times
  };



  struct Solution
  {
    unsigned int              n = 0;     ///< steps per unit time, 1/dt
    std::vector<Quantities>   multiples; ///< at the multiples of dt
    std::vector<ContactEvent> events;

    const Quantities &
    at(const double time) const
    {
      return multiples.at(std::lround(time * n));
    }
  };



  Solution
  run(const TestCase    &scene,
      const std::string &scheme,
      const unsigned int n,
      const bool         is_located)
  {
    Parameters parameters                   = read_parameters("");
    parameters.contact.law.at("Compliance") = scene.compliance;
    parameters.mesh.cells                   = 4;
    parameters.mesh.degree                  = 5;
    parameters.time.scheme                  = scheme;
    parameters.time.start                   = "consistent";
    parameters.time.end_time                = end_time;
    parameters.time.step_size               = 1. / n;
    parameters.time.locate_contact_events   = is_located ? "true" : "false";
    Simulation<1> simulation(parameters, MPI_COMM_SELF);

    Solution solution;
    solution.n         = n;
    const auto observe = [&](const Simulation<1> &s) {
      const StepRecord &r = s.record();
      if (std::abs(r.time - 1. * solution.multiples.size() / n) < 1e-12)
        solution.multiples.push_back({{r.displacement_end,
                                       r.velocity_end,
                                       r.temperature_end,
                                       r.contact_force}});
    };
    simulation.run({observe});
    solution.events = simulation.events();

    bool as_expected = solution.multiples.size() == end_time * n + 1 &&
                       solution.events.size() == 2 &&
                       solution.events[0].kind == ContactEvent::begin &&
                       solution.events[1].kind == ContactEvent::end;
    for (unsigned int i = 0; i < scene.times.size(); ++i)
      as_expected &=
        (solution.at(scene.times[i])[3] > 0.) == scene.is_closed[i];
    if (!as_expected)
      deallog << scheme << ", dt = 1/" << n
              << ": contact is not that of the scene, or steps do not return "
                 "to multiples of dt"
              << std::endl;
    return solution;
  }



  /** The expected order if it is observed, the observed one otherwise. */
  void
  print_orders(const char                  *name,
               const double                 expected,
               const std::array<double, 3> &errors)
  {
    for (unsigned int level = 1; level < 3; ++level)
      if (!(errors[level] < 1e-11))
        {
          const double observed = std::log2(errors[level - 1] / errors[level]);
          deallog << ", " << name << ' '
                  << (std::abs(observed - expected) <= 0.15 ? expected :
                                                              observed);
        }
  }



  /** Largest error of u_t(1) at multiples of dt after contact begins. */
  double
  largest_velocity_error(const Solution &solution, const Solution &reference)
  {
    const unsigned int ratio   = reference.n / solution.n;
    double             largest = 0.;
    for (unsigned int i = 0; i < solution.multiples.size(); ++i)
      if (1. * i / solution.n > reference.events.at(0).time)
        raise(largest,
              std::abs(solution.multiples[i][1] -
                       reference.multiples.at(i * ratio)[1]));
    return largest;
  }



  void
  study(const TestCase    &scene,
        const std::string &scheme,
        const unsigned int order,
        const unsigned int coarsest,
        const Solution    &reference)
  {
    std::array<Solution, 3> solutions;
    for (unsigned int level = 0; level < 3; ++level)
      solutions[level] = run(scene, scheme, coarsest << level, true);

    const auto print = [&](const char *name, const auto &value) {
      std::array<double, 3> errors;
      for (unsigned int level = 0; level < 3; ++level)
        errors[level] = std::abs(value(solutions[level]) - value(reference));
      print_orders(name, order, errors);
    };
    const std::string title =
      "experiment " + std::to_string(scene.experiment) + ", " + scheme;
    for (const double time : scene.times)
      {
        deallog << title << ", t = " << time;
        for (unsigned int q = 0; q < names.size(); ++q)
          print(names[q], [&](const Solution &s) { return s.at(time)[q]; });
        deallog << std::endl;
      }
    deallog << title << ", contact";
    print("begins", [](const Solution &s) { return s.events.at(0).time; });
    print("ends", [](const Solution &s) { return s.events.at(1).time; });
    deallog << std::endl;

    if (order > 2)
      deallog << title << ", largest error of u_t(1) of the order "
              << within(0.5 *
                          std::log2(
                            largest_velocity_error(solutions[0], reference) /
                            largest_velocity_error(solutions[2], reference)),
                        2.)
              << std::endl;
  }



  void
  study_unlocated(const TestCase &scene, const Solution &reference)
  {
    const auto error = [&](const unsigned int n, const bool is_located) {
      return std::abs(run(scene, "sdirk4", n, is_located).at(end_time)[0] -
                      reference.at(end_time)[0]);
    };
    deallog << "experiment " << scene.experiment
            << ", sdirk4 across contact times: u(1) of mean order: "
            << within(std::log2(error(50, false) / error(800, false)) / 4., 2.5)
            << ", 1000 times the error with contact times, over that error: "
            << within(1000. * error(400, true) / error(400, false), 1.)
            << std::endl;
  }
} // namespace



void
main_contact_orders()
{
  initlog();
  const std::array<TestCase, 2> scenes = {
    {{1, 0.01, {{0.16, 0.48, 2.}}, {{false, true, false}}},
     {5, 1., {{0.16, 0.8, 2.}}, {{false, true, false}}}}};
  for (const TestCase &scene : scenes)
    {
      const Solution reference = run(scene, "sdirk4", 3200, true);
      study(scene, "backward euler", 1, 400, reference);
      study(scene, "sdirk2", 2, 100, reference);
      study(scene, "sdirk3", 3, 200, reference);
      study(scene, "sdirk4", 4, 50, reference);
      study_unlocated(scene, reference);
    }
}
