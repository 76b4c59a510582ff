// SPDX-License-Identifier: LGPL-2.1-or-later

#include <thermocontact/base/tolerances.h>
#include <thermocontact/space/cell_products.h>
#include <thermocontact/space/massless_contact.h>

#include <deal.II/base/mpi.h>
#include <deal.II/base/polynomial.h>
#include <deal.II/base/quadrature_lib.h>

#include <deal.II/fe/fe_q.h>
#include <deal.II/fe/fe_tools.h>
#include <deal.II/fe/fe_values.h>

#include <cmath>
#include <map>
#include <type_traits>
#include <utility>

namespace ThermoContact
{
  namespace
  {
    /** Values of the nodes of a batch, components behind each other. */
    template <int n_components, typename Number>
    inline void
    gather(const Number       *x,
           const unsigned int *positions,
           const unsigned int *strides,
           const unsigned int  n_nodes,
           Lanes<Number>      *values,
           const unsigned int  first_component = 0)
    {
      constexpr unsigned int n_lanes = Lanes<Number>::n_lanes;
      for (unsigned int i = 0; i < n_nodes; ++i)
        for (unsigned int c = 0; c < n_components; ++c)
          {
            Lanes<Number> value{};
            for (unsigned int lane = 0; lane < n_lanes; ++lane)
              value.data[lane] = x[positions[i * n_lanes + lane] +
                                   (first_component + c) * strides[i]];
            values[c * n_nodes + i] = value;
          }
    }



    /** Adds those of the first @p n_cells lanes. */
    template <int n_components, typename Number>
    inline void
    scatter(const Lanes<Number> *values,
            const unsigned int  *positions,
            const unsigned int  *strides,
            const unsigned int   n_nodes,
            const unsigned int   n_cells,
            Number              *y,
            const unsigned int   first_component = 0)
    {
      constexpr unsigned int n_lanes = Lanes<Number>::n_lanes;
      const auto add = [&](const unsigned int i, const unsigned int lane) {
        for (unsigned int c = 0; c < n_components; ++c)
          y[positions[i * n_lanes + lane] +
            (first_component + c) * strides[i]] +=
            values[c * n_nodes + i].data[lane];
      };
      if (n_cells == n_lanes)
        for (unsigned int i = 0; i < n_nodes; ++i)
          for (unsigned int lane = 0; lane < n_lanes; ++lane)
            add(i, lane);
      else
        for (unsigned int i = 0; i < n_nodes; ++i)
          for (unsigned int lane = 0; lane < n_cells; ++lane)
            add(i, lane);
    }



    /** Names for parts of a scratch array, one array of a cell each. */
    template <int dim, typename Number>
    std::array<std::array<Lanes<Number> *, dim>, dim>
    gradients_in(Lanes<Number> *scratch, const unsigned int n_nodes)
    {
      std::array<std::array<Lanes<Number> *, dim>, dim> gradients;
      for (unsigned int c = 0; c < dim; ++c)
        for (unsigned int d = 0; d < dim; ++d)
          gradients[c][d] = scratch + (c * dim + d) * n_nodes;
      return gradients;
    }



    /** What a point contributes to the momentum, with its factors. */
    template <typename Number>
    struct MomentumPoint
    {
      Lanes<Number> mass[3];
      Lanes<Number> mu;
      Lanes<Number> lambda;
      Lanes<Number> hoop; ///< strain per displacement along y
    };



    /**
     * Replaces displacement and gradient at a quadrature point by what the test
     * functions and their derivatives are multiplied by.
     */
    template <int dim, bool is_radial, typename Number>
    inline __attribute__((always_inline)) void
    momentum_at_point(
      const MomentumPoint<Number>                             &point,
      const Lanes<Number>                                     *inverse_size,
      const std::array<Lanes<Number> *, dim>                  &u,
      const std::array<std::array<Lanes<Number> *, dim>, dim> &gradient,
      const unsigned int                                       q)
    {
      Lanes<Number> e[dim][dim];
      for (unsigned int c = 0; c < dim; ++c)
        for (unsigned int d = 0; d < dim; ++d)
          e[c][d] = gradient[c][d][q] * inverse_size[d];
      Lanes<Number> dilatation = e[0][0] + e[1][1];
      if constexpr (dim == 3)
        dilatation += e[2][2];
      const Lanes<Number> strain =
        is_radial ? point.hoop * u[1][q] : Lanes<Number>{};
      if constexpr (is_radial)
        dilatation += strain;
      const Lanes<Number> pressure = point.lambda * dilatation;
      for (unsigned int c = 0; c < dim; ++c)
        u[c][q] *= point.mass[c];
      if constexpr (is_radial)
        u[1][q] += point.hoop * (point.mu * (strain + strain) + pressure);
      for (unsigned int c = 0; c < dim; ++c)
        {
          gradient[c][c][q] =
            (point.mu * (e[c][c] + e[c][c]) + pressure) * inverse_size[c];
          for (unsigned int d = c + 1; d < dim; ++d)
            {
              const Lanes<Number> shear = point.mu * (e[c][d] + e[d][c]);
              gradient[c][d][q]         = shear * inverse_size[d];
              gradient[d][c][q]         = shear * inverse_size[c];
            }
        }
    }
  } // namespace



