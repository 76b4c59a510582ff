// SPDX-License-Identifier: LGPL-2.1-or-later

#include <thermocontact/base/special_numbers.h>
#include <thermocontact/base/tolerances.h>
#include <thermocontact/space/level_grid.h>

#include <deal.II/base/quadrature_lib.h>

#include <algorithm>

namespace ThermoContact
{
  namespace
  {
    /** A level has at most this part of the nodes of the next finer one. */
    constexpr double most_nodes = 0.8;

    /** By which the distance grows below which nodes are left out. */
    constexpr double growth = 1.25;

    /**
     * Length of a cell over the width of the body at most: longer ones cannot
     * bend.
     */
    constexpr double longest_cell = 4.;

    /** Of coarser levels; flows without dilatation need two. */
    constexpr unsigned int largest_degree = 2;



    /** Gauss-Lobatto points of the cells of a body. */
    std::vector<double>
    nodes_of_cells(const MeshParameters &mesh, const std::vector<double> &sizes)
    {
      const dealii::QGaussLobatto<1> points(mesh.degree + 1);
      const unsigned int             n_parts = 1U << mesh.refinements;
      std::vector<double>            nodes{0.};
      double                         start = 0.;
      for (const double size : sizes)
        {
          for (unsigned int part = 0; part < n_parts; ++part)
            for (unsigned int k = 1; k <= mesh.degree; ++k)
              nodes.push_back(start +
                              size * (part + points.point(k)[0]) / n_parts);
          start += size;
        }
      return nodes;
    }



    double
    shortest_cell(const std::vector<double> &nodes, const unsigned int degree)
    {
      double shortest = infinity;
      for (unsigned int i = 0; i + degree < nodes.size(); i += degree)
        shortest = std::min(shortest, nodes[i + degree] - nodes[i]);
      return shortest;
    }



    /** With one cell for two that are no longer than @p length together. */
    std::vector<double>
    thinned(const std::vector<double> &nodes,
            const unsigned int         degree,
            const double               length)
    {
      std::vector<double> result{nodes.front()};
      for (unsigned int i = 0, next = 0; i + 1 < nodes.size(); i = next)
        {
          next = i + 2 * degree;
          if (next >= nodes.size() || nodes[next] - nodes[i] > length)
            next = i + degree;
          if (degree > 1)
            result.push_back(nodes[(i + next) / 2]);
          result.push_back(nodes[next]);
        }
      return result;
    }
  } // namespace



  ValueAndSlope
  lagrange(const double      *nodes,
           const unsigned int degree,
           const unsigned int i,
           const double       x)
  {
    ValueAndSlope result{1., 0.};
    for (unsigned int j = 0; j <= degree; ++j)
      if (j != i)
        {
          const double length = nodes[i] - nodes[j], part = x - nodes[j];
          result.slope = (result.slope * part + result.value) / length;
          result.value *= part / length;
        }
    return result;
  }



  template <int dim>
  LevelGrid<dim>::LevelGrid(const MeshParameters &mesh)
    : axes{{nodes_of_cells(mesh, mesh.cell_sizes()),
            nodes_of_cells(mesh, mesh.cell_sizes_across())}}
    , degree_(mesh.degree)
  {}



  template <int dim>
  std::optional<LevelGrid<dim>>
  LevelGrid<dim>::coarsened() const
  {
    LevelGrid  coarse(*this);
    const auto thin = [&](const double length) {
      coarse.axes = {{thinned(axes[0],
                              degree_,
                              std::min(length, longest_cell * axes[1].back())),
                      thinned(axes[1], degree_, length)}};
    };
    if (degree_ > largest_degree)
      {
        coarse.degree_ = largest_degree;
        thin(0.);
        return coarse;
      }
    double length = infinity, longest = 0.;
    for (const std::vector<double> &axis : axes)
      if (axis.size() > degree_ + 1)
        {
          length  = std::min(length, 2. * shortest_cell(axis, degree_));
          longest = std::max(longest, axis.back() - axis.front());
        }
    for (length *= 1. + Tolerances::rounding_of_data;
         coarse.n_nodes() > most_nodes * n_nodes() && length < growth * longest;
         length *= growth)
      thin(length);
    if (coarse.n_nodes() == n_nodes())
      return {};
    return coarse;
  }



  template <int dim>
  unsigned int
  LevelGrid<dim>::n_nodes() const
  {
    return strides()[0] * axes[0].size();
  }



  template <int dim>
  typename LevelGrid<dim>::Index
  LevelGrid<dim>::strides() const
  {
    Index strides;
    strides[dim - 1] = 1;
    for (unsigned int d = dim - 1; d > 0; --d)
      strides[d - 1] = strides[d] * axes[1].size();
    return strides;
  }



  template <int dim>
  typename LevelGrid<dim>::Index
  LevelGrid<dim>::index(unsigned int node) const
  {
    Index index;
    for (unsigned int d = dim; d-- > 0; node /= positions(d).size())
      index[d] = node % positions(d).size();
    return index;
  }



  template <int dim>
  dealii::Point<dim>
  LevelGrid<dim>::node(const Index &index) const
  {
    dealii::Point<dim> point;
    for (unsigned int d = 0; d < dim; ++d)
      point[d] = positions(d)[index[d]];
    return point;
  }



  template <int dim>
  unsigned int
  LevelGrid<dim>::number(const dealii::Point<dim> &node) const
  {
    unsigned int number = 0;
    for (unsigned int d = 0; d < dim; ++d)
      {
        const std::vector<double> &x = positions(d);
        const double below = node[d] * (1. - Tolerances::rounding_of_data);
        number += strides()[d] *
                  (std::lower_bound(x.begin(), x.end(), below) - x.begin());
      }
    return number;
  }



  template class LevelGrid<2>;
  template class LevelGrid<3>;
} // namespace ThermoContact
