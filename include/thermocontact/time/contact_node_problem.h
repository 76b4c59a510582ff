// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef thermocontact_time_contact_node_problem_h
#define thermocontact_time_contact_node_problem_h

#include <thermocontact/contact/interface_problem.h>
#include <thermocontact/space/body.h>

#include <deal.II/lac/vector.h>

#include <vector>

namespace ThermoContact
{
  /**
   * Values of the nodes of the contact end, all others being given, with
   * pressures of unilateral contact there: $Kx=f-wp$ with a multiple $K$ of the
   * stiffness between the nodes. For as many nodes as there may be: active sets
   * and conjugate gradients, with products of the cells at the end alone.
   *
   * Vectors of numbers have one for each of all nodes, those of pressures one
   * for each node that can meet the obstacle. All of it is collective.
   */
  template <int dim>
  class ContactNodeProblem : private InterfaceOperator
  {
  public:
    /**
     * @param body borrowed; it has no matrices
     * @param factor of the stiffness
     * @param takes_heat the nodes move at once, and the body takes heat for it,
     *   (M.67): $K$ has $a^2D^TM^{-1}D$ added
     */
    ContactNodeProblem(const Body<dim> &body,
                       const double     factor,
                       const bool       takes_heat = false);

    /**
     * Changes @p x by which the nodes come into equilibrium.
     *
     * @param load $f$ before the change
     * @param laws of the nodes that can meet the obstacle, rigid or linear
     * @param position of these before the change, as the laws have it
     * @param pressure in: a guess; out: the solution
     * @throw ComputationError if the branches do not settle
     */
    std::vector<double>
    solve(const std::vector<double>  &load,
          const std::vector<NodeLaw> &laws,
          const std::vector<double>  &position,
          std::vector<double>        &pressure);

    /**
     * The same for the branches that were found, whatever the pressures.
     *
     * @param penetration of the obstacles where the nodes are, in the direction
     *   of the displacement; or a rate
     */
    std::vector<double>
    solve_for_same_branches(const std::vector<double> &load,
                            const std::vector<double> &penetration);

    /** $-aM^{-1}D\,\delta u$, (M.67), of a change of the nodes. */
    Vector
    heating(const std::vector<double> &change) const;

    /** The product of the conjugate gradients. */
    void
    vmult(dealii::Vector<double> &y, const dealii::Vector<double> &x) const;

  private:
    const Body<dim>    &body;
    const double        factor;
    const bool          takes_heat;
    std::vector<int>    branches;
    std::vector<double> diagonal;          ///< of K
    Vector              inverse_heat_mass; ///< of its diagonal
    mutable Vector      values;
    mutable Vector      forces;

    // of the problem that is solved
    const std::vector<double>  *load     = nullptr;
    const std::vector<NodeLaw> *laws     = nullptr;
    const std::vector<double>  *position = nullptr;
    std::vector<double>         change;

    void
    solve(const std::vector<int> &branch,
          const bool              is_last,
          std::vector<double>    &new_position,
          std::vector<double>    &pressure) override;

    /** Relative residual of the conjugate gradients. */
    double
    tolerance() const
    {
      return takes_heat ? 1e-11 : 1e-13;
    }

    bool
    is_held(const unsigned int node) const
    {
      return branches[node] != 0 && body.law().is_rigid();
    }

    /** Of the obstacle, per displacement of the node. */
    double
    spring(const unsigned int node) const;

    /** K times values of the nodes. */
    std::vector<double>
    product(const std::vector<double> &x) const;
  };
} // namespace ThermoContact

#endif
