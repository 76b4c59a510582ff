// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef thermocontact_time_box_integrator_h
#define thermocontact_time_box_integrator_h

#include <thermocontact/contact/mass_impact.h>
#include <thermocontact/contact/step_contact.h>
#include <thermocontact/time/box_solver.h>
#include <thermocontact/time/contact_side.h>
#include <thermocontact/time/time_integrator.h>

#include <algorithm>
#include <array>
#include <optional>
#include <vector>

namespace ThermoContact
{
  /**
   * The scheme without dispersion, doc/contact-in-time.md section 6: the
   * midpoint rule on equal linear cells whose mass is taken at their midpoints,
   * in steps in which a wave passes one of them, with heat by an L-stable rule
   * in the same linear system. The contact nodes keep their mass.
   *
   * The velocity of a state is that of the cells, in their middles; its nodal
   * values are those with which the contact end has its own velocity, (C6.13),
   * of a rod between two contacts its right end.
   */
  class BoxIntegrator : public TimeIntegrator
  {
  public:
    /** @param body borrowed */
    explicit BoxIntegrator(Body<1> &body);

    void
    step(const State      &state,
         const TimeStep   &time_step,
         const ContactMode mode,
         StepResult       &result) override;

    StageSolver &
    stage_solver() override
    {
      return solver;
    }

  private:
    Body<1>           &body;
    BoxSolver          solver;
    const unsigned int n_heat_stages; ///< 0: there is no heat

    /** Where bodies meet each other, or the obstacle. */
    struct Contact
    {
      std::vector<ContactSide> sides;
      std::vector<double>      impedances; ///< of the sides, in this step

      /** $1/\chi$ of the rods, of viscous ones that of waves; infinite between
       * masses. */
      double impedance;

      bool
      is_of_masses() const
      {
        return std::all_of(sides.begin(),
                           sides.end(),
                           [](const ContactSide &side) {
                             return side.is_mass();
                           });
      }

      /** Waves pass all rods at the contact, of which there is at least one. */
      bool
      has_rods_with_waves() const;

      /** The rods pass on waves, which viscosity does not smooth. */
      bool
      has_waves() const;

      /** Sum of a function over the sides. */
      template <typename OfSide>
      double
      sum(const OfSide &of_side) const;

      /** Velocity into the contact without pressure of one of its sides, where
       * what is in a cell arrives. */
      double
      arriving(const unsigned int side, const CellValues &cell) const;
    };

    std::vector<Contact> contacts;

    BoxRates rates, right;

    /** Known values, with what the fixed end does. */
    Vector known_velocity, known_displacement, known_temperature;

    std::array<Vector, HeatStages::n> heat_load;
    Vector                            momentum_load; ///< mean of the step
    Vector                            stage_momentum_load;

    std::array<double, HeatStages::n> heat_times; ///< of the stages

    /** The loads of the stages are means over these times; without heat the
     * first one is that of the step. */
    std::array<MeanOfTimes, HeatStages::n> load_times;

    TimeStep present; ///< the step

    /** The rates of the fixed end by its drive. */
    std::array<double, HeatStages::n> end_heating;
    double                            end_velocity = 0.;
    Vector                            heat_lift, heat_scratch, momentum_lift;

    Vector velocity_change, viscous_part; ///< of a viscous rod

    State  stage;    ///< in which a step does its work
    State  obstacle; ///< gaps alone, at the end of the step
    Vector acceleration;

    /** The values of a step for contact: at the end node, unless others are
     * named. */
    struct EndValues
    {
      double velocity   = 0.; ///< $w$
      double inner      = 0.; ///< $w$ of its neighbour
      double old_middle = 0.; ///< known velocity of the last cell

      /** $\theta-\theta_{obs}$ at the stages, or the difference of two bodies.
       */
      std::array<double, HeatStages::n> temperature{};
    };

    /**
     * A single front that reaches the end in contact within the step and takes
     * it from the obstacle, (C6.14). Velocities are those into the obstacle
     * that the end would have without it.
     */
    struct Release
    {
      int    side;   ///< of the obstacle: 1 in front, -1 behind
      double part;   ///< of the step, before the front
      double before; ///< velocity that the obstacle stops
      double after;  ///< with which the end leaves, negative
    };

    /** The release in this step and in the next one, if there are any. */
    struct Releases
    {
      std::optional<Release> now, next;

      /** What loads add to the velocity that waves bring to the end. */
      double change = 0.;
    };

    /** Pressure, heat exchange and what follows at the end of the step. */
    struct EndContact
    {
      StepContact                       contact;
      std::array<double, HeatStages::n> flux{};
      std::array<double, HeatStages::n> coefficient{}; ///< k at the stages
      double                            end_coefficient = 0.; ///< k at $t^1$
      double                            end_pressure    = 0.; ///< $p^1$
      double                            end_velocity    = 0.; ///< $v(1,t^1)$
      double free_velocity = 0.; ///< $w$ without pressure
      double end_excess    = 0.; ///< $\theta-\theta_{obs}$ at $t^1$

