// SPDX-License-Identifier: LGPL-2.1-or-later

#include <thermocontact/base/tolerances.h>
#include <thermocontact/input/load_enclosure.h>
#include <thermocontact/space/enclosed_function.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <vector>

namespace ThermoContact
{
  namespace
  {
    /**
     * More pieces of a cell are not worth their time: a jump across the axis
     * takes 50, one along a curve is then followed to a hundredth of a cell.
     */
    constexpr std::size_t max_pieces = 256;



    /** Along an axis of a small piece, in which a load is nearly a parabola. */
    constexpr unsigned int fewest_points = 4;



    /**
     * The axis along which a piece has to be halved, if there is one: of those
     * along which it is not smooth the longest, in lengths of the cell.
     */
    template <int dim>
    std::optional<unsigned int>
    rough_direction(const EnclosedFunction<dim> &function,
                    const unsigned int           component,
                    const BoundingBox<dim>      &piece,
                    const BoundingBox<dim>      &cell,
                    const double                 negligible)
    {
      double part = 1.; // of the cell
      for (unsigned int d = 0; d < dim; ++d)
        if (cell.side_length(d) > 0.)
          part *= piece.side_length(d) / cell.side_length(d);
      std::optional<unsigned int> rough;
      double                      longest = 0.;
      for (unsigned int d = 0; d < dim; ++d)
        {
          const double h = piece.side_length(d);
          if (!(h > 0.) || !function.varies_along(d, component))
            continue;
          const IntervalJet all = function.enclosure(piece, d, component);
          if (all.value.width() * part <= negligible)
            return {};
          const double length = h / cell.side_length(d);
          if (length > longest &&
              !is_nearly_parabolic(
                all,
                function.derivatives(piece.center(), d, component),
                h,
                negligible))
            {
              rough   = d;
              longest = length;
            }
        }
      return rough;
    }



    template <int dim>
    std::vector<BoundingBox<dim>>
    smooth_pieces(const EnclosedFunction<dim> &function,
                  const unsigned int           component,
                  const BoundingBox<dim>      &cell,
                  const double                 negligible)
    {
      // level by level, so that what is left over in the end is small
      std::vector<BoundingBox<dim>> pieces, level{cell}, halves;
      while (!level.empty())
        {
          halves.clear();
          for (std::size_t i = 0; i < level.size(); ++i)
            {
              const std::size_t n_pieces =
                pieces.size() + halves.size() + level.size() - i;
              const auto direction = n_pieces < max_pieces ?
                                       rough_direction(function,
                                                       component,
                                                       level[i],
                                                       cell,
                                                       negligible) :
                                       std::nullopt;
              if (!direction)
                {
                  pieces.push_back(level[i]);
                  continue;
                }
              const Point<dim> middle   = level[i].center();
              auto [low, high]          = level[i].get_boundary_points();
              low[*direction]           = middle[*direction];
              auto before               = level[i].get_boundary_points();
              before.second[*direction] = middle[*direction];
              halves.emplace_back(before);
              halves.emplace_back(std::pair(low, high));
            }
          level.swap(halves);
        }
      return pieces;
    }
  } // namespace



  template <int dim>
  double
  EnclosedFunction<dim>::bound(const BoundingBox<dim> &box,
                               const unsigned int      component) const
  {
    const double bound = enclosure(box, 0, component).value.magnitude();
    return std::isfinite(bound) ? bound : 0.;
  }



  template <int dim>
  PiecewiseRule<dim>::PiecewiseRule(const EnclosedFunction<dim> &function,
                                    const BoundingBox<dim>      &body,
                                    const unsigned int           n_points)
    : function(function)
  {
    for (unsigned int n = n_points; n >= std::min(n_points, fewest_points); --n)
      rules.emplace_back(n);
    for (unsigned int c = 0; c < function.n_components; ++c)
      negligible.push_back(Tolerances::negligible_load *
                           function.bound(body, c));
  }



  template <int dim>
  bool
  PiecewiseRule<dim>::is_smooth(const BoundingBox<dim> &box,
                                const unsigned int      component) const
  {
    return !rough_direction(
      function, component, box, box, negligible[component]);
  }



  template <int dim>
  Quadrature<dim>
  PiecewiseRule<dim>::operator()(const BoundingBox<dim> &box,
                                 const unsigned int      component) const
  {
    const std::vector<BoundingBox<dim>> pieces =
      smooth_pieces(function, component, box, negligible[component]);
    std::vector<Point<dim>> points;
    std::vector<double>     weights;
    for (const BoundingBox<dim> &piece : pieces)
      {
        // of what a polynomial is in half of a box each degree is halved
        std::array<const dealii::QGauss<1> *, dim> lines{};
        unsigned int                               n = 1;
        for (unsigned int d = 0; d < dim; ++d)
          if (piece.side_length(d) > 0.)
            {
              const unsigned int n_halvings = std::lround(
                std::log2(box.side_length(d) / piece.side_length(d)));
              lines[d] =
                &rules[std::min<std::size_t>(n_halvings, rules.size() - 1)];
              n *= lines[d]->size();
            }
        for (unsigned int q = 0; q < n; ++q)
          {
            Point<dim> place  = piece.get_boundary_points().first;
            double     weight = 1.;
            for (unsigned int d = 0, rest = q; d < dim; ++d)
              if (lines[d] != nullptr)
                {
                  const double       h = piece.side_length(d);
                  const unsigned int k = rest % lines[d]->size();
                  place[d] += h * lines[d]->point(k)[0];
                  weight *= h * lines[d]->weight(k);
                  rest /= lines[d]->size();
                }
            points.push_back(place);
            weights.push_back(weight);
          }
      }
    return Quadrature<dim>(points, weights);
  }



#define INSTANTIATE(dim)                \
  template class EnclosedFunction<dim>; \
  template class PiecewiseRule<dim>

  INSTANTIATE(1);
  INSTANTIATE(2);
  INSTANTIATE(3);

#undef INSTANTIATE
} // namespace ThermoContact
