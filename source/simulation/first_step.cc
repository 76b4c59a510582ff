// SPDX-License-Identifier: LGPL-2.1-or-later

#include <thermocontact/base/special_numbers.h>
#include <thermocontact/method/butcher_tableau.h>
#include <thermocontact/simulation/first_step.h>
#include <thermocontact/space/linear_system.h>

#include <algorithm>
#include <cmath>

namespace ThermoContact
{
  template <int dim>
  double
  first_step_of_heat(Body<dim>   &body,
                     const State &state,
                     const double thermal_energy)
  {
    const Scene &scene = body.scene;
    if (!scene.fields.has_temperature || scene.fields.has_displacement ||
        !scene.heat.exchange->is_in_matrices() ||
        !scene.parameters.time.has_error_control())
      return infinity;
    const double              tolerance = scene.parameters.time.tolerance;
    const auto               &equations = body.equations;
    const std::vector<double> bounds =
      butcher_tableau(scene.scheme.name).bounds_of_estimate();

    const LinearSystem<dim> mass(equations, heat_at_once);
    Vector load   = body.discretization.make_vector(Field::temperature);
    Vector forces = body.discretization.make_vector(Field::displacement);
    Vector right(load), unused(forces);
    State  rate(state);
    body.loads.assemble(state.load_time, load, forces);
    equations.stage_rhs(state, 0., load, forces, right, unused);
    constexpr double safety = 0.9; // as behind any other step, (D3.5)
    double           size   = 0.;
    // a body without thermal energy has in a step what its rate gives it
    double       scale       = thermal_energy;
    unsigned int scale_order = 0;
    for (unsigned int m = 1; m <= bounds.size(); ++m)
      {
        equations.zero_constrained(Field::temperature, right);
        mass.solve(rate.temperature, right);
        equations.zero_constrained(Field::temperature, rate.temperature);
        const double change =
          body.energy.difference_energy(rate, state.contact.pressure).thermal;
        if (!(change > 0.))
          return infinity; // at rest
        if (scale > 0.)
          size =
            std::max(size,
                     safety * std::pow(tolerance / (bounds[m - 1] *
                                                    std::sqrt(change / scale)),
                                       1. / (m - scale_order)));
        else
          {
            scale       = change;
            scale_order = 1;
          }
        equations.conduction.vmult(right, rate.temperature);
        right *= -1.;
      }
    return size;
  }



#define INSTANTIATE(dim) \
  template double first_step_of_heat(Body<dim> &, const State &, const double)

  INSTANTIATE(1);
  INSTANTIATE(2);
  INSTANTIATE(3);

#undef INSTANTIATE
} // namespace ThermoContact
