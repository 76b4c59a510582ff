// SPDX-License-Identifier: LGPL-2.1-or-later
//
// Loads and initial values that vary within a cell, doc/discretisation.md
// section 1: on 8 cells none is missed.
//
// 1. Basis functions sum up to 1, and with the places of their nodes to x. So
//    the entries of a load sum up to its integral, and times their places to
//    its moment; both are known.
//    A jump: 2 on (0.299, 0.301) has the integral 0.004 and its place at 0.3;
//    jumps 1e3 and 1e5 times narrower have theirs.
//
//    A step: 1 behind x = 1/3 has 2/3, at 2/3.
//
//    A moving flash, and a moving force: exp(-((x - t/10)/1e-4)^2) has
//    1e-4 sqrt(pi), at t = 7 at 0.7.
//
//    In a strip, 0.5 wide: a rectangle of 0.02 by 0.01 has 2e-4; two Gaussians,
//    of width 1e-3, and of 1e-4 in a block: 1e-6 pi and 1e-12 pi^(3/2).
//
//    In a round rod, whose integrals have the weight r: 1 in r < 1/2 at
//    0.4 < x < 0.401 has 1e-3/8.
//
//    A flux of 1 on a stripe of 1e-3 of the left end of the strip has 1e-3; a
//    force of 1 on a slice of 1e-3 of a block 1e-3 of its area 1/4.
//    Loads without t are kept once they are known: 1 + 2x has 2 at all times
//    and the rate 0; times t^2 it has 8 at t = 2 and the rate 4 at t = 1.
// 2. A rod that is held at 0 and else insulated, under the heat 2 on
//    (0.299, 0.301), gets 0.004 * 0.3 warm behind it, up to exp(-pi^2 t/4).
//    A flash of 1e-3 on a spot of 2e-4 with the heat 1e4 makes an insulated rod
//    2e-3 warmer.
// 3. The projection has the mean of the initial temperature in each cell, so
//    that the rod has the mean of it: 3 on (0.37, 0.373): 0.009. Two bonded
//    rods of 1/4 at 4 and 3/4 at 0: 1. The momentum of 2 on (0.37, 0.373) by
//    the means of cells of box: 0.006.

#include <cmath>

#include "../recorded_run.h"

using namespace ThermoContact;

namespace
{
  const double pi = std::acos(-1.);



  /** Integral and moment of a load at t = 7, against what they are. */
  template <int dim>
  void
  check_load(const std::string &name,
             const std::string &source,
             const Overrides   &more,
             const double       integral,
             const double       place,
             const double       bound,
             const Field::Block field = Field::temperature)
  {
    const Scene scene(
      read_parameters("",
                      Overrides{"Dimension=" + std::to_string(dim),
                                "Mesh/Cells=8",
                                "Mesh/Degree=2",
                                "Time/Scheme=sdirk4",
                                "Initial values/Displacement=0",
                                "Initial values/Temperature=0",
                                "Boundary/left/Temperature=none",
                                "Boundary/right/Heat exchange=0",
                                source} +
                        more));
    Body<dim>             body(scene, MPI_COMM_SELF);
    ThermoContact::Vector heat(body.loads.outer_heat());
    ThermoContact::Vector force =
      body.discretization.make_vector(Field::displacement);
    body.loads.assemble(7., heat, force);
    const ThermoContact::Vector &load =
      field == Field::temperature ? heat : force;
    const auto &nodes = body.discretization.nodal_values(field);
    double      sum = 0., moment = 0.;
    for (unsigned int i = 0; i < nodes.size(); ++i)
      if (nodes[i].component == 0)
        {
          sum += load.local_element(i);
          moment += load.local_element(i) * nodes[i].node[0];
        }
    // which pieces are the 256 first ones rounding may decide
    deallog << name << ": integral "
            << noise_within(std::abs(sum / integral - 1.), bound) << ", place "
            << noise_within(std::abs(moment / sum - place), bound) << std::endl;
  }



  /** Sums of the momentum load of a body force at two times, and of its rate.
   */
  void
  check_rates(const std::string &force, const double at_2, const double rate)
  {
    const Scene           scene(read_parameters("",
                                      {"Model/Fields=displacement",
                                                 "Initial values/Displacement=0",
                                                 "Sources/Body force=" + force}));
    Body<1>               body(scene, MPI_COMM_SELF);
    ThermoContact::Vector heat(body.loads.outer_heat());
    ThermoContact::Vector load =
      body.discretization.make_vector(Field::displacement);
    const auto sum = [&]() { return load.mean_value() * load.size(); };
    body.loads.assemble(0., heat, load);
    body.loads.assemble_momentum_rate(1., load);
    const double found = sum();
    body.loads.assemble(2., heat, load);
    deallog << force << ": at 2 " << within(std::abs(sum() - at_2), 1e-12)
            << ", rate " << within(std::abs(found - rate), 1e-12) << std::endl;
  }



  double
  mean_at_start(const Overrides &overrides)
  {
    return run<1>("", Overrides{"Time/End time=0"} + overrides)
      .rows.front()
      .temperature_mean;
  }
} // namespace

