// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef thermocontact_time_dirk_integrator_h
#define thermocontact_time_dirk_integrator_h

#include <thermocontact/base/local_sums.h>
#include <thermocontact/method/butcher_tableau.h>
#include <thermocontact/time/driven_step.h>
#include <thermocontact/time/newton_stage.h>
#include <thermocontact/time/time_integrator.h>

#include <vector>

namespace ThermoContact
{
  /**
   * One step of a stiffly accurate SDIRK scheme, and the paper's first step.
   *
   * Stage i of a step by $\Delta t$ starts from the known values
   * $\tilde\theta=\theta^n+\Delta t\sum_{j<i}a_{ij}\theta'_j$ and likewise
   * $\tilde u$, $\tilde v$, and has length $\tau=a_{ii}\Delta t$; the last
   * stage is the new state. Backward Euler, one stage that starts from the old
   * state, is the scheme (3.1), (3.2) of the paper.
   *
   * Work, dissipation and impulse are sums over the stages with the weights of
   * the scheme. The numerical dissipation of backward Euler has its own formula
   * (D4.3); in other schemes it is the rest of the balance, has no sign, and
   * vanishes with the order of the scheme.
   */
  template <int dim>
  class DirkIntegrator : public TimeIntegrator
  {
  public:
    /** @param body borrowed; its scheme names the tableau */
    explicit DirkIntegrator(Body<dim> &body);

    /** Through the stages, (D3.1), (D3.2), with the estimate (D3.3). */
    void
    step(const State      &state,
         const TimeStep   &time_step,
         const ContactMode mode,
         StepResult       &result) override;

    void
    prescribed_step(const State    &state,
                    const TimeStep &time_step,
                    StepResult     &result) override;

    StageSolver &
    stage_solver() override
    {
      return newton ? newton->solver() : *solver;
    }

  private:
    Body<dim>            &body;
    const ButcherTableau &of_scheme;

    /** Its own, or one whose abscissae are in the order of time. */
    const ButcherTableau &in_order;

    const ButcherTableau *tableau = nullptr; ///< of the present step

    /** One of the two is there. */
    const std::unique_ptr<StageSolver>      solver;
    const std::unique_ptr<NewtonStage<dim>> newton;

    DrivenStep<dim>  driven; ///< of a fixed end that is heated or moved
    PrescribedMotion gaps;   ///< of an obstacle that moves

    std::vector<StageRates> stages;
    State                   known;
    State                   difference; ///< of schemes with an error estimate
    Vector                  heat_load;
    Vector                  momentum_load;

    std::vector<Multiple> sum; ///< of rates

    /** Starts the motions of the ends of the body in a step from @p state. */
    void
    start_drives(const State &state, const TimeStep &time_step);

    /** The gaps of a step before an obstacle that moves, (C8.1), (C8.2). */
    void
    start_obstacle(const State      &state,
                   const TimeStep   &time_step,
                   const StageTimes &loads_at);

    /**
     * The obstacle of stage @p i where it is at the end of the stage. Nodes
     * with mass that a rigid one holds move with it: their known velocities are
     * those from which they reach its velocity with its acceleration.
     */
    void
    place_obstacle(const unsigned int i,
                   const double       tau,
                   const ContactMode  mode);

    /** The known values of stage @p i of a step by @p step_size. */
    void
    set_known_values(const State       &state,
                     const double       step_size,
                     const unsigned int i);

    /**
     * True if the velocity or the position of a contact node can change at once
     * within a step: it has no mass, and the law decides in every stage or
     * equilibrium at all times.
     */
    bool
    can_change_at_once(const ContactMode mode) const;

    /** True if a stage of the step has contact pressure. */
    bool
    pushes() const;

    /**
     * Through the stages of the present tableau; @p result gets their sums and
     * the failure of one.
     */
    void
    solve_stages(const State      &state,
                 const TimeStep   &time_step,
                 const ContactMode mode,
                 StepResult       &result);

    /** True if some nodes are in contact and some are not. */
    bool
    is_partial(const State &state) const;

    /**
     * True if nodes are in contact in a stage that were open before the step.
     * Where they are viscous such a step, and one from partial contact, whose
     * nodes close and open one after another, is taken with stages in the order
     * of time: else a node that has closed would be open in a later stage that
     * is earlier, and the step would end short of the obstacle.
     */
    bool
    closes_nodes(const State &state) const;

    /**
     * Closed nodes between two obstacles stay at the one where @p state has them:
     * the known values of a stage, and its end, may be nearer to the other one.
     */
    void
    choose_stops(const State &state, const ContactMode mode);

    /** The nodes in contact at the end of the step. */
    std::vector<bool>
    closed_at_end(const ContactMode mode) const;

    /** Sets StepResult::closed_nodes of a step from @p state. */
    void
    find_closed_nodes(const State      &state,
                      const ContactMode mode,
                      StepResult       &result) const;

    /**
     * Takes out of the difference to the embedded scheme what the contact
     * condition forbids, doc/contact-in-time.md (C3.2): nodes in contact at the
     * end of the step, where they have these pressures, stay with the obstacle.
     */
    void
    keep_contact(const ContactMode mode, const std::vector<double> &pressure);

    /** The difference to the embedded scheme, (D3.3), (C3.2). */
    void
    estimate_error(const double      step_size,
                   const ContactMode mode,
                   StepResult       &result);

    /** The time whose loads stage @p i takes. */
    double
    load_time(const State       &state,
              const TimeStep    &time_step,
              const unsigned int i) const;

    /**
     * Solves stage @p i of length @p tau from its known values, with the loads
     * that have been assembled: its rates and, if something needs it, its
     * acceleration.
     */
    void
    solve_stage(const unsigned int i, const double tau, const ContactMode mode);

    /** The known values go to the end of stage @p i. */
    void
    advance(const unsigned int i, const double tau);

    /** The temperature rate of the paper's first step. */
    void
    solve_heat_alone(const State &state, const double tau, Vector &rate);
  };
} // namespace ThermoContact

#endif
