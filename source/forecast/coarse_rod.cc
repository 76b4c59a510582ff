// SPDX-License-Identifier: LGPL-2.1-or-later

#include <thermocontact/forecast/coarse_rod.h>
#include <thermocontact/space/problem_data.h>

#include <algorithm>
#include <cmath>

namespace ThermoContact
{
  namespace
  {
    constexpr double largest_cell = 1. / 64., growth = 1.2, of_heat = 1e-3;

    /** The diagonal entry of the scheme with two stages, L-stable. */
    const double diagonal = 1. - std::sqrt(0.5);



    /** Cells of half the rod, from its end on. */
    std::vector<double>
    half_of_cells(const double smallest)
    {
      std::vector<double> cells;
      double              sum = 0.;
      for (double h = smallest; sum < 0.5;
           h        = std::min(growth * h, largest_cell))
        {
                 cells.push_back(h);
                 sum += h;
        }
      for (double &h : cells)
        h *= 0.5 / sum;
      return cells;
    }



    /** Short contacts compress a short part of the rod. */
    double
    smallest_cell(const ContactLaw &law)
    {
      return law.is_rigid() || !law.is_linear() ?
               of_heat :
               std::clamp(0.25 * law.tangent(1.), 1e-6, of_heat);
    }
  } // namespace



  std::vector<double>
  CoarseRod::cell_sizes(const double smallest)
  {
    std::vector<double>       cells  = half_of_cells(of_heat);
    const std::vector<double> at_end = half_of_cells(smallest);
    cells.insert(cells.end(), at_end.rbegin(), at_end.rend());
    return cells;
  }



  CoarseRod::CoarseRod(const Scene &scene)
    : scene(scene)
    , h(cell_sizes(smallest_cell(*scene.contact.law)))
  {
    const ProblemData<1> data(scene);
    const unsigned int   axial = scene.fields.has_temperature ? 1 : 0;
    dealii::Point<1>     x(0.);
    for (unsigned int i = 0; i <= h.size(); ++i)
      {
        initial.temperature.push_back(
          !scene.fields.has_temperature ? 0. :
          i == 0                        ? scene.heat.fixed_end_temperature :
                                          data.initial_fields().value(x, 0));
        initial.displacement.push_back(
          i == 0 ? 0. : data.initial_fields().value(x, axial));
        initial.velocity.push_back(
          i == 0 ? 0. : data.initial_velocity().value(x, axial));
        if (i < h.size())
          x[0] = i + 1 == h.size() ? 1. : x[0] + h[i];
      }
  }



  void
  CoarseRod::factorize(const double length)
  {
    tau                         = length;
    const Material    &material = scene.material;
    const double       m        = scene.heat.lateral_exchange;
    const bool         has_heat = scene.fields.has_temperature;
    const unsigned int n        = h.size();
    lower.assign(n, Block());
    upper.assign(n, Block());
    inverse.assign(n, Block());
    std::vector<Block> &diagonals = inverse;
    for (unsigned int cell = 0; cell < n; ++cell)
      for (int i = 0; i < 2; ++i)
        for (int j = 0; j < 2; ++j)
          {
            const int row    = static_cast<int>(cell) - 1 + i,
                      column = static_cast<int>(cell) - 1 + j;
            if (row < 0 || column < 0)
              continue;
            const double mass      = h[cell] * (i == j ? 2. : 1.) / 6.;
            const double stiffness = (i == j ? 1. : -1.) / h[cell];
            Block       &block     = i == j ? diagonals[row] :
                                     i < j  ? upper[row] :
                                              lower[row];
            if (has_heat)
              {
                block[0][0] += mass * (1. / tau + m) + stiffness;
                block[0][1] += material.heating * (j == 0 ? -0.5 : 0.5);
                block[1][0] -= material.thermal_stress * (i == 0 ? -0.5 : 0.5);
              }
            block[1][1] += material.inertia * mass / tau +
                           (material.viscosity + tau) * stiffness;
          }
    if (has_heat)
      diagonals.back()[0][0] += scene.heat.reference_coefficient;
    for (unsigned int i = 0; i < n; ++i)
      {
        if (!has_heat)
          diagonals[i][0][0] = 1.;
        if (i > 0)
          {
            lower[i] = lower[i] * inverse[i - 1];
            diagonals[i] -= lower[i] * upper[i - 1];
          }
        inverse[i] = invert(diagonals[i]);
      }
    response.assign(n, dealii::Tensor<1, 2>());
    response.back()[1] = -1.;
    solve(response);
    receptance = -tau * response.back()[1];
  }



