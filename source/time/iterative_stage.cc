// SPDX-License-Identifier: LGPL-2.1-or-later

#include <thermocontact/base/exceptions.h>
#include <thermocontact/base/number_text.h>
#include <thermocontact/base/special_numbers.h>
#include <thermocontact/base/text.h>
#include <thermocontact/base/tolerances.h>
#include <thermocontact/time/iterative_stage.h>

#include <deal.II/base/mpi.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace ThermoContact
{
  namespace
  {
    /** Directions of a Krylov space that are kept. */
    constexpr unsigned int max_directions = 60;
  } // namespace



  template <int dim>
  IterativeStage<dim>::IterativeStage(const Body<dim>          &body,
                                      std::vector<std::string> &warnings)
    : body(body)
    , warnings(warnings)
    , hierarchies(body)
    , krylov(max_directions)
  {
    rhs.reinit(2);
    for (const Field::Block field : all_fields)
      rhs.block(field).reinit(body.discretization.make_vector(field));
    rhs.collect_sizes();
    // not assigned: an empty block, of a field that there is not, would keep
    // the communicator of one rank, and its sums be those of the first block
    for (BlockVector *vector : {&solution,
                                &residual,
                                &weights,
                                &inverse_weights,
                                &correction,
                                &scaled_residual})
      vector->reinit(rhs);
    springs.assign(body.contact_end().n_nodes(), 0.);
    if (body.scene.contact.has_massless_nodes &&
        body.scene.material.has_inertia())
      {
        massless_rows.assign(
          rhs.block(Field::displacement).locally_owned_size(), false);
        for (const auto &[node, entry] :
             body.contact_end().all_entries(Field::displacement))
          massless_rows[entry] = true;
      }
  }



  template <int dim>
  void
  IterativeStage<dim>::apply(BlockVector &y, const BlockVector &x) const
  {
    if (!has_heat)
      y.block(Field::temperature) = 0.;
    body.equations.product(coefficients,
                           x.block(Field::temperature),
                           x.block(Field::displacement),
                           y.block(Field::temperature),
                           y.block(Field::displacement));
    if (has_heat && !conductance.empty())
      for (const auto &[node, entry] :
           body.contact_end().entries(Field::temperature))
        y.block(Field::temperature).local_element(entry) +=
          conductance[node] * x.block(Field::temperature).local_element(entry);
  }



  template <int dim>
  void
  IterativeStage<dim>::compute_residual()
  {
    if (has_residual)
      return;
    apply(residual, solution);
    residual.sadd(-1., 1., rhs);
    has_residual = true;
  }



  template <int dim>
  void
  IterativeStage<dim>::prepare(const State               &known,
                               const double               stage_length,
                               const Vector              &heat_load,
                               const Vector              &momentum_load,
                               const std::vector<double> &pressure,
                               const bool                 with_heat)
  {
    hierarchies.provide(stage_length);
    tau          = stage_length;
    has_heat     = with_heat && body.scene.fields.has_temperature;
    coefficients = stage_coefficients(tau);
    // of the unknowns (tau theta', v), the first row times tau
    coefficients.heating *= tau;
    coefficients.thermal_stress /= tau;
    if (!has_heat)
      coefficients = coefficients.of(Field::displacement);
    conductance.clear();
    Vector &heat     = rhs.block(Field::temperature);
    Vector &momentum = rhs.block(Field::displacement);
    body.equations.stage_rhs(
      known, tau, heat_load, momentum_load, heat, momentum);
    heat *= tau;
    if (!has_heat)
      heat = 0.;

    solution     = 0.;
    has_residual = false;
    if (body.scene.fields.has_displacement)
      {
        Vector &v = solution.block(Field::displacement);
        v.copy_locally_owned_data_from(known.velocity);
        body.equations.zero_constrained(Field::displacement, v);
      }
    set_weights(known, pressure);
    largest_residual = 0.;
    if (has_heat)
      {
        body.contact_end().get_values(Field::temperature,
                                      known.temperature,
                                      excess_temperature);
        for (double &value : excess_temperature)
          value -= body.scene.heat.obstacle_temperature;
      }
  }



  template <int dim>
  void
  IterativeStage<dim>::set_exchange(const std::vector<double> &coefficient)
  {
    conductance.resize(coefficient.size(), 0.);
    std::vector<double> change(conductance);
    for (unsigned int i = 0; i < coefficient.size(); ++i)
      {
        conductance[i] =
          tau * body.contact_end().nodes()[i].weight * coefficient[i];
        change[i] -= conductance[i];
      }
    for (const auto &[node, entry] :
         body.contact_end().entries(Field::temperature))
      rhs.block(Field::temperature).local_element(entry) +=
        change[node] * excess_temperature[node];
    has_residual = false;
  }



  template <int dim>
  void
  IterativeStage<dim>::prepare_pressures()
  {
    rhs              = 0.;
    solution         = 0.;
    has_residual     = false;
    largest_residual = 0.;
  }



  template <int dim>
  void
  IterativeStage<dim>::set_interface(const std::vector<double> &start,
                                     const double               factor)
  {
    this->start  = start;
    this->factor = factor;
    laws.assign(start.size(), AffineLaw());
    springs.assign(start.size(), 0.);
  }



  template <int dim>
  std::vector<double>
  IterativeStage<dim>::receptances() const
  {
    std::vector<double> receptance(springs.size(), 1.);
    if (!body.scene.fields.has_displacement)
      return receptance; // nothing pushes
    body.contact_end().get_values(
      Field::displacement,
      hierarchies.current().diagonals[Field::displacement],
      receptance);
    for (unsigned int i = 0; i < receptance.size(); ++i)
      receptance[i] =
        factor * tau * body.contact_end().nodes()[i].weight / receptance[i];
    return receptance;
  }



  template <int dim>
  void
  IterativeStage<dim>::set_laws(const std::vector<AffineLaw> &new_laws)
  {
    laws = new_laws;
    for (unsigned int i = 0; i < laws.size(); ++i)
      springs[i] = laws[i].compliance == 0. ?
                     infinity :
                     factor * tau * body.contact_end().nodes()[i].weight /
                       laws[i].compliance;
    hierarchies.set_contact(springs);
    for (unsigned int i = 0; i < laws.size(); ++i)
      if (is_held(i))
        has_residual = false; // on all ranks, whoever has the node
    Vector &v = solution.block(Field::displacement);
    for (const auto &[node, entry] :
         body.contact_end().entries(Field::displacement))
      if (is_held(node))
        v.local_element(entry) = touching_velocity(node);
  }



  template <int dim>
  bool
  IterativeStage<dim>::has_contact() const
  {
    return !std::all_of(laws.begin(), laws.end(), [](const AffineLaw &law) {
      return law.is_open();
    });
  }



  template <int dim>
  void
  IterativeStage<dim>::restore(const double               stage_length,
                               const std::vector<double> &last_contact)
  {
    hierarchies.provide(stage_length);
    tau = stage_length;
    if (!last_contact.empty())
      hierarchies.set_contact(last_contact);
  }



  template <int dim>
  double
  IterativeStage<dim>::compute_scaled_residual()
  {
    compute_residual();
    scaled_residual        = residual;
    Vector       &r        = scaled_residual.block(Field::displacement);
    const Vector &v        = solution.block(Field::displacement);
    const Vector &w        = weights.block(Field::displacement);
    double        rounding = 0.;
    for (const auto &[node, entry] :
         body.contact_end().entries(Field::displacement))
      if (is_held(node))
        r.local_element(entry) = 0.;
      else if (springs[node] != 0.)
        {
          // what the spring does beside the body
          r.local_element(entry) -= spring_force(node, v.local_element(entry));
          const double size = std::max(std::abs(touching_velocity(node)),
                                       std::abs(v.local_element(entry)));
          rounding += Utilities::fixed_power<2>(w.local_element(entry) *
                                                springs[node] * size);
        }
    scaled_residual.scale(weights);
    return 4. * std::numeric_limits<double>::epsilon() *
           std::sqrt(Utilities::MPI::sum(rounding, r.get_mpi_communicator()));
  }



  template <int dim>
  unsigned int
  IterativeStage<dim>::solve(const double tolerance, const Measure measure)
  {
    double rounding = compute_scaled_residual();
    double reached  = scaled_residual.l2_norm();

    const double allowed =
      measure == Measure::of_terms ? tolerance : tolerance * reached;
    // velocities that a short stage prescribes have larger terms than all else
    largest_residual          = std::max(largest_residual, reached);
    unsigned int n_iterations = 0;
    // GMRES estimates its residual, and takes its rounding for progress: what
    // is left is computed, and once more is tried
    for (unsigned int attempt = 0; attempt < 2; ++attempt)
      {
        const FlexibleGmres::Result result = add_correction(allowed);
        n_iterations += result.n_iterations;
        rounding = compute_scaled_residual();
        reached  = scaled_residual.l2_norm();
        if (reached <=
            2. * allowed + rounding +
              Tolerances::rounding_of_sum * std::max(1., largest_residual))
          return n_iterations;
        if (result.residual > allowed)
          give_up(reached, allowed, n_iterations);
      }
    // nothing but rounding is left
    if (reached > Tolerances::loose_residual)
      give_up(reached, allowed, n_iterations);
    if (measure == Measure::of_terms && reached > 2. * told_rounding_)
      {
        told_rounding_ = reached;
        warnings.push_back(
          text("Solver/Linear tolerance = ",
               body.scene.linear_solver.tolerance,
               ": rounding leaves ",
               significant(reached, 2),
               " of the forces and heat flows in a stage of length ",
               significant(tau, few_digits)));
      }
    return n_iterations;
  }



  template <int dim>
  void
  IterativeStage<dim>::get_pressures(std::vector<double> &pressure)
  {
    const ContactEnd<dim> &end = body.contact_end();
    if (!has_contact())
      {
        pressure.assign(laws.size(), 0.);
        return;
      }
    compute_residual();
    const Vector &residual = this->residual.block(Field::displacement);
    const Vector &v        = solution.block(Field::displacement);
    const Vector &diagonal =
      hierarchies.current().diagonals[Field::displacement];
    Vector &forces = scaled_residual.block(Field::displacement);
    for (const auto &[node, entry] : end.entries(Field::displacement))
      {
        // Both agree where the stage is solved: the one that errors of the
        // solution change less, which for springs softer than the body is
        // theirs
        forces.local_element(entry) =
          springs[node] < diagonal.local_element(entry) ?
            spring_force(node, v.local_element(entry)) :
            residual.local_element(entry);
      }
    end.get_values(Field::displacement, forces, pressure);
    for (unsigned int i = 0; i < pressure.size(); ++i)
      pressure[i] =
        laws[i].is_open() ? 0. : pressure[i] / (tau * end.nodes()[i].weight);
  }



  template <int dim>
  void
  IterativeStage<dim>::get_positions(std::vector<double> &position) const
  {
    body.contact_end().get_values(Field::displacement,
                                  solution.block(Field::displacement),
                                  position);
    for (unsigned int i = 0; i < position.size(); ++i)
      position[i] =
        is_held(i) ? laws[i].offset : start[i] + factor * position[i];
  }



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
        body.equations.conduction.vmult(flow, known.temperature);
        size = std::max(size, tau * norm(flow));
        flow.copy_locally_owned_data_from(known.temperature);
        scale_by(hierarchies.levels()
                   .field(hierarchies.levels().n_levels() - 1,
                          Field::temperature)
                   .stiffness,
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
      {
        squares[is_massless(i)] += square(i);
        if (is_massless(i))
          squares[0] +=
            Utilities::fixed_power<2>(rows.local_element(i)) / largest_diagonal;
      }
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
    const MultigridLevels<dim, float> &levels = hierarchies.levels();
    const unsigned int                 finest = levels.n_levels() - 1;

    largest_diagonal = diagonal.linfty_norm();
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
    body.equations.stiffness.vmult(rows, known.displacement);
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



  namespace
  {
    constexpr unsigned int max_iterations = 300;
  } // namespace



  /** The stage matrix with contact, rows scaled. */
  template <int dim>
  class IterativeStage<dim>::Matrix
  {
  public:
    explicit Matrix(const IterativeStage &stage)
      : stage(stage)
    {}

    void
    vmult(BlockVector &y, const BlockVector &x) const
    {
      stage.apply(y, x);
      Vector       &y_u = y.block(Field::displacement);
      const Vector &x_u = x.block(Field::displacement);
      for (const auto &[node, entry] :
           stage.body.contact_end().entries(Field::displacement))
        if (stage.is_held(node))
          y_u.local_element(entry) = x_u.local_element(entry);
        else
          y_u.local_element(entry) +=
            stage.springs[node] * x_u.local_element(entry);
      y.scale(stage.weights);
    }

  private:
    const IterativeStage &stage;
  };



  /** V-cycles, the temperature first; rows scaled back. */
  template <int dim>
  class IterativeStage<dim>::Preconditioner
  {
  public:
    /** @param scratch of the layout of the unknowns; both are borrowed */
    Preconditioner(const IterativeStage &stage, BlockVector &scratch)
      : stage(stage)
      , rhs(scratch.block(Field::displacement))
      , heat_rhs(scratch.block(Field::temperature))
    {}

    void
    vmult(BlockVector &z, const BlockVector &r) const
    {
      const auto &hierarchy = stage.hierarchies.current();
      const bool  has_heat  = hierarchy.heat && stage.has_heat;
      Vector     &z_theta   = z.block(Field::temperature);
      if (has_heat)
        {
          heat_rhs.copy_locally_owned_data_from(r.block(Field::temperature));
          heat_rhs.scale(stage.inverse_weights.block(Field::temperature));
          hierarchy.heat->vmult(z_theta, heat_rhs);
        }
      else
        z_theta = 0.;
      if (!hierarchy.momentum)
        return;
      rhs.copy_locally_owned_data_from(r.block(Field::displacement));
      rhs.scale(stage.inverse_weights.block(Field::displacement));
      if (has_heat)
        {
          stage.body.equations.add_thermal_stress(z_theta, stage.tau, rhs);
          // held rows keep their residual, which is zero
          for (const auto &[node, entry] :
               stage.body.contact_end().entries(Field::displacement))
            if (stage.is_held(node))
              rhs.local_element(entry) = 0.;
        }
      hierarchy.momentum->vmult(z.block(Field::displacement), rhs);
    }

  private:
    const IterativeStage &stage;
    Vector               &rhs;
    Vector               &heat_rhs;
  };



  template <int dim>
  FlexibleGmres::Result
  IterativeStage<dim>::add_correction(const double tolerance)
  {
    has_residual = false; // its place is used
    const FlexibleGmres::Result result =
      krylov.solve(Matrix(*this),
                   Preconditioner(*this, residual),
                   tolerance,
                   max_iterations,
                   scaled_residual,
                   correction);
    solution += correction;
    return result;
  }



  template <int dim>
  void
  IterativeStage<dim>::give_up(const double       residual,
                               const double       tolerance,
                               const unsigned int n_iterations) const
  {
    throw ComputationError(
      text("the iterative solver reached a relative residual of ",
           significant(residual, few_digits),
           " instead of ",
           significant(tolerance, few_digits),
           " in ",
           n_iterations,
           " iterations, for a stage of length ",
           significant(tau, few_digits),
           "\n  remedy:  Solver/Linear solver = direct, a larger "
           "Solver/Linear tolerance, cells that are cubes, a larger "
           "Contact/Compliance, or a Model/Poisson ratio farther from 1/2"));
  }



  template class IterativeStage<2>;
  template class IterativeStage<3>;
} // namespace ThermoContact
