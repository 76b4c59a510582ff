// SPDX-License-Identifier: LGPL-2.1-or-later
//
// Contact events, no mesh. All numbers by hand.
//
// 1. CubicHermite: cubics with known roots. A root where it becomes negative
//    counts, one where it touches zero or rises does not; "inf" without one, 0
//    if it is never positive. 16 (x - 1/4)(x - 1/2) has its minimum -1/4
//    between its roots, a dip above it is tolerated. (x - 0.995)^2 - 5e-5 is
//    still below zero at 1: then its dip counts from 0.995 on. At its ends the
//    slope is what was given, 1e-20 and -1e-20, whatever it is in between.
//    x - 3 has its zero in (0, 4), and none in (5, 9): the nearer end is 5.
// 2. EventLocator, gap 0.1, compliance 0.01, tolerance 1e-3, momentum 1. From
//    t = 1, u = 0 with u_t = 0.2 contact begins at 1.5. A step to t = 2 is to
//    be taken to there; one that was aimed ends the state if the miss s of u(1)
//    satisfies s^2 <= 0.2 eps |u_t| 1e-3 = 4e-7: 1e-4 does and 6.2e-4, 6.6e-4
//    and 1e-2 do not; the event is at 1.5 in all cases. Then u = 0.1 + 0.2 x -
//    0.4 x^2, x = t - 1.5, leaves the obstacle at t = 2 with u_t = -0.2. Rigid:
//    the pressure falls from 1 to -1 between t = 1 and 2, zero at 1.5; a step
//    that was aimed and ends with p = -5e-5, below 1e-4 of the largest
//    pressure, has its zero at 1 + 0.5/1.00005.
//    Without location: gap 0.3 to -0.1 between t = 1 and 2 has its zero
//    at 1.75, -0.1 to 0.1 between t = 2 and 4 at 3. Two nodes of which one
//    touches: neither open nor closed holds for both, so that the next step is
//    unilateral, and contact has begun once. An event at the start of a step
//    waits until a step is accepted, and is dropped if it is taken back. An
//    event is never before the last: begin at 1.5, found at the end 1.4995 of
//    its step, end of the next step at 1.4999, which counts as 1.5.
//    Without momentum a miss is 1e-5 of the smallest size: with the energy
//    5e-5 of the way sqrt(2 eps 5e-5) = 1e-3 on which the obstacle takes it,
//    1e-8; without mass of eps sqrt(2 5e-5) = 1e-4, 1e-9; of u = 0.1 if the
//    energy is large, 1e-6. A tenth above, and below, each. So it is where the
//    momentum does not count: 1e-4 is too much.
//    Rigid: nodes that touch at t = 0 with 0.2, stop, and are let go at once
//    begin contact with 0.2 and end it with 0 there.
//    Two stops, the rear one at -0.15, t = 1 + x: u = x - 1.6 x^2 meets the
//    front at 1/8 and the rear at 3/4, its mirror image the rear first, at (1 -
//    0.2)/3.2 = 1/4. u = -0.2 x, and -0.15 - 0.2 y + 0.4 y^2, y = t - 1.75:
//    contact with the rear one from 1.75 to 2.25. Two nodes, without location:
//    the second meets the front where its gap is 0.1 and then -0.1, at 1.5; at
//    2 it leaves for the rear, where the first has the gap 0.2 and -0.1 at 3,
//    so that it begins at 2 + 2/3, and 0.15 at 4: end at 3.4. Nodes in contact
//    at one time: those with pressure, and those nearer to the obstacle than
//    1e-5 of the largest displacement 0.1, as above: 0.9e-6 but not 1.1e-6;
//    1e-17 is rounding.

#include <thermocontact/contact/event_locator.h>
#include <thermocontact/method/bracketed_root.h>

#include <cmath>
#include <limits>

#include "../tests.h"

using namespace ThermoContact;

namespace
{
  /** Without rounding next to zero. */
  double
  clean(const double value)
  {
    return std::abs(value) < 1e-15 ? 0. : value;
  }



  /** The cubic with coefficients @p c. */
  CubicHermite
  cubic(const std::array<double, 4> &c)
  {
    return {c[0],
            c[1],
            c[0] + c[1] + c[2] + c[3],
            c[1] + 2. * c[2] + 3. * c[3]};
  }



  void
  print_first_zero(const std::string           &name,
                   const std::array<double, 4> &c,
                   const double                 dip = 0.)
  {
    const double zero = cubic(c).first_zero(dip);
    deallog << name << ": ";
    if (std::isinf(zero))
      deallog << "inf" << std::endl;
    else
      deallog << clean(zero) << std::endl;
  }



