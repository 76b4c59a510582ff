// SPDX-License-Identifier: LGPL-2.1-or-later

#include <thermocontact/base/exceptions.h>
#include <thermocontact/base/number_text.h>
#include <thermocontact/base/text.h>
#include <thermocontact/input/parameter_text.h>
#include <thermocontact/input/quantity_units.h>
#include <thermocontact/space/load_scan.h>
#include <thermocontact/space/obstacle_motion.h>

#include <algorithm>
#include <array>
#include <iterator>
#include <regex>

namespace ThermoContact
{
  namespace
  {
    /** More numbers of an expression are not looked at one by one. */
    constexpr unsigned int max_named_times = 100;

    /**
     * Length of the stage in which equilibrium is restored, or nodes go to a
     * new value, in parts of the time that heat takes through the body and of
     * $T$: neither heat nor momentum go far in it, and rates are within the
     * range of numbers.
     */
    constexpr double direct_jump_length = 1e-11;

    /**
     * The same without matrices: iterations measure what the heat of the jump
     * leaves unsolved by the heat that flows in the stage.
     */
    constexpr double iterative_jump_length = 1e-7;



    /** The numbers up to @p largest in an expression, without signs. */
    std::vector<double>
    numbers_in(const std::string &expression, const double largest)
    {
      static const std::regex number("(\\d+\\.?\\d*|\\.\\d+)([eE][+-]?\\d+)?");
      std::vector<double>     values;
      for (std::sregex_iterator match(expression.begin(),
                                      expression.end(),
                                      number);
           match != std::sregex_iterator() && values.size() < max_named_times;
           ++match)
        if (const auto value = parse_number(match->str());
            value && *value <= largest)
          values.push_back(*value);
      std::sort(values.begin(), values.end());
      values.erase(std::unique(values.begin(), values.end()), values.end());
      return values;
    }



