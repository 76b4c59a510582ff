// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef thermocontact_tests_cycle_h
#define thermocontact_tests_cycle_h

#include <thermocontact/base/number_text.h>
#include <thermocontact/multigrid/stage_multigrid.h>

#include <cmath>

#include "tests.h"

namespace ThermoContact
{
  /** Rows of contact nodes, every second one active; compliance 1e-4. */
  template <int dim>
  ContactRows
  contact_rows(const Body<dim> &body, const bool is_rigid, const double tau)
  {
    ContactRows rows;
    Vector     &values = is_rigid ? rows.held : rows.springs;
    values             = body.discretization.make_vector(Field::displacement);
    for (const auto &[node, entry] :
         body.contact_end().entries(Field::displacement))
      if (node % 2 == 0)
        values.local_element(entry) =
          is_rigid ? 1. :
                     tau * tau * body.contact_end().nodes()[node].weight / 1e-4;
    return rows;
  }



  /**
   * A V-cycle in double precision is symmetric to 1e-10, positive and leaves
   * less than half of an error, and one in single precision is the same to
   * 1e-4, in words behind each other; of zero it makes zero. What is left is
   * told to two digits, as it was measured: whatever makes a smoother, a
   * transfer or a coarser level another one shows.
   *
   * @param rows null: without contact
   */
  template <int dim>
  void
  test_cycle(const Body<dim>                    &body,
             const MultigridLevels<dim, double> &levels,
             const MultigridLevels<dim, float>  &rounded_levels,
             const Field::Block                  field,
             const double                        tau,
             const ContactRows                  *rows)
  {
    const unsigned int          finest = levels.n_levels() - 1;
    StageMultigrid<dim, double> cycle(levels, field, tau);
    StageBlock<dim, double>     block(levels, finest, field, tau);
    if (rows != nullptr)
      {
        cycle.set_contact(rows);
        block.set_contact(*rows);
      }
    Vector r[2], z[2];
    for (unsigned int i = 0; i < 2; ++i)
      {
        r[i] = body.discretization.make_vector(field);
        for (unsigned int j = 0; j < r[i].locally_owned_size(); ++j)
          r[i].local_element(j) = std::sin(1. + 1.7 * (i + 2.) * j * j);
        block.zero_prescribed(r[i]);
        z[i].reinit(r[i]);
        cycle.vmult(z[i], r[i]);
      }
    const double size   = std::sqrt((z[0] * r[0]) * (z[1] * r[1]));
    const double defect = std::abs(z[0] * r[1] - z[1] * r[0]) / size;

    // the error that is left, in the norm of the cycle
    Vector left(r[0]), smoothed(r[0]);
    block.vmult(left, z[0]);
    left -= r[0];
    cycle.vmult(smoothed, left);
    const double remains = std::sqrt((smoothed * left) / (z[0] * r[0]));
    deallog << " asymmetry " << within(defect, 1e-10) << ", positive "
            << (z[0] * r[0] > 0. && z[1] * r[1] > 0.) << ", leaves "
            << significant(remains, 2)
            << (remains <= 0.5 ? "" : " exceeds 1/2");

    StageMultigrid<dim, float> rounded(rounded_levels, field, tau);
    if (rows != nullptr)
      rounded.set_contact(rows);
    rounded.vmult(smoothed, r[0]);
    smoothed -= z[0];
    deallog << ", single precision "
            << within(smoothed.l2_norm() / z[0].l2_norm(), 1e-4);
    left = 0.;
    rounded.vmult(smoothed, left);
    deallog << (smoothed.linfty_norm() == 0. ? "" : ", of zero not zero");
  }
} // namespace ThermoContact

#endif
