// SPDX-License-Identifier: LGPL-2.1-or-later
//
// Rods of a row whose coefficients are expressions of x, doc/model.md (M10.1),
// against closed forms. Length 1 unless something else is said.
//
// 1. Static, A = exp(-x), E = 1 + x, force f = 1/10 at the right end:
//    u = f times the integral of exp(x)/(1 + x), by a series here; the stress
//    at x = 0.45 is f exp(0.45). The mesh of 3 linear cells, whose stiffness is
//    that of the parts in series, has it exactly at its nodes, too. Without
//    inertia, zeta = 1/2 and four times that in the right half, f starts with
//    v(1) = f/zeta (1/2 + 1/8); where A = 2 the stress is f/2 at once.
// 2. Cone A = (1 + x)^2, clamped on the left, free on the right, b = 1:
//    u = sin(w x)/(1 + x) cos(w t) with tan(w) = 2 w: sdirk4 with cells of
//    degree 4 to the tolerance; box of order 2.
// 3. Heat: K = 1, 2 and 5 up to x = 0.3, 0.7 and 1, theta_A = 10, k = 1:
//    resistance 0.56 + 1, theta(1) = 10/1.56, which cells across a jump would
//    miss; A = 1 + x, K = 1: log(2) + 1/k, where the exchange at the right end
//    is per area of the scene; with sides that exchange m A (theta_s - theta)
//    and nothing else all of the rod comes to theta_s. A source 1 per volume
//    warms an insulated rod with A = 1 + x and c = 2 by t/2.
// 4. E = 1 + x, density 1/(1 + x): no wave is reflected within the rod. Free,
//    velocity 1, at a rigid obstacle: p = 1 for the time 2 log(2), then it
//    flies back with velocity -1. All cells are passed in the same time.
// 5. One rod that jumps at x = 1/2 is two bonded ones: section, stiffness,
//    density, viscosity, coupling, conductivity, heat capacity, with box and
//    sdirk4, heat on the sides, body force, contact at the end.
// 6. A rod and its mirror image, A(1 - x), E(1 - x), ..., pulled from the other
//    side: the same displacements.
// 7. All coefficients vary: E + D + N - W is that of the start to 1e-12.
// 8. Two bonded rods of length 1, box; the half that touches a rigid stop has
//    velocity 1: its energy is 1/4, and the wave that goes to the stop presses
//    with 1 for the time 1/2.

#include <thermocontact/space/point_values.h>

#include <algorithm>
#include <cmath>

#include "../tests.h"

#include "../recorded_run.h"

using namespace ThermoContact;

namespace
{
  const Overrides elastic = {"Model/Fields=displacement", "Model/Viscosity=0"};

  const Overrides free_right = {"Boundary/right/Support=free"};



  void
  check_static()
  {
    // exp(x)/(1 + x): with y = 1 + x, exp(y)/(e y)
    double exact = std::log(2.), power = 1., factorial = 1.;
    for (unsigned int n = 1; n < 40; ++n)
      {
        power *= 2.;
        factorial *= n;
        exact += (power - 1.) / (n * factorial);
      }
    exact *= 0.1 / std::exp(1.);
    for (const unsigned int degree : {1, 4})
      {
        const Parameters scene =
          read_parameters("",
                          elastic + free_right +
                            body("bar",
                                 {"Section=exp(-x)",
                                  "Stiffness=1+x",
                                  entry("Cells", degree == 1 ? 3 : 12)}) +
                            Overrides{"Model/Inertia=0",
                                      "Boundary/right/Traction=0.1",
                                      entry("Mesh/Degree", degree),
                                      "Time/Tolerance=1e-10",
                                      "Time/End time=1"});
        Simulation<1> simulation(scene, MPI_COMM_SELF);
        simulation.run({});
        PointValues<1> values(simulation.body().scene,
                              simulation.body().discretization,
                              {{Point<1>(0.45), Point<1>(0.45)}});
        const double   stress =
          values.evaluate(simulation.state())[PointValues<1>::stress];
        deallog << "static, degree " << degree << ": u(1) "
                << within(std::abs(simulation.record().displacement_end -
                                   exact),
                          1e-11)
                << ", stress "
                << within(std::abs(stress - 0.1 * std::exp(0.45)), 1e-8)
                << std::endl;
      }
    const StepRecord pulled =
      run<1>("",
             Overrides{"Model/Fields=displacement",
                       "Model/Inertia=0",
                       "Model/Viscosity=0.5",
                       "Boundary/right/Traction=0.1",
                       "Time/End time=0.1"} +
               free_right + body("bar", {"Viscosity=if(x<0.5,1,4)", "Cells=2"}))
        .rows.front();
    deallog << "viscous: v(1) "
            << within(std::abs(pulled.velocity_end - 0.125), 1e-11);
    Simulation<1> taper(
      read_parameters("",
                      Overrides{"Model/Fields=displacement",
                                "Model/Inertia=0",
                                "Model/Viscosity=0.5",
                                "Boundary/right/Traction="
                                "0.1",
                                "Time/End time=0"} +
                        free_right +
                        body("bar", {"Section=if(x<0.5,1,2)", "Cells=2"})),
      MPI_COMM_SELF);
    PointValues<1> there(taper.body().scene,
                         taper.body().discretization,
                         {{Point<1>(0.75), Point<1>(0.75)}});
    const double stress = there.evaluate(taper.state())[PointValues<1>::stress];
    deallog << ", stress " << within(std::abs(stress - 0.05), 1e-11)
            << std::endl;
  }