  template <int dim, typename Number>
  inline Lanes<Number>
  CellProducts<dim, Number>::weight(const unsigned int b,
                                    const unsigned int q,
                                    const bool         is_of_mesh) const
  {
    const Lanes<Number> weight = Lanes<Number>::in(weights.begin())[q] *
                                 *Lanes<Number>::in(batches[b].volume.data());
    return radial.empty() || is_of_mesh ?
             weight :
             weight * Lanes<Number>::in(radial.begin())[2 * (b * n + q / n)];
  }



  template <int dim, typename Number>
  inline Lanes<Number>
  CellProducts<dim, Number>::hoop(const unsigned int b,
                                  const unsigned int q) const
  {
    return Lanes<Number>::in(radial.begin())[2 * (b * n + q / n) + 1];
  }



  template <int dim, typename Number>
  template <int n_static>
  void
  CellProducts<dim, Number>::scalar_on_cells(const Field::Block   field,
                                             const unsigned int   component,
                                             const Factors       &factors,
                                             LevelVector<Number> &y,
                                             const LevelVector<Number> &x) const
  {
    using Batched              = Lanes<Number>;
    const int          n_line  = n_static > 0 ? n_static : int(n);
    const unsigned int n_point = power_of(n_line, dim);
    const FieldCells  &cells   = fields[field];
    Batched           *theta   = reinterpret_cast<Batched *>(scratch.begin());
    const std::array<Batched *, dim> gradient =
      gradients_in<dim>(theta + n_point, n_point)[0];
    const Batched *points    = Batched::in(weights.begin());
    const Number   mass_part = has_lumped_mass ? 0. : factors.mass;
    const Number   flow_part = factors.stiffness;
    for (unsigned int b = first_batch(factors); b < batches.size(); ++b)
      {
        const Batch        &batch = batches[b];
        const unsigned int *positions =
          cells.positions.data() + b * n_point * n_lanes;
        gather<1>(
          x.begin(), positions, strides.data(), n_point, theta, component);
        apply_along_all<dim, n_static>(Batched::in(values.begin()),
                                       theta,
                                       n_line);
        differentiate<dim, n_static>(Batched::in(derivatives.begin()),
                                     theta,
                                     gradient,
                                     n_line);
        const Batched  volume = *Batched::in(batch.volume.data());
        const Batched *radii  = Batched::in(radial.begin()) + 2 * b * n_line;
        const bool     is_weighted = !radial.empty() && !factors.is_of_mesh;
        Batched        factor[dim];
        for (unsigned int d = 0; d < dim; ++d)
          {
            factor[d] = *Batched::in(batch.inverse_size[d].data());
            factor[d] *= factor[d] * flow_part;
          }
        for (unsigned int q = 0; q < n_point; ++q)
          {
            Batched weight = points[q] * volume;
            if (is_weighted)
              weight *= radii[2 * (q / n_line)];
            theta[q] *= weight * mass_part;
            for (unsigned int d = 0; d < dim; ++d)
              gradient[d][q] *= weight * factor[d];
          }
        add_transposed<dim, n_static>(
          Batched::in(derivatives_transposed.begin()), gradient, theta, n_line);
        apply_along_all<dim, n_static>(Batched::in(values_transposed.begin()),
                                       theta,
                                       n_line);
        scatter<1>(theta,
                   positions,
                   strides.data(),
                   n_point,
                   batch.n_cells,
                   y.begin(),
                   component);
      }
  }



