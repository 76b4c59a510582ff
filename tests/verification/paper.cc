// SPDX-License-Identifier: LGPL-2.1-or-later
//
// The published parameter files against independent numbers.
//
// 1. Experiments 1 and 2 at the paper's settings against the tables
//    tests/reference/experiment-N-paper-scheme.csv of an independent code for
//    the scheme (3.1)-(3.2): eight times, eight quantities, 1e-9 (absolute, or
//    relative for the energy, which starts at 128.7). The tables carry 12
//    digits. First contact is late against an exact solution in time and space
//    (0.1849692017564 and 0.1109600618893) by 1.211e-4 and 8.928e-4.
// 2. Steady states of all five experiments in closed form, doc/model.md (M3.1):
//      c = k/(k+1), G = a theta_A (1 - c/2), p = [G - g]_+/(1 + eps),
//      u(1) = G - p, theta(1) = theta_A (1 - c),
//      E = -(a theta_A)^2/2 (1 - c + c^2/3) + (1 + eps) p^2/2,
//    and for degree 1 the elastic energy of the interpolated quadratic u adds
//    (a theta_A c h)^2/24. Large steps of backward Euler lead there: 1e-9.
//    A rigid obstacle is the case eps = 0.
// 3. The audit E(0) + W = E + D + N at every row, each term by its own formula:
//    1e-11 of E(0); all experiments, and scenes with all sources, elastic and
//    rigid, rod and strip with free lateral faces.
// 4. Cost: the monolithic scheme factorises twice (the start of the paper and
//    the stages), solves once per step, and needs one response.

#include <thermocontact/simulation/simulation.h>

#include <deal.II/base/mpi.h>

#include <array>
#include <cmath>
#include <iomanip>
#include <sstream>

#include "../tests.h"

using namespace ThermoContact;

namespace
{
  std::string
  paper_file(const unsigned int experiment)
  {
    return "paper/experiment-" + std::to_string(experiment) + ".prm";
  }



  /** Columns of the tables, without the time. */
  std::array<double, 8>
  reference_quantities(const StepRecord &r)
  {
    return {{r.displacement_end,
             r.displacement_mid,
             r.velocity_end,
             r.stress_end,
             r.penetration,
             r.contact_force,
             r.temperature_end,
             r.energy}};
  }



  std::vector<std::array<double, 9>>
  read_table(const unsigned int experiment)
  {
    std::ifstream file(std::string(REFERENCE_DIR) + "/experiment-" +
                       std::to_string(experiment) + "-paper-scheme.csv");
    std::string   line;
    std::getline(file, line); // header
    std::vector<std::array<double, 9>> rows;
    while (std::getline(file, line))
      {
        std::istringstream stream(line);
        rows.emplace_back();
        for (double &value : rows.back())
          {
            std::string cell;
            std::getline(stream, cell, ',');
            value = std::stod(cell);
          }
      }
    return rows;
  }



  void
  compare_with_table(const unsigned int experiment)
  {
    const auto    table = read_table(experiment);
    Simulation<1> simulation(read_parameters(paper_file(experiment)),
                             MPI_COMM_SELF);
    unsigned int  n_rows  = 0;
    double        error   = 0.;
    const auto    observe = [&](const Simulation<1> &s) {
      for (const auto &row : table)
        if (std::abs(row[0] - s.record().time) < 1e-9)
          {
            ++n_rows;
            const auto values = reference_quantities(s.record());
            for (unsigned int i = 0; i < values.size(); ++i)
              raise(error,
                    std::abs(values[i] - row[i + 1]) /
                      std::max(1., std::abs(row[i + 1])));
          }
    };
    simulation.run({observe});

    deallog << "experiment " << experiment << ": " << n_rows << " of "
            << table.size() << " rows: " << within(error, 1e-9) << std::endl;
    const double exact = experiment == 1 ? 0.1849692017564 : 0.1109600618893;
    const double late  = experiment == 1 ? 1.211e-4 : 8.928e-4;
    deallog << "  first contact: "
            << within(std::abs(simulation.events().at(0).time - exact - late),
                      1e-7)
            << std::endl;
    const SolverCounters counters = simulation.counters();
    deallog << "  steps " << simulation.record().step << ", factorizations "
            << counters.factorizations << ", solves " << counters.solves
            << ", responses " << counters.responses << std::endl;
  }



