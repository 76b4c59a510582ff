// SPDX-License-Identifier: LGPL-2.1-or-later
//
// Bodies at obstacles with p = ([s]_+/eps)^m [1 + c s_t]_+, doc/model.md
// section 4.
//
// 1. The audit of backward Euler with all its terms, of experiment 1 and of a
//    strip before a curved obstacle, m = 1 and 3/2: to 1e-11 of the largest
//    term; without loads the energy never increases, no step creates any, and
//    the obstacle takes energy in each step (to -1e-12 of the largest).
// 2. A strip and a block on rollers equal the rod: all columns, and what the
//    obstacle takes, to 1e-9 of the largest.
// 3. Heat exchange 1 + 0*pressure, solved together with the contact, equals the
//    number 1: all columns to 1e-10 of the largest; rod and strip.
// 4. Start in contact without inertia, one cell, u = -x/10, g = -0.3, eps =
//    0.4, m = 1, c = 2: zeta v + u + (s/eps)(1 + c v) = 0, s = 0.2, zeta = 1/2
//    gives v = (0.1 - 0.5)/(0.5 + 1) = -4/15 and the force 1/2 (1 - 8/15) =
//    7/30.
// 5. Orders: a preload in equilibrium, u = -x/10, g = -0.2, eps =
//    0.1^(1-1/m), so that p = 1/10 at rest, and the traction t^4/2, c = 1/2, m
//    = 1 and 3/2: u(1) at t = 1 in contact, one cell of degree 2, steps of 1/80
//    and 1/160 against sdirk4 with 1/1280: order of the scheme to 0.15.

#include <thermocontact/simulation/simulation.h>

#include <deal.II/base/mpi.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "../recorded_run.h"

using namespace ThermoContact;

namespace
{
  Overrides
  law(const double m, const double c)
  {
    return Overrides{"Contact/Condition=power law",
                     "Contact/Exponent=" + number(m),
                     "Contact/Damping=" + number(c)};
  }



  const Overrides one_cell{"Model/Fields=displacement",
                           "Mesh/Cells=1",
                           "Mesh/Degree=1"};



  void
  check_audit(const std::string &title, const RecordedRun &result)
  {
    const std::vector<StepRecord> &rows = result.rows;
    double largest = 0., defect = 0., increase = 0., created = 0., given = 0.;
    for (const StepRecord &r : rows)
      for (const double term :
           {r.energy, r.work, r.dissipation, r.numerical_dissipation})
        raise(largest, std::abs(term));
    for (unsigned int i = 1; i < rows.size(); ++i)
      {
        const StepRecord &r = rows[i], &old = rows[i - 1];
        raise(defect,
              std::abs(rows[0].energy + r.work - r.energy - r.dissipation -
                       r.contact_dissipation - r.numerical_dissipation));
        raise(increase, r.energy - old.energy);
        raise(created, old.numerical_dissipation - r.numerical_dissipation);
        raise(given, old.contact_dissipation - r.contact_dissipation);
      }
    deallog << title << ": the obstacle has taken energy "
            << (rows.back().contact_dissipation > 1e-6 * largest)
            << ", audit to 1e-11 " << (defect < 1e-11 * largest)
            << ", energy never increases " << (increase < 1e-12 * largest)
            << ", none created " << (created < 1e-12 * largest)
            << ", none given " << (given < 1e-12 * largest) << std::endl;
  }



  const Overrides euler{"Time/Scheme=backward euler",
                        "Time/Start=consistent",
                        "Time/Step size=0.01",
                        "Time/End time=1"};

  const Overrides coarse{"Mesh/Cells=3",
                         "Mesh/Degree=2",
                         "Contact/Compliance=0.05"};



  /** Largest difference of columns, each in parts of its largest value. */
  double
  difference(const RecordedRun &one, const RecordedRun &other)
  {
    if (one.rows.size() != other.rows.size())
      return 1.;
    std::vector<double> change, largest;
    for (unsigned int i = 0; i < one.rows.size(); ++i)
      {
        const auto          columns       = all_columns(one.rows[i]);
        const auto          other_columns = all_columns(other.rows[i]);
        std::vector<double> a(columns.begin(), columns.end());
        std::vector<double> b(other_columns.begin(), other_columns.end());
        a.push_back(one.rows[i].contact_dissipation);
        b.push_back(other.rows[i].contact_dissipation);
        change.resize(a.size());
        largest.resize(a.size(), 1e-3);
        for (unsigned int j = 0; j < a.size(); ++j)
          if (!(std::isnan(a[j]) && std::isnan(b[j])))
            {
              raise(change[j], std::abs(a[j] - b[j]));
              raise(largest[j], std::abs(a[j]));
            }
      }
    double result = 0.;
    for (unsigned int j = 0; j < change.size(); ++j)
      raise(result, change[j] / largest[j]);
    return result;
  }



