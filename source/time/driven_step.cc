// SPDX-License-Identifier: LGPL-2.1-or-later

#include <thermocontact/time/driven_step.h>

namespace ThermoContact
{
  namespace
  {
    std::vector<double>
    values_at(const std::vector<unsigned int> &entries, const Vector &vector)
    {
      std::vector<double> values;
      for (const unsigned int entry : entries)
        values.push_back(vector.begin()[entry]);
      return values;
    }



    /** A motion of entries of a vector by a function of time. */
    void
    start_motion(const std::unique_ptr<const TimeFunction> &function,
                 const std::vector<double>                 &old_values,
                 const double                               size,
                 const StageTimes                          &stages,
                 const bool                                 has_inertia,
                 PrescribedMotion                          &motion)
    {
      motion.start(stages, size, old_values, has_inertia, [&](const double t) {
        return std::vector<TimeDerivatives>(old_values.size(),
                                            old_values.empty() ?
                                              TimeDerivatives{} :
                                              function->derivatives(t));
      });
    }
  } // namespace



  template <int dim>
  DrivenStep<dim>::DrivenStep(const Body<dim> &body)
    : body(body)
  {
    if (!is_active())
      return;
    heat_load     = body.discretization.make_vector(Field::temperature);
    momentum_load = body.discretization.make_vector(Field::displacement);
  }



  template <int dim>
  void
  DrivenStep<dim>::start(const State      &state,
                         const double      size,
                         const StageTimes &stages)
  {
    if (!is_active())
      return;
    const Scene &scene = body.scene;
    const auto  &moved = body.driven_end.entries(Field::displacement);
    start_motion(scene.heat.fixed_end_drive,
                 values_at(body.driven_end.entries(Field::temperature),
                           state.temperature),
                 size,
                 stages,
                 false,
                 temperature);
    start_motion(scene.fixed_end_motion,
                 values_at(moved, state.displacement),
                 size,
                 stages,
                 scene.material.has_inertia(),
                 displacement);
    displacement.set_accelerations(values_at(moved, state.velocity),
                                   displacement.stages().back().rates);
  }



  template <int dim>
  typename DrivenStep<dim>::StageLoads
  DrivenStep<dim>::constrain(const unsigned int stage,
                             const StageLoads  &loads,
                             State             &known)
  {
    if (!is_active())
      return loads;
    heat_load     = loads.heat;
    momentum_load = loads.momentum;
    body.driven_end.constrain(temperature.stages()[stage],
                              displacement.stages()[stage],
                              known,
                              heat_load,
                              momentum_load);
    return {heat_load, momentum_load};
  }



  template <int dim>
  void
  DrivenStep<dim>::complete(const unsigned int stage, StageRates &rates) const
  {
    if (!is_active())
      return;
    const DrivenEnd<dim>  &end    = body.driven_end;
    const PrescribedStage &motion = displacement.stages()[stage];
    end.set(Field::temperature,
            temperature.stages()[stage].rates,
            rates.temperature_rate);
    end.set(Field::displacement, motion.rates, rates.velocity);
    end.set(Field::displacement, motion.accelerations, rates.acceleration);
  }



  template class DrivenStep<1>;
  template class DrivenStep<2>;
  template class DrivenStep<3>;
} // namespace ThermoContact
