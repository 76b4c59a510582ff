// SPDX-License-Identifier: LGPL-2.1-or-later
//
// The iterative solver of stages against the direct one.
//
// Each scene with both solvers, four fixed steps in which bodies with obstacle
// meet it node by node: all columns of contact.csv of all steps relative to the
// largest value of their kind (displacements, velocities, pressures,
// temperatures, energies), and the vectors and pressures at the end relative to
// their largest entry, to 1e-8 for Linear tolerance = 1e-10. The tolerance
// bounds residuals relative to the terms of their rows (D8.4); an error is
// larger by the condition of the matrix with unit diagonal, some 1e2 here.
// Measured: at most 4.5e-9, for contact nodes without mass and viscosity.

#include <thermocontact/simulation/simulation.h>

#include <deal.II/base/mpi.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "../matched_spaces.h"
#include "../overrides.h"

using namespace ThermoContact;

namespace
{
  using ThermoContact::Vector;

  /** Both, of which later ones win; '-PATH' takes an earlier one away. */
  Overrides
  joined(Overrides first, const Overrides &second)
  {
    for (const std::string &text : second)
      {
        const std::string path = text.substr(0, text.find('='));
        first.erase(std::remove_if(first.begin(),
                                   first.end(),
                                   [&](const std::string &other) {
                                     return other.substr(0, other.find('=')) ==
                                            path.substr(path[0] == '-');
                                   }),
                    first.end());
        first.push_back(text);
      }
    return first;
  }



  Parameters
  read(Overrides overrides, const std::string &solver)
  {
    overrides = joined(overrides, {"Solver/Linear solver=" + solver});
    overrides.erase(std::remove_if(overrides.begin(),
                                   overrides.end(),
                                   [](const std::string &text) {
                                     return text[0] == '-';
                                   }),
                    overrides.end());
    return read_parameters("", overrides);
  }



  /** A run with one of the solvers, by its records. */
  template <int dim>
  struct Run
  {
    Run(const Overrides &overrides, const std::string &solver)
      : simulation(read(overrides, solver), MPI_COMM_SELF)
    {
      const auto observe = [this](const Simulation<dim> &s) {
        records.push_back(s.record());
      };
      simulation.run({observe});
    }

    Simulation<dim>         simulation;
    std::vector<StepRecord> records;
  };



  /** What the columns of contact.csv are of, for their scale. */
  enum Kind : unsigned int
  {
    plain,
    length,
    velocity,
    pressure,
    temperature,
    energy,
    n_kinds
  };

  constexpr std::array<Kind, 18> kinds{{plain,
                                        plain,
                                        length,
                                        length,
                                        velocity,
                                        pressure,
                                        length,
                                        length,
                                        pressure,
                                        pressure,
                                        temperature,
                                        temperature,
                                        energy,
                                        energy,
                                        energy,
                                        plain,
                                        energy,
                                        temperature}};



  /** Largest difference of each kind over its largest value. */
  std::array<double, n_kinds>
  differences(const std::vector<StepRecord> &a,
              const std::vector<StepRecord> &b)
  {
    std::array<double, n_kinds> scale, result;
    scale.fill(0.);
    result.fill(a.size() == b.size() ? 0. : 1.);
    const unsigned int n = std::min(a.size(), b.size());
    for (unsigned int i = 0; i < n; ++i)
      for (unsigned int c = 0; c < kinds.size(); ++c)
        if (const double value = std::abs(all_columns(a[i])[c]);
            value > scale[kinds[c]])
          scale[kinds[c]] = value;
    for (unsigned int i = 0; i < n; ++i)
      {
        const auto x = all_columns(a[i]), y = all_columns(b[i]);
        for (unsigned int c = 0; c < kinds.size(); ++c)
          // a field that the scene does not have is NaN in both
          if (!(std::isnan(x[c]) && std::isnan(y[c])) && x[c] != y[c])
            raise(result[kinds[c]], std::abs(x[c] - y[c]) / scale[kinds[c]]);
      }
    return result;
  }



  template <int dim>
  double
  difference_of_states(const Simulation<dim> &a, const Simulation<dim> &b)
  {
    const MatchedSpaces<dim> spaces(a.discretization(), b.discretization());
    const State             &x = a.state(), &y = b.state();
    double                   result = spaces.is_complete ? 0. : 1.;
    const auto               compare =
      [&](const Field::Block field, const Vector &first, const Vector &second) {
        if (first.size() > 0 && first.linfty_norm() > 0.)
          raise(result,
                spaces.difference(field, first, second, first.linfty_norm()));
      };
    compare(Field::temperature, x.temperature, y.temperature);
    compare(Field::displacement, x.displacement, y.displacement);
    compare(Field::displacement, x.velocity, y.velocity);
    double largest = 0.;
    for (const double p : x.contact_pressure)
      raise(largest, p);
    for (unsigned int i = 0; i < x.contact_pressure.size(); ++i)
      if (x.contact_pressure[i] != y.contact_pressure[i])
        raise(result,
              std::abs(x.contact_pressure[i] - y.contact_pressure[i]) /
                largest);
    return result;
  }



  unsigned int
  n_in_contact(const std::vector<StepRecord> &records)
  {
    unsigned int n = 0;
    for (const StepRecord &r : records)
      n += r.in_contact;
    return n;
  }



