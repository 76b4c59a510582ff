// SPDX-License-Identifier: LGPL-2.1-or-later

#include <thermocontact/base/exceptions.h>
#include <thermocontact/base/interruption.h>
#include <thermocontact/base/special_numbers.h>
#include <thermocontact/base/text.h>
#include <thermocontact/base/tolerances.h>
#include <thermocontact/scene/coarser_scenes.h>
#include <thermocontact/scene/scene_checks.h>
#include <thermocontact/study/error_bars.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>

namespace ThermoContact
{
  namespace
  {
    /** Where errors hardly fall from mesh to mesh, more is not known. */
    constexpr double largest_factor = 2.;



    /**
     * Differences of the key results of a scene to those of the run: 0 of a
     * result that neither has, NaN if one has it; nothing if it cannot be run.
     */
    using Differences =
      std::function<std::optional<KeyResults>(const CoarserScene &)>;



    /** Beside the key results of a repeat: contacts that it has more. */
    const std::string number_of_contacts = "contact_begins";

    double
    n_contacts(const std::vector<ContactEvent> &events)
    {
      return std::count_if(events.begin(),
                           events.end(),
                           [](const ContactEvent &event) {
                             return event.kind == ContactEvent::begin;
                           });
    }



    KeyResults
    all_unknown()
    {
      KeyResults bars;
      for (const std::string &k : results_with_error_bars())
        bars[k] = nan;
      return bars;
    }



    /**
     * (D9.3) of the differences that there are.
     *
     * @param missed by the largest values of the step ends
     */
    KeyResults
    time_errors(const Parameters  &parameters,
                const KeyResults  &missed,
                const Differences &differences_of)
    {
      KeyResults bars     = all_unknown();
      bool       is_first = true;
      for (const CoarserScene &scene : coarser_in_time(parameters))
        {
          if (const auto differences = differences_of(scene))
            for (auto &[k, bar] : bars)
              {
                // the miss of a coarser one tells nothing; a contact that one
                // of them misses is no error in proportion to anything
                const bool misses_contact =
                  (k == "contact_duration" || k == "first_contact_time") &&
                  differences->at(number_of_contacts) != 0.;
                const double of_scene =
                  (misses_contact ? std::max(1., scene.weight) : scene.weight) *
                  std::abs(differences->at(k));
                if (is_first || of_scene > bar)
                  bar = of_scene;
              }
          is_first = false;
        }
      for (auto &[k, bar] : bars)
        if (missed.at(k) > bar)
          bar = missed.at(k);
      return bars;
    }



    /**
     * The factor by which the error of a result falls from mesh to mesh, from
     * its differences to the run.
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
      for (const std::string &k : results_with_error_bars())
        if (std::abs(near.at(k)) > 2. * time.at(k) && std::abs(far.at(k)) > 0.)
          largest = std::max(largest, rate(near.at(k), far.at(k), smallest));
      return largest;
    }



    /** A linear obstacle that the scheme without dispersion does not resolve.
     */
    bool
    is_hard(const Scene &scene)
    {
      const auto compliance = scene.contact.compliance();
      return compliance &&
             2. * *compliance * std::sqrt(scene.material.inertia) <
               *scene.parameters.time.step_size;
    }



    /** True if the first contact begins where nothing was apart: at the start
     * of the step in which a front arrives, wherever in it that is. */
    bool
    begins_without_gap(const Scene &scene, const RunHistory &history)
    {
      if (history.events.empty())
        return false;
      const ContactEvent &first    = history.events.front();
      const auto         &contacts = scene.row.contacts;
      const double        gap      = first.contact < contacts.size() ?
                                       contacts[first.contact].gap :
                                       scene.parameters.contact.gap;
      return gap == 0. && first.time > 0.;
    }



    /**
     * Errors of the scheme without dispersion that meshes may all have alike,
     * (D9.5), since steps of all of them end at the same times: a front
     * hides what the force does beside it, as it did before or does behind, and
     * when contact begins without a gap, and it overshoots where short waves
     * stay behind; a rigid obstacle lets go at the end of a step, half of one
     * early or late, and a hard one in the time in which it gives way.
     */
    KeyResults
    errors_within_steps(const Scene &scene, const RunHistory &history)
    {
      KeyResults   errors;
      const double overshoot = overshoot_of_fronts(scene, history);
      errors["max_contact_force"] =
        Tolerances::steps_of_front * history.largest_force().change_beside() +
        overshoot * history.max_contact_force;
      errors["max_penetration"] =
        Tolerances::steps_of_front *
          history.largest_penetration().change_beside() +
        overshoot * history.max_penetration;
      const double step      = *scene.parameters.time.step_size;
      const double impedance = std::sqrt(scene.material.inertia);
      if (begins_without_gap(scene, history))
        errors["first_contact_time"] = errors["contact_duration"] = step;
      if (!is_hard(scene) && !scene.contact.has_rigid())
        return errors;
      const double n = std::count_if(history.events.begin(),
                                     history.events.end(),
                                     [](const ContactEvent &event) {
                                       return event.kind == ContactEvent::end;
                                     });
      const double time =
        n * (is_hard(scene) ? *scene.contact.compliance() * impedance : step);
      errors["contact_duration"] += time;
      errors["contact_impulse"] = time * history.max_contact_force;
      if (is_hard(scene))
        errors["final_displacement_end"] =
          time * history.max_contact_force / impedance;
      return errors;
    }



