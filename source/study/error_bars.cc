// SPDX-License-Identifier: LGPL-2.1-or-later

#include <thermocontact/base/exceptions.h>
#include <thermocontact/base/interruption.h>
#include <thermocontact/base/text.h>
#include <thermocontact/scene/coarser_scenes.h>
#include <thermocontact/scene/scene_checks.h>
#include <thermocontact/study/error_bars.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

namespace ThermoContact
{
  namespace
  {
    constexpr double unknown = std::numeric_limits<double>::quiet_NaN();

    /** Where errors hardly fall from mesh to mesh, more is not known. */
    constexpr double largest_factor = 2.;



    /** Makes repeats one after the other, and counts them. */
    template <int dim>
    class Repeats
    {
    public:
      Repeats(const Simulation<dim>       &simulation,
              const std::function<void()> &look_up,
              Log                         &log,
              KeyErrors                   &errors)
        : simulation(simulation)
        , look_up(look_up)
        , log(log)
        , errors(errors)
        , values(smooth_key_results(simulation.scene(), simulation.history()))
      {}

      /**
       * Differences of the key results of a scene to those of the run; nothing
       * if it fails. 0 of what neither has, NaN of what one has.
       */
      std::optional<KeyResults>
      differences(const CoarserScene &scene)
      {
        ++errors.n_repeats;
        log.live_line(text(
          "  error bars: repeat ", errors.n_repeats, " with ", scene.words));
        try
          {
            check_scene(scene.parameters);
            Simulation<dim> repeat(scene.parameters,
                                   simulation.discretization().communicator());
            repeat.run({[this](const Simulation<dim> &) { look_up(); }});
            KeyResults result =
              smooth_key_results(repeat.scene(), repeat.history());
            for (const KeyResult::Name k : results_with_error_bars)
              result[k] = std::isnan(values[k]) && std::isnan(result[k]) ?
                            0. :
                            result[k] - values[k];
            return result;
          }
        catch (const Interruption &)
          {
            throw;
          }
        catch (const InputError &error)
          {
            add_failure(scene, error.what());
          }
        catch (const ComputationError &error)
          {
            add_failure(scene, error.what());
          }
        catch (const std::bad_alloc &)
          {
            // perhaps of this rank alone: the others wait for it
            if (Utilities::MPI::n_mpi_processes(
                  simulation.discretization().communicator()) > 1)
              throw;
            add_failure(scene, "there is not enough memory");
          }
        return {};
      }

    private:
      const Simulation<dim>       &simulation;
      const std::function<void()> &look_up;
      Log                         &log;
      KeyErrors                   &errors;
      const KeyResults             values;

      void
      add_failure(const CoarserScene &scene, const std::string &reason)
      {
        errors.remarks.push_back(text("error bars: the repeat with ",
                                      scene.words,
                                      " fails: ",
                                      reason.substr(0, reason.find('\n'))));
      }
    };



    /** (D9.3) of what differences there are. */
    template <int dim>
    KeyResults
    time_errors(const Simulation<dim> &simulation, Repeats<dim> &repeats)
    {
      KeyResults bars;
      bars.fill(unknown);
      bool is_first = true;
      for (const CoarserScene &scene : coarser_in_time(simulation.parameters()))
        {
          const auto differences = repeats.differences(scene);
          if (differences)
            for (const KeyResult::Name k : results_with_error_bars)
              {
                const double bar = scene.weight * std::abs((*differences)[k]);
                // what a coarser one misses tells nothing
                if (is_first)
                  bars[k] = bar;
                else if (bar > bars[k])
                  bars[k] = bar;
              }
          is_first = false;
        }
      const KeyResults values =
        key_results(simulation.scene(), simulation.history());
      const KeyResults smooth =
        smooth_key_results(simulation.scene(), simulation.history());
      for (const KeyResult::Name k : results_with_error_bars)
        if (const double missed = smooth[k] - values[k]; missed > bars[k])
          bars[k] = missed;
      return bars;
    }



    /**
     * By what the error of a result falls from mesh to mesh, from its
     * differences to the run.
     */
    double
    rate(const double near, const double far, const double smallest)
    {
      const double coarser = std::abs(far - near);
      // a rate only where the coarser mesh is worse
      return coarser > std::abs(near) ?
               std::max(std::abs(near) / coarser, smallest) :
               1.;
    }



    /**
     * The largest rate of the results that differ by more than their errors in
     * time; 0: there is none.
     */
    double
    largest_rate(const KeyResults &near,
                 const KeyResults &far,
                 const KeyResults &time,
                 const double      smallest)
    {
      double largest = 0.;
      for (const KeyResult::Name k : results_with_error_bars)
        if (std::abs(near[k]) > 2. * time[k] && std::abs(far[k]) > 0.)
          largest = std::max(largest, rate(near[k], far[k], smallest));
      return largest;
    }



    /** (D9.4) of what differences there are. */
    template <int dim>
    KeyResults
    space_errors(const Simulation<dim> &simulation,
                 const KeyResults      &time,
                 Repeats<dim>          &repeats)
    {
      KeyResults bars;
      bars.fill(unknown);
      const auto scenes = coarser_in_space(simulation.parameters());
      if (scenes.empty())
        return bars;
      const auto near = repeats.differences(scenes[0]);
      if (!near)
        return bars;
      KeyResults far = bars;
      if (scenes.size() > 1)
        far = repeats.differences(scenes[1]).value_or(far);
      const double smallest = scenes[0].smallest_rate;
      const double largest  = largest_rate(*near, far, time, smallest);
      for (const KeyResult::Name k : results_with_error_bars)
        {
          const double own    = rate((*near)[k], far[k], smallest);
          const double common = std::max(own, std::sqrt(own * largest));
          // what follows a geometric sequence of differences
          const double factor =
            common < 1. ? common / (1. - common) : largest_factor;
          bars[k] = std::min(factor, largest_factor) * std::abs((*near)[k]);
        }
      return bars;
    }
  } // namespace



  template <int dim>
  KeyErrors
  error_bars(const Simulation<dim>       &simulation,
             const std::function<void()> &look_up,
             Log                         &log)
  {
    KeyErrors    errors;
    Repeats<dim> repeats(simulation, look_up, log, errors);
    errors.time  = time_errors(simulation, repeats);
    errors.space = space_errors(simulation, errors.time, repeats);
    const KeyResults values =
      key_results(simulation.scene(), simulation.history());
    const bool has_largest_force =
      !is_largest_force_of_mesh(simulation.scene(), simulation.events());
    for (const KeyResult::Name k : results_with_error_bars)
      if (std::isnan(values[k]) ||
          (k == KeyResult::max_contact_force && !has_largest_force))
        errors.time[k] = errors.space[k] = unknown;
    if (!has_largest_force)
      errors.remarks.push_back(
        "error bars: none of the largest force, which is that of the mesh: the "
        "force of a viscous body behind an impact grows as cells get smaller, "
        "as far as the obstacle gives way");
    return errors;
  }



#define INSTANTIATE(dim)                                       \
  template KeyErrors error_bars(const Simulation<dim> &,       \
                                const std::function<void()> &, \
                                Log &)

  INSTANTIATE(1);
  INSTANTIATE(2);
  INSTANTIATE(3);

#undef INSTANTIATE
} // namespace ThermoContact
