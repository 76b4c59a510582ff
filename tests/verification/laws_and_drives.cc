// SPDX-License-Identifier: LGPL-2.1-or-later
//
// Each contact law with each drive, heat exchange and pair of stops of
// doc/laws.md: a rod that is thrown at an obstacle, two cells of degree 2,
// backward Euler. A line for each law, with the largest value of all drives:
//
// 1. audit: energy(0) + work = energy + dissipation + contact_dissipation +
//    numerical_dissipation, each by its own formula, of the rod, the strip, the
//    block: to 1e-11 of the sum of its terms. Drives work. Without one, and
//    without work of the heat exchange, for theta_A = theta_obs, the energy
//    never increases, and neither scheme nor obstacle gives any back, to 1e-12.
// 2. bodies: a strip and a block on rollers equal the rod, all columns to 1e-9
//    of their largest values or of 0.1, and so does the iterative solver where
//    the scene allows it. A body that loses heat through its lateral faces is
//    the rod but for O(W^2) of its width W: extrapolated from two widths.
// 3. mirrored: between two stops the scene with u -> -u, a -> -a, loads of the
//    other sign and the gaps exchanged gives that result negated, to 1e-9.
//
// Then steps with error control and steps that conserve energy, mirrored; the
// curved obstacle before a free strip, whose nodes close one by one: its audit;
// and heat exchange 1 + 0*pressure, solved together with the contact, against
// the number 1, rod and strip: all columns to 1e-10.

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "../recorded_run.h"
#include "../row_checks.h"

using namespace ThermoContact;

namespace
{
  /** Things of the other sign in the mirrored scene. */
  std::string
  sign_of(const bool is_mirrored)
  {
    return is_mirrored ? "-" : "";
  }



  Overrides
  at_rest(const bool is_mirrored)
  {
    return {"Model/Coupling=" + sign_of(is_mirrored) + "0.3",
            "Boundary/Fixed end temperature=1",
            "Boundary/Obstacle temperature=1",
            "Contact/Gap=0.03",
            "Initial values/Temperature=theta_A*(1-x^2)",
            "Mesh/Cells=2",
            "Mesh/Degree=2",
            "Time/Scheme=backward euler",
            "Time/Start=consistent",
            "Time/Step size=0.02",
            "Time/End time=0.3"};
  }



  Overrides
  thrown(const bool is_mirrored)
  {
    return at_rest(is_mirrored) +
           Overrides{"Initial values/Velocity=" + sign_of(is_mirrored) + "x"};
  }



  Overrides
  two_stops(const bool is_mirrored)
  {
    return {is_mirrored ? "Contact/Gap=0.04" : "Contact/Gap=0.03",
            is_mirrored ? "Contact/Rear gap=0.03" : "Contact/Rear gap=0.04",
            "Sources/End traction=" + sign_of(is_mirrored) + "4*sin(9*t)",
            "Time/End time=0.7"};
  }



  struct Law
  {
    std::string name;
    Overrides   overrides;
    bool        has_iterative_solver;
    /** Without inertia nothing can be thrown: between two stops alone. */
    bool has_inertia = true;

    Overrides
    scene(const bool is_mirrored) const
    {
      return (has_inertia ? thrown(is_mirrored) : at_rest(is_mirrored)) +
             overrides;
    }
  };

  const std::string compliance = "Contact/Compliance=0.1";
  const std::string power      = "Contact/Condition=power law";
  const std::string rigid      = "Contact/Condition=rigid";
  const std::string damping    = "Contact/Damping=0.3";
  const std::string massless   = "Contact/Massless nodes=on";
  const std::string no_inertia = "Model/Inertia=0";