  void
  test_cubic()
  {
    print_first_zero("1 - 2x", {{1., -2., 0., 0.}});
    print_first_zero("1 - 2x^3", {{1., 0., 0., -2.}});
    print_first_zero("(0.2 - x)(x - 0.5)(x - 0.8)", {{0.08, -0.66, 1.5, -1.}});
    print_first_zero("two roots", {{2., -12., 16., 0.}});
    print_first_zero("two roots, dip 0.2", {{2., -12., 16., 0.}}, 0.2);
    print_first_zero("two roots, dip 0.3", {{2., -12., 16., 0.}}, 0.3);
    print_first_zero("dip of 5e-5 that goes on to the end, dip 1e-4",
                     {{0.989975, -1.99, 1., 0.}},
                     1e-4);
    print_first_zero("touches", {{0.25, -1., 1., 0.}});
    print_first_zero("grazes, -1e-6", {{0.249999, -1., 1., 0.}});
    print_first_zero("negative, recovers", {{-1., 4., 0., 0.}});
    print_first_zero("negative, recovers, root at 0.75",
                     {{-0.1875, 1., -1., 0.}});
    print_first_zero("negative, rises, never positive", {{-1., 0.5, 0., 0.}});
    print_first_zero("negative, never positive", {{-0.35, 1., -1., 0.}});
    print_first_zero("no root", {{1., 1., 0., 0.}});
    print_first_zero("rises from zero", {{0., 1., 0., 0.}});
    print_first_zero("falls from zero", {{0., -1., 0., 0.}});
    print_first_zero("falls from zero and comes back", {{0., -0.5, 1., 0.}});
    print_first_zero("falls to zero", {{1., -1., 0., 0.}});
    deallog << "zero near the end: 1.1 - x "
            << cubic({{1.1, -1., 0., 0.}}).zero_near_end() << ", 0.81 - x^2 "
            << cubic({{0.81, 0., -1., 0.}}).zero_near_end() << ", 0.3 - x "
            << cubic({{0.3, -1., 0., 0.}}).zero_near_end() << ", 1 "
            << cubic({{1., 0., 0., 0.}}).zero_near_end() << std::endl;
    const CubicHermite s = cubic({{1., 2., 3., 4.}});
    deallog << "1 + 2x + 3x^2 + 4x^3 at 1/2: " << s.value(0.5) << ", slope "
            << s.slope(0.5) << std::endl;
    const CubicHermite jump(1., 1e-20, 4., -1e-20);
    const auto         line = [](const double x) { return x - 3.; };
    deallog << "slopes of a jump at its ends: " << jump.slope(0.) * 1e20 << ' '
            << jump.slope(1.) * 1e20 << "; zero of x - 3 in (0, 4): "
            << bracketed_root(line, 0., 4.).first
            << ", in (5, 9): " << bracketed_root(line, 5., 9.).second
            << ", in (9, 9): " << bracketed_root(line, 9., 9.).first
            << std::endl;
    try
      {
        bracketed_root([](const double x) { return std::sqrt(-1. - x); },
                       0.,
                       4.);
      }
    catch (const ComputationError &error)
      {
        deallog << error.what() << std::endl;
      }
  }



  const double                            gap       = 0.1;
  const std::unique_ptr<const ContactLaw> compliant = make_law(0.01);
  const std::unique_ptr<const ContactLaw> rigid     = make_law(0.);



  const char *
  name_of(const ContactMode mode)
  {
    return mode == ContactMode::open   ? "open" :
           mode == ContactMode::closed ? "closed" :
                                         "unilateral";
  }



  /** Values of nodes that all move with @p velocity. */
  ContactValues
  values(const double               time,
         const std::vector<double> &displacement,
         const double               velocity,
         const std::vector<double> &pressure,
         const double rear_gap = std::numeric_limits<double>::infinity())
  {
    const std::size_t   n = displacement.size();
    std::vector<double> front(displacement), rear(displacement);
    for (double &s : front)
      s -= gap;
    for (double &s : rear)
      s = -s - rear_gap;
    return {time,
            displacement,
            {front, std::vector<double>(n, velocity)},
            {rear, std::vector<double>(n, -velocity)},
            pressure};
  }



  void
  print_events(const std::vector<ContactEvent> &events)
  {
    deallog << " events " << events.size();
    for (const ContactEvent &event : events)
      deallog << (event.kind == ContactEvent::begin ? ", begin " : ", end ")
              << clean(event.time) << " with u_t " << event.velocity
              << (event.side < 0 ? " behind" : "");
    deallog << std::endl;
  }



