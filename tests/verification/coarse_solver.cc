// SPDX-License-Identifier: LGPL-2.1-or-later
//
// Coarser grids, and V-cycles of a strip with an odd number of graded, flat
// cells that hardly changes its volume. On one rank and on two.
//
// 1. Grids by hand, as distances between nodes. Of 5 x 2 squares of degree 2,
//    which have 10 x 4, two become one and one stays alone: 6 x 2; then it is
//    joined with the next one, 4 x 2, 2 x 2. Of 8 x 2 cells eight times as wide
//    as long those along the body become one until they are squares: 1 x 2.
//    64 cells of a thin rod become 32: others would be longer than 4 widths.
//    Of 8 x 1 cells 1, 1.10, 1.22, 1.35, 1.49, 1.64, 1.81, 2 long none are
//    joined up to a length of 2 (1), up to 2.5 two are, which leaves more than
//    0.8 of 18 nodes; up to 3.125 two pairs (2.10, 2.56). Of these six up to
//    4.64 two pairs (4.05, 3.45), of 2.10, 4.05, 3.45, 2 up to 6.25 all.
//    Factors of (4, 2; 2, 1, 3; 3, 20) with pivots of no less than a tenth of
//    the diagonal: 4, 1 - 1 becomes 0.1, 20 - 9/0.1 becomes 2, beside them 1/2
//    and 30, so that x = (1, 2, 3) is from (8, 4 + 9.2, 30 9.2 + 6).
// 2. As preconditioners the cycles are what others are (matrix_free.cc):
//    symmetric to 1e-10, positive, and half of an error is left at most;
//    without contact, with springs and with held nodes. In single precision
//    they are the same to 1e-4.
// 3. Made again for the same stage, and with the same contact after another
//    one, they give the same bytes: a run that goes on from a checkpoint makes
//    them again.
// 4. What is held gets no correction.
// 5. Of four stage lengths those that were used last stay. Springs of contact
//    nodes are those that are there while none is twice or half as stiff, zero
//    or held where the other is not; behind contact that has ended the last
//    ones. The cycle is the one with these rows.

#include <thermocontact/base/exceptions.h>
#include <thermocontact/multigrid/band_factors.h>
#include <thermocontact/multigrid/stage_hierarchies.h>

#include <deal.II/base/mpi.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "../cycle.h"

using namespace ThermoContact;

namespace
{
  using ThermoContact::Vector;

  void
  show_grids(const unsigned int cells,
             const unsigned int cells_across,
             const double       width,
             const unsigned int degree,
             const double       grading = 1.)
  {
    MeshParameters mesh;
    mesh.cells        = cells;
    mesh.cells_across = cells_across;
    mesh.width        = width;
    mesh.degree       = degree;
    mesh.grading      = grading;
    for (std::optional<LevelGrid<2>> grid = LevelGrid<2>(mesh); grid;
         grid                             = grid->coarsened())
      deallog << grid->positions(0).size() - 1 << " x "
              << grid->positions(1).size() - 1 << "; ";
    deallog << std::endl;
  }



  void
  test_factors()
  {
    for (const double smallest : {0.1, 0.})
      {
        BandFactors factors(3, 1);
        factors.entry(0, 0) = 4.;
        factors.entry(1, 0) = 2.;
        factors.entry(1, 1) = 1.;
        factors.entry(2, 1) = 3.;
        factors.entry(2, 2) = 20.;
        std::vector<double> x{8., 13.2, 282.};
        try
          {
            factors.factorize(smallest);
            factors.solve(x);
            for (unsigned int i = 0; i < 3; ++i)
              deallog << factors.entry(i, i) << ' ' << x[i] << "; ";
          }
        catch (const ComputationError &)
          {
            deallog << "not positive" << std::endl;
          }
      }
  }



  Parameters
  graded_strip()
  {
    Parameters parameters;
    parameters.dimension              = 2;
    parameters.mesh.degree            = 2;
    parameters.mesh.cells             = 41;
    parameters.mesh.cells_across      = 9;
    parameters.mesh.width             = 1.;
    parameters.mesh.grading           = 8.;
    parameters.boundary.sides.support = "free";
    parameters.contact.massless_nodes = "off";
    parameters.model.poisson_ratio    = 0.499; // with subspaces
    parameters.solver.linear_solver   = "iterative";
    return parameters;
  }



  /** What a cycle makes of a fixed vector. */
  Vector
  result(const StageMultigrid<2, float> &cycle,
         const Body<2>                  &body,
         const Field::Block              field,
         const ContactRows              *rows)
  {
    Vector r = body.discretization.make_vector(field), z(r);
    for (unsigned int j = 0; j < r.locally_owned_size(); ++j)
      r.local_element(j) = std::sin(1. + 0.3 * j * j);
    for (const unsigned int entry :
         body.discretization.constrained_entries(field))
      r.local_element(entry) = 0.;
    if (rows != nullptr && rows->held.size() > 0)
      for (unsigned int j = 0; j < r.locally_owned_size(); ++j)
        if (rows->held.local_element(j) > 0.)
          r.local_element(j) = 0.;
    cycle.vmult(z, r);
    return z;
  }