  template <int dim, typename Number>
  template <int n_static, bool is_radial>
  void
  CellProducts<dim, Number>::momentum_on_cells(
    const Factors             &factors,
    LevelVector<Number>       &y,
    const LevelVector<Number> &x) const
  {
    using Batched                = Lanes<Number>;
    const int          n_line    = n_static > 0 ? n_static : int(n);
    const unsigned int n_point   = power_of(n_line, dim);
    const FieldCells  &cells     = fields[Field::displacement];
    Batched           *values_at = reinterpret_cast<Batched *>(scratch.begin());
    std::array<Batched *, dim> u;
    for (unsigned int c = 0; c < dim; ++c)
      u[c] = values_at + c * n_point;
    const auto     gradient  = gradients_in<dim>(u[0] + dim * n_point, n_point);
    const Batched *points    = Batched::in(weights.begin());
    const Number   mass_part = has_lumped_mass ? 0. : factors.mass;
    const Number   mu        = 0.5 * factors.stiffness * material.two_mu;
    const Number   lambda    = factors.stiffness * material.lambda;
    for (unsigned int b = first_batch(factors); b < batches.size(); ++b)
      {
        const Batch        &batch = batches[b];
        const unsigned int *positions =
          cells.positions.data() + b * n_point * n_lanes;
        gather<dim>(x.begin(), positions, strides.data(), n_point, values_at);
        for (unsigned int c = 0; c < dim; ++c)
          {
            apply_along_all<dim, n_static>(Batched::in(values.begin()),
                                           u[c],
                                           n_line);
            differentiate<dim, n_static>(Batched::in(derivatives.begin()),
                                         u[c],
                                         gradient[c],
                                         n_line);
          }
        const Batched  volume = *Batched::in(batch.volume.data());
        const Batched *radii  = Batched::in(radial.begin()) + 2 * b * n_line;
        Batched        inverse_size[dim];
        for (unsigned int d = 0; d < dim; ++d)
          inverse_size[d] = *Batched::in(batch.inverse_size[d].data());
        for (unsigned int q = 0; q < n_point; ++q)
          {
            Batched weight = points[q] * volume;
            if constexpr (is_radial)
              weight *= radii[2 * (q / n_line)];
            MomentumPoint<Number> point;
            point.mass[0] = weight * (batch.has_axial_mass ? mass_part : 0);
            point.mass[1] = point.mass[2] = weight * mass_part;
            point.mu                      = weight * mu;
            point.lambda                  = weight * lambda;
            if constexpr (is_radial)
              point.hoop = radii[2 * (q / n_line) + 1];
            momentum_at_point<dim, is_radial>(
              point, inverse_size, u, gradient, q);
          }
        for (unsigned int c = 0; c < dim; ++c)
          {
            add_transposed<dim, n_static>(Batched::in(
                                            derivatives_transposed.begin()),
                                          gradient[c],
                                          u[c],
                                          n_line);
            apply_along_all<dim, n_static>(
              Batched::in(values_transposed.begin()), u[c], n_line);
          }
        scatter<dim>(values_at,
                     positions,
                     strides.data(),
                     n_point,
                     batch.n_cells,
                     y.begin());
      }
  }



  template <int dim, typename Number>
  template <int n_static>
  void
  CellProducts<dim, Number>::divergence_on_cells(
    LevelVector<Number>       &heat,
    const LevelVector<Number> &u) const
  {
    using Batched              = Lanes<Number>;
    const int          n_line  = n_static > 0 ? n_static : int(n);
    const unsigned int n_point = power_of(n_line, dim);
    Batched           *at      = reinterpret_cast<Batched *>(scratch.begin());
    Batched           *change  = at + dim * n_point;
    Batched           *sum     = change + n_point;
    for (unsigned int b = 0; b < batches.size(); ++b)
      {
        const std::size_t first = b * n_point * n_lanes;
        gather<dim>(u.begin(),
                    &fields[Field::displacement].positions[first],
                    strides.data(),
                    n_point,
                    at);
        std::fill_n(sum, n_point, Batched{});
        const auto add = [&](const auto direction) {
          constexpr int  d         = decltype(direction)::value;
          Batched *const component = at + d * n_point;
          apply_along_all<dim, n_static>(Batched::in(values.begin()),
                                         component,
                                         n_line);
          apply_along<dim, d, n_static, false>(Batched::in(derivatives.begin()),
                                               component,
                                               change,
                                               n_line);
          const Batched inverse_size =
            *Batched::in(batches[b].inverse_size[d].data());
          for (unsigned int q = 0; q < n_point; ++q)
            sum[q] += inverse_size * change[q];
          if (d == 1 && !radial.empty())
            for (unsigned int q = 0; q < n_point; ++q)
              sum[q] += hoop(b, q) * component[q];
        };
        along_all<dim>(add);
        for (unsigned int q = 0; q < n_point; ++q)
          sum[q] *= weight(b, q);
        apply_along_all<dim, n_static>(Batched::in(values_transposed.begin()),
                                       sum,
                                       n_line);
        scatter<1>(sum,
                   &fields[Field::temperature].positions[first],
                   strides.data(),
                   n_point,
                   batches[b].n_cells,
                   heat.begin());
      }
  }