  void
  check_steady_state(const Parameters &paper, const unsigned int degree)
  {
    Parameters parameters     = paper;
    parameters.mesh.degree    = degree;
    parameters.time.start     = "consistent";
    parameters.time.step_size = 1e6;
    parameters.time.end_time  = 2e7;
    Simulation<1> simulation(parameters, MPI_COMM_SELF);
    simulation.run();

    const double a       = parameters.model.coupling;
    const double theta_A = parameters.boundary.left.temperature;
    const double k       = parameters.boundary.right.heat_exchange;
    const double g       = parameters.contact.gap;
    const double eps     = parameters.contact.condition == "rigid" ?
                             0. :
                             parameters.contact.law.at("Compliance");
    const double c       = k / (k + 1.);
    const double G       = a * theta_A * (1. - c / 2.);
    const double p       = std::max(G - g, 0.) / (1. + eps);
    const double h       = 1. / parameters.mesh.cells;
    const double E =
      -0.5 * std::pow(a * theta_A, 2) * (1. - c + c * c / 3.) +
      0.5 * (1. + eps) * p * p +
      (degree == 1 ? std::pow(a * theta_A * c * h, 2) / 24. : 0.);

    const StepRecord &r = simulation.record();
    deallog << "  degree " << degree << ": u(1) = " << G - p
            << ", force = " << p << "; within 1e-9: u(1) "
            << within(std::abs(r.displacement_end - (G - p)), 1e-9)
            << ", force " << within(std::abs(r.contact_force - p), 1e-9)
            << ", theta(1) "
            << within(std::abs(r.temperature_end - theta_A * (1. - c)), 1e-9)
            << ", energy " << within(std::abs(r.energy - E), 1e-9) << std::endl;
  }



  template <int dim>
  void
  check_audit(const std::string &name, const Parameters &parameters)
  {
    Simulation<dim> simulation(parameters, MPI_COMM_SELF);
    double          initial = 0., defect = 0., smallest_dissipation = 0.;
    unsigned int    n_contacts = 0;
    double          last       = 0.;
    const auto      observe    = [&](const Simulation<dim> &s) {
      const StepRecord &r = s.record();
      if (r.step == 0)
        initial = r.energy;
      raise(defect,
            std::abs(initial + r.work - r.energy - r.dissipation -
                     r.numerical_dissipation));
      // the prescribed first step may gain energy, later steps may not
      if (r.step > 1)
        smallest_dissipation =
          std::min(smallest_dissipation, r.numerical_dissipation - last);
      last = r.numerical_dissipation;
      n_contacts += r.in_contact;
    };
    simulation.run({observe});
    deallog << name << ": contact occurs " << (n_contacts > 0)
            << ", work is done " << (simulation.record().work != 0.)
            << ", audit closes within 1e-11 E(0) "
            << within(defect / initial, 1e-11)
            << ", numerical dissipation of a step below 0 by "
            << within(std::abs(smallest_dissipation) / initial, 1e-14)
            << std::endl;
  }



  /** The audit where the paper does not go, with all sources. */
  template <int dim>
  void
  check_audit_with_sources(const std::string &condition)
  {
    std::vector<std::string> overrides = {"Dimension=" + std::to_string(dim),
                                          "Time/Scheme=backward euler",
                                          "Time/Start=consistent",
                                          "Time/Step size=0.01",
                                          "Time/End time=3",
                                          "Mesh/Degree=2",
                                          "Boundary/right/Surroundings=3",
                                          "Contact/Condition=" + condition,
                                          "Sources/Heat source=x*cos(t)",
                                          "Sources/Body force=sin(3*t)*(1+x)",
                                          "Boundary/right/Traction=0.1*t",
                                          "Boundary/right/Heat flux=1+t"};
    if (dim > 1)
      overrides.insert(overrides.end(),
                       {"Model/Poisson ratio=0.3",
                        "Boundary/sides/Support=free",
                        "Mesh/Cells across=2"});
    check_audit<dim>(std::to_string(dim) + "-D, sources, " + condition,
                     read_parameters("", overrides));
  }
} // namespace



void
main_paper()
{
  initlog();
  deallog << std::setprecision(12);

  deallog << "paper's scheme against an independent code" << std::endl;
  for (const unsigned int experiment : {1, 2})
    compare_with_table(experiment);

  deallog << "steady states" << std::endl;
  for (unsigned int experiment = 1; experiment <= 5; ++experiment)
    {
      deallog << "experiment " << experiment << ':';
      for (const unsigned int degree : {1, 2})
        check_steady_state(read_parameters(paper_file(experiment)), degree);
    }
  deallog << "rigid obstacle:";
  for (const unsigned int degree : {1, 2})
    check_steady_state(read_parameters(paper_file(1),
                                       {"Contact/Condition=rigid"}),
                       degree);

  deallog << "energy audit: ";
  for (unsigned int experiment = 1; experiment <= 5; ++experiment)
    check_audit<1>("experiment " + std::to_string(experiment),
                   read_parameters(paper_file(experiment)));
  for (const char *condition : {"normal compliance", "rigid"})
    {
      check_audit_with_sources<1>(condition);
      check_audit_with_sources<2>(condition);
    }
}