  void
  CoarseRod::solve(Vector &vector) const
  {
    const unsigned int n = vector.size();
    for (unsigned int i = 1; i < n; ++i)
      vector[i] -= lower[i] * vector[i - 1];
    vector[n - 1] = inverse[n - 1] * vector[n - 1];
    for (unsigned int i = n - 1; i-- > 0;)
      vector[i] = inverse[i] * (vector[i] - upper[i] * vector[i + 1]);
  }



  double
  CoarseRod::stage(State &base, const bool meets_obstacle) const
  {
    const Material    &material = scene.material;
    const SceneHeat   &heat     = scene.heat;
    const unsigned int n        = h.size();
    Vector             values(n);
    for (unsigned int cell = 0; cell < n; ++cell)
      for (unsigned int i = cell == 0 ? 1 : 0; i < 2; ++i)
        {
          const unsigned int other = cell + 1 - i, own = cell + i;
          const auto mass_times = [&](const std::vector<double> &field) {
            return h[cell] * (2. * field[own] + field[other]) / 6.;
          };
          values[own - 1][1] +=
            material.inertia * mass_times(base.velocity) / tau -
            (base.displacement[own] - base.displacement[other]) / h[cell];
          if (!scene.fields.has_temperature)
            continue;
          values[own - 1][0] +=
            mass_times(base.temperature) / tau +
            heat.lateral_exchange * heat.ambient_temperature * 0.5 * h[cell];
          if (cell == 0)
            {
              const double fixed = base.temperature[0];
              values[0][0] -=
                fixed *
                (h[0] / 6. * (1. / tau + heat.lateral_exchange) - 1. / h[0]);
              values[0][1] += material.thermal_stress * 0.5 * fixed;
            }
        }
    if (scene.fields.has_temperature)
      values[n - 1][0] +=
        heat.reference_coefficient * heat.obstacle_temperature;
    solve(values);
    double pressure = 0.;
    if (meets_obstacle)
      {
        const double beyond =
          base.displacement[n] + tau * values[n - 1][1] - scene.contact.gap;
        if (std::isfinite(beyond) && receptance > 0.)
          pressure = scene.contact.law->resolve(beyond, receptance).pressure;
        for (unsigned int i = 0; i < n; ++i)
          values[i] += pressure * response[i];
      }
    for (unsigned int i = 0; i < n; ++i)
      {
        if (scene.fields.has_temperature)
          base.temperature[i + 1] = values[i][0];
        base.velocity[i + 1] = values[i][1];
        base.displacement[i + 1] += tau * values[i][1];
      }
    return pressure;
  }



  double
  CoarseRod::step(State &state, const double dt, const bool meets_obstacle)
  {
    if (diagonal * dt != tau)
      factorize(diagonal * dt);
    State middle = state;
    stage(middle, meets_obstacle);
    const double after = (1. - diagonal) / diagonal;
    for (const auto field :
         {&State::temperature, &State::displacement, &State::velocity})
      for (unsigned int i = 0; i <= h.size(); ++i)
        (state.*field)[i] += after * ((middle.*field)[i] - (state.*field)[i]);
    return stage(state, meets_obstacle);
  }
} // namespace ThermoContact