  template <int dim>
  void
  compare_solvers(const std::string &name, const Overrides &overrides)
  {
    const Overrides all = joined({"Dimension=" + std::to_string(dim),
                                  "Mesh/Width=0.4",
                                  "Model/Poisson ratio=0.3",
                                  "Boundary/Lateral support=free",
                                  "Contact/Gap=0.01",
                                  "Initial values/Velocity=x*(0.4+2*y)",
                                  "Time/Scheme=sdirk2",
                                  "Time/Step size=0.01",
                                  "Time/End time=0.04",
                                  "Solver/Linear tolerance=1e-10"},
                                 overrides);
    const Run<dim>  a(joined(all, {"-Solver/Linear tolerance"}), "direct");
    const Run<dim>  b(all, "iterative");
    const auto      columns = differences(a.records, b.records);
    double          largest = 0.;
    for (const double value : columns)
      raise(largest, value);
    const double states = difference_of_states(a.simulation, b.simulation);
    deallog << dim << "-D, " << name << ": in contact "
            << (n_in_contact(a.records) > 0) << ", columns "
            << within(largest, 1e-8) << ", states " << within(states, 1e-8)
            << std::endl;
  }



  void
  compare(const std::string &name, const Overrides &overrides)
  {
    compare_solvers<2>(
      name,
      joined({"Mesh/Cells=8", "Mesh/Cells across=4", "Mesh/Degree=2"},
             overrides));
  }



  void
  compare_strips()
  {
    compare("degree 1, epsilon = 1", {"Mesh/Degree=1", "Contact/Compliance=1"});
    compare("degree 2, epsilon = 1e-2", {"Contact/Compliance=1e-2"});
    compare("degree 4, epsilon = 1e-6",
            {"Mesh/Degree=4",
             "Mesh/Cells across=2",
             "Contact/Compliance=1e-6"});
    compare("degree 2, epsilon = 1e-6, massless",
            {"Contact/Compliance=1e-6", "Contact/Massless nodes=on"});
    compare("degree 2, rigid", {"Contact/Condition=rigid"});
    compare("degree 4, rigid, no viscosity, sdirk4",
            {"Mesh/Degree=4",
             "Mesh/Cells across=2",
             "Contact/Condition=rigid",
             "Model/Viscosity=0",
             "Time/Scheme=sdirk4"});
    compare("degree 1, no obstacle",
            {"Mesh/Degree=1", "Contact/Condition=none", "-Contact/Gap"});
    compare("no inertia, elastic",
            {"Model/Inertia=0",
             "-Initial values/Velocity",
             "Sources/End traction=20*t*(0.5+y)"});
    compare("no inertia, rigid",
            {"Model/Inertia=0",
             "-Initial values/Velocity",
             "Contact/Condition=rigid",
             "Sources/End traction=20*t*(0.5+y)",
             "Initial values/Temperature=0*x"});
    compare("static, rigid",
            {"Model/Inertia=0",
             "-Initial values/Velocity",
             "Model/Viscosity=0",
             "Contact/Condition=rigid",
             "Sources/End traction=20*t*(0.5+y)"});
  }



  void
  compare_other_strips()
  {
    compare("rollers", {"Boundary/Lateral support=rollers"});
    compare("no heating, rigid",
            {"Model/Thermoelastic heating=false", "Contact/Condition=rigid"});
    compare("strong coupling", {"Model/Coupling=1"});
    compare("displacement alone, rigid, lumped",
            {"Model/Fields=displacement",
             "Contact/Condition=rigid",
             "Mesh/Mass matrix=lumped"});
    compare("temperature alone",
            {"Model/Fields=temperature",
             "-Model/Poisson ratio",
             "-Boundary/Lateral support",
             "-Contact/Gap",
             "-Initial values/Velocity"});
    compare("round rod, elastic", {"Mesh/Geometry=axisymmetric"});
    compare("round rod, degree 4, rigid",
            {"Mesh/Geometry=axisymmetric",
             "Mesh/Degree=4",
             "Mesh/Cells across=2",
             "Contact/Condition=rigid"});
    compare("graded", {"Mesh/Grading=4"});
  }



  void
  compare_blocks()
  {
    const Overrides block{"Mesh/Cells=4",
                          "Mesh/Cells across=2",
                          "Mesh/Degree=2"};
    const auto      compare = [&](const std::string &name,
                             const Overrides   &overrides) {
      compare_solvers<3>(name, joined(block, overrides));
    };
    compare("degree 1, epsilon = 1e-2",
            {"Mesh/Degree=1", "Contact/Compliance=1e-2"});
    compare("degree 2, rigid", {"Contact/Condition=rigid"});
    compare("degree 2, epsilon = 1e-6, no viscosity",
            {"Contact/Compliance=1e-6", "Model/Viscosity=0"});
    compare("degree 1, no inertia",
            {"Mesh/Degree=1",
             "Model/Inertia=0",
             "-Initial values/Velocity",
             "Sources/End traction=20*t*(0.5+y)"});
    compare("degree 4, rollers, rigid",
            {"Mesh/Degree=4",
             "Mesh/Cells=2",
             "Mesh/Cells across=1",
             "Boundary/Lateral support=rollers",
             "Contact/Condition=rigid"});
  }
} // namespace



void
main_iterative_solver()
{
  initlog();
  deallog << "direct against iterative" << std::endl;
  compare_strips();
  compare_other_strips();
  compare_blocks();
}
