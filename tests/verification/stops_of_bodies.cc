// SPDX-License-Identifier: LGPL-2.1-or-later
//
// Two stops, Contact/Rear gap, for all bodies, doc/model.md section 4; on two
// processes. Loads are strong enough for contact at both stops.
//
// 1. A strip and a block on rollers equal the rod, all columns to 1e-9 of their
//    largest values or of 0.1, with inertia, without, and without viscosity,
//    each law, nodes with mass and without, and with the iterative solver where
//    there is one. The audit of backward Euler closes to 1e-11 of the sum of
//    its terms.
// 2. The mirrored scene of a rod gives the mirrored result to the last bit:
//    static, quasi-static, massless nodes, heat exchange by gap and pressure,
//    steps that conserve energy, with error control but for these.
// 3. A static rod under traction F, without thermal stress: u = F - p, and p by
//    hand. F = -1/2, g_2 = 0.2, eps = 1/2: p = -(0.5 - 0.2)/1.5 = -0.2, rigid
//    -0.3; power law m = 2, eps = 1/2: p = -4 s^2, s + 4 s^2 = 0.3, so that
//    s = (sqrt(5.8) - 1)/8: to 1e-12. With k = 2 if pressed by more than 0.1,
//    else 1, theta_A = 0, theta_obs = 1: theta(1) = 2/3 at rest, to 1e-6.
// 4. The rod without viscosity that conserves energy between two stops does so
//    in large steps, elastic and rigid, massless nodes and box scheme: the
//    energy stays to 1e-11, contact at both stops.
// 5. A strip whose lower part is drawn back and whose upper part is pushed, and
//    then the other way round: its nodes are at both stops at once. Two
//    processes have the columns of one, and the iterative solver those of the
//    direct one, to 1e-9; the audit closes to 1e-11.

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
  using Table = std::vector<std::vector<double>>;

  Table
  table_of(const std::vector<StepRecord> &rows)
  {
    Table table;
    for (const StepRecord &r : rows)
      table.push_back({r.displacement_end,
                       r.velocity_end,
                       r.stress_end,
                       r.gap,
                       r.contact_force,
                       r.contact_impulse,
                       r.temperature_end,
                       r.energy,
                       r.work,
                       r.dissipation,
                       r.contact_dissipation,
                       r.numerical_dissipation});
    return table;
  }



  /** Largest difference of a column relative to its largest value or 0.1. */
  double
  difference(const Table &a, const Table &b)
  {
    if (a.size() != b.size())
      return 1e300;
    double result = 0.;
    for (unsigned int j = 0; j < a[0].size(); ++j)
      {
        double change = 0., scale = 0.1;
        for (unsigned int i = 0; i < a.size(); ++i)
          if (!(std::isnan(a[i][j]) && std::isnan(b[i][j])))
            {
              raise(change, std::abs(a[i][j] - b[i][j]));
              raise(scale, std::abs(a[i][j]));
            }
        raise(result, change / scale);
      }
    return result;
  }



  bool
  has_audit(const std::vector<StepRecord> &rows)
  {
    double defect = 0., scale = 0.;
    for (const StepRecord &r : rows)
      {
        raise(scale,
              rows[0].energy_terms.magnitude() + std::abs(r.work) +
                r.dissipation + r.contact_dissipation +
                std::abs(r.numerical_dissipation));
        raise(defect,
              std::abs(rows[0].energy + r.work - r.energy - r.dissipation -
                       r.contact_dissipation - r.numerical_dissipation));
      }
    return defect < 1e-11 * scale;
  }



  bool
  meets_both(const std::vector<StepRecord> &rows)
  {
    double largest = 0., smallest = 0.;
    for (const StepRecord &r : rows)
      {
        raise(largest, r.contact_force);
        smallest = std::min(smallest, r.contact_force);
      }
    return largest > 0.01 && smallest < -0.01;
  }



  /** @param has_both_signs out: pressures of both signs at the same time */
  template <int dim>
  std::vector<StepRecord>
  rows_of(const Overrides &overrides,
          const MPI_Comm   communicator,
          bool            *has_both_signs = nullptr)
  {
    std::vector<StepRecord> rows;
    Simulation<dim> simulation(read_parameters("", overrides), communicator);
    simulation.run({[&](const Simulation<dim> &s) {
      rows.push_back(s.record());
      const auto [smallest, largest] =
        std::minmax_element(s.state().contact_pressure.begin(),
                            s.state().contact_pressure.end());
      if (has_both_signs != nullptr)
        *has_both_signs |= *smallest < -0.1 && *largest > 0.1;
    }});
    return rows;
  }



  const Overrides euler{"Time/Scheme=backward euler",
                        "Time/Start=consistent",
                        "Time/Step size=0.02"};
  const Overrides elastic{"Contact/Compliance=0.1"};
  const Overrides rigid{"Contact/Condition=rigid"};
  const Overrides power{"Contact/Condition=power law"};
  const Overrides damped{"Contact/Damping=0.3"};
  const Overrides is_static{"Model/Inertia=0", "Model/Viscosity=0"};
  const Overrides quasi_static{"Model/Inertia=0"};
  const Overrides massless{"Contact/Massless nodes=on"};
  const Overrides with_mass{"Contact/Massless nodes=off"};
  const Overrides no_viscosity{"Model/Viscosity=0"};
  const Overrides by_gap{"Boundary/Heat exchange=if(pressure>0,1+pressure,"
                         "0.1/(0.1+gap))",
                         "Boundary/Obstacle temperature=2"};
  const Overrides iterative{"Solver/Linear solver=iterative",
                            "Solver/Linear tolerance=1e-13"};



  void
  check_dimensions(const std::string &name,
                   const Overrides   &choice,
                   const bool         has_iterative_solver)
  {
    const Overrides scene = euler + choice +
                            Overrides{"Model/Coupling=0.1",
                                      "Boundary/Fixed end temperature=1",
                                      "Contact/Gap=0.03",
                                      "Contact/Rear gap=0.04",
                                      "Initial values/Temperature=theta_A",
                                      "Mesh/Cells=2",
                                      "Mesh/Degree=2",
                                      "Sources/End traction=4*sin(9*t)",
                                      "Time/End time=0.7"};
    const Overrides strip{"Dimension=2",
                          "Mesh/Width=0.1",
                          "Mesh/Cells across=1",
                          "Solver/Linear solver=direct"};
    const auto      rod   = rows_of<1>(scene, MPI_COMM_SELF);
    const auto      plane = rows_of<2>(scene + strip, MPI_COMM_SELF);
    const auto      block =
      rows_of<3>(scene + strip + Overrides{"Dimension=3"}, MPI_COMM_SELF);
    deallog << name << ": both stops " << meets_both(rod) << ", audits "
            << (has_audit(rod) && has_audit(plane) && has_audit(block))
            << ", strip " << (difference(table_of(rod), table_of(plane)) < 1e-9)
            << ", block "
            << (difference(table_of(rod), table_of(block)) < 1e-9);
    if (has_iterative_solver)
      deallog << ", iterative "
              << (difference(table_of(rod),
                             table_of(rows_of<2>(scene + strip + iterative,
                                                 MPI_COMM_SELF))) < 1e-9);
    deallog << std::endl;
  }



  void
  check_mirror(const std::string &name,
               const Overrides   &choice,
               const bool         is_thrown)
  {
    Table tables[2];
    bool  has_both = true;
    for (const int sign : {1, -1})
      {
        const std::string s = sign > 0 ? "" : "-";
        Overrides         scene{"Mesh/Cells=3",
                        "Mesh/Degree=2",
                        "Boundary/Fixed end temperature=0",
                        "Initial values/Temperature=0",
                        "Model/Coupling=" + s + "0.02",
                        "Sources/End traction=" + s + "1.5*sin(5*t)",
                        sign > 0 ? "Contact/Gap=0.05" : "Contact/Gap=0.08",
                        sign > 0 ? "Contact/Rear gap=0.08" :
                                           "Contact/Rear gap=0.05",
                        "Time/End time=1.5"};
        if (is_thrown)
          scene = scene + Overrides{"Initial values/Velocity=" + s + "x"};
        const auto rows = rows_of<1>(scene + choice, MPI_COMM_SELF);
        has_both &= meets_both(rows);
        for (const StepRecord &r : rows)
          tables[sign < 0].push_back({r.time,
                                      sign * r.displacement_end,
                                      sign * r.displacement_mid,
                                      sign * r.velocity_end,
                                      sign * r.stress_end,
                                      sign * r.contact_force,
                                      sign * r.contact_impulse,
                                      r.gap,
                                      r.penetration,
                                      r.temperature_end,
                                      r.heat_flux_end,
                                      r.energy,
                                      r.work,
                                      r.dissipation});
      }
    deallog << "mirrored " << name << ": both stops " << has_both
            << ", the same to the last bit "
            << (difference(tables[0], tables[1]) == 0.) << std::endl;
  }



  void
  check_rest()
  {
    const Overrides scene = is_static + Overrides{"Contact/Rear gap=0.2",
                                                  "Model/Coupling=0",
                                                  "Mesh/Cells=2",
                                                  "Mesh/Degree=1",
                                                  "Sources/End traction=-0.5",
                                                  "Time/End time=0.1"};
    const Overrides soft{"Contact/Compliance=0.5"};
    const double    s = (std::sqrt(5.8) - 1.) / 8.;
    for (const auto &[name, choice, exact] :
         {std::make_tuple("linear", soft, -0.2),
          std::make_tuple("rigid", rigid, -0.3),
          std::make_tuple("power law",
                          soft + power + Overrides{"Contact/Exponent=2"},
                          -4. * s * s)})
      {
        const StepRecord last =
          rows_of<1>(scene + choice, MPI_COMM_SELF).back();
        deallog << "at rest, " << name << ": force "
                << (std::abs(last.contact_force - exact) < 1e-12)
                << ", displacement "
                << (std::abs(last.displacement_end + 0.5 + exact) < 1e-12)
                << std::endl;
      }
    const StepRecord last =
      rows_of<1>(scene + soft +
                   Overrides{"Boundary/Heat exchange=if(pressure>0.1,2,1)",
                             "Boundary/Fixed end temperature=0",
                             "Boundary/Obstacle temperature=1",
                             "Initial values/Temperature=0",
                             "Time/End time=12"},
                 MPI_COMM_SELF)
        .back();
    deallog << "at rest, heat exchange of the rear stop "
            << (std::abs(last.temperature_end - 2. / 3.) < 1e-6) << std::endl;
  }



  void
  check_conservation(const std::string &name, const Overrides &choice)
  {
    const auto rows  = rows_of<1>(choice + no_viscosity +
                                   Overrides{"Model/Fields=displacement",
                                             "Time/Scheme=energy conserving",
                                             "Time/Start=consistent",
                                             "Contact/Gap=0.05",
                                             "Contact/Rear gap=0.08",
                                             "Initial values/Velocity=x*(1+x)",
                                             "Time/End time=6"},
                                 MPI_COMM_SELF);
    double     drift = 0.;
    for (const StepRecord &r : rows)
      raise(drift, std::abs(r.energy - rows[0].energy));
    deallog << "conserving, " << name << ": both stops " << meets_both(rows)
            << ", energy " << (drift < 1e-11 * rows[0].energy) << std::endl;
  }



  void
  check_both_at_once(const std::string &name,
                     const Overrides   &choice,
                     const bool         has_iterative_solver)
  {
    const Overrides scene =
      euler + choice +
      Overrides{"Dimension=2",
                "Model/Coupling=0.05",
                "Boundary/Fixed end temperature=0",
                "Initial values/Temperature=0",
                "Contact/Gap=0.01",
                "Contact/Rear gap=0.012",
                "Mesh/Width=0.6",
                "Mesh/Cells=2",
                "Mesh/Cells across=3",
                "Mesh/Degree=2",
                "Boundary/Lateral support=free",
                "Sources/End traction=2*sin(9*t)*(y-0.27)",
                "Time/End time=0.5"};
    const Overrides direct{"Solver/Linear solver=direct"};
    bool            is_at_both = false;
    const auto one = rows_of<2>(scene + direct, MPI_COMM_SELF, &is_at_both);
    const auto two = rows_of<2>(scene + direct, MPI_COMM_WORLD);
    deallog << "at both stops at once, " << name << ": " << is_at_both
            << ", audit " << has_audit(one) << ", two processes "
            << (difference(table_of(one), table_of(two)) < 1e-9);
    if (has_iterative_solver)
      deallog << ", iterative "
              << (difference(table_of(one),
                             table_of(rows_of<2>(scene + iterative,
                                                 MPI_COMM_WORLD))) < 1e-9);
    deallog << std::endl;
  }
} // namespace



