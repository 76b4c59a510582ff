// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef thermocontact_extremes_checks_h
#define thermocontact_extremes_checks_h

#include <thermocontact/simulation/simulation.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "../tests.h"

namespace ThermoContact
{
  /** Thrown by the observer where a run has been followed long enough. */
  struct EnoughSteps
  {};



  /** Largest magnitudes over a run, that differences are measured by. */
  struct Scales
  {
    double displacement      = 0.;
    double velocity          = 0.;
    double temperature       = 0.;
    double force             = 0.;
    double energy            = 0.; ///< of the absolute terms, work, dissipation
    double mechanical_energy = 0.; ///< kinetic or elastic
  };



  /**
   * What rounding does to the energy in a step. A stage of n unknowns is solved
   * up to residuals of the size of epsilon sqrt(n) |S| U of the momentum and
   * epsilon sqrt(n) |S| Theta of the heat equation, |S| the largest row sum of
   * the stiffness, which is large on fine and graded meshes of high degree, and
   * epsilon k Theta at the end; U, Theta, V largest nodal values. These meet
   * the changes of u and theta, so that the energy of a body that rests at u
   * and theta_s fluctuates. theta itself is stored to epsilon Theta, and in
   * contact u_n = u_free - chi p, with chi < 1.
   */
  template <int dim>
  class EnergyRounding
  {
  public:
    /** For the step to the present state from that of the last call. */
    double
    operator()(const Simulation<dim> &simulation)
    {
      const State       &state     = simulation.state();
      const Scene       &scene     = simulation.scene();
      const auto        &stage     = simulation.body().equations;
      const double       dt        = simulation.record().step_size;
      const auto        &stiffness = stage.field_matrices().stiffness;
      const unsigned int n_fields  = stiffness.n_block_rows();
      const double       unit =
        std::numeric_limits<double>::epsilon() *
        std::sqrt(simulation.discretization().dof_handler().n_dofs()) *
        stiffness.block(n_fields - 1, n_fields - 1).linfty_norm();
      Values values;
      if (scene.fields.has_displacement)
        {
          values.u = state.displacement.linfty_norm();
          values.v = state.velocity.linfty_norm();
        }
      if (scene.fields.has_temperature)
        {
          values.theta = state.temperature.linfty_norm();
          Vector excess(state.temperature);
          excess -= simulation.body().energy.steady_profile();
          values.excess = excess.linfty_norm();
        }
      const double u       = std::max(values.u, last.u);
      const double v       = std::max(values.v, last.v);
      const double theta   = std::max(values.theta, last.theta);
      const double excess  = std::max(values.excess, last.excess);
      last                 = values;
      const double epsilon = std::numeric_limits<double>::epsilon();
      const double p =
        scene.fields.has_displacement ? simulation.record().contact_force : 0.;
      const double k = scene.heat.reference_coefficient;
      return 4. * unit *
               (u * u + std::min(dt, 1.) * theta * excess +
                unit * theta * theta + dt * scene.material.viscosity * v * v) +
             4. * epsilon * theta * excess +
             4. * epsilon * dt * k * theta * end_excess(simulation) +
             4. * epsilon * p * (10. * u + p);
    }

  private:
    struct Values
    {
      double u = 0., v = 0., theta = 0., excess = 0.;
    };

    Values last;

    /** Of the temperature of the end over theta_s. */
    static double
    end_excess(const Simulation<dim> &simulation)
    {
      if (!simulation.scene().fields.has_temperature)
        return 0.;
      const BoundaryParameters &b = simulation.parameters().boundary;
      const double              c = b.heat_exchange / (b.heat_exchange + 1.);
      const double              steady =
        b.fixed_end_temperature -
        c * (b.fixed_end_temperature - b.obstacle_temperature);
      return std::abs(simulation.record().temperature_end - steady);
    }
  };



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

    void
    observe(const Simulation<dim> &simulation)
    {
      const StepRecord &record = simulation.record();
      check_finite(simulation);
      add_to_scales(simulation);
      check_contact(simulation);
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
      if (scene.material.is_static() && record.step == 0)
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
          raise(scales.force, r.contact_force);
        }
      if (simulation.scene().fields.has_temperature)
        raise(scales.temperature, s.temperature.linfty_norm());
      raise(scales.energy, r.energy_terms.magnitude());
      raise(scales.mechanical_energy,
            std::max(r.energy_terms.kinetic, r.energy_terms.elastic));
      raise(scales.energy, std::abs(r.work));
      raise(scales.energy, r.dissipation);
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
      const State        &state = simulation.state();
      const auto         &nodes = simulation.body().contact_end().nodes();
      std::vector<double> penetration;
      simulation.body().contact_end().get_penetrations(state.displacement,
                                                       penetration);
      const TimeParameters &time = simulation.parameters().time;
      // one of several nodes may end an event of a rigid obstacle beyond it
      const double miss =
        dim > 1 && law.is_rigid() && time.locates_contact_events() ?
          0.01 * event_tolerance(time) * scales.displacement :
          0.;
      for (unsigned int i = 0; i < penetration.size(); ++i)
        {
          const double p = state.contact_pressure[i];
          const double s = law.penetration(p) - penetration[i];
          // the static displacement without contact exceeds the gap by p
          const double scale = std::max(
            {scales.displacement, p, p > 0. ? std::abs(nodes[i].gap) : 0.});
          require_below("pressure < 0", -p, 0.);
          require_below("gap + eps p < 0", -s, miss + 1e-12 * scale);
          if (p > 0.)
            require_below("p (gap + eps p) > 0", s, 1e-12 * scale);
        }
    }

    /**
     * Without loads the energy must change by the physical dissipation alone:
     * energy conserving; and must not grow: backward Euler by (M.22), the
     * others, all of them A-stable, where the step is linear, that is, where no
     * stage asked whether the obstacle pushes. An event that is missed by s
     * changes the obstacle's energy by s^2/(2 eps): less than the tolerance.
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

      if (time.scheme == "energy conserving" && record.work == 0.)
        require_below("energy is not conserved",
                      std::abs(record.numerical_dissipation -
                               last.numerical_dissipation),
                      allowance);
      else if (time.scheme == "backward euler" &&
               !time.locates_contact_events())
        require_below("energy grows", increase, allowance);
      else if (record.iterations == 0 && record.work == 0. && !is_near_event)
        require_below("energy grows in a linear step", increase, allowance);
      else if (record.iterations == 0 && record.work == 0.)
        require_below("energy grows at an event",
                      increase,
                      allowance +
                        event_tolerance(time) * scales.mechanical_energy);
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
                            record.numerical_dissipation;
      rounding += step_rounding;
      require_below("audit open",
                    std::abs(defect),
                    1e-11 * scales.energy + rounding);
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
