// SPDX-License-Identifier: LGPL-2.1-or-later

#include <thermocontact/base/exceptions.h>
#include <thermocontact/simulation/exchange_of_law.h>
#include <thermocontact/simulation/load_jump.h>
#include <thermocontact/space/load_scan.h>
#include <thermocontact/time/contact_equilibrium.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace ThermoContact
{
  namespace
  {
    /** Parts of the time by which a load is looked at beside a jump. */
    constexpr double beside_jump = 1e-12;

    /** Parts of a load that are rounding. */
    constexpr double rounding_of_load = 1e-13;



    /**
     * True if the loads of the momentum equation jump: if what they change from
     * one time to the next is no part of what they change around; not beyond
     * the end time, where the jumps of another run may be.
     */
    template <int dim>
    bool
    forces_jump(Body<dim> &body, const double old_time, const double new_time)
    {
      Vector heat_load = body.discretization.make_vector(Field::temperature);
      Vector sides[2], around[2];
      for (Vector *load : {&sides[0], &sides[1], &around[0], &around[1]})
        load->reinit(body.discretization.make_vector(Field::displacement));
      body.loads.assemble(old_time, heat_load, sides[0]);
      body.loads.assemble(new_time, heat_load, sides[1]);
      const double width =
        std::max(beside_jump * new_time, std::numeric_limits<double>::min());
      body.loads.assemble(std::max(old_time - width, 0.), heat_load, around[0]);
      const double end_time = body.scene.parameters.time.end_time;
      body.loads.assemble(std::min(new_time + width,
                                   std::max(new_time, end_time)),
                          heat_load,
                          around[1]);
      const double size =
        std::max(sides[0].linfty_norm(), sides[1].linfty_norm());
      sides[1] -= sides[0];
      around[1] -= around[0];
      const double change = sides[1].linfty_norm();
      return change > rounding_of_load * size &&
             change > 0.5 * around[1].linfty_norm();
    }



    /**
     * The state goes to the equilibrium of the loads at its time in a short
     * stage.
     *
     * @return the work of the loads
     */
    template <int dim>
    double
    solve_short_stage(Body<dim> &body, StageSolver &solver, State &state)
    {
      Vector heat_load = body.discretization.make_vector(Field::temperature);
      Vector momentum_load =
        body.discretization.make_vector(Field::displacement);
      const double length = jump_length(body.scene, 0.);
      StageRates   rates;
      rates.temperature_rate = heat_load;
      rates.velocity         = momentum_load;
      body.loads.assemble(state.time, heat_load, momentum_load);
      solver.solve(state,
                   length,
                   heat_load,
                   momentum_load,
                   ContactMode::unilateral,
                   rates);
      if (!rates.failure.empty())
        throw ComputationError(rates.failure);
      state.temperature.add(length, rates.temperature_rate);
      state.displacement.add(length, rates.velocity);
      state.velocity             = rates.velocity;
      state.contact_pressure     = rates.pressure;
      state.exchange_coefficient = rates.exchange_coefficient;
      return body.energy.has_work() ?
               length * body.energy.work_rate(heat_load, momentum_load, state) :
               0.;
    }
  } // namespace



  bool
  moves_at_jumps(const Scene &scene)
  {
    return scene.fields.has_displacement &&
           (!scene.material.has_inertia() || scene.contact.is_in_equilibrium());
  }



  namespace
  {
    /** Moves contact nodes alone; returns the work of the loads. */
    template <int dim>
    double
    move_nodes(Body<dim> &body, State &state)
    {
      const Vector way = move_contact_nodes(body, state);
      set_exchange_of_law(body, state);
      Vector heat_load = body.discretization.make_vector(Field::temperature);
      Vector momentum_load(way);
      body.loads.assemble(state.time, heat_load, momentum_load);
      return body.energy.work_of_motion(momentum_load, state, way);
    }



    /** The state of the loads at its time; returns their work. */
    template <int dim>
    double
    find_new_state(Body<dim>               &body,
                   Reset<dim>              &reset,
                   StageSolver             &solver,
                   const std::vector<bool> &is_closed,
                   State                   &state)
    {
      const bool is_static = body.scene.material.is_static();
      if (!is_static && !body.scene.contact.is_in_equilibrium())
        {
          reset.complete(state, is_closed);
          set_exchange_of_law(body, state);
          return 0.; // nothing moves
        }
      if (!is_static && !body.scene.linear_solver.has_matrices())
        return move_nodes(body, state);
      const Vector velocity(state.velocity);
      const double work = solve_short_stage(body, solver, state);
      // rates of what was moved at once say nothing
      if (is_static)
        state.velocity = 0.;
      else
        {
          state.velocity = velocity;
          settle_contact_nodes(body, state);
        }
      return work;
    }
  } // namespace



  template <int dim>
  bool
  apply_load_jump(Body<dim>               &body,
                  Reset<dim>              &reset,
                  StageSolver             &solver,
                  const std::vector<bool> &is_closed,
                  const LoadBreak         &at,
                  StepResult              &result)
  {
    State       &state = result.state;
    const double time  = state.time;
    if (!forces_jump(body, at.old_time, at.new_time))
      return false;
    const double old_energy = result.energy.sum();
    state.time              = at.new_time;
    const double work = find_new_state(body, reset, solver, is_closed, state);
    state.time        = time;
    state.jump_time   = time;
    result.energy     = body.energy.energy(state);
    result.work += work;
    result.numerical_dissipation += old_energy + work - result.energy.sum();
    return true;
  }



#define INSTANTIATE(dim)                                        \
  template bool apply_load_jump<dim>(Body<dim> &,               \
                                     Reset<dim> &,              \
                                     StageSolver &,             \
                                     const std::vector<bool> &, \
                                     const LoadBreak &,         \
                                     StepResult &)

  INSTANTIATE(1);
  INSTANTIATE(2);
  INSTANTIATE(3);

#undef INSTANTIATE
} // namespace ThermoContact
