// SPDX-License-Identifier: LGPL-2.1-or-later
//
// Rods whose coefficients depend on the temperature, doc/model.md (M10.8),
// against closed forms. Length 1.
//
// 1. K = c = 1 + theta/2: with Kirchhoff's H = theta + theta^2/4 the equation
//    is H_t = H_xx, and theta = 2 (sqrt(1 + H) - 1). The mean temperature at
//    t = 0.4: orders of the schemes with 20 and 40 fixed steps for H = 2 + x +
//    exp(-pi^2 t) sin(pi x), whose ends are held; errors as small as
//    tolerances of 1e-6 and 1e-9 say for H = 2 + x + exp(-pi^2 t/4)
//    cos(pi x/2), whose left end is driven.
// 2. At rest, K = 1 + theta/2, theta_A = 4, an obstacle of theta = 1 with k = 2
//    at the other end: H(4) - H(theta) = 2 (theta - 1) there, which is
//    theta = 2 (sqrt(19) - 3).
// 3. c = exp(theta), insulated, heated by q = 1: exp(theta) - 1 = t.
// 4. E = 2 + theta where theta = 1, so E = 3, b = 1, zeta = (1 + 3 theta)/50:
//    u = sin(pi x/2) e^(-d t) (cos(w t) + d/w sin(w t)) with
//    d = 3/8 pi^2 zeta and w^2 = 3/4 pi^2 - d^2.
// 5. At rest, theta = 1 + x, E = 1/(1 + theta), a = (1 + theta)/4, pulled by
//    f = 1/10: u_x = (1 + theta) (f + a theta), u(1) = 5/2 f + 119/48; the
//    stress is f. Static it is so from the start; with b = 0,
//    zeta = 2 (1 + theta) it starts with v_x = (f + a theta)/2,
//    v(1) = (f + 23/24)/2.
// 6. All coefficients, contact, two rods: E + D + N - W is the energy at the
//    start to 1e-12, with N of backward Euler by its own formula (D4.3). One
//    rod between two temperatures, sdirk4: N is as small as the tolerance.

//
// 7. Static, a load that jumps at t = 1/2. Uniform, insulated, theta = 1,
//    a = (1 + theta)/2, to f = 1/2: adiabatic, d theta = -a d eps, so
//    eps = 1 - 2 log((1 + theta)/2) = f + a theta, met to the third order of
//    the jump. E = 2 + theta with a = 0, to
//    0.1: half the work of the load is lost, f^2/6.
// 8. Linear cells have series means at all temperatures: E = exp(8 x) (1 -
//    theta/2) where theta = 1, f = 0.1: u(1) = (1 - exp(-8))/40 with two cells.
//    Thermal strains a theta/E of the parts of a cell add up: a = 1 + 2 x +
//    theta/10, E = 1 have u(1) = f + 2 + 1/10 with one cell. Without Coupling
//    alpha is the same for every E: of a = 3/10 and theta = 1 u(1) = 3/10.
// 9. Clamped at both ends, heated evenly, fixed steps: the motion is rounding
//    alone, and Newton's method settles.
// 10. A rod and its mirror image, laws of 1 - x, ends exchanged: the middle
//    moves as far to the other side, and the mean temperature is the same.

#include <thermocontact/space/point_values.h>

#include <deal.II/base/quadrature_lib.h>

#include <array>
#include <cmath>

#include "../tests.h"

#include "../recorded_run.h"

using namespace ThermoContact;

namespace
{
  const double pi = numbers::PI;

  const Overrides thermal   = {"Model/Fields=temperature"},
                  insulated = {"Boundary/right/Heat exchange=0"};



  /** Of the mean temperature at the end, with wave number @p k. */
  double
  error_of_kirchhoff(const bool is_driven, const Overrides &steps)
  {
    const double     end_time = 0.4, k = is_driven ? pi / 2. : pi;
    const QGauss<1>  rule(40);
    double           exact = 0.;
    const StepRecord last =
      run<1>("",
             thermal +
               body("rod",
                    {"Conductivity=1+theta/2",
                     "Heat capacity=1+theta/2",
                     is_driven ? "Temperature=2*(sqrt(3+x+cos(pi*x/2))-1)" :
                                 "Temperature=2*(sqrt(3+x+sin(pi*x))-1)",
                     "Cells=4"}) +
               Overrides{is_driven ? "Boundary/left/Temperature="
                                     "2*(sqrt(3+exp(-pi^2/4*t))-1)" :
                                     "Boundary/left/Temperature="
                                     "2*(sqrt(3)-1)",
                         "Boundary/right/Temperature=2",
                         "Mesh/Degree=8",
                         entry("Time/End time", end_time)} +
               steps)
        .rows.back();
    for (unsigned int q = 0; q < rule.size(); ++q)
      {
        const double x = rule.point(q)[0];
        const double h = 2. + x +
                         std::exp(-k * k * end_time) *
                           (is_driven ? std::cos(k * x) : std::sin(k * x));
        exact += rule.weight(q) * 2. * (std::sqrt(1. + h) - 1.);
      }
    return std::abs(last.temperature_mean - exact);
  }