  double
  error_of_cone(const Overrides &scheme)
  {
    double w = 1.2;
    for (unsigned int i = 0; i < 50; ++i)
      w = std::atan(2. * w);
    char digits[40];
    std::snprintf(digits, sizeof digits, "%.17g", w);
    const RecordedRun result =
      run<1>("",
             elastic + free_right +
               body("cone",
                    {"Section=(1+x)^2",
                     std::string("Displacement=0.1*sin(") + digits +
                       "*x)/(1+x)"}) +
               Overrides{"Time/End time=3"} + scheme);
    double error = 0.;
    for (const StepRecord &row : result.rows)
      raise(error,
            std::abs(row.displacement_end -
                     0.05 * std::sin(w) * std::cos(w * row.time)));
    return error;
  }



  void
  check_cone()
  {
    deallog << "cone: sdirk4 "
            << within(error_of_cone({"Time/Scheme=sdirk4",
                                     "Bodies/cone/Cells=16",
                                     "Time/Tolerance=1e-10"}),
                      1e-9);
    const double coarse =
                   error_of_cone({"Time/Scheme=box", "Bodies/cone/Cells=50"}),
                 fine =
                   error_of_cone({"Time/Scheme=box", "Bodies/cone/Cells=100"});
    deallog << ", box " << within(fine, 1e-5) << ", of order 2 "
            << (coarse / fine > 3.6 && coarse / fine < 4.4) << std::endl;
  }



  void
  check_heat()
  {
    const auto at_rest = [](const Overrides &scene) {
      return run<1>("",
                    scene +
                      Overrides{"Time/Tolerance=1e-10", "Time/End time=40"})
        .rows.back();
    };
    const Overrides thermal = {"Model/Fields=temperature"};
    const Overrides layers =
      body("rod", {"Conductivity=if(x<0.3,1,if(x<0.7,2,5))", "Cells=5"}) +
      Overrides{"Boundary/left/Temperature=10", "Mesh/Degree=4"};
    // the end of a row that meets nothing
    const StepRecord flux = at_rest(
      layers + free_right +
      Overrides{"Model/Inertia=0", "Boundary/right/Heat exchange=1+0*t"});
    deallog << "flux of the right end "
            << within(std::abs(flux.heat_flux_end - 10. / 1.56), 1e-8)
            << std::endl;
    const StepRecord heated =
      run<1>("",
             body("rod", {"Section=1+x", "Heat capacity=2"}) + thermal +
               Overrides{"Boundary/left/Temperature=none",
                         "Boundary/right/Heat exchange=0",
                         "Sources/Heat source=1",
                         "Time/End time=3"})
        .rows.back();
    deallog << "heat source: "
            << within(std::abs(heated.temperature_end - 1.5), 1e-11)
            << std::endl;
    for (const std::string degree : {"1", "4"})
      deallog
        << "heat, degree " << degree << ": layers "
        << within(std::abs(at_rest(layers + thermal +
                                   Overrides{"Mesh/Degree=" + degree,
                                             "Boundary/right/Heat exchange="
                                             "1"})
                             .temperature_end -
                           10. / 1.56),
                  1e-8)
        << ", taper "
        << within(std::abs(at_rest(body("rod", {"Section=1+x", "Cells=8"}) +
                                   thermal +
                                   Overrides{"Mesh/Degree=" + degree,
                                             "Boundary/left/Temperature=10",
                                             "Boundary/right/Heat exchange="
                                             "1"})
                             .temperature_end -
                           10. / (1. + std::log(2.))),
                  1e-8)
        << ", sides "
        << within(std::abs(at_rest(body("rod", {"Section=1+x", "Cells=8"}) +
                                   thermal +
                                   Overrides{"Mesh/Degree=" + degree,
                                             "Boundary/left/Temperature=none",
                                             "Boundary/right/Heat exchange=0",
                                             "Boundary/sides/Heat exchange=2",
                                             "Boundary/sides/Surroundings=3"})
                             .temperature_end -
                           3.),
                  1e-8)
        << std::endl;
  }



