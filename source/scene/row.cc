// SPDX-License-Identifier: LGPL-2.1-or-later

#include <thermocontact/base/exceptions.h>
#include <thermocontact/base/text.h>
#include <thermocontact/base/tolerances.h>
#include <thermocontact/scene/row.h>

#include <algorithm>
#include <cmath>
#include <tuple>

namespace ThermoContact
{
  const RowBody &
  BodyRow::body_at(const double x) const
  {
    // places of nodes are rounded: the middle of a gap is between two bodies
    for (std::size_t i = 0; i + 1 < bodies.size(); ++i)
      if (x <= 0.5 * (bodies[i].end + bodies[i + 1].begin))
        return bodies[i];
    return bodies.back();
  }



  double
  BodyRow::begin_of_last_part() const
  {
    double x = 0., begin = 0.;
    for (const RowCell &cell : cells)
      {
        if (cell.is_gap)
          begin = x + 0.5 * cell.size;
        x += cell.size;
      }
    return begin;
  }



  std::vector<std::string>
  BodyRow::contact_names() const
  {
    std::vector<std::string> names;
    for (const RowContact &contact : contacts)
      {
        names.push_back(contact.name);
        names.back()[contact.name.find(' ')] = '-';
      }
    if (meets_obstacle || contacts.empty())
      names.push_back(bodies.back().name +
                      (meets_obstacle ? "-obstacle" : "-end"));
    return names;
  }



  std::optional<double>
  BodyRow::middle() const
  {
    const double          wanted = 0.5 * length();
    std::optional<double> nearest;
    for (const RowBody &body : bodies)
      if (body.n_cells > 0)
        {
          const double x = std::clamp(wanted, body.begin, body.end);
          if (!nearest || std::abs(x - wanted) < std::abs(*nearest - wanted))
            nearest = x;
        }
    return nearest;
  }



  namespace
  {
    // All members of each record by letters: a binding that leaves one out does
    // not compile.

    auto
    letters(const RowCell &cell)
    {
      const auto &[a, b, c, d, e, f, g, h, i] = cell;
      return std::tie(a, b, c, d, e, f, g, h, i);
    }

    auto
    letters(const RowMass &mass)
    {
      const auto &[a, b, c] = mass;
      return std::tie(a, b, c);
    }

    auto
    letters(const RowContact &contact)
    {
      const auto &[a, b, c, d] = contact;
      return std::tie(a, b, c, d);
    }

    auto
    letters(const RowBody &body)
    {
      const auto &[a, b, c, d, e, f, g, h] = body;
      return std::tie(a, b, c, d, e, f, g, h);
    }

    template <typename Part>
    bool
    are_same(const std::vector<Part> &one, const std::vector<Part> &other)
    {
      return std::equal(one.begin(),
                        one.end(),
                        other.begin(),
                        other.end(),
                        [](const Part &a, const Part &b) {
                          return letters(a) == letters(b);
                        });
    }



    const PairParameters *
    find_pair(const RowParameters &row, const std::string &name)
    {
      const auto found =
        std::find_if(row.pairs.begin(),
                     row.pairs.end(),
                     [&name](const auto &pair) { return pair.name == name; });
      return found == row.pairs.end() ? nullptr : &*found;
    }



    RowCell
    cell_of_rod(const BodyParameters &rod, const double size)
    {
      const double A = rod.section;
      return {size,
              false,
              A,
              A * rod.heat_capacity,
              A * rod.conductivity,
              A * rod.coupling,
              A * rod.density,
              A * rod.stiffness,
              A * rod.stiffness * rod.viscosity};
    }
  } // namespace



  bool
  operator==(const BodyRow &one, const BodyRow &other)
  {
    return are_same(one.bodies, other.bodies) &&
           are_same(one.cells, other.cells) &&
           are_same(one.masses, other.masses) &&
           are_same(one.contacts, other.contacts) &&
           one.meets_obstacle == other.meets_obstacle &&
           one.gap_of_obstacle == other.gap_of_obstacle;
  }



