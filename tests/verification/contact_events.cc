// SPDX-License-Identifier: LGPL-2.1-or-later
//
// Begin and end of contact with error-controlled steps: none is missed, none is
// found twice. Mesh of 4 cells of degree 5, 0 <= t <= 10; experiment 2 is
// experiment 1 with viscosity 1, experiment 5 the one with compliance 1.
//
// 1. 80 gaps, log-uniform in (1e-4, 0.3) (std::mt19937, seed = number of the
//    experiment), for each of experiments 1, 2, 5. The run with tolerance 1e-6
//    passes if
//      - events alternate, begin first, at ascending times, and the sign of the
//        gap at all ends of steps is what they say, but for excursions below
//        the tolerance of the displacement, d = 1e-6 max |u(1)|;
//      - a run with tolerance 1e-8 has the same events, with times that differ
//        by less than 1e-4, or than 2 d/|v|, v the velocity at the event: what
//        an error of 2 d moves a grazing event by;
//      - a run whose first step is longer by 1e-12 has the same events and
//        ends in the same state to the tolerance.
//    A begin and an end (or an end and a begin) with an excursion below d in
//    between are left aside in both lists. None of the 80 gaps has such a pair:
//    it needs a top within 1e-6 of the gap, which is rare.
// 2. 20 gaps with a rigid obstacle, tolerances 1e-5 and 1e-6, d = 1e-5 max
//    |u(1)|: the events alternate, agree in number, and no step end is beyond
//    the obstacle by more than d.
// 3. Scenes with a known start, experiment 1; all pass the test of part 1, too:
//      gap -0.05: in contact at t = 0, where contact begins with the velocity
//      u_1(1) = 0; at the end in contact, as all scenes with g < G = 0.1275,
//      where u(1) tends to G - (G - g)/(1 + eps) > g;
//      gap -0.05 and the velocity x: contact begins with 1;
//      gap 0.05 and 0, at rest: the heat alone pushes;
//      gap = top (1 + r), top the largest u(1) without an obstacle, found on
//      the cubic Hermite interpolant between step ends of tolerance 1e-9: no
//      contact for r = 1e-5; contact for r = -1e-5, for a time of 2 sqrt(2e-5
//      top / |u_tt(1)|) to 5 %; one contact or none for r = 0 and +-2e-7, where
//      the tolerance decides.
//    The mirror image of each start is the run, but for rounding.
// 4. Tolerance 0.1: steps have the largest size that is allowed, 1/64, but for
//    a quarter of it, 1/256, after a begin, and half of it after an end.
// 5. Runs that end d = 1e-4 before or behind the first begin t_1 or end t_2 of
//    contact, d being far less than a step: the events before the end of the
//    run at the times of a longer run, to its tolerance 1e-6; the last step
//    ends at the end of the run to the last digit.

#include <deal.II/base/mpi.h>

#include <cmath>
#include <random>

#include "../tests.h"

#include "../history.h"
#include "../mirror_image.h"

using namespace ThermoContact;

namespace
{
  /** Experiment 1, 2 or 5. */
  Parameters
  scene(const unsigned int experiment, const double gap)
  {
    Parameters parameters    = read_parameters("");
    parameters.mesh.cells    = 4;
    parameters.mesh.degree   = 5;
    parameters.contact.gap   = gap;
    parameters.time.scheme   = "sdirk4";
    parameters.time.end_time = 10.;
    if (experiment == 2)
      parameters.model.viscosity = 1.;
    if (experiment == 5)
      parameters.contact.law.at("Compliance") = 1.;
    return parameters;
  }



  bool
  same_end(const History &a, const History &b, const double tolerance)
  {
    return std::abs(a.last.displacement_end - b.last.displacement_end) <
             tolerance * a.max_displacement &&
           std::abs(a.last.velocity_end - b.last.velocity_end) <
             tolerance * a.max_velocity &&
           std::abs(a.last.temperature_end - b.last.temperature_end) <
             tolerance * 10.;
  }