    /**
     * Times up to the end at which an expression may jump or bend. Numbers in
     * it, and, as times are often scaled - those of files in SI units stand
     * there as (2592120*t) -, zeros of what is linear in t.
     */
    std::vector<double>
    times_in(const std::string &expression, const double end_time)
    {
      std::vector<double>       times = numbers_in(expression, end_time);
      const std::vector<double> zeros =
        zeros_of_linear_parts(expression, 0.6180339887 * end_time);
      // others would take the places of those that count
      std::copy_if(zeros.begin(),
                   zeros.end(),
                   std::back_inserter(times),
                   [end_time](const double zero) {
                     return zero >= 0. && zero <= end_time;
                   });
      std::sort(times.begin(), times.end());
      times.erase(std::unique(times.begin(), times.end()), times.end());
      if (times.size() > 2 * max_named_times)
        times.resize(2 * max_named_times);
      return times;
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



  namespace
  {
    /** A function of time, at one or more places, that steps are to follow. */
    struct Load
    {
      std::string path;
      std::string expression;
      LoadSample  sample;

      /** Nothing can follow a jump of it; said to the user. */
      std::string no_jump = "";

      /** Nodes have it for their value. */
      bool is_of_nodes = false;

      /** Its derivative, if that is known. */
      LoadSample rate = nullptr;
    };



    template <int dim>
    LoadSample
    sample_of(ProblemData<dim>    &data,
              const Function<dim> &function,
              const bool           is_on_end,
              const double         width)
    {
      const auto places = sample_places<dim>(is_on_end, width);
      return [&data, &function, places](const double         t,
                                        std::vector<double> &values) {
        data.set_time(t);
        values.clear();
        for (const Point<dim> &place : places)
          for (unsigned int c = 0; c < function.n_components; ++c)
            values.push_back(function.value(place, c));
      };
    }



    LoadSample
    sample_of(const TimeFunction &function)
    {
      return [&function](const double t, std::vector<double> &values) {
        values.assign(1, function.value(t));
      };
    }



    /** Of the gaps of an obstacle that moves. */
    template <int dim>
    LoadSample
    sample_of_gap(const Scene &scene)
    {
      const std::shared_ptr<Function<dim>> gap = contact_gap<dim>(scene);
      const auto                           places =
        sample_places<dim>(true, dim > 1 ? scene.parameters.mesh.width : 0.);
      return [gap, places](const double t, std::vector<double> &values) {
        gap->set_time(t);
        values.clear();
        for (const Point<dim> &place : places)
          values.push_back(gap->value(place));
      };
    }



    template <int dim>
    LoadSample
    rate_of_gap(const Scene &scene)
    {
      const auto places =
        sample_places<dim>(true, dim > 1 ? scene.parameters.mesh.width : 0.);
      const std::string formula = scene.parameters.contact.gap_expression;
      return [formula, places](const double t, std::vector<double> &rates) {
        rates.clear();
        for (const Point<dim> &place : places)
          rates.push_back(
            differentiate(formula, t, named_coordinates(place)).first);
      };
    }



    /** Those of the sources and of the obstacle. */
    template <int dim>
    void
    add_sources(const Scene       &scene,
                ProblemData<dim>  &data,
                std::vector<Load> &loads)
    {
      const SourceParameters &sources = scene.parameters.sources;
      const auto              add     = [&](const std::string   &path,
                           const std::string   &expression,
                           const Function<dim> *function,
                           const bool           is_on_end) {
        if (function != nullptr && depends_on(expression, "t"))
          loads.push_back({path,
                           expression,
                           sample_of<dim>(data,
                                          *function,
                                          is_on_end,
                                          scene.parameters.mesh.width)});
      };
      add("Sources/Heat source",
          sources.heat_source,
          data.heat_source(),
          false);
      add("Sources/Body force", sources.body_force, data.body_force(), false);
      add("Sources/End traction",
          sources.end_traction,
          data.end_traction(),
          true);
      add("Sources/End heat flux",
          sources.end_heat_flux,
          data.end_heat_flux(),
          true);
      add("Boundary/Obstacle temperature",
          scene.parameters.boundary.obstacle_expression,
          data.obstacle_warming(),
          true);
    }



    template <int dim>
    void
    add_drives(const Scene &scene, std::vector<Load> &loads)
    {
      const auto add = [&](const std::string  &path,
                           const TimeFunction &drive,
                           const std::string  &no_jump) {
        if (depends_on(drive.text(), "t"))
          loads.push_back(
            {path,
             drive.text(),
             sample_of(drive),
             no_jump,
             true,
             [&drive](const double t, std::vector<double> &rates) {
               rates.assign(1, drive.derivatives(t).first);
             }});
      };
      if (scene.sources.has_driven_temperature)
        add("Boundary/Fixed end temperature", *scene.heat.fixed_end_drive, "");
      if (scene.sources.has_moving_end)
        add("Boundary/Fixed end displacement",
            *scene.fixed_end_motion,
            "a ramp of a length that the body can follow: an end that jumps "
            "has no velocity");
      if (scene.sources.has_moving_obstacle)
        loads.push_back({"Contact/Gap",
                         scene.parameters.contact.gap_expression,
                         sample_of_gap<dim>(scene),
                         "a ramp of a length that the body can follow: an "
                         "obstacle that jumps has no velocity",
                         false,
                         rate_of_gap<dim>(scene)});
    }



    /** Adds what a load does in time to the history. */
    void
    scan(const Load               &load,
         const Scene              &scene,
         LoadHistory              &history,
         std::vector<std::string> &warnings)
    {
      const TimeParameters &time = scene.parameters.time;
      const QuantityUnits   units(scene.parameters);
      const auto            words = [&units](const double at) {
        return units.text_for_entry("time", at);
      };
      std::vector<double> named = times_in(load.expression, time.end_time);
      named.insert(named.end(),
                   time.break_points.begin(),
                   time.break_points.end());
      ScannedLoad scanned = scan_load(load.sample, time.end_time, named);
      if (!load.no_jump.empty() && scanned.is_infinite)
        throw InputError(text(load.path,
                              " = ",
                              quote(load.expression),
                              ": is not finite at t = ",
                              words(scanned.time),
                              "\n  allowed: functions that are continuous"
                              "\n  remedy:  a function that is finite up to "
                              "Time/End time"));
      if (!load.no_jump.empty())
        for (const LoadBreak &at : scanned.history.breaks)
          if (at.is_jump)
            throw InputError(text(load.path,
                                  " = ",
                                  quote(load.expression),
                                  ": jumps at t = ",
                                  words(at.time),
                                  "\n  allowed: functions that are continuous"
                                  "\n  remedy:  ",
                                  load.no_jump));
      if (!time.has_error_control())
        {
          // a rigid obstacle that turns within a step would throw its nodes
          if (!load.is_of_nodes && load.rate)
            {
              sharpen_bends(load.rate, time.end_time, scanned.history);
              LoadHistory bends;
              bends.breaks = scanned.history.breaks;
              history.add(bends);
            }
          return;
        }
      if (load.is_of_nodes)
        for (LoadBreak &at : scanned.history.breaks)
          if (at.is_jump)
            at.node_step = jump_length(scene, at.time);
      if (load.rate)
        sharpen_bends(load.rate, time.end_time, scanned.history);
      history.add(scanned.history);
      if (!scanned.is_resolved)
        warnings.push_back(
          text(load.path,
               scanned.is_infinite ? " is not finite at t = " :
                                     " changes too fast near t = ",
               words(scanned.time),
               scanned.is_infinite ? "" : " to be seen before the run",
               ": steps do not look for its jumps and pulses (Time/Break "
               "points and Time/Maximum step size help them)"));
    }
  } // namespace



  double
  jump_length(const Scene &scene, const double time)
  {
    const double end_time = scene.parameters.time.end_time;
    const double scale    = end_time > 0. ? std::min(end_time, 1.) : 1.;
    return (scene.linear_solver.has_matrices() ? direct_jump_length :
                                                 iterative_jump_length) *
           std::max(scale, time);
  }



  template <int dim>
  LoadHistory
  load_history(const Scene              &scene,
               ProblemData<dim>         &data,
               std::vector<std::string> &warnings)
  {
    const TimeParameters &time = scene.parameters.time;
    LoadHistory           history;
    std::vector<Load>     loads;
    add_sources(scene, data, loads);
    add_drives<dim>(scene, loads);
    for (const Load &load : loads)
      if (time.end_time > 0. &&
          (time.has_error_control() || !load.no_jump.empty()))
        scan(load, scene, history, warnings);
    std::vector<double> reached;
    for (const double point : time.break_points)
      if (point <= time.end_time)
        reached.push_back(point);
    if (reached.size() < time.break_points.size())
      warnings.push_back(text("Time/Break points = ",
                              *std::max_element(time.break_points.begin(),
                                                time.break_points.end()),
                              " is beyond Time/End time = ",
                              time.end_time,
                              " and has no effect"));
    history.add_breaks(reached);
    history.end_at(time.end_time);
    return history;
  }



  template LoadHistory
  load_history(const Scene &, ProblemData<1> &, std::vector<std::string> &);
  template LoadHistory
  load_history(const Scene &, ProblemData<2> &, std::vector<std::string> &);
  template LoadHistory
  load_history(const Scene &, ProblemData<3> &, std::vector<std::string> &);
} // namespace ThermoContact
