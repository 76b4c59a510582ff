// SPDX-License-Identifier: LGPL-2.1-or-later
//
// The scheme energy conserving, and contact nodes without mass, beyond the
// elastic rod of the test elastic_impact. Coupling a = 0.5, heat, viscosity.
//
// 1. Energy. A step changes the energy by the physical dissipation, whatever
//    happens at the contact end: over 500 steps with impacts and releases
//    |E - E_0 + D| is at most 1e-11 of the largest |E|. eps = 1, 1e-2, 1e-6 and
//    rigid; zeta = 0 and 0.01; degrees 1 and 4; both mass matrices. Also with
//    100 steps of dt = 10, far longer than a passage of the waves.
// 2. The same in 2-D, free lateral faces, u_1 = (2 + y) x: the contact nodes
//    touch and leave one by one. At the end of each step, at each node,
//    p >= 0, s = gap + eps p >= 0 and p s = 0, to 1e-12 of max p and g.
// 3. Order 2 in dt, without contact: zeta = 0, heat source, body force and end
//    traction, from rest, against sdirk4 with dt = 1/1000 on the same mesh,
//    which then has the same equations. u(1), u(1/2) and theta(1) at t = 1 and
//    2, one halving: order 2 +- 0.15.
// 4. Experiment 1 of the paper through its impact, at t = 1.5, degree 1, and
//    12 cells of degree 5 with all their mass to compare with. Contact nodes
//    without mass do not change the order 2 in h of u(1), u(1/2) and theta(1),
//    +-0.2, of sdirk4. The scheme energy conserving has no viscous stress at
//    the contact node either: a change of the body over one cell, of order 1 in
//    h, +-0.25, for u.
//
// The mirror image of each run is the run, but for rounding.

#include <thermocontact/simulation/simulation.h>
#include <thermocontact/space/node_laws.h>

#include <deal.II/base/mpi.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "../mirror_image.h"

using namespace ThermoContact;

namespace
{
  const Overrides energy_scene = {"Model/Coupling=0.5",
                                  "Boundary/left/Temperature=1",
                                  "Initial values/Temperature=1+sin(3*pi*x)",
                                  "Initial values/Velocity=2*x",
                                  "Time/Scheme=energy conserving",
                                  "Time/Step size=0.02",
                                  "Time/End time=10"};

  /** Compliance, or rigid if it is 0. */
  std::string
  obstacle(const double compliance)
  {
    return compliance > 0. ? entry("Contact/Compliance", compliance) :
                             "Contact/Condition=rigid";
  }



  MirrorImages images;



  struct Balance
  {
    double       defect          = 0.; ///< relative
    double       violation       = 0.; ///< of the contact conditions
    unsigned int n_events        = 0;
    unsigned int n_partial_steps = 0; ///< some nodes in contact, some not
  };



  /** Largest violation of the contact conditions at a node, relative. */
  template <int dim>
  double
  violation(const Simulation<dim> &simulation)
  {
    const ContactLaw &law   = simulation.body().law();
    const State      &state = simulation.state();
    ContactValues     values;
    get_contact_values(simulation.body(), state, values);
    const std::vector<double> &penetration = values.front.penetration;
    double                     worst = 0., largest = 1.;
    for (const double p : state.contact.pressure)
      largest = std::max(largest, p);
    for (unsigned int i = 0; i < penetration.size(); ++i)
      {
        const double p = state.contact.pressure[i] / largest;
        const double s =
          (law.penetration(state.contact.pressure[i]) - penetration[i]) /
          simulation.scene().contact.gap;
        raise(worst, std::max({-p, -s, std::abs(p * s)}));
      }
    return worst;
  }



