// SPDX-License-Identifier: LGPL-2.1-or-later

#include <thermocontact/space/flexible_gmres.h>

#include <cmath>

namespace ThermoContact
{
  FlexibleGmres::FlexibleGmres(const unsigned int max_directions)
    : max_directions(max_directions)
  {
    basis.reserve(max_directions); // else they are copied as their number grows
    directions.reserve(max_directions);
  }



  void
  FlexibleGmres::extend_basis()
  {
    basis.emplace_back();
    basis.back().reinit(residual, true);
    basis.back().equ(residual_norm > 0. ? 1. / residual_norm : 0., residual);
  }



  void
  FlexibleGmres::start(const double norm)
  {
    columns.clear();
    rotations.clear();
    projected.assign(1, norm);
    residual_norm = norm;
  }



  void
  FlexibleGmres::keep_direction()
  {
    directions.emplace_back(); // such vectors cannot be moved, only copied
    Direction &kept = directions.back();
    kept.values.reinit(direction.n_blocks());
    for (unsigned int i = 0; i < direction.n_blocks(); ++i)
      kept.values.block(i).reinit(direction.block(i), true);
    kept.values.collect_sizes();
    for (unsigned int i = 0; i < direction.n_blocks(); ++i)
      {
        Vector      &values  = direction.block(i);
        auto        &rounded = kept.values.block(i);
        const double largest = values.linfty_norm();
        kept.scales[i]       = largest > 0. ? largest : 1.;
        for (unsigned int k = 0; k < values.locally_owned_size(); ++k)
          {
            rounded.local_element(k) = values.local_element(k) / kept.scales[i];
            values.local_element(k) =
              kept.scales[i] * double(rounded.local_element(k));
          }
      }
  }



  void
  FlexibleGmres::orthogonalize(const unsigned int j)
  {
    std::vector<double> column(j + 2);
    column[0] = residual * basis[0];
    for (unsigned int i = 1; i <= j; ++i)
      column[i] = residual.add_and_dot(-column[i - 1], basis[i - 1], basis[i]);
    column[j + 1] =
      std::sqrt(residual.add_and_dot(-column[j], basis[j], residual));
    residual_norm = column[j + 1];
    columns.push_back(std::move(column));
  }



  double
  FlexibleGmres::rotate(const unsigned int j)
  {
    std::vector<double> &column = columns[j];
    const auto           apply =
      [](const std::array<double, 2> &rotation, double &first, double &second) {
        const double before = first;
        first               = rotation[0] * before + rotation[1] * second;
        second              = rotation[0] * second - rotation[1] * before;
      };
    for (unsigned int i = 0; i < j; ++i)
      apply(rotations[i], column[i], column[i + 1]);
    const double size = std::hypot(column[j], column[j + 1]);
    rotations.push_back(
      size > 0. ?
        std::array<double, 2>{{column[j] / size, column[j + 1] / size}} :
        std::array<double, 2>{{1., 0.}});
    apply(rotations[j], column[j], column[j + 1]);
    projected.push_back(0.);
    apply(rotations[j], projected[j], projected[j + 1]);
    return std::abs(projected[j + 1]);
  }



  void
  FlexibleGmres::add_solution(const unsigned int n, BlockVector &x) const
  {
    std::vector<double> factors(n);
    for (unsigned int i = n; i-- > 0;)
      {
        double sum = projected[i];
        for (unsigned int j = i + 1; j < n; ++j)
          sum -= columns[j][i] * factors[j];
        factors[i] = columns[i][i] != 0. ? sum / columns[i][i] : 0.;
      }
    for (unsigned int j = 0; j < n; ++j)
      for (unsigned int i = 0; i < x.n_blocks(); ++i)
        {
          Vector      &values    = x.block(i);
          const auto  &direction = directions[j].values.block(i);
          const double factor    = factors[j] * directions[j].scales[i];
          for (unsigned int k = 0; k < values.locally_owned_size(); ++k)
            values.local_element(k) += factor * direction.local_element(k);
        }
  }
} // namespace ThermoContact
