// SPDX-License-Identifier: LGPL-2.1-or-later
//
// Each contact law with each drive and each heat exchange, doc/laws.md: a rod
// that is thrown at an obstacle, backward Euler, two cells of degree 2.
//
// 1. The audit energy(0) + work = energy + dissipation + contact_dissipation +
//    numerical_dissipation, each line by its own formula, of the rod, the strip
//    and the block: to 1e-11 of the sum of its terms. Drives work. Without one,
//    and without work of the heat exchange, for theta_A = theta_obs, the energy
//    never increases, to 1e-12 of that sum.
// 2. A strip and a block on rollers equal the rod: all columns to 1e-9 of their
//    largest values, or of 0.1, and with the iterative solver where the scene
//    allows it. A body that loses heat through its lateral faces is the rod but
//    for O(W^2) of its width W: extrapolated from two widths.

#include <thermocontact/simulation/simulation.h>

#include <deal.II/base/mpi.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "../recorded_run.h"

using namespace ThermoContact;

namespace
{
  const Overrides thrown{"Model/Coupling=0.3",
                         "Boundary/Fixed end temperature=1",
                         "Boundary/Obstacle temperature=1",
                         "Contact/Gap=0.03",
                         "Initial values/Temperature=theta_A*(1-x^2)",
                         "Initial values/Velocity=x",
                         "Mesh/Cells=2",
                         "Mesh/Degree=2",
                         "Time/Scheme=backward euler",
                         "Time/Start=consistent",
                         "Time/Step size=0.02",
                         "Time/End time=0.3"};

  struct Law
  {
    std::string name;
    Overrides   overrides;
    bool        has_iterative_solver;
  };

  const std::string compliance = "Contact/Compliance=0.1";

  const std::vector<Law> laws{
    {"normal compliance", {compliance}, true},
    {"power law", {compliance, "Contact/Condition=power law"}, false},
    {"damped", {compliance, "Contact/Damping=0.3"}, false},
    {"damped power law",
     {compliance, "Contact/Condition=power law", "Contact/Damping=0.3"},
     false},
    {"rigid", {"Contact/Condition=rigid", "Contact/Massless nodes=on"}, true},
    {"rigid with mass",
     {"Contact/Condition=rigid", "Contact/Massless nodes=off"},
     false},
    {"damped without mass",
     {compliance, "Contact/Damping=0.3", "Contact/Massless nodes=on"},
     false},
    {"compliance without mass",
     {compliance, "Contact/Massless nodes=on"},
     true}};

  struct Drive
  {
    std::string name;
    Overrides   overrides;
    bool        has_work;
    bool        has_iterative_solver;
    bool        is_lateral = false;
  };

  const std::vector<Drive> drives{
    {"no drive", {}, false, true},
    {"fixed end temperature",
     {"Boundary/Fixed end temperature=1+sin(7*t)"},
     true,
     true},
    {"obstacle temperature",
     {"Boundary/Obstacle temperature=1+sin(5*t)"},
     true,
     true},
    {"fixed end displacement",
     {"Boundary/Fixed end displacement=0.02*(1-cos(9*t))"},
     true,
     true},
    {"moving obstacle", {"Contact/Gap=0.03-0.02*sin(7*t)"}, true, true},
    {"exchange by gap and pressure",
     {"Boundary/Heat exchange=0.05/(0.05+gap)+20*pressure"},
     false,
     false},
    {"lateral exchange",
     {"Boundary/Lateral heat exchange=3", "Boundary/Ambient temperature=-2"},
     false,
     false,
     true},
    {"sources",
     {"Sources/Heat source=x*sin(4*t)",
      "Sources/Body force=sin(6*t)",
      "Sources/End traction=0.3*sin(8*t)",
      "Sources/End heat flux=sin(5*t)"},
     true,
     true},
    {"all but lateral exchange",
     {"Boundary/Fixed end temperature=1+sin(7*t)",
      "Contact/Gap=0.03-0.01*sin(7*t)",
      "Boundary/Fixed end displacement=0.02*(1-cos(9*t))",
      "Boundary/Heat exchange=0.05/(0.05+gap)+20*pressure",
      "Sources/Heat source=x*sin(4*t)",
      "Sources/Body force=sin(6*t)",
      "Sources/End traction=0.3*sin(8*t)",
      "Sources/End heat flux=sin(5*t)"},
     true,
     false}};



  using Table = std::vector<std::vector<double>>;

