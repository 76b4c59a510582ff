// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef thermocontact_method_butcher_tableau_h
#define thermocontact_method_butcher_tableau_h

#include <string>
#include <vector>

namespace ThermoContact
{
  /**
   * Coefficients of a diagonally implicit Runge-Kutta scheme with equal
   * diagonal entries (SDIRK), so that a step size costs one factorisation.
   * Stage i of a step from $t$ by $\Delta t$ is at $t+c_i\Delta t$ and has
   * length $\tau=a_{ii}\Delta t$. All schemes here are stiffly accurate: the
   * last stage is the new state, which therefore satisfies the contact
   * condition.
   */
  struct ButcherTableau
  {
    std::string                      name;
    unsigned int                     order = 1;
    std::vector<std::vector<double>> a; ///< lower triangle with diagonal
    std::vector<double>              c; ///< row sums of a

    /** Weights of the embedded scheme of order - 1; empty if there is none. */
    std::vector<double> embedded_b;

    /**
     * Those for a body without inertia and viscosity, which follows its loads
     * at once, doc/discretisation.md section 3: embedded_b, or of sdirk4 of
     * order 2, and for what has no equation of its own the extrapolation of the
     * old value and the first stages, of order 3.
     */
    std::vector<double> static_b;

    bool
    has_error_estimate() const
    {
      return !embedded_b.empty();
    }

    unsigned int
    n_stages() const
    {
      return a.size();
    }

    /**
     * Bounds $C_m$, $m=1,\dots,$ order, of the error estimate of what decays at
     * the rate $\lambda$, in parts of it: $|e|\le C_m(\lambda\,\Delta t)^m$ for
     * all $\lambda\ge0$; empty if there is no estimate.
     */
    std::vector<double>
    bounds_of_estimate() const;

    /** Diagonal entry, stage length per step size. */
    double
    gamma() const
    {
      return a[0][0];
    }

    /** Quadrature weights: the last row of a (stiff accuracy). */
    const std::vector<double> &
    b() const
    {
      return a.back();
    }
  };



  /**
   * The schemes of the program. Adding a scheme is adding an entry here.
   *
   * Backward Euler; Alexander (1977) of orders 2 and 3; Hairer and Wanner
   * (1996), table IV.6.5, of order 4.
   */
  const std::vector<ButcherTableau> &
  butcher_tableaus();

  /** The scheme of that name, which exists. */
  const ButcherTableau &
  butcher_tableau(const std::string &name);
} // namespace ThermoContact

#endif