  const std::vector<Law> laws{
    {"normal compliance", {compliance}, true},
    {"power law", {compliance, power}, false},
    {"damped", {compliance, damping}, false},
    {"damped power law", {compliance, power, damping}, false},
    {"rigid", {rigid, massless}, true},
    {"rigid with mass", {rigid, "Contact/Massless nodes=off"}, false},
    {"damped without mass", {compliance, damping, massless}, false},
    {"compliance without mass", {compliance, massless}, true},
    {"static", {compliance, no_inertia, "Model/Viscosity=0"}, true, false},
    {"static power law",
     {compliance, power, no_inertia, "Model/Viscosity=0"},
     false,
     false},
    {"quasi-static rigid", {rigid, no_inertia}, true, false},
    {"quasi-static damped", {compliance, damping, no_inertia}, false, false}};

  struct Drive
  {
    std::string name;
    Overrides   overrides;
    bool        has_work;
    bool        has_iterative_solver;
    bool        is_lateral    = false;
    bool        has_two_stops = false;
  };

  const std::string by_gap =
    "Boundary/Heat exchange=0.05/(0.05+gap)+20*pressure";

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
    {"exchange by gap and pressure", {by_gap}, false, false},
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
      by_gap,
      "Sources/Heat source=x*sin(4*t)",
      "Sources/Body force=sin(6*t)",
      "Sources/End traction=0.3*sin(8*t)",
      "Sources/End heat flux=sin(5*t)"},
     true,
     false},
    {"two stops", {}, true, true, false, true},
    {"thrown at two stops",
     {"Sources/End traction=0", "Model/Viscosity=0.02", "Time/End time=3"},
     false,
     true,
     false,
     true},
    {"two stops, exchange by gap and pressure",
     {by_gap, "Boundary/Obstacle temperature=2"},
     true,
     false,
     false,
     true}};



  /** The largest values of a law. */
  struct Worst
  {
    double audit = 0., increase = 0., bodies = 0., mirrored = 0.;
    /** Scenes, those without contact, those whose drives do not work. */
    unsigned int n_scenes = 0, n_without_contact = 0, n_without_work = 0;

    void
    add_audit(const RecordedRun &result, const bool has_work)
    {
      const Audit found = ThermoContact::audit(result.rows);
      raise(audit, found.defect);
      if (!has_work)
        raise(increase, std::max(found.increase, found.given));
      n_without_work +=
        has_work ? !(std::abs(found.work) > 1e-4) : found.work != 0.;
    }
  };



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
  Columns
  columns_of_body(const Overrides &scene, const Drive &drive, Worst &worst)
  {
    const RecordedRun result = body<dim>(scene, "0.1");
    worst.add_audit(result, drive.has_work);
    if (!drive.is_lateral)
      return table_of(result.rows);
    Columns       table = table_of(body<dim>(scene, "0.001").rows);
    const Columns wide  = table_of(body<dim>(scene, "0.002").rows);
    for (unsigned int i = 0; i < table.size() && i < wide.size(); ++i)
      for (unsigned int j = 0; j < table[i].size(); ++j)
        table[i][j] += (table[i][j] - wide[i][j]) / 3.;
    return table;
  }



  /** The columns that change their sign in a mirrored rod do so here. */
  Columns
  mirrored_table(std::vector<StepRecord> rows, const bool is_mirrored)
  {
    if (is_mirrored)
      for (StepRecord &r : rows)
        for (double *value : {&r.displacement_end,
                              &r.displacement_mid,
                              &r.velocity_end,
                              &r.stress_end,
                              &r.contact_force,
                              &r.contact_impulse})
          *value *= -1.;
    return table_of(rows);
  }



  void
  check(const Law &law, const Drive &drive, Worst &worst)
  {
    Overrides scene = law.scene(false);
    if (drive.has_two_stops)
      scene = scene + two_stops(false);
    scene                    = scene + drive.overrides;
    const RecordedRun rod    = run<1>("", scene);
    const Columns     table  = table_of(rod.rows);
    const double      before = worst.bodies;
    worst.add_audit(rod, drive.has_work);
    raise(worst.bodies,
          difference(table, columns_of_body<2>(scene, drive, worst)));
    raise(worst.bodies,
          difference(table, columns_of_body<3>(scene, drive, worst)));
    if (law.has_iterative_solver && drive.has_iterative_solver)
      raise(worst.bodies,
            difference(table,
                       table_of(
                         body<2>(scene +
                                   Overrides{"Solver/Linear solver=iterative",
                                             "Solver/Linear tolerance=1e-13"},
                                 "0.1")
                           .rows)));
    ++worst.n_scenes;
    worst.n_without_contact += drive.has_two_stops ?
                                 !meets_both(rod.rows, 0.01) :
                                 !(rod.rows.back().contact_impulse > 1e-3);
    if (drive.has_two_stops)
      raise(worst.mirrored,
            difference(table,
                       mirrored_table(run<1>("",
                                             law.scene(true) + two_stops(true) +
                                               drive.overrides)
                                        .rows,
                                      true)));
    if (worst.bodies > std::max(before, 1e-9) || worst.audit > 1e-11 ||
        worst.increase > 1e-12 || worst.mirrored > 1e-9)
      deallog << law.name << " with " << drive.name << ':' << std::endl;
  }



  void
  check_mirrored(const std::string &name, const Overrides &choice)
  {
    Columns tables[2];
    bool    has_both = true;
    for (const bool is_mirrored : {false, true})
      {
        const RecordedRun result =
          run<1>("", thrown(is_mirrored) + two_stops(is_mirrored) + choice);
        has_both &= meets_both(result.rows, 0.01);
        tables[is_mirrored] = mirrored_table(result.rows, is_mirrored);
      }
    deallog << name << ": at " << 1 + has_both << " stops, mirrored "
            << within(difference(tables[0], tables[1]), 1e-9) << std::endl;
  }



  void
  check_curved_obstacle()
  {
    const Audit found =
      audit(body<2>(thrown(false) + Overrides{compliance,
                                              power,
                                              damping,
                                              "Contact/Gap=0.02+5*(y-0.03)^2",
                                              "Boundary/Lateral support=free"},
                    "0.1")
              .rows);
    deallog << "curved obstacle: takes a share " << (found.taken > 1e-6)
            << ", audit " << within(found.defect, 1e-11) << ", energy "
            << within(std::max(found.increase, found.given), 1e-12)
            << std::endl;
  }



  void
  check_expression_of_exchange()
  {
    const Overrides scene = thrown(false) + Overrides{compliance, damping};
    const Overrides number{"Boundary/Heat exchange=1"};
    const Overrides expression{"Boundary/Heat exchange=1+0*pressure"};
    deallog << "exchange by an expression: rod "
            << within(difference(table_of(run<1>("", scene + number).rows),
                                 table_of(run<1>("", scene + expression).rows)),
                      1e-10)
            << ", strip "
            << within(difference(table_of(body<2>(scene + number, "0.1").rows),
                                 table_of(
                                   body<2>(scene + expression, "0.1").rows)),
                      1e-10)
            << std::endl;
  }
} // namespace



void
main_laws_and_drives()
{
  initlog();
  for (const Law &law : laws)
    {
      Worst worst;
      for (const Drive &drive : drives)
        if (law.has_inertia || (drive.has_two_stops && drive.has_work))
          check(law, drive, worst);
      deallog << law.name << ": " << worst.n_scenes << " scenes, "
              << worst.n_without_contact << " without contact, "
              << worst.n_without_work << " with other work; audit "
              << within(worst.audit, 1e-11) << ", energy "
              << within(worst.increase, 1e-12) << ", bodies "
              << within(worst.bodies, 1e-9) << ", mirrored "
              << within(worst.mirrored, 1e-9) << std::endl;
    }
  const Overrides error_control{"Time/Scheme=sdirk4",
                                "Time/Step size=automatic"};
  check_mirrored("error control", error_control + Overrides{compliance});
  check_mirrored("error control, rigid", error_control + Overrides{rigid});
  check_mirrored("conserving",
                 {compliance,
                  "Model/Viscosity=0",
                  "Time/Scheme=energy conserving"});
  check_curved_obstacle();
  check_expression_of_exchange();
}
