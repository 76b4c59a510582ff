// SPDX-License-Identifier: LGPL-2.1-or-later
//
// Loads that jump within a step of the scheme box, which takes their mean over
// the step. b = 1, Z = 1, 20 cells, so that steps last 1/20; t0 = 0.12 is
// within the third one; written as if(t < t0, old, new) and as if(t <= t0, old,
// new). By d'Alembert a front of the pressure p behind which a rod moves with p
// takes a free end along with 2 p. All to 1e-12: behind a front that is spread
// over a cell the rod is where it is behind a sharp one.
//
// 1. Pressure p = 1/10 on the free left end from t0 on, the right one g = 3/100
//    from a rigid obstacle: it flies with 2 p from t0 + 1 on, contact begins at
//    t0 + 1 + g/(2 p) = 1.27, F = 2 p up to the echo of the left end at t0 + 3;
//    impulse at t = 2.9 2 p (2.9 - 1.27) = 0.326. Up to t = 1.25 the scheme has
//    taken no energy, and the impulse of the left end is then p (1.25 - t0) =
//    0.113.
// 2. Traction T = 1/10 on the right end from t0 on, g = 0.0172: it flies
//    with T, contact begins at t0 + g/T = 0.292, F = T up to the echo at t0 +
//    2; impulse at t = 2 T (2 - 0.292) = 0.1708.
// 3. A pulse of the pressure p from 0.11 to 0.13, within one step: u(1) = 2 p
//    0.02 = 0.004 behind it, at t = 1.5.
// 4. A body force f = 1/10 from t0 on, both ends free: u_t = f (t - t0), at t =
//    1 f 0.88 = 0.088.
// 5. A kink, p = (t - t0)/10 from t0 on: u(1) = (t - t0 - 1)^2/10, which is
//    0.01444 at t = 1.5.
// 6. 1 to 5 with heat, a = 0. Heat of 1 from t0 on, by a source in an insulated
//    rod, or through its right end: mean temperature t - t0, 0.88 at t = 1.
// 7. Two masses 1 in front of a clamped rod. The first one comes with the
//    velocity 1 over a gap of 0.0375 to the second one, which is beside the
//    rod: both contacts begin at 0.0375, in the first step, to 1e-11: they are
//    soft, so that the second one hardly moves its mass in this step (measured:
//    9e-14).
// 8. A pulse of 1/10 from t0 to 0.52 on a dashpot that takes all waves, Z = 1,
//    linear obstacle, eps = 0.02, 40 cells: s' = 0.2 - s/eps, then -s/eps, so
//    that the end comes to rest on the obstacle, by rounding before t = 5, and
//    contact begins once.

#include <array>
#include <cmath>

#include "../tests.h"

#include "../row_checks.h"
#include "../two_spellings.h"

using namespace ThermoContact;

namespace
{
  /** The runs of both spellings, @ in the entries. */
  std::array<RecordedRun, 2>
  runs_of_spellings(const Overrides &entries, const bool has_heat)
  {
    return run_both_spellings(Overrides{"Time/Scheme=box",
                                        "Model/Viscosity=0",
                                        "Mesh/Cells=20",
                                        "Boundary/left/Support=free",
                                        "Initial values/Velocity=0",
                                        "Output/Boundaries=true"} +
                              (has_heat ?
                                 Overrides{"Model/Coupling=0",
                                           "Boundary/left/Temperature=none",
                                           "Boundary/right/Heat exchange=0",
                                           "Initial values/Temperature=0"} :
                                 Overrides{"Model/Fields=displacement"}) +
                              entries);
  }



  /** Prints the largest error of a number of the runs, and how far they are
   * apart. */
  template <typename OfRun>
  void
  check(const std::string &name,
        const Overrides   &entries,
        const bool         has_heat,
        const OfRun       &of_run,
        const double       exact)
  {
    const auto runs  = runs_of_spellings(entries, has_heat);
    double     error = 0.;
    for (const RecordedRun &result : runs)
      raise(error, std::abs(of_run(result) - exact));
    deallog << name << (has_heat ? ", with heat: " : ": ")
            << within(error, 1e-12) << ", apart "
            << within(difference(table_of(runs[0].rows),
                                 table_of(runs[1].rows)),
                      1e-12)
            << std::endl;
  }