  void
  check_kirchhoff()
  {
    const std::array<const char *, 4> schemes = {
      {"backward euler", "sdirk2", "sdirk3", "sdirk4"}};
    for (unsigned int order = 1; order <= schemes.size(); ++order)
      {
        const auto error = [&](const unsigned int n_steps) {
          return error_of_kirchhoff(false,
                                    {std::string("Time/Scheme=") +
                                       schemes[order - 1],
                                     entry("Time/Step size", 0.4 / n_steps)});
        };
        const double observed = std::log2(error(20) / error(40));
        deallog << schemes[order - 1] << ": order "
                << (std::abs(observed - order) <= 0.25 ? order : observed)
                << std::endl;
      }
    deallog << "tolerances 1e-6, 1e-9: "
            << within(error_of_kirchhoff(true, {"Time/Tolerance=1e-6"}), 1e-5)
            << ", "
            << within(error_of_kirchhoff(true, {"Time/Tolerance=1e-9"}), 1e-8)
            << std::endl;
  }



  void
  check_heat()
  {
    const StepRecord rest =
      run<1>("",
             thermal + body("rod", {"Conductivity=1+theta/2", "Cells=6"}) +
               Overrides{"Boundary/left/Temperature=4",
                         "Boundary/right/Heat exchange=2",
                         "Boundary/right/Surroundings=1",
                         "Mesh/Degree=8",
                         "Time/Tolerance=1e-9",
                         "Time/End time=20"})
        .rows.back();
    deallog << "at rest: theta(1) "
            << within(std::abs(rest.temperature_end -
                               2. * (std::sqrt(19.) - 3.)),
                      1e-10)
            << std::endl;
    const StepRecord heated =
      run<1>("",
             thermal + insulated + body("rod", {"Heat capacity=exp(theta)"}) +
               Overrides{"Boundary/left/Temperature=none",
                         "Sources/Heat source=1",
                         "Time/Tolerance=1e-9",
                         "Time/End time=2"})
        .rows.back();
    deallog << "heated: theta "
            << within(std::abs(heated.temperature_end - std::log(3.)), 1e-8)
            << std::endl;
  }



  void
  check_motion()
  {
    const double zeta = 4. / 50., d = 3. / 8. * pi * pi * zeta,
                 w = std::sqrt(0.75 * pi * pi - d * d);
    double error   = 0.;
    for (const StepRecord &row :
         run<1>("",
                body("rod",
                     {"Stiffness=2+theta",
                      "Viscosity=1+3*theta",
                      "Displacement=0.1*sin(pi*x/2)",
                      "Temperature=1",
                      "Cells=2"}) +
                  insulated +
                  Overrides{"Boundary/left/Temperature=1",
                            "Boundary/right/Support=free",
                            "Model/Inertia=1",
                            "Model/Viscosity=0.02",
                            "Model/Coupling=0",
                            "Mesh/Degree=8",
                            "Time/Tolerance=1e-10",
                            "Time/End time=3"})
           .rows)
      raise(error,
            std::abs(
              row.displacement_end -
              0.1 * std::exp(-d * row.time) *
                (std::cos(w * row.time) + d / w * std::sin(w * row.time))));
    deallog << "damped mode: " << within(error, 1e-8) << std::endl;

    const Overrides pulled = body("rod",
                                  {"Stiffness=1/(1+theta)",
                                   "Coupling=1+theta",
                                   "Temperature=1+x",
                                   "Cells=2"}) +
                             Overrides{"Boundary/left/Temperature=1",
                                       "Boundary/right/Temperature=2",
                                       "Boundary/right/Support=free",
                                       "Boundary/right/Traction=0.1",
                                       "Model/Inertia=0",
                                       "Model/Viscosity=0",
                                       "Model/Coupling=0.25",
                                       "Mesh/Degree=6",
                                       "Time/Tolerance=1e-9",
                                       "Time/End time=1"};
    const Overrides slow = pulled + body("rod", {"Viscosity=1+theta"}) +
                           Overrides{"Model/Viscosity=2", "Time/End time=200"};
    const double  exact = 0.25 + 119. / 48.;
    Simulation<1> at_rest(read_parameters("",
                                          slow + Overrides{"Model/Inertia=1"}),
                          MPI_COMM_SELF);
    at_rest.run({});
    PointValues<1> values(at_rest.body().scene,
                          at_rest.body().discretization,
                          {{Point<1>(0.3), Point<1>(0.3)}});
    deallog << "at rest: u(1) "
            << within(std::abs(at_rest.record().displacement_end - exact), 1e-8)
            << ", stress "
            << within(std::abs(values.evaluate(
                                 at_rest.state())[PointValues<1>::stress] -
                               0.1),
                      1e-8)
            << std::endl;

    const auto at_once = run<1>("", pulled).rows;
    const auto viscous = run<1>("", slow).rows;
    deallog << "static: u(1) at first "
            << within(std::abs(at_once.front().displacement_end - exact), 1e-10)
            << ", later "
            << within(std::abs(at_once.back().displacement_end - exact), 1e-10)
            << "; viscous: v(1) at first "
            << within(std::abs(viscous.front().velocity_end - 0.05 - 23. / 48.),
                      1e-11)
            << ", u(1) at rest "
            << within(std::abs(viscous.back().displacement_end - exact), 1e-8)
            << std::endl;
  }



