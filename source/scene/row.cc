// SPDX-License-Identifier: LGPL-2.1-or-later

#include <thermocontact/base/exceptions.h>
#include <thermocontact/base/text.h>
#include <thermocontact/base/tolerances.h>
#include <thermocontact/scene/row.h>

#include <algorithm>
#include <cmath>
#include <numeric>
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



  EquationFactors
  BodyRow::of_rod(const unsigned int number,
                  const double       x,
                  const double       theta) const
  {
    const RowCell &cell = cells[number];
    const RowBody &body = bodies[cell.body];
    if (cell.is_gap || !body.profile)
      return cell.whole;
    // within the cell, so that a jump at its begin is behind
    const double inside = Tolerances::rounding_of_data * cell.size;
    return body.profile->at(std::clamp(x - body.begin,
                                       cell.begin + inside,
                                       cell.begin + cell.size - inside),
                            theta);
  }



  EquationFactors
  BodyRow::in_equations(const unsigned int number,
                        const double       x,
                        const double       theta) const
  {
    if (cells[number].varies || theta == 0.)
      return cells[number].varies ? of_rod(number, x, theta) :
                                    cells[number].whole;
    EquationFactors result = cells[number].whole;
    const auto      beyond =
      beyond_zero(number, {of_rod(number, x, theta), {}}, of_rod(number, x))
        .value;
    // the stress alone
    result.coupling += beyond.coupling;
    result.stiffness += beyond.stiffness;
    result.viscosity += beyond.viscosity;
    return result;
  }



  EquationTangents
  BodyRow::beyond_zero(const unsigned int      cell,
                       const EquationTangents &at_theta,
                       const EquationFactors  &at_zero) const
  {
    EquationTangents       beyond = at_theta;
    const EquationFactors &whole  = cells[cell].whole;
    for (const auto part : {&EquationFactors::heat_mass,
                            &EquationFactors::conduction,
                            &EquationFactors::coupling,
                            &EquationFactors::stiffness,
                            &EquationFactors::viscosity})
      {
        beyond.value.*part -= at_zero.*part;
        if (cells[cell].varies || part == &EquationFactors::heat_mass)
          continue;
        // thermal strains a/E add up along a cell
        const auto in_series = part == &EquationFactors::coupling ?
                                 &EquationFactors::stiffness :
                                 part;
        if (at_zero.*in_series != 0.)
          {
            beyond.value.*part *= whole.*in_series / (at_zero.*in_series);
            beyond.slope.*part *= whole.*in_series / (at_zero.*in_series);
          }
      }
    return beyond;
  }



  bool
  BodyRow::has_varying_rods() const
  {
    return std::any_of(bodies.begin(), bodies.end(), [](const RowBody &body) {
      return body.profile.has_value();
    });
  }



  bool
  BodyRow::depends_on_temperature() const
  {
    return std::any_of(bodies.begin(), bodies.end(), [](const RowBody &body) {
      return body.profile && !body.profile->of_temperature().empty();
    });
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
      const auto &[a, b, c, d, e, f] = cell;
      return std::tie(a, b, c, d, e, f);
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
      const auto &[a, b, c, d, e] = contact;
      return std::tie(a, b, c, d, e);
    }

    auto
    letters(const RowBody &body)
    {
      const auto &[a, b, c, d, e, f, g, h, i] = body;
      return std::tie(a, b, c, d, e, f, g, h, i);
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



  } // namespace



  bool
  operator==(const BodyRow &one, const BodyRow &other)
  {
    return are_same(one.bodies, other.bodies) &&
           are_same(one.cells, other.cells) &&
           are_same(one.masses, other.masses) &&
           are_same(one.contacts, other.contacts) &&
           one.meets_obstacle == other.meets_obstacle;
  }



  std::vector<double>
  passages_of_cells(const Parameters &parameters, const BodyParameters &rod)
  {
    const RodProfile                profile(parameters, rod);
    const std::vector<unsigned int> cells = profile.cells_of_parts(rod.cells);
    std::vector<double>             times = profile.passages();
    for (std::size_t part = 0; part < cells.size(); ++part)
      times[part] /= cells[part];
    return times;
  }



  namespace
  {
    /** Where two bodies of a row may meet, or the last one an obstacle. */
    struct Meeting
    {
      std::string                       name;
      const BodyParameters             &one;
      const BodyParameters             *other; ///< null: an obstacle
      std::unique_ptr<const ContactLaw> law;   ///< active
    };



    std::vector<Meeting>
    meetings_of_row(const Parameters &parameters)
    {
      const ContactParameters &general = parameters.contact;
      const ContactLawKind    &kind    = contact_law(general.condition);
      std::vector<Meeting>     meetings;
      if (!parameters.has_row() || parameters.model.fields == "temperature" ||
          !kind.make(general.law)->is_active())
        return meetings;
      const std::vector<BodyParameters> &bodies = parameters.row.bodies;
      for (std::size_t i = 0; i + 1 < bodies.size(); ++i)
        {
          const BodyParameters       &left = bodies[i], &right = bodies[i + 1];
          const std::string           name = left.name + ' ' + right.name;
          const PairParameters *const pair = parameters.row.find_pair(name);
          if (pair != nullptr && pair->is_bonded())
            continue;
          meetings.push_back({name,
                              left,
                              &right,
                              pair != nullptr ?
                                pair->law_kind(kind).make(
                                  pair->own_law.instead_of(general.law)) :
                                kind.make(general.law)});
        }
      if (!parameters.boundary.right.meets_obstacle())
        return meetings;
      const BodyParameters &last = bodies.back();
      meetings.push_back(
        {last.name + " obstacle", last, nullptr, kind.make(general.law)});
      if (general.has_own_rear_law())
        meetings.push_back(
          {last.name + " rear obstacle",
           last,
           nullptr,
           kind.make(general.own_rear_law.instead_of(general.law))});
      return meetings;
    }
  } // namespace



  bool
  has_waves_or_impacts(const Parameters &parameters)
  {
    const auto meetings = meetings_of_row(parameters);
    const auto touches  = [&](const Meeting &meeting) {
      const PairParameters *const pair = parameters.row.find_pair(meeting.name);
      return meeting.other != nullptr &&
             (pair != nullptr && pair->gap ? *pair->gap :
                                              parameters.contact.gap) == 0.;
    };
    return parameters.model.inertia > 0. &&
           parameters.model.fields != "temperature" &&
           (parameters.row.has_rods() ||
            std::any_of(meetings.begin(),
                        meetings.end(),
                        [&](const Meeting &meeting) {
                          return meeting.law->is_rigid() || touches(meeting);
                        }));
  }



  std::vector<MassContact>
  mass_contacts(const Parameters &parameters)
  {
    std::vector<MassContact> contacts;
    double                   fastest = 0.;
    for (const BodyParameters &body : parameters.row.bodies)
      fastest =
        std::max(fastest, std::abs(parse_number(body.velocity).value_or(0.)));
    for (const Meeting &meeting : meetings_of_row(parameters))
      {
        const BodyParameters       &one   = meeting.one;
        const BodyParameters *const other = meeting.other;
        const ContactLaw           &law   = *meeting.law;
        const bool                  has_rod =
          !one.is_mass() || (other != nullptr && !other->is_mass());
        if (!one.is_mass() && (other == nullptr || !other->is_mass()))
          continue;
        const double mass =
          has_rod          ? (one.is_mass() ? one.mass : other->mass) :
          other == nullptr ? one.mass :
                             one.mass * other->mass / (one.mass + other->mass);
        if (!law.is_rigid())
          {
            const double energy = 0.5 * mass * fastest * fastest;
            const double compliance =
              law.tangent(law.is_linear() ?
                            0. :
                            law.pressure(law.penetration_of_energy(energy)));
            contacts.push_back({meeting.name, std::sqrt(mass * compliance)});
          }
        else if (has_rod)
          {
            const BodyParameters &rod = one.is_mass() ? *other : one;
            const EquationFactors end =
              RodProfile(parameters, rod).at_end(one.is_mass());
            contacts.push_back({meeting.name,
                                mass / std::sqrt(parameters.model.inertia *
                                                 end.inertia * end.stiffness)});
          }
      }
    return contacts;
  }



  double
  passage_of_row_cell(const Parameters &parameters)
  {
    double sum = 0., n_cells = 0.;
    for (const BodyParameters &body : parameters.row.bodies)
      if (!body.is_mass())
        {
          const std::vector<double> times =
            RodProfile(parameters, body).passages();
          sum = std::accumulate(times.begin(), times.end(), sum);
          n_cells += body.cells;
        }
    if (n_cells > 0.)
      return sum / n_cells;
    double size = Tolerances::step_of_masses * parameters.time.end_time;
    for (const MassContact &contact : mass_contacts(parameters))
      size = std::min(size, 0.02 * contact.time);
    return size;
  }



  void
  choose_row_cells(const double n_cells,
                   const bool   by_passage,
                   Parameters  &parameters)
  {
    struct Part
    {
      BodyParameters *rod;
      double          size; // to be shared by the cells
    };
    std::vector<Part> parts;
    double            sum = 0., given_passage = 0.;
    for (BodyParameters &body : parameters.row.bodies)
      if (!body.is_mass() && body.cells == 0)
        {
          std::vector<double> sizes = RodProfile(parameters, body).passages();
          if (!by_passage)
            sizes.assign(sizes.size(), body.length / sizes.size());
          for (const double size : sizes)
            parts.push_back({&body, size});
          sum = std::accumulate(sizes.begin(), sizes.end(), sum);
        }
      else if (!body.is_mass() && given_passage == 0.)
        given_passage = passages_of_cells(parameters, body)[0];
    if (parts.empty())
      return;
    // the first number of cells for which all are as good as whole, if any
    const auto misfit = [&](const double n) {
      double largest = 0.;
      for (const Part &part : parts)
        {
          const double cells = n * part.size / sum;
          largest            = std::max(largest,
                             std::abs(cells - std::max(1., std::round(cells))) /
                               std::max(1., cells));
        }
      return largest;
    };
    const unsigned int first = std::ceil(n_cells);
    unsigned int       best  = first;
    if (by_passage && given_passage == 0.)
      for (unsigned int n = first; n < 2 * first; ++n)
        {
          if (misfit(n) < misfit(best))
            best = n;
          if (misfit(best) < Tolerances::rounding_of_data)
            break;
        }
    for (const Part &part : parts)
      {
        const double cells = by_passage && given_passage > 0. ?
                               part.size / given_passage :
                               best * part.size / sum;
        part.rod->cells += std::max(1., std::round(cells));
      }
  }



  BodyRow
  resolve_row(const Parameters &parameters)
  {
    const RowParameters &given = parameters.row;
    BodyRow              row;
    if (!parameters.has_row())
      return row;
    double length = 0.;
    for (const BodyParameters &body : given.bodies)
      length += body.is_mass() ? 0. : body.length;
    // length of a closed gap in the mesh
    const double smallest_gap =
      Tolerances::closed_gap * (length > 0. ? length : 1.);
    double x = 0.;

    const auto add_gap = [&](const double gap) {
      RowCell cell;
      cell.size   = std::max(gap, smallest_gap);
      cell.is_gap = true;
      row.cells.push_back(cell);
      x += row.cells.back().size;
    };
    const auto add_cells = [&](const RodProfile     &profile,
                               const BodyParameters &rod,
                               const unsigned int    number) {
      const unsigned int n_parts = profile.n_parts();
      if (rod.cells < n_parts)
        throw InputError(
          text("Bodies/",
               rod.name,
               "/Cells = ",
               rod.cells,
               "\n  allowed: automatic, or from ",
               n_parts,
               " on, a cell for each part between jumps "
               "and kinks of its coefficients\n  remedy:  automatic"));
      // a linear cell has means, others follow the coefficients
      const bool varies = profile.varies() && parameters.mesh.degree > 1;
      double     begin  = 0.;
      for (const double size : profile.cell_sizes(rod.cells))
        {
          row.cells.push_back({size,
                               false,
                               number,
                               begin,
                               varies,
                               varies ? EquationFactors() :
                                        profile.of_cell(begin, begin + size)});
          begin += size;
        }
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
            const PairParameters *const pair = given.find_pair(name);
            const bool bonded = pair != nullptr && pair->is_bonded();
            if (bonded && (left.is_mass() || body.is_mass()))
              throw InputError(
                "Contacts/" + name +
                "/Condition = bonded\n  allowed: contact, since one of them is "
                "a mass\n  remedy:  Boundary/right/Mass, or a short rod that is "
                "as heavy");
            if (!bonded)
              {
                if (!parameters.contact.gap_expression.empty() &&
                    (pair == nullptr || !pair->gap))
                  throw InputError(
                    "Contacts/" + name +
                    "/Gap = none\n  allowed: a number, since Contact/Gap = " +
                    parameters.contact.gap_expression +
                    " is of the obstacle\n  remedy:  Contacts/" + name +
                    "/Gap = 0");
                const double gap = pair != nullptr && pair->gap ?
                                     *pair->gap :
                                     parameters.contact.gap;
                row.contacts.push_back(
                  {name,
                   static_cast<unsigned int>(row.cells.size()),
                   gap,
                   pair != nullptr ? pair->heat_exchange : std::nullopt,
                   std::nullopt});
                if (pair != nullptr && pair->has_own_law())
                  row.contacts.back().law = {
                    pair->law_kind(contact_law(parameters.contact.condition))
                      .name,
                    pair->own_law.instead_of(parameters.contact.law)};
                add_gap(gap);
              }
          }
        else if (body.is_mass())
          add_gap(0.); // a mesh begins with a cell, whose left end rests
        const double              begin = x;
        const unsigned int        first = row.cells.size();
        std::optional<RodProfile> profile;
        if (body.is_mass())
          {
            const unsigned int vertex = row.cells.size();
            row.masses.push_back({vertex, body.mass, body.heat_capacity.value});
          }
        else
          {
            const RodProfile of_rod(parameters, body);
            add_cells(of_rod, body, i);
            if (of_rod.varies())
              profile = of_rod;
            x += body.length;
          }
        row.bodies.push_back({body.name,
                              begin,
                              body.is_mass() ? begin : x,
                              first,
                              body.is_mass() ? 0 : body.cells,
                              profile,
                              body.temperature,
                              body.displacement,
                              body.velocity});
      }
    for (const PairParameters &pair : given.pairs)
      if (std::find(known.begin(), known.end(), pair.name) == known.end())
        throw InputError(
          "Contacts/" + pair.name +
          ": no two neighbours of the row\n  allowed: " +
          (known.empty() ? "none, of one body" : join_words(known)) +
          "\n  remedy:  the names of section Bodies, in the "
          "order of x");
    row.meets_obstacle = parameters.boundary.right.meets_obstacle();
    return row;
  }
} // namespace ThermoContact
