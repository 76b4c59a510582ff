// SPDX-License-Identifier: LGPL-2.1-or-later
//
// Rows whose contacts have laws of different kinds, Contacts/A B/Condition,
// doc/model.md section 10.
//
// 1. Three masses 1, 1, 3, the first with velocity 1, gaps 0 and 1, and an
//    obstacle at 1, as in rows.cc: one contact after the other, each with the
//    reduced mass m and the velocity w. The first, m = 1/2, w = 1, is elastic
//    with eps = 1/25: pi sqrt(m eps), largest force w sqrt(m/eps). The second,
//    m = 3/4, w = 1, is a power law with the exponent 3/2 and eps = 1/100: it
//    gives way by s = eps (5 m w^2/(4 eps))^(2/5), with the largest force
//    (s/eps)^(3/2) in the time 2 I s/w with I the integral of 1/sqrt(1 -
//    x^(5/2)) over [0, 1], sqrt(pi) Gamma(7/5)/Gamma(9/10). The third, m = 3, w
//    = 1/2, is elastic with eps = 9/100 (by sdirk4 with a tolerance of 1e-8),
//    or rigid with e = 1/2 (by box): then both events are one, the impulse is 3
//    (1 + e)/2.
// 2. A rod of length 1/2 with velocity 1 meets one at rest, b = Z = 1, in a
// rigid
//    contact, behind which an elastic obstacle, eps = 1/2, touches: the force
//    of the bodies is 1/2 until t = 1 and that of the obstacle 1 - exp(-2 (t -
//    1/2)) from t = 1/2 to 3/2. Its wave 2 exp(-x) - 1, x = 2 (t - 1), takes
//    the second rod from the first one and brings it back where x = 2 (1 -
//    exp(-x)), t = 1 + x/2: the force is 1/2 - exp(-x) from there on. By box,
//    of order 2.
// 3. A row whose contacts all have another kind of their own is that of section
//    Contact, to the last digit, with rigid contacts and power laws.
// 4. Three rods with a rigid and a damped contact have the forces of their
// mirror
//    image, by box to rounding.
// 5. Two rods at rest between a wall and a spring 1 at the right end, lengths
//    1/2: the contact of the two is rigid with an overlap of 1/10, the
//    obstacle, eps = 1/4, stands at 1/50. With the displacement u of the right
//    end and the pressures p, q of the two contacts: u = 1/10 - p, q = 4 (u -
//    1/50), p = u + q: p = 7/100, q = 1/25. The same with the displacement 1/10
//    of the wall in place of the overlap, of viscous rods in the end.
// 6. The audit of all kinds in one row, to rounding.

#include <algorithm>
#include <cmath>

#include "../recorded_run.h"
#include "../row_checks.h"

using namespace ThermoContact;

namespace
{
  const double pi = dealii::numbers::PI;

  const Overrides elastic = {"Model/Fields=displacement", "Model/Viscosity=0"};

  const Overrides free_ends = {"Boundary/left/Support=free",
                               "Boundary/right/Support=free"};

  const Overrides power = {"Contacts/b c/Condition=power law",
                           "Contacts/b c/Exponent=1.5",
                           "Contacts/b c/Compliance=0.01"};



  void
  check_masses(const bool is_box)
  {
    const Overrides kinds =
      is_box ? Overrides{"Contact/Condition=rigid",
                         "Contact/Restitution=0.5",
                         "Contacts/a b/Condition=normal compliance"} :
               Overrides{"Contact/Compliance=0.09"};
    const RecordedRun result =
      run<1>("",
             elastic + kinds + power + body("a", {"Kind=mass", "Velocity=1"}) +
               body("b", {"Kind=mass"}) + body("c", {"Kind=mass", "Mass=3"}) +
               Overrides{"Boundary/left/Support=free",
                         "Contact/Gap=1",
                         "Contacts/a b/Gap=0",
                         "Contacts/a b/Compliance=0.04",
                         is_box ? "Time/Scheme=box" : "Time/Scheme=sdirk4",
                         "Time/Tolerance=1e-8",
                         "Time/End time=6"});
    const double first = pi * std::sqrt(0.5 * 0.04);
    const double way   = 0.01 * std::pow(0.75 * 1.25 / 0.01, 0.4);
    const double second =
      2. * std::sqrt(pi) * std::tgamma(1.4) / std::tgamma(0.9) * way;
    const double third = is_box ? 0. : pi * std::sqrt(3. * 0.09);
    const double meet  = 1. + 0.5 * first;
    // the way of the centre of b and c during their contact, and so of both
    const double x       = 0.25 * second;
    const double back    = meet + second + (1. + x - 0.5 * first) / 0.5;
    const double ahead   = meet + second + (1. - x) / 0.5;
    double       times[] = {
            0., first, meet, meet + second, back, ahead, back + first, ahead + third};
    std::sort(std::begin(times), std::end(times));
    double time = 0., impulse = 0., force = 0.;
    for (unsigned int i = 0; i < 8 && i < result.events.size(); ++i)
      raise(time, std::abs(result.events[i].time - times[i]));
    const double impulses[] = {1.5, 1.5, is_box ? 2.25 : 3.},
                 forces[]   = {std::sqrt(0.5 / 0.04),
                               std::pow(way / 0.01, 1.5),
                               0.5 * std::sqrt(3. / 0.09)};
    for (unsigned int i = 0; i < 3; ++i)
      {
        double peak = 0.;
        for (const StepRecord &row : result.rows)
          raise(peak, row.contacts[i].contact_force);
        if (i < 2 || !is_box)
          raise(force, std::abs(peak / forces[i] - 1.));
        raise(impulse,
              std::abs(result.rows.back().contacts[i].contact_impulse -
                       impulses[i]));
      }
    deallog << (is_box ? "box" : "sdirk4") << ": events "
            << result.events.size() << ", times "
            << within(time, is_box ? 1e-4 : 1e-6) << ", impulses "
            << within(impulse, is_box ? 1e-11 : 1e-6) << ", forces "
            << within(force, 2e-3) << std::endl;
  }



