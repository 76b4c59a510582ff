// SPDX-License-Identifier: LGPL-2.1-or-later

#include <thermocontact/base/exceptions.h>
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
#include <tuple>
#include <utility>

namespace ThermoContact
{
  namespace
  {
    auto
    parts_of(const RodCoefficients &coefficients)
    {
      const auto &[a, b, c, d, e, f, g] = coefficients;
      return std::tie(a, b, c, d, e, f, g);
    }



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



  bool
  operator==(const RodCoefficients &one, const RodCoefficients &other)
  {
    return parts_of(one) == parts_of(other);
  }



  namespace
  {
    double
    plain_value(const double number)
    {
      return number;
    }

    double
    plain_value(const NumberJet &jet)
    {
      return jet.value;
    }
  } // namespace



  template <typename Number>
  Number
  RodProfile::Coefficient::at(const double x, const Number &theta) const
  {
    if (!expression)
      return Number(number);
    const Number variables[4] = {theta, Number(0.), Number(0.), Number(x)};
    const Number result       = expression->evaluate(variables);
    const double value        = plain_value(result);
    if (!std::isfinite(value) || (!may_be_negative && value < 0.) ||
        (!may_be_zero && value == 0.))
      throw InputError(text(expression->path(),
                            " = ",
                            expression->text(),
                            ": ",
                            significant(value, 6),
                            " at ",
                            significant(100. * x / length, 6),
                            " % of the rod",
                            expression->depends_on("theta") ?
                              text(" where theta is ",
                                   significant(plain_value(theta), 6),
                                   " (nondimensional)") :
                              "",
                            "\n  allowed: ",
                            may_be_negative ? "finite numbers" :
                            may_be_zero     ? "numbers from 0 on" :
                                              "positive numbers",
                            "\n  remedy:  an expression that has them in the "
                            "whole rod",
                            expression->depends_on("theta") ?
                              ", at all of its temperatures" :
                              ""));
    return result;
  }



  RodProfile::RodProfile(const Parameters     &parameters,
                         const BodyParameters &rod)
    : length(rod.length)
    , inertia(parameters.model.inertia)
    , all(n_coefficients)
    , ends({0., rod.length})
  {
    const auto set =
      [&](const Name name, const char *entry, const RodCoefficient &given) {
        all[name].number = given.value;
        all[name].length = length;
        if (given.expression.empty())
          return;
        const std::string path  = "Bodies/" + rod.name + "/" + entry;
        ExpressionNames   names = parameters.names(path);
        const bool        has_theta =
          entry_of_program(path).variables(1).back() == "theta";
        names.variables     = {has_theta ? "theta" : "", "", "", "x"};
        names.checks_values = false; // on [0, 1], whatever the length
        all[name].expression.emplace(path, given.expression, names);
      };
    set(section, "Section", rod.section);
    set(stiffness, "Stiffness", rod.stiffness);
    set(density, "Density", rod.density);
    set(viscosity, "Viscosity", rod.viscosity);
    set(coupling, "Coupling", rod.coupling);
    set(conductivity, "Conductivity", rod.conductivity);
    set(heat_capacity, "Heat capacity", rod.heat_capacity);
    all[viscosity].may_be_zero = true;
    all[coupling].may_be_zero = all[coupling].may_be_negative = true;
    if (varies())
      for (unsigned int i = 0; i <= n_looks; ++i)
        at(length * i / n_looks);
    // linear cells have means, whatever bends within them
    const bool has_means = parameters.mesh.degree == 1;
    for (const Coefficient &coefficient : all)
      if (coefficient.expression)
        find_breaks(coefficient, !has_means);
  }



  void
  RodProfile::find_breaks(const Coefficient &coefficient,
                          const bool         takes_kinks)
  {
    const EnclosedLoad found =
      enclose_load(TimeFunction(*coefficient.expression), length);
    if (!found.is_resolved)
      throw InputError(
        text(coefficient.expression->path(),
             " = ",
             coefficient.expression->text(),
             found.is_infinite ? ": not finite" : ": changes too fast",
             " near ",
             significant(100. * found.time / length, 6),
             " % of the rod\n  allowed: finite values, and jumps "
             "that can be told apart\n  remedy:  a smoother "
             "expression"));
    for (const LoadBreak &one : found.history.breaks)
      if (const double x = one.time;
          (one.is_jump || takes_kinks) &&
          std::none_of(ends.begin(), ends.end(), [&](const double end) {
            return std::abs(x - end) < Tolerances::rounding_of_data * length;
          }))
        ends.push_back(x);
    std::sort(ends.begin(), ends.end());
  }



  bool
  RodProfile::varies() const
  {
    return std::any_of(all.begin(), all.end(), [](const Coefficient &one) {
      return one.expression.has_value();
    });
  }



  std::vector<const Expression *>
  RodProfile::of_temperature() const
  {
    std::vector<const Expression *> expressions;
    for (const Coefficient &one : all)
      if (one.expression && one.expression->depends_on("theta"))
        expressions.push_back(&*one.expression);
    return expressions;
  }



