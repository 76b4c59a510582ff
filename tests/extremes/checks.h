// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef thermocontact_extremes_checks_h
#define thermocontact_extremes_checks_h

#include <thermocontact/simulation/simulation.h>
#include <thermocontact/space/node_laws.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

#include "../tests.h"

#include "energy_rounding.h"
#include "law_checks.h"

namespace ThermoContact
{
  /** Thrown by the observer where a run has been followed long enough. */
  struct EnoughSteps
  {};



  /** Follows one run and notes what must not happen. */
  template <int dim>
  class StepChecks
  {
  public:
    explicit StepChecks(const unsigned int max_steps)
      : max_steps(max_steps)
    {}

    /** Kind of failure and how large it is at worst. */
    std::map<std::string, double> failures;
    Scales                        scales;
    bool                          has_contact = false;
    double                        growth      = 0.; ///< of the energy

    /**
     * Of a pressure: below the smallest normal number it has fewer digits than
     * others, or none, and powers of two make others. So has one of the elastic
     * law.
     */
    bool has_underflow = false;

    void
    observe(const Simulation<dim> &simulation)
    {
      const StepRecord &record = simulation.record();
      check_finite(simulation);
      add_to_scales(simulation);
      check_contact(simulation);
      for (const auto &[what, value] : misses_of_laws(simulation, scales))
        require_below(what, value, 1.);
      step_rounding = rounding_of_energy(simulation);
      if (record.step == 0)
        first = record;
      else
        {
          check_energy(simulation);
          check_audit(simulation);
        }
      last          = record;
      n_last_events = simulation.events().size();
      if (record.step >= max_steps)
        throw EnoughSteps();
    }

  private:
    const unsigned int  max_steps;
    StepRecord          first, last;
    EnergyRounding<dim> rounding_of_energy;
    double              step_rounding = 0.; ///< of the energy
    double              rounding      = 0.; ///< of the steps so far
    std::size_t         n_last_events = 0;
    bool                had_new_event = false; ///< in the step before

    /** Times 1e-100 it is below the smallest normal number. */
    static constexpr double smallest_to_be_scaled = 1e-207;

    /** Notes @p what if @p value is beyond @p bound or not a number. */
    void
    require_below(const std::string &what,
                  const double       value,
                  const double       bound)
    {
      if (!(value <= bound))
        raise(failures[what], bound > 0. ? value / bound : value);
    }

    void
    check_finite(const Simulation<dim> &simulation)
    {
      StepRecord   record = simulation.record();
      const Scene &scene  = simulation.scene();
      // what the scene does not have is nan
      if (!scene.contact.law->is_active())
        record.gap = 0.;
      if (!scene.fields.has_displacement)
        record.displacement_end = record.displacement_mid =
          record.velocity_end = record.stress_end = record.penetration =
            record.contact_force = record.contact_impulse = 0.;
      if (!scene.fields.has_temperature)
        record.temperature_end = record.temperature_mean =
          record.heat_flux_end = 0.;
      if (scene.material.is_static() && simulation.state().was_moved_at_once())
        record.velocity_end = 0.;
      for (const double value : all_columns(record))
        if (!std::isfinite(value))
          raise(failures["not finite"], 1.);
    }

    void
    add_to_scales(const Simulation<dim> &simulation)
    {
      const StepRecord &r = simulation.record();
      const State      &s = simulation.state();
      if (simulation.scene().fields.has_displacement)
        {
          raise(scales.displacement, s.displacement.linfty_norm());
          raise(scales.velocity, s.velocity.linfty_norm());
          for (const double gap : s.gap)
            raise(scales.gap, std::abs(gap));
          raise(scales.force, std::abs(r.contact_force));
        }
      if (simulation.scene().fields.has_temperature)
        raise(scales.temperature, s.temperature.linfty_norm());
      raise(scales.energy, r.energy_terms.magnitude());
      raise(scales.mechanical_energy,
            std::max(r.energy_terms.kinetic, r.energy_terms.elastic));
      raise(scales.energy, std::abs(r.work));
      raise(scales.energy, r.dissipation + std::abs(r.contact_dissipation));
      raise(scales.energy, std::abs(r.numerical_dissipation));
      has_contact |= r.in_contact;
    }

    /** Complementarity at every contact node, relative to what is added. */
    void
    check_contact(const Simulation<dim> &simulation)
    {
      const ContactLaw &law = simulation.body().law();
      if (!law.is_active())
        return;
      const State         &state = simulation.state();
      std::vector<NodeLaw> laws;
      std::vector<double>  position;
      get_node_laws(simulation.body(), state, laws, position);
      const SceneContact &contact = simulation.scene().contact;
      const double rear_gap = contact.is_two_sided() ? contact.rear_gap : 0.;
      const TimeParameters &time = simulation.parameters().time;
      // one of several nodes may end an event of a rigid obstacle beyond it
      const double miss =
        dim > 1 && law.is_rigid() && time.locates_contact_events() ?
          0.01 * event_tolerance(time) * scales.displacement :
          0.;
      for (unsigned int i = 0; i < laws.size(); ++i)
        {
          const double p    = laws[i].side * state.contact_pressure[i];
          const double near = laws[i].penetration(position[i]);
          require_below("pressure < 0", -p, 0.);
          const bool is_underflow =
            near > 0. && !law.is_rigid() &&
            law.pressure(near) < std::numeric_limits<double>::min();
          has_underflow |=
            is_underflow || (p > 0. && p < smallest_to_be_scaled);
          if (is_underflow || law.damping() > 0.)
            continue; // misses_of_laws()
          const double s = law.penetration(p) - near;
          // the static displacement without contact exceeds the gap by p;
          // within the step the node may have gone some way and back
          const double way   = scales.velocity * simulation.record().step_size;
          const double scale = std::max(
            {scales.displacement,
             way,
             p,
             p > 0. ? std::max(std::abs(state.gap[i]), rear_gap) : 0.});
          const double rounding =
            1e-12 * scale * flatness(simulation.parameters());
          require_below("gap + eps p < 0", -s, miss + rounding);
          if (p > 0.)
            require_below("p (gap + eps p) > 0", s, rounding);
        }
    }

