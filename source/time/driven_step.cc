// SPDX-License-Identifier: LGPL-2.1-or-later

#include <thermocontact/time/driven_step.h>

namespace ThermoContact
{
  namespace
  {
    /** Takes the weighted mean away. */
    void
    subtract_mean(const std::vector<double> &weights,
                  std::vector<double>       &rates)
    {
      double mean = 0.;
      for (unsigned int i = 0; i < rates.size(); ++i)
        mean += weights[i] * rates[i];
      for (double &rate : rates)
        rate -= mean;
    }



    /** Rates that lead the entries of a vector to @p value in a step. */
    std::vector<double>
    mean_rates(const std::vector<unsigned int> &entries,
               const Vector                    &vector,
               const double                     value,
               const double                     size)
    {
      std::vector<double> rates;
      for (const unsigned int entry : entries)
        rates.push_back((value - vector.begin()[entry]) / size);
      return rates;
    }



    void
    set_shifted(const std::vector<double> &mean,
                const double               deviation,
                std::vector<double>       &rates)
    {
      rates = mean;
      for (double &rate : rates)
        rate += deviation;
    }



    /** Where the known values lead with the rates of a stage. */
    void
    set_values(const std::vector<unsigned int> &entries,
               const Vector                    &known,
               const double                     tau,
               const std::vector<double>       &rates,
               std::vector<double>             &values)
    {
      values.resize(rates.size());
      for (unsigned int i = 0; i < rates.size(); ++i)
        values[i] = known.begin()[entries[i]] + tau * rates[i];
    }
  } // namespace



  template <int dim>
  DrivenStep<dim>::DrivenStep(const Body<dim> &body)
    : body(body)
    , heat_load_(body.discretization.make_vector(Field::temperature))
    , momentum_load_(body.discretization.make_vector(Field::displacement))
  {}



  template <int dim>
  void
  DrivenStep<dim>::start(const State      &state,
                         const double      size,
                         const StageTimes &stages)
  {
    const Scene               &scene   = body.scene;
    const std::vector<double> &weights = stages.weights;
    const DrivenEnd<dim>      &end     = body.driven_end;
    temperature_deviations.clear();
    velocity_deviations.clear();
    acceleration_deviations.clear();
    double last_value = 0.;
    if (scene.sources.has_driven_temperature)
      {
        for (const double time : stages.times)
          {
            const TimeDerivatives drive =
              scene.heat.fixed_end_drive->derivatives(time);
            last_value = drive.value;
            temperature_deviations.push_back(drive.first);
          }
        subtract_mean(weights, temperature_deviations);
        mean_temperature_rate = mean_rates(end.entries(Field::temperature),
                                           state.temperature,
                                           last_value,
                                           size);
      }
    if (!scene.sources.has_moving_end)
      return;
    for (const double time : stages.times)
      {
        const TimeDerivatives drive = scene.fixed_end_motion->derivatives(time);
        last_value                  = drive.value;
        velocity_deviations.push_back(drive.first);
        acceleration_deviations.push_back(drive.second);
      }
    subtract_mean(weights, velocity_deviations);
    subtract_mean(weights, acceleration_deviations);
    const std::vector<unsigned int> &entries = end.entries(Field::displacement);
    mean_velocity = mean_rates(entries, state.displacement, last_value, size);
    mean_acceleration.resize(entries.size());
    for (unsigned int i = 0; i < entries.size(); ++i)
      mean_acceleration[i] = (mean_velocity[i] + velocity_deviations.back() -
                              state.velocity.begin()[entries[i]]) /
                             size;
  }



  template <int dim>
  void
  DrivenStep<dim>::constrain(const unsigned int stage,
                             const double       tau,
                             const Vector      &heat_load,
                             const Vector      &momentum_load,
                             State             &known)
  {
    const DrivenEnd<dim> &end = body.driven_end;
    if (!temperature_deviations.empty())
      {
        set_shifted(mean_temperature_rate,
                    temperature_deviations[stage],
                    motion.temperature_rate);
        set_values(end.entries(Field::temperature),
                   known.temperature,
                   tau,
                   motion.temperature_rate,
                   motion.temperature);
      }
    if (!velocity_deviations.empty())
      {
        set_shifted(mean_velocity, velocity_deviations[stage], motion.velocity);
        set_shifted(mean_acceleration,
                    acceleration_deviations[stage],
                    motion.acceleration);
        set_values(end.entries(Field::displacement),
                   known.displacement,
                   tau,
                   motion.velocity,
                   motion.displacement);
      }
    heat_load_     = heat_load;
    momentum_load_ = momentum_load;
    end.constrain(motion, known, heat_load_, momentum_load_);
  }



  template <int dim>
  void
  DrivenStep<dim>::complete(StageRates &rates, Vector &acceleration) const
  {
    const DrivenEnd<dim> &end = body.driven_end;
    end.set(Field::temperature,
            motion.temperature_rate,
            rates.temperature_rate);
    end.set(Field::displacement, motion.velocity, rates.velocity);
    end.set(Field::displacement, motion.acceleration, acceleration);
  }



  template class DrivenStep<1>;
  template class DrivenStep<2>;
  template class DrivenStep<3>;
} // namespace ThermoContact
