// SPDX-License-Identifier: LGPL-2.1-or-later

#include <thermocontact/base/exceptions.h>
#include <thermocontact/base/number_text.h>
#include <thermocontact/base/stop_watch.h>
#include <thermocontact/base/text.h>
#include <thermocontact/time/iterative_solver.h>

#include <deal.II/lac/solver_control.h>
#include <deal.II/lac/solver_gmres.h>

#include <algorithm>
#include <cmath>

namespace ThermoContact
{
  namespace
  {
    /** Hierarchies that are kept: step sizes come back. */
    constexpr unsigned int max_hierarchies = 4;

    /** Relative residual while the set of active nodes still changes. */
    constexpr double loose_tolerance = 1e-5;

    constexpr unsigned int max_iterations  = 300;
    constexpr unsigned int max_block_sets  = 20;
    constexpr unsigned int max_single_sets = 200;
  } // namespace



  /** The stage matrix with contact, rows scaled. */
  template <int dim>
  class IterativeSolver<dim>::Matrix
  {
  public:
    explicit Matrix(const IterativeSolver &solver)
      : solver(solver)
    {}

    void
    vmult(BlockVector &y, const BlockVector &x) const
    {
      const Stage &stage = solver.stage;
      solver.apply(y, x);
      Vector       &y_u = y.block(Field::displacement);
      const Vector &x_u = x.block(Field::displacement);
      for (const auto &[node, entry] :
           solver.body.contact_end().entries(Field::displacement))
        if (stage.is_active[node])
          {
            if (stage.contact.held.size() > 0)
              y_u.local_element(entry) = x_u.local_element(entry);
            else
              y_u.local_element(entry) +=
                stage.contact.springs.local_element(entry) *
                x_u.local_element(entry);
          }
      y.scale(stage.weights);
    }

  private:
    const IterativeSolver &solver;
  };



  /** V-cycles, the temperature first; rows scaled back. */
  template <int dim>
  class IterativeSolver<dim>::Preconditioner
  {
  public:
    explicit Preconditioner(const IterativeSolver &solver)
      : solver(solver)
      , rhs(solver.stage.rhs.block(Field::displacement))
      , heat_rhs(solver.stage.rhs.block(Field::temperature))
    {}

    void
    vmult(BlockVector &z, const BlockVector &r) const
    {
      const Stage     &stage     = solver.stage;
      const Hierarchy &hierarchy = solver.hierarchies.front();
      const bool       has_heat  = hierarchy.heat && stage.has_heat;
      Vector          &z_theta   = z.block(Field::temperature);
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
          solver.body.equations.add_thermal_stress(z_theta, stage.tau, rhs);
          // held rows keep their residual, which is zero
          for (const auto &[node, entry] :
               solver.body.contact_end().entries(Field::displacement))
            if (stage.is_active[node] && stage.contact.held.size() > 0)
              rhs.local_element(entry) = 0.;
        }
      hierarchy.momentum->vmult(z.block(Field::displacement), rhs);
    }