  /** Number of entries that differ, on all ranks. */
  unsigned int
  n_different(const Vector &a, const Vector &b)
  {
    unsigned int n = 0;
    for (unsigned int i = 0; i < a.locally_owned_size(); ++i)
      n += a.local_element(i) != b.local_element(i);
    return Utilities::MPI::sum(n, MPI_COMM_WORLD);
  }



  void
  test_repetition(const Body<2>                   &body,
                  const MultigridLevels<2, float> &levels,
                  const Field::Block               field,
                  const double                     tau,
                  const ContactRows               *rows,
                  const ContactRows               *others)
  {
    StageMultigrid<2, float> first(levels, field, tau),
      second(levels, field, tau);
    if (rows != nullptr)
      {
        first.set_contact(rows);
        second.set_contact(others);
        second.set_contact(nullptr);
        second.set_contact(rows);
      }
    const Vector z = result(first, body, field, rows);
    deallog << ", made again, entries that differ: "
            << n_different(z, result(second, body, field, rows));
    second.set_contact(nullptr);
    if (rows != nullptr)
      second.set_contact(rows, true);
    deallog << " and " << n_different(z, result(second, body, field, rows));
    if (rows == nullptr || rows->held.size() == 0)
      return;
    unsigned int n_moved = 0;
    for (unsigned int i = 0; i < z.locally_owned_size(); ++i)
      n_moved += rows->held.local_element(i) > 0. && z.local_element(i) != 0.;
    deallog << ", held ones that move: "
            << Utilities::MPI::sum(n_moved, MPI_COMM_WORLD);
  }



  void
  test_hierarchies(const Body<2> &body)
  {
    StageHierarchies<2> hierarchies(body);
    deallog << "made:";
    for (const double tau : {1., 2., 3., 4., 1., 5., 1., 2.})
      {
        hierarchies.provide(tau);
        deallog << ' ' << hierarchies.n_made();
        if (hierarchies.current().tau != tau)
          deallog << " of another length";
      }
    deallog << ", and for contact";
    std::vector<double> springs(body.contact_end().n_nodes());
    const double        held = std::numeric_limits<double>::infinity();
    const auto          set  = [&](const double first, const double second) {
      springs[0] = first;
      springs[1] = second;
      hierarchies.set_springs(springs);
      deallog << ' ' << hierarchies.n_made();
    };
    set(0., 0.);
    set(3., 0.);
    set(5.9, 0.); // as 3
    set(6.1, 0.);
    set(3., 0.);
    set(1.6, 0.); // as 3
    set(3., 3.);
    set(3., 0.);
    set(0., 0.);
    set(4., 0.); // as 3
    set(7., 0.);
    set(held, 0.);
    set(held, 0.);
    for (const bool is_rigid : {false, true})
      {
        const ContactRows rows   = contact_rows(body, is_rigid, 2.);
        const Vector     &values = is_rigid ? rows.held : rows.springs;
        body.contact_end().get_values(Field::displacement, values, springs);
        for (double &spring : springs)
          spring = is_rigid && spring > 0. ? held : spring;
        hierarchies.set_springs(springs);
        StageMultigrid<2, float> cycle(hierarchies.levels(),
                                       Field::displacement,
                                       2.);
        cycle.set_contact(&rows);
        deallog << (is_rigid ? ", held: " : ", entries that differ, springs: ")
                << n_different(result(*hierarchies.current().momentum,
                                      body,
                                      Field::displacement,
                                      &rows),
                               result(cycle, body, Field::displacement, &rows));
      }
    deallog << std::endl;
  }
} // namespace



void
main_coarse_solver()
{
  initlog();
  show_grids(5, 2, 0.4, 2);
  show_grids(8, 2, 2., 1);
  show_grids(64, 1, 0.01, 1);
  show_grids(8, 1, 1., 1, 0.5);
  test_factors();
  const Scene                      scene(graded_strip());
  const Body<2>                    body(scene, MPI_COMM_WORLD);
  const MultigridLevels<2, double> levels(body);
  const MultigridLevels<2, float>  rounded(body);
  for (const double tau : {1e-3, 0.1})
    {
      const ContactRows springs = contact_rows(body, false, tau);
      const ContactRows held    = contact_rows(body, true, tau);
      const auto        test    = [&](const std::string &name,
                            const Field::Block field,
                            const ContactRows *rows,
                            const ContactRows *others) {
        deallog << "tau = " << tau << ", " << name << ':';
        test_cycle<2>(body, levels, rounded, field, tau, rows);
        test_repetition(body, rounded, field, tau, rows, others);
        deallog << std::endl;
      };
      test("heat", Field::temperature, nullptr, nullptr);
      test("momentum", Field::displacement, nullptr, nullptr);
      test("springs", Field::displacement, &springs, &held);
      test("held", Field::displacement, &held, &springs);
    }
  test_hierarchies(body);
}
