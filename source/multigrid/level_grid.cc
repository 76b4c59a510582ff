// SPDX-License-Identifier: LGPL-2.1-or-later

#include <thermocontact/base/tolerances.h>
#include <thermocontact/base/types.h>
#include <thermocontact/multigrid/level_grid.h>

#include <deal.II/base/quadrature_lib.h>

#include <algorithm>
#include <limits>

namespace ThermoContact
{
  namespace
  {
    /** A level has at most this part of the nodes of the next finer one. */
    constexpr double coarsening = 0.7;

    /** Doublings of the shortest length from a level to the next. */
    constexpr unsigned int max_doublings = 3;



    GridAxis
    axis_of_body(const MeshParameters &mesh, const std::vector<double> &sizes)
    {
      GridAxis           axis{mesh.degree, {0.}};
      const unsigned int n_parts = 1U << mesh.refinements;
      for (const double size : sizes)
        {
          const double start = axis.ends.back();
          for (unsigned int i = 1; i <= n_parts; ++i)
            axis.ends.push_back(start + size * i / n_parts);
        }
      return axis;
    }
  } // namespace



  double
  GridAxis::shortest() const
  {
    double size = std::numeric_limits<double>::infinity();
    for (unsigned int i = 0; i < n_cells(); ++i)
      size = std::min(size, ends[i + 1] - ends[i]);
    return size / degree;
  }



  double
  GridAxis::longest() const
  {
    double size = 0.;
    for (unsigned int i = 0; i < n_cells(); ++i)
      size = std::max(size, ends[i + 1] - ends[i]);
    return size / degree;
  }



  std::vector<double>
  GridAxis::nodes() const
  {
    const QGaussLobatto<1> points(degree + 1);
    std::vector<double>    result{ends.front()};
    for (unsigned int i = 0; i < n_cells(); ++i)
      for (unsigned int k = 1; k <= degree; ++k)
        result.push_back(ends[i] +
                         points.point(k)[0] * (ends[i + 1] - ends[i]));
    return result;
  }



  GridAxis
  GridAxis::coarsened(const double length, const double across) const
  {
    const double slack = 1. + Tolerances::rounding_of_data;
    const double limit = length * slack;
    if (degree > 1)
      {
        if (2. * shortest() > limit)
          return *this;
        if (longest() <= slack * std::max(across, shortest()))
          return {degree / 2, ends};
        return GridAxis{1, nodes()}.coarsened(length, across);
      }
    GridAxis coarse{1, {ends.front()}};
    for (unsigned int i = 0; i < n_cells();)
      {
        const bool is_joined =
          i + 2 <= n_cells() && ends[i + 2] - ends[i] <= limit;
        i += is_joined ? 2 : 1;
        coarse.ends.push_back(ends[i]);
      }
    return coarse;
  }



  template <int dim>
  LevelGrid<dim>::LevelGrid(const MeshParameters &mesh)
    : axes{{axis_of_body(mesh, mesh.cell_sizes()),
            axis_of_body(mesh, mesh.cell_sizes_across())}}
  {}



  template <int dim>
  std::optional<LevelGrid<dim>>
  LevelGrid<dim>::coarsened() const
  {
    LevelGrid          coarse(*this);
    const unsigned int n_before   = n_nodes();
    unsigned int       n_doubling = 0;
    while (n_doubling < max_doublings &&
           coarse.n_nodes() > coarsening * n_before)
      {
        double length = std::numeric_limits<double>::infinity();
        for (const GridAxis &axis : coarse.axes)
          if (axis.n_nodes() > 2)
            length = std::min(length, 2. * axis.shortest());
        if (length == std::numeric_limits<double>::infinity())
          break;
        // neighbours of the shortest cell may be longer
        for (unsigned int n = coarse.n_nodes(); coarse.n_nodes() == n;
             length *= 2.)
          coarse.axes = {
            {coarse.axes[0].coarsened(length, coarse.axes[1].shortest()),
             coarse.axes[1].coarsened(length, coarse.axes[0].shortest())}};
        ++n_doubling;
      }
    if (coarse.n_nodes() == n_before)
      return {};
    return coarse;
  }



  template <int dim>
  unsigned int
  LevelGrid<dim>::n_nodes() const
  {
    unsigned int n = 1;
    for (unsigned int d = 0; d < dim; ++d)
      n *= axis(d).n_nodes();
    return n;
  }



  template <int dim>
  unsigned int
  LevelGrid<dim>::number_of_node(
    const std::array<unsigned int, dim> &index) const
  {
    unsigned int number = 0;
    for (unsigned int d = 0; d < dim; ++d)
      number = number * axis(d).n_nodes() + index[d];
    return number;
  }



  template <int dim>
  unsigned int
  LevelGrid<dim>::bandwidth() const
  {
    std::array<unsigned int, dim> last;
    for (unsigned int d = 0; d < dim; ++d)
      last[d] = axis(d).degree;
    return number_of_node(last);
  }



  template class LevelGrid<2>;
  template class LevelGrid<3>;
} // namespace ThermoContact
