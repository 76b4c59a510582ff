// SPDX-License-Identifier: LGPL-2.1-or-later
//
// A row whose right end stands between two stops, Contact/Rear gap,
// doc/model.md sections 4 and 10.
//
// 1. A mass 1 with velocity 1 between springs eps = 1/25 at g = 3/10 and eps =
//    1/100 at g_2 = 1/5: it flies for 3/10, is in front for pi/5 with the
//    largest force 5, flies back for 1/2, is behind for pi/10 with the force
//    -10, and so on with the period 1 + 3 pi/10: the times of six events, their
//    velocities 1, -1, -1, 1, 1, -1, the impulse 2 - 2 + 2 behind the last of
//    them. By sdirk4 with a tolerance of 1e-8, whose steps end at each event,
//    and by box of order 2. The same with a second mass in the row, far behind.
// 2. The row of one rod is the rod of section Model: events and columns are the
//    same to rounding, with both schemes, elastic, damped and rigid stops,
//    without inertia, and with heat that depends on the stops. (Of a rigid stop
//    by box alone: impacts that are located multiply rounding.)
// 3. Mirror images: a mass and a rod, with the stops exchanged, to rounding.
// 4. A rigid mass with e = 1/2 between rigid stops at 3/10 and 1/5: impacts at
//    3/10, 13/10 and 33/10 with the velocities 1, -1/2, 1/4. The mass 3, thrown
//    with 2 from the rear stop at g_2 = 3/4 against the gravity 2 to the other
//    one at 3/4, meets it at 1/2 with 1, the rear one at 3/2 with 5/2, and
//    rests there from 4 on with the pressure -6: the impulse is 6 - 6 t. Before
//    an obstacle that comes with 1/2 from 9/10 a mass with velocity 1 meets it
//    at 3/5 with 3/2, seen from it, the rear one at 6/5 + 1/25 with 5/4, and
//    the other one at 5/3 with 9/8. The energy of all impacts is booked.
// 5. Two rods, the second one between stops behind the contact of the two,
// which
//    both are met: the audit, to rounding.

#include <algorithm>
#include <cmath>

#include "../mirror_image.h"
#include "../recorded_run.h"
#include "../row_checks.h"

using namespace ThermoContact;

namespace
{
  const double pi = dealii::numbers::PI;

  const Overrides elastic = {"Model/Fields=displacement", "Model/Viscosity=0"};

  const Overrides springs = {"Contact/Gap=0.3",
                             "Contact/Compliance=0.04",
                             "Contact/Rear gap=0.2",
                             "Contact/Rear compliance=0.01"};

  const Overrides flying = elastic + Overrides{"Boundary/left/Support=free"} +
                           body("m", {"Kind=mass", "Mass=1", "Velocity=1"});



  void
  check_mass(const std::string &name,
             const Overrides   &scene,
             const double       bound)
  {
    const RecordedRun result = run<1>("", scene);
    const double      front = 0.2 * pi, rear = 0.1 * pi;
    const double      times[]      = {0.3,
                                      0.3 + front,
                                      0.8 + front,
                                      0.8 + front + rear,
                                      1.3 + front + rear,
                                      1.3 + 2. * front + rear};
    const double      velocities[] = {1., -1., -1., 1., 1., -1.};
    double time = 0., velocity = 0., least = 0., most = 0., energy = 0.;
    for (unsigned int i = 0; i < 6 && i < result.events.size(); ++i)
      {
        const ContactEvent &event = result.events[i];
        raise(time, std::abs(event.time - times[i]));
        raise(velocity, std::abs(event.velocity - velocities[i]));
        if (event.side != (i == 2 || i == 3 ? -1 : 1))
          deallog << "event " << i << " at the other stop" << std::endl;
      }
    for (const StepRecord &row : result.rows)
      {
        raise(most, row.contacts.back().contact_force);
        least = std::min(least, row.contacts.back().contact_force);
        raise(energy, std::abs(row.energy - 0.5));
      }
    const ContactRecord &last = result.rows.back().contacts.back();
    deallog << name << ": events " << result.events.size() << ", times "
            << within(time, bound) << ", velocities "
            << within(velocity, 10. * bound) << ", forces "
            << within(std::max(std::abs(most / 5. - 1.),
                               std::abs(least / 10. + 1.)),
                      2e-3)
            << ", impulse "
            << within(std::abs(last.contact_impulse - 2.), bound) << ", energy "
            << within(energy, 10. * bound) << std::endl;
  }