    /**
     * Without loads the energy must change by the physical dissipation alone:
     * energy conserving; and must not grow: backward Euler by (D4.1), the
     * others, all of them A-stable, where the step is linear, that is, where no
     * stage asked whether the obstacle pushes, or what its law is. An event
     * that is missed by s changes the obstacle's energy by s^2/(2 eps): less
     * than the tolerance; and that of a body that follows an obstacle from
     * where it was to where it touches, within rounding of the gaps, by s^2/2.
     */
    void
    check_energy(const Simulation<dim> &simulation)
    {
      const StepRecord     &record = simulation.record();
      const TimeParameters &time   = simulation.parameters().time;
      if (record.step == 1 && simulation.scene().has_prescribed_start)
        return;
      const double magnitude     = std::max(record.energy_terms.magnitude(),
                                        last.energy_terms.magnitude());
      const bool   has_new_event = simulation.events().size() != n_last_events;
      const bool   is_near_event = has_new_event || had_new_event;
      had_new_event              = has_new_event;

      const double increase =
        record.energy - last.energy - (record.work - last.work);
      const double allowance =
        1e-12 * magnitude + 1e-13 * std::abs(record.work) + step_rounding;
      if (increase > allowance)
        raise(growth, increase / scales.energy);

      const SceneSources &sources       = simulation.scene().sources;
      const bool          is_conserving = time.scheme == "energy conserving";
      if (is_conserving && !simulation.scene().has_work())
        require_below("energy grows", increase, allowance);
      if (is_conserving && record.work == 0. &&
          !(sources.has_body_force || sources.has_end_traction) &&
          !may_take_energy(simulation.scene()))
        require_below("energy is not conserved",
                      std::abs(record.numerical_dissipation -
                               last.numerical_dissipation),
                      allowance);
      else if (time.scheme == "backward euler" &&
               !time.locates_contact_events())
        require_below("energy grows", increase, allowance);
      else if (!is_linear(simulation))
        return;
      else if (record.iterations == 0 && record.work == 0. && !is_near_event)
        require_below("energy grows in a linear step", increase, allowance);
      else if (record.iterations == 0 && record.work == 0.)
        require_below("energy grows at an event",
                      increase,
                      allowance +
                        event_tolerance(time) * scales.mechanical_energy +
                        0.5 * std::pow(1e-12 * scales.gap, 2));
    }

    /** The box scheme on an obstacle that is stiffer than its cells, (C6.9). */
    static bool
    may_take_energy(const Scene &scene)
    {
      return scene.has_midpoint_mass && scene.contact.law->is_active() &&
             (scene.contact.law->is_rigid() ||
              scene.parameters.contact.compliance <
                0.5 * scene.parameters.mesh.contact_spacing());
    }

    /** What the last step computed is linear if contact stays as it is. */
    bool
    is_linear(const Simulation<dim> &simulation) const
    {
      const Scene      &scene = simulation.scene();
      const ContactLaw &law   = *scene.contact.law;
      return scene.heat.exchange->is_constant() &&
             ((law.is_linear() && law.damping() == 0.) ||
              !(simulation.record().in_contact || last.in_contact));
    }

    /** Of the error control, or rounding. */
    static double
    event_tolerance(const TimeParameters &time)
    {
      return time.has_error_control() ? time.tolerance : 1e-13;
    }

    void
    check_audit(const Simulation<dim> &simulation)
    {
      const StepRecord &record = simulation.record();
      const double      defect = first.energy + record.work + record.algebraic -
                            record.energy - record.dissipation -
                            record.contact_dissipation -
                            record.numerical_dissipation;
      rounding += step_rounding;
      require_below("audit open",
                    std::abs(defect),
                    1e-11 * scales.energy + rounding);
      if (simulation.parameters().time.scheme != "backward euler")
        return; // others weigh stages, some with negative weights
      const auto require_growth = [&](const std::string &what,
                                      const double       value) {
        require_below(what + " falls", -value, 1e-13 * scales.energy);
      };
      require_growth("dissipation", record.dissipation - last.dissipation);
      require_growth("dissipation of the obstacle",
                     record.contact_dissipation - last.contact_dissipation);
      require_growth("dissipation along the rod",
                     record.lateral_dissipation - last.lateral_dissipation);
    }
  };



  /** Begin and end take turns, at times that do not decrease. */
  inline bool
  are_in_order(const std::vector<ContactEvent> &events)
  {
    double last = 0.;
    for (unsigned int i = 0; i < events.size(); ++i)
      {
        if ((events[i].kind == ContactEvent::begin) != (i % 2 == 0) ||
            !(events[i].time >= last))
          return false;
        last = events[i].time;
      }
    return true;
  }
} // namespace ThermoContact

#endif