  /** Examines a step and does what the finding says. */
  void
  take(EventLocator              &locator,
       const ContactValues       &next,
       const bool                 is_aimed,
       std::vector<ContactEvent> &events,
       const BodyScales          &scales = {1., 1.})
  {
    const EventLocator::Finding finding =
      locator.examine(next, is_aimed, scales);
    deallog << "  to " << next.time << (is_aimed ? ", aimed: " : ": ");
    switch (finding.kind)
      {
        case EventLocator::Finding::at_start:
          deallog << "at start";
          locator.switch_at_start(finding.time);
          break;
        case EventLocator::Finding::within:
          deallog << "within, at " << finding.time;
          break;
        default:
          deallog << (finding.kind == EventLocator::Finding::at_end ?
                        "at end" :
                        "nothing");
          locator.accept(next, finding, events);
      }
    deallog << ", then " << name_of(locator.mode());
    print_events(events);
  }



  void
  test_compliant()
  {
    for (const double time : {1.5, 1.5005, 1.4995, 1.5031, 1.5033, 1.55})
      {
        deallog << "compliant:";
        EventLocator locator(*compliant, true, NodeOrder::inertial, 1e-3);
        std::vector<ContactEvent> events;
        locator.start(values(1., {0.}, 0.2, {0.}), events);
        take(locator, values(2., {0.2}, 0.2, {0.}), false, events);
        take(locator,
             values(time, {0.2 * (time - 1.)}, 0.2, {0.}),
             true,
             events);
        if (time == 1.4995)
          take(locator, values(1.4999, {0.1}, -0.05, {0.}), true, events);
        if (time != 1.5)
          continue;
        take(locator, values(1.75, {0.125}, 0., {2.5}), false, events);
        take(locator, values(2.5, {-0.1}, -0.6, {-20.}), false, events);
        take(locator, values(2., {0.1}, -0.2, {0.}), true, events);
        take(locator, values(2.5, {0.}, -0.2, {0.}), false, events);
      }
  }



  /** A step that ends @p miss beyond the obstacle. */
  void
  test_miss(const double miss, const NodeOrder nodes, const double energy)
  {
    EventLocator              locator(*compliant, true, nodes, 1e-3);
    std::vector<ContactEvent> events;
    locator.start(values(1., {0.}, 0.2, {0.}), events);
    take(locator,
         values(1.5 + miss / 0.2, {0.1 + miss}, 0.2, {0.}),
         true,
         events,
         {energy, 0.});
  }



  void
  test_misses()
  {
    deallog << "misses of 1e-8, 1e-9, 1e-6:";
    EventLocator locator(*compliant, true, NodeOrder::inertial, 1e-3, false);
    std::vector<ContactEvent> events;
    locator.start(values(1., {0.}, 0.2, {0.}), events);
    take(locator, values(1.5005, {0.1001}, 0.2, {0.}), true, events);
    for (const double factor : {0.9, 1.1})
      {
        test_miss(factor * 1e-8, NodeOrder::inertial, 5e-5);
        test_miss(factor * 1e-9, NodeOrder::viscous, 5e-5);
        test_miss(factor * 1e-6, NodeOrder::inertial, 1e9);
      }
  }



  void
  test_starts()
  {
    std::vector<ContactEvent> events;
    EventLocator locator(*compliant, true, NodeOrder::inertial, 1e-3);
    deallog << "closed at the start:";
    locator.start(values(0., {0.15}, -0.3, {5.}), events);
    deallog << "  " << name_of(locator.mode());
    print_events(events);

    deallog << "touches at the start:";
    locator.start(values(0., {0.1}, 0.2, {0.}), events);
    take(locator, values(1., {0.3}, 0.2, {0.}), false, events);
    take(locator, values(1., {0.2}, 0., {10.}), false, events);

    deallog << "neither open nor closed:";
    locator.start(values(0., {0.1 + 1e-7}, -1e-6, {0.}), events);
    take(locator, values(1., {0.3}, 0.2, {0.}), false, events);
    take(locator, values(1., {-0.1}, -0.2, {-20.}), false, events);
  }