  template <int dim, typename Number>
  template <int n_static>
  void
  CellProducts<dim, Number>::thermal_stress_on_cells(
    LevelVector<Number>       &momentum,
    const LevelVector<Number> &theta) const
  {
    using Batched              = Lanes<Number>;
    const int          n_line  = n_static > 0 ? n_static : int(n);
    const unsigned int n_point = power_of(n_line, dim);
    Batched           *at      = reinterpret_cast<Batched *>(scratch.begin());
    Batched           *stress  = at + dim * n_point;
    Batched           *change  = stress + n_point;
    for (unsigned int b = 0; b < batches.size(); ++b)
      {
        const std::size_t first = b * n_point * n_lanes;
        gather<1>(theta.begin(),
                  &fields[Field::temperature].positions[first],
                  strides.data(),
                  n_point,
                  stress);
        apply_along_all<dim, n_static>(Batched::in(values.begin()),
                                       stress,
                                       n_line);
        for (unsigned int q = 0; q < n_point; ++q)
          stress[q] *= weight(b, q);
        const auto add = [&](const auto direction) {
          constexpr int  d         = decltype(direction)::value;
          Batched *const component = at + d * n_point;
          const Batched  inverse_size =
            *Batched::in(batches[b].inverse_size[d].data());
          for (unsigned int q = 0; q < n_point; ++q)
            change[q] = inverse_size * stress[q];
          apply_along<dim, d, n_static, false>(
            Batched::in(derivatives_transposed.begin()),
            change,
            component,
            n_line);
          if (d == 1 && !radial.empty())
            for (unsigned int q = 0; q < n_point; ++q)
              component[q] += hoop(b, q) * stress[q];
          apply_along_all<dim, n_static>(Batched::in(values_transposed.begin()),
                                         component,
                                         n_line);
        };
        along_all<dim>(add);
        scatter<dim>(at,
                     &fields[Field::displacement].positions[first],
                     strides.data(),
                     n_point,
                     batches[b].n_cells,
                     momentum.begin());
      }
  }



  template <int dim, typename Number>
  template <typename Kernel>
  void
  CellProducts<dim, Number>::sum_up(LevelVector<Number>       &y,
                                    const LevelVector<Number> &x,
                                    const Kernel              &kernel) const
  {
    y = Number();
    x.update_ghost_values();
    if (n == 2)
      kernel(std::integral_constant<int, 2>());
    else if (n == 3)
      kernel(std::integral_constant<int, 3>());
    else if (n == 5)
      kernel(std::integral_constant<int, 5>());
    else
      kernel(std::integral_constant<int, 0>());
    x.zero_out_ghost_values();
    y.compress(VectorOperation::add);
  }



  template <int dim, typename Number>
  template <int n_static>
  void
  CellProducts<dim, Number>::add_cells(const Field::Block         field,
                                       const Factors             &factors,
                                       LevelVector<Number>       &y,
                                       const LevelVector<Number> &x) const
  {
    if (field == Field::temperature)
      scalar_on_cells<n_static>(field, 0, factors, y, x);
    else if (dim == 2 && !radial.empty())
      momentum_on_cells<n_static, dim == 2>(factors, y, x);
    else
      momentum_on_cells<n_static, false>(factors, y, x);
  }



  template <int dim, typename Number>
  template <typename Visit>
  void
  CellProducts<dim, Number>::visit_faces(const Field::Block field,
                                         const double       mass,
                                         const double       stiffness,
                                         const Visit       &visit) const
  {
    const Number factor = field == Field::temperature ? stiffness : mass;
    for (const auto *const entries :
         {&fields[field].at_end, &fields[field].at_sides})
      for (const Entry &entry : *entries)
        visit(entry.row, entry.column, factor * entry.value);
  }



  template <int dim, typename Number>
  void
  CellProducts<dim, Number>::vmult(const Field::Block         field,
                                   const double               mass,
                                   const double               stiffness,
                                   LevelVector<Number>       &y,
                                   const LevelVector<Number> &x) const
  {
    sum_up(y, x, [&](const auto size) {
      if (on_grid)
        on_grid->add(field == Field::temperature ? OnGrid::heat :
                                                   OnGrid::momentum,
                     mass,
                     stiffness,
                     y.begin(),
                     x.begin());
      else
        add_cells<decltype(size)::value>(field, {mass, stiffness}, y, x);
      visit_faces(field,
                  mass,
                  stiffness,
                  [&](const unsigned int row,
                      const unsigned int column,
                      const Number       value) {
                    y.begin()[row] += value * x.begin()[column];
                  });
    });
    const LevelVector<Number> &lumped_mass = fields[field].lumped_mass;
    if (lumped_mass.size() > 0)
      for (unsigned int i = 0; i < y.locally_owned_size(); ++i)
        y.local_element(i) +=
          Number(mass) * lumped_mass.local_element(i) * x.local_element(i);
  }