  double
  passage_of_rod(const Parameters &parameters, const BodyParameters &rod)
  {
    return rod.length *
           std::sqrt(parameters.model.inertia * rod.density / rod.stiffness);
  }



  std::vector<MassContact>
  mass_contacts(const Parameters &parameters)
  {
    const auto law =
      contact_law(parameters.contact.condition).make(parameters.contact.law);
    std::vector<MassContact> contacts;
    if (!law->is_active() || parameters.model.fields == "temperature")
      return contacts;
    const std::vector<BodyParameters> &bodies = parameters.row.bodies;
    double                             fastest = 0.;
    for (const BodyParameters &body : bodies)
      fastest = std::max(fastest, std::abs(parse_number(body.velocity).value_or(0.)));
    const auto add = [&](const std::string &name,
                         const BodyParameters &one,
                         const BodyParameters *const other) {
      const bool has_rod =
        !one.is_mass() || (other != nullptr && !other->is_mass());
      if (!one.is_mass() && (other == nullptr || !other->is_mass()))
        return;
      const double mass =
        has_rod            ? (one.is_mass() ? one.mass : other->mass) :
        other == nullptr   ? one.mass :
                             one.mass * other->mass / (one.mass + other->mass);
      if (!law->is_rigid())
        {
          const double energy = 0.5 * mass * fastest * fastest;
          const double compliance =
            law->tangent(law->is_linear() ?
                           0. :
                           law->pressure(law->penetration_of_energy(energy)));
          contacts.push_back({name, std::sqrt(mass * compliance)});
        }
      else if (has_rod)
        {
          const BodyParameters &rod = one.is_mass() ? *other : one;
          contacts.push_back(
            {name,
             mass / (rod.section * std::sqrt(parameters.model.inertia *
                                             rod.density * rod.stiffness))});
        }
    };
    for (std::size_t i = 0; i + 1 < bodies.size(); ++i)
      add(bodies[i].name + " " + bodies[i + 1].name, bodies[i], &bodies[i + 1]);
    if (parameters.boundary.right.meets_obstacle())
      add(bodies.back().name + " obstacle", bodies.back(), nullptr);
    return contacts;
  }



  double
  passage_of_row_cell(const Parameters &parameters)
  {
    double sum = 0., n_cells = 0.;
    for (const BodyParameters &body : parameters.row.bodies)
      if (!body.is_mass())
        {
          sum += passage_of_rod(parameters, body);
          n_cells += body.cells;
        }
    if (n_cells > 0.)
      return sum / n_cells;
    double size = 1e-3 * parameters.time.end_time;
    for (const MassContact &contact : mass_contacts(parameters))
      size = std::min(size, 0.02 * contact.time);
    return size;
  }



  void
  choose_row_cells(const double n_cells,
                   const bool   by_passage,
                   Parameters  &parameters)
  {
    std::vector<BodyParameters *> rods;
    std::vector<double>           sizes; // to be shared by the cells
    double                        sum = 0.;
    for (BodyParameters &body : parameters.row.bodies)
      if (!body.is_mass() && body.cells == 0)
        {
          rods.push_back(&body);
          sizes.push_back(by_passage ? passage_of_rod(parameters, body) :
                                       body.length);
          sum += sizes.back();
        }
    if (rods.empty())
      return;
    for (const BodyParameters &body : parameters.row.bodies)
      if (by_passage && !body.is_mass() && body.cells > 0)
        {
          // in the time in which a wave passes a cell that is given
          const double passage =
            passage_of_rod(parameters, body) / body.cells;
          for (unsigned int i = 0; i < rods.size(); ++i)
            rods[i]->cells = std::max(1., std::round(sizes[i] / passage));
          return;
        }
    // the first number of cells for which all are as good as whole, if any
    const auto misfit = [&](const double n) {
      double largest = 0.;
      for (const double size : sizes)
        {
          const double cells = n * size / sum;
          largest            = std::max(largest,
                             std::abs(cells - std::max(1., std::round(cells))) /
                               std::max(1., cells));
        }
      return largest;
    };
    const unsigned int first = std::ceil(n_cells);
    unsigned int       best  = first;
    if (by_passage)
      for (unsigned int n = first; n < 2 * first; ++n)
        {
          if (misfit(n) < misfit(best))
            best = n;
          if (misfit(best) < Tolerances::rounding_of_data)
            break;
        }
    for (unsigned int i = 0; i < rods.size(); ++i)
      rods[i]->cells =
        std::max(1., std::round(static_cast<double>(best) * sizes[i] / sum));
  }