  Table
  table_of(const RecordedRun &result)
  {
    Table table;
    for (const StepRecord &r : result.rows)
      {
        const auto          columns = all_columns(r);
        std::vector<double> row(columns.begin(), columns.end());
        row.insert(row.end(),
                   {r.contact_dissipation,
                    r.lateral_heat_flux,
                    r.lateral_dissipation});
        table.push_back(row);
      }
    return table;
  }



  /** Largest difference of a column relative to its largest value, or 0.1. */
  double
  difference(const Table &a, const Table &b)
  {
    if (a.size() != b.size())
      return 1.;
    double result = 0.;
    for (unsigned int column = 0; column < a[0].size(); ++column)
      {
        double change = 0., scale = 0.1;
        for (unsigned int i = 0; i < a.size(); ++i)
          {
            raise(change, std::abs(a[i][column] - b[i][column]));
            raise(scale, std::abs(a[i][column]));
          }
        raise(result, change / scale);
      }
    return result;
  }



  /** The audit closes, and the energy grows only where something works. */
  bool
  has_audit(const RecordedRun &result, const bool has_work)
  {
    const std::vector<StepRecord> &rows   = result.rows;
    double                         defect = 0., increase = 0., scale = 0.;
    for (unsigned int i = 0; i < rows.size(); ++i)
      {
        const StepRecord &r = rows[i];
        raise(scale,
              rows[0].energy_terms.magnitude() + std::abs(r.work) +
                r.dissipation + r.contact_dissipation +
                std::abs(r.numerical_dissipation));
        raise(defect,
              std::abs(rows[0].energy + r.work - r.energy - r.dissipation -
                       r.contact_dissipation - r.numerical_dissipation));
        if (i > 0)
          raise(increase, r.energy - rows[i - 1].energy);
      }
    return defect < 1e-11 * scale &&
           (has_work ? std::abs(rows.back().work) > 1e-4 * scale :
                       rows.back().work == 0. && increase < 1e-12 * scale);
  }



  template <int dim>
  RecordedRun
  body(const Overrides &scene, const std::string &width)
  {
    return run<dim>("",
                    scene + Overrides{"Dimension=" + std::to_string(dim),
                                      "Mesh/Width=" + width,
                                      "Mesh/Cells across=1",
                                      "Model/Poisson ratio=0.3"});
  }



  /**
   * The columns of a body, without a width if heat is lost on its faces; thin
   * bodies have no digits left for the audit.
   */
  template <int dim>
  Table
  columns_of_body(const Overrides &scene, const Drive &drive, bool &has_audits)
  {
    const RecordedRun result = body<dim>(scene, "0.1");
    has_audits &= has_audit(result, drive.has_work);
    if (!drive.is_lateral)
      return table_of(result);
    Table       table = table_of(body<dim>(scene, "0.001"));
    const Table wide  = table_of(body<dim>(scene, "0.002"));
    for (unsigned int i = 0; i < table.size() && i < wide.size(); ++i)
      for (unsigned int j = 0; j < table[i].size(); ++j)
        table[i][j] += (table[i][j] - wide[i][j]) / 3.;
    return table;
  }



  void
  check(const Law &law, const Drive &drive)
  {
    const Overrides   scene      = thrown + law.overrides + drive.overrides;
    const RecordedRun rod        = run<1>("", scene);
    const Table       table      = table_of(rod);
    bool              has_audits = has_audit(rod, drive.has_work);
    const auto        strip      = columns_of_body<2>(scene, drive, has_audits);
    const auto        block      = columns_of_body<3>(scene, drive, has_audits);
    deallog << law.name << ", " << drive.name << ": contact "
            << (rod.rows.back().contact_impulse > 1e-3) << ", audits "
            << has_audits << ", strip " << (difference(table, strip) < 1e-9)
            << ", block " << (difference(table, block) < 1e-9);
    if (law.has_iterative_solver && drive.has_iterative_solver)
      deallog << ", iterative "
              << (difference(table,
                             table_of(body<2>(
                               scene +
                                 Overrides{"Solver/Linear solver=iterative",
                                           "Solver/Linear tolerance=1e-13"},
                               "0.1"))) < 1e-9);
    deallog << std::endl;
    if (!(difference(table, strip) < 1e-9 && difference(table, block) < 1e-9))
      deallog << difference(table, strip) << ' ' << difference(table, block)
              << std::endl;
  }
} // namespace



int
main(int argc, char **argv)
{
  Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  initlog();
  for (const Law &law : laws)
    for (const Drive &drive : drives)
      check(law, drive);
}
