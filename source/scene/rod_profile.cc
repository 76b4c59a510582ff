// SPDX-License-Identifier: LGPL-2.1-or-later

#include <thermocontact/base/exceptions.h>
#include <thermocontact/base/shares.h>
#include <thermocontact/base/text.h>
#include <thermocontact/base/tolerances.h>
#include <thermocontact/input/load_enclosure.h>
#include <thermocontact/scene/rod_profile.h>

#include <deal.II/base/quadrature_lib.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numeric>
#include <utility>

namespace ThermoContact
{
  namespace
  {
    /** Places at which values are looked at first. */
    constexpr unsigned int n_looks = 64;



    template <std::size_t n>
    using Values = std::array<double, n>;



    /** $\int f\,dx$ by Gauss's rule, and that of the largest $|f|$. */
    template <std::size_t n, typename Function>
    std::pair<Values<n>, Values<n>>
    gauss(const double begin, const double end, const Function &f)
    {
      static const dealii::QGauss<1> rule(8);
      Values<n>                      sums{}, largest{};
      for (unsigned int q = 0; q < rule.size(); ++q)
        {
          const Values<n> values = f(begin + (end - begin) * rule.point(q)[0]);
          for (std::size_t i = 0; i < n; ++i)
            {
              sums[i] += (end - begin) * rule.weight(q) * values[i];
              largest[i] =
                std::max(largest[i], (end - begin) * std::abs(values[i]));
            }
        }
      return {sums, largest};
    }



    /**
     * Calls @p add with the integrals over pieces that Gauss's rule has to
     * rounding, from the left: a piece is halved until its halves say the same.
     */
    template <std::size_t n, typename Function, typename Add>
    void
    integrate(const double       begin,
              const double       end,
              const Function    &f,
              const Add         &add,
              const unsigned int n_halvings = 20)
    {
      const double middle            = 0.5 * (begin + end);
      const auto [whole, largest]    = gauss<n>(begin, end, f);
      const auto [left, left_size]   = gauss<n>(begin, middle, f);
      const auto [right, right_size] = gauss<n>(middle, end, f);
      bool is_resolved               = true;
      for (std::size_t i = 0; i < n; ++i)
        is_resolved = is_resolved &&
                      std::abs(left[i] + right[i] - whole[i]) <=
                        Tolerances::rounding_of_data *
                          std::max({largest[i], left_size[i], right_size[i]});
      if (is_resolved || n_halvings == 0)
        {
          add(middle, left);
          add(end, right);
          return;
        }
      integrate<n>(begin, middle, f, add, n_halvings - 1);
      integrate<n>(middle, end, f, add, n_halvings - 1);
    }
  } // namespace



  RodProfile::RodProfile(const Parameters     &parameters,
                         const BodyParameters &rod)
    : length(rod.length)
    , inertia(parameters.model.inertia)
    , all(parameters, rod, {{"", "", "theta", "x"}})
    , ends({0., rod.length})
  {
    if (varies())
      for (unsigned int i = 0; i <= n_looks; ++i)
        at(length * i / n_looks);
    // linear cells have means, whatever bends within them
    const bool has_means = parameters.mesh.degree == 1;
    for (const Expression *const coefficient : all.expressions())
      find_breaks(*coefficient, !has_means, rod.name);
  }



  void
  RodProfile::find_breaks(const Expression  &coefficient,
                          const bool         takes_kinks,
                          const std::string &body)
  {
    const LoadHistory along = history_along(TimeFunction(coefficient), length);
    if (takes_kinks)
      note_narrowest(coefficient, along, body);
    for (const LoadBreak &one : along.breaks)
      if (const double x = one.time;
          (one.is_jump || takes_kinks) &&
          std::none_of(ends.begin(), ends.end(), [&](const double end) {
            return std::abs(x - end) < Tolerances::rounding_of_data * length;
          }))
        ends.push_back(x);
    std::sort(ends.begin(), ends.end());
  }



