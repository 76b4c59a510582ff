// SPDX-License-Identifier: LGPL-2.1-or-later
//
// What comes through the boundary, Output/Boundaries, doc/discretisation.md
// (D4.9).
//
// 1. Balances to rounding, in every step: with a uniform source q and body
// force
//    f the heat of the body grows by heat_left + heat_right + heat_sides + q t
//    less (1, aD u), its momentum by both impulses less that of the contact and
//    f t. In a rod, a strip and a block, by both solvers, in a row; heat by a
//    given temperature, constant or not, that jumps, by exchange, by k(gap, p);
//    forces by a support that rests or moves, traction, spring and dashpot; of
//    box the heat alone, whose velocities are means over cells.
// 2. Closed forms: a rod at rest between 1 and an exchange k = 3 with 0 has the
//    flux 3/4. A rod of b = 1 whose end starts to move with velocity 1 pulls
//    with the impedance 1 until the echo comes back at t = 2: impulse_left t,
//    work_left t, the energy, to rounding by box. A static rod under a traction
//    1 from t = 1/2 on that acts at once: work 1, against a spring 1 on the
//    same end 1/2 - 1/8 = 3/8 in all.
// 3. An end that is driven, or pulled, does all the work where nothing else
//    does: work_left + work_right is column work.
// 4. The mirror image of a rod that is free at both ends, with exchange, heat
//    fluxes, tractions, springs and dashpots, has heat and work of the other
//    end, and its impulse with the other sign, to rounding.

#include <cmath>

#include "../recorded_run.h"
#include "../row_checks.h"

using namespace ThermoContact;

namespace
{
  const Overrides boundaries = {"Output/Boundaries=true"};

  const double q = 0.7, f = -0.3;



  /** Largest defects of the balances of heat and momentum. */
  template <int dim>
  void
  check_balances(const std::string &name,
                 const Overrides   &overrides,
                 const bool         has_momentum = true)
  {
    const Overrides sources = {"Sources/Heat source=" + std::to_string(q),
                               dim == 1 ? "Sources/Body force=-0.3" :
                               dim == 2 ? "Sources/Body force=-0.3; 0" :
                                          "Sources/Body force=-0.3; 0; 0",
                               "Dimension=" + std::to_string(dim)};
    Simulation<dim> simulation(
      read_parameters("", boundaries + sources + overrides), MPI_COMM_SELF);
    double heat_0 = 0., momentum_0 = 0., heat = 0., momentum = 0.;
    double most_heat = 0., most_momentum = 0.;
    simulation.run({[&](const Simulation<dim> &s) {
      const Body<dim>    &body  = s.body();
      const State        &state = s.state();
      const StepRecord   &r     = s.record();
      const BoundarySums &sums  = r.boundaries;
      const double        area = body.discretization.geometry().cross_section();
      ThermoContact::Vector content(state.temperature),
        heating(state.temperature);
      ThermoContact::Vector motion(state.velocity);
      body.equations.heat_mass.vmult(content, state.temperature);
      body.equations.divergence.vmult(heating, state.displacement);
      body.equations.momentum_mass.vmult(motion, state.velocity);
      double now = 0., moving = 0.;
      for (unsigned int i = 0; i < content.locally_owned_size(); ++i)
        now +=
          content.begin()[i] + body.scene.material.heating * heating.begin()[i];
      const auto &nodes = body.discretization.nodal_values(Field::displacement);
      for (unsigned int i = 0; i < motion.locally_owned_size(); ++i)
        if (nodes[i].component == 0)
          moving += body.scene.material.inertia * motion.begin()[i];
      now /= area;
      moving /= area;
      if (r.step == 0)
        {
          heat_0     = now;
          momentum_0 = moving;
        }
      heat = sums.heat_left + sums.heat_right + sums.heat_sides + q * r.time;
      const double of_obstacle = r.contacts.empty() ?
                                   r.contact_impulse :
                                   r.contacts.back().contact_impulse;
      momentum =
        sums.impulse_left + sums.impulse_right - of_obstacle + f * r.time;
      raise(most_heat, std::abs(now - heat_0 - heat));
      raise(most_momentum, std::abs(moving - momentum_0 - momentum));
    }});
    deallog << name << ": heat " << within(most_heat, 1e-10);
    if (has_momentum)
      deallog << ", momentum " << within(most_momentum, 1e-10);
    const BoundarySums &sums = simulation.record().boundaries;
    deallog << ", all parts"
            << (sums.heat_left != 0. && sums.heat_right != 0. ? " of heat" : "")
            << (sums.impulse_left != 0. ? " of force" : "")
            << (simulation.events().empty() ? "" : ", contact") << std::endl;
  }



