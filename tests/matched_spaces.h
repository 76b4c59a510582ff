// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef thermocontact_matched_spaces_h
#define thermocontact_matched_spaces_h

#include <thermocontact/base/dealii_versions.h>
#include <thermocontact/space/discretization.h>

#include <array>
#include <cmath>
#include <map>
#include <vector>

#include "tests.h"

namespace ThermoContact
{
  /**
   * The degrees of freedom of two discretisations of one body, whose meshes may
   * have been made in different ways, by component and position. One rank.
   */
  template <int dim>
  class MatchedSpaces
  {
  public:
    MatchedSpaces(const Discretization<dim> &first,
                  const Discretization<dim> &second)
    {
      const Places places = find_places(first), others = find_places(second);
      for (const Field::Block field : all_fields)
        {
          for (const auto &[place, dof] : places[field])
            pairs[field].push_back({dof, others[field].at(place)});
          is_complete =
            is_complete && places[field].size() == others[field].size();
        }
    }

    /** False if one of them has a degree of freedom that the other lacks. */
    bool is_complete = true;

    /** Largest difference of two vectors of a field over @p scale. */
    double
    difference(const Field::Block field,
               const Vector      &first,
               const Vector      &second,
               const double       scale) const
    {
      double result = 0.;
      for (const auto &[i, j] : pairs[field])
        raise(result, std::abs(first[i] - second[j]) / scale);
      return result;
    }

    /** Gives two vectors of a field the same values, without any symmetry. */
    void
    fill(const Field::Block field,
         Vector            &first,
         Vector            &second,
         const double       seed) const
    {
      double n = seed;
      for (const auto &[i, j] : pairs[field])
        {
          first[i] = second[j] = std::sin(1. + 1.7 * n * n);
          ++n;
        }
    }

  private:
    /** Component and coordinates in units of 1e-8. */
    using Place  = std::array<long, dim + 1>;
    using Places = std::array<std::map<Place, types::global_dof_index>, 2>;

    std::array<
      std::vector<std::pair<types::global_dof_index, types::global_dof_index>>,
      2>
      pairs;

    static Places
    find_places(const Discretization<dim> &space)
    {
      const DoFHandler<dim> &handler = space.dof_handler();
      const auto             points  = support_points(space.mapping(), handler);
      Places                 places;
      std::vector<types::global_dof_index> dofs(
        handler.get_fe().n_dofs_per_cell());
      for (const auto &cell : handler.active_cell_iterators())
        {
          cell->get_dof_indices(dofs);
          for (unsigned int i = 0; i < dofs.size(); ++i)
            {
              const unsigned int component =
                handler.get_fe().system_to_component_index(i).first;
              const Field::Block field =
                space.has_field(Field::displacement) &&
                    component >= space.first_component(Field::displacement) ?
                  Field::displacement :
                  Field::temperature;
              Place place{{static_cast<long>(component)}};
              for (unsigned int d = 0; d < dim; ++d)
                place[d + 1] = std::lround(points.at(dofs[i])[d] * 1e8);
              places[field][place] = dofs[i] - space.first_dof(field);
            }
        }
      return places;
    }
  };
} // namespace ThermoContact

#endif
