// SPDX-License-Identifier: LGPL-2.1-or-later

#include <thermocontact/base/text.h>
#include <thermocontact/base/tolerances.h>
#include <thermocontact/scene/body_profile.h>

#include <algorithm>
#include <cmath>

namespace ThermoContact
{
  namespace
  {
    const std::array<std::string, 3> axis_names{{"x", "y", "z"}};

    /** Lines that are looked along, as parts of the extent across them. */
    constexpr std::array<double, 5> lines{{0.03, 0.28, 0.5, 0.77, 0.97}};

    /** Places at which values are looked at, likewise. */
    constexpr std::array<double, 7> looks{
      {0., 0.03, 0.28, 0.5, 0.77, 0.97, 1.}};



    /** The variables of an expression that is followed along a direction; the
     * names of the others come first. */
    std::array<std::string, 4>
    variables_along(const unsigned int direction)
    {
      std::array<std::string, 4> names{
        {"", "", "theta", axis_names[direction]}};
      for (unsigned int d = 0, place = 0; d < 3; ++d)
        if (d != direction)
          names[place++] = axis_names[d];
      return names;
    }



    bool
    is_same(const double one, const double other)
    {
      return std::abs(one - other) < Tolerances::same_coordinate;
    }
  } // namespace



  BodyProfile::BodyProfile(const Parameters &parameters)
    : all(parameters, parameters.row.bodies.front(), variables_along(0))
  {
    const double width = parameters.mesh.width;
    if (varies())
      for (const double x : looks)
        for (const double y : looks)
          for (const double z : looks)
            at({{x, y * width, z * width}});
    for (const Expression *const one : all.expressions())
      {
        for (const std::string &doubt : one->doubts_of_tables())
          doubts_.push_back(one->path() + ": " + doubt);
        if (one->depends_on("theta"))
          continue; // its temperatures are those of a scene
        const double corner[4] = {width, width, 0., 1.};
        for (const std::string &file : one->tables_left(corner))
          doubts_.push_back(
            one->doubt_beyond(file, "at the far end of the body"));
      }
    for (unsigned int d = 0; d < parameters.dimension; ++d)
      {
        const MaterialCoefficients along(parameters,
                                         parameters.row.bodies.front(),
                                         variables_along(d));
        for (const Expression *const one : along.expressions())
          if (one->depends_on(axis_names[d]))
            find_planes(parameters, *one, d);
      }
    for (std::vector<double> &one : planes_)
      {
        std::sort(one.begin(), one.end());
        one.erase(std::unique(one.begin(), one.end(), is_same), one.end());
      }
  }



  void
  BodyProfile::find_planes(const Parameters  &parameters,
                           const Expression  &coefficient,
                           const unsigned int direction)
  {
    const double width     = parameters.mesh.width,
                 length    = direction == 0 ? 1. : width;
    const bool takes_kinks = parameters.mesh.degree != 1;
    const auto names       = variables_along(direction);
    const bool is_layered =
      std::none_of(names.begin(), names.end() - 1, [&](const std::string &one) {
        return coefficient.depends_on(one);
      });

    struct Break
    {
      double       place;
      unsigned int n_lines;
      bool         is_jump;
    };
    std::vector<Break> breaks;
    for (unsigned int i = 0; i < (is_layered ? 1 : lines.size()); ++i)
      {
        dealii::Point<3> line;
        for (unsigned int k = 0; k < 2; ++k)
          line[k] = lines[(1 + k) * i % lines.size()] *
                    (names[k] == axis_names[0] ? 1. : width);
        const TimeFunction along(coefficient, line);
        for (const LoadBreak &one :
             history_along(along, length, axis_names[direction] + " at ")
               .breaks)
          if ((one.is_jump || takes_kinks) &&
              one.time > Tolerances::thinnest_layer * length &&
              one.time < (1. - Tolerances::thinnest_layer) * length)
            {
              const auto known =
                std::find_if(breaks.begin(),
                             breaks.end(),
                             [&](const Break &other) {
                               return is_same(one.time, other.place);
                             });
              if (known == breaks.end())
                breaks.push_back({one.time, 1, one.is_jump});
              else
                ++known->n_lines;
            }
      }
    bool is_oblique = false;
    for (const Break &one : breaks)
      if (is_layered || one.n_lines > 1)
        planes_[direction == 0 ? 0 : 1].push_back(one.place);
      else
        is_oblique = is_oblique || one.is_jump;
    const std::string doubt = coefficient.path() + " = " + coefficient.text() +
                              ": jumps where cells have no face, so that "
                              "errors shrink with their size alone";
    if (is_oblique &&
        std::find(doubts_.begin(), doubts_.end(), doubt) == doubts_.end())
      doubts_.push_back(doubt);
  }
} // namespace ThermoContact
