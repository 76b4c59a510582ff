// SPDX-License-Identifier: LGPL-2.1-or-later
//
// Error bars of the scheme without dispersion contain closed solutions, with
// all settings of the numerics at their defaults, and are not larger than 1 per
// cent of what they belong to. b = 1, no viscosity, Z = 1.
//
// 1. A wall that moves with 0.01 into a rod at rest, d'Alembert: force 0.01,
//    impulse 0.0175 at t = 1.75.
// 2. A rod that is let go at -x/2 meets a rigid stop at 0 at t = 1 with 1/2,
//    leaves at t = 2 with -1/2: duration 1, force and impulse 1/2,
//    restitution 1.
// 3. A rod under gravity f = 1, rigid at g = 0.3, d'Alembert: what comes to the
//    end is the triangle w_0 = t, 2 - t, t - 4, ... and with the force P on it
//    comes w = w_0 + 2 P(t - 2) - 2 P(t - 4) + ... In contact P = w, until
//    it falls below 0; in flight the end moves with w. So contact begins at
//      0.6^(1/2) ,  4 - 0.8^(1/2) ,  6 - 0.2^(1/2) ,  8 + 0.4^(1/2) ,  11 ,
//    ends at 2, 4 + 0.6^(1/2), 8 - 0.8^(1/2), 10 - 0.2^(1/2), and P vanishes
//    for an instant at 4 and 6. P rises and falls with slopes 1 and -1 between
//    0 and 1, which it reaches at t = 1, 7, 9 and 11: its impulse is 0.7 in
//    each of the first four contacts and 0.5 in the last one until t = 12, 3.3
//    in all. The begins are right to 1e-3, and no row of the force, rows of
//    which differ by 1/640, is below both of its neighbours by more than 1e-2.
// 4. A rod thrown with x at a spring, gap 0: s' = 1 - t - s/eps until t = 2,
//    largest force 1 - eps log(1 + 1/eps), final displacement at t = 1/2
//    eps ((1 + eps) (1 - exp(-1/(2 eps))) - 1/2). eps = 0.1 and 0.01, which the
//    mesh resolves, and 1e-4.
// 5. The last one until it has left twice. First p = 1 - t + eps - (1 + eps)
//    exp(-t/eps) until t = 1 + eps, impulse (1 - eps^2)/2. What comes to the
//    end from t = 2 on is 2 p - 1 + t of the time before, t counted from 2,
//    which takes the end to the spring at t = 1 + eps with eps: p grows with
//    slope 1 to 1 - eps at t = 2. Then (2 + 2 y) exp(-y) - 1 + O(eps), y the
//    time over eps, until (1 + y) exp(-y) = 1/2, y = 1.678, impulse 0.949 eps.
//    Together 1 - 0.051 eps, which the mesh does not see: it is within the time
//    eps.
// 6. A rod whose last 203.5/640 fly with 1 at a spring, eps = 0.3, gap 0: s' =
// 1
//    - s/eps until what rests arrives in the middle of a step, largest force 1
//    - exp(-203.5/(640 eps)). The steps of both repeats end at the end of that
//    one, so that all three miss the same.
// 7. That of 4 with b = 4, thrown with x/2 for twice the time: the same rod in
//    another unit of time. Bars of displacements and forces are the same, to
//    1e-6 of them, those of times and impulses twice as large.

#include <thermocontact/report/key_results.h>
#include <thermocontact/simulation/simulation.h>
#include <thermocontact/study/error_bars.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <string>

#include "../tests.h"

#include "../overrides.h"

using namespace ThermoContact;

namespace
{
  const Overrides rod = {"Model/Fields=displacement",
                         "Model/Viscosity=0",
                         "Contact/Gap=0",
                         "Initial values/Velocity=0"};



  /** Forces of all steps. */
  std::vector<double>
  check(const std::string                   &name,
        const Overrides                     &overrides,
        const std::map<std::string, double> &exact)
  {
    Simulation<1>       simulation(read_parameters("", rod + overrides),
                             MPI_COMM_SELF);
    std::vector<double> forces;
    simulation.run({[&forces](const Simulation<1> &s) {
      forces.push_back(s.record().contact_force);
    }});
    Log             log(false, true);
    const KeyErrors errors = error_bars(
      simulation, []() {}, log);
    const KeyResults values =
      key_results(simulation.scene(), simulation.history());
    deallog << name << " by " << simulation.parameters().time.scheme;
    for (const auto &[key, truth] : exact)
      {
        const double bar   = errors.space.at(key);
        const double error = std::abs(values.at(key) - truth);
        deallog << ", " << key;
        // an error of first order is half of that of half as many cells
        if (error <= bar * (1. + 1e-6) && bar <= 0.01 * std::abs(truth))
          deallog << " contained";
        else
          deallog << ' ' << values.at(key) << " +- " << bar << " for " << truth;
      }
    deallog << std::endl;
    if (name == "falls")
      {
        const double begins[] = {std::sqrt(0.6),
                                 4. - std::sqrt(0.8),
                                 6. - std::sqrt(0.2),
                                 8. + std::sqrt(0.4),
                                 11.};
        double       largest  = 0.;
        for (const double begin : begins)
          {
            double nearest = 12.;
            for (const ContactEvent &event : simulation.events())
              if (event.kind == ContactEvent::begin)
                nearest = std::min(nearest, std::abs(event.time - begin));
            raise(largest, nearest);
          }
        deallog << "begins " << noise_within(largest, 1e-3) << std::endl;
      }
    return forces;
  }



