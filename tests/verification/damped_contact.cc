// SPDX-License-Identifier: LGPL-2.1-or-later
//
// Obstacles with p = ([s]_+/eps)^m [1 + c s_t]_+, doc/model.md section 20.
//
// tests/reference/damped-contact.csv, of tests/reference/damped_contact.py
// (SciPy, 1e-12), m = 1, 3/2, 2, 3 with c = 0 and 1/10 (impact 0 and 1/2):
// creep    zeta u' + u + p = 2 sin 3 t, one cell, b = 0, tolerance 1e-11:
//          u at 6 times to 1e-9;
// static   the same with zeta = 0, steps of 1/20000: u at 4 times to 1e-9;
// impact   a mass b/2 on a spring of stiffness 1 thrown at the obstacle, one
//          cell, lumped, tolerance 1e-12: begin and end of contact, velocity
//          of impact and rebound to 1e-8;
// rods     experiments 1 and 5 with 16 linear cells, tolerance 1e-7: u, v
//          and force at 11 times and the times of contact to 1e-6 of the
//          largest of each.

#include <thermocontact/simulation/simulation.h>

#include <deal.II/base/mpi.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <map>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include "../tests.h"

#include "../overrides.h"

using namespace ThermoContact;

namespace
{
  std::string
  number(const double value)
  {
    std::ostringstream text;
    text.precision(17);
    text << value;
    return text.str();
  }



  struct Run
  {
    std::vector<StepRecord>   rows;
    std::vector<ContactEvent> events;
  };



  template <int dim>
  Run
  run(const std::string &file, const Overrides &overrides)
  {
    Run             result;
    Simulation<dim> simulation(read_parameters(file, overrides), MPI_COMM_SELF);
    simulation.run(
      {[&](const Simulation<dim> &s) { result.rows.push_back(s.record()); }});
    result.events = simulation.events();
    return result;
  }



  /** The row of that time, which the run has. */
  const StepRecord &
  row_at(const Run &result, const double time)
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



  Overrides
  scene_of(const std::string &name)
  {
    const Overrides driven =
      one_cell + Overrides{"Model/Inertia=0",
                           "Contact/Compliance=0.3",
                           "Sources/End traction=2*sin(3*t)"};
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
    return lands +
           Overrides{"Mesh/Cells=16",
                     "Mesh/Degree=1",
                     "Mesh/Grading=1",
                     "Contact/Massless nodes=off",
                     "Contact/Compliance=" +
                       std::string(name == "experiment-1" ? "0.01" : "1"),
                     "Time/Tolerance=1e-7",
                     "Time/End time=1.2"};
  }



  double
  value_of(const Run &result, const Reference &reference)
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
        const Run result         = run<1>("", scene_of(name) + law(m, c));
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
                << (error < bound) << std::endl;
        if (!(error < bound))
          deallog << error << std::endl;
      }
  }
} // namespace



int
main(int argc, char **argv)
{
  Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  initlog();
  check_references();
}