void
main_narrow_loads()
{
  initlog();

  const std::string heat = "Sources/Heat source=", body = "Sources/Body force=";
  const std::string flash = "exp(-((x - t/10)/1e-4)^2)";
  check_load<1>(
    "jump", heat + "if(abs(x - 0.3) < 1e-3, 2, 0)", {}, 0.004, 0.3, 1e-6);
  check_load<1>(
    "narrow jump", heat + "if(abs(x - 0.3) < 1e-6, 2, 0)", {}, 4e-6, 0.3, 1e-3);
  check_load<1>(
    "peak", heat + "if(abs(x - 0.3) < 1e-8, 2, 0)", {}, 4e-8, 0.3, 1e-3);
  check_load<1>("step", heat + "x > 1/3", {}, 2. / 3., 2. / 3., 1e-7);
  check_load<1>("moving", heat + flash, {}, 1e-4 * std::sqrt(pi), 0.7, 1e-4);
  check_load<1>("force",
                body + flash,
                {},
                1e-4 * std::sqrt(pi),
                0.7,
                1e-4,
                Field::displacement);
  const Overrides strip = {"Mesh/Width=0.5"};
  check_load<2>("rectangle",
                heat + "if(abs(x - 0.31) < 0.01 && abs(y - 0.12) < 5e-3, 1, 0)",
                strip,
                2e-4,
                0.31,
                1e-3);
  check_load<2>("Gaussian",
                heat + "exp(-((x - 0.31)^2 + (y - 0.12)^2)/1e-6)",
                strip,
                1e-6 * pi,
                0.31,
                1e-3);
  check_load<3>("small Gaussian",
                heat +
                  "exp(-((x - 0.31)^2 + (y - 0.18)^2 + (z - 0.13)^2)/1e-8)",
                strip,
                1e-12 * std::pow(pi, 1.5),
                0.31,
                1e-3);
  check_load<2>("round rod",
                heat + "if(y < 0.5 && abs(x - 0.4005) < 5e-4, 1, 0)",
                {"Mesh/Width=1", "Mesh/Geometry=axisymmetric"},
                1e-3 / 8.,
                0.4005,
                1e-4);
  check_load<2>("flux",
                "Boundary/left/Heat flux=if(abs(y - 0.3) < 5e-4, 1, 0)",
                strip,
                1e-3,
                0.,
                1e-6);
  check_load<3>("force on a block",
                body + "if(abs(x - 0.3) < 5e-4, 1, 0); 0; 0",
                strip,
                1e-3 / 4.,
                0.3,
                1e-6,
                Field::displacement);

  check_rates("1+2*x", 2., 0.);
  check_rates("(1+2*x)*t^2", 8., 4.);

  const double end = run<1>("",
                            {heat + "if(abs(x - 0.3) < 1e-3, 2, 0)",
                             "Model/Inertia=0",
                             "Model/Coupling=0",
                             "Contact/Condition=none",
                             "Boundary/left/Temperature=0",
                             "Boundary/right/Heat exchange=0",
                             "Initial values/Temperature=0",
                             "Initial values/Displacement=0",
                             "Time/End time=12"})
                       .rows.back()
                       .temperature_end;
  deallog << "warm end: " << within(std::abs(end / (0.004 * 0.3) - 1.), 1e-5)
          << std::endl;

  const double flashed = run<1>("",
                                {heat + "if(t > 0.3 && t < 0.301 && "
                                        "abs(x - 0.3) < 1e-4, 1e4, 0)",
                                 "Model/Coupling=0",
                                 "Model/Inertia=0",
                                 "Contact/Condition=none",
                                 "Boundary/left/Temperature=none",
                                 "Boundary/right/Heat exchange=0",
                                 "Initial values/Temperature=0",
                                 "Initial values/Displacement=0",
                                 "Time/End time=1"})
                           .rows.back()
                           .temperature_mean;
  deallog << "flash on a spot: " << within(std::abs(flashed / 2e-3 - 1.), 1e-6)
          << std::endl;

  const std::string spot = "if(abs(x - 0.3715) < 1.5e-3, 3, 0)";
  deallog << "mean at the start: "
          << within(std::abs(
                      mean_at_start({"Initial values/Temperature=" + spot,
                                     "Boundary/left/Temperature=none",
                                     "Mesh/Cells=8",
                                     "Mesh/Degree=4",
                                     "Time/Scheme=sdirk4"}) /
                        0.009 -
                      1.),
                    1e-5)
          << std::endl;
  deallog << "of bonded rods: "
          << within(std::abs(mean_at_start({"Bodies/a/Length=0.25",
                                            "Bodies/a/Temperature=4",
                                            "Bodies/b/Length=0.75",
                                            "Contacts/a b/Condition=bonded",
                                            "Boundary/left/Temperature=none",
                                            "Mesh/Degree=4",
                                            "Time/Scheme=sdirk4"}) -
                             1.),
                    1e-10)
          << std::endl;
  Simulation<1> flight(
    read_parameters(
      "",
      {"Model/Fields=displacement",
       "Model/Inertia=1",
       "Boundary/left/Support=free",
       "Contact/Condition=none",
       "Initial values/Displacement=0",
       "Initial values/Velocity=if(abs(x - 0.3715) < 1.5e-3, 2, 0)",
       "Time/Scheme=box",
       "Time/End time=0"}),
    MPI_COMM_SELF);
  double momentum = 0.;
  flight.run({[&](const Simulation<1> &s) {
    const ThermoContact::Vector &v = s.state().velocity;
    // means of neighbours are those of cells of one length
    for (unsigned int i = 0; i + 1 < v.size(); ++i)
      momentum += (v(i) + v(i + 1)) / 2. / (v.size() - 1.);
  }});
  deallog << "momentum of box: "
          << within(std::abs(momentum / 0.006 - 1.), 1e-6) << std::endl;
}
