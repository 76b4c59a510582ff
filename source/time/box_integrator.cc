// SPDX-License-Identifier: LGPL-2.1-or-later

#include <thermocontact/base/local_sums.h>
#include <thermocontact/space/node_laws.h>
#include <thermocontact/time/box_integrator.h>
#include <thermocontact/time/schemes.h>

namespace ThermoContact
{
  namespace
  {
    /** Bodies of other dimensions are refused. */
    class BoxMaker : public IntegratorMaker
    {
    public:
      std::unique_ptr<TimeIntegrator>
      make(Body<1> &body) const override
      {
        return std::make_unique<BoxIntegrator>(body);
      }

      std::unique_ptr<TimeIntegrator>
      make(Body<2> &) const override
      {
        AssertThrow(false, ExcInternalError());
        return nullptr;
      }

      std::unique_ptr<TimeIntegrator>
      make(Body<3> &) const override
      {
        AssertThrow(false, ExcInternalError());
        return nullptr;
      }
    };
  } // namespace



  Scheme
  box_scheme()
  {
    static const BoxMaker maker;
    Scheme                scheme;
    scheme.name  = "box";
    scheme.text  = "for waves in an elastic rod, which have no dispersion in "
                   "steps of h sqrt(b)";
    scheme.order = 2;
    scheme.can_create_energy = false;
    scheme.has_midpoint_rule = true;
    scheme.has_no_dispersion = true;
    scheme.needs_inertia     = "without inertia there are no waves";
    scheme.needs_linear_contact =
      "the scheme knows the potential of linear laws only";
    scheme.needs_constant_exchange =
      "the scheme finds its pressures before it knows the temperatures";
    scheme.needs_resting_end =
      "its midpoint rule would let the velocity of a moving end alternate";
    scheme.needs_factors       = true;
    scheme.cannot_hold_contact = "a wave passes a cell in each of its steps";
    scheme.step_exponent       = 0.5;
    scheme.integrator          = &maker;
    return scheme;
  }



  BoxIntegrator::BoxIntegrator(Body<1> &body)
    : body(body)
    , solver(body)
    , driven(body)
    , midpoint(body.discretization.make_state())
    , heat_load(body.discretization.make_vector(Field::temperature))
    , momentum_load(body.discretization.make_vector(Field::displacement))
  {
    rates.temperature_rate = heat_load;
    rates.velocity         = momentum_load;
    acceleration           = momentum_load;
    has_mean_pressure      = body.law().is_active() && !body.law().is_rigid() &&
                        body.law().tangent(1.) >=
                          0.5 * body.scene.parameters.mesh.contact_spacing();
  }



  void
  BoxIntegrator::step(const State    &state,
                      const TimeStep &time_step,
                      const ContactMode,
                      StepResult &result)
  {
    const double size = time_step.size;
    move_obstacle(state, time_step);
    body.loads.assemble(0.5 * (time_step.first_loads + time_step.last_loads),
                        heat_load,
                        momentum_load);
    solve_without_contact(state, time_step);
    if (body.law().is_active())
      apply_contact(state, time_step);

    driven.complete(0, rates, acceleration);
    set_equal(midpoint.velocity, rates.velocity);
    set_sum(midpoint.temperature,
            state.temperature,
            0.5 * size,
            rates.temperature_rate);

    result.state.copy_values(state);
    result.state.time     = time_step.end;
    result.state.gap      = obstacle.gap;
    result.state.gap_rate = obstacle.gap_rate;
    result.state.temperature.add(size, rates.temperature_rate);
    result.state.displacement.add(size, rates.velocity);
    result.state.velocity.sadd(-1., 2., rates.velocity);
    if (body.law().is_active())
      {
        result.state.contact_pressure = rates.pressure;
        if (has_mean_pressure)
          set_pressures_of_law(body, result.state);
      }

    result.failure.clear();
    result.n_iterations  = rates.n_iterations;
    result.is_prescribed = false;
    result.dissipation   = size * body.energy.dissipation_rate(midpoint);
    result.lateral_dissipation =
      size * body.energy.lateral_dissipation_rate(midpoint);
    midpoint.contact_pressure = rates.pressure;
    result.work =
      !body.energy.has_work() ?
        0. :
        size * (body.energy.work_rate(heat_load, momentum_load, midpoint) +
                body.energy.obstacle_power(midpoint));
    result.work += size * driven.power(midpoint,
                                       rates.temperature_rate,
                                       acceleration,
                                       {heat_load, momentum_load});
    result.impulse   = size * body.contact_end().mean(rates.pressure);
    result.algebraic = 0.;
    result.energy    = body.energy.energy(result.state);
    result.close_balance();
  }



  void
  BoxIntegrator::move_obstacle(const State &state, const TimeStep &time_step)
  {
    obstacle.gap      = state.gap;
    obstacle.gap_rate = state.gap_rate;
    body.obstacle.place(time_step.end, obstacle);
    for (unsigned int i = 0; i < state.gap.size(); ++i)
      midpoint.gap_rate[i] = (obstacle.gap[i] - state.gap[i]) / time_step.size;
  }



  void
  BoxIntegrator::solve_without_contact(const State    &state,
                                       const TimeStep &time_step)
  {
    const double tau = 0.5 * time_step.size;
    if (!driven.is_active())
      {
        solver.solve_without_contact(
          state, tau, heat_load, momentum_load, rates);
        return;
      }
    static const std::vector<std::vector<double>> half   = {{0.5}};
    static const std::vector<double>              weight = {1.};
    driven.start(state, time_step.size, {half, weight, {time_step.last_loads}});
    State      known(state);
    const auto loads = driven.constrain(0, {heat_load, momentum_load}, known);
    solver.solve_without_contact(known, tau, loads.heat, loads.momentum, rates);
  }



  void
  BoxIntegrator::apply_contact(const State &state, const TimeStep &time_step)
  {
    const ContactEnd<1> &end = body.contact_end();
    get_node_laws(body, state, laws, start);
    // the velocity first, then where it leads
    end.get_values(Field::displacement, rates.velocity, end_position);
    end_position[0] =
      start[0] + (time_step.size * end_position[0] -
                  (laws[0].side > 0 ? obstacle.gap[0] - state.gap[0] : 0.));
    rates.pressure.assign(1, 0.);
    rates.n_iterations = 0;
    if (laws[0].is_open(start[0]) && laws[0].is_open(end_position[0]))
      return;
    if (has_mean_pressure)
      laws[0].mean_from = start[0];
    rates.pressure[0] =
      laws[0].resolve(end_position[0], 2. * solver.response()(0, 0)).pressure;
    rates.n_iterations = 1;
    solver.apply_pressure(rates);
  }
} // namespace ThermoContact
