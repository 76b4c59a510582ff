// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef thermocontact_time_energy_conserving_integrator_h
#define thermocontact_time_energy_conserving_integrator_h

#include <thermocontact/contact/conserving_contact.h>
#include <thermocontact/time/driven_step.h>
#include <thermocontact/time/equilibrium.h>
#include <thermocontact/time/make_stage_solver.h>
#include <thermocontact/time/time_integrator.h>

#include <memory>
#include <vector>

namespace ThermoContact
{
  /**
   * The midpoint rule with a discrete gradient of the contact potential,
   * doc/contact-in-time.md section 6: of order 2, and without loads a step
   * changes the energy by exactly the physical dissipation, through contact of
   * any stiffness and for any step size.
   *
   * One stage of length $\Delta t/2$, whose matrix and factorisation are those
   * of other schemes. The contact nodes have no mass and carry elastic and
   * thermal stress alone, so that they are in equilibrium at every time level,
   * as the caller has put them in the initial state. Their velocity is the mean
   * one of the step.
   */
  template <int dim>
  class EnergyConservingIntegrator : public TimeIntegrator
  {
  public:
    /** @param body borrowed */
    explicit EnergyConservingIntegrator(Body<dim> &body);

    void
    step(const State      &state,
         const TimeStep   &time_step,
         const ContactMode mode,
         StepResult       &result) override;

    StageSolver &
    stage_solver() override
    {
      return *solver;
    }

  private:
    Body<dim>                         &body;
    const std::unique_ptr<StageSolver> solver;

    DrivenStep<dim> driven; ///< of a fixed end that is heated

    StageRates         rates;
    State              midpoint;
    State              obstacle; ///< gaps alone, at the end of the step
    Vector             heat_load;
    Vector             momentum_load;
    FullMatrix<double> all_receptance; ///< $X$ of (C6.3)
    FullMatrix<double> receptance;     ///< its square part, $X$ of the nodes
    FullMatrix<double> loss;           ///< $W-X$ of the step

    Equilibrium<dim>                   nodes; ///< at fixed entropy
    std::unique_ptr<ConservingContact> contact;

    std::vector<NodeLaw> laws;  ///< of the contact nodes in the step
    std::vector<double>  start; ///< their positions at the beginning

    std::vector<double> old_free_position; ///< $s$ at the beginning
    std::vector<double> free_position;     ///< $s$ at the end

    /** Computes $X$ and what goes with it. */
    void
    set_up_contact();

    /** Where the obstacle will be, and its mean velocity. */
    void
    move_obstacle(const State &state, const TimeStep &time_step);

    /** The stage to the middle of the step, with a driven end. */
    void
    solve_without_contact(const State &state, const TimeStep &time_step);

    /**
     * Loads of a step: those at its middle, but for the contact nodes the mean
     * ones of both ends, with which they are in equilibrium.
     */
    void
    assemble_loads(const double begin, const double end);

    /** Finds $\bar p$ and adds its response to the rates. */
    void
    apply_contact(const State &state, const TimeStep &time_step);

    /** Moves the contact nodes to their equilibrium at the end of the step. */
    void
    finish_contact(const State    &state,
                   const TimeStep &time_step,
                   State          &new_state);
  };
} // namespace ThermoContact

#endif
