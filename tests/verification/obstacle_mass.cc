// SPDX-License-Identifier: LGPL-2.1-or-later
//
// A rigid mass as the obstacle of a body in two and three dimensions,
// doc/model.md (M10.10).
//
// 1. On rollers a strip and a block are the rod, and the mass behind them is
//    the one of a row "bar ram": force, velocity and place of the mass, place
//    of the bar in its middle, with gravity, heat and viscosity, for an
//    elastic, a damped and a power law: to rounding, at the same steps. So is
//    the temperature of the mass, which exchanges heat with the bar.
// 2. A mass that nothing meets: m Y'' + d Y' + k Y = t, with m = 2, k = 8, d =
//    0.4, t = 0.3 in the mean and Y' = 1 at first: Y = t/k + exp(-c t) (A cos(w
//    t) + B sin(w t)), c = d/(2 m), w^2 = k/m - c^2. The impulse at the right
//    end is m (Y' - 1), in boundaries.csv, the work m/2 (Y'^2 - 1); the body
//    has no stress.
// 3. A mass flies at a block, a round one at its axis, with velocity -0.5: the
//    impulse of the contact is what the mass gets, m (V + 0.5), and E + D + N -
//    W is that of the start to 1e-12.
// 4. Half of a strip with a plane of symmetry, width 0.05, has half the mass
// and
//    the same motion.

#include <algorithm>
#include <cmath>

#include "../tests.h"

#include "../recorded_run.h"

using namespace ThermoContact;

namespace
{
  // ------------------------------------------------------------ 1. the row

  template <int dim>
  double
  difference_from_row(const Overrides &law, const std::string &exchange = "0")
  {
    const Overrides   scene = law + Overrides{"Model/Viscosity=0.05",
                                            "Model/Coupling=0.3",
                                            "Contact/Gap=0.02",
                                            "Sources/Body force=-0.1",
                                            "Mesh/Degree=2",
                                            "Time/Scheme=sdirk4",
                                            "Time/Step size=0.02",
                                            "Time/Locate contact events=false",
                                            "Time/End time=2"};
    const Overrides   ram   = body("ram",
                               {"Kind=mass",
                                    "Mass=0.7",
                                    "Velocity=-0.3",
                                    "Temperature=5",
                                    "Heat capacity=0.4"});
    const RecordedRun row   = run<1>("",
                                   body("bar", {"Cells=8"}) + ram + scene +
                                     Overrides{"Boundary/right/Support=free",
                                               "Boundary/right/Heat exchange=0",
                                               "Contacts/bar ram/Heat "
                                                 "exchange=" +
                                                 exchange});
    const RecordedRun of_body =
      run<dim>("",
               body("bar", {"Kind=rod"}) + ram + scene +
                 Overrides{"Dimension=" + std::to_string(dim),
                           "Mesh/Cells=8",
                           "Mesh/Cells across=2",
                           "Initial values/Temperature=0",
                           "Initial values/Displacement=0",
                           "Initial values/Velocity=0",
                           "Boundary/right/Heat exchange=" + exchange,
                           "Boundary/sides/Support=rollers"});
    double difference = row.rows.size() == of_body.rows.size() ? 0. : 1.;
    double force      = 0.;
    for (unsigned int i = 0; i < row.rows.size() && difference < 1.; ++i)
      {
        const StepRecord &one = row.rows[i], &other = of_body.rows[i];
        raise(difference, std::abs(one.contact_force - other.contact_force));
        raise(difference,
              std::abs(one.displacement_end - other.obstacle_displacement));
        raise(difference, std::abs(one.velocity_end - other.obstacle_velocity));
        raise(difference, std::abs(one.contacts[0].gap - other.gap));
        raise(difference,
              std::abs(one.temperature_end - other.obstacle_temperature));
        raise(difference,
              std::abs(one.contacts[0].heat_flux - other.heat_flux_end));
        raise(force, one.contact_force);
      }
    return force > 0.1 ? difference : 1.;
  }



  // ------------------------------------------------------- 2. an oscillator

  void
  check_oscillator()
  {
    const RecordedRun result =
      run<2>("",
             body("bar", {"Kind=rod"}) +
               body("ram", {"Kind=mass", "Mass=2", "Velocity=1"}) +
               Overrides{"Dimension=2",
                         "Model/Fields=displacement",
                         "Contact/Gap=1",
                         "Initial values/Velocity=0",
                         "Boundary/right/Spring=8",
                         "Boundary/right/Dashpot=0.4",
                         "Boundary/right/Traction=0.6*y/0.1",
                         "Boundary/sides/Support=free",
                         "Mesh/Cells=2",
                         "Mesh/Cells across=1",
                         "Mesh/Degree=1",
                         "Output/Boundaries=true",
                         "Time/Tolerance=1e-10",
                         "Time/End time=3"});
    const double c = 0.1, w = std::sqrt(4. - c * c), rest = 0.3 / 8.;
    const double A = -rest, B = (1. + c * A) / w;
    double place = 0., velocity = 0., impulse = 0., work = 0., stress = 0.;
    for (const StepRecord &row : result.rows)
      {
        const double decay  = std::exp(-c * row.time),
                     cosine = std::cos(w * row.time),
                     sine   = std::sin(w * row.time);
        const double Y      = rest + decay * (A * cosine + B * sine),
                     V      = decay *
                         ((B * w - c * A) * cosine - (A * w + c * B) * sine);
        raise(place, std::abs(row.obstacle_displacement - Y));
        raise(velocity, std::abs(row.obstacle_velocity - V));
        raise(impulse, std::abs(row.boundaries.impulse_right - 2. * (V - 1.)));
        raise(work, std::abs(row.boundaries.work_right - (V * V - 1.)));
        raise(stress, std::abs(row.stress_end));
      }
    deallog << "oscillator: " << within(place, 1e-9) << ", "
            << within(velocity, 1e-9) << ", impulse " << within(impulse, 1e-8)
            << ", work " << within(work, 1e-8) << ", stress of the body "
            << within(stress, 1e-12) << std::endl;
  }



