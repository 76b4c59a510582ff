// SPDX-License-Identifier: LGPL-2.1-or-later

#include <thermocontact/method/two_stops.h>

#include <limits>
#include <utility>

namespace ThermoContact
{
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