  void
  check_impact()
  {
    const RecordedRun result =
      run<1>("",
             elastic +
               body("rod", {"Stiffness=1+x", "Density=1/(1+x)", "Velocity=1"}) +
               Overrides{"Boundary/left/Support=free",
                         "Contact/Condition=rigid",
                         "Contact/Gap=0",
                         "Mesh/Cells=200",
                         "Time/End time=2"});
    const double duration = 2. * std::log(2.);
    double       force = 0., size = 0.;
    for (const StepRecord &row : result.rows)
      {
        if (row.time > 0. && row.time < duration - 2. * row.step_size)
          raise(force, std::abs(row.contact_force - 1.));
        raise(size, row.step_size);
      }
    deallog << "no reflections: force " << within(force, 1e-11) << ", impulse "
            << within(std::abs(result.rows.back().contact_impulse - duration),
                      1e-11)
            << ", end "
            << within(std::abs(result.events[1].time - duration), 1e-12)
            << ", velocity behind "
            << within(std::abs(result.events[1].velocity + 1.), 1e-10)
            << ", steps "
            << within(std::abs(size / (std::log(2.) / 200.) - 1.), 1e-6)
            << ", events " << result.events.size() << std::endl;
  }



  void
  check_parts()
  {
    for (const std::string scheme : {"box", "sdirk4"})
      {
        const bool        is_box = scheme == "box";
        const Overrides   common = {"Time/Scheme=" + scheme,
                                  is_box ? "Mesh/Degree=1" : "Mesh/Degree=3",
                                    "Model/Coupling=0.3",
                                    "Model/Viscosity=0.1",
                                    "Contact/Condition=normal compliance",
                                    "Contact/Compliance=0.02",
                                    "Contact/Gap=0.02",
                                    "Boundary/right/Heat exchange=2",
                                    "Boundary/left/Temperature=1",
                                    "Boundary/sides/Heat exchange=0.5",
                                    "Sources/Body force=0.2*sin(3*t)",
                                    "Sources/Heat source=1",
                                    "Time/Step size=0.0125",
                                    "Time/End time=2"};
        const RecordedRun whole =
          run<1>("",
                 common + body("rod",
                               {"Section=if(x<0.5,1,2)",
                                "Stiffness=if(x<0.5,1,4)",
                                "Density=if(x<0.5,2,0.5)",
                                "Viscosity=if(x<0.5,1,3)",
                                "Coupling=if(x<0.5,1,-0.5)",
                                "Conductivity=if(x<0.5,1,7)",
                                "Heat capacity=if(x<0.5,1,1.5)",
                                "Temperature=1-x",
                                "Velocity=x",
                                "Cells=50"}));
        const RecordedRun parts =
          run<1>("",
                 common +
                   body("a",
                        {"Length=0.5",
                         "Density=2",
                         "Temperature=1-x",
                         "Velocity=x",
                         "Cells=40"}) +
                   body("b",
                        {"Length=0.5",
                         "Section=2",
                         "Stiffness=4",
                         "Density=0.5",
                         "Viscosity=3",
                         "Coupling=-0.5",
                         "Conductivity=7",
                         "Heat capacity=1.5",
                         "Temperature=0.5-x",
                         "Velocity=0.5+x",
                         "Cells=10"}) +
                   Overrides{"Contacts/a b/Condition=bonded"});
        double u = 0., theta = 0., force = 0., scale = 0.;
        for (unsigned int i = 0; i < whole.rows.size(); ++i)
          {
            const StepRecord &a = whole.rows[i], &b = parts.rows[i];
            raise(u, std::abs(a.displacement_end - b.displacement_end));
            raise(theta, std::abs(a.temperature_end - b.temperature_end));
            raise(force, std::abs(a.contact_force - b.contact_force));
            raise(scale, std::abs(a.contact_force));
          }
        deallog << scheme << ", jumps: rows "
                << (whole.rows.size() == parts.rows.size()) << ", u(1) "
                << within(u, 1e-11) << ", theta(1) " << within(theta, 1e-11)
                << ", force " << within(force / scale, 1e-10) << std::endl;
      }
  }



