// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef thermocontact_time_iterative_node_equilibrium_h
#define thermocontact_time_iterative_node_equilibrium_h

#include <thermocontact/base/tolerances.h>
#include <thermocontact/space/linear_system.h>
#include <thermocontact/time/node_equilibrium.h>

#include <deal.II/lac/vector.h>

#include <vector>

namespace ThermoContact
{
  /**
   * For bodies without matrices and as many nodes as there may be: tangents of
   * the laws and conjugate gradients, with products of the cells at the end
   * alone.
   */
  template <int dim>
  class IterativeNodeEquilibrium : public NodeEquilibrium<dim>,
                                   private InterfaceOperator
  {
  public:
    /** As make_node_equilibrium(). */
    IterativeNodeEquilibrium(const Body<dim> &body,
                             const double     factor,
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

    /** The product of the conjugate gradients. */
    void
    vmult(dealii::Vector<double> &y, const dealii::Vector<double> &x) const;

  private:
    const Body<dim>                   &body;
    const double                       factor;
    const bool                         takes_heat;
    std::vector<AffineLaw>             tangents;  ///< of all nodes
    std::vector<double>                diagonal;  ///< of K
    std::unique_ptr<LinearSystem<dim>> heat_mass; ///< if it takes heat
    mutable Vector                     values;
    mutable Vector                     forces;

    // of the problem that is solved
    const std::vector<double> *load     = nullptr;
    const std::vector<double> *position = nullptr;
    std::vector<double>        change;

    void
    solve(const std::vector<AffineLaw> &laws,
          const bool                    is_last,
          std::vector<double>          &new_position,
          std::vector<double>          &pressure) override;

    /** Relative residual of the conjugate gradients. */
    double
    tolerance() const
    {
      return takes_heat ? Tolerances::adiabatic_residual :
                          Tolerances::rounding_of_solution;
    }

    bool
    is_held(const unsigned int node) const
    {
      return tangents[node].compliance == 0.;
    }

    /** Of the obstacle, per displacement of the node. */
    double
    spring(const unsigned int node) const;

    /**
     * The linear problem of the present tangents.
     *
     * @param penetration of all nodes beyond their offsets
     */
    std::vector<double>
    solve_linear(const std::vector<double> &load,
                 const std::vector<double> &penetration);

    /** The temperature of add_heating(). */
    Vector
    heating(const std::vector<double> &change) const;

    /** K times values of the nodes. */
    std::vector<double>
    product(const std::vector<double> &x) const;
  };
} // namespace ThermoContact

#endif