  template <int dim>
  Balance
  run_balance(const Overrides &overrides)
  {
    Simulation<dim> simulation(read_parameters("", energy_scene + overrides),
                               MPI_COMM_SELF);
    Balance         balance;
    double          first = 0., largest = 0., defect = 0.;
    const auto      observe = [&](const Simulation<dim> &s) {
      const StepRecord &r = s.record();
      if (r.step == 0)
        first = r.energy;
      raise(largest, std::abs(r.energy));
      raise(defect, std::abs(r.energy - first + r.dissipation));
      raise(balance.violation, violation(s));
      const std::vector<double> &p = s.state().contact.pressure;
      const unsigned int         n_active =
        std::count_if(p.begin(), p.end(), [](const double x) {
          return x > 0.;
        });
      balance.n_partial_steps += n_active > 0 && n_active < p.size();
    };
    images.run(simulation, {observe});
    balance.defect   = defect / largest;
    balance.n_events = simulation.events().size();
    return balance;
  }



  /** The worst of several runs, and the least eventful. */
  void
  add(Balance &all, const Balance &balance)
  {
    raise(all.defect, balance.defect);
    raise(all.violation, balance.violation);
    all.n_events = std::min(all.n_events, balance.n_events);
    all.n_partial_steps =
      std::min(all.n_partial_steps, balance.n_partial_steps);
  }



  void
  test_balance_1d()
  {
    for (const double compliance : {1., 1e-2, 1e-6, 0.})
      {
        Balance all{0., 0., 1000, 1000};
        for (const double viscosity : {0., 0.01})
          for (const std::string mass : {"lumped", "consistent"})
            for (const unsigned int degree : {1, 4})
              add(all,
                  run_balance<1>({obstacle(compliance),
                                  entry("Model/Viscosity", viscosity),
                                  "Mesh/Mass matrix=" + mass,
                                  entry("Mesh/Degree", degree),
                                  entry("Mesh/Cells", 40 / degree)}));
        deallog << "1-D, compliance " << compliance << ": energy "
                << within(all.defect, 1e-11) << ", contact conditions "
                << within(all.violation, 1e-12)
                << ", events up to 5: " << std::min(all.n_events, 5U)
                << std::endl;
      }
    const Balance balance = run_balance<1>({obstacle(0.),
                                            entry("Mesh/Cells", 40),
                                            entry("Mesh/Degree", 1),
                                            entry("Time/Step size", 10.),
                                            entry("Time/End time", 1000.)});
    deallog << "1-D, dt = 10: energy " << within(balance.defect, 1e-11)
            << ", contact conditions " << within(balance.violation, 1e-12)
            << std::endl;
  }



  void
  test_balance_2d()
  {
    const Overrides scene = {"Dimension=2",
                             "Boundary/sides/Support=free",
                             "Model/Poisson ratio=0.3",
                             "Model/Viscosity=0.01",
                             "Initial values/Velocity=(2+y)*x",
                             "Mesh/Width=0.3"};
    for (const double compliance : {1e-2, 1e-8, 0.})
      {
        Balance all{0., 0., 1000, 1000};
        add(all,
            run_balance<2>(scene + Overrides{obstacle(compliance),
                                             "Mesh/Cells=10",
                                             "Mesh/Degree=1",
                                             "Mesh/Cells across=4"}));
        add(all,
            run_balance<2>(scene + Overrides{obstacle(compliance),
                                             "Mesh/Cells=5",
                                             "Mesh/Degree=2",
                                             "Mesh/Mass matrix=lumped",
                                             "Mesh/Cells across=3"}));
        deallog << "2-D, compliance " << compliance << ": energy "
                << within(all.defect, 1e-11) << ", contact conditions "
                << within(all.violation, 1e-12)
                << ", events up to 4: " << std::min(all.n_events, 4U)
                << ", steps with a part of the "
                << "nodes up to 5: " << std::min(all.n_partial_steps, 5U)
                << std::endl;
      }
  }



  /** u(1), u(1/2), theta(1). */
  using Quantities = std::array<double, 3>;

  const std::array<const char *, 3> names = {{"u(1)", "u(1/2)", "theta(1)"}};

