// SPDX-License-Identifier: LGPL-2.1-or-later

#include <thermocontact/base/tolerances.h>
#include <thermocontact/space/massless_contact.h>
#include <thermocontact/space/nonlinear_rod.h>

#include <deal.II/base/quadrature_lib.h>

#include <deal.II/fe/fe_q.h>

#include <algorithm>
#include <limits>

namespace ThermoContact
{
  using namespace dealii;

  NonlinearRod::NonlinearRod(const Scene &scene, const Operator &equations)
    : fields(scene.fields)
    , row(scene.row)
    , material(scene.material)
    , equations(equations)
    , matrices(*equations.rod())
  {
    const unsigned int degree = matrices.layout().degree;
    const FE_Q<1>      basis(degree);
    const auto         read = [&](const Quadrature<1> &rule) {
      std::vector<Point> all;
      for (unsigned int q = 0; q < rule.size(); ++q)
        {
          Point point{rule.point(q)[0], rule.weight(q), {}, {}};
          for (unsigned int i = 0; i <= degree; ++i)
            {
              point.value.push_back(basis.shape_value(i, rule.point(q)));
              point.slope.push_back(basis.shape_grad(i, rule.point(q))[0]);
            }
          all.push_back(point);
        }
      return all;
    };
    mass_points = read(mass_quadrature<1>(degree, scene.has_lumped_mass));
    points      = read(QGauss<1>(degree + 1));
    for (unsigned int number = 0; number < scene.row.cells.size(); ++number)
      {
        const RowCell &of_row = scene.row.cells[number];
        if (of_row.is_gap)
          continue;
        const auto &profile = scene.row.bodies[of_row.body].profile;
        if (!profile || profile->of_temperature().empty())
          continue;
        // within the cell, beside a jump at its ends
        const double inside = Tolerances::rounding_of_data * of_row.size;
        Cell         cell{number,
                  of_row.size - 2. * inside,
                  of_row.begin + inside,
                  &*profile,
                  {},
                  {}};
        for (const Point &point : mass_points)
          cell.of_mass.push_back(
            profile->at(cell.begin + point.place * cell.size));
        for (const Point &point : points)
          cell.of_rest.push_back(
            profile->at(cell.begin + point.place * cell.size));
        cells.push_back(cell);
      }
  }



  template <typename AtMass, typename AtRest>
  void
  NonlinearRod::visit(const Cell   &cell,
                      const State  &state,
                      const Rates  &rates,
                      const bool    with_slopes,
                      const AtMass &at_mass,
                      const AtRest &at_rest) const
  {
    const RodLayout &layout = matrices.layout();
    const auto       sum    = [&](const std::vector<double> &basis,
                         const Vector              &values) {
      double result = 0.;
      if (values.size() > 0)
        for (unsigned int i = 0; i < basis.size(); ++i)
          result += basis[i] * values.begin()[layout.node(cell.number, i)];
      return result;
    };
    const auto visit_points = [&](const std::vector<Point>           &all,
                                  const std::vector<EquationFactors> &at_zero,
                                  const auto                         &at) {
      for (unsigned int q = 0; q < all.size(); ++q)
        {
          const Point &point = all[q];
          const double x     = cell.begin + point.place * cell.size;
          const Local  local{sum(point.value, state.temperature),
                            sum(point.slope, state.temperature) / cell.size,
                            sum(point.value, rates.temperature_rate),
                            sum(point.slope, state.displacement) / cell.size,
                            sum(point.slope, rates.velocity) / cell.size};
          const auto   now = with_slopes ?
                               cell.profile->tangents(x, local.theta) :
                               EquationTangents{cell.profile->at(x, local.theta),
                                              EquationFactors()};
          at(point,
             point.weight * cell.size,
             local,
             row.beyond_zero(cell.number, now, at_zero[q]));
        }
    };
    visit_points(mass_points, cell.of_mass, at_mass);
    visit_points(points, cell.of_rest, at_rest);
  }