    /**
     * True if contact begins or ends twice at a hard obstacle while this gives
     * way: the force there is not that of one front.
     */
    bool
    has_overlapping_events(const Scene &scene, const RunHistory &history)
    {
      const double time =
        *scene.contact.compliance() * std::sqrt(scene.material.inertia);
      std::map<unsigned int, double> last; // of each contact
      for (const ContactEvent &event : history.events)
        {
          const auto [before, is_first] =
            last.try_emplace(event.contact, event.time);
          if (!is_first && event.time - before->second < time)
            return true;
          before->second = event.time;
        }
      return false;
    }



    /**
     * (D9.5): steps and cells are coarser together, and errors of first order
     * or more.
     *
     * @param values key results, for their rounding
     * @param missed as for time_errors()
     * @param least errors that no mesh shows
     */
    KeyResults
    joined_errors(const KeyResults &values,
                  const KeyResults &least,
                  const KeyResults &missed,
                  const KeyResults &near,
                  const KeyResults &far)
    {
      KeyResults bars = all_unknown();
      for (auto &[k, bar] : bars)
        {
          bar                 = std::abs(near.at(k));
          const auto of_steps = least.find(k);
          for (const double other :
               {std::abs(far.at(k)) / 3.,
                of_steps == least.end() ? 0. : of_steps->second,
                missed.at(k),
                Tolerances::rounding_of_fronts * std::abs(values.at(k))})
            if (other > bar)
              bar = other;
        }
      return bars;
    }



    /** A bar of a restitution, which without drives is 1 at most. */
    bool
    exceeds_range(const double bar, const double restitution)
    {
      return bar > std::max(1., std::abs(restitution));
    }



    /** (D9.4) of the differences that there are. */
    KeyResults
    space_errors(const Parameters  &parameters,
                 const KeyResults  &values,
                 const KeyResults  &least,
                 const KeyResults  &missed,
                 const KeyResults  &time,
                 const Differences &differences_of)
    {
      KeyResults bars = all_unknown();
      if (parameters.has_masses_alone() && !coarser_in_time(parameters).empty())
        for (auto &[k, bar] : bars)
          bar = 0.;
      const auto scenes = coarser_in_space(parameters);
      if (scenes.empty())
        return bars;
      const auto near = differences_of(scenes[0]);
      if (!near)
        return bars;
      KeyResults far = bars;
      if (scenes.size() > 1)
        far = differences_of(scenes[1]).value_or(far);
      if (scenes[0].has_coarser_steps)
        return joined_errors(values, least, missed, *near, far);
      const double smallest = scenes[0].smallest_rate;
      const double largest  = largest_rate(*near, far, time, smallest);
      for (auto &[k, bar] : bars)
        {
          const double own    = rate(near->at(k), far.at(k), smallest);
          const double common = std::max(own, std::sqrt(own * largest));
          // the rest of a geometric sequence of differences
          const double factor =
            common < 1. ? common / (1. - common) : largest_factor;
          bar = std::min(factor, largest_factor) * std::abs(near->at(k));
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
    const Scene      &scene  = simulation.scene();
    const KeyResults  values = key_results(scene, simulation.history());
    const KeyResults  smooth = smooth_key_results(scene, simulation.history());
    const MPI_Comm    communicator = simulation.discretization().communicator();
    KeyErrors         errors;
    const Differences differences =
      [&](const CoarserScene &coarser) -> std::optional<KeyResults> {
      ++errors.n_repeats;
      log.live_line(text(
        "  error bars: repeat ", errors.n_repeats, " with ", coarser.words));
      try
        {
          const Scene its_scene(coarser.parameters);
          check_scene(its_scene);
          Simulation<dim> repeat(its_scene, communicator);
          repeat.run({[&](const Simulation<dim> &) { look_up(); }});
          KeyResults result =
            smooth_key_results(repeat.scene(), repeat.history());
          for (auto &[k, value] : result)
            value = std::isnan(smooth.at(k)) && std::isnan(value) ?
                      0. :
                      value - smooth.at(k);
          result[number_of_contacts] =
            n_contacts(repeat.events()) - n_contacts(simulation.events());
          return result;
        }
      catch (const Interruption &)
        {
          throw;
        }
      catch (const std::runtime_error &error)
        {
          const std::string reason = error.what();
          errors.remarks.push_back(
            "error bars: the repeat with " + coarser.words +
            " fails: " + reason.substr(0, reason.find('\n')));
          return {};
        }
    };

    KeyResults missed;
    for (const auto &[k, value] : values)
      missed[k] = smooth.at(k) - value;
    errors.time = time_errors(scene.parameters, missed, differences);
    errors.space =
      space_errors(scene.parameters,
                   values,
                   scene.scheme.has_no_dispersion ?
                     errors_within_steps(scene, simulation.history()) :
                     KeyResults(),
                   missed,
                   errors.time,
                   differences);
    if (const std::string reason = reason_for_no_repeats(scene.parameters);
        !reason.empty())
      errors.remarks.push_back("error bars: none, since " + reason);
    const bool is_unresolved = scene.scheme.has_no_dispersion && is_hard(scene);
    const bool has_largest_force =
      // a warning of the run says why
      !is_largest_force_of_mesh(scene, simulation.events()) &&
      !(is_unresolved && has_overlapping_events(scene, simulation.history()));
    for (const std::string &k : results_with_error_bars())
      if (std::isnan(values.at(k)) ||
          (!has_largest_force &&
           (k == "max_contact_force" || k == "max_penetration")) ||
          // the boundary layer of a release has no order on equal cells, a hard
          // obstacle is left within a step; in repeats an impact with next to
          // no velocity tells nothing
          (k == "restitution" &&
           (is_unresolved ||
            (scene.scheme.has_no_dispersion &&
             scene.material.has_viscosity()) ||
            exceeds_range(errors.time[k], values.at(k)) ||
            exceeds_range(errors.space[k], values.at(k)))))
        errors.time[k] = errors.space[k] = nan;
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