  template <int dim, typename Number>
  void
  CellProducts<dim, Number>::laplacian(const Field::Block         field,
                                       LevelVector<Number>       &y,
                                       const LevelVector<Number> &x) const
  {
    sum_up(y, x, [&](const auto size) {
      for (unsigned int c = 0; c < n_components(field); ++c)
        scalar_on_cells<decltype(size)::value>(field, c, {0., 1., true}, y, x);
    });
  }



  template <int dim, typename Number>
  void
  CellProducts<dim, Number>::divergence(LevelVector<Number>       &heat,
                                        const LevelVector<Number> &u) const
  {
    sum_up(heat, u, [&](const auto size) {
      if (on_grid)
        on_grid->add(OnGrid::divergence, 0., 1., heat.begin(), u.begin());
      else
        divergence_on_cells<decltype(size)::value>(heat, u);
    });
  }



  template <int dim, typename Number>
  void
  CellProducts<dim, Number>::thermal_stress(
    LevelVector<Number>       &momentum,
    const LevelVector<Number> &theta) const
  {
    sum_up(momentum, theta, [&](const auto size) {
      if (on_grid)
        on_grid->add(
          OnGrid::thermal_stress, 0., 1., momentum.begin(), theta.begin());
      else
        thermal_stress_on_cells<decltype(size)::value>(momentum, theta);
    });
  }



  template <int dim, typename Number>
  void
  CellProducts<dim, Number>::lateral_exchange(
    LevelVector<Number>       &y,
    const LevelVector<Number> &x) const
  {
    sum_up(y, x, [&](const auto) {
      for (const Entry &entry : fields[Field::temperature].at_sides)
        y.begin()[entry.row] += entry.value * x.begin()[entry.column];
    });
  }



  template <int dim, typename Number>
  void
  CellProducts<dim, Number>::contact_stiffness(
    LevelVector<Number>       &y,
    const LevelVector<Number> &x) const
  {
    sum_up(y, x, [&](const auto size) {
      add_cells<decltype(size)::value>(Field::displacement,
                                       {0., 1., false, true},
                                       y,
                                       x);
    });
  }



  template <int dim, typename Number>
  void
  CellProducts<dim, Number>::add_diagonal(const Field::Block   field,
                                          const Factors       &factors,
                                          LevelVector<Number> &y) const
  {
    using Batched         = Lanes<Number>;
    const bool is_elastic = field == Field::displacement && !factors.is_of_mesh;
    const bool has_hoop   = is_elastic && !radial.empty();
    const Number shear =
      (is_elastic ? 0.5 * material.two_mu : 1.) * factors.stiffness;
    const Number lambda = is_elastic ? material.lambda * factors.stiffness : 0.;
    const Number normal = is_elastic ? 2 * shear + lambda : shear;
    Batched *const sum  = reinterpret_cast<Batched *>(scratch.begin());
    Batched *const terms = sum + n_nodes;
    for (unsigned int b = first_batch(factors); b < batches.size(); ++b)
      for (unsigned int c = 0; c < n_components(field); ++c)
        {
          const Batch &batch = batches[b];
          // squares of a basis function, of another kind along one direction
          const auto add = [&](const unsigned int along,
                               const Square       kind,
                               const auto        &factor) {
            for (unsigned int q = 0; q < n_nodes; ++q)
              terms[q] = weight(b, q, factors.is_of_mesh) * factor(q);
            along_all<dim>([&](const auto direction) {
              constexpr int d = decltype(direction)::value;
              apply_along<dim, d, 0, false>(
                Batched::in(squares[d == int(along) ? kind : of_value].begin()),
                terms,
                terms,
                n);
            });
            for (unsigned int i = 0; i < n_nodes; ++i)
              sum[i] += terms[i];
          };
          const bool has_mass =
            !has_lumped_mass &&
            (field == Field::temperature || c > 0 || batch.has_axial_mass);
          std::fill_n(sum, n_nodes, Batched{});
          add(0, of_value, [&](const unsigned int q) {
            Batched factor = Batched::all(has_mass ? factors.mass : 0.);
            if (has_hoop && c == 1)
              factor += hoop(b, q) * hoop(b, q) * normal;
            return factor;
          });
          for (unsigned int d = 0; d < dim; ++d)
            {
              const Batched per_size =
                *Batched::in(batch.inverse_size[d].data());
              add(d, of_derivative, [&](const unsigned int) {
                return per_size * per_size * (c == d ? normal : shear);
              });
              if (has_hoop && c == 1 && d == 1)
                add(d, of_both, [&](const unsigned int q) {
                  return per_size * hoop(b, q) * (2 * lambda);
                });
            }
          scatter<1>(
            sum,
            &fields[field].positions[std::size_t(b) * n_nodes * n_lanes],
            strides.data(),
            n_nodes,
            batch.n_cells,
            y.begin(),
            c);
        }
  }



