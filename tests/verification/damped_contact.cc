// SPDX-License-Identifier: LGPL-2.1-or-later
//
// Obstacles with p = ([s]_+/eps)^m [1 + c s_t]_+, doc/model.md section 4.
//
// tests/reference/damped-contact.csv, of tests/reference/damped_contact.py
// (SciPy, 1e-12), m = 1, 3/2, 3 with c = 0 and 1/10 (impact 0 and 1/2):
// creep    zeta u' + u + p = 2 sin 3 t, one cell, b = 0, tolerance 1e-11:
//          u at 2 times to 1e-9;
// static   the same with zeta = 0, steps of 1/20000: u at t = 0.8 to 1e-9;
// impact   a mass b/2 on a spring of stiffness 1 thrown at the obstacle, one
//          cell, lumped, tolerance 1e-12: begin and end of contact, velocity
//          of impact and rebound to 1e-8;
// rods     experiments 1 and 5 with 16 linear cells, tolerance 1e-7: u, v
//          and force at 2 times and the times of contact to 1e-6 of the
//          largest of each.
// orders   the same rods with 4 linear cells, fixed steps: u(1) at t = 0.8, in
//          contact, has the order of the scheme to 0.15. With m = 3/2 the force
//          grows like t^(3/2) once contact has begun, of which the first step
//          makes an error of order 5/2: smaller by far in the steps taken here
//          than that of each scheme, and not for ever smaller.
// start    in contact, b = 0, one cell, u = -x/10, g = -0.3, eps = 0.4, m = 1,
//          c = 2: zeta v + u + (s/eps)(1 + c v) = 0, s = 0.2, zeta = 1/2 gives
//          v = (0.1 - 0.5)/(0.5 + 1) = -4/15, the force 1/2 (1 - 8/15) = 7/30.
//          With mass the force jumps where the obstacle gets the velocity -1/5:
//          (s/eps) (1 + c (v + 1/5)) in that row.

#include <thermocontact/simulation/simulation.h>

#include <deal.II/base/mpi.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <map>
#include <string>
#include <tuple>
#include <vector>

#include "../recorded_run.h"

using namespace ThermoContact;

namespace
{
  /** The row of that time, which the run has. */
  const StepRecord &
  row_at(const RecordedRun &result, const double time)
  {
    return *std::min_element(result.rows.begin(),
                             result.rows.end(),
                             [time](const StepRecord &a, const StepRecord &b) {
                               return std::abs(a.time - time) <
                                      std::abs(b.time - time);
                             });
  }



  Overrides
  law(const double m, const double c)
  {
    return Overrides{"Contact/Condition=power law",
                     "Contact/Exponent=" + number(m),
                     "Contact/Damping=" + number(c)};
  }



  /** One value of the table. */
  struct Reference
  {
    std::string quantity;
    double      time, value;
  };

  /** Case, m, c. */
  using Key = std::tuple<std::string, double, double>;



  std::map<Key, std::vector<Reference>>
  read_references()
  {
    std::ifstream file(std::string(REFERENCE_DIR) + "/damped-contact.csv");
    std::string   line;
    std::getline(file, line); // header
    std::map<Key, std::vector<Reference>> table;
    while (std::getline(file, line))
      {
        std::istringstream stream(line);
        std::string        cells[6];
        for (std::string &cell : cells)
          std::getline(stream, cell, ',');
        table[{cells[0], std::stod(cells[1]), std::stod(cells[2])}].push_back(
          {cells[3], std::stod(cells[4]), std::stod(cells[5])});
      }
    return table;
  }



  const Overrides one_cell{"Model/Fields=displacement",
                           "Mesh/Cells=1",
                           "Mesh/Degree=1"};



  /** Experiment 1, or 5, in linear elements. */
  Overrides
  rod(const bool is_first)
  {
    return {"Mesh/Degree=1",
            "Mesh/Grading=1",
            "Contact/Massless nodes=off",
            std::string("Contact/Compliance=") + (is_first ? "0.01" : "1")};
  }



  Overrides
  scene_of(const std::string &name)
  {
    const Overrides driven =
      one_cell + Overrides{"Model/Inertia=0",
                           "Contact/Compliance=0.3",
                           "Boundary/right/Traction=2*sin(3*t)"};
    const Overrides lands{"Output/Contact interval=0.1",
                          "Output/Land on output times=true"};
    if (name == "creep")
      return driven + lands +
             Overrides{"Model/Viscosity=0.5",
                       "Time/Tolerance=1e-11",
                       "Time/End time=1.6"};
    if (name == "static")
      return driven + Overrides{"Model/Viscosity=0",
                                "Time/Step size=5e-5",
                                "Time/Locate contact events=true",
                                "Time/End time=0.8"};
    if (name == "impact")
      return one_cell + Overrides{"Contact/Compliance=0.1",
                                  "Model/Viscosity=0",
                                  "Mesh/Mass matrix=lumped",
                                  "Initial values/Velocity=x",
                                  "Time/Tolerance=1e-12",
                                  "Time/End time=1"};
    return lands + rod(name == "experiment-1") +
           Overrides{"Mesh/Cells=16",
                     "Time/Tolerance=1e-7",
                     "Time/End time=1.2"};
  }



