// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef thermocontact_space_heat_mass_h
#define thermocontact_space_heat_mass_h

#include <thermocontact/space/body.h>
#include <thermocontact/space/direct_solver.h>

#include <memory>

namespace ThermoContact
{
  /**
   * $M\,\delta\theta=q$, what heat does to a body at one instant, before it
   * flows; $\delta\theta$ vanishes where temperatures are given. By factors, or
   * for a body without matrices by conjugate gradients.
   */
  template <int dim>
  class HeatMass
  {
  public:
    /**
     * @param body borrowed
     * @throw ComputationError if $M$ cannot be factorised
     */
    explicit HeatMass(const Body<dim> &body);

    /** True if a matrix was factorised for it. */
    bool
    has_factors() const
    {
      return factors != nullptr;
    }

    /**
     * @param temperature out: $\delta\theta$
     * @param heat $q$; given rows are zero
     * @throw ComputationError if the iteration does not converge
     */
    void
    solve(Vector &temperature, const Vector &heat) const;

  private:
    const Body<dim>              &body;
    std::unique_ptr<DirectSolver> factors;
    Vector                        inverse_diagonal;
  };
} // namespace ThermoContact

#endif