  template <int dim, typename Number>
  LevelVector<Number>
  CellProducts<dim, Number>::diagonal(const Field::Block field,
                                      const double       mass,
                                      const double       stiffness) const
  {
    LevelVector<Number> result = make_vector(field);
    add_diagonal(field, {mass, stiffness}, result);
    visit_faces(field,
                mass,
                stiffness,
                [&](const unsigned int row,
                    const unsigned int column,
                    const Number       value) {
                  if (row == column)
                    result.begin()[row] += value;
                });
    result.compress(VectorOperation::add);
    if (fields[field].lumped_mass.size() > 0)
      result.add(mass, fields[field].lumped_mass);
    return result;
  }



  template <int dim, typename Number>
  LevelVector<Number>
  CellProducts<dim, Number>::laplacian_diagonal(const Field::Block field) const
  {
    LevelVector<Number> result = make_vector(field);
    add_diagonal(field, {0., 1., true}, result);
    result.compress(VectorOperation::add);
    return result;
  }



  template <int dim, typename Number>
  LevelVector<Number>
  CellProducts<dim, Number>::contact_stiffness_diagonal() const
  {
    LevelVector<Number> result = make_vector(Field::displacement);
    add_diagonal(Field::displacement, {0., 1., false, true}, result);
    result.compress(VectorOperation::add);
    return result;
  }



  namespace
  {
    /** Appends a number for all lanes. */
    template <unsigned int n_lanes, typename Number>
    void
    append(AlignedVector<Number> &numbers, const double value)
    {
      for (unsigned int lane = 0; lane < n_lanes; ++lane)
        numbers.push_back(value);
    }



    /** Sides of a cell that is a box. */
    template <int dim>
    Tensor<1, dim>
    size_of(const typename DoFHandler<dim>::active_cell_iterator &cell)
    {
      return cell->vertex(GeometryInfo<dim>::vertices_per_cell - 1) -
             cell->vertex(0);
    }
  } // namespace



  template <int dim, typename Number>
  CellProducts<dim, Number>::CellProducts(
    const Scene               &scene,
    const Discretization<dim> &discretization)
    : discretization(discretization)
    , geometry(discretization.geometry())
    , material(scene.material)
    , n(discretization.degree() + 1)
    , n_nodes(Utilities::fixed_power<dim>(n))
    , has_lumped_mass(scene.has_lumped_mass)
    , scratch((dim + dim * dim) * n_nodes * n_lanes)
  {
    tabulate();
    compute_strides();
    const auto cells = make_batches(scene.contact.has_massless_nodes);
    if (!geometry.has_uniform_weight())
      compute_radial(cells);
    for (const Field::Block field : all_fields)
      if (discretization.has_field(field))
        {
          fields[field].prototype.reinit(
            discretization.make_vector(field).get_partitioner());
          compute_positions(field, cells);
          if (has_lumped_mass)
            collect_lumped_mass(field, cells);
        }
    collect_faces(scene);
    if (n == 2 &&
        Utilities::MPI::n_mpi_processes(discretization.communicator()) == 1)
      make_grid_products(scene);
  }



  template <int dim, typename Number>
  void
  CellProducts<dim, Number>::make_grid_products(const Scene &scene)
  {
    const LevelGrid<dim> grid(scene.parameters.mesh);
    std::array<std::vector<unsigned int>, 2>
      entries; // of their first component
    for (const Field::Block field : all_fields)
      if (discretization.has_field(field))
        {
          const auto &values = discretization.nodal_values(field);
          entries[field].resize(grid.n_nodes());
          for (unsigned int i = 0; i < values.size(); ++i)
            if (values[i].component == 0)
              entries[field][grid.number(values[i].node)] = i;
        }
    on_grid = std::make_unique<const OnGrid>(scene, geometry, grid, entries);
  }



  template <int dim, typename Number>
  LevelVector<Number>
  CellProducts<dim, Number>::make_vector(const Field::Block field) const
  {
    return fields[field].prototype;
  }



  template <int dim, typename Number>
  void
  CellProducts<dim, Number>::tabulate()
  {
    const QGauss<1> rule(n);
    const auto      nodal = Polynomials::generate_complete_Lagrange_basis(
      QGaussLobatto<1>(n).get_points());
    const auto at_points =
      Polynomials::generate_complete_Lagrange_basis(rule.get_points());
    for (unsigned int i = 0; i < n; ++i)
      for (unsigned int j = 0; j < n; ++j)
        {
          append<n_lanes>(values, nodal[j].value(rule.point(i)[0]));
          append<n_lanes>(values_transposed, nodal[i].value(rule.point(j)[0]));
          append<n_lanes>(derivatives,
                          at_points[j].derivative().value(rule.point(i)[0]));
          append<n_lanes>(derivatives_transposed,
                          at_points[i].derivative().value(rule.point(j)[0]));
          const double value = nodal[i].value(rule.point(j)[0]);
          const double slope = nodal[i].derivative().value(rule.point(j)[0]);
          append<n_lanes>(squares[of_value], value * value);
          append<n_lanes>(squares[of_both], value * slope);
          append<n_lanes>(squares[of_derivative], slope * slope);
        }
    const Quadrature<dim> of_cell(rule);
    for (const double weight : of_cell.get_weights())
      append<n_lanes>(weights, weight);
  }



