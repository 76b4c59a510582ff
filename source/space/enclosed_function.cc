// SPDX-License-Identifier: LGPL-2.1-or-later

#include <thermocontact/base/tolerances.h>
#include <thermocontact/input/load_enclosure.h>
#include <thermocontact/space/enclosed_function.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <queue>
#include <vector>

namespace ThermoContact
{
  namespace
  {
    /** More pieces of a cell are not worth their time; a jump takes 80. */
    constexpr std::size_t max_pieces = 256;

    /** Along an axis of a small piece, in which a load is nearly a parabola. */
    constexpr unsigned int fewest_points = 4;

    /**
     * How far a component may be from a parabola in a piece, in parts of its
     * largest value in the cell: Gauss's rule sees the rest.
     */
    constexpr double nearly_parabolic = 0.1;



    /** A piece of a box. */
    template <int dim>
    struct Piece
    {
      BoundingBox<dim> box;

      /** The axis along which it has to be halved, if there is one. */
      std::optional<unsigned int> rough = {};

      /** A bound of what a rule may miss in it, per volume of the whole box. */
      double missed = 0.;

      bool
      operator<(const Piece &other) const
      {
        return missed < other.missed;
      }
    };



    /** The pieces of a box, halved where it may be missed most. */
    template <int dim>
    class Pieces
    {
    public:
      Pieces(const EnclosedFunction<dim> &function,
             const unsigned int           component,
             const BoundingBox<dim>      &box,
             const double                 bound)
        : function(function)
        , component(component)
        , whole(box)
        , bound(bound)
      {}

      /**
       * Looks at a piece. Of the axes along which the component is not nearly
       * a parabola it is to be halved along the longest, in lengths of the box.
       */
      Piece<dim>
      look(const BoundingBox<dim> &box)
      {
        Piece<dim> piece{box};
        double     part = 1., longest = 0.;
        for (unsigned int d = 0; d < dim; ++d)
          if (whole.side_length(d) > 0.)
            part *= box.side_length(d) / whole.side_length(d);
        for (unsigned int d = 0; d < dim; ++d)
          {
            const double h = box.side_length(d);
            if (!(h > 0.) || !function.varies_along(d, component))
              continue;
            const IntervalJet all = function.enclosure(box, d, component);
            if (part == 1. && all.value.is_finite())
              of_whole = all.value.magnitude();
            piece.missed = all.value.width() * part;
            if (piece.missed <= Tolerances::least_load * bound)
              return {box};
            const double length = h / whole.side_length(d);
            if (length > longest &&
                !is_nearly_parabolic(
                  all,
                  function.derivatives(box.center(), d, component),
                  h,
                  std::max(Tolerances::negligible_load * bound,
                           nearly_parabolic * of_whole)))
              {
                piece.rough = d;
                longest     = length;
              }
          }
        return piece;
      }

      std::vector<BoundingBox<dim>>
      smooth()
      {
        std::vector<BoundingBox<dim>>   done;
        std::priority_queue<Piece<dim>> open;
        const auto                      add = [&](const Piece<dim> &piece) {
          if (piece.rough)
            open.push(piece);
          else
            done.push_back(piece.box);
        };
        add(look(whole));
        while (!open.empty() && done.size() + open.size() < max_pieces)
          {
            const Piece<dim> piece = open.top();
            open.pop();
            const unsigned int d      = *piece.rough;
            const double       middle = piece.box.center()[d];
            auto low = piece.box.get_boundary_points(), high = low;
            low.second[d] = middle;
            high.first[d] = middle;
            add(look({low}));
            add(look({high}));
          }
        for (; !open.empty(); open.pop())
          done.push_back(open.top().box);
        return done;
      }

    private:
      const EnclosedFunction<dim> &function;
      const unsigned int           component;
      const BoundingBox<dim>       whole;
      const double                 bound;         ///< in the body
      double                       of_whole = 0.; ///< likewise in the box
    };
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
    , body(body)
  {
    for (unsigned int n = n_points; n >= std::min(n_points, fewest_points); --n)
      rules.emplace_back(n);
    for (unsigned int c = 0; c < function.n_components; ++c)
      for (unsigned int d = 0; d < dim; ++d)
        varies = varies || function.varies_along(d, c);
    update();
  }



  template <int dim>
  void
  PiecewiseRule<dim>::update()
  {
    bounds.clear();
    if (!varies)
      return;
    for (unsigned int c = 0; c < function.n_components; ++c)
      bounds.push_back(function.bound(body, c));
  }



  template <int dim>
  bool
  PiecewiseRule<dim>::is_smooth(const BoundingBox<dim> &box,
                                const unsigned int      component) const
  {
    return !varies || !Pieces<dim>(function, component, box, bounds[component])
                         .look(box)
                         .rough;
  }



  template <int dim>
  Quadrature<dim>
  PiecewiseRule<dim>::operator()(const BoundingBox<dim> &box,
                                 const unsigned int      component) const
  {
    const std::vector<BoundingBox<dim>> pieces =
      Pieces<dim>(function, component, box, varies ? bounds[component] : 0.)
        .smooth();
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
