// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef thermocontact_time_integrator_h
#define thermocontact_time_integrator_h

#include <deal.II/lac/full_matrix.h>

#include <memory>
#include <string>
#include <vector>

#include "butcher_tableau.h"
#include "direct_solver.h"
#include "energy.h"
#include "loads.h"
#include "step_controller.h"
#include "step_solver.h"
#include "thermoviscoelastic_operator.h"

namespace ThermoContact
{
  /** A step that has been computed but not yet accepted. */
  struct StepResult
  {
    State        state;                      ///< at the end of the step
    EnergyTerms  energy;                     ///< of that state
    EnergyTerms  error;                      ///< its estimate, (M.29)
    double       work                  = 0.; ///< $W$
    double       dissipation           = 0.; ///< $D$
    double       numerical_dissipation = 0.; ///< $N$
    double       impulse               = 0.; ///< of the contact force
    unsigned int n_iterations          = 0;  ///< of the stages, added up
    bool         is_prescribed = false;      ///< the paper's first step, (M.26)
    std::string  failure;                    ///< empty: the step is solved
  };



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
   * (M.24); that of the other schemes is what the balance lacks, has no sign,
   * and vanishes with the order of the scheme.
   */
  template <int dim>
  class TimeIntegrator
  {
  public:
    /** The references are borrowed. */
    TimeIntegrator(const Discretization<dim>             &discretization,
                   const ThermoviscoelasticOperator<dim> &stage_operator,
                   const Energy<dim>                     &energy,
                   const ContactLaw                      &law,
                   const ButcherTableau                  &tableau,
                   Loads<dim>                            &loads,
                   StepSolver                            &step_solver);

    /**
     * One step with all equations solved, (M.27), (M.28).
     *
     * @param old_energy $\hat E$ of @p state
     * @param mode unilateral: every stage satisfies the contact law; open,
     *   closed: the state of contact is held, which makes the step a smooth
     *   function of its size
     * @param result out; its error is set if the scheme has an estimate; reuses
     *   the memory of an earlier result; if a stage
     *   did not converge only its failure has a meaning
     * @throw ComputationError as StepSolver::solve() does
     */
    void
    step(const State      &state,
         const double      old_energy,
         const TimeStep   &time_step,
         const ContactMode mode,
         StepResult       &result);

    /**
     * The start of the paper, (M.26): the displacement moves with the present
     * velocity, then the heat equation is solved. No stage is solved, so that
     * the pressure is that of the compliance law, and the defect of the energy
     * balance is booked as numerical dissipation, of either sign. The caller
     * has made sure that a rigid obstacle is not penetrated.
     *
     * @throw ComputationError if the heat matrix cannot be factorised
     */
    void
    prescribed_step(const State    &state,
                    const TimeStep &time_step,
                    StepResult     &result);

    /**
     * Impact of all contact nodes on a rigid obstacle: they are put on it, and
     * an impulse through the mass matrix takes their velocity away, so that the
     * velocity jumps to the nearest one, in the norm of the kinetic energy,
     * with which they rest (M.33).
     *
     * @param energy out: of the new state
     * @param impulse,numerical_dissipation what the impact costs is added
     * @throw ComputationError if the mass matrix cannot be factorised
     */
    void
    impact(State       &state,
           EnergyTerms &energy,
           double      &impulse,
           double      &numerical_dissipation);

    /**
     * Pressures of a step that is accepted: none is negative, and where contact
     * begins they are those of the law, since no stage has seen them.
     */
    void
    finish_pressure(const bool begins_contact, StepResult &result);

    /** What the prescribed steps have spent; the rest is the step solver's. */
    const SolverCounters &
    counters() const
    {
      return counters_;
    }

  private:
    const Discretization<dim>             &discretization;
    const ThermoviscoelasticOperator<dim> &stage_operator;
    const Energy<dim>                     &energy;
    const ContactLaw                       law;
    const ButcherTableau                  &tableau;
    Loads<dim>                            &loads;
    StepSolver                            &step_solver;
    SolverCounters                         counters_;
    std::vector<StageRates>                stages;
    std::vector<Vector>                    accelerations; ///< $v'$ of a stage
    State                                  known;
    State                                  difference;
    Vector                                 heat_load;
    Vector                                 momentum_load;
    std::unique_ptr<DirectSolver>          mass_solver;
    std::vector<Vector>                    impulse_responses;
    FullMatrix<double>                     inverse_receptance;

    /** Velocities, and those of the contact nodes, per unit impulse. */
    void
    compute_impulse_responses();

    /** The known values of stage @p i of a step by @p step_size. */
    void
    set_known_values(const State       &state,
                     const double       step_size,
                     const unsigned int i);

    /** The difference to the embedded scheme, (M.29). */
    void
    estimate_error(const double step_size, StepResult &result);

    /** Adds what the stage that ends in @p stage_state weighs. */
    void
    book(const State &stage_state, const double weight, StepResult &result);
  };
} // namespace ThermoContact

#endif
