// SPDX-License-Identifier: LGPL-2.1-or-later

#include <thermocontact/base/tolerances.h>
#include <thermocontact/time/prescribed_motion.h>

#include <cmath>

namespace ThermoContact
{
  namespace
  {
    /**
     * Shifts rates of scalar @p k in all stages such that their mean leads from
     * @p old_value to @p new_value, unless they do but for @p rounding.
     */
    void
    shift(std::vector<PrescribedStage> &stages,
          std::vector<double> PrescribedStage::*rates,
          const std::vector<double>            &weights,
          const unsigned int                    k,
          const double                          size,
          const double                          change,
          const double                          rounding)
    {
      double mean = 0.;
      for (unsigned int i = 0; i < stages.size(); ++i)
        mean += weights[i] * (stages[i].*rates)[k];
      if (std::abs(change - size * mean) > rounding)
        for (PrescribedStage &stage : stages)
          (stage.*rates)[k] += change / size - mean;
    }
  } // namespace



  void
  PrescribedMotion::start(
    const StageTimes                                          &times,
    const double                                               step_size,
    const std::vector<double>                                 &old_values,
    const bool                                                 has_inertia,
    const std::function<std::vector<TimeDerivatives>(double)> &functions_at)
  {
    const unsigned int n = old_values.size(), n_stages = times.times.size();
    std::vector<TimeDerivatives> functions; // at last of the end
    size    = step_size;
    weights = times.weights;
    stages_.resize(n_stages);
    for (unsigned int i = 0; i < n_stages; ++i)
      {
        PrescribedStage &stage = stages_[i];
        functions              = functions_at(times.times[i]);
        stage.values           = old_values;
        stage.rates.resize(n);
        stage.accelerations.resize(n);
        for (unsigned int k = 0; k < n; ++k)
          {
            stage.rates[k]         = functions[k].first;
            stage.accelerations[k] = functions[k].second;
          }
      }
    const bool ends_with_last_stage = times.a.back() == weights;
    for (unsigned int k = 0; k < n; ++k)
      {
        const double value = functions[k].value;
        if (has_inertia && ends_with_last_stage)
          integrate_accelerations(times, k);
        shift(stages_,
              &PrescribedStage::rates,
              weights,
              k,
              size,
              value - old_values[k],
              Tolerances::rounding *
                (std::abs(value) + std::abs(old_values[k])));
        for (unsigned int i = 0; i < n_stages; ++i)
          for (unsigned int j = 0; j <= i; ++j)
            stages_[i].values[k] += size * times.a[i][j] * stages_[j].rates[k];
        if (ends_with_last_stage)
          stages_.back().values[k] = value;
      }
  }



  void
  PrescribedMotion::integrate_accelerations(const StageTimes  &times,
                                            const unsigned int k)
  {
    const double rate_at_end = stages_.back().rates[k];
    for (unsigned int i = 0; i < stages_.size(); ++i)
      {
        double rest = 0.; // from the stage to the end
        for (unsigned int j = 0; j < stages_.size(); ++j)
          rest += (weights[j] - (j <= i ? times.a[i][j] : 0.)) *
                  stages_[j].accelerations[k];
        if (const double rate = rate_at_end - size * rest; std::isfinite(rate))
          stages_[i].rates[k] = rate;
      }
  }



  void
  PrescribedMotion::set_accelerations(const std::vector<double> &old_rates,
                                      const std::vector<double> &new_rates)
  {
    for (unsigned int k = 0; k < old_rates.size(); ++k)
      shift(stages_,
            &PrescribedStage::accelerations,
            weights,
            k,
            size,
            new_rates[k] - old_rates[k],
            0.);
  }
} // namespace ThermoContact