  void
  check_static()
  {
    const Overrides uniform = {"Boundary/left/Temperature=none",
                               "Boundary/right/Support=free",
                               "Boundary/right/Heat exchange=0",
                               "Model/Inertia=0",
                               "Model/Viscosity=0",
                               "Time/Tolerance=1e-8",
                               "Time/End time=1"};
    double          low = 0.5, high = 1.;
    for (unsigned int i = 0; i < 60; ++i)
      {
        const double theta = 0.5 * (low + high);
        (1. - 2. * std::log((1. + theta) / 2.) - 0.5 * (1. + theta) * theta >
             0.5 ?
           low :
           high)           = theta;
      }
    const StepRecord heated =
      run<1>("",
             uniform + body("rod", {"Coupling=1+theta", "Temperature=1"}) +
               Overrides{"Model/Coupling=0.5",
                         "Boundary/right/Traction=if(t<0.5,0,0.5)"})
        .rows.back();
    const StepRecord pulled =
      run<1>("",
             uniform + body("rod", {"Stiffness=2+theta", "Temperature=1"}) +
               Overrides{"Model/Coupling=0",
                         "Boundary/right/Traction=if(t<0.5,0,0.1)"})
        .rows.back();
    deallog << "jumps: theta "
            << within(std::abs(heated.temperature_end - low), 1e-3) << ", u(1) "
            << within(std::abs(heated.displacement_end - 0.5 -
                               0.5 * (1. + low) * low),
                      1e-3)
            << ", lost "
            << within(std::abs(pulled.numerical_dissipation - 0.01 / 6.), 1e-8)
            << std::endl;
    const StepRecord linear = run<1>("",
                                     uniform +
                                       body("rod",
                                            {"Stiffness=exp(8*x)*(1-theta/2)",
                                             "Temperature=1",
                                             "Cells=2"}) +
                                       Overrides{"Model/Coupling=0",
                                                 "Boundary/right/Traction=0.1",
                                                 "Mesh/Degree=1"})
                                .rows.back();
    const StepRecord added =
      run<1>("",
             uniform +
               body("rod",
                    {"Coupling=1+2*x+theta/10", "Temperature=1", "Cells=1"}) +
               Overrides{"Model/Coupling=1",
                         "Boundary/right/Traction=0.1",
                         "Mesh/Degree=1"})
        .rows.back();
    const auto rests =
      run<1>("",
             body("rod",
                  {"Stiffness=1/(1+theta/10)", "Coupling=1", "Temperature=1"}) +
               Overrides{"Boundary/left/Temperature=none",
                         "Boundary/right/Support=clamped",
                         "Boundary/right/Heat exchange=0",
                         "Sources/Heat source=1",
                         "Model/Coupling=0.3",
                         "Time/Scheme=sdirk4",
                         "Time/Step size=0.01",
                         "Time/End time=1"})
        .rows;
    double expansion = 0.;
    for (const char *const stiffness :
         {"3", "exp(x)", "1/(1+theta/2)", "exp(x)/(1+theta/2)"})
      for (const char *const degree : {"1", "4"})
        raise(expansion,
              std::abs(run<1>("",
                              uniform +
                                body("rod",
                                     {"Stiffness=" + std::string(stiffness),
                                      "Temperature=1",
                                      "Cells=1"}) +
                                Overrides{"Model/Coupling=0.3",
                                          "Mesh/Degree=" + std::string(degree)})
                         .rows.back()
                         .displacement_end -
                       0.3));
    deallog << "the same alpha: u(1) " << within(expansion, 1e-10) << std::endl;
    deallog << "linear cells: u(1) "
            << within(std::abs(linear.displacement_end -
                               (1. - std::exp(-8.)) / 40.),
                      1e-10)
            << ", of thermal stress "
            << within(std::abs(added.displacement_end - 2.2), 1e-10)
            << "; at rest: theta "
            << within(std::abs(rests.back().temperature_end - 2.), 1e-6)
            << std::endl;
  }