  // ------------------------------------------------------ 3., 4. an impact

  template <int dim>
  RecordedRun
  impact(const std::string &mass, const Overrides &more)
  {
    return run<dim>("",
                    body("block", {"Stiffness=1+y"}) +
                      body("ram",
                           {"Kind=mass", "Mass=" + mass, "Velocity=-0.5"}) +
                      Overrides{"Dimension=" + std::to_string(dim),
                                "Model/Viscosity=0.02",
                                "Model/Coupling=0.2",
                                "Contact/Compliance=0.05",
                                "Initial values/Velocity=0",
                                "Initial values/Temperature=0",
                                "Boundary/left/Temperature=0",
                                "Boundary/sides/Support=free",
                                "Mesh/Width=0.4",
                                "Mesh/Cells=4",
                                "Mesh/Cells across=2",
                                "Mesh/Degree=2",
                                "Time/Tolerance=1e-5",
                                "Time/End time=3"} +
                      more);
  }



  template <int dim>
  void
  check_impact(const std::string &name, const Overrides &more)
  {
    const RecordedRun result = impact<dim>("0.3", more);
    double            defect = 0., impulse = 0., force = 0.;
    for (const StepRecord &row : result.rows)
      {
        raise(defect,
              std::abs(row.energy + row.dissipation +
                       row.numerical_dissipation + row.contact_dissipation -
                       row.work - result.rows[0].energy));
        raise(impulse,
              std::abs(0.3 * (row.obstacle_velocity + 0.5) -
                       row.contact_impulse));
        raise(force, row.contact_force);
      }
    const StepRecord &last = result.rows.back();
    deallog << name << ": impulse " << noise_within(impulse, 1e-12)
            << ", balance " << noise_within(defect, 1e-12) << ", events "
            << result.events.size() << ", rebound "
            << (last.obstacle_velocity > 0.05) << std::endl;
  }



  void
  check_half()
  {
    const std::string step = "Time/Step size=0.01";
    const RecordedRun whole =
                        impact<2>("0.3", {"Bodies/block/Stiffness=1", step}),
                      half = impact<2>("0.3",
                                       {"Bodies/block/Stiffness=1",
                                        step,
                                        "Boundary/sides/Support=symmetric",
                                        "Mesh/Width=0.2",
                                        "Mesh/Cells across=1"});
    double difference      = whole.rows.size() == half.rows.size() ? 0. : 1.;
    for (unsigned int i = 0; i < whole.rows.size() && difference < 1.; ++i)
      raise(difference,
            std::abs(whole.rows[i].obstacle_velocity -
                     half.rows[i].obstacle_velocity));
    deallog << "half: " << noise_within(difference, 1e-9) << std::endl;
  }
} // namespace



void
main_obstacle_mass()
{
  initlog();
  const Overrides elastic = {"Contact/Compliance=0.05"};
  deallog << "row, elastic: "
          << noise_within(difference_from_row<2>(elastic), 1e-10) << ' '
          << noise_within(difference_from_row<3>(elastic), 1e-10) << std::endl;
  deallog << "row, dashpot: "
          << noise_within(difference_from_row<2>(
                            {"Contact/Compliance=0.05", "Contact/Dashpot=0.2"}),
                          1e-10)
          << std::endl;
  deallog << "row, power law: "
          << noise_within(difference_from_row<2>({"Contact/Condition=power law",
                                                  "Contact/Exponent=1.5",
                                                  "Contact/Compliance=0.05"}),
                          1e-10)
          << std::endl;
  deallog << "row, heat: "
          << noise_within(difference_from_row<2>(elastic, "2"), 1e-10) << ' '
          << noise_within(difference_from_row<3>(elastic, "0.5"), 1e-10)
          << std::endl;
  check_oscillator();
  check_impact<2>("strip",
                  {"Contact/Gap=0.01",
                   "Boundary/right/Heat exchange=0.1/(0.1+gap)+5*pressure",
                   "Bodies/ram/Temperature=3"});
  check_impact<2>("round bar",
                  {"Contact/Gap=0.01+y^2", "Mesh/Geometry=axisymmetric"});
  check_impact<3>("block",
                  {"Contact/Gap=0.01+(y-0.1)^2+(z-0.2)^2",
                   "Mesh/Cells across=1"});
  check_half();
}
