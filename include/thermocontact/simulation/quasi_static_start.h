// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef thermocontact_simulation_quasi_static_start_h
#define thermocontact_simulation_quasi_static_start_h

#include <thermocontact/method/interface_problem.h>
#include <thermocontact/space/body.h>
#include <thermocontact/space/direct_solver.h>
#include <thermocontact/space/state.h>
#include <thermocontact/time/stage_solver.h>

#include <deal.II/lac/full_matrix.h>

#include <memory>
#include <vector>

namespace ThermoContact
{
  /**
   * Completes states of a body without inertia, the initial one and those that
   * no stage has completed, doc/model.md section 12: with viscosity the
   * velocity follows from the displacement, (M.34); without, the displacement
   * is in equilibrium with the temperature, (M.35), and the velocity, which has
   * no value yet, is left at zero. There is one for a simulation, lent to all
   * who need it. It keeps its factors; preconditioners it makes anew each time,
   * so that a run that is resumed makes the same.
   */
  template <int dim>
  class QuasiStaticStart
  {
  public:
    /** @param body borrowed */
    explicit QuasiStaticStart(Body<dim> &body);

    /**
     * @param state in: temperature and, with viscosity, displacement and
     *   pressure of the compliance law
     * @param is_closed with viscosity, at a rigid obstacle: the nodes in
     *   contact; empty: those that do not lie before it
     * @throw ComputationError if the stiffness matrix cannot be factorised or
     *   the contact nodes do not settle
     */
    void
    complete(State &state, const std::vector<bool> &is_closed = {});

    /** Factors and responses so far, and what an iterative solver made. */
    const SolverCounters &
    counters() const
    {
      return counters_;
    }

    /**
     * Goes on counting from there, for a run that goes on: its initial state
     * has made the factors again.
     */
    void
    restore(const SolverCounters &counters)
    {
      counters_ = counters;
    }

  private:
    Body<dim>                    &body;
    SolverCounters                counters_;
    std::unique_ptr<DirectSolver> factors;
    std::vector<Vector>           unit_responses; ///< to pressures
    FullMatrix<double>            response;       ///< of the contact nodes

    /** An IterativeSolver, without matrices; only its levels are kept. */
    std::unique_ptr<StageSolver> iterative;

    /** Makes the factors and responses, if it has matrices. */
    void
    factorize();

    /**
     * Adds to $w$ what pressures do at contact nodes that meet @p laws.
     *
     * @param free what the laws are of, without pressures
     * @param factor of that per $w$
     * @param w in: without pressures; out: the solution
     * @param pressure in: a guess; out: the solution
     */
    void
    add_contact(const std::vector<NodeLaw> &laws,
                const std::vector<double>  &free,
                const double                factor,
                Vector                     &w,
                std::vector<double>        &pressure);

    /** A static body: its displacement under a load. */
    void
    solve_static(const Vector &load, State &state);

    /**
     * (M.34) with a rigid obstacle: nodes in contact cannot move into it.
     *
     * @param is_closed as for complete()
     * @param load as for solve_with_damping()
     */
    void
    solve_on_rigid(const std::vector<bool> &is_closed,
                   const Vector            &load,
                   State                   &state);

    /**
     * (M.34) with a damped obstacle: velocities and pressures that go with
     * the displacements.
     *
     * @param load forces on the body without contact
     */
    void
    solve_with_damping(const Vector &load, State &state);
  };
} // namespace ThermoContact

#endif