  void
  check_forces(const bool has_heat)
  {
    const auto begin = [](const RecordedRun &r) { return r.events.at(0).time; };
    const auto impulse = [](const RecordedRun &r) {
      return r.rows.back().contact_impulse;
    };
    const auto u = [](const RecordedRun &r) {
      return r.rows.back().displacement_end;
    };
    const Overrides pushed = {"Boundary/left/Traction=if(t@0.12,0,-0.1)",
                              "Contact/Condition=rigid",
                              "Contact/Gap=0.03"};
    check("pressure, begin",
          pushed + Overrides{"Time/End time=2.9"},
          has_heat,
          begin,
          1.27);
    check("pressure, impulse",
          pushed + Overrides{"Time/End time=2.9"},
          has_heat,
          impulse,
          0.326);
    check(
      "pressure, impulse of the left end",
      pushed + Overrides{"Time/End time=1.25"},
      has_heat,
      [](const RecordedRun &r) {
        return r.rows.back().boundaries.impulse_left;
      },
      0.113);
    check(
      "pressure, lost to the scheme",
      pushed + Overrides{"Time/End time=1.25"},
      has_heat,
      [](const RecordedRun &r) { return r.rows.back().numerical_dissipation; },
      0.);
    const Overrides pulled = {"Boundary/left/Support=clamped",
                              "Boundary/right/Traction=if(t@0.12,0,0.1)",
                              "Contact/Condition=rigid",
                              "Contact/Gap=0.0172",
                              "Time/End time=2"};
    check("traction, begin", pulled, has_heat, begin, 0.292);
    check("traction, impulse", pulled, has_heat, impulse, 0.1708);
    const Overrides free = {"Contact/Condition=none", "Time/End time=1.5"};
    check("pulse, u(1)",
          free +
            Overrides{"Boundary/left/Traction=if(t@0.11,0,if(t@0.13,-0.1,0))"},
          has_heat,
          u,
          0.004);
    check(
      "body force, u_t(1)",
      free +
        Overrides{"Sources/Body force=if(t@0.12,0,0.1)", "Time/End time=1"},
      has_heat,
      [](const RecordedRun &r) { return r.rows.back().velocity_end; },
      0.088);
    check("kink, u(1)",
          free + Overrides{"Boundary/left/Traction=if(t@0.12,0,0.012-0.1*t)"},
          has_heat,
          u,
          0.01444);
  }



  void
  check_masses()
  {
    const RecordedRun result =
      run<1>("",
             Overrides{"Time/Scheme=box",
                       "Model/Fields=displacement",
                       "Model/Viscosity=0",
                       "Mesh/Cells=20",
                       "Boundary/left/Support=free",
                       "Boundary/right/Support=clamped",
                       "Contact/Compliance=100",
                       "Contacts/a b/Gap=0.0375",
                       "Contacts/b c/Gap=0",
                       "Time/End time=0.1"} +
               body("a", {"Kind=mass", "Mass=1", "Velocity=1"}) +
               body("b", {"Kind=mass", "Mass=1"}) + body("c", {"Length=1"}));
    double time = 0.;
    for (const ContactEvent &event : result.events)
      raise(time, std::abs(event.time - 0.0375));
    deallog << "masses: " << result.events.size() << " contacts begin "
            << within(time, 1e-11) << std::endl;
  }



  void
  check_rest()
  {
    const auto runs = runs_of_spellings(
      {"Boundary/left/Dashpot=1",
       "Boundary/left/Traction=if(t@0.12,0,if(t@0.52,-0.1,0))",
       "Contact/Compliance=0.02",
       "Contact/Gap=0.03",
       "Mesh/Cells=40",
       "Time/End time=5"},
      false);
    for (const RecordedRun &result : runs)
      {
        unsigned int n_begins = 0;
        for (const ContactEvent &event : result.events)
          n_begins += event.kind == ContactEvent::begin;
        deallog << "comes to rest: contact begins " << n_begins
                << ", beside the obstacle by "
                << within(std::abs(result.rows.back().displacement_end - 0.03),
                          1e-12)
                << std::endl;
      }
  }
} // namespace



void
main_box_jumps()
{
  initlog();
  for (const bool has_heat : {false, true})
    check_forces(has_heat);
  for (const std::string path :
       {"Sources/Heat source", "Boundary/right/Heat flux"})
    check(
      path,
      {path + "=if(t@0.12,0,1)", "Contact/Condition=none", "Time/End time=1"},
      true,
      [](const RecordedRun &r) { return r.rows.back().temperature_mean; },
      0.88);
  check_masses();
  check_rest();
}