  const Overrides strip{"Dimension=2", "Mesh/Cells across=2"};
  const Overrides block{"Dimension=3", "Mesh/Cells across=1"};



  void
  check_bodies()
  {
    const Overrides   scene = coarse + law(1.5, 0.3) + euler;
    const RecordedRun rod   = run<1>("", scene);
    deallog << "contact " << (rod.rows.back().contact_impulse > 0.)
            << ", strip equals rod to 1e-9 "
            << (difference(rod, run<2>("", scene + strip)) < 1e-9) << ", block "
            << (difference(rod, run<3>("", scene + block)) < 1e-9) << std::endl;

    const Overrides exchange{"Boundary/Heat exchange=1+0*pressure"};
    deallog << "exchange by an expression equals the number to 1e-10: rod "
            << (difference(rod, run<1>("", scene + exchange)) < 1e-10)
            << ", strip "
            << (difference(run<2>("", scene + strip),
                           run<2>("", scene + strip + exchange)) < 1e-10)
            << std::endl;
  }



  void
  check_start_in_contact()
  {
    const RecordedRun result =
      run<1>("",
             one_cell + law(1., 2.) +
               Overrides{"Model/Inertia=0",
                         "Model/Viscosity=0.5",
                         "Contact/Gap=-0.3",
                         "Contact/Compliance=0.4",
                         "Initial values/Displacement=-x/10",
                         "Time/End time=0.01"});
    const StepRecord &first = result.rows.front();
    deallog << "start in contact: velocity over -4/15 and force over 7/30, to "
            << "1e-12 "
            << (std::abs(first.velocity_end * -15. / 4. - 1.) < 1e-12) << ' '
            << (std::abs(first.contact_force * 30. / 7. - 1.) < 1e-12)
            << std::endl;
  }



  double
  end_of_preload(const std::string &scheme, const double m, const double step)
  {
    return run<1>("",
                  law(m, 0.5) + Overrides{"Contact/Gap=-0.2",
                                          "Contact/Compliance=" +
                                            number(std::pow(0.1, 1. - 1. / m)),
                                          "Model/Fields=displacement",
                                          "Initial values/Displacement=-x/10",
                                          "Initial values/Velocity=0",
                                          "Sources/End traction=t^4/2",
                                          "Time/Scheme=" + scheme,
                                          "Time/Step size=" + number(step),
                                          "Time/Start=consistent",
                                          "Mesh/Cells=1",
                                          "Mesh/Degree=2",
                                          "Time/End time=1"})
      .rows.back()
      .displacement_end;
  }



  void
  check_orders(const double m)
  {
    const double exact = end_of_preload("sdirk4", m, 1. / 1280.);
    for (const auto &[scheme, order] : {std::pair("backward euler", 1.),
                                        std::pair("sdirk2", 2.),
                                        std::pair("sdirk3", 3.),
                                        std::pair("sdirk4", 4.)})
      {
        const double coarse = end_of_preload(scheme, m, 1. / 80.) - exact;
        const double fine   = end_of_preload(scheme, m, 1. / 160.) - exact;
        const double rate   = std::log2(std::abs(coarse / fine));
        deallog << "m = " << m << ", " << scheme << ": order " << order << ' '
                << (std::abs(rate - order) < 0.15) << std::endl;
        if (!(std::abs(rate - order) < 0.15))
          deallog << rate << std::endl;
      }
  }
} // namespace



int
main(int argc, char **argv)
{
  Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  initlog();
  for (const double m : {1., 1.5})
    {
      check_audit("m = " + number(m) + ", rod",
                  run<1>("", coarse + law(m, 0.3) + euler));
      check_audit("m = " + number(m) + ", strip, curved obstacle",
                  run<2>("",
                         coarse + strip + law(m, 0.3) + euler +
                           Overrides{"Contact/Gap=0.05+5*(y-0.03)^2",
                                     "Boundary/Lateral support=free"}));
    }
  check_bodies();
  check_start_in_contact();
  for (const double m : {1., 1.5})
    check_orders(m);
}