  void
  RodProfile::note_narrowest(const Expression  &coefficient,
                             const LoadHistory &along,
                             const std::string &body)
  {
    const TimeFunction value(coefficient);
    const double       part =
      Tolerances::harmless_change * range_of(value, along, length);
    const LoadStretch *shortest = nullptr;
    for (const LoadStretch &stretch : along.stretches)
      if (const double end = std::min(stretch.begin + stretch.width, length);
          std::abs(value.value(end) - value.value(stretch.begin)) > part &&
          (shortest == nullptr || stretch.width < shortest->width))
        shortest = &stretch;
    if (shortest != nullptr)
      narrowest.push_back(
        {coefficient.path(), "Bodies/" + body + "/Cells", *shortest});
  }



  bool
  RodProfile::varies() const
  {
    return all.vary();
  }



  bool
  RodProfile::has_one_speed() const
  {
    return all.is_number(MaterialCoefficients::stiffness) &&
           all.is_number(MaterialCoefficients::density);
  }



  double
  RodProfile::value(const MaterialCoefficients::Name name, const double x) const
  {
    return all.at<double>(name, {{0., 0., 0., x}});
  }



  EquationFactors
  RodProfile::at(const double x, const double theta) const
  {
    return all.in_equations({{0., 0., theta, x}});
  }



  EquationTangents
  RodProfile::tangents(const double x, const double theta) const
  {
    return all.tangents({{0., 0., theta, x}});
  }



  EquationFactors
  RodProfile::of_cell(const double begin, const double end) const
  {
    if (!varies())
      return at(begin);
    Values<7> sums{};
    integrate<7>(
      begin,
      end,
      [this](const double x) -> Values<7> {
        const EquationFactors c = at(x);
        return {{c.section,
                 c.heat_mass,
                 1. / c.conduction,
                 c.coupling / c.stiffness,
                 c.inertia,
                 1. / c.stiffness,
                 value(MaterialCoefficients::viscosity, x)}};
      },
      [&sums](const double, const Values<7> &values) {
        for (std::size_t i = 0; i < values.size(); ++i)
          sums[i] += values[i];
      });
    const double size      = end - begin;
    const double stiffness = size / sums[5];
    return {sums[0] / size,
            sums[1] / size,
            size / sums[2],
            stiffness * sums[3] / size,
            sums[4] / size,
            stiffness,
            stiffness * sums[6] / size};
  }



  EquationFactors
  RodProfile::at_end(const bool is_left) const
  {
    const double inside = Tolerances::rounding_of_data * length;
    return at(is_left ? inside : length - inside);
  }



  double
  RodProfile::slowness(const double x) const
  {
    return std::sqrt(inertia * value(MaterialCoefficients::density, x) /
                     value(MaterialCoefficients::stiffness, x));
  }



  std::vector<RodProfile::Piece>
  RodProfile::pieces(const double begin, const double end) const
  {
    if (has_one_speed())
      return {{end, (end - begin) * slowness(begin)}};
    std::vector<Piece> all;
    double             time = 0.;
    integrate<1>(
      begin,
      end,
      [this](const double x) -> Values<1> { return {{slowness(x)}}; },
      [&](const double x, const Values<1> &of_piece) {
        time += of_piece[0];
        all.push_back({x, time});
      });
    return all;
  }



  std::vector<double>
  RodProfile::passages() const
  {
    std::vector<double> times;
    for (std::size_t part = 0; part + 1 < ends.size(); ++part)
      times.push_back(pieces(ends[part], ends[part + 1]).back().time);
    return times;
  }



  std::vector<unsigned int>
  RodProfile::cells_of_parts(const unsigned int wanted) const
  {
    // without inertia all take no time: by length
    std::vector<double> weights = passages();
    if (!(inertia > 0.))
      for (std::size_t part = 0; part + 1 < ends.size(); ++part)
        weights[part] = ends[part + 1] - ends[part];
    return shares(weights, wanted);
  }



