// SPDX-License-Identifier: LGPL-2.1-or-later
//
// Time/Scheme = box with all contact laws, against characteristics. At the end
// of an elastic rod p = Z (v_in - v), Z = sqrt(b): what comes to it is
//   v_in = w(t) for t < 2 Z, and then v_in(t) = v_in(t - 2 Z) - 2 v(t - 2 Z),
// the wave that has left, back from the fixed end, with w = 0 for a rod at rest
// and w = 1 - t/Z for the initial velocity x. Left is
//   s' = v - g', p = (f + D s')_+ for s >= 0, f = (s/eps)^m, D = c f + d,
// so that p = (f + D (v_in - g'))/(1 + D/Z) where it is positive: by the
// classical Runge-Kutta method with 40 steps to a cell, 1e-9; 2000 where a
// dashpot makes jumps.
//
// 1. A wall that moves with 0.01 into a rod at rest: force 0.01 until t = 2,
// then
//    0.03 (the wave comes back from the fixed end, which doubles it); impulse
//    0.019 at 1.9.
// 2. A spring on such a wall: p = 0.01 Z (1 - exp(-t/(Z eps))) until 2 Z.
// 3. Rods thrown at elastic, Hertzian, damped stops and buffers, b = 1
// and 2.25:
//    displacement of the end and impulse to 1e-3 at all times, the peak to 0.3
//    per cent, 200 cells; order of the displacement from 100 to 200 cells at
//    least 1.7 (measured 1.8 to 2) where the mesh resolves the obstacle. Where
//    it does not, eps = 0.001, the peak to one cell of the incoming wave.
// 4. The mirror image of each run is the run, but for rounding.
// 5. Energy, work, dissipation of the obstacle and that of the scheme add up
//    to 1e-12 of the largest energy; the last never gives any.
// 6. Viscous rods, zeta = 1e-3, 0.05 and 1: order 2 of u(1) on a Hertzian stop,
//    from 100, 200 and 400 cells. The energy does not grow.
// 7. Events. A rod that is let go at -x/2: meets a stop at 0 at t = 1 with 1/2,
//    leaves at t = 2 with -1/2, a spring later with the same, as that is what
//    arrives until t = 3. The half x > 1/2 of a rod moves with 1: it presses
//    with 1 until t = 1/2, then with nothing. A rod on a stop whose fixed end
//    starts to move: no pressure before t = 1, then 0.02. A rod that falls on a
//    stop, force 1, gap 0.3, 400 cells: begins at 0.6^(1/2), 4 - 0.8^(1/2), 6 -
//    0.2^(1/2), 8 + 0.4^(1/2), 11, impulse 3.3 (box_bars.cc derives them). All
//    waves are linear between fronts, and releases by these are located in a
//    step: what is left is of order h^2 = 6e-6 in each of a dozen reflections,
//    1e-4. The peak 1 is that of a triangle with slopes 1 and -1 whose means
//    over steps are half a step lower, 1.25e-3.
// 8. The massless node of sdirk4 has no velocity when it leaves: no
//    restitution.
// 9. Heat of a rod whose fixed end jumps by 1, a = 0.5, zeta = 0.1, k of gap
//    and pressure, against sdirk4 with a tolerance of 1e-8. Contact changes k
//    at a time that the scheme knows to a step, which costs the mean
//    temperature at most that time of the largest flux q of heat: 200 cells,
//    dt q. At T heat has decayed by exp(-pi^2/4 (T - 0.5)) since. Away from
//    the jump and from events second differences of what does not alternate
//    fall like dt^2: by 4 from 100 to 200 cells.

#include <thermocontact/report/key_results.h>
#include <thermocontact/simulation/simulation.h>
#include <thermocontact/space/point_values.h>

#include <deal.II/base/mpi.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <string>

#include "../mirror_image.h"

using namespace ThermoContact;

namespace
{
  using Entries = std::vector<std::string>;

  const Entries elastic_rod = {"Model/Fields=displacement",
                               "Model/Viscosity=0"};



  MirrorImages images;



  /** What the end of a rod does, step by step. */
  struct Run
  {
    std::vector<StepRecord>   rows;
    std::vector<ContactEvent> events;
    double                    peak = 0., restitution = 0., growth = 0.;
  };