  template <int dim, typename Number>
  std::vector<std::vector<typename CellProducts<dim, Number>::Cell>>
  CellProducts<dim, Number>::make_batches(const bool has_massless_nodes)
  {
    std::vector<std::vector<Cell>> cells;
    for (const bool at_end : {false, true})
      {
        const unsigned int n_before = first_at_end = cells.size();
        for (const Cell &cell :
             discretization.dof_handler().active_cell_iterators())
          if (cell->is_locally_owned() &&
              touches_contact_end<dim>(cell) == at_end)
            {
              if (cells.size() == n_before || cells.back().size() == n_lanes)
                cells.emplace_back();
              cells.back().push_back(cell);
            }
        for (unsigned int b = n_before; b < cells.size(); ++b)
          {
            Batch batch;
            batch.n_cells        = cells[b].size();
            batch.has_axial_mass = !(at_end && has_massless_nodes);
            for (unsigned int lane = 0; lane < n_lanes; ++lane)
              {
                const Tensor<1, dim> size =
                  size_of<dim>(cells[b][lane < batch.n_cells ? lane : 0]);
                batch.volume[lane] = 1.;
                for (unsigned int d = 0; d < dim; ++d)
                  {
                    batch.inverse_size[d][lane] = 1. / size[d];
                    batch.volume[lane] *= size[d];
                  }
              }
            batches.push_back(batch);
          }
      }
    return cells;
  }



  template <int dim, typename Number>
  void
  CellProducts<dim, Number>::compute_radial(
    const std::vector<std::vector<Cell>> &cells)
  {
    const QGauss<1> rule(n);
    for (const auto &batch : cells)
      for (unsigned int q = 0; q < n; ++q)
        for (const bool is_strain : {false, true})
          for (unsigned int lane = 0; lane < n_lanes; ++lane)
            {
              const Cell &cell  = batch[lane < batch.size() ? lane : 0];
              Point<dim>  point = cell->vertex(0);
              point[1] += rule.point(q)[0] * size_of<dim>(cell)[1];
              radial.push_back(is_strain ?
                                 geometry.strain_per_displacement(point) :
                                 geometry.weight_at(point));
            }
  }



  template <int dim, typename Number>
  void
  CellProducts<dim, Number>::compute_strides()
  {
    // a FESystem numbers the components of a vertex, line, face one by one
    lexicographic = FETools::hierarchic_to_lexicographic_numbering<dim>(n - 1);
    const FE_Q<dim> fe(n - 1);
    strides.resize(n_nodes);
    for (unsigned int i = 0; i < n_nodes; ++i)
      {
        const unsigned int object_dim = i < fe.get_first_line_index() ? 0U :
                                        i < fe.get_first_quad_index() ? 1U :
                                        i < fe.get_first_hex_index()  ? 2U :
                                                                        3U;
        strides[lexicographic[i]]     = power_of(n - 2, object_dim);
      }
  }



  template <int dim, typename Number>
  std::vector<unsigned int>
  CellProducts<dim, Number>::local_positions(const Field::Block field,
                                             const Cell        &cell) const
  {
    const FiniteElement<dim>            &fe = discretization.finite_element();
    std::vector<types::global_dof_index> dofs(fe.dofs_per_cell);
    cell->get_dof_indices(dofs);
    std::vector<unsigned int> positions(n_nodes);
    for (unsigned int i = 0; i < n_nodes; ++i)
      for (unsigned int c = 0; c < n_components(field); ++c)
        {
          const unsigned int at =
            position(field,
                     dofs[fe.component_to_system_index(
                       discretization.first_component(field) + c, i)]);
          unsigned int &first = positions[lexicographic[i]];
          if (c == 0)
            first = at;
          AssertThrow(at == first + c * strides[lexicographic[i]],
                      ExcInternalError());
        }
    return positions;
  }



  template <int dim, typename Number>
  void
  CellProducts<dim, Number>::compute_positions(
    const Field::Block                    field,
    const std::vector<std::vector<Cell>> &cells)
  {
    std::vector<unsigned int> &positions = fields[field].positions;
    for (const auto &batch : cells)
      {
        const std::size_t first = positions.size();
        positions.resize(first + n_nodes * n_lanes);
        for (unsigned int lane = 0; lane < n_lanes; ++lane)
          {
            const std::vector<unsigned int> of_cell =
              local_positions(field, batch[lane < batch.size() ? lane : 0]);
            for (unsigned int i = 0; i < n_nodes; ++i)
              positions[first + i * n_lanes + lane] = of_cell[i];
          }
      }
  }