  void
  check_period()
  {
    const Overrides far = {"Bodies/far/Kind=mass"};
    for (const std::string scheme : {"sdirk4", "box"})
      {
        const Overrides common = springs + Overrides{"Time/Scheme=" + scheme,
                                                     "Time/Tolerance=1e-8",
                                                     "Time/End time=2.9"};
        const double    bound  = scheme == "box" ? 1e-4 : 1e-7;
        check_mass("mass, " + scheme, flying + common, bound);
        check_mass("behind another one, " + scheme,
                   far + flying + common + Overrides{"Contacts/far m/Gap=10"},
                   bound);
      }
  }



  /** Largest difference of the columns that a rod and a row share; of them the
   * energy relative to its profile and the velocity behind a front are others.
   */
  double
  difference_of_runs(const RecordedRun &rod, const RecordedRun &row)
  {
    if (rod.rows.size() != row.rows.size() ||
        rod.events.size() != row.events.size())
      return infinity;
    // where contact begins rounding decides whether it has begun
    const auto is_pressed = [](const StepRecord &r) {
      return std::max(r.penetration, std::abs(r.contact_force)) > 1e-12;
    };
    const auto table = [&is_pressed](const RecordedRun &run) {
      Columns columns;
      for (const StepRecord &r : run.rows)
        columns.push_back({r.time,
                           r.displacement_end,
                           r.gap,
                           r.penetration,
                           r.contact_force,
                           r.contact_impulse,
                           is_pressed(r) && r.in_contact ? 1. : 0.,
                           r.temperature_end,
                           r.heat_flux_end,
                           r.contact_dissipation,
                           r.numerical_dissipation,
                           r.energy_terms.elastic,
                           r.energy_terms.kinetic,
                           r.energy_terms.obstacle});
      return columns;
    };
    double largest = difference(table(rod), table(row));
    // what the row says of the contact alone
    for (const StepRecord &r : row.rows)
      if (const ContactRecord &contact = r.contacts[0];
          contact.gap != r.gap || contact.contact_force != r.contact_force ||
          contact.contact_impulse != r.contact_impulse ||
          contact.in_contact != r.in_contact)
        largest = infinity;
    raise(largest,
          difference(signed_table(rod.events, 1.),
                     signed_table(row.events, 1.)));
    return largest;
  }



