// SPDX-License-Identifier: LGPL-2.1-or-later

#include <thermocontact/base/number_text.h>
#include <thermocontact/base/text.h>
#include <thermocontact/space/load_scan.h>

#include <algorithm>
#include <array>
#include <regex>

namespace ThermoContact
{
  namespace
  {
    /** More numbers of an expression are not looked at one by one. */
    constexpr unsigned int max_named_times = 100;



    bool
    depends_on_time(const std::string &expression)
    {
      static const std::regex time("\\bt\\b");
      return std::regex_search(expression, time);
    }



    /** The numbers in an expression, without signs. */
    std::vector<double>
    numbers_in(const std::string &expression)
    {
      static const std::regex number("(\\d+\\.?\\d*|\\.\\d+)([eE][+-]?\\d+)?");
      std::vector<double>     values;
      for (std::sregex_iterator match(expression.begin(),
                                      expression.end(),
                                      number);
           match != std::sregex_iterator() && values.size() < max_named_times;
           ++match)
        if (const auto value = parse_number(match->str()))
          values.push_back(*value);
      std::sort(values.begin(), values.end());
      values.erase(std::unique(values.begin(), values.end()), values.end());
      return values;
    }



    /** Points in the body, or on its end, at no places that are special. */
    template <int dim>
    std::vector<Point<dim>>
    sample_places(const bool is_on_end, const double width)
    {
      const std::vector<double> along =
        is_on_end ?
          std::vector<double>{1.} :
          std::vector<double>{0.017, 0.113, 0.293, 0.487, 0.709, 0.887, 0.983};
      const std::array<double, 3> across{{0.483, 0.137, 0.871}};
      std::vector<Point<dim>>     places;
      for (unsigned int i = 0; i < along.size(); ++i)
        for (unsigned int j = 0; j < (dim > 1 && is_on_end ? 3 : 1); ++j)
          {
            Point<dim> place;
            place[0] = along[i];
            for (unsigned int d = 1; d < dim; ++d)
              place[d] = width * across[(i + j + d) % 3];
            places.push_back(place);
          }
      return places;
    }
  } // namespace



  template <int dim>
  LoadHistory
  load_history(const Scene              &scene,
               ProblemData<dim>         &data,
               std::vector<std::string> &warnings)
  {
    const TimeParameters   &time     = scene.parameters.time;
    const double            end_time = time.end_time;
    LoadHistory             history;
    const SourceParameters &sources = scene.parameters.sources;
    struct Load
    {
      std::string          path;
      std::string          expression;
      const Function<dim> *function;
      bool                 is_on_end;
    };
    const std::vector<Load> loads = {
      {"Sources/Heat source", sources.heat_source, data.heat_source(), false},
      {"Sources/Body force", sources.body_force, data.body_force(), false},
      {"Sources/End traction", sources.end_traction, data.end_traction(), true},
      {"Sources/End heat flux",
       sources.end_heat_flux,
       data.end_heat_flux(),
       true},
      {"Boundary/Obstacle temperature",
       scene.parameters.boundary.obstacle_expression,
       data.obstacle_warming(),
       true}};
    for (const Load &load : loads)
      {
        if (load.function == nullptr || !depends_on_time(load.expression) ||
            !time.has_error_control() || end_time == 0.)
          continue;
        const auto places =
          sample_places<dim>(load.is_on_end, scene.parameters.mesh.width);
        const auto sample = [&](const double t, std::vector<double> &values) {
          data.set_time(t);
          values.clear();
          for (const Point<dim> &place : places)
            for (unsigned int c = 0; c < load.function->n_components; ++c)
              values.push_back(load.function->value(place, c));
        };
        std::vector<double> named = numbers_in(load.expression);
        named.insert(named.end(),
                     time.break_points.begin(),
                     time.break_points.end());
        const ScannedLoad scanned = scan_load(sample, end_time, named);
        history.add(scanned.history);
        if (!scanned.is_resolved)
          warnings.push_back(
            text(load.path,
                 scanned.is_infinite ? " is not finite at t = " :
                                       " changes too fast near t = ",
                 scanned.time,
                 scanned.is_infinite ? "" : " to be seen before the run",
                 ": steps do not look for its jumps and pulses (Time/Break "
                 "points and Time/Maximum step size help them)"));
      }
    history.add_breaks(time.break_points);
    history.end_at(end_time);
    return history;
  }



  template LoadHistory
  load_history(const Scene &, ProblemData<1> &, std::vector<std::string> &);
  template LoadHistory
  load_history(const Scene &, ProblemData<2> &, std::vector<std::string> &);
  template LoadHistory
  load_history(const Scene &, ProblemData<3> &, std::vector<std::string> &);
} // namespace ThermoContact