int
main(int argc, char **argv)
{
  Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  initlog();
  check_dimensions("elastic", elastic, true);
  check_dimensions("damped power law", elastic + power + damped, false);
  check_dimensions("rigid, massless", rigid + massless, true);
  check_dimensions("rigid", rigid + with_mass, false);
  check_dimensions("massless", elastic + massless + no_viscosity, true);
  check_dimensions("static", is_static + elastic, true);
  check_dimensions("static power law", is_static + elastic + power, false);
  check_dimensions("quasi-static rigid", quasi_static + rigid, true);
  check_dimensions("quasi-static damped",
                   quasi_static + elastic + damped,
                   false);
  check_dimensions("heat exchange", elastic + by_gap, false);

  check_mirror("static", is_static + elastic, false);
  check_mirror("quasi-static", quasi_static + rigid, false);
  check_mirror("massless", massless + no_viscosity + elastic, true);
  check_mirror("massless rigid", massless + rigid, true);
  check_mirror("heat exchange", elastic + by_gap, true);
  check_mirror("conserving",
               elastic + no_viscosity +
                 Overrides{"Time/Scheme=energy conserving",
                           "Time/Start=consistent",
                           "Time/Step size=0.05"},
               true);

  check_rest();

  const Overrides many{"Mesh/Cells=10", "Mesh/Degree=2", "Time/Step size=0.15"};
  const Overrides box{"Mesh/Cells=20",
                      "Mesh/Degree=1",
                      "Mesh/Mass matrix=midpoint",
                      "Time/Step size=0.3"};
  check_conservation("elastic", elastic + many);
  check_conservation("rigid", rigid + many);
  check_conservation("box scheme", elastic + box);

  const Overrides at_rest{"Initial values/Velocity=0"};
  const Overrides soft{"Contact/Compliance=0.02"};
  check_both_at_once("elastic", at_rest + soft, true);
  check_both_at_once("damped power law",
                     at_rest + soft + power + damped,
                     false);
  check_both_at_once("rigid", at_rest + rigid + massless, true);
  check_both_at_once("quasi-static rigid", rigid + quasi_static, true);
  check_both_at_once("heat exchange", at_rest + soft + by_gap, false);
}
