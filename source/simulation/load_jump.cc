// SPDX-License-Identifier: LGPL-2.1-or-later

#include <thermocontact/base/exceptions.h>
#include <thermocontact/method/load_samples.h>
#include <thermocontact/simulation/load_jump.h>
#include <thermocontact/simulation/quasi_static_start.h>
#include <thermocontact/time/contact_equilibrium.h>

namespace ThermoContact
{
  namespace
  {
    /**
     * Length of the stage in which equilibrium is restored. Neither heat nor
     * momentum go far in it, and rates are within the range of numbers.
     */
    constexpr double jump_length = 1e-11;
  } // namespace



  bool
  moves_at_jumps(const Scene &scene)
  {
    return scene.fields.has_displacement &&
           (!scene.material.has_inertia() || scene.contact.is_in_equilibrium);
  }



  template <int dim>
  void
  apply_load_jump(Body<dim> &body, StageSolver &solver, StepResult &result)
  {
    const double old_energy = result.energy.sum();
    State       &state      = result.state;
    const double time       = state.time;
    state.time              = next_time(time);
    const Scene &scene      = body.scene;
    double       work       = 0.;
    if (scene.material.is_static() || scene.contact.is_in_equilibrium)
      {
        Vector heat_load = body.discretization.make_vector(Field::temperature);
        Vector momentum_load =
          body.discretization.make_vector(Field::displacement);
        StageRates rates;
        rates.temperature_rate = heat_load;
        rates.velocity         = momentum_load;
        body.loads.assemble(state.time, heat_load, momentum_load);
        solver.solve(state,
                     jump_length,
                     heat_load,
                     momentum_load,
                     ContactMode::unilateral,
                     rates);
        if (!rates.failure.empty())
          throw ComputationError(rates.failure);
        state.temperature.add(jump_length, rates.temperature_rate);
        state.displacement.add(jump_length, rates.velocity);
        state.velocity             = rates.velocity;
        state.contact_pressure     = rates.pressure;
        state.exchange_coefficient = rates.exchange_coefficient;
        if (body.energy.has_work())
          work = jump_length *
                 body.energy.work_rate(heat_load, momentum_load, state);
        // rates of what was moved at once say nothing
        if (scene.material.is_static())
          state.velocity = 0.;
        else
          settle_contact_nodes(body, state);
      }
    else
      QuasiStaticStart<dim>(body).complete(state);
    state.time    = time;
    result.energy = body.energy.energy(state);
    result.work += work;
    result.numerical_dissipation += old_energy + work - result.energy.sum();
  }



#define INSTANTIATE(dim) \
  template void apply_load_jump<dim>(Body<dim> &, StageSolver &, StepResult &)

  INSTANTIATE(1);
  INSTANTIATE(2);
  INSTANTIATE(3);

#undef INSTANTIATE
} // namespace ThermoContact