  BodyRow
  resolve_row(const Parameters &parameters)
  {
    const RowParameters &given = parameters.row;
    BodyRow                  row;
    if (!given.is_given())
      return row;
    double length = 0.;
    for (const BodyParameters &body : given.bodies)
      length += body.is_mass() ? 0. : body.length;
    // length of a closed gap in the mesh
    const double smallest_gap = 1e-9 * (length > 0. ? length : 1.);
    double       x            = 0.;

    const auto add_gap = [&](const double gap) {
      row.cells.push_back({std::max(gap, smallest_gap), true});
      x += row.cells.back().size;
    };
    std::vector<std::string> known;
    for (unsigned int i = 0; i < given.bodies.size(); ++i)
      {
        const BodyParameters &body = given.bodies[i];
        if (i > 0)
          {
            const BodyParameters &left = given.bodies[i - 1];
            const std::string     name = left.name + " " + body.name;
            known.push_back(name);
            const PairParameters *const pair = find_pair(given, name);
            const bool bonded = pair != nullptr && pair->is_bonded();
            if (bonded && (left.is_mass() || body.is_mass()))
              throw InputError(
                "Contacts/" + name +
                "/Condition = bonded\n  allowed: contact, since one of them is "
                "a mass\n  remedy:  Boundary/right/Mass, or a short rod that is "
                "as heavy");
            if (!bonded)
              {
                const double gap = pair != nullptr && pair->gap ?
                                     *pair->gap :
                                     parameters.contact.gap;
                row.contacts.push_back(
                  {name,
                   static_cast<unsigned int>(row.cells.size()),
                   gap,
                   pair != nullptr ? pair->heat_exchange : std::nullopt});
                add_gap(gap);
              }
          }
        else if (body.is_mass())
          add_gap(0.); // a mesh begins with a cell, whose left end rests
        const double       begin = x;
        const unsigned int first = row.cells.size();
        if (body.is_mass())
          {
            const unsigned int vertex = row.cells.size();
            row.masses.push_back({vertex, body.mass, body.heat_capacity});
          }
        else
          for (unsigned int c = 0; c < body.cells; ++c)
            row.cells.push_back(cell_of_rod(body, body.length / body.cells));
        if (!body.is_mass())
          x += body.length;
        row.bodies.push_back({body.name,
                              begin,
                              body.is_mass() ? begin : x,
                              first,
                              body.is_mass() ? 0 : body.cells,
                              body.temperature,
                              body.displacement,
                              body.velocity});
      }
    for (const PairParameters &pair : given.pairs)
      if (std::find(known.begin(), known.end(), pair.name) == known.end())
        throw InputError("Contacts/" + pair.name +
                         ": no two neighbours of the row\n  allowed: " +
                         (known.empty() ? "none, of one body" :
                                          join_words(known)) +
                         "\n  remedy:  the names of section Bodies, in the "
                         "order of x");
    row.meets_obstacle  = parameters.boundary.right.meets_obstacle();
    row.gap_of_obstacle = parameters.contact.gap;
    return row;
  }
} // namespace ThermoContact