  void
  check_resistances()
  {
    const RecordedRun result =
      run<1>("",
             boundaries + Overrides{"Model/Fields=temperature",
                                    "Boundary/left/Temperature=1",
                                    "Boundary/right/Heat exchange=3",
                                    "Boundary/right/Surroundings=0",
                                    "Initial values/Temperature=1-0.75*x",
                                    "Time/End time=2"});
    const BoundarySums &sums = result.rows.back().boundaries;
    deallog << "at rest: left " << within(std::abs(sums.heat_left - 1.5), 1e-10)
            << ", right " << within(std::abs(sums.heat_right + 1.5), 1e-10)
            << std::endl;
  }



  void
  check_impedance()
  {
    const RecordedRun result =
      run<1>("",
             boundaries + Overrides{"Model/Fields=displacement",
                                    "Model/Viscosity=0",
                                    "Boundary/left/Displacement=t",
                                    "Boundary/right/Support=free",
                                    "Initial values/Velocity=0",
                                    "Time/Scheme=box",
                                    "Time/End time=1.9"});
    double impulse = 0., work = 0., energy = 0.;
    for (const StepRecord &r : result.rows)
      {
        raise(impulse, std::abs(r.boundaries.impulse_left - r.time));
        raise(work, std::abs(r.boundaries.work_left - r.time));
        raise(energy, std::abs(r.boundaries.work_left - r.energy));
      }
    deallog << "impedance: impulse " << within(impulse, 1e-11) << ", work "
            << within(work, 1e-11) << ", energy " << within(energy, 1e-11)
            << std::endl;
  }



  void
  check_jump_of_traction()
  {
    for (const double spring : {0., 1.})
      {
        const RecordedRun result =
          run<1>("",
                 boundaries +
                   Overrides{"Model/Fields=displacement",
                             "Model/Inertia=0",
                             "Model/Viscosity=0",
                             "Boundary/right/Support=free",
                             "Boundary/right/Traction=if(t < 0.5, 0, 1)",
                             entry("Boundary/right/Spring", spring),
                             "Time/End time=1"});
        const double u    = 1. / (1. + spring);
        const double work = u - 0.5 * spring * u * u;
        deallog << "jump of a traction, spring " << spring << ": work "
                << within(std::abs(result.rows.back().boundaries.work_right -
                                   work),
                          1e-10)
                << std::endl;
      }
  }



  /** Of scenes in which the boundary alone does work. */
  template <int dim>
  void
  check_work(const std::string &name, const Overrides &overrides)
  {
    const RecordedRun result =
      run<dim>("",
               boundaries +
                 Overrides{"Model/Fields=displacement",
                           "Dimension=" + std::to_string(dim)} +
                 overrides);
    double defect = 0., scale = 0.;
    for (const StepRecord &r : result.rows)
      {
        raise(defect,
              std::abs(r.boundaries.work_left + r.boundaries.work_right -
                       r.work));
        raise(scale, std::abs(r.work));
      }
    deallog << name << ": work " << within(defect / scale, 1e-10) << std::endl;
  }



