// SPDX-License-Identifier: LGPL-2.1-or-later

#include <thermocontact/base/exceptions.h>
#include <thermocontact/base/number_text.h>
#include <thermocontact/base/stop_watch.h>
#include <thermocontact/base/text.h>
#include <thermocontact/base/tolerances.h>
#include <thermocontact/time/box_solver.h>

#include <algorithm>
#include <utility>

namespace ThermoContact
{
  namespace
  {
    /** Steps of a run: a regular one, to a break and from it, and the last. */
    constexpr unsigned int max_kept = 8;
  } // namespace



  BoxSolver::BoxSolver(const Body<1> &body)
    : body(body)
    , kept(max_kept)
  {}



  BoxRates
  BoxSolver::make_rates() const
  {
    const Vector heat = body.discretization.make_vector(Field::temperature);
    return {{{heat, heat}},
            body.discretization.make_vector(Field::displacement)};
  }



  BoxSolver::Factors &
  BoxSolver::provide(const double size)
  {
    if (kept.use(size))
      return kept.front();
    const StopWatch watch(counters_.factorization_seconds);
    const Material &material       = body.scene.material;
    const double    tau            = 0.5 * size;
    const auto      momentum_block = [&](const SystemCoefficients &c) {
      return rod_block(c, material, Field::displacement);
    };
    const auto  momentum = momentum_block(stage_coefficients(tau));
    const auto &matrices = *body.equations.rod();
    Factors     factors{size, nullptr, nullptr, nullptr, {}};
    double      growth = 0.;
    const auto is_held = [&](const Field::Block field, const unsigned int end) {
      return body.discretization.are_ends_held(field)[end];
    };
    const RodFactors<1>::Held held{{is_held(Field::displacement, 0)}},
      held_right{{is_held(Field::displacement, 1)}};
    if (body.scene.fields.has_temperature)
      {
        RodFactors<3>::Blocks blocks;
        for (unsigned int i = 0; i < HeatStages::n; ++i)
          {
            double stress = 0.; // the part of this rate in the mean temperature
            for (unsigned int j = 0; j < HeatStages::n; ++j)
              {
                blocks[i][j] = {{size * HeatStages::coefficients[i][j],
                                 RodMatrices::conduction}};
                stress +=
                  HeatStages::weights[j] * HeatStages::coefficients[j][i];
              }
            blocks[i][i].push_back({1., RodMatrices::heat_mass});
            blocks[i][2] = {{material.heating, RodMatrices::divergence}};
            blocks[2][i] = {{-tau * size * stress * material.thermal_stress,
                             RodMatrices::thermal_stress}};
          }
        blocks[2][2]      = momentum;
        factors.with_heat = std::make_unique<const RodFactors<3>>(
          matrices,
          blocks,
          RodFactors<3>::Held{{is_held(Field::temperature, 0),
                               is_held(Field::temperature, 0),
                               held[0]}},
          RodFactors<3>::Held{{is_held(Field::temperature, 1),
                               is_held(Field::temperature, 1),
                               held_right[0]}});
        growth = factors.with_heat->growth();
      }
    else
      {
        factors.alone = std::make_unique<const RodFactors<1>>(
          matrices, RodFactors<1>::Blocks{{{{momentum}}}}, held, held_right);
        growth = factors.alone->growth();
      }
    if (material.has_viscosity())
      {
        factors.viscous = std::make_unique<const RodFactors<1>>(
          matrices,
          RodFactors<1>::Blocks{
            {{{momentum_block({0., 0., 0., 0., 1., size})}}}},
          held,
          held_right);
        growth = std::max(growth, factors.viscous->growth());
      }
    if (!(growth <= Tolerances::tolerated_cancellation))
      throw ComputationError(
        text("the blocks of the matrix of a step of ",
             significant(size, 3),
             " grow by ",
             significant(growth, 2),
             ", more digits than a result may lose\n  remedy:  Time/Scheme = ",
             default_scheme().name));
    kept.add(std::move(factors));
    counters_.factorizations += 1 + material.has_viscosity();
    return kept.front();
  }



  void
  BoxSolver::solve_by(const Factors  &factors,
                      const BoxRates &right,
                      BoxRates       &rates) const
  {
    if (factors.with_heat)
      factors.with_heat->solve({{right.temperature_rate[0].begin(),
                                 right.temperature_rate[1].begin(),
                                 right.velocity.begin()}},
                               {{rates.temperature_rate[0].begin(),
                                 rates.temperature_rate[1].begin(),
                                 rates.velocity.begin()}});
    else
      factors.alone->solve({{right.velocity.begin()}},
                           {{rates.velocity.begin()}});
  }



  void
  BoxSolver::solve(const double size, const BoxRates &right, BoxRates &rates)
  {
    const StopWatch watch(counters_.solve_seconds);
    solve_by(provide(size), right, rates);
    ++counters_.solves;
  }



  void
  BoxSolver::solve_viscous(const double  size,
                           const Vector &right,
                           Vector       &solution)
  {
    provide(size).viscous->solve({{right.begin()}}, {{solution.begin()}});
  }



  void
  BoxSolver::compute_responses(Factors &factors)
  {
    const ContactEnd<1> &end = body.contact_end();
    const auto           add = [&](const BoxRates &right) {
      solve_by(factors, right, factors.responses.emplace_back(make_rates()));
      ++counters_.responses;
    };
    for (unsigned int node = 0; node < end.n_nodes(); ++node)
      {
        BoxRates right = make_rates();
        end.set_load_of_node(Field::displacement,
                             node,
                             0.5 * factors.tau,
                             right.velocity);
        add(right);
        for (unsigned int i = 0; i + 1 < n_responses(); ++i)
          {
            right = make_rates();
            end.set_load_of_node(Field::temperature,
                                 node,
                                 1.,
                                 right.temperature_rate[i]);
            add(right);
          }
      }
  }



  const BoxRates &
  BoxSolver::response_to_pressure(const double size, const unsigned int contact)
  {
    Factors &factors = provide(size);
    if (factors.responses.empty())
      compute_responses(factors);
    return factors.responses[contact * n_responses()];
  }



  const BoxRates &
  BoxSolver::response_to_flux(const double       size,
                              const unsigned int contact,
                              const unsigned int stage)
  {
    response_to_pressure(size, contact);
    return kept.front().responses[contact * n_responses() + 1 + stage];
  }



  void
  BoxSolver::solve(const State &,
                   const double,
                   const Vector &,
                   const Vector &,
                   ContactMode,
                   StageRates &)
  {
    AssertThrow(false, ExcInternalError()); // a body with inertia has none
  }



  types::global_dof_index
  BoxSolver::n_factorized_unknowns() const
  {
    return body.discretization.n_displacement_dofs() +
           HeatStages::n * body.discretization.n_temperature_dofs();
  }



  RetainedFactorizations
  BoxSolver::retained() const
  {
    RetainedFactorizations retained;
    retained.counters = counters_;
    for (const Factors &factors : kept.all())
      {
        retained.taus.push_back(factors.tau);
        retained.has_response.push_back(!factors.responses.empty());
      }
    return retained;
  }



  void
  BoxSolver::restore(const RetainedFactorizations &retained)
  {
    kept.clear();
    for (unsigned int i = retained.taus.size(); i-- > 0;)
      {
        Factors &factors = provide(retained.taus[i]);
        if (retained.has_response[i])
          compute_responses(factors);
      }
    counters_ = retained.counters;
  }
} // namespace ThermoContact
