// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef thermocontact_time_stage_solver_h
#define thermocontact_time_stage_solver_h

#include <thermocontact/base/types.h>
#include <thermocontact/contact/contact_law.h>
#include <thermocontact/contact/interface_law.h>
#include <thermocontact/space/state.h>

#include <deal.II/lac/full_matrix.h>

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

namespace ThermoContact
{
  /** The solution of one implicit stage, doc/discretisation.md (D2.1).
   * Integrators set the acceleration. */
  struct StageRates : Rates
  {
    ObstacleAction contact;

    /**
     * in: of closed stages, the obstacle at which each node is held, 1 or -1,
     * wherever the known values are; empty: there is one
     */
    std::vector<int> held_at;

    unsigned int n_iterations =
      0; ///< linear systems of contact, or of the fixed point

    /** Power of the residuals of a linear solver, (D8.5). */
    double algebraic_power = 0.;

    std::string failure; ///< empty: solved

    /** The start of a solver: no pressures, nothing of the last stage. */
    void
    start(const State &known)
    {
      failure.clear();
      n_iterations = 0;
      contact      = known.contact;
      contact.pressure.assign(contact.pressure.size(), 0.);
    }
  };



  /** The cost of a run so far. */
  struct SolverCounters
  {
    /** Factors, or preconditioners of a stage length or of a set of nodes. */
    unsigned int factorizations = 0;

    unsigned int solves    = 0; ///< linear problems of stages
    unsigned int responses = 0; ///< back-substitutions for $W$

    unsigned int linear_iterations     = 0; ///< with V-cycles, added up
    unsigned int max_linear_iterations = 0; ///< of one system of a stage
    unsigned int active_set_iterations = 0; ///< of systems without factors

    double factorization_seconds = 0.; ///< assembly of stage matrices, too
    double solve_seconds         = 0.; ///< with factorisations
    double contact_seconds       = 0.; ///< pressures and responses

    /** Counts the iterations of a Krylov method for one system of a stage. */
    void
    count_iterations(const unsigned int n)
    {
      linear_iterations += n;
      max_linear_iterations = std::max(max_linear_iterations, n);
    }

    /** Adds counts; times are of stages alone. */
    SolverCounters &
    operator+=(const SolverCounters &other)
    {
      factorizations += other.factorizations;
      solves += other.solves;
      responses += other.responses;
      linear_iterations += other.linear_iterations;
      max_linear_iterations =
        std::max(max_linear_iterations, other.max_linear_iterations);
      active_set_iterations += other.active_set_iterations;
      return *this;
    }

    template <class Archive>
    void
    serialize(Archive &archive, const unsigned int)
    {
      archive &factorizations &solves &responses &linear_iterations
        &max_linear_iterations &active_set_iterations;
    }
  };



  /** The memory of a stage solver from one stage to the next. */
  struct RetainedFactorizations
  {
    SolverCounters counters;

    /** Stage lengths that are factorised, the one used last in front. */
    std::vector<double> taus;

    /** Whether the response to pressures is known for them. */
    std::vector<bool> has_response;

    /** The springs of contact nodes that are factorised, too; empty: none. */
    std::vector<std::vector<double>> contact_springs;

    /** Whether a stage had sparse factors since the blocks of its rod grew. */
    bool has_refused_blocks = false;

    /** The largest residual by rounding that was warned of. */
    double reported_rounding = 0.;

    template <class Archive>
    void
    serialize(Archive &archive, const unsigned int)
    {
      archive &counters &taus &has_response &contact_springs &has_refused_blocks
        &reported_rounding;
    }
  };



  /**
   * Solves one implicit stage of length tau: finds the rates with
   * $\theta=\tilde\theta+\tau\theta'$, $u=\tilde u+\tau v$,
   * $v=\tilde v+\tau v'$ that satisfy the semidiscrete equations (D1.1),
   * (D1.2) with contact.
   */
  class StageSolver
  {
  public:
    virtual ~StageSolver() = default;

