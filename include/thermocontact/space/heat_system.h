// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef thermocontact_space_heat_system_h
#define thermocontact_space_heat_system_h

#include <thermocontact/space/direct_solver.h>
#include <thermocontact/space/thermoviscoelastic_operator.h>

#include <memory>

namespace ThermoContact
{
  /**
   * $M\,\theta=q$ or $(K+kB+L+E)\,\theta=q$ with a diagonal $E$, for
   * temperatures that vanish where they are given. By factors, or for a body
   * without matrices by conjugate gradients.
   */
  template <int dim>
  class HeatSystem
  {
  public:
    /**
     * @param equations borrowed
     * @param diagonal $E$ of $K+kB+L+E$, the body at rest; null: $M$, what heat
     *   does at one instant, before it flows
     * @throw ComputationError if the matrix cannot be factorised
     */
    explicit HeatSystem(const ThermoviscoelasticOperator<dim> &equations,
                        const Vector *const diagonal = nullptr);

    /** True if a matrix was factorised for it. */
    bool
    has_factors() const
    {
      return factors != nullptr;
    }

    /**
     * @param temperature out: $\theta$
     * @param heat $q$; given rows are zero
     * @throw ComputationError if the iteration does not converge
     */
    void
    solve(Vector &temperature, const Vector &heat) const;

    /** The product of the iteration. */
    void
    vmult(Vector &y, const Vector &x) const;

  private:
    const ThermoviscoelasticOperator<dim> &equations;
    const bool                             is_mass;
    Vector                                 diagonal; ///< $E$
    std::unique_ptr<DirectSolver>          factors;
    Vector                                 inverse_diagonal; ///< or that
  };
} // namespace ThermoContact

#endif
