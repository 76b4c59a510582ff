// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef thermocontact_time_node_equilibrium_h
#define thermocontact_time_node_equilibrium_h

#include <thermocontact/space/body.h>
#include <thermocontact/time/contact_port.h>
#include <thermocontact/time/stage_solver.h>

#include <deal.II/lac/full_matrix.h>

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
    /**
     * @param body borrowed
     * @param factor of the stiffness
     * @param counters to which factorisations are added
     * @param takes_heat the nodes move at once, and the body takes heat for it,
     *   (C4.4): $K$ has $a^2D^TM^{-1}D$ added
     */
    NodeEquilibrium(const Body<dim> &body,
                    const double     factor,
                    SolverCounters  &counters,
                    const bool       takes_heat = false);

    /**
     * @param load $f$ without pressures
     * @param laws,position of the nodes before the change
     * @param pressure in: a guess; out: the solution
     * @return $\delta x$
     * @throw ComputationError if the pressures are not found
     */
    std::vector<double>
    solve(const std::vector<double>  &load,
          const std::vector<NodeLaw> &laws,
          const std::vector<double>  &position,
          std::vector<double>        &pressure);

    /**
     * The same problem differentiated at the solution that was found last, its
     * branches held, (C4.3).
     *
     * @param load its rate
     * @param rate of the positions before the change
     * @param laws of the nodes, for their local obstacles
     * @param closing nodes that touch their local obstacle at this instant and
     *   may have no pressure yet
     */
    std::vector<double>
    solve_rates(const std::vector<double>       &load,
                const std::vector<double>       &rate,
                const std::vector<NodeLaw>      &laws,
                const std::vector<unsigned int> &closing);

    /**
     * Adds $-aM^{-1}D\,\delta u$, the temperature of a body that is deformed at
     * once, (C4.4).
     */
    void
    add_heating(const std::vector<double> &change, Vector &temperature);

    /**
     * $X=K^{-1}\mathrm{diag}(w)$ of (C6.3), displacements of all nodes of the
     * end per unit pressure at those that have pressures, which come first; of
     * bodies that have matrices.
     */
    FullMatrix<double>
    receptance();

  private:
    const Body<dim>  &body;
    const bool        takes_heat;
    LinearSystem<dim> system;
    ContactPort<dim>  port;
    Vector            forces, displacement, heat;

    /** Of the nodes of the end. */
    std::vector<double>
    changes() const;
  };
} // namespace ThermoContact

#endif
