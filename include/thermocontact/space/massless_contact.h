// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef thermocontact_space_massless_contact_h
#define thermocontact_space_massless_contact_h

#include <thermocontact/base/types.h>
#include <thermocontact/space/discretization.h>

#include <deal.II/base/quadrature.h>

#include <deal.II/dofs/dof_handler.h>

#include <deal.II/lac/full_matrix.h>

#include <vector>

namespace ThermoContact
{
  /** Rule for mass matrices; lumped: the nodes of FE_Q, a diagonal matrix. */
  template <int dim>
  Quadrature<dim>
  mass_quadrature(const unsigned int degree, const bool is_lumped);

  /**
   * The same as mass_quadrature() across the body, and along it the
   * interpolatory rule on the nodes off the contact end $x=1$ of a cell that
   * touches it: exact for polynomials of degree p - 1, it leaves the contact
   * nodes without mass and keeps the mass of the cell, doc/contact-in-time.md
   * (C1.1).
   */
  template <int dim>
  Quadrature<dim>
  massless_quadrature(const unsigned int degree, const bool is_lumped);

  /**
   * Value at the contact end of the polynomial of degree p - 1 through the
   * other nodes of a line along the body, as factors of their values.
   */
  std::vector<double>
  extension_from_other_nodes(const unsigned int degree);

  /**
   * Matrix that gives the nodes on the contact end of a cell the axial
   * displacement of the polynomial of degree p - 1 through the other nodes of
   * their line, and leaves all else as it is; in the numbering of the cell.
   * doc/contact-in-time.md (C6.1).
   */
  template <int dim>
  FullMatrix<double>
  extension_to_contact_nodes(const Discretization<dim> &discretization);
} // namespace ThermoContact

#endif