  void
  check_rods()
  {
    double x = 1.6;
    for (unsigned int i = 0; i < 60; ++i)
      x = 2. * (1. - std::exp(-x));
    const auto of_bodies = [&](const double t) {
      return t < 1.           ? 0.5 :
             t < 1. + 0.5 * x ? 0. :
                                0.5 - std::exp(-2. * (t - 1.));
    };
    const auto of_obstacle = [](const double t) {
      return t < 0.5 ? 0. : 1. - std::exp(-2. * (t - 0.5));
    };
    double errors[2], ends[2];
    for (const unsigned int i : {0, 1})
      {
        const RecordedRun result =
          run<1>("",
                 elastic + body("a", {"Length=0.5", "Velocity=1"}) +
                   body("b", {"Length=0.5"}) +
                   Overrides{"Boundary/left/Support=free",
                             "Contact/Compliance=0.5",
                             "Contact/Gap=0",
                             "Contacts/a b/Condition=rigid",
                             entry("Mesh/Cells", 200 << i),
                             "Time/End time=1.99"});
        errors[i]             = 0.;
        const double fronts[] = {0., 0.5, 1., 1. + 0.5 * x};
        for (const StepRecord &row : result.rows)
          {
            // rows have the force of the end of a step
            if (row.time == 0. ||
                std::any_of(std::begin(fronts),
                            std::end(fronts),
                            [&](const double front) {
                              return std::abs(row.time - front) <
                                     2.5 * row.step_size;
                            }))
              continue;
            raise(errors[i],
                  std::abs(row.contacts[0].contact_force -
                           of_bodies(row.time)));
            if (row.time < 1.5)
              raise(errors[i],
                    std::abs(row.contacts[1].contact_force -
                             of_obstacle(row.time)));
          }
        ends[i] = 0.;
        std::vector<double> found;
        for (const ContactEvent &event : result.events)
          if (event.contact == 0)
            found.push_back(event.time);
        const double expected[] = {0., 1., 1. + 0.5 * x};
        for (unsigned int k = 0; k < 3 && k < found.size(); ++k)
          raise(ends[i], std::abs(found[k] - expected[k]));
        if (found.size() != 3)
          ends[i] = infinity;
      }
    deallog << "rods: forces " << within(errors[1], 1e-4) << ", of order 2 "
            << (errors[0] > 3. * errors[1] ? "yes" : "no") << ", events "
            << within(ends[1], 1e-4) << std::endl;
  }



  void
  check_same()
  {
    const Overrides rods = elastic + free_ends + body("a", {"Velocity=1"}) +
                           body("b", {"Section=2"}) + body("c", {"Length=1"}) +
                           Overrides{"Contact/Gap=0.1", "Time/End time=4"};
    for (const std::string condition : {"rigid", "power law"})
      {
        Overrides numbers = {"Compliance=0.1", "Exponent=2", "Damping=0.3"};
        Overrides all     = {"Contact/Condition=" + condition}, own;
        if (condition == "rigid")
          numbers.clear();
        for (const std::string &number : numbers)
          all.push_back("Contact/" + number);
        numbers.push_back("Condition=" + condition);
        for (const std::string pair : {"a b", "b c"})
          for (const std::string &number : numbers)
            own.push_back("Contacts/" + pair + '/' + number);
        const RecordedRun one = run<1>("", rods + all);
        const RecordedRun two = run<1>("", rods + own);
        deallog << condition << ": the same "
                << (difference(table_of(one.rows), table_of(two.rows)) == 0.)
                << ", events " << one.events.size() << ' ' << two.events.size()
                << std::endl;
      }
  }