  /** The largest relative difference of bars of one rod in two units of time.
   */
  void
  check_unit_of_time()
  {
    KeyResults bars[2];
    for (const unsigned int i : {0, 1})
      {
        const double  unit = i + 1.;
        Simulation<1> simulation(
          read_parameters("",
                          rod + Overrides{entry("Model/Inertia", unit * unit),
                                          "Contact/Compliance=1e-4",
                                          "Initial values/Velocity=x/" +
                                            number(unit),
                                          entry("Time/End time", 4.6 * unit)}),
          MPI_COMM_SELF);
        simulation.run();
        Log log(false, true);
        bars[i] = error_bars(
                    simulation, []() {}, log)
                    .space;
      }
    double       difference = 0.;
    unsigned int n          = 0;
    for (const auto &[key, bar] : bars[0])
      if (const double factor = key.find("time") != key.npos ||
                                    key.find("duration") != key.npos ||
                                    key.find("impulse") != key.npos ?
                                  2. :
                                  1.;
          bar > 0.)
        {
          raise(difference, std::abs(bars[1].at(key) / (factor * bar) - 1.));
          ++n;
        }
    deallog << "in another unit of time: " << n << " bars, difference "
            << within(difference, 1e-6) << std::endl;
  }



  /** By how much a force is below both of its neighbours. */
  double
  largest_dip(const std::vector<double> &forces)
  {
    double largest = 0.;
    for (unsigned int i = 1; i + 1 < forces.size(); ++i)
      raise(largest, std::min(forces[i - 1], forces[i + 1]) - forces[i]);
    return largest;
  }
} // namespace



void
main_box_bars()
{
  initlog();
  const Overrides rigid = {"Contact/Condition=rigid"};
  check("wall",
        rigid + Overrides{"Contact/Gap=-0.01*t", "Time/End time=1.75"},
        {{"contact_impulse", 0.0175}, {"max_contact_force", 0.01}});
  check("let go",
        rigid +
          Overrides{"Initial values/Displacement=-0.5*x", "Time/End time=2.9"},
        {{"first_contact_time", 1.},
         {"contact_duration", 1.},
         {"contact_impulse", 0.5},
         {"max_contact_force", 0.5},
         {"restitution", 1.}});
  const double touches[] = {std::sqrt(0.6),
                            std::sqrt(0.8),
                            std::sqrt(0.2),
                            std::sqrt(0.4)};
  const auto   forces    = check(
    "falls",
    rigid +
      Overrides{"Contact/Gap=0.3", "Sources/Body force=1", "Time/End time=12"},
    {{"first_contact_time", touches[0]},
          {"contact_duration",
           (2. - touches[0]) + (touches[0] + touches[1]) +
             (2. - touches[1] + touches[2]) + (2. - touches[2] - touches[3]) + 1.},
          {"contact_impulse", 3.3},
          {"max_contact_force", 1.}});
  deallog << "dip " << noise_within(largest_dip(forces), 1e-2) << std::endl;

  for (const double compliance : {0.1, 0.01, 1e-4})
    check("thrown, eps " + std::to_string(compliance),
          {entry("Contact/Compliance", compliance),
           "Initial values/Velocity=x",
           "Time/End time=0.5"},
          {{"max_contact_force",
            1. - compliance * std::log(1. + 1. / compliance)},
           {"final_displacement_end",
            compliance *
              ((1. + compliance) * (1. - std::exp(-0.5 / compliance)) - 0.5)}});
  check("thrown twice",
        {"Contact/Compliance=1e-4",
         "Initial values/Velocity=x",
         "Time/End time=4.6"},
        {{"contact_impulse", 1. - 0.051e-4}});
  const double flying = 203.5 / 640.;
  check("cusp",
        {"Contact/Compliance=0.3",
         "Initial values/Velocity=if(x>" + significant(1. - flying, 16) +
           ",1,0)",
         "Time/End time=0.8"},
        {{"max_contact_force", 1. - std::exp(-flying / 0.3)}});
  check_unit_of_time();
}