  /** Part 1 for one scene; counts pairs that were left aside. */
  bool
  passes(Parameters parameters, unsigned int &n_with_tiny)
  {
    const double tolerance          = 1e-6;
    parameters.time.first_step_size = 1e-3;
    const History history           = run(parameters, tolerance);
    const History reference         = run(parameters, 1e-2 * tolerance);
    parameters.time.first_step_size = 1e-3 * (1. + 1e-12);
    const History perturbed         = run(parameters, tolerance);

    const double miss      = tolerance * history.max_displacement;
    const auto   events    = without_tiny(history, miss);
    const auto   expected  = without_tiny(reference, miss);
    const auto   as_before = without_tiny(perturbed, miss);
    const bool   is_consistent =
      history.is_complete && reference.is_complete &&
      alternate(history.events) && alternate(reference.events) &&
      wrong_side(history) < miss && wrong_side(reference) < miss;
    n_with_tiny += events.size() < history.events.size() ||
                   expected.size() < reference.events.size();
    const bool pass = is_consistent && agree(events, expected, miss) &&
                      agree(as_before, events, miss) &&
                      same_end(perturbed, history, tolerance);
    return pass;
  }



  void
  test_random_gaps(const unsigned int experiment)
  {
    const unsigned int                     n_gaps = 80;
    std::mt19937                           generator(experiment);
    std::uniform_real_distribution<double> uniform(std::log(1e-4),
                                                   std::log(0.3));
    unsigned int                           n_passed = 0, n_with_tiny = 0;
    for (unsigned int i = 0; i < n_gaps; ++i)
      n_passed +=
        passes(scene(experiment, std::exp(uniform(generator))), n_with_tiny);
    deallog << "experiment " << experiment << ": " << n_passed << " of "
            << n_gaps << " gaps, with tiny excursions " << n_with_tiny
            << std::endl;
  }



  void
  test_rigid_obstacle()
  {
    const unsigned int                     n_gaps = 20;
    std::mt19937                           generator(0);
    std::uniform_real_distribution<double> uniform(std::log(1e-4),
                                                   std::log(0.3));
    unsigned int                           n_complete = 0, n_passed = 0;
    for (unsigned int i = 0; i < n_gaps; ++i)
      {
        Parameters parameters        = scene(1, std::exp(uniform(generator)));
        parameters.contact.condition = "rigid";
        const History coarse         = run(parameters, 1e-5);
        const History fine           = run(parameters, 1e-6);
        const double  height         = 1e-5 * fine.max_displacement;
        n_complete += coarse.is_complete && fine.is_complete;
        const bool pass =
          coarse.is_complete && fine.is_complete && alternate(coarse.events) &&
          alternate(fine.events) && wrong_side(coarse) < height &&
          wrong_side(fine) < height &&
          same_kinds(without_tiny(coarse, height), without_tiny(fine, height));
        n_passed += pass;
      }
    deallog << "rigid obstacle: " << n_complete << " of " << n_gaps
            << " gaps run through, events of " << n_passed << std::endl;
  }



  void
  test_start(const std::string &name, const Parameters &parameters)
  {
    unsigned int  n_with_tiny = 0;
    const bool    pass        = passes(parameters, n_with_tiny);
    const History history     = run(parameters, 1e-6);
    MirrorImages  images;
    Simulation<1> simulation(parameters, MPI_COMM_SELF);
    images.run(simulation);
    deallog << name << ": passes " << pass << ", in contact at the end "
            << (history.events.size() % 2 == 1) << ", " << images.words(1e-12)
            << std::endl;
  }



  struct Top
  {
    double time = 0., displacement = 0., curvature = 0.;
  };



  /** Of u(1) without an obstacle. */
  Top
  top_of_free_swing(Parameters parameters)
  {
    parameters.contact.condition = "none";
    const History history        = run(parameters, 1e-9);
    Top           top;
    for (unsigned int i = 1; i < history.steps.size(); ++i)
      {
        const StepEnd &left = history.steps[i - 1], &right = history.steps[i];
        if (!(left.velocity > 0. && right.velocity <= 0.))
          continue;
        const double       size = right.time - left.time;
        const CubicHermite u(left.displacement,
                             size * left.velocity,
                             right.displacement,
                             size * right.velocity);
        double             low = 0., high = 1.;
        for (unsigned int j = 0; j < 60; ++j)
          {
            const double middle                 = 0.5 * (low + high);
            (u.slope(middle) > 0. ? low : high) = middle;
          }
        if (u.value(low) > top.displacement)
          top = {left.time + low * size,
                 u.value(low),
                 (right.velocity - left.velocity) / size};
      }
    return top;
  }