  /** The middle of a rod that is pulled, and its mean temperature. */
  StepRecord
  pulled_rod(const bool is_mirrored)
  {
    const std::string x = is_mirrored ? "(1-x)" : "x";
    return run<1>("",
                  body("rod",
                       {"Stiffness=exp(" + x + "/2)*(1+theta/5)",
                        "Viscosity=1+theta/4",
                        "Coupling=1-theta/6",
                        "Conductivity=1+" + x + "+theta/2",
                        "Heat capacity=1+theta^2/9",
                        "Temperature=1+" + x}) +
                    (is_mirrored ? Overrides{"Boundary/left/Support=free",
                                             "Boundary/left/Traction=0.1",
                                             "Boundary/left/Temperature=2",
                                             "Boundary/right/Temperature=1",
                                             "Boundary/right/Support=clamped"} :
                                   Overrides{"Boundary/right/Support=free",
                                             "Boundary/right/Traction=0.1",
                                             "Boundary/left/Temperature=1",
                                             "Boundary/right/Temperature=2"}) +
                    Overrides{"Model/Coupling=0.3",
                              "Time/Scheme=sdirk4",
                              "Time/Step size=0.05",
                              "Time/End time=2"})
      .rows.back();
  }



  void
  check_mirror()
  {
    const StepRecord rod = pulled_rod(false), image = pulled_rod(true);
    deallog << "mirrored: u(1/2) "
            << within(std::abs(rod.displacement_mid + image.displacement_mid),
                      1e-11)
            << ", mean temperature "
            << within(std::abs(rod.temperature_mean - image.temperature_mean),
                      1e-11)
            << ", moves " << (std::abs(rod.displacement_mid) > 0.01)
            << std::endl;
  }



  void
  check_audit()
  {
    for (const char *const scheme : {"backward euler", "sdirk4"})
      {
        const auto rows =
          run<1>("",
                 body("one",
                      {"Stiffness=exp(0.1*theta)",
                       "Viscosity=1+theta^2/9",
                       "Coupling=1-theta/5",
                       "Velocity=0.2*x",
                       "Cells=3"}) +
                   body("other",
                        {"Conductivity=2+theta",
                         "Heat capacity=1+theta/(1+theta^2)",
                         "Temperature=1-x",
                         "Cells=3"}) +
                   Overrides{"Boundary/left/Temperature=1+sin(t)^2",
                             "Contact/Condition=normal compliance",
                             "Contact/Compliance=0.1",
                             "Contact/Gap=0.01",
                             "Boundary/right/Heat exchange=1+pressure",
                             "Mesh/Degree=3",
                             std::string("Time/Scheme=") + scheme,
                             "Time/Step size=0.02",
                             "Time/End time=2"})
            .rows;
        double defect = 0.;
        bool   meets  = false;
        for (const StepRecord &r : rows)
          {
            raise(defect,
                  std::abs(r.energy + r.dissipation + r.numerical_dissipation -
                           r.work - rows.front().energy) /
                    (std::abs(r.energy) + std::abs(r.dissipation) +
                     std::abs(r.numerical_dissipation) + std::abs(r.work) +
                     rows.front().energy));
            meets = meets || r.in_contact;
          }
        deallog << scheme << ", audit: defect " << within(defect, 1e-12)
                << ", met " << meets << std::endl;
      }
    const StepRecord held =
      run<1>("",
             thermal +
               body("rod",
                    {"Conductivity=1+theta/2", "Temperature=2+x", "Cells=2"}) +
               Overrides{"Boundary/left/Temperature=2",
                         "Boundary/right/Temperature=3",
                         "Mesh/Degree=6",
                         "Time/Tolerance=1e-8",
                         "Time/End time=5"})
        .rows.back();
    deallog << "held at both ends: N "
            << within(std::abs(held.numerical_dissipation), 1e-6) << ", D "
            << (held.dissipation > 1e-3) << std::endl;
  }
} // namespace



void
main_temperature_laws()
{
  initlog();
  check_kirchhoff();
  check_heat();
  check_motion();
  check_static();
  check_mirror();
  check_audit();
}