      /** $p^1$ of a rigid obstacle that may pull. */
      double stopping = 0.;

      /** Of rigid masses, (M10.6). */
      std::optional<MassImpacts> masses;

      Releases releases;
    };

    /**
     * The times of the loads of a step. Between breaks within it the rule of
     * the step is applied to each piece; their sum, weighted by lengths, is the
     * mean of the momentum loads and of the heat.
     */
    void
    set_load_times(const TimeStep &time_step);

    /** Loads and motions of a step. */
    void
    set_loads(const State &state, const TimeStep &time_step);

    /** The rates without pressure and with the heat flux of a number k. */
    void
    solve_without_contact(const State &state, const double size);

    // of contact c

    EndValues
    end_values(const State       &state,
               const double       size,
               const unsigned int c) const;

    /** The loss of these values by a unit load. */
    EndValues
    end_response(const BoxRates    &response,
                 const double       size,
                 const unsigned int c) const;

    /** The contact node for a coefficient of the heat exchange at $t^1$. */
    EndContact
    contact_for(const unsigned int c,
                const State       &state,
                const double       end_coefficient,
                const EndValues   &free,
                const StepPath    &path,
                const double       size,
                const Releases    &releases);

    /**
     * With the coefficient of its law.
     *
     * @param free without loads at this contact
     */
    EndContact
    find_contact(const unsigned int c,
                 const State       &state,
                 const double       size,
                 const EndValues   &free,
                 const StepPath    &path,
                 const Releases    &releases);

    /**
     * All of them, one after the other until none changes another one, (M10.4).
     *
     * @throw ComputationError if they do not come to rest
     */
    void
    find_contacts(const State             &state,
                  const double             size,
                  std::vector<EndContact> &ends);

    /** Takes the response to a load of a contact node from the rates. */
    void
    add_response(const double load, const BoxRates &response);

    /** Rigid masses that meet follow Newton's law of impact, (M10.6). */
    void
    follow_masses(const unsigned int c,
                  const State       &state,
                  const StepPath    &path,
                  EndContact        &end);

    /** Velocity of a contact at the start of a step. */
    double
    velocity_of(const unsigned int c, const State &state) const;

    /** Velocities that the rounding of waves and displacements makes. */
    double
    rounding_of_velocity(const State &state) const;

    /** Pressure and velocity of the node at the end of the step, (C6.13). */
    void
    finish_node(const unsigned int c,
                const State       &state,
                const EndValues   &values,
                EndContact        &end) const;

    /** Heat exchange at the start of a step, behind a jump of its law there. */
    double
    old_coefficient(const unsigned int c,
                    const State       &state,
                    const StepPath    &path) const;

    /** Mean velocity of the obstacle in one of the steps before, from 1. */
    double
    former_rate(const unsigned int c,
                const State       &state,
                const double       size,
                const unsigned int n_steps);

    StepPath
    path_of_node(const unsigned int c,
                 const State       &state,
                 const double       size) const;

    /** Impedances of a step of this size. */
    void
    set_impedances(const double size);

    /** The state at the end of the step. */
    void
    advance(const State                   &state,
            const TimeStep                &time_step,
            const std::vector<EndContact> &ends,
            State                         &new_state);

    /** Gives the ends of rods at contacts their velocities, (C6.13). */
    void
    set_end_velocities(const State                   &state,
                       const std::vector<EndContact> &ends,
                       State                         &new_state) const;

    /**
     * The velocity at its end, (C6.12): of a viscous rod without what the
     * midpoint rule lets alternate.
     */
    void
    advance_velocity(const double size, const State &state, Vector &velocity);

    /** The values of a side at the end of the step from @p state with the
     * present rates. */
    CellValues
    later_values_in(const ContactSide &side,
                    const State       &state,
                    const double       size,
                    const unsigned int cell) const;

    /** The releases by the waves near the end, with the free rates. */
    Releases
    find_releases(const unsigned int c,
                  const State       &state,
                  const StepPath    &path);

    /** Where in the step the node meets or leaves an obstacle, (C6.14). */
    std::optional<ContactChange>
    contact_change(const unsigned int c,
                   const State       &state,
                   const StepPath    &path,
                   const EndContact  &end,
                   const State       &new_state) const;

    /** Bodies at rest side by side, of which a mass is pushed within the step
     * by a contact on its other side, meet when that one changes and not at the
     * start of the step. */
    void
    begin_with_causes(const State                               &state,
                      std::vector<std::optional<ContactChange>> &changes) const;

    /** Work and dissipation. */
    void
    book(const State                   &state,
         const double                   size,
         const std::vector<EndContact> &ends,
         StepResult                    &result);

    // of the contacts in a step; scratch but for the first
    std::vector<EndContact> ends;
    std::vector<EndValues>  free;
    std::vector<StepPath>   paths;
    std::vector<Releases>   releases;

    std::vector<TimeDerivatives> former_gaps;

    /** Work of the loads on the way of masses by impacts, which the mean
     * velocity does not have. */
    double work_of_impacts = 0.;
  };
} // namespace ThermoContact

#endif