  void
  test_grazing()
  {
    Parameters parameters    = scene(1, 0.1);
    const Top  top           = top_of_free_swing(parameters);
    parameters.time.end_time = top.time + 0.5; // later tops are lower
    for (const double r : {1e-5, 2e-7, 0., -2e-7, -1e-5})
      {
        parameters.contact.gap    = top.displacement * (1. + r);
        unsigned int  n_with_tiny = 0;
        const bool    pass        = passes(parameters, n_with_tiny);
        const History history     = run(parameters, 1e-6);
        deallog << "grazing, r = " << r << ": passes " << pass;
        if (std::abs(r) == 1e-5)
          deallog << ", events " << history.events.size();
        else
          deallog << ", none or two events "
                  << (history.events.empty() || history.events.size() == 2);
        if (r == -1e-5 && history.events.size() == 2)
          {
            const double duration =
              history.events[1].time - history.events[0].time;
            const double expected =
              2. * std::sqrt(2. * top.displacement * 1e-5 / -top.curvature);
            deallog << ", duration "
                    << within(std::abs(duration / expected - 1.), 0.05);
          }
        deallog << std::endl;
      }
  }



  /** Part 4: steps of the largest size, but for the first after an event. */
  void
  test_first_steps()
  {
    Parameters parameters             = scene(1, 0.05);
    parameters.time.maximum_step_size = 1. / 64.;
    const History history             = run(parameters, 0.1);
    for (unsigned int i = 0; i + 1 < history.steps.size(); ++i)
      for (unsigned int event = 0; event < 2; ++event)
        if (std::abs(history.steps[i].time - history.events.at(event).time) <
            1e-4)
          deallog << (event == 0 ? "after begin " : "after end ")
                  << history.steps[i + 1].time - history.steps[i].time
                  << std::endl;
  }



  /** Part 5. */
  void
  test_last_step()
  {
    const Parameters parameters = scene(1, 0.05);
    const auto       expected   = run(parameters, 1e-6).events;
    for (const unsigned int i : {0, 1})
      for (const double d : {-1e-4, 1e-4})
        {
          Parameters shorter    = parameters;
          shorter.time.end_time = expected.at(i).time + d;
          const History history = run(shorter, 1e-6);
          double        error   = 0.;
          for (unsigned int j = 0; j < history.events.size(); ++j)
            raise(error,
                  std::abs(history.events[j].time - expected.at(j).time));
          deallog << "ends " << (d < 0. ? "before " : "behind ")
                  << (i == 0 ? "begin" : "end") << ": events "
                  << history.events.size() << ", times " << within(error, 1e-6)
                  << ", in contact " << history.last.in_contact
                  << (history.last.time == shorter.time.end_time ?
                        "" :
                        ", ends at another time")
                  << std::endl;
        }
  }
} // namespace



void
main_contact_events()
{
  initlog();
  for (const unsigned int experiment : {1, 2, 5})
    test_random_gaps(experiment);
  test_rigid_obstacle();

  const Parameters closed = scene(1, -0.05);
  test_start("closed at the start", closed);
  const ContactEvent first = run(closed, 1e-6).events.at(0);
  deallog << "  begins at t = 0 " << (first.time == 0.) << ", with velocity 0 "
          << within(std::abs(first.velocity), 1e-12) << std::endl;
  Parameters thrown              = closed;
  thrown.initial_values.velocity = "x";
  test_start("closed and thrown", thrown);
  for (const double gap : {0.05, 0.})
    {
      Parameters parameters              = scene(1, gap);
      parameters.initial_values.velocity = "0";
      test_start("at rest", parameters);
    }
  test_grazing();
  test_first_steps();
  test_last_step();
}
