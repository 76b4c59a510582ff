// SPDX-License-Identifier: LGPL-2.1-or-later

#include <thermocontact/time/iterative_stage.h>

#include <deal.II/base/mpi.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace ThermoContact
{
  namespace
  {
    constexpr double epsilon = std::numeric_limits<double>::epsilon();

    /** @p roots of the diagonal of a block, and one over them. */
    void
    set_roots(const Vector &diagonal, Vector &roots, Vector &weights)
    {
      roots.copy_locally_owned_data_from(diagonal);
      for (unsigned int i = 0; i < roots.locally_owned_size(); ++i)
        {
          roots.local_element(i)   = std::sqrt(roots.local_element(i));
          weights.local_element(i) = 1. / roots.local_element(i);
        }
    }



    void
    scale_by(const LevelVector<float> &factors, Vector &vector)
    {
      for (unsigned int i = 0; i < vector.locally_owned_size(); ++i)
        vector.local_element(i) *= factors.local_element(i);
    }



    void
    raise_to(std::array<double, 2>       &sizes,
             const std::array<double, 2> &others,
             const double                 factor = 1.)
    {
      for (unsigned int i = 0; i < sizes.size(); ++i)
        sizes[i] = std::max(sizes[i], factor * others[i]);
    }
  } // namespace



  template <int dim>
  void
  IterativeStage<dim>::set_weights(const State               &known,
                                   const std::vector<double> &pressure)
  {
    compute_residual();
    for (const Field::Block field : all_fields)
      if (body.discretization.has_field(field))
        set_roots(hierarchies.current().diagonals[field],
                  inverse_weights.block(field),
                  weights.block(field));
    if (body.scene.fields.has_temperature)
      set_heat_weights(known);
    if (body.scene.fields.has_displacement)
      set_momentum_weights(known, pressure);
  }



  template <int dim>
  void
  IterativeStage<dim>::set_heat_weights(const State &known)
  {
    Vector     scratch(rhs.block(Field::temperature));
    const auto norm = [&](const Vector &rows) {
      scratch.copy_locally_owned_data_from(rows);
      scratch.scale(weights.block(Field::temperature));
      return scratch.l2_norm();
    };
    double size = std::max(norm(rhs.block(Field::temperature)),
                           norm(residual.block(Field::temperature)));
    if (has_heat)
      {
        // the terms may cancel in a steady state, and leave rounding
        Vector flow(scratch);
        body.equations.conduction().vmult(flow, known.temperature);
        size = std::max(size, tau * norm(flow));
        flow.copy_locally_owned_data_from(known.temperature);
        scale_by(
          levels.field(levels.n_levels() - 1, Field::temperature).stiffness,
          flow);
        size = std::max(size,
                        tau * epsilon / body.scene.linear_solver.tolerance *
                          norm(flow));
      }
    if (size == 0.)
      return;
    weights.block(Field::temperature) /= size;
    inverse_weights.block(Field::temperature) *= size;
  }



  template <int dim>
  typename IterativeStage<dim>::Sizes
  IterativeStage<dim>::momentum_sizes(const Vector &rows) const
  {
    const Vector &w      = weights.block(Field::displacement);
    const auto    square = [&](const unsigned int i) {
      return Utilities::fixed_power<2>(w.local_element(i) *
                                       rows.local_element(i));
    };
    Sizes squares{};
    for (unsigned int i = 0; i < rows.locally_owned_size(); ++i)
      squares[is_massless(i)] += square(i);
    Sizes sizes;
    for (unsigned int i = 0; i < sizes.size(); ++i)
      sizes[i] =
        std::sqrt(Utilities::MPI::sum(squares[i], rows.get_mpi_communicator()));
    return sizes;
  }



  template <int dim>
  void
  IterativeStage<dim>::set_momentum_weights(const State               &known,
                                            const std::vector<double> &pressure)
  {
    const Material &material = body.scene.material;
    const Vector   &diagonal =
      hierarchies.current().diagonals[Field::displacement];
    const unsigned int finest = levels.n_levels() - 1;

    // Forces that move something: those beside the pressure that is there.
    Sizes  sizes{};
    Vector rows(rhs.block(Field::displacement));
    for (const BlockVector *terms : {&rhs, &residual})
      {
        rows.copy_locally_owned_data_from(terms->block(Field::displacement));
        body.contact_end().subtract_load(Field::displacement,
                                         pressure,
                                         tau,
                                         rows);
        body.equations.zero_constrained(Field::displacement, rows);
        raise_to(sizes, momentum_sizes(rows));
      }
    // At rest they cancel. The force inside of the body is what a body with
    // inertia or viscosity responds to. Without, in a stage that is shorter
    // than the time of its motion, it is balanced already, and an error of its
    // size is one of u/tau in the velocity: then the part that displaces by u
    // in a unit of time, that of diffusion.
    body.equations.stiffness().vmult(rows, known.displacement);
    const double slow     = tau + material.viscosity;
    const Sizes  internal = momentum_sizes(rows);
    raise_to(sizes,
             {{std::min(1., slow + std::sqrt(material.inertia)) * internal[0],
               std::min(1., slow) * internal[1]}},
             tau);
    // Contact nodes without mass follow the others, whose velocity they have.
    rows.copy_locally_owned_data_from(known.velocity);
    rows.scale(diagonal);
    raise_to(sizes, {{0., momentum_sizes(rows)[1]}});
    // Nothing is solved for that is rounding of the right-hand side.
    rows.copy_locally_owned_data_from(known.displacement);
    scale_by(levels.field(finest, Field::displacement).stiffness, rows);
    raise_to(sizes,
             momentum_sizes(rows),
             tau * epsilon / body.scene.linear_solver.tolerance);

    Vector &w     = weights.block(Field::displacement);
    Vector &roots = inverse_weights.block(Field::displacement);
    for (unsigned int i = 0; i < w.locally_owned_size(); ++i)
      {
        const double own  = sizes[is_massless(i)];
        const double size = own > 0. ? own : sizes[!is_massless(i)];
        if (size == 0.)
          return;
        w.local_element(i) /= size;
        roots.local_element(i) *= size;
      }
  }



  template void
  IterativeStage<2>::set_weights(const State &, const std::vector<double> &);
  template void
  IterativeStage<3>::set_weights(const State &, const std::vector<double> &);
} // namespace ThermoContact
