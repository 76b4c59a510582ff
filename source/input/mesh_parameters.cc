// SPDX-License-Identifier: LGPL-2.1-or-later

#include <thermocontact/input/parameters.h>

#include <cmath>

namespace ThermoContact
{
  std::vector<double>
  MeshParameters::cell_sizes() const
  {
    const double factor =
      cells > 1 ? std::pow(grading, -1. / (cells - 1.)) : 1.;
    std::vector<double> sizes(cells);
    double              sum = 0.;
    for (unsigned int i = 0; i < cells; ++i)
      sum += sizes[i] = std::pow(factor, i);
    for (double &size : sizes)
      size /= sum;
    return sizes;
  }



  unsigned int
  MeshParameters::n_halvings() const
  {
    unsigned int n = 0;
    while (grading == 1. && cells % (2U << n) == 0 &&
           cells_across % (2U << n) == 0)
      ++n;
    return n;
  }



  double
  MeshParameters::n_nodes(const unsigned int dim) const
  {
    const auto along = [this](const unsigned int n_cells) {
      return degree * std::ldexp(n_cells, refinements) + 1.;
    };
    return along(cells) * std::pow(along(cells_across), dim - 1.);
  }



  double
  MeshParameters::contact_spacing() const
  {
    return std::ldexp(cell_sizes().back(), -static_cast<int>(refinements)) /
           degree;
  }
} // namespace ThermoContact
