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
  template <int dim>
  IterativeStage<dim>::IterativeStage(const Body<dim>          &body,
                                      std::vector<std::string> &warnings)
    : body(body)
    , warnings(warnings)
    , hierarchies(body)
  {
    for (BlockVector *vector :
         {&rhs, &solution, &measure.weights, &measure.inverses})
      vector->reinit(body.discretization.make_block_vector());
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
  IterativeStage<dim>::provide(const double stage_length)
  {
    hierarchies.provide(stage_length);
    if (system && tau == stage_length)
      return;
    tau = stage_length;
    system.reset();
    // of the unknowns (tau theta', v)
    system =
      std::make_unique<LinearSystem<dim>>(body.equations,
                                          stage_coefficients(tau).scaled(tau),
                                          nullptr,
                                          LinearSystem<dim>::Rows::all,
                                          &hierarchies);
  }



  template <int dim>
  void
  IterativeStage<dim>::prepare(const State               &known,
                               const double               stage_length,
                               const Vector              &heat_load,
                               const Vector              &momentum_load,
                               const std::vector<double> &pressure)
  {
    provide(stage_length);
    conductance.clear();
    Vector &heat     = rhs.block(Field::temperature);
    Vector &momentum = rhs.block(Field::displacement);
    body.equations.stage_rhs(
      known, tau, heat_load, momentum_load, heat, momentum);
    heat *= tau;

    solution = 0.;
    if (body.scene.fields.has_displacement)
      {
        Vector &v = solution.block(Field::displacement);
        v.copy_locally_owned_data_from(known.velocity);
        body.equations.zero_constrained(Field::displacement, v);
      }
    system->restart();
    system->set_conductance({});
    set_weights(known, pressure);
    if (body.scene.fields.has_temperature)
      {
        body.contact_end().get_values(Field::temperature,
                                      known.temperature,
                                      excess_temperature);
        load_time = known.load_time;
        for (unsigned int i = 0; i < excess_temperature.size(); ++i)
          excess_temperature[i] -= body.surroundings.temperature(i, load_time);
      }
  }



  template <int dim>
  void
  IterativeStage<dim>::push(const std::vector<double> &pressure)
  {
    body.contact_end().subtract_load(Field::displacement,
                                     pressure,
                                     tau,
                                     rhs.block(Field::displacement));
    system->restart();
  }



  template <int dim>
  void
  IterativeStage<dim>::set_springs(const std::vector<double> &springs,
                                   const std::vector<double> &relaxed)
  {
    system->set_springs(springs, relaxed);
    if (has_momentum_size || !body.scene.fields.has_displacement)
      return;
    // a body at rest that a moving obstacle meets: nothing else moves it
    Vector        rows(rhs.block(Field::displacement));
    const Vector &diagonal =
      hierarchies.current().diagonals[Field::displacement];
    rows = 0.;
    for (const auto &[node, entry] :
         body.contact_end().entries(Field::displacement))
      rows.local_element(entry) =
        std::min(springs[node], double(diagonal.local_element(entry))) *
        relaxed[node];
    set_momentum_size(momentum_sizes(rows));
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
    system->set_conductance(conductance);
  }



  template <int dim>
  std::vector<ExchangeConditions>
  IterativeStage<dim>::conditions() const
  {
    std::vector<double> change;
    body.contact_end().get_values(Field::temperature,
                                  solution.block(Field::temperature),
                                  change);
    std::vector<ExchangeConditions> all;
    for (unsigned int i = 0; i < change.size(); ++i)
      {
        const double surroundings = body.surroundings.temperature(i, load_time);
        all.push_back({surroundings + excess_temperature[i] + change[i],
                       surroundings,
                       load_time});
      }
    return all;
  }



  template <int dim>
  void
  IterativeStage<dim>::prepare_pressures()
  {
    rhs      = 0.;
    solution = 0.;
    system->restart();
  }



  template <int dim>
  void
  IterativeStage<dim>::restore(const double               stage_length,
                               const std::vector<double> &last_contact)
  {
    provide(stage_length);
    if (!last_contact.empty())
      hierarchies.set_springs(last_contact);
  }



  template <int dim>
  unsigned int
  IterativeStage<dim>::solve(const double tolerance, const Measure kind)
  {
    const auto result = system->solve(
      solution, rhs, measure, tolerance, kind == Measure::of_start);
    if (result.is_rounding && kind == Measure::of_terms &&
        result.residual > 2. * reported_rounding_)
      {
        reported_rounding_ = result.residual;
        warnings.push_back(
          text("Solver/Linear tolerance = ",
               body.scene.linear_solver.tolerance,
               ": rounding leaves ",
               significant(result.residual, 2),
               " of the forces and heat flows in a stage of length ",
               significant(tau, few_digits)));
      }
    return result.n;
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
    for (const Field::Block field : all_fields)
      if (body.discretization.has_field(field))
        set_roots(hierarchies.current().diagonals[field],
                  measure.inverses.block(field),
                  measure.weights.block(field));
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
      scratch.scale(measure.weights.block(Field::temperature));
      return scratch.l2_norm();
    };
    double size = std::max(norm(rhs.block(Field::temperature)),
                           norm(unsolved(Field::temperature)));
    // the terms may cancel in a steady state, and leave rounding
    Vector flow(scratch);
    body.equations.conduction.vmult(flow, known.temperature);
    size = std::max(size, tau * norm(flow));
    flow.copy_locally_owned_data_from(known.temperature);
    scale_by(hierarchies.levels()
               .field(hierarchies.levels().n_levels() - 1, Field::temperature)
               .stiffness,
             flow);
    size =
      std::max(size,
               tau * epsilon / body.scene.linear_solver.tolerance * norm(flow));
    if (size == 0.)
      return;
    measure.weights.block(Field::temperature) /= size;
    measure.inverses.block(Field::temperature) *= size;
  }



  template <int dim>
  typename IterativeStage<dim>::Sizes
  IterativeStage<dim>::momentum_sizes(const Vector &rows) const
  {
    const Vector &w      = measure.weights.block(Field::displacement);
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
    Sizes         sizes{};
    Vector        rows(rhs.block(Field::displacement));
    const Vector &at_start = unsolved(Field::displacement);
    for (const bool is_rhs : {true, false})
      {
        rows.copy_locally_owned_data_from(
          is_rhs ? rhs.block(Field::displacement) : at_start);
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

    set_momentum_size(sizes);
  }



  template <int dim>
  void
  IterativeStage<dim>::set_momentum_size(const Sizes &sizes)
  {
    has_momentum_size = sizes[0] > 0. || sizes[1] > 0.;
    if (!has_momentum_size)
      return;
    Vector &w     = measure.weights.block(Field::displacement);
    Vector &roots = measure.inverses.block(Field::displacement);
    for (unsigned int i = 0; i < w.locally_owned_size(); ++i)
      {
        const double own  = sizes[is_massless(i)];
        const double size = own > 0. ? own : sizes[!is_massless(i)];
        w.local_element(i) /= size;
        roots.local_element(i) *= size;
      }
  }



  template class IterativeStage<2>;
  template class IterativeStage<3>;
} // namespace ThermoContact