  void
  NonlinearRod::subtract(const State &state,
                         const Rates &rates,
                         Vector      &heat,
                         Vector      &momentum) const
  {
    const RodLayout &layout = matrices.layout();
    for (const Cell &cell : cells)
      visit(
        cell,
        state,
        rates,
        false,
        [&](const Point            &point,
            const double            weight,
            const Local            &at,
            const EquationTangents &beyond) {
          for (unsigned int i = 0; i < layout.nodes_per_cell(); ++i)
            heat.begin()[layout.node(cell.number, i)] -=
              weight * beyond.value.heat_mass * at.rate * point.value[i];
        },
        [&](const Point            &point,
            const double            weight,
            const Local            &at,
            const EquationTangents &beyond) {
          const double source = material.heating * beyond.value.coupling *
                                at.strain_rate,
                       flux   = beyond.value.conduction * at.theta_x,
                       stress = stress_of(material,
                                          beyond.value,
                                          at.theta,
                                          at.strain,
                                          at.strain_rate);
          for (unsigned int i = 0; i < layout.nodes_per_cell(); ++i)
            {
              const unsigned int node  = layout.node(cell.number, i);
              const double       slope = point.slope[i] / cell.size;
              heat.begin()[node] -=
                weight * (flux * slope + source * point.value[i]);
              if (fields.has_displacement)
                momentum.begin()[node] -= weight * stress * slope;
            }
        });
  }



  std::unique_ptr<const NonlinearRod::Operator>
  NonlinearRod::at(const Vector &temperature) const
  {
    State state;
    state.temperature = temperature;
    return operator_at(state, Rates(), false);
  }



  std::unique_ptr<const NonlinearRod::Operator>
  NonlinearRod::operator_at(const State &state,
                            const Rates &rates,
                            const bool   with_slopes) const
  {
    using Matrix               = RodMatrices::Matrix;
    const RodLayout    &layout = matrices.layout();
    const unsigned int  n      = layout.nodes_per_cell();
    const std::size_t   n_cell = RodMatrices::n_matrices * n * n;
    std::vector<double> entries(layout.n_cells * n_cell);
    std::vector<bool>   carries(layout.n_cells);
    for (const RodMatrices::Run &run : matrices.runs())
      for (unsigned int cell = run.begin; cell < run.end; ++cell)
        {
          const double *const of_run = matrices.entries(run, Matrix(0));
          std::copy(of_run, of_run + n_cell, entries.data() + cell * n_cell);
          carries[cell] = run.carries;
        }
    for (const Cell &cell : cells)
      {
        const auto add = [&](const Matrix               matrix,
                             const double               factor,
                             const std::vector<double> &row,
                             const std::vector<double> &column) {
          double *entry =
            entries.data() + cell.number * n_cell + matrix * n * n;
          for (unsigned int j = 0; j < n; ++j)
            for (unsigned int i = 0; i < n; ++i)
              *entry++ += factor * row[i] * column[j];
        };
        visit(
          cell,
          state,
          rates,
          with_slopes,
          [&](const Point            &point,
              const double            weight,
              const Local            &at,
              const EquationTangents &beyond) {
            add(RodMatrices::heat_mass,
                weight * beyond.value.heat_mass,
                point.value,
                point.value);
            add(RodMatrices::conduction,
                weight * beyond.slope.heat_mass * at.rate,
                point.value,
                point.value);
          },
          [&](const Point            &point,
              const double            weight,
              const Local            &at,
              const EquationTangents &beyond) {
            const EquationFactors &value = beyond.value, &slope = beyond.slope;
            const double           by_slope  = weight / cell.size;
            const double           by_slopes = by_slope / cell.size;
            add(RodMatrices::conduction,
                by_slopes * value.conduction,
                point.slope,
                point.slope);
            add(RodMatrices::conduction,
                by_slope * slope.conduction * at.theta_x,
                point.slope,
                point.value);
            add(RodMatrices::conduction,
                weight * material.heating * slope.coupling * at.strain_rate,
                point.value,
                point.value);
            if (!fields.has_displacement)
              return;
            add(RodMatrices::divergence,
                by_slope * value.coupling,
                point.value,
                point.slope);
            add(RodMatrices::stiffness,
                by_slopes * value.stiffness,
                point.slope,
                point.slope);
            if (material.has_viscosity())
              add(RodMatrices::viscous_stiffness,
                  by_slopes * value.viscosity,
                  point.slope,
                  point.slope);
            if (material.has_thermal_stress())
              add(RodMatrices::thermal_stress,
                  by_slope *
                    (value.coupling + slope.coupling * at.theta -
                     (slope.stiffness * at.strain +
                      material.viscosity * slope.viscosity * at.strain_rate) /
                       material.thermal_stress),
                  point.slope,
                  point.value);
          });
      }
    return std::make_unique<const Operator>(
      equations,
      std::make_unique<const RodMatrices>(
        layout,
        0.,
        [&](const Matrix       matrix,
            const unsigned int cell,
            const unsigned int i,
            const unsigned int j) {
          return entries[cell * n_cell + (matrix * n + j) * n + i];
        },
        carries));
  }
} // namespace ThermoContact