  void
  check_images()
  {
    const Overrides common =
      elastic + free_ends + Overrides{"Contact/Gap=0.1", "Time/End time=6"};
    const auto pairs = [](const std::string &hard, const std::string &soft) {
      return Overrides{"Contacts/" + hard + "/Condition=rigid",
                       "Contacts/" + soft + "/Condition=power law",
                       "Contacts/" + soft + "/Damping=0.5",
                       "Contacts/" + soft + "/Compliance=0.1"};
    };
    const RecordedRun one =
      run<1>("",
             common + body("a", {"Velocity=1"}) + body("b", {"Section=2"}) +
               body("c", {"Length=1"}) + pairs("a b", "b c"));
    const RecordedRun two =
      run<1>("",
             common + body("c", {"Length=1"}) + body("b", {"Section=2"}) +
               body("a", {"Velocity=-1"}) + pairs("b a", "c b"));
    double difference = 0., impulse = 1.;
    for (unsigned int i = 0; i < std::min(one.rows.size(), two.rows.size());
         ++i)
      for (unsigned int c = 0; c < 2; ++c)
        raise(difference,
              std::abs(one.rows[i].contacts[c].contact_force -
                       two.rows[i].contacts[1 - c].contact_force));
    for (const ContactRecord &contact : one.rows.back().contacts)
      impulse = std::min(impulse, contact.contact_impulse);
    deallog << "mirror image: rows "
            << (one.rows.size() == two.rows.size() ? "as many" : "differ")
            << ", forces " << within(difference, 1e-9) << ", all met "
            << (impulse > 0.1 ? "yes" : "no") << std::endl;
  }



  void
  check_rest()
  {
    for (const bool is_viscous : {false, true})
      {
        const Overrides moved = {
          "Model/Viscosity=0.1",
          "Contacts/a b/Gap=0",
          "Boundary/left/Displacement=0.1*(1-exp(-5*t))"};
        const Overrides still = {"Model/Viscosity=0", "Contacts/a b/Gap=-0.1"};
        const RecordedRun result =
          run<1>("",
                 body("a", {"Length=0.5"}) + body("b", {"Length=0.5"}) +
                   Overrides{"Model/Fields=displacement",
                             "Model/Inertia=0",
                             "Boundary/right/Spring=1",
                             "Contact/Compliance=0.25",
                             "Contact/Gap=0.02",
                             "Contacts/a b/Condition=rigid",
                             "Time/Tolerance=1e-8",
                             "Time/End time=10"} +
                   (is_viscous ? moved : still));
        const StepRecord &last = result.rows.back();
        deallog << (is_viscous ? "viscous" : "static") << " rods: forces "
                << within(std::abs(last.contacts[0].contact_force - 0.07), 1e-9)
                << ", "
                << within(std::abs(last.contacts[1].contact_force - 0.04), 1e-9)
                << ", u(1) "
                << within(std::abs(last.displacement_end - 0.03), 1e-9)
                << ", audit " << within(audit(result.rows).defect, 1e-11)
                << std::endl;
      }
  }



  void
  check_audit()
  {
    for (const bool is_box : {true, false})
      {
        const RecordedRun result = run<1>(
          "",
          body("hammer",
               {"Kind=mass", "Mass=0.7", "Velocity=1", "Temperature=3"}) +
            body("a", {"Length=0.5", "Section=2", "Viscosity=0.5"}) +
            body("b", {"Length=0.4", "Density=2", "Stiffness=3"}) +
            body("c", {"Length=0.6", "Temperature=2*x"}) +
            Overrides{"Model/Coupling=0.3",
                      "Model/Viscosity=0.02",
                      "Boundary/left/Support=free",
                      "Boundary/left/Temperature=none",
                      "Boundary/right/Heat exchange=1+5*pressure",
                      is_box ? "Contact/Condition=rigid" :
                               "Contact/Dashpot=0.5",
                      "Contacts/hammer a/Condition=power law",
                      "Contacts/hammer a/Damping=0.5",
                      "Contacts/a b/Condition=normal compliance",
                      "Contact/Gap=0.05",
                      is_box ? "Time/Scheme=box" : "Time/Scheme=sdirk3",
                      "Time/Step size=0.01",
                      "Mesh/Cells=60",
                      "Time/End time=4"});
        deallog << "audit, " << (is_box ? "box" : "sdirk3") << ": defect "
                << within(audit(result.rows).defect, 1e-11) << ", all met "
                << std::all_of(result.rows.back().contacts.begin(),
                               result.rows.back().contacts.end(),
                               [](const ContactRecord &c) {
                                 return c.contact_impulse > 0.;
                               })
                << std::endl;
      }
  }
} // namespace



void
main_kinds_of_contacts()
{
  initlog();
  check_masses(true);
  check_masses(false);
  check_rods();
  check_same();
  check_images();
  check_rest();
  check_audit();
}