  void
  check_rod()
  {
    const Overrides stops  = {"Contact/Gap=0.1", "Contact/Rear gap=0.05"};
    const Overrides power  = {"Contact/Condition=power law",
                              "Contact/Compliance=0.05",
                              "Contact/Damping=0.5",
                              "Contact/Rear exponent=1",
                              "Contact/Rear compliance=0.2",
                              "Contact/Rear damping=0"};
    const Overrides buffer = {"Contact/Compliance=0.3",
                              "Contact/Dashpot=0.7",
                              "Contact/Rear compliance=0.1",
                              "Contact/Rear dashpot=0"};
    const Overrides rigid  = {"Contact/Condition=rigid"};
    const Overrides box    = {"Time/Scheme=box",
                              "Mesh/Degree=1",
                              "Time/Step size=0.02"};
    const Overrides sdirk  = {"Time/Scheme=sdirk4",
                              "Mesh/Degree=3",
                              "Time/Locate contact events=true",
                              "Time/Step size=0.02"};
    const Overrides thrown = elastic + Overrides{"Time/End time=5"};
    const Overrides pulled =
      elastic + Overrides{"Model/Inertia=0",
                          "Boundary/right/Traction=sin(3*t)",
                          "Time/End time=3"};
    const Overrides hot     = {"Model/Coupling=0.3",
                               "Boundary/left/Temperature=1",
                               "Boundary/right/Heat exchange=1/(1+20*gap)+pressure",
                               "Time/End time=4"};
    double          largest = 0.;
    unsigned int    n = 0, n_sides = 0;
    for (const Overrides &scene : {thrown + power + box,
                                   thrown + power + sdirk,
                                   thrown + buffer + box,
                                   thrown + buffer + sdirk,
                                   thrown + rigid + box,
                                   pulled + sdirk,
                                   pulled + rigid + sdirk,
                                   hot + box,
                                   hot + sdirk})
      {
        const auto has = [&scene](const std::string &entry) {
          return std::find(scene.begin(), scene.end(), entry) != scene.end();
        };
        const std::string cells = has("Time/Scheme=box") ? "50" : "10";
        Overrides of_rod{"Mesh/Cells=" + cells}, of_row{"Cells=" + cells};
        if (!has("Model/Inertia=0"))
          {
            of_rod.emplace_back("Initial values/Velocity=x");
            if (!has("Time/Scheme=box"))
              of_rod.emplace_back("Contact/Massless nodes=off");
            of_row.emplace_back("Velocity=x");
          }
        if (has("Model/Coupling=0.3"))
          {
            of_rod.emplace_back("Initial values/Temperature=1-x");
            of_row.emplace_back("Temperature=1-x");
          }
        const RecordedRun rod = run<1>("", stops + scene + of_rod);
        const RecordedRun row = run<1>("", stops + scene + body("rod", of_row));
        raise(largest, difference_of_runs(rod, row));
        ++n;
        for (const int side : {1, -1})
          n_sides += std::any_of(row.events.begin(),
                                 row.events.end(),
                                 [side](const ContactEvent &event) {
                                   return event.side == side;
                                 });
      }
    deallog << n << " rods and their rows: " << noise_within(largest, 1e-9)
            << ", stops that are met " << n_sides << std::endl;
  }



  void
  check_images()
  {
    MirrorImages    images;
    const Overrides rod    = elastic + body("rod", {"Velocity=x"});
    const Overrides step   = {"Time/Scheme=sdirk4", "Time/Tolerance=1e-6"};
    const Overrides rigid  = {"Contact/Condition=rigid",
                              "Contact/Gap=0.1",
                              "Contact/Rear gap=0.05"};
    const Overrides bounce = rigid + Overrides{"Contact/Restitution=0.7"};
    for (const Overrides &scene :
         {flying + springs + step,
          flying + springs,
          flying + bounce + Overrides{"Sources/Body force=-0.4"},
          rod + springs + step,
          rod + springs,
          rod + rigid})
      {
        Simulation<1> simulation(
          read_parameters("", scene + Overrides{"Time/End time=4"}),
          MPI_COMM_SELF);
        images.run(simulation);
      }
    deallog << images.words(1e-9) << std::endl;
  }