  double
  RodProfile::place_of(const double              time,
                       const double              begin,
                       const std::vector<Piece> &all) const
  {
    const auto   next = std::lower_bound(all.begin(),
                                       all.end(),
                                       time,
                                       [](const Piece &piece, const double t) {
                                         return piece.time < t;
                                       });
    const double from = next == all.begin() ? begin : (next - 1)->end,
                 rest = time - (next == all.begin() ? 0. : (next - 1)->time);
    constexpr unsigned int n_iterations = 60; // bisection alone needs no more
    double                 low = from, high = next->end, x = high;
    for (unsigned int i = 0; i < n_iterations; ++i)
      {
        const double late = gauss<1>(from,
                                     x,
                                     [this](const double y) -> Values<1> {
                                       return {{slowness(y)}};
                                     })
                              .first[0] -
                            rest;
        (late > 0. ? high : low) = x;
        // Newton's method within its bracket
        const double newton = x - late / slowness(x);
        if (std::abs(newton - x) <=
            std::numeric_limits<double>::epsilon() * length)
          break;
        x = newton > low && newton < high ? newton : 0.5 * (low + high);
      }
    return x;
  }



  std::vector<double>
  RodProfile::cell_sizes(const unsigned int n_cells) const
  {
    const std::vector<unsigned int> cells = cells_of_parts(n_cells);
    std::vector<double>             sizes;
    for (std::size_t part = 0; part < cells.size(); ++part)
      {
        const double begin = ends[part], size = ends[part + 1] - begin;
        if (has_one_speed() || !(inertia > 0.))
          {
            sizes.insert(sizes.end(), cells[part], size / cells[part]);
            continue;
          }
        const std::vector<Piece> all  = pieces(begin, ends[part + 1]);
        double                   last = begin;
        for (unsigned int c = 1; c < cells[part]; ++c)
          {
            const double x =
              place_of(all.back().time * c / cells[part], begin, all);
            sizes.push_back(x - last);
            last = x;
          }
        sizes.push_back(ends[part + 1] - last);
      }
    return sizes;
  }



  std::vector<std::string>
  RodProfile::doubts(const std::vector<double> &cells,
                     const unsigned int         degree,
                     const QuantityUnits       &units) const
  {
    std::vector<std::string> all_doubts;
    for (const Narrowest &one : narrowest)
      {
        double x = 0., there = length; // the cell there
        for (unsigned int i = 0; i < cells.size() && x <= one.stretch.begin;
             ++i)
          {
            there = cells[i];
            x += there;
          }
        const double wanted =
          0.5 * degree * one.stretch.width; // as a parabola is of two
        if (wanted < there)
          all_doubts.push_back(text(one.entry,
                                    " varies within ",
                                    units.text("length", one.stretch.width),
                                    " at x = ",
                                    units.text("length", one.stretch.begin),
                                    ", which a cell of ",
                                    units.text("length", there),
                                    " does not resolve; remedy: ",
                                    one.cells,
                                    " = ",
                                    std::ceil(cells.size() * there / wanted),
                                    " or more"));
      }
    for (const Expression *const one : all.expressions())
      {
        for (const std::string &doubt : one->doubts_of_tables())
          all_doubts.push_back(one->path() + ": " + doubt);
        for (const bool is_end : {false, true})
          {
            if (one->depends_on("theta"))
              continue; // its temperatures are those of a scene
            const double variables[4] = {0., 0., 0., is_end ? length : 0.};
            for (const std::string &file : one->tables_left(variables))
              all_doubts.push_back(one->doubt_beyond(
                file,
                text("at the ", is_end ? "right" : "left", " end of the rod")));
          }
      }
    return all_doubts;
  }



  bool
  RodProfile::operator==(const RodProfile &other) const
  {
    return length == other.length && inertia == other.inertia &&
           all == other.all;
  }
} // namespace ThermoContact
