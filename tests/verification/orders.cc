// SPDX-License-Identifier: LGPL-2.1-or-later
//
// Order in dt of all schemes on a fixed mesh, where contact does not change:
// experiment 1 without an obstacle, and pressed against it all the time (gap
// -10, eps = 1, initial displacement -10 x/(1 + eps), that of a rod at rest
// there). Quantities at t = 0.48, against sdirk4 with steps at least 32 times
// smaller; two halvings each. Expected: the order of the tableau, +-0.15, for
// u(1), u_t(1), theta(1) and the contact force; errors below 1e-11 are rounding
// and skipped. The remainder N of the energy balance between t = 0.24 and 0.48,
// away from the corner layer of the data at t = 0, vanishes with that order,
// too; for backward Euler, whose N has a formula of its own, it is of order 1.

#include <thermocontact/simulation/simulation.h>

#include <deal.II/base/mpi.h>

#include <array>
#include <cmath>

#include "../tests.h"

using namespace ThermoContact;

namespace
{
  const double end_time = 0.48;

  using Quantities = std::array<double, 5>;

  const std::array<const char *, 5> names = {
    {"u(1)", "u_t(1)", "theta(1)", "force", "N"}};



  Quantities
  run(const std::string &scheme, const unsigned int n_steps, const bool contact)
  {
    Parameters parameters        = read_parameters("");
    parameters.mesh.cells        = 4;
    parameters.mesh.degree       = 5;
    parameters.contact.condition = contact ? "normal compliance" : "none";
    if (contact)
      {
        parameters.contact.gap                  = -10.;
        parameters.contact.law.at("Compliance") = 1.;
        parameters.initial_values.displacement  = "-5*x";
      }
    parameters.time.scheme    = scheme;
    parameters.time.start     = "consistent";
    parameters.time.end_time  = end_time;
    parameters.time.step_size = end_time / n_steps;
    Simulation<1> simulation(parameters, MPI_COMM_SELF);
    bool          as_expected = true;
    double        remainder   = 0.;
    const auto    observe     = [&](const Simulation<1> &s) {
      const StepRecord &r = s.record();
      as_expected &= r.in_contact == contact;
      if (2 * r.step == n_steps)
        remainder = r.numerical_dissipation;
    };
    simulation.run({observe});
    if (!as_expected)
      deallog << "contact is not what the scene is made for" << std::endl;
    const StepRecord &r = simulation.record();
    return {{r.displacement_end,
             r.velocity_end,
             r.temperature_end,
             r.contact_force,
             r.numerical_dissipation - remainder}};
  }



  /** The expected order if it is observed, the observed one otherwise. */
  void
  print_order(const char *name, const double expected, const double observed)
  {
    deallog << ", " << name << ' '
            << (std::abs(observed - expected) <= 0.15 ? expected : observed);
  }



  void
  study(const std::string &scheme, const unsigned int order, const bool contact)
  {
    Quantities reference = run("sdirk4", 12800, contact);
    reference.back()     = 0.; // the remainder itself is the error

    std::array<Quantities, 3> errors;
    for (unsigned int level = 0; level < 3; ++level)
      {
        errors[level] = run(scheme,
                            (order == 1 ? 400 :
                             order == 4 ? 40 :
                                          100)
                              << level,
                            contact);
        for (unsigned int q = 0; q < reference.size(); ++q)
          errors[level][q] = std::abs(errors[level][q] - reference[q]);
      }
    deallog << scheme << (contact ? ", in contact" : ", without contact");
    for (unsigned int q = 0; q < reference.size(); ++q)
      if (contact || std::string(names[q]) != "force")
        for (unsigned int level = 1; level < 3; ++level)
          if (!(errors[level][q] < 1e-11))
            print_order(names[q],
                        order,
                        std::log2(errors[level - 1][q] / errors[level][q]));
    deallog << std::endl;
  }
} // namespace



void
main_orders()
{
  initlog();
  for (const bool contact : {false, true})
    {
      study("backward euler", 1, contact);
      study("sdirk2", 2, contact);
      study("sdirk3", 3, contact);
      study("sdirk4", 4, contact);
    }
}