  Run
  run(const Entries &entries)
  {
    Simulation<1> simulation(read_parameters("", entries), MPI_COMM_SELF);
    Run           result;
    images.run(simulation, {[&result](const Simulation<1> &s) {
                 result.rows.push_back(s.record());
               }});
    result.events = simulation.events();
    const Scene scene(simulation.parameters());
    const auto  values = key_results(scene, simulation.history());
    result.peak        = values.at("max_contact_force");
    result.restitution = values.at("restitution");
    result.growth      = simulation.history().max_energy_increase;
    return result;
  }



  Run
  run_box(const unsigned int n_cells,
          const double       inertia,
          const double       end_time,
          const Entries     &entries)
  {
    return run(Entries{"Time/Scheme=box",
                       "Mesh/Degree=1",
                       "Mesh/Cells=" + std::to_string(n_cells),
                       entry("Model/Inertia", inertia),
                       entry("Time/Step size", std::sqrt(inertia) / n_cells),
                       entry("Time/End time", end_time)} +
               entries);
  }



  struct Law
  {
    double compliance, exponent, damping, dashpot = 0.;
  };



  /** Characteristics at all ends of steps: u(1), p, impulse. */
  struct Exact
  {
    std::vector<double> displacement, impulse;
    double              peak = 0.;
  };



  Exact
  solve_exactly(const unsigned int                   n_cells,
                const double                         impedance,
                const Law                           &law,
                const double                         gap,
                const double                         wall, // its velocity, g'
                const std::function<double(double)> &first,
                const unsigned int                   n_steps)
  {
    // of a step; the jumps that a dashpot makes are known to one of them
    const unsigned int  n_parts = law.dashpot > 0. ? 2000 : 40;
    const double        dt      = impedance / n_cells / n_parts;
    const unsigned int  way     = 2 * n_cells * n_parts; // there and back
    std::vector<double> coming, velocity;                // at half parts
    const auto          pressure = [&](const double s, const double v_in) {
      if (s < 0.)
        return 0.;
      const double f = std::pow(s / law.compliance, law.exponent);
      const double d = law.damping * f + law.dashpot;
      return std::max(0., f + d * (v_in - wall)) / (1. + d / impedance);
    };
    const auto v_in = [&](const unsigned int half) {
      return half < 2 * way ?
               first(0.5 * half * dt) :
               coming[half - 2 * way] - 2. * velocity[half - 2 * way];
    };
    Exact  exact;
    double s = -gap, u = 0., impulse = 0.;
    for (unsigned int i = 0; i <= n_steps * n_parts; ++i)
      {
        if (i % n_parts == 0)
          {
            exact.displacement.push_back(u);
            exact.impulse.push_back(impulse);
          }
        const double v0 = v_in(2 * i), v1 = v_in(2 * i + 1),
                     v2 = v_in(2 * i + 2);
        const auto rate = [&](const double at, const double v) {
          return v - pressure(at, v) / impedance - wall;
        };
        const double k1 = rate(s, v0), k2 = rate(s + 0.5 * dt * k1, v1),
                     k3     = rate(s + 0.5 * dt * k2, v1),
                     k4     = rate(s + dt * k3, v2);
        const double middle = s + 0.25 * dt * (k1 + k2);
        const double change = dt / 6. * (k1 + 2. * k2 + 2. * k3 + k4);
        raise(exact.peak, pressure(s, v0));
        coming.push_back(v0);
        velocity.push_back(v0 - pressure(s, v0) / impedance);
        coming.push_back(v1);
        velocity.push_back(v1 - pressure(middle, v1) / impedance);
        impulse += dt / 6. *
                   (pressure(s, v0) + 4. * pressure(middle, v1) +
                    pressure(s + change, v2));
        s += change;
        u += change + dt * wall;
      }
    return exact;
  }



  struct Errors
  {
    double displacement = 0., impulse = 0., peak = 0., energy = 0., loss = 0.;
  };



