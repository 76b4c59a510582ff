// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef thermocontact_time_node_equilibrium_h
#define thermocontact_time_node_equilibrium_h

#include <thermocontact/contact/interface_law.h>
#include <thermocontact/contact/interface_problem.h>
#include <thermocontact/space/body.h>
#include <thermocontact/time/stage_solver.h>

#include <deal.II/lac/full_matrix.h>

#include <memory>
#include <vector>

namespace ThermoContact
{
  /**
   * Nodes of the contact end that balance the forces on them, all others being
   * given: $K\,\delta x+wp=f$ with a multiple K of the stiffness between them
   * and pressures that their laws give at $x+\delta x$.
   *
   * Vectors of numbers have one for each node of the end, those of pressures,
   * laws and positions one for each that can meet the obstacle. All of it is
   * collective.
   */
  template <int dim>
  class NodeEquilibrium
  {
  public:
    virtual ~NodeEquilibrium() = default;

    /**
     * @param load $f$ without pressures
     * @param laws,position of the nodes before the change
     * @param pressure in: a guess; out: the solution
     * @return $\delta x$
     * @throw ComputationError if the pressures are not found
     */
    virtual std::vector<double>
    solve(const std::vector<double>  &load,
          const std::vector<NodeLaw> &laws,
          const std::vector<double>  &position,
          std::vector<double>        &pressure) = 0;

    /**
     * The same problem differentiated at the solution that was found last, its
     * branches held, (C4.3).
     *
     * @param load its rate
     * @param rate of the positions before the change
     * @param closing nodes that touch their local obstacle at this instant and
     *   may have no pressure yet
     */
    virtual std::vector<double>
    solve_rates(const std::vector<double>       &load,
                const std::vector<double>       &rate,
                const std::vector<unsigned int> &closing) = 0;

    /**
     * Adds $-aM^{-1}D\,\delta u$, the temperature of a body that is deformed at
     * once, (C4.4).
     */
    virtual void
    add_heating(const std::vector<double> &change,
                Vector                    &temperature) const = 0;
  };



  /** With $K^{-1}$, for bodies that have matrices. */
  template <int dim>
  class DirectNodeEquilibrium : public NodeEquilibrium<dim>
  {
  public:
    /** As make_node_equilibrium(). */
    DirectNodeEquilibrium(const Body<dim> &body,
                          const double     factor,
                          SolverCounters  &counters,
                          const bool       takes_heat);

    std::vector<double>
    solve(const std::vector<double>  &load,
          const std::vector<NodeLaw> &laws,
          const std::vector<double>  &position,
          std::vector<double>        &pressure) override;

    std::vector<double>
    solve_rates(const std::vector<double>       &load,
                const std::vector<double>       &rate,
                const std::vector<unsigned int> &closing) override;

    void
    add_heating(const std::vector<double> &change,
                Vector                    &temperature) const override;

    /**
     * $X=K^{-1}\mathrm{diag}(w)$ of (C6.3), displacements of all nodes of the
     * end per unit pressure at those that have pressures, which come first.
     */
    const dealii::FullMatrix<double> &
    receptance() const
    {
      return all_receptance;
    }

  private:
    const ContactLaw          &law;
    dealii::FullMatrix<double> flexibility; ///< $K^{-1}$
    dealii::FullMatrix<double> all_receptance;
    dealii::FullMatrix<double> between_pressures; ///< its square part
    InterfaceProblem           problem;

    /** Temperatures per unit displacement of a node; empty: none. */
    std::vector<Vector> temperature_responses;

    /** $\delta x$ by forces and pressures. */
    std::vector<double>
    change_by(const std::vector<double> &free,
              const std::vector<double> &pressure) const;

    /** Positions, or their rates, with the change by forces. */
    std::vector<double>
    moved(const std::vector<double> &position,
          const std::vector<double> &free) const;

    /** Adds $a^2D^TM^{-1}D$ to K. */
    void
    add_heating_to(const Body<dim>            &body,
                   SolverCounters             &counters,
                   dealii::FullMatrix<double> &stiffness);
  };



  /**
   * @param body borrowed
   * @param factor of the stiffness
   * @param counters what is factorised is added
   * @param takes_heat the nodes move at once, and the body takes heat for it,
   *   (C4.4): $K$ has $a^2D^TM^{-1}D$ added
   */
  template <int dim>
  std::unique_ptr<NodeEquilibrium<dim>>
  make_node_equilibrium(const Body<dim> &body,
                        const double     factor,
                        SolverCounters  &counters,
                        const bool       takes_heat = false);
} // namespace ThermoContact

#endif