  std::vector<Quantities>
  values_at(const std::vector<double> &times, const Overrides &overrides)
  {
    Simulation<1> simulation(read_parameters("", overrides), MPI_COMM_SELF);
    std::vector<Quantities> values;
    const auto              observe = [&](const Simulation<1> &s) {
      const StepRecord &r = s.record();
      for (const double time : times)
        if (std::abs(r.time - time) < 1e-9)
          values.push_back(
            {{r.displacement_end, r.displacement_mid, r.temperature_end}});
    };
    images.run(simulation, {observe});
    return values;
  }



  /** The expected order if it is observed, the observed one otherwise. */
  void
  print_order(const unsigned int quantity,
              const double       expected,
              const double       tolerance,
              const double       coarse_error,
              const double       fine_error)
  {
    const double observed = std::log2(coarse_error / fine_error);
    deallog << ", " << names[quantity] << ' '
            << (std::abs(observed - expected) <= tolerance ? expected :
                                                             observed);
  }



  void
  test_order_in_time()
  {
    const Overrides           scene = {"Model/Viscosity=0",
                                       "Model/Coupling=0.5",
                                       "Boundary/left/Temperature=0",
                                       "Contact/Gap=10",
                                       "Initial values/Temperature=0",
                                       "Initial values/Velocity=0",
                                       "Sources/Heat source=5*sin(3*t)*x",
                                       "Sources/Body force=t^3*cos(2*x)",
                                       "Boundary/right/Traction=sin(2*t)^3",
                                       "Time/End time=2"};
    const std::vector<double> times = {1., 2.};
    for (const Overrides &mesh : {Overrides{"Mesh/Cells=20", "Mesh/Degree=1"},
                                  Overrides{"Mesh/Cells=5",
                                            "Mesh/Degree=3",
                                            "Mesh/Mass matrix=lumped"}})
      {
        const auto run = [&](const std::string &scheme, const double n) {
          return values_at(times,
                           scene + mesh +
                             Overrides{"Time/Scheme=" + scheme,
                                       entry("Time/Step size", 1. / n)});
        };
        const auto reference = run("sdirk4", 1000);
        const auto coarse    = run("energy conserving", 100);
        const auto fine      = run("energy conserving", 200);
        for (unsigned int i = 0; i < times.size(); ++i)
          {
            deallog << "order in dt, " << mesh[1] << ", t = " << times[i];
            for (unsigned int q = 0; q < names.size(); ++q)
              print_order(q,
                          2.,
                          0.15,
                          std::abs(coarse[i][q] - reference[i][q]),
                          std::abs(fine[i][q] - reference[i][q]));
            deallog << std::endl;
          }
      }
  }



  void
  test_order_in_space()
  {
    const auto run = [](const std::string &scheme,
                        const unsigned int cells,
                        const unsigned int degree,
                        const std::string &massless) {
      return values_at({1.5},
                       {"Time/End time=1.5",
                        "Time/Scheme=" + scheme,
                        "Contact/Massless nodes=" + massless,
                        entry("Mesh/Cells", cells),
                        entry("Mesh/Degree", degree),
                        entry("Time/Step size", 0.0005)})
        .at(0);
    };
    const Quantities reference = run("sdirk4", 12, 5, "off");
    for (const std::string scheme : {"sdirk4", "energy conserving"})
      {
        const Quantities coarse = run(scheme, 80, 1, "on");
        const Quantities fine   = run(scheme, 160, 1, "on");
        deallog << "order in h, " << scheme << ", massless";
        for (unsigned int q = 0; q < names.size(); ++q)
          if (q < 2 || scheme == "sdirk4")
            print_order(q,
                        scheme == "sdirk4" ? 2. : 1.,
                        scheme == "sdirk4" ? 0.2 : 0.25,
                        std::abs(coarse[q] - reference[q]),
                        std::abs(fine[q] - reference[q]));
        deallog << std::endl;
      }
  }
} // namespace



void
main_energy_conserving()
{
  initlog();
  test_balance_1d();
  test_balance_2d();
  test_order_in_time();
  test_order_in_space();
  deallog << images.words(1e-12) << std::endl;
}