  void
  check_mirror_image()
  {
    Overrides         scene[2]  = {{"Boundary/right/Support=free",
                                    "Boundary/left/Support=free",
                                    "Boundary/left/Temperature=none",
                                    "Time/Scheme=sdirk4",
                                    "Time/Tolerance=1e-4",
                                    "Time/End time=2"},
                                   {}};
    const std::string ends[]    = {"left/", "right/"};
    const std::string common[]  = {"Heat exchange=2",
                                   "Surroundings=3",
                                   "Heat flux=cos(t)",
                                   "Traction=sin(2*t)",
                                   "Spring=4",
                                   "Dashpot=0.3"};
    const std::string other[]   = {"Heat exchange=1",
                                   "Surroundings=-1",
                                   "Heat flux=t",
                                   "Traction=0.2*t",
                                   "Spring=2",
                                   "Dashpot=0.1"};
    scene[1]                    = scene[0];
    const std::string initial[] = {"x", "(1-x)"};
    RecordedRun       result[2];
    for (unsigned int image = 0; image < 2; ++image)
      {
        for (const std::string &entry : common)
          scene[image].push_back("Boundary/" + ends[image] + entry);
        for (const std::string &entry : other)
          scene[image].push_back("Boundary/" + ends[1 - image] + entry);
        scene[image].push_back("Initial values/Temperature=exp(" +
                               initial[image] + ")");
        scene[image].push_back(
          "Initial values/Velocity=" + std::string(image == 0 ? "" : "-") +
          "sin(" + initial[image] + ")");
        result[image] = run<1>("", boundaries + scene[image]);
      }
    double difference = 0.;
    for (unsigned int i = 0;
         i < std::min(result[0].rows.size(), result[1].rows.size());
         ++i)
      {
        const BoundarySums &a = result[0].rows[i].boundaries,
                           &b = result[1].rows[i].boundaries;
        for (const double d : {a.heat_left - b.heat_right,
                               a.heat_right - b.heat_left,
                               a.impulse_left + b.impulse_right,
                               a.impulse_right + b.impulse_left,
                               a.work_left - b.work_right,
                               a.work_right - b.work_left})
          raise(difference, std::abs(d));
      }
    deallog << "mirror image: rows "
            << (result[0].rows.size() == result[1].rows.size() ? "as many" :
                                                                 "differ")
            << ", " << within(difference, 1e-11) << std::endl;
  }
} // namespace



