// SPDX-License-Identifier: LGPL-2.1-or-later
//
// Rods without inertia; the solutions are derived in the parameter files.
//
// 1. creep-release.prm: u(1) in contact and after it, and the time at which
//    contact ends, by elementary functions: 1e-8, tolerance 1e-7.
// 2. equilibrium.prm: u(1) = G - p and p = [G - g]_+/(1 + eps) with G = a times
//    the integral of theta, at every row, the initial one included, for an
//    elastic (eps = 0.01) and a rigid obstacle (eps = 0) and all schemes:
//    1e-11.
// 3. inertia-limit.prm: the difference of u(1) to that of b = 0 is O(b), at t =
//    0.25, ..., 2, in contact and out of it: rates 1 +-0.02 between b = 1e-3,
//    1e-4, 1e-5, and +-0.15 between 1e-2 and 1e-3, which is not small against
//    (zeta pi/4)^2 = 0.025, where the first mode begins to oscillate.
// 4. A cold rod with b = zeta = 0 under the body force cos(3 t), whose strain,
//    1 at most, makes temperatures of a, at first 9/2 a t^2: rounding of the
//    strain. Tolerance 1e-7 against 1e-9, 20 tolerances in parts of a.

#include <thermocontact/simulation/simulation.h>

#include <deal.II/base/mpi.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "../tests.h"

#include "../recorded_run.h"

using namespace ThermoContact;

namespace
{
  void
  check_creep()
  {
    const Parameters parameters =
      read_parameters("verification/creep-release.prm");
    const double zeta = parameters.model.viscosity;
    const double eps  = parameters.contact.law.at("Compliance");
    const double g    = parameters.contact.gap;
    const double v_0  = 0.2; // u_0 = v_0 x in the file
    const double v_e  = g / (1. + eps);
    const double release =
      zeta * eps / (1. + eps) * std::log((v_0 - v_e) / (g - v_e));

    double       error     = 0.;
    unsigned int n_contact = 0;
    const auto [rows, events, counts] =
      run<1>("verification/creep-release.prm", {});
    for (const StepRecord &r : rows)
      {
        const double u =
          r.time < release ?
            v_e + (v_0 - v_e) * std::exp(-(1. + 1. / eps) * r.time / zeta) :
            g * std::exp(-(r.time - release) / zeta);
        raise(error, std::abs(r.displacement_end - u));
        n_contact += r.in_contact;
      }
    const bool is_released =
      events.size() == 2 && events[1].kind == ContactEvent::end;
    const double late = is_released ? events[1].time - release : INFINITY;
    deallog << "creep: rows in contact and not " << (n_contact > 1)
            << (rows.size() - n_contact > 1) << ", u(1) " << within(error, 1e-8)
            << ", end of contact " << within(std::abs(late), 1e-8) << std::endl;
  }



  void
  check_equilibrium(const std::string              &title,
                    const std::vector<std::string> &overrides)
  {
    const Parameters parameters =
      read_parameters("verification/equilibrium.prm", overrides);
    const double eps = parameters.contact.condition == "rigid" ?
                         0. :
                         parameters.contact.law.at("Compliance");
    const double g   = parameters.contact.gap;

    double error = 0.;
    const auto [rows, events, counts] =
      run<1>("verification/equilibrium.prm", overrides);
    for (const StepRecord &r : rows)
      {
        const double G = parameters.model.coupling * r.temperature_mean;
        const double p = std::max(G - g, 0.) / (1. + eps);
        raise(error, std::abs(r.displacement_end - (G - p)));
        raise(error, std::abs(r.contact_force - p));
      }
    const unsigned int n_begins =
      std::count_if(events.begin(),
                    events.end(),
                    [](const ContactEvent &event) {
                      return event.kind == ContactEvent::begin;
                    });
    deallog << "equilibrium, " << title << ": contact begins " << n_begins
            << ", ends " << events.size() - n_begins << ", u(1) and p "
            << within(error, 1e-11) << std::endl;
  }



  /** u(1) at the output times; the number of those in contact. */
  std::vector<double>
  displacements(const std::string &inertia, unsigned int &n_contact)
  {
    std::vector<std::string> overrides = {"Model/Inertia=" + inertia};
    if (inertia == "0") // has no initial velocity: back to the default
      overrides.push_back("Initial values/Velocity=20*x*(x-1)^2");
    const Parameters parameters =
      read_parameters("verification/inertia-limit.prm", overrides);
    const double        interval = parameters.output.contact_interval;
    std::vector<double> values;
    n_contact = 0;
    Simulation<1> simulation(parameters, MPI_COMM_SELF);
    const auto    observe = [&](const Simulation<1> &s) {
      const StepRecord &r = s.record();
      if (std::abs(r.time - interval * (values.size() + 1)) < 1e-12)
        {
          values.push_back(r.displacement_end);
          n_contact += r.in_contact;
        }
    };
    simulation.run({observe});
    return values;
  }



  void
  check_inertia_limit()
  {
    unsigned int              n_contact  = 0;
    const std::vector<double> limit      = displacements("0", n_contact);
    std::vector<double>       difference = displacements("1e-2", n_contact);
    for (unsigned int i = 0; i < limit.size(); ++i)
      difference[i] -= limit.at(i);

    for (const std::string inertia : {"1e-3", "1e-4", "1e-5"})
      {
        const std::vector<double> u     = displacements(inertia, n_contact);
        const double              bound = inertia == "1e-3" ? 0.15 : 0.02;
        double                    worst = 0.;
        for (unsigned int i = 0; i < limit.size(); ++i)
          {
            const double next = u.at(i) - limit[i];
            const double rate = std::log10(difference[i] / next);
            raise(worst, std::abs(rate - 1.));
            difference[i] = next;
          }
        deallog << "b to " << inertia << ": times " << limit.size()
                << ", in contact " << n_contact << ", rates 1 within " << bound
                << ' ' << within(worst, bound) << std::endl;
      }
  }



  void
  check_cold_rod()
  {
    const auto temperature = [](const std::string &tolerance) {
      Simulation<1> simulation(read_parameters("",
                                               {"Model/Inertia=0",
                                                "Model/Viscosity=0",
                                                "Contact/Condition=none",
                                                "Boundary/left/Temperature=0",
                                                "Initial values/Temperature=0",
                                                "Sources/Body force=cos(3*t)",
                                                "Time/End time=1",
                                                "Time/Tolerance=" + tolerance}),
                               MPI_COMM_SELF);
      simulation.run();
      return simulation.record().temperature_mean /
             simulation.parameters().model.coupling;
    };
    deallog << "cold rod: error of the temperature in parts of a "
            << within(std::abs(temperature("1e-7") - temperature("1e-9")),
                      20e-7)
            << std::endl;
  }
} // namespace



void
main_quasi_static()
{
  initlog();

  check_creep();
  for (const char *condition : {"normal compliance", "rigid"})
    {
      const std::string contact = std::string("Contact/Condition=") + condition;
      check_equilibrium(std::string(condition) + ", automatic steps",
                        {contact});
      for (const char *scheme :
           {"backward euler", "sdirk2", "sdirk3", "sdirk4"})
        check_equilibrium(std::string(condition) + ", " + scheme,
                          {contact,
                           std::string("Time/Scheme=") + scheme,
                           "Time/Step size=0.05"});
    }
  check_inertia_limit();
  check_cold_rod();
}