  Errors
  compare(const unsigned int n_cells,
          const double       inertia,
          const Law         &law,
          const bool         has_wall)
  {
    const double  z = std::sqrt(inertia);
    const Entries body =
      elastic_rod + Entries{"Contact/Condition=power law",
                            entry("Contact/Compliance", law.compliance),
                            entry("Contact/Exponent", law.exponent),
                            entry("Contact/Damping", law.damping),
                            entry("Contact/Dashpot", law.dashpot)};
    const Run found =
      run_box(n_cells,
              inertia,
              3. * z,
              body +
                (has_wall ?
                   Entries{"Contact/Gap=-0.01*t", "Initial values/Velocity=0"} :
                   Entries{"Contact/Gap=0.01", "Initial values/Velocity=x"}));
    const Exact exact = solve_exactly(
      n_cells,
      z,
      law,
      has_wall ? 0. : 0.01,
      has_wall ? -0.01 : 0.,
      [&](const double t) { return has_wall ? 0. : 1. - t / z; },
      3 * n_cells);
    Errors errors;
    double scale = 0.;
    for (unsigned int i = 0; i < found.rows.size(); ++i)
      {
        const StepRecord &r = found.rows[i];
        raise(errors.displacement,
              std::abs(r.displacement_end - exact.displacement[i]));
        raise(errors.impulse, std::abs(r.contact_impulse - exact.impulse[i]));
        raise(scale, r.energy);
        raise(errors.energy,
              std::abs(found.rows[0].energy + r.work - r.energy -
                       r.contact_dissipation - r.numerical_dissipation));
        if (i > 0)
          raise(errors.loss,
                found.rows[i - 1].numerical_dissipation -
                  r.numerical_dissipation);
      }
    errors.peak = std::abs(found.peak / exact.peak - 1.);
    errors.energy /= scale;
    errors.loss /= scale;
    return errors;
  }



  void
  check_law(const std::string &name,
            const double       inertia,
            const Law         &law,
            const bool         has_wall = false)
  {
    const Errors coarse  = compare(100, inertia, law, has_wall);
    const Errors fine    = compare(200, inertia, law, has_wall);
    const double scale   = has_wall ? 0.01 : 1.;
    const bool   is_soft = law.compliance > 0.02;
    deallog << name << ", b " << inertia << ": u(1) "
            << within(fine.displacement / scale, 1e-3);
    if (is_soft)
      deallog << ", order 1.7 "
              << (std::log2(coarse.displacement / fine.displacement) >= 1.7);
    deallog << ", impulse " << within(fine.impulse / scale, 1e-3) << ", peak "
            << within(fine.peak, is_soft ? 3e-3 : 6e-3) << ", balance "
            << within(fine.energy, 1e-12) << ", gives "
            << within(fine.loss, 1e-13) << std::endl;
  }
} // namespace