void
main_boundaries()
{
  initlog();
  const Overrides warm   = {"Boundary/left/Temperature=1+sin(3*t)",
                            "Boundary/sides/Heat exchange=0.4",
                            "Boundary/sides/Surroundings=-1",
                            "Initial values/Temperature=cos(3*x)",
                            "Mesh/Cells=12",
                            "Time/End time=2"};
  const Overrides moved  = {"Boundary/left/Displacement=0.1*sin(5*t)",
                            "Contact/Gap=0.05"};
  const Overrides pushed = {"Boundary/left/Support=free",
                            "Boundary/left/Temperature=none",
                            "Boundary/left/Heat exchange=2",
                            "Boundary/left/Surroundings=3",
                            "Boundary/left/Heat flux=cos(t)",
                            "Boundary/left/Traction=-sin(2*t)",
                            "Boundary/right/Traction=0.2*t",
                            "Boundary/right/Heat flux=t",
                            "Contact/Gap=0.05"};
  const Overrides held   = {"Boundary/left/Spring=4",
                            "Boundary/left/Dashpot=0.3",
                            "Boundary/right/Spring=2",
                            "Boundary/right/Dashpot=0.2"};
  const Overrides by_law = {
    "Boundary/right/Heat exchange=if(pressure > 0, 10 + 5*pressure, "
    "0.1/(0.1 + gap))"};
  const Overrides coarse   = {"Mesh/Cells=4",
                              "Mesh/Cells across=2",
                              "Mesh/Degree=2",
                              "Time/Tolerance=1e-3",
                              "Time/End time=0.5"};
  const Overrides direct   = {"Solver/Linear solver=direct"};
  const Overrides iterated = {"Solver/Linear solver=iterative",
                              "Solver/Linear tolerance=1e-13"};

  for (const std::string scheme :
       {"backward euler", "sdirk2", "sdirk3", "sdirk4"})
    {
      const Overrides by = {"Time/Scheme=" + scheme,
                            scheme == "backward euler" ?
                              "Time/Start=consistent" :
                              "Time/Start=automatic",
                            scheme == "sdirk3" || scheme == "sdirk4" ?
                              "Time/Tolerance=1e-4" :
                              "Time/Step size=0.01"};
      check_balances<1>(scheme + ", moved", warm + moved + by);
      check_balances<1>(scheme + ", pushed", warm + pushed + held + by);
      check_balances<1>(scheme + ", k(gap, p)", warm + moved + by_law + by);
    }
  check_balances<1>("energy conserving",
                    warm + pushed +
                      Overrides{"Time/Scheme=energy conserving",
                                "Time/Step size=0.01"});
  check_balances<1>("box", warm + moved + Overrides{"Time/Scheme=box"}, false);
  check_balances<1>("jump of the temperature",
                    warm + moved +
                      Overrides{"Boundary/left/Temperature=if(t < 1, 1, 4)"});
  check_balances<1>("static, jump",
                    warm +
                      Overrides{"Model/Inertia=0",
                                "Model/Viscosity=0",
                                "Boundary/left/Temperature=if(t < 1, 1, 4)",
                                "Boundary/right/Traction=if(t < 0.7, 0, 1)",
                                "Sources/Body force=0"},
                    false);
  check_balances<1>("impacts on a rigid obstacle",
                    warm + moved +
                      Overrides{"Mesh/Cells=2",
                                "Mesh/Degree=1",
                                "Contact/Condition=rigid",
                                "Contact/Massless nodes=off",
                                "Time/Scheme=sdirk4"});
  check_balances<1>("right temperature",
                    warm + Overrides{"Boundary/left/Displacement=0.1*sin(5*t)",
                                     "Boundary/right/Temperature=2",
                                     "Boundary/right/Support=clamped"});
  check_balances<1>("row",
                    moved + by_law + body("a", {"Length=0.5", "Velocity=0.3"}) +
                      body("b", {"Length=0.5", "Temperature=2"}) +
                      Overrides{"Boundary/left/Temperature=1+sin(3*t)",
                                "Time/Scheme=sdirk4",
                                "Time/End time=2"});
  for (const Overrides &solver : {direct, iterated})
    {
      const std::string by = solver == direct ? ", direct" : ", iterative";
      check_balances<2>("strip, moved" + by, warm + moved + coarse + solver);
      check_balances<2>("strip, pushed" + by, warm + pushed + coarse + solver);
    }
  check_balances<2>("strip before a mass",
                    warm + by_law + coarse + direct +
                      body("bar", {"Kind=rod"}) +
                      body("ram", {"Kind=mass", "Velocity=-1"}) +
                      Overrides{"Contact/Gap=0.05"},
                    false);
  check_balances<3>("block", warm + moved + by_law + coarse + direct);

  check_resistances();
  check_impedance();
  check_jump_of_traction();

  check_mirror_image();
  check_work<1>("driven", {"Boundary/left/Displacement=0.1*sin(5*t)"});
  check_work<1>("box, driven",
                {"Boundary/left/Displacement=0.1*sin(5*t)",
                 "Time/Scheme=box",
                 "Model/Viscosity=0"});
  check_work<1>("box, pulled",
                {"Boundary/left/Support=free",
                 "Boundary/left/Traction=-sin(2*t)",
                 "Boundary/right/Support=free",
                 "Boundary/right/Traction=0.2*t",
                 "Time/Scheme=box",
                 "Model/Viscosity=0"});
  check_work<1>("pulled at both ends",
                {"Boundary/left/Support=free",
                 "Boundary/left/Traction=-sin(2*t)",
                 "Boundary/right/Traction=0.2*t"});
  check_work<2>("strip",
                {"Boundary/left/Support=free",
                 "Boundary/left/Traction=(1+y)*sin(2*t)",
                 "Boundary/right/Traction=0.2*t*(1-y)",
                 "Mesh/Cells=4",
                 "Mesh/Cells across=2",
                 "Mesh/Degree=2",
                 "Time/End time=1"});
}
