// SPDX-License-Identifier: LGPL-2.1-or-later
//
// What the mesh of a rod leaves out, (D9.1), for displacements and temperatures
// that are given; all by hand, with norms of one.
//
// 1. One cell of degree 3, u = 0.5 P_2 + 0.1 P_3 in xi = 2x - 1: P_3' = 5 P_2 +
//    P_0, P_2' = 3 P_1, so that the strain has 1.0 P_2 and 3.0 P_1, whose
//    squares are 1/5 and 3. The rate is sqrt(1/15). The same temperature has
//    0.01/7 and 0.25/5, with the rate sqrt(1/35). For a time 1, then half of it
//    for 3: the square is 7/16 of that.
// 2. Four cells of degree 1, u = x^3: slopes h^2 (3i^2 + 3i + 1) differ by
//    6 h^2 (i + 1); the strain lacks half of that times P_1 in a cell. Squares
//    h/3 (3 h^2)^2 (1 + 4 + 9) = 42 h^5; of the changes 2 h/3 (3 h^2)^2 = 6
//    h^5.
// 3. Four cells of degree 2, u = x^4: with the middle m of a cell the strain
// has
//    4/h (6 m^2 (h/2)^2 + (h/2)^4) P_1, from cell to cell 12 h^3 (i + 1) more;
//    it lacks a sixth of that times P_2. Squares h/5 (2 h^3)^2 14, of the
//    changes h/5 (2 h^3)^2 2.
// 4. A linear displacement leaves out nothing and is not warned of. That of 1.
//    is, once; of the cells of the box scheme nothing is said.
// 5. 1000 steps with the displacement of 2., 100 times that in the ten steps
//    601 to 610 of a contact: of these step 608 is looked at, for 8 steps, so
//    that the mean of the squares is 0.992 + 0.008 * 1e4.

#include <thermocontact/base/dealii_versions.h>
#include <thermocontact/scene/scene.h>
#include <thermocontact/simulation/spatial_error_monitor.h>

#include <deal.II/base/mpi.h>

#include <functional>

#include "../tests.h"

using namespace ThermoContact;

namespace
{
  StepRecord
  record_of(const double step_size)
  {
    StepRecord record;
    record.step_size            = step_size;
    record.energy_terms.thermal = record.energy_terms.elastic = 0.5;
    return record;
  }



  /** Adds states f, and f/2 for another time 3, to a monitor of its own. */
  class Monitored
  {
  public:
    Monitored(const std::vector<std::string>              &overrides,
              const std::function<double(const double x)> &f)
      : parameters(read_parameters("", overrides))
      , scene(parameters)
      , space(scene, MPI_COMM_SELF)
      , monitor(scene, space)
      , state(space.make_state())
    {
      const auto points = support_points(space.mapping(), space.dof_handler());
      const unsigned int n = space.n_temperature_dofs();
      for (const auto &[dof, point] : points)
        (dof < n ? state.temperature[dof] : state.displacement[dof - n]) =
          f(point[0]);
      if (!scene.parameters.time.has_error_control())
        return;
      monitor.add(state, record_of(1.));
      state.temperature *= 0.5;
      state.displacement *= 0.5;
      monitor.add(state, record_of(3.));
    }

    /** Over what it is by hand, from the squares of norms. */
    double
    ratio(const Field::Block field, const double upper, const double lower)
    {
      return monitor.error(field) /
             std::sqrt(7. / 16. * upper * std::sqrt(upper / lower));
    }

    const Parameters        parameters;
    const Scene             scene;
    const Discretization<1> space;
    SpatialErrorMonitor     monitor;
    State                   state; ///< that of the last time
  };



  std::vector<std::string>
  mesh(const unsigned int cells, const unsigned int degree)
  {
    return {"Mesh/Cells=" + std::to_string(cells),
            "Mesh/Degree=" + std::to_string(degree)};
  }



  /** Case 5. */
  void
  check_contact_among_many_steps()
  {
    std::vector<std::string> overrides = mesh(4, 1);
    for (const char *const entry :
         {"Time/Scheme=backward euler", "Time/Step size=1e-3"})
      overrides.push_back(entry);
    Monitored rod(overrides, [](const double x) { return x * x * x; });
    for (unsigned int n = 1; n <= 1000; ++n)
      {
        const bool is_in_contact = n > 600 && n <= 610;
        State      state         = rod.state;
        state.displacement *= is_in_contact ? 100. : 1.;
        rod.monitor.add(state, record_of(1e-3));
      }
    const double h5 = std::pow(0.25, 5);
    deallog << "ten steps of a contact: "
            << rod.ratio(Field::displacement, 6. * h5, 42. * h5) /
                 std::sqrt(80.992 / (7. / 16.))
            << std::endl;
  }
} // namespace



void
main_spatial_error_monitor()
{
  initlog();
  const auto legendre = [](const double x) {
    return 0.5 * std::legendre(2, 2. * x - 1.) +
           0.1 * std::legendre(3, 2. * x - 1.);
  };
  Monitored cubic(mesh(1, 3), legendre);
  deallog << "degree 3, strain: "
          << cubic.ratio(Field::displacement, 1. / 5., 3.) << std::endl
          << "degree 3, temperature: "
          << cubic.ratio(Field::temperature, 0.01 / 7., 0.25 / 5.) << std::endl;
  const double h = 0.25;
  Monitored    linear(mesh(4, 1), [](const double x) { return x * x * x; });
  deallog << "degree 1, strain: "
          << linear.ratio(Field::displacement,
                          6. * std::pow(h, 5),
                          42. * std::pow(h, 5))
          << std::endl;
  Monitored quadratic(mesh(4, 2), [](const double x) { return x * x * x * x; });
  deallog << "degree 2, strain: "
          << quadratic.ratio(Field::displacement,
                             8. / 5. * std::pow(h, 7),
                             56. / 5. * std::pow(h, 7))
          << std::endl;
  Monitored straight(mesh(4, 4), [](const double x) { return x; });
  deallog << "straight: error below rounding "
          << within(straight.monitor.error(Field::displacement), 1e-12)
          << ", warned of " << !straight.monitor.take_warning().empty()
          << std::endl;
  deallog << "degree 3: warned of " << !cubic.monitor.take_warning().empty()
          << ", again " << !cubic.monitor.take_warning().empty() << std::endl;
  Monitored box({"Mesh/Cells=4",
                 "Mesh/Degree=1",
                 "Model/Fields=displacement",
                 "Model/Viscosity=0",
                 "Time/Scheme=box",
                 "Time/Step size=0.25"},
                [](const double x) { return x * x * x; });
  deallog << "box: error " << box.monitor.error(Field::displacement)
          << std::endl;
  check_contact_among_many_steps();
}