  template <int dim, typename Number>
  void
  CellProducts<dim, Number>::collect_lumped_mass(
    const Field::Block                    field,
    const std::vector<std::vector<Cell>> &cells)
  {
    LevelVector<Number>     &mass = fields[field].lumped_mass;
    const QGaussLobatto<dim> nodes(n);
    mass = fields[field].prototype;
    for (unsigned int b = 0; b < cells.size(); ++b)
      for (const Cell &cell : cells[b])
        {
          const std::vector<unsigned int> positions =
            local_positions(field, cell);
          const Tensor<1, dim> size   = size_of<dim>(cell);
          double               volume = 1.;
          for (unsigned int d = 0; d < dim; ++d)
            volume *= size[d];
          const bool has_first =
            field == Field::temperature || batches[b].has_axial_mass;
          for (unsigned int i = 0; i < n_nodes; ++i)
            {
              Point<dim> node = cell->vertex(0);
              for (unsigned int d = 0; d < dim; ++d)
                node[d] += nodes.point(i)[d] * size[d];
              for (unsigned int c = has_first ? 0 : 1; c < n_components(field);
                   ++c)
                mass.begin()[positions[i] + c * strides[i]] +=
                  nodes.weight(i) * volume * geometry.weight_at(node);
            }
        }
    mass.compress(VectorOperation::add);
  }



  template <int dim, typename Number>
  void
  CellProducts<dim, Number>::collect_faces(const Scene &scene)
  {
    using Sums = std::map<std::pair<unsigned int, unsigned int>, double>;
    const FiniteElement<dim> &fe = discretization.finite_element();
    HeatExchangeFaces<dim>    faces(scene, discretization);
    FEValues<dim>             massless_values(discretization.mapping(),
                                  fe.base_element(0),
                                  massless_quadrature<dim>(n - 1,
                                                           has_lumped_mass),
                                  update_values | update_quadrature_points |
                                    update_JxW_values);
    std::vector<std::size_t>  nodes, axial_dofs;
    for (unsigned int i = 0; scene.contact.has_massless_nodes && i < n_nodes;
         ++i)
      {
        nodes.push_back(i);
        axial_dofs.push_back(fe.component_to_system_index(
          discretization.first_component(Field::displacement), i));
      }

    std::array<Sums, 2>                  at_end; // of the fields
    Sums                                 at_sides;
    std::vector<types::global_dof_index> dofs(fe.dofs_per_cell);
    for (const Cell &cell :
         discretization.dof_handler().active_cell_iterators())
      if (cell->is_locally_owned() && cell->at_boundary())
        {
          cell->get_dof_indices(dofs);
          const auto add = [&](const Field::Block field,
                               const CellMatrix  &of_cell,
                               Sums              &sums) {
            const double rounding =
              Tolerances::rounding_of_sum * of_cell.matrix.linfty_norm();
            for (unsigned int i = 0; i < of_cell.dofs.size(); ++i)
              for (unsigned int j = 0; j < of_cell.dofs.size(); ++j)
                if (std::abs(of_cell.matrix(i, j)) > rounding)
                  sums[{position(field, dofs[of_cell.dofs[i]]),
                        position(field, dofs[of_cell.dofs[j]])}] +=
                    of_cell.matrix(i, j);
          };
          faces.visit(cell,
                      [&](const CellMatrix &exchange, const bool is_lateral) {
                        add(Field::temperature,
                            exchange,
                            is_lateral ? at_sides : at_end[Field::temperature]);
                      });
          if (!scene.contact.has_massless_nodes ||
              !touches_contact_end<dim>(cell))
            continue;
          massless_values.reinit(
            typename Triangulation<dim>::active_cell_iterator(cell));
          CellMatrix mass =
            mass_between(discretization, nodes, massless_values, 1.);
          mass.dofs = axial_dofs;
          add(Field::displacement, mass, at_end[Field::displacement]);
        }
    const auto keep = [](const Sums &sums, std::vector<Entry> &entries) {
      for (const auto &[place, value] : sums)
        entries.push_back({place.first, place.second, Number(value)});
    };
    for (const Field::Block field : all_fields)
      keep(at_end[field], fields[field].at_end);
    keep(at_sides, fields[Field::temperature].at_sides);
  }



  template class CellProducts<2, float>;
  template class CellProducts<2, double>;
  template class CellProducts<3, float>;
  template class CellProducts<3, double>;
} // namespace ThermoContact