  bool
  RodProfile::has_one_speed() const
  {
    return !all[stiffness].expression && !all[density].expression;
  }



  template <typename Number>
  std::array<Number, 7>
  RodProfile::terms(const double x, const Number &theta) const
  {
    const auto   of = [&](const Name name) { return all[name].at(x, theta); };
    const Number A = of(section), E = of(stiffness);
    return {{A,
             A * of(heat_capacity),
             A * of(conductivity),
             A * of(coupling),
             A * of(density),
             A * E,
             A * E * of(viscosity)}};
  }



  namespace
  {
    template <typename Number, typename Part>
    RodCoefficients
    coefficients(const std::array<Number, 7> &terms, const Part &part)
    {
      return {part(terms[0]),
              part(terms[1]),
              part(terms[2]),
              part(terms[3]),
              part(terms[4]),
              part(terms[5]),
              part(terms[6])};
    }
  } // namespace



  RodCoefficients
  RodProfile::at(const double x, const double theta) const
  {
    return coefficients(terms(x, theta),
                        [](const double term) { return term; });
  }



  RodTangents
  RodProfile::tangents(const double x, const double theta) const
  {
    const auto jets = terms(x, NumberJet(theta, 1., 0.));
    return {coefficients(jets, [](const NumberJet &jet) { return jet.value; }),
            coefficients(jets, [](const NumberJet &jet) { return jet.first; })};
  }



  RodCoefficients
  RodProfile::of_cell(const double begin, const double end) const
  {
    if (!varies())
      return at(begin);
    Values<7> sums{};
    integrate<7>(
      begin,
      end,
      [this](const double x) -> Values<7> {
        const RodCoefficients c = at(x);
        return {{c.section,
                 c.heat_mass,
                 1. / c.conduction,
                 c.coupling,
                 c.inertia,
                 1. / c.stiffness,
                 all[viscosity].at(x)}};
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
            sums[3] / size,
            sums[4] / size,
            stiffness,
            stiffness * sums[6] / size};
  }



  RodCoefficients
  RodProfile::at_end(const bool is_left) const
  {
    const double inside = Tolerances::rounding_of_data * length;
    return at(is_left ? inside : length - inside);
  }



  double
  RodProfile::slowness(const double x) const
  {
    return std::sqrt(inertia * all[density].at(x) / all[stiffness].at(x));
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
    const unsigned int n_cells = std::max(wanted, n_parts());
    // without inertia all take no time: by length
    std::vector<double> weights = passages();
    if (!(inertia > 0.))
      for (std::size_t part = 0; part + 1 < ends.size(); ++part)
        weights[part] = ends[part + 1] - ends[part];
    const double sum = std::accumulate(weights.begin(), weights.end(), 0.);
    std::vector<unsigned int> cells(weights.size(), 1);
    // each next cell where those that are there are the largest
    for (std::size_t part = 0; part < cells.size(); ++part)
      cells[part] = std::max(1., std::floor(n_cells * weights[part] / sum));
    unsigned int n      = std::accumulate(cells.begin(), cells.end(), 0U);
    const auto   excess = [&](const std::size_t part) {
      return cells[part] - n_cells * weights[part] / sum;
    };
    while (n != n_cells)
      {
        std::size_t best = cells.size();
        for (std::size_t part = 0; part < cells.size(); ++part)
          if ((n < n_cells || cells[part] > 1) &&
              (best == cells.size() ||
               (n < n_cells ? excess(part) < excess(best) :
                              excess(part) > excess(best))))
            best = part;
        cells[best] += n < n_cells ? 1 : -1;
        n += n < n_cells ? 1 : -1;
      }
    return cells;
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
  RodProfile::doubts() const
  {
    std::vector<std::string> all_doubts;
    for (const Coefficient &one : all)
      if (one.expression)
        {
          for (const std::string &doubt : one.expression->doubts_of_tables())
            all_doubts.push_back(one.expression->path() + ": " + doubt);
          for (const bool is_end : {false, true})
            {
              const double variables[4] = {0., 0., 0., is_end ? length : 0.};
              for (const std::string &file :
                   one.expression->tables_left(variables))
                all_doubts.push_back(
                  text(one.expression->path(),
                       ": ",
                       quote(file),
                       " has no row at the ",
                       is_end ? "right" : "left",
                       " end of the rod: the value of its nearest row holds "
                       "there"));
            }
        }
    return all_doubts;
  }



  bool
  RodProfile::operator==(const RodProfile &other) const
  {
    return length == other.length && inertia == other.inertia &&
           std::equal(all.begin(),
                      all.end(),
                      other.all.begin(),
                      [](const Coefficient &a, const Coefficient &b) {
                        return a.number == b.number &&
                               a.expression == b.expression;
                      });
  }
} // namespace ThermoContact
