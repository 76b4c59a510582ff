// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef thermocontact_rounding_of_velocity_h
#define thermocontact_rounding_of_velocity_h

#include <thermocontact/method/butcher_tableau.h>

#include <deal.II/lac/full_matrix.h>

#include <limits>
#include <string>

namespace ThermoContact
{
  /**
   * What rounding does to the velocity of a body without mass and viscosity,
   * or of contact nodes without them, whatever solves its stages.
   *
   * Their displacement u is in equilibrium, to 1e3 roundings: the condition of
   * the stiffness with unit diagonal is 1e3 to 1e5 on the meshes of the tests,
   * and errors of roundings are random. The velocity of a stage is $v_i =
   * (u_i-\tilde u_i)/\tau$, and $\tilde u_i$ has those of the stages before,
   * $u_i-u_0=\Delta t\sum_j a_{ij}v_j$. So $v = (a/\gamma)^{-1}(u-u_0)/\tau$,
   * and the sums of the rows of the absolute inverse say what roundings can add
   * up to: 1 for backward Euler, 3.4 for sdirk2, 71 for sdirk4.
   *
   * @param displacement its largest size
   * @param step_size the shortest one
   */
  inline double
  rounding_of_velocity(const std::string &scheme,
                       const double       displacement,
                       const double       step_size)
  {
    const double               n_roundings = 1e3;
    const ButcherTableau      &tableau     = butcher_tableau(scheme);
    const unsigned int         n           = tableau.n_stages();
    dealii::FullMatrix<double> matrix(n, n);
    for (unsigned int i = 0; i < n; ++i)
      for (unsigned int j = 0; j <= i; ++j)
        matrix(i, j) = tableau.a[i][j] / tableau.gamma();
    matrix.gauss_jordan();
    return matrix.linfty_norm() * n_roundings *
           std::numeric_limits<double>::epsilon() * displacement /
           (tableau.gamma() * step_size);
  }
} // namespace ThermoContact

#endif
