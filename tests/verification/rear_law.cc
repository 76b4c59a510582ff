// SPDX-License-Identifier: LGPL-2.1-or-later
//
// A rear stop with a law of its own, doc/model.md (M4.3).
//
// 1. A mass 1/2 on a spring 1 (one cell, lumped), with velocity 1 between a
//    buffer in front, gap 1/10, eps = 3/10, d = 7/10, and a spring behind, gap
//    1/20, eps = 1/10. Between the four touches and ends of contact it swings
//    with sqrt(2), in front with the dashpot and the stiffness 1 + 1/0.3,
//    behind with 1 + 1/0.1: the times of all events, and the position at t
//    = 1.9, of order 4 by sdirk4; the mass leaves the spring with the velocity
//    with which it came.
// 2. Rods that are thrown at the one stop and come back to the other one, with
//    sdirk4 and box, power laws of different exponents, damping on one side:
//    each has its mirror image, with the laws exchanged, to rounding. So has a
//    strip.
// 3. Entries of the rear stop that say what those in front say change nothing.

#include <thermocontact/method/bracketed_root.h>

#include <cmath>

#include "../mirror_image.h"
#include "../oscillator.h"
#include "../recorded_run.h"

using namespace ThermoContact;

namespace
{
  MirrorImages images;

  const Overrides elastic = {"Model/Fields=displacement", "Model/Viscosity=0"};



  /** Times of the events, velocities of the last two, u at the end. */
  using Values = std::vector<double>;



  Values
  exact(const double t_end)
  {
    const double g = 0.1, eps = 0.3, d = 0.7, rear_gap = 0.05, rear_eps = 0.1;
    Values       values;
    Motion       m{0., 1.};
    double       t = 0.;
    // on until f vanishes, which it does once between the two times
    const auto go = [&](const double d,
                        const double k,
                        const double rest,
                        const double first,
                        const double last,
                        const auto  &f) {
      const auto at = [&](const double time) {
        return oscillation(d, k, rest, m, time);
      };
      const double way =
        bracketed_root([&](const double time) { return f(at(time)); },
                       first,
                       last)
          .first;
      m = at(way);
      t += way;
      values.push_back(t);
    };
    go(0., 1., 0., 0., 0.5, [&](const Motion &x) { return x.u - g; });
    const double k = 1. + 1. / eps;
    go(d, k, g / eps / k, 0.2, 1.5, [&](const Motion &x) {
      return 0. - (x.u - g) / eps - d * x.v;
    });
    go(0., 1., 0., 0., 1., [&](const Motion &x) {
      return 0. - x.u - rear_gap;
    });
    const double touch  = m.v;
    const double rear_k = 1. + 1. / rear_eps;
    go(0.,
       rear_k,
       -rear_gap / rear_eps / rear_k,
       0.2,
       1.,
       [&](const Motion &x) { return x.u + rear_gap; });
    values.push_back(touch);
    values.push_back(-touch);
    values.push_back(oscillation(0., 1., 0., m, t_end - t).u);
    return values;
  }



  const Overrides different = {"Contact/Gap=0.1",
                               "Contact/Compliance=0.3",
                               "Contact/Dashpot=0.7",
                               "Contact/Rear gap=0.05",
                               "Contact/Rear compliance=0.1",
                               "Contact/Rear dashpot=0"};



  void
  check_orders()
  {
    const double        end   = 2.2;
    const Values        right = exact(end);
    std::vector<Values> errors;
    for (const unsigned int n : {100, 200})
      {
        const RecordedRun result =
          run<1>("",
                 elastic + different +
                   Overrides{"Mesh/Cells=1",
                             "Mesh/Degree=1",
                             "Mesh/Mass matrix=lumped",
                             "Initial values/Velocity=x",
                             "Time/Scheme=sdirk4",
                             "Time/Locate contact events=true",
                             entry("Time/Step size", end / n),
                             entry("Time/End time", end)});
        if (result.events.size() != 4)
          {
            deallog << result.events.size() << " events" << std::endl;
            return;
          }
        Values found;
        for (const ContactEvent &event : result.events)
          found.push_back(event.time);
        found.push_back(result.events[2].velocity);
        found.push_back(result.events[3].velocity);
        found.push_back(result.rows.back().displacement_end);
        for (unsigned int i = 0; i < found.size(); ++i)
          found[i] = std::abs(found[i] - right[i]);
        errors.push_back(found);
      }
    deallog << "orders";
    for (unsigned int i = 0; i < right.size(); ++i)
      {
        const double rate = std::log2(errors[0][i] / errors[1][i]);
        deallog << ' ' << (rate > 3.7 ? 4. : rate);
      }
    double largest = 0.;
    for (const double error : errors[1])
      raise(largest, error);
    deallog << ", errors " << within(largest, 1e-6) << std::endl;
  }