  double
  value_of(const RecordedRun &result, const Reference &reference)
  {
    const auto event = [&](const unsigned int i) {
      return i < result.events.size() ? result.events[i] : ContactEvent{-1.};
    };
    if (reference.quantity == "begin" || reference.quantity == "event0")
      return event(0).time;
    if (reference.quantity == "end" || reference.quantity == "event1")
      return event(1).time;
    if (reference.quantity == "impact")
      return event(0).velocity;
    if (reference.quantity == "rebound")
      return event(1).velocity;
    const StepRecord &row = row_at(result, reference.time);
    if (std::abs(row.time - reference.time) > 1e-12)
      return std::nan("");
    return reference.quantity == "force"    ? row.contact_force :
           reference.quantity == "velocity" ? row.velocity_end :
                                              row.displacement_end;
  }



  void
  check_references()
  {
    std::map<std::string, double>       errors;
    std::map<std::string, unsigned int> counts;
    for (const auto &[key, references] : read_references())
      {
        const auto &[name, m, c] = key;
        if (name.rfind("coarse", 0) == 0)
          continue; // for orders
        const RecordedRun result = run<1>("", scene_of(name) + law(m, c));
        std::map<std::string, double> largest;
        for (const Reference &reference : references)
          raise(largest[reference.quantity], std::abs(reference.value));
        const bool is_rod = name.rfind("experiment", 0) == 0;
        for (const Reference &reference : references)
          {
            const double error =
              std::abs(value_of(result, reference) - reference.value) /
              (is_rod ? largest[reference.quantity] : 1.);
            errors[name] = error <= errors[name] ? errors[name] : error;
            ++counts[name];
          }
      }
    for (const auto &[name, error] : errors)
      {
        const double bound = name == "impact"                    ? 1e-8 :
                             name == "creep" || name == "static" ? 1e-9 :
                                                                   1e-6;
        deallog << name << ": " << counts[name] << " values to " << bound << ' '
                << within(error, bound) << std::endl;
        if (!(error < bound))
          deallog << error << std::endl;
      }
  }



  double
  error_of(const Key         &key,
           const Reference   &reference,
           const std::string &scheme,
           const unsigned int n)
  {
    const auto &[name, m, c] = key;
    const RecordedRun result =
      run<1>("",
             rod(name == "coarse-1") + law(m, c) +
               Overrides{"Mesh/Cells=4",
                         "Time/Scheme=" + scheme,
                         "Time/Start=consistent",
                         "Time/Locate contact events=true",
                         "Time/Step size=" + number(1. / n),
                         "Time/End time=" + number(reference.time)});
    return value_of(result, reference) - reference.value;
  }



  void
  check_orders()
  {
    for (const auto &[key, references] : read_references())
      if (const std::string &name = std::get<0>(key);
          name.rfind("coarse", 0) == 0)
        {
          deallog << name << ", m = " << std::get<1>(key)
                  << ", c = " << std::get<2>(key) << ": orders";
          for (const auto &[scheme, order, n] :
               {std::tuple("backward euler", 1., 800u),
                std::tuple("sdirk2", 2., 400u),
                std::tuple("sdirk3", 3., name == "coarse-1" ? 800u : 100u),
                std::tuple("sdirk4", 4., 50u)})
            {
              const double rate = std::log2(
                std::abs(error_of(key, references[0], scheme, n) /
                         error_of(key, references[0], scheme, 2 * n)));
              deallog << ' ' << (std::abs(rate - order) < 0.15 ? order : rate);
            }
          deallog << std::endl;
        }
  }



  void
  check_start_in_contact()
  {
    const StepRecord first =
      run<1>("",
             one_cell + law(1., 2.) +
               Overrides{"Model/Inertia=0",
                         "Model/Viscosity=0.5",
                         "Contact/Gap=-0.3",
                         "Contact/Compliance=0.4",
                         "Initial values/Displacement=-x/10",
                         "Time/End time=0.01"})
        .rows.front();
    deallog << "start in contact: velocity over -4/15 "
            << within(std::abs(first.velocity_end * -15. / 4. - 1.), 1e-12)
            << ", force over 7/30 "
            << within(std::abs(first.contact_force * 30. / 7. - 1.), 1e-12)
            << std::endl;
    const RecordedRun result =
      run<1>("",
             one_cell + law(1., 2.) +
               Overrides{"Contact/Gap=-0.3-0.2*max(t-0.005,0)",
                         "Contact/Compliance=0.4",
                         "Initial values/Displacement=-x/10",
                         "Time/End time=0.01"});
    const StepRecord &kink = row_at(result, 0.005);
    const double      by_law =
      kink.penetration / 0.4 * (1. + 2. * (kink.velocity_end + 0.2));
    deallog << "force behind a kink over its law "
            << within(std::abs(kink.contact_force / by_law - 1.), 1e-12)
            << std::endl;
  }
} // namespace



void
main_damped_contact()
{
  initlog();
  check_references();
  check_orders();
  check_start_in_contact();
}
