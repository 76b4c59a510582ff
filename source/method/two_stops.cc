// SPDX-License-Identifier: LGPL-2.1-or-later

#include <thermocontact/method/bracketed_root.h>
#include <thermocontact/method/two_stops.h>

#include <algorithm>
#include <limits>
#include <utility>

namespace ThermoContact
{
  double
  crossing_pressure(const double compliance,
                    const double start,
                    const double free_end,
                    const double receptance,
                    const double width)
  {
    const auto potential = [&](const double s) {
      const double beyond = std::max({s, -s - width, 0.});
      return beyond * beyond / (2. * compliance);
    };
    const auto mean = [&](const double end) {
      // at one stop, or in the play, without the difference of potentials
      if (std::min(start, end) >= 0.)
        return (start + end) / (2. * compliance);
      if (std::max(start, end) <= -width)
        return (start + end + 2. * width) / (2. * compliance);
      if (std::max(start, end) <= 0. && std::min(start, end) >= -width)
        return 0.;
      return (potential(end) - potential(start)) / (end - start);
    };
    // grows with the end, since the potential is convex
    const auto excess = [&](const double end) {
      return end + receptance * mean(end) - free_end;
    };
    const double other = free_end - receptance * mean(free_end);
    if (other == free_end)
      return mean(free_end);
    return mean(bracketed_root(excess,
                               std::min(other, free_end),
                               std::max(other, free_end))
                  .first);
  }



  void
  NearerStops::choose()
  {
    sides.assign(far.size(), 1.);
    for (unsigned int i = 0; i < far.size(); ++i)
      if (nearer_stop(near[i], far[i]) < 0)
        {
          sides[i] = -1.;
          std::swap(near[i], far[i]);
        }
  }



  void
  NearerStops::see_from(const unsigned int node, const int new_side)
  {
    if (sides[node] * new_side < 0.)
      std::swap(near[node], far[node]);
    sides[node] = new_side;
  }



  void
  NearerStops::turn(std::vector<double> &values) const
  {
    if (are_two())
      for (unsigned int i = 0; i < values.size(); ++i)
        if (sides[i] < 0.)
          values[i] = 0. - values[i]; // zero stays positive
  }



  void
  NearerStops::turn_rows(dealii::FullMatrix<double> &matrix) const
  {
    if (are_two())
      for (unsigned int i = 0; i < matrix.m(); ++i)
        for (unsigned int j = 0; j < matrix.n(); ++j)
          matrix(i, j) *= sides[i];
  }



  void
  NearerStops::turn_columns(dealii::FullMatrix<double> &matrix) const
  {
    if (are_two())
      for (unsigned int i = 0; i < matrix.m(); ++i)
        for (unsigned int j = 0; j < matrix.n(); ++j)
          matrix(i, j) *= sides[j];
  }



  dealii::FullMatrix<double>
  NearerStops::turned(dealii::FullMatrix<double> matrix) const
  {
    turn_rows(matrix);
    turn_columns(matrix);
    return matrix;
  }



  NearerStops
  NearerStops::in_motion(const std::vector<unsigned int> &nodes,
                         const std::vector<double>       &velocity) const
  {
    NearerStops result;
    for (const unsigned int node : nodes)
      {
        result.near.push_back(side(node) * velocity[node]);
        if (!are_two())
          continue;
        result.sides.push_back(side(node));
        result.far.push_back(-std::numeric_limits<double>::infinity());
      }
    return result;
  }
} // namespace ThermoContact
