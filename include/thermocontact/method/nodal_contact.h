// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef thermocontact_method_nodal_contact_h
#define thermocontact_method_nodal_contact_h

#include <deal.II/lac/full_matrix.h>

#include <vector>

namespace ThermoContact
{
  /**
   * The pressure of each contact node as a function of one number x of the
   * node, its penetration or its velocity. Does not fall as x grows.
   */
  class NodalLaws
  {
  public:
    virtual ~NodalLaws() = default;

    virtual double
    pressure(const unsigned int node, const double x) const = 0;

    /** $dp/dx\ge0$, finite, where the pressure is @p pressure. */
    virtual double
    stiffness(const unsigned int node,
              const double       x,
              const double       pressure) const = 0;

    /** The pressure p of one node alone at $x=x_{free}-rp$. */
    virtual double
    local_pressure(const unsigned int node,
                   const double       free_x,
                   const double       receptance) const = 0;

    /** That x. */
    virtual double
    position(const unsigned int node,
             const double       free_x,
             const double       receptance,
             const double       pressure) const = 0;
  };



  /**
   * Pressures of nodes that influence each other, doc/model.md (M.70), (M.84):
   * $x_i+\sum_j R_{ij}\,p_j(x_j)=x^{free}_i$. Newton's method; each step, or a
   * part of it, has to make the largest defect smaller than it ever was, else
   * one node after another meets its law. There is one solution, since R is a
   * positive definite matrix with scaled columns.
   *
   * @param response R
   * @param x in: where the search starts
   * @param pressure out
   * @return number of iterations
   * @throw ComputationError if there are too many
   */
  unsigned int
  solve_nodal_contact(const NodalLaws                  &laws,
                      const dealii::FullMatrix<double> &response,
                      const std::vector<double>        &free_x,
                      std::vector<double>               x,
                      std::vector<double>              &pressure);
} // namespace ThermoContact

#endif