    /**
     * @param known $(\tilde\theta,\tilde u,\tilde v)$ and, to start the search,
     *   nearby contact pressures
     * @param tau stage length, positive; a new value costs a factorisation
     * @param heat_load,momentum_load loads at the stage time
     * @param mode unilateral: the contact law; open, closed: one of its two
     *   branches, which makes the stage linear if the law is and exchange does
     *   not depend on the contact
     * @param rates out; its vectors have been given their layout by the caller;
     *   a stage that did not converge has a non-empty failure
     * @throw ComputationError if a matrix cannot be factorised, iterations of a
     *   linear problem do not converge, the active set of several contact nodes
     *   does not settle, or no heat exchange coefficients are found that go
     * with the contact
     */
    virtual void
    solve(const State  &known,
          const double  tau,
          const Vector &heat_load,
          const Vector &momentum_load,
          ContactMode   mode,
          StageRates   &rates) = 0;

    /**
     * Takes from the difference between two results of a step the response of
     * the stage that was solved last to pressures, doc/contact-in-time.md
     * (C3.2): the laws have these pressures where they bring the contact nodes
     * back from this displacement. A solver without responses leaves the
     * difference as it is.
     *
     * Arguments: tangents of closed nodes, others are open; that displacement;
     * in, out: the difference $e_\theta$, $e_u$, $e_v$.
     */
    virtual void
    subtract_response(const std::vector<AffineLaw> & /*laws*/,
                      const std::vector<double> & /*displacement*/,
                      State & /*difference*/)
    {}

    /**
     * $W$ of (C2.1) for stages of length @p tau with heat exchange in their
     * matrices; to be asked for before such a stage is solved.
     */
    virtual const FullMatrix<double> &
    response(const double /*tau*/)
    {
      AssertThrow(false, dealii::ExcNotImplemented());
    }

    /**
     * Adds the response to the pressures of @p rates to the rates of the stage
     * that was solved last, which was open.
     */
    virtual void
    apply_pressure(StageRates & /*rates*/)
    {
      AssertThrow(false, dealii::ExcNotImplemented());
    }

    /** Unknowns of the largest matrix that is factorised; 0: there is none. */
    virtual types::global_dof_index
    n_factorized_unknowns() const = 0;

    /** How linear systems are solved, in one word or two. */
    virtual std::string
    linear_solver() const
    {
      return "direct";
    }

    /** Warnings for the user of the stages since the last call. */
    std::vector<std::string>
    take_warnings()
    {
      return std::exchange(warnings, {});
    }

    const SolverCounters &
    counters() const
    {
      return counters_;
    }

    /** The memory of the solver between stages, for checkpoints. */
    virtual RetainedFactorizations
    retained() const = 0;

    /**
     * Makes retained factors again and goes on counting from there, so that a
     * run that goes on spends as much as an uninterrupted one. Collective.
     */
    virtual void
    restore(const RetainedFactorizations &retained) = 0;

  protected:
    SolverCounters           counters_;
    std::vector<std::string> warnings;

    /**
     * Takes @p load times the response to a load from a difference.
     *
     * @param tau,viscosity length of the stage; $\zeta$ of the body
     * @param velocity of the response
     * @param heating,heat the temperature of the response is their product; a
     *   vector without entries: it does not change
     * @param difference in, out
     */
    static void
    subtract(const double  load,
             const double  tau,
             const double  viscosity,
             const Vector &velocity,
             const double  heating,
             const Vector &heat,
             State        &difference)
    {
      difference.displacement.add(-load * tau, velocity);
      // Viscous stress alone has carried the displacement of the nodes into the
      // velocity of the others: elastic stress does so with higher order.
      difference.velocity.add(-load * viscosity / (viscosity + tau), velocity);
      if (heat.size() > 0)
        difference.temperature.add(-load * heating, heat);
    }
  };
} // namespace ThermoContact

#endif