  /** Impacts of a rigid mass: times and velocities, in turn at both stops. */
  void
  check_bounces(const std::string                            &name,
                const Overrides                              &scene,
                const std::vector<std::pair<double, double>> &impacts,
                const double                                  impulse)
  {
    const RecordedRun result = run<1>("",
                                      elastic + scene +
                                        Overrides{"Boundary/left/Support=free",
                                                  "Contact/Condition=rigid",
                                                  "Contact/Restitution=0.5"});
    double            time = 0., velocity = 0.;
    int               side = 1;
    for (unsigned int i = 0; i < impacts.size(); ++i, side = -side)
      for (const unsigned int j : {2 * i, 2 * i + 1})
        {
          const ContactEvent &event = result.events.at(j);
          raise(time, std::abs(event.time - impacts[i].first));
          raise(velocity,
                std::abs(event.velocity -
                         (j % 2 == 0 ? 1. : -0.5) * impacts[i].second));
          if (event.side != side)
            deallog << "event " << j << " at the other stop" << std::endl;
        }
    const StepRecord &last = result.rows.back();
    deallog << name << ": times " << within(time, 1e-12) << ", velocities "
            << within(velocity, 1e-11) << ", impulse "
            << within(std::abs(last.contact_impulse - impulse), 1e-10)
            << ", energy "
            << within(std::abs(result.rows[0].energy + last.work - last.energy -
                               last.contact_dissipation),
                      1e-11)
            << ", force " << last.contact_force << ", last begin "
            << (last.contact_force == 0. ?
                  result.events.at(result.events.size() - 2).time :
                  result.events.back().time)
            << std::endl;
  }



  void
  check_restitution()
  {
    const Overrides mass = {"Kind=mass", "Mass=1", "Velocity=1"};
    check_bounces("rigid stops",
                  body("m", mass) + Overrides{"Contact/Gap=0.3",
                                              "Contact/Rear gap=0.2",
                                              "Time/End time=4"},
                  {{0.3, 1.}, {1.3, -0.5}, {3.3, 0.25}},
                  1.5 - 0.75 + 0.375);
    check_bounces("against gravity",
                  body("m", {"Kind=mass", "Mass=3", "Velocity=2"}) +
                    Overrides{"Contact/Gap=0.75",
                              "Contact/Rear gap=0.75",
                              "Sources/Body force=-2",
                              "Time/End time=5"},
                  {{0.5, 1.}, {1.5, -2.5}},
                  6. - 6. * 5.);
    check_bounces("an obstacle that comes",
                  body("m", mass) + Overrides{"Contact/Gap=0.9-0.5*t",
                                              "Contact/Rear gap=0.2",
                                              "Time/End time=1.8"},
                  {{0.6, 1.5}, {1.24, -1.25}, {5. / 3., 1.125}},
                  1.5 * (1.5 - 1.25 + 1.125));
  }



  void
  check_audit()
  {
    for (const std::string scheme : {"box", "sdirk3"})
      {
        const RecordedRun result =
          run<1>("",
                 body("a", {"Length=0.5", "Velocity=2*x", "Temperature=1-x"}) +
                   body("b", {"Length=0.5", "Section=2"}) +
                   Overrides{"Model/Coupling=0.3",
                             "Model/Viscosity=0.01",
                             "Contact/Compliance=0.02",
                             "Contact/Gap=0.03",
                             "Contact/Rear gap=0.01",
                             "Contact/Rear compliance=0.05",
                             "Contacts/a b/Gap=0.02",
                             "Sources/Body force=0.4*cos(3*t)",
                             "Boundary/left/Temperature=1",
                             "Boundary/right/Heat exchange=1+5*pressure",
                             "Time/Scheme=" + scheme,
                             "Time/Step size=0.01",
                             "Mesh/Cells=40",
                             "Time/End time=5"});
        bool is_at_rear = false;
        for (const ContactEvent &event : result.events)
          is_at_rear = is_at_rear || (event.side < 0 && event.contact == 1);
        bool is_behind = false;
        for (const ContactEvent &event : result.events)
          is_behind = is_behind || (event.side < 0 && event.contact == 0);
        deallog << "audit, " << scheme << ": defect "
                << within(audit(result.rows).defect, 1e-11)
                << ", rear stop met " << (is_at_rear ? "yes" : "no")
                << ", by the first rod " << (is_behind ? "yes" : "no")
                << std::endl;
      }
  }
} // namespace



void
main_stops_of_rows()
{
  initlog();
  check_period();
  check_rod();
  check_images();
  check_restitution();
  check_audit();
}