  template <int dim>
  unsigned int
  mirror(const Overrides &scene)
  {
    Simulation<dim> simulation(read_parameters("", scene), MPI_COMM_SELF);
    images.run(simulation);
    unsigned int n_sides = 0;
    for (const int side : {1, -1})
      n_sides += std::any_of(simulation.events().begin(),
                             simulation.events().end(),
                             [side](const ContactEvent &event) {
                               return event.side == side;
                             });
    return n_sides;
  }



  void
  check_images()
  {
    const Overrides thrown =
      elastic + Overrides{"Initial values/Velocity=x", "Time/End time=5"};
    const Overrides power = {"Contact/Condition=power law",
                             "Contact/Exponent=1.5",
                             "Contact/Compliance=0.05",
                             "Contact/Damping=0.5",
                             "Contact/Gap=0.1",
                             "Contact/Rear gap=0.02",
                             "Contact/Rear exponent=1",
                             "Contact/Rear compliance=0.2",
                             "Contact/Rear damping=0"};
    const Overrides box   = {"Time/Scheme=box",
                             "Mesh/Degree=1",
                             "Mesh/Cells=100",
                             "Time/Step size=0.01"};
    const Overrides sdirk = {"Time/Scheme=sdirk4",
                             "Mesh/Cells=10",
                             "Mesh/Degree=4",
                             "Time/Tolerance=1e-6"};
    unsigned int    n     = 0;
    for (const Overrides &law : {different, power})
      for (const Overrides &scheme : {box, sdirk})
        n += mirror<1>(thrown + law + scheme);
    const Overrides springs = {"Contact/Gap=0.1",
                               "Contact/Compliance=0.3",
                               "Contact/Rear gap=0.05",
                               "Contact/Rear compliance=0.1",
                               "Time/Tolerance=1e-6"};
    const Overrides pulled  = {"Model/Inertia=0",
                               "Boundary/right/Traction=sin(3*t)",
                               "Time/End time=3"};
    n += mirror<1>(elastic + pulled + springs);
    n += mirror<1>(elastic + pulled + different +
                   Overrides{"Model/Viscosity=0.3", "Time/Tolerance=1e-6"});
    n += mirror<1>(thrown + springs + Overrides{"Contact/Massless nodes=on"});
    n += mirror<2>(thrown + different +
                   Overrides{"Dimension=2",
                             "Mesh/Cells=4",
                             "Mesh/Degree=2",
                             "Mesh/Cells across=2",
                             "Boundary/sides/Support=free",
                             "Time/Scheme=sdirk3",
                             "Time/Step size=0.02"});
    deallog << "stops that are met " << n << std::endl;
    deallog << images.words(1e-10) << std::endl;
  }



  void
  check_same()
  {
    const Overrides   scene = elastic + Overrides{"Initial values/Velocity=x",
                                                "Contact/Compliance=0.2",
                                                "Contact/Rear gap=0.02",
                                                "Time/Tolerance=1e-5",
                                                "Time/End time=4"};
    const RecordedRun one   = run<1>("", scene);
    const RecordedRun two =
      run<1>("", scene + Overrides{"Contact/Rear compliance=0.2"});
    deallog << "as in front: the same "
            << (difference(table_of(one.rows), table_of(two.rows)) == 0.)
            << std::endl;
  }
} // namespace



void
main_rear_law()
{
  initlog();
  check_orders();
  check_images();
  check_same();
}