  private:
    const IterativeSolver &solver;
    mutable Vector         rhs;
    mutable Vector         heat_rhs;
  };



  template <int dim>
  IterativeSolver<dim>::IterativeSolver(const Body<dim> &body)
    : body(body)
    , levels(body)
  {
    stage.rhs.reinit(2);
    for (const Field::Block field : all_fields)
      stage.rhs.block(field) = body.discretization.make_vector(field);
    stage.rhs.collect_sizes();
    stage.solution        = stage.rhs;
    stage.residual        = stage.rhs;
    stage.weights         = stage.rhs;
    stage.inverse_weights = stage.rhs;
    correction            = stage.rhs;
    scaled_residual       = stage.rhs;
    stage.is_active.assign(body.contact_end().n_nodes(), false);
  }



  template <int dim>
  types::global_dof_index
  IterativeSolver<dim>::n_factorized_unknowns() const
  {
    return std::max(levels.discretization(0).n_temperature_dofs(),
                    levels.discretization(0).n_displacement_dofs());
  }



  template <int dim>
  void
  IterativeSolver<dim>::provide_hierarchy(const double tau)
  {
    const auto known =
      std::find_if(hierarchies.begin(),
                   hierarchies.end(),
                   [tau](const Hierarchy &h) { return h.tau == tau; });
    if (known != hierarchies.end())
      {
        hierarchies.splice(hierarchies.begin(), hierarchies, known);
        return;
      }
    const StopWatch watch(counters_.factorization_seconds);
    while (hierarchies.size() >= max_hierarchies)
      hierarchies.pop_back();
    hierarchies.push_front({tau, nullptr, nullptr, {}});
    Hierarchy         &hierarchy = hierarchies.front();
    const unsigned int finest    = levels.n_levels() - 1;
    for (const Field::Block field : all_fields)
      if (body.discretization.has_field(field))
        {
          auto &multigrid =
            field == Field::temperature ? hierarchy.heat : hierarchy.momentum;
          multigrid = std::make_unique<StageMultigrid<dim>>(levels, field, tau);
          hierarchy.diagonals[field] =
            StageBlock<dim>(levels, finest, field, tau).diagonal();
        }
    ++counters_.factorizations;
  }



  template <int dim>
  RetainedFactorizations
  IterativeSolver<dim>::retained() const
  {
    RetainedFactorizations retained;
    retained.counters = counters_;
    for (const Hierarchy &hierarchy : hierarchies)
      {
        retained.taus.push_back(hierarchy.tau);
        retained.has_response.push_back(false);
      }
    return retained;
  }



  template <int dim>
  void
  IterativeSolver<dim>::restore(const RetainedFactorizations &retained)
  {
    hierarchies.clear();
    for (unsigned int i = retained.taus.size(); i-- > 0;)
      provide_hierarchy(retained.taus[i]);
    counters_ = retained.counters;
  }



  template <int dim>
  void
  IterativeSolver<dim>::apply(BlockVector &y, const BlockVector &x) const
  {
    const ThermoviscoelasticOperator<dim> &equations = body.equations;
    const Material                        &material  = body.scene.material;
    const double                           tau       = stage.tau;
    const bool has_heat   = body.scene.fields.has_temperature && stage.has_heat;
    Vector    &y_theta    = y.block(Field::temperature);
    Vector    &y_u        = y.block(Field::displacement);
    const Vector &x_theta = x.block(Field::temperature);
    const Vector &x_u     = x.block(Field::displacement);
    if (has_heat)
      {
        equations.matrix_free()->heat({1., tau}, y_theta, x_theta);
        // - (-a D v) times tau
        if (material.has_heating())
          {
            y_theta *= -1. / tau;
            equations.subtract_heating(x_u, y_theta);
            y_theta *= -tau;
          }
        equations.zero_constrained(Field::temperature, y_theta);
      }
    else
      y_theta = 0.;
    if (!body.scene.fields.has_displacement)
      return;
    equations.matrix_free()->momentum(
      {material.inertia, tau * tau, tau * material.viscosity}, y_u, x_u);
    if (has_heat)
      equations.add_thermal_stress(x_theta, -tau, y_u);
    equations.zero_constrained(Field::displacement, y_u);
  }



  template <int dim>
  void
  IterativeSolver<dim>::compute_residual()
  {
    apply(stage.residual, stage.solution);
    stage.residual.sadd(-1., 1., stage.rhs);
  }



  template <int dim>
  void
  IterativeSolver<dim>::prepare(const State  &known,
                                const double  tau,
                                const Vector &heat_load,
                                const Vector &momentum_load)
  {
    provide_hierarchy(tau);
    stage.tau   = tau;
    stage.known = &known;
    body.contact_end().get_penetrations(known.displacement,
                                        stage.known_penetration);
    Vector &heat     = stage.rhs.block(Field::temperature);
    Vector &momentum = stage.rhs.block(Field::displacement);
    body.equations.stage_rhs(
      known, tau, heat_load, momentum_load, heat, momentum);
    heat *= tau;
    if (!stage.has_heat)
      heat = 0.;

    stage.solution = 0.;
    if (body.scene.fields.has_displacement)
      {
        Vector &v = stage.solution.block(Field::displacement);
        v.copy_locally_owned_data_from(known.velocity);
        body.equations.zero_constrained(Field::displacement, v);
      }
    set_weights(known, tau);
  }



  template <int dim>
  void
  IterativeSolver<dim>::set_weights(const State &known, const double tau)
  {
    // Residuals are compared to the terms of the equations, whose sum may
    // vanish where a body is at rest, and by rows, since those of contact nodes
    // without mass are of the order of the square of a short stage.
    compute_residual();
    for (const Field::Block field : all_fields)
      {
        if (!body.discretization.has_field(field))
          continue;
        Vector &weights = stage.weights.block(field);
        Vector &roots   = stage.inverse_weights.block(field);
        roots.copy_locally_owned_data_from(
          hierarchies.front().diagonals[field]);
        for (unsigned int i = 0; i < roots.locally_owned_size(); ++i)
          {
            roots.local_element(i)   = std::sqrt(roots.local_element(i));
            weights.local_element(i) = 1. / roots.local_element(i);
          }
        Vector     scratch(weights);
        const auto norm = [&](const Vector &vector) {
          scratch.copy_locally_owned_data_from(vector);
          scratch.scale(weights);
          return scratch.l2_norm();
        };
        double size = std::max(norm(stage.rhs.block(field)),
                               norm(stage.residual.block(field)));
        if (field == Field::displacement || stage.has_heat)
          {
            Vector internal(scratch);
            if (field == Field::temperature)
              body.equations.conduction().vmult(internal, known.temperature);
            else
              body.equations.stiffness().vmult(internal, known.displacement);
            size = std::max(size, tau * norm(internal));
          }
        if (size == 0.)
          continue;
        weights /= size;
        roots *= size;
      }
  }



  template <int dim>
  void
  IterativeSolver<dim>::set_active(const std::vector<bool> &is_active)
  {
    const ContactEnd<dim> &end = body.contact_end();
    stage.is_active            = is_active;
    stage.contact              = ContactRows();
    const bool has_contact =
      std::find(is_active.begin(), is_active.end(), true) != is_active.end();
    if (hierarchies.front().momentum == nullptr)
      return;
    if (!has_contact)
      {
        hierarchies.front().momentum->set_contact(nullptr);
        return;
      }
    Vector &rows =
      body.law().is_rigid() ? stage.contact.held : stage.contact.springs;
    rows      = body.discretization.make_vector(Field::displacement);
    Vector &v = stage.solution.block(Field::displacement);
    for (const auto &[node, entry] : end.entries(Field::displacement))
      if (is_active[node])
        {
          const double tangent = body.law().tangent(0.);
          rows.local_element(entry) =
            body.law().is_rigid() ?
              1. :
              stage.tau * stage.tau * end.nodes()[node].weight / tangent;
          if (body.law().is_rigid())
            v.local_element(entry) = -stage.known_penetration[node] / stage.tau;
        }
    hierarchies.front().momentum->set_contact(&stage.contact);
  }



  template <int dim>
  void
  IterativeSolver<dim>::solve_linear(const double tolerance)
  {
    const ContactEnd<dim> &end = body.contact_end();
    compute_residual();
    scaled_residual = stage.residual;
    Vector       &r = scaled_residual.block(Field::displacement);
    const Vector &v = stage.solution.block(Field::displacement);
    for (const auto &[node, entry] : end.entries(Field::displacement))
      if (stage.is_active[node])
        {
          if (body.law().is_rigid())
            r.local_element(entry) = 0.;
          else // what the spring does beside the body
            r.local_element(entry) -=
              stage.contact.springs.local_element(entry) *
              (v.local_element(entry) +
               stage.known_penetration[node] / stage.tau);
        }
    scaled_residual.scale(stage.weights);

    SolverControl            control(max_iterations, tolerance, false, false);
    SolverGMRES<BlockVector> gmres(
      control, typename SolverGMRES<BlockVector>::AdditionalData(60, true));
    correction = 0.;
    try
      {
        gmres.solve(Matrix(*this),
                    correction,
                    scaled_residual,
                    Preconditioner(*this));
      }
    catch (const SolverControl::NoConvergence &)
      {
        throw ComputationError(
          text("the iterative solver reached a relative residual of ",
               significant(control.last_value(), few_digits),
               " instead of ",
               significant(tolerance, few_digits),
               " in ",
               control.last_step(),
               " iterations, for a stage of length ",
               significant(stage.tau, few_digits),
               "\n  remedy:  Solver/Linear solver = direct, cells that are "
               "cubes, a larger Contact/Compliance, or a Model/Poisson ratio "
               "farther from 1/2"));
      }
    stage.solution += correction;
    counters_.linear_iterations += control.last_step();
    counters_.max_linear_iterations =
      std::max(counters_.max_linear_iterations, control.last_step());
    compute_residual();
  }



  template <int dim>
  void
  IterativeSolver<dim>::get_pressures(std::vector<double> &pressure)
  {
    const ContactEnd<dim> &end      = body.contact_end();
    const Vector          &residual = stage.residual.block(Field::displacement);
    const Vector          &v        = stage.solution.block(Field::displacement);
    const Vector          &springs  = stage.contact.springs;
    const Vector &diagonal = hierarchies.front().diagonals[Field::displacement];
    Vector       &forces   = scaled_residual.block(Field::displacement);
    for (const auto &[node, entry] : end.entries(Field::displacement))
      {
        // Both agree where the stage is solved: the one that errors of the
        // solution change less, which for springs softer than the body is
        // theirs
        const bool is_soft =
          springs.size() > 0 &&
          springs.local_element(entry) < diagonal.local_element(entry);
        forces.local_element(entry) =
          is_soft ? springs.local_element(entry) *
                      (v.local_element(entry) +
                       stage.known_penetration[node] / stage.tau) :
                    residual.local_element(entry);
      }
    end.get_values(Field::displacement, forces, pressure);
    for (unsigned int i = 0; i < pressure.size(); ++i)
      pressure[i] = stage.is_active[i] ?
                      pressure[i] / (stage.tau * end.nodes()[i].weight) :
                      0.;
  }



  template <int dim>
  bool
  IterativeSolver<dim>::update_set(const std::vector<double> &pressure,
                                   const bool                 only_the_first,
                                   std::vector<bool>         &is_active) const
  {
    std::vector<double> reach;
    body.contact_end().get_values(Field::displacement,
                                  stage.solution.block(Field::displacement),
                                  reach);
    double largest_pressure = 0., largest_reach = 0.;
    for (unsigned int i = 0; i < reach.size(); ++i)
      {
        reach[i]         = stage.known_penetration[i] + stage.tau * reach[i];
        largest_pressure = std::max(largest_pressure, std::abs(pressure[i]));
        largest_reach    = std::max(largest_reach, std::abs(reach[i]));
      }
    // A node that touches without pressure must not flip for ever.
    const double rounding = 1e-13;
    bool         changed  = false;
    for (unsigned int i = 0; i < reach.size() && !(changed && only_the_first);
         ++i)
      if (is_active[i] ? pressure[i] < -rounding * largest_pressure :
                         reach[i] > rounding * largest_reach)
        {
          is_active[i] = !is_active[i];
          changed      = true;
        }
    return changed;
  }



  template <int dim>
  void
  IterativeSolver<dim>::solve_prepared(const ContactMode mode,
                                       StageRates       &rates)
  {
    const unsigned int n         = body.contact_end().n_nodes();
    const double       tolerance = body.scene.linear_solver.tolerance;
    rates.failure.clear();
    rates.pressure.assign(n, 0.);
    std::vector<bool> is_active(n, false);
    if (body.law().is_active() && mode != ContactMode::open)
      for (unsigned int i = 0; i < n; ++i)
        is_active[i] =
          mode == ContactMode::closed || stage.known->contact_pressure[i] > 0.;
    stage.n_sets = 0;
    set_active(is_active);
    if (!body.law().is_active() || mode != ContactMode::unilateral)
      {
        solve_linear(tolerance);
        get_pressures(rates.pressure);
        return;
      }
    double present_tolerance = std::max(tolerance, loose_tolerance);
    while (true)
      {
        ++stage.n_sets;
        solve_linear(present_tolerance);
        get_pressures(rates.pressure);
        if (update_set(rates.pressure,
                       stage.n_sets > max_block_sets,
                       is_active))
          set_active(is_active);
        else if (present_tolerance <= tolerance)
          break;
        else
          {
            --stage.n_sets; // the same set again
            present_tolerance = tolerance;
          }
        if (stage.n_sets > max_block_sets + max_single_sets)
          throw ComputationError(
            "the active set of " + std::to_string(n) +
            " contact nodes did not settle\n  remedy:  a larger "
            "Contact/Compliance or a smaller Time/Step size");
      }
    for (double &p : rates.pressure)
      p = std::max(p, 0.);
    rates.n_iterations = stage.n_sets;
    counters_.active_set_iterations += stage.n_sets;
  }



  template <int dim>
  void
  IterativeSolver<dim>::solve(const State      &known,
                              const double      tau,
                              const Vector     &heat_load,
                              const Vector     &momentum_load,
                              const ContactMode mode,
                              StageRates       &rates)
  {
    const StopWatch watch(counters_.solve_seconds);
    stage.has_heat = true;
    prepare(known, tau, heat_load, momentum_load);
    solve_prepared(mode, rates);
    ++counters_.solves;
    if (body.scene.fields.has_temperature)
      rates.temperature_rate.equ(1. / tau,
                                 stage.solution.block(Field::temperature));
    if (body.scene.fields.has_displacement)
      rates.velocity.copy_locally_owned_data_from(
        stage.solution.block(Field::displacement));
  }



  template <int dim>
  void
  IterativeSolver<dim>::solve_momentum(const State      &known,
                                       const double      tau,
                                       const Vector     &heat_load,
                                       const Vector     &momentum_load,
                                       const ContactMode mode,
                                       StageRates       &rates)
  {
    const StopWatch watch(counters_.solve_seconds);
    stage.has_heat = false;
    prepare(known, tau, heat_load, momentum_load);
    solve_prepared(mode, rates);
    ++counters_.solves;
    rates.velocity.copy_locally_owned_data_from(
      stage.solution.block(Field::displacement));
  }



  template class IterativeSolver<2>;
  template class IterativeSolver<3>;
} // namespace ThermoContact