void
main_box_laws()
{
  initlog();
  {
    const Run wall =
      run_box(200,
              1.,
              2.5,
              elastic_rod + Entries{"Contact/Condition=rigid",
                                    "Contact/Gap=-0.01*t",
                                    "Initial values/Velocity=0"});
    double error = 0., impulse = 0.;
    for (const StepRecord &r : wall.rows)
      {
        if (r.time > 0. && std::abs(r.time - 2.) > 0.006)
          raise(error, std::abs(r.contact_force - (r.time < 2. ? 0.01 : 0.03)));
        if (std::abs(r.time - 1.9) < 1e-9)
          impulse = r.contact_impulse;
      }
    deallog << "wall: force " << within(error, 1e-12) << ", impulse "
            << within(std::abs(impulse - 0.019), 1e-12) << std::endl;

    // a wave at x = 1/2 behind which the rod has the velocity of the wall
    Simulation<1> simulation(
      read_parameters("",
                      elastic_rod + Entries{"Contact/Condition=rigid",
                                            "Contact/Gap=-0.01*t",
                                            "Initial values/Velocity=0",
                                            "Time/Scheme=box",
                                            "Mesh/Degree=1",
                                            "Mesh/Cells=100",
                                            "Time/Step size=0.01",
                                            "Time/End time=0.5"}),
      MPI_COMM_SELF);
    PointValues<1> probes(simulation.scene(),
                          simulation.discretization(),
                          {{Point<1>(0.25), Point<1>(0.25)},
                           {Point<1>(0.75), Point<1>(0.75)}});
    simulation.run({});
    const std::vector<double> &values = probes.evaluate(simulation.state());
    deallog << "velocities before and behind the wave "
            << within(std::abs(values[2 * PointValues<1>::velocity]), 1e-14)
            << ", "
            << within(std::abs(values[2 * PointValues<1>::velocity + 1] + 0.01),
                      1e-14)
            << std::endl;
  }

  for (const double inertia : {1., 2.25})
    {
      check_law("spring on a wall", inertia, {0.1, 1., 0.}, true);
      check_law("elastic", inertia, {0.1, 1., 0.});
      check_law("elastic, hard", inertia, {1e-3, 1., 0.});
      check_law("Hertzian", inertia, {0.1, 1.5, 0.});
      check_law("Hertzian, hard", inertia, {1e-3, 1.5, 0.});
      check_law("damped", inertia, {0.1, 1., 1.});
      check_law("damped, Hertzian", inertia, {0.05, 1.5, 0.5});
      check_law("buffer on a wall", inertia, {0.1, 1., 0., 0.7}, true);
      check_law("buffer", inertia, {0.1, 1., 0., 0.3});
      check_law("buffer, Hertzian", inertia, {0.05, 1.5, 0.5, 0.3});
    }

  for (const double viscosity : {1e-3, 0.05, 1.})
    {
      std::vector<double> end;
      double              growth = 0.;
      for (const unsigned int n : {100, 200, 400})
        {
          const Run viscous = run_box(n,
                                      1.,
                                      2.,
                                      {"Model/Fields=displacement",
                                       entry("Model/Viscosity", viscosity),
                                       "Contact/Condition=power law",
                                       "Contact/Compliance=0.1",
                                       "Contact/Gap=0.05",
                                       "Initial values/Velocity=x"});
          end.push_back(viscous.rows.back().displacement_end);
          raise(growth, viscous.growth);
        }
      const double order =
        std::log2(std::abs((end[0] - end[1]) / (end[1] - end[2])));
      deallog << "viscosity " << viscosity << ": order 1.8 " << (order >= 1.8)
              << ", growth " << within(growth, 1e-13) << std::endl;
    }

  const Entries rigid  = elastic_rod + Entries{"Contact/Condition=rigid"};
  const Entries let_go = rigid + Entries{"Contact/Gap=0",
                                         "Initial values/Displacement=-0.5*x",
                                         "Initial values/Velocity=0"};
  {
    const Run r = run_box(200, 1., 2.9, let_go);
    deallog << "let go: events " << r.events.size() << ", at "
            << within(std::abs(r.events[0].time - 1.), 1e-12) << " with "
            << within(std::abs(r.events[0].velocity - 0.5), 1e-12) << ", at "
            << within(std::abs(r.events[1].time - 2.), 1e-12) << " with "
            << within(std::abs(r.events[1].velocity + 0.5), 1e-12)
            << ", restitution " << within(std::abs(r.restitution - 1.), 1e-12)
            << std::endl;
    for (const unsigned int cells : {64, 200})
      deallog << "let go on a spring, " << cells << " cells: restitution "
              << within(std::abs(
                          run_box(cells,
                                  1.,
                                  2.9,
                                  let_go + Entries{"Contact/Condition=normal "
                                                   "compliance",
                                                   "Contact/Compliance=0.01"})
                            .restitution -
                          1.),
                        1e-11)
              << std::endl;
    const Run massless = run(let_go + Entries{"Time/Scheme=sdirk4",
                                              "Time/End time=2.9",
                                              "Time/Tolerance=1e-3"});
    deallog << "sdirk4: no restitution " << std::isnan(massless.restitution)
            << std::endl;
  }
  {
    const Run r = run_box(200,
                          1.,
                          2.5,
                          rigid + Entries{"Contact/Gap=0",
                                          "Initial values/Velocity=if(x>0.5, "
                                          "1, 0)"});
    deallog << "half a rod: events " << r.events.size() << ", the last at "
            << within(std::abs(r.events.back().time - 0.5), 1e-12)
            << ", impulse "
            << within(std::abs(r.rows.back().contact_impulse - 0.5), 1e-12)
            << std::endl;
  }
  {
    const Run r     = run_box(200,
                          1.,
                          1.5,
                          rigid + Entries{"Contact/Gap=0",
                                          "Initial values/Velocity=0",
                                          "Boundary/left/Displacement=0.01*t"});
    double    early = 0.;
    for (const StepRecord &row : r.rows)
      if (row.time < 0.99)
        raise(early, std::abs(row.contact_force));
    deallog << "base: before the wave " << early << ", events "
            << r.events.size() << " at "
            << within(std::abs(r.events[0].time - 1.), 1e-12) << ", force "
            << within(std::abs(r.rows.back().contact_force - 0.02), 1e-12)
            << std::endl;
  }
  {
    const Run           r = run_box(400,
                          1.,
                          12.,
                          rigid + Entries{"Contact/Gap=0.3",
                                          "Initial values/Velocity=0",
                                          "Sources/Body force=1"});
    std::vector<double> begins;
    for (const ContactEvent &event : r.events)
      if (event.kind == ContactEvent::begin)
        begins.push_back(event.time);
    const std::vector<double> expected = {std::sqrt(0.6),
                                          4. - std::sqrt(0.8),
                                          6. - std::sqrt(0.2),
                                          8. + std::sqrt(0.4),
                                          11.};
    double                    error    = 0.;
    for (const double begin : expected)
      {
        double nearest = 1.; // touches without pressure are others
        for (const double found : begins)
          nearest = std::min(nearest, std::abs(found - begin));
        raise(error, nearest);
      }
    deallog << "falling: begins " << noise_within(error, 1e-4) << "; peak "
            << noise_within(std::abs(r.peak - 1.), 1.26e-3) << ", impulse "
            << noise_within(std::abs(r.rows.back().contact_impulse - 3.3), 1e-4)
            << std::endl;
  }
  {
    const Entries heated = {
      "Model/Coupling=0.5",
      "Model/Viscosity=0.1",
      "Boundary/right/Heat exchange=0.1/(0.1+gap)+5*pressure",
      "Boundary/left/Temperature=10+if(t>0.25,1,0)",
      "Time/Break points=0.25",
      "Time/End time=1.5"};
    const Run fine = run(heated + Entries{"Time/Tolerance=1e-8"});
    double    flux = 0.;
    for (const StepRecord &row : fine.rows)
      raise(flux, std::abs(row.heat_flux_end));
    double difference = 0., end = 0., swing[] = {0., 0.};
    for (const unsigned int n : {100, 200})
      {
        const Run    box = run_box(n, 1., 1.5, heated);
        unsigned int i   = 0;
        difference       = 0.;
        for (const StepRecord &row : box.rows)
          {
            while (i + 1 < fine.rows.size() && fine.rows[i + 1].time < row.time)
              ++i;
            const StepRecord &
              a = fine.rows[i],
             &b = fine.rows[std::min<std::size_t>(i + 1, fine.rows.size() - 1)];
            const double part =
              b.time > a.time ? (row.time - a.time) / (b.time - a.time) : 0.;
            raise(difference,
                  std::abs(row.temperature_mean - a.temperature_mean -
                           part * (b.temperature_mean - a.temperature_mean)));
          }
        for (unsigned int k = 2; k < box.rows.size(); ++k)
          if ((box.rows[k].time > 0.3 && box.rows[k].time < 0.44) ||
              box.rows[k].time > 0.55)
            raise(swing[n / 200],
                  std::abs(box.rows[k].temperature_mean -
                           2. * box.rows[k - 1].temperature_mean +
                           box.rows[k - 2].temperature_mean));
        end = std::abs(box.rows.back().temperature_end -
                       fine.rows.back().temperature_end);
      }
    const double bound = flux / 200.;
    const double decay =
      std::exp(-std::pow(dealii::numbers::PI / 2., 2) * (1.5 - 0.5));
    deallog << "heat: mean temperature in bounds "
            << within(difference / bound, 1.) << ", at the end "
            << within(end / (decay * bound), 1.) << ", second differences by 4 "
            << within(std::abs(swing[0] / swing[1] - 4.), 0.1) << std::endl;
  }
  deallog << images.words(1e-12) << std::endl;
}