  void
  check_mirror()
  {
    for (const std::string scheme : {"box", "sdirk4"})
      {
        const bool      is_box = scheme == "box";
        const Overrides common =
          elastic + free_right +
          Overrides{"Boundary/left/Support=free",
                    "Time/Scheme=" + scheme,
                    is_box ? "Mesh/Degree=1" : "Mesh/Degree=3",
                    "Model/Viscosity=0.01",
                    "Bodies/rod/Cells=20",
                    "Time/Step size=0.02",
                    "Time/End time=1"};
        const auto ends = [&](const Overrides &scene) {
          Simulation<1> simulation(read_parameters("", common + scene),
                                   MPI_COMM_SELF);
          simulation.run({});
          PointValues<1> values(simulation.body().scene,
                                simulation.body().discretization,
                                {{Point<1>(0.), Point<1>(0.)},
                                 {Point<1>(1.), Point<1>(1.)}});
          const auto    &all = values.evaluate(simulation.state());
          return std::array<double, 2>{
            {all[2 * PointValues<1>::displacement],
             all[2 * PointValues<1>::displacement + 1]}};
        };
        const auto right = ends({"Bodies/rod/Section=1+x^2",
                                 "Bodies/rod/Stiffness=1+x",
                                 "Bodies/rod/Density=exp(x)",
                                 "Bodies/rod/Viscosity=x",
                                 "Boundary/right/Traction=0.1*sin(t)"});
        const auto left  = ends({"Bodies/rod/Section=1+(1-x)^2",
                                 "Bodies/rod/Stiffness=2-x",
                                 "Bodies/rod/Density=exp(1-x)",
                                 "Bodies/rod/Viscosity=1-x",
                                 "Boundary/left/Traction=0.1*sin(t)"});
        deallog << scheme << ", mirrored: "
                << within(std::max(std::abs(right[0] + left[1]),
                                   std::abs(right[1] + left[0])),
                          1e-11)
                << ", moves " << (right[1] > 1e-3) << std::endl;
      }
  }



  void
  check_audit()
  {
    for (const std::string scheme : {"box", "sdirk4"})
      {
        const RecordedRun result =
          run<1>("",
                 body("a",
                      {"Section=1+x",
                       "Stiffness=if(x<0.4,1,2+x)",
                       "Density=2-x",
                       "Viscosity=x",
                       "Coupling=1-2*x",
                       "Conductivity=1+x^2",
                       "Heat capacity=exp(x)",
                       "Velocity=1",
                       "Temperature=x"}) +
                   body("b", {"Length=0.5", "Section=exp(-x)"}) +
                   Overrides{"Model/Coupling=0.3",
                             "Model/Viscosity=0.02",
                             "Boundary/left/Support=free",
                             "Boundary/left/Temperature=none",
                             "Boundary/right/Heat exchange=2",
                             "Boundary/sides/Heat exchange=0.5",
                             "Contact/Condition=normal compliance",
                             "Contact/Compliance=0.01",
                             "Contact/Gap=0.05",
                             "Mesh/Cells=40",
                             "Time/Scheme=" + scheme,
                             "Time/End time=2"});
        const StepRecord &first  = result.rows.front();
        double            defect = 0.;
        for (const StepRecord &row : result.rows)
          raise(defect,
                std::abs(row.energy + row.dissipation +
                         row.numerical_dissipation + row.contact_dissipation -
                         row.work - first.energy));
        deallog << scheme << ", audit: defect "
                << within(defect / first.energy, 1e-12) << ", met "
                << (result.rows.back().contacts[0].contact_impulse > 0.)
                << std::endl;
      }
  }



  void
  check_bonded_start()
  {
    const auto rows =
      run<1>("",
             elastic + body("a", {"Cells=100"}) +
               body("b", {"Cells=100", "Velocity=if(x>0.5,1,0)"}) +
               Overrides{"Contacts/a b/Condition=bonded",
                         "Contact/Condition=rigid",
                         "Contact/Gap=0",
                         "Time/Scheme=box",
                         "Time/End time=3"})
        .rows;
    deallog << "bonded rods start: energy "
            << within(std::abs(rows.front().energy - 0.25), 1e-12)
            << ", impulse "
            << within(std::abs(rows.back().contact_impulse - 0.5), 1e-12)
            << std::endl;
  }
} // namespace



void
main_varying_rods()
{
  initlog();
  check_static();
  check_cone();
  check_heat();
  check_impact();
  check_parts();
  check_mirror();
  check_audit();
  check_bonded_start();
}