  void
  test_rigid()
  {
    std::vector<ContactEvent> events;
    EventLocator              locator(*rigid, true, NodeOrder::inertial, 1e-3);
    deallog << "rigid:";
    locator.start(values(0., {0.1}, 0., {1.}), events);
    take(locator, values(1., {0.1}, 0., {1.}), false, events);
    take(locator, values(2., {0.1}, 0., {-1.}), false, events);
    take(locator, values(1.5, {0.1}, 0., {-5e-5}), true, events);

    deallog << "rigid, let go at once:";
    locator.start(values(0., {0.1}, 0.2, {0.}), events);
    take(locator, values(1., {0.3}, 0.2, {0.}), false, events);
    locator.release(values(0., {0.1}, 0., {0.}));
    take(locator, values(1., {0.05}, -0.1, {0.}), false, events);
  }



  void
  test_without_location()
  {
    std::vector<ContactEvent> events;
    EventLocator locator(*compliant, false, NodeOrder::inertial, 1e-3);
    deallog << "without location:";
    locator.start(values(1., {-0.2}, 0.5, {0.}), events);
    locator.accept(values(2., {0.2}, 0.7, {10.}), {}, events);
    locator.accept(values(4., {0.}, -0.3, {0.}), {}, events);
    deallog << "  " << name_of(locator.mode());
    print_events(events);
  }



  void
  test_closed_nodes()
  {
    std::vector<ContactEvent> events;
    EventLocator              locator(*rigid, true, NodeOrder::viscous, 1e-3);
    const auto                nodes =
      values(1.,
             {0.1 - 1e-3, 0.1, 0.1 - 1e-17, 0.1 - 0.9e-6, 0.1 - 1.1e-6, 0.05},
             0.,
             {2., 0., 0., 0., 0., 0.});
    locator.start(nodes, events);
    deallog << "closed nodes:";
    for (const bool is_closed : locator.closed_nodes(nodes))
      deallog << ' ' << is_closed;
    deallog << std::endl;
  }



  void
  test_two_stops()
  {
    deallog << "two stops:";
    for (const double v : {1., -1.})
      {
        std::vector<ContactEvent> events;
        EventLocator locator(*compliant, true, NodeOrder::inertial, 1e-3);
        locator.start(values(1., {0.}, v, {0.}, 0.15), events);
        take(locator,
             values(2., {-0.6 * v}, -2.2 * v, {0.}, 0.15),
             false,
             events);
      }
    std::vector<ContactEvent> events;
    EventLocator locator(*compliant, true, NodeOrder::inertial, 1e-3);
    locator.start(values(1., {0.}, -0.2, {0.}, 0.15), events);
    take(locator, values(1.75, {-0.15}, -0.2, {0.}, 0.15), true, events);
    take(locator, values(2., {-0.175}, 0., {-2.5}, 0.15), false, events);
    take(locator, values(2.25, {-0.15}, 0.2, {0.}, 0.15), true, events);

    EventLocator none(*compliant, false, NodeOrder::inertial, 1e-3);
    none.start(values(1., {-0.1, 0.}, 0.5, {0., 0.}, 0.15), events);
    none.accept(values(2., {0.05, 0.2}, 0.7, {0., 10.}, 0.15), {}, events);
    none.accept(values(3., {-0.25, -0.1}, -0.4, {-10., 0.}, 0.15), {}, events);
    none.accept(values(4., {0., 0.05}, 0.3, {0., 0.}, 0.15), {}, events);
    print_events(events);
  }



  void
  test_two_nodes()
  {
    std::vector<ContactEvent> events;
    EventLocator locator(*compliant, true, NodeOrder::inertial, 1e-3);
    deallog << "two nodes together:";
    locator.start(values(1., {0., 0.}, 0.2, {0., 0.}), events);
    take(locator, values(1.5, {0.1, 0.1}, 0.2, {0., 0.}), true, events);
    take(locator, values(2., {0.12, 0.15}, 0., {2., 5.}), false, events);

    deallog << "two nodes, one touches:";
    locator.start(values(1., {0., -0.1}, 0.2, {0., 0.}), events);
    take(locator, values(2., {0.2, 0.1}, 0.2, {0., 0.}), false, events);
    take(locator, values(1.5, {0.1, 0.}, 0.2, {0., 0.}), true, events);
    locator.accept(values(2., {0.12, 0.08}, 0.1, {2., 0.}), {}, events);
    deallog << "  one in contact, then " << name_of(locator.mode());
    print_events(events);
    locator.accept(values(2.2, {0.12, 0.11}, 0.1, {2., 1.}), {}, events);
    deallog << "  both in contact, then " << name_of(locator.mode());
    print_events(events);
  }
} // namespace



void
main_event_locator()
{
  initlog();
  test_cubic();
  test_compliant();
  test_misses();
  test_starts();
  test_rigid();
  test_without_location();
  test_two_stops();
  test_two_nodes();
  test_closed_nodes();
}
