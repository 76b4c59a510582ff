// SPDX-License-Identifier: LGPL-2.1-or-later

#include <thermocontact/base/exceptions.h>
#include <thermocontact/base/number_text.h>
#include <thermocontact/base/text.h>
#include <thermocontact/base/tolerances.h>
#include <thermocontact/input/load_enclosure.h>
#include <thermocontact/input/parameter_text.h>
#include <thermocontact/input/quantity_units.h>
#include <thermocontact/space/enclosed_function.h>
#include <thermocontact/space/load_scan.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <optional>
#include <vector>

namespace ThermoContact
{
  namespace
  {
    /** Places at which a load that varies in space is looked at, and one more.
     */
    constexpr unsigned int n_places = 61;



    /** A function of time that steps are to follow. */
    struct Load
    {
      std::vector<TimeFunction> at_places; ///< at least one

      /** Nothing can follow a jump of it; said to the user. */
      std::string no_jump = "";

      /** Nodes have it for their value. */
      bool is_dirichlet = false;

      LoadKind kind = other_load;

      const Expression &
      expression() const
      {
        return at_places.front().expression;
      }
    };



    /** The largest absolute value that a load has at any time of a run. */
    class LargestValue : public EnclosedFunction<3>
    {
    public:
      LargestValue(const Expression &load, const double end_time)
        : load(load)
        , times(0., end_time)
      {}

      double
      value(const Point<3> &place, const unsigned int) const override
      {
        const IntervalJet at = enclosure({{place, place}}, 0, 0);
        return at.value.is_finite() ? at.value.magnitude() : 0.;
      }

      bool
      varies_along(const unsigned int direction,
                   const unsigned int) const override
      {
        return load.depends_on({"xyz"[direction]});
      }

      NumberJet
      derivatives(const Point<3> &place,
                  const unsigned int,
                  const unsigned int) const override
      {
        return NumberJet(value(place, 0)); // which spans do not tell
      }

      IntervalJet
      enclosure(const BoundingBox<3> &box,
                const unsigned int    direction,
                const unsigned int) const override
      {
        std::array<IntervalJet, 4> variables;
        for (unsigned int d = 0; d < 3; ++d)
          variables[d] =
            IntervalJet(Interval(box.lower_bound(d), box.upper_bound(d)),
                        d == direction ? 1. : 0.,
                        0.);
        variables.back() = IntervalJet(times, 0., 0.);
        return load.evaluate(variables.data());
      }

    private:
      const Expression &load;
      const Interval    times;
    };



    /** The place in the body where a load has its largest value: it may be
     * nowhere else. */
    Point<3>
    place_of_largest(const Expression &load, const Scene &scene)
    {
      Point<3> corner(scene.row.length(), 0., 0.);
      for (unsigned int d = 1; d < scene.parameters.dimension; ++d)
        corner[d] = scene.parameters.mesh.width;
      const BoundingBox<3>        body({Point<3>(), corner});
      constexpr unsigned int      n_points = 4;
      const LargestValue          largest(load, scene.parameters.time.end_time);
      const std::vector<Point<3>> places =
        PiecewiseRule<3>(largest, body, n_points)(body, 0).get_points();
      return *std::max_element(places.begin(),
                               places.end(),
                               [&](const Point<3> &a, const Point<3> &b) {
                                 return largest.value(a, 0) <
                                        largest.value(b, 0);
                               });
    }



    /**
     * The load at places in the body, or on its @p end at this x, that are
     * spread evenly and lie nowhere special, in the body also where it is
     * largest; at one if it is the same everywhere.
     */
    std::vector<TimeFunction>
    at_places(const Expression           &load,
              const std::optional<double> end,
              const Scene                &scene)
    {
      const bool         is_on_end = end.has_value();
      const unsigned int dim       = scene.parameters.dimension;
      const double       width     = scene.parameters.mesh.width;
      // parts of the powers of the root of r^4 = r + 1 are spread in the cube
      const double root   = 1.2207440846057596;
      const bool   varies = (!is_on_end && load.depends_on("x")) ||
                          load.depends_on("y") || load.depends_on("z");
      std::vector<TimeFunction> functions;
      for (unsigned int i = 1; i <= (varies ? n_places : 1); ++i)
        {
          dealii::Point<3> place(end.value_or(1.), 0., 0.);
          for (unsigned int d = is_on_end ? 1 : 0; d < dim; ++d)
            place[d] = (d == 0 ? 1. : width) *
                       std::fmod(0.5 + i * std::pow(root, -1. - d), 1.);
          functions.emplace_back(load, place);
        }
      if (varies && !is_on_end)
        functions.emplace_back(load, place_of_largest(load, scene));
      return functions;
    }



    /**
     * The heat exchange as a function of time alone: of an end that is as warm
     * as what is around it, open and in contact.
     */
    std::vector<Expression>
    exchange_in_time(const Scene &scene)
    {
      if (!scene.heat.exchange->dependence().on_time)
        return {};
      const std::string     path  = "Boundary/right/Heat exchange";
      const ExpressionNames names = scene.parameters.names(path);
      const Expression      law(path,
                           scene.parameters.boundary.right.exchange_expression,
                           names);
      ExpressionNames       in_time(names);
      in_time.variables     = {"", "", "", "t"};
      in_time.checks_values = false;
      const auto number     = [](const double value) {
        return '(' + significant(value, all_digits) + ')';
      };
      const std::string       theta = number(scene.heat.obstacle_temperature);
      std::vector<Expression> all;
      for (const auto &[gap, pressure] :
           {std::pair(std::max(scene.contact.gap, 0.), 0.), std::pair(0., 1.)})
        all.emplace_back(path,
                         law.with_variables(
                           {number(gap), number(pressure), theta, theta, "t"}),
                         in_time);
      return all;
    }



    template <int dim>
    std::vector<Load>
    loads_in_time(const Scene &scene, const ProblemData<dim> &data)
    {
      const std::string no_velocity =
        "a ramp of a length that the body can follow: an ";
      std::vector<Load> loads;
      const auto        add = [&](const Expression           &expression,
                           const std::optional<double> end,
                           const std::string          &no_jump      = "",
                           const bool                  is_dirichlet = false,
                           const LoadKind              kind = other_load) {
        if (expression.depends_on("t"))
          loads.push_back(
            {at_places(expression, end, scene), no_jump, is_dirichlet, kind});
      };
      const auto add_source = [&](const ExpressionFunction<dim> *const source,
                                  const std::optional<double>          end,
                                  const LoadKind kind = other_load) {
        if (source != nullptr)
          for (const Expression &component : source->components())
            add(component, end, "", false, kind);
      };
      add_source(data.heat_source.get(), std::nullopt);
      add_source(data.body_force.get(), std::nullopt, force);
      add_source(data.end_traction.get(), 1., force);
      add_source(data.end_heat_flux.get(), 1.);
      add_source(data.left_traction.get(), 0., force);
      add_source(data.left_heat_flux.get(), 0.);
      add_source(data.obstacle_warming.get(), 1.);
      if (scene.sources.has_driven_exchange)
        {
          if (scene.heat.obstacle_drive)
            add(*scene.heat.obstacle_drive, 1.);
          for (const Expression &exchange : exchange_in_time(scene))
            add(exchange, 1.);
        }
      if (scene.sources.has_driven_temperature)
        add(scene.heat.fixed_end_drive->expression,
            0.,
            "",
            true,
            fixed_end_temperature);
      if (scene.sources.has_moving_end)
        add(scene.fixed_end_motion->expression,
            0.,
            no_velocity + "end that jumps has no velocity",
            true);
      if (scene.sources.has_moving_obstacle)
        add(*scene.gap_expression,
            1.,
            no_velocity + "obstacle that jumps has no velocity");
      return loads;
    }



    /** Refuses a load that no scheme can follow. */
    void
    check_continuity(const Load         &load,
                     const EnclosedLoad &enclosed,
                     const std::string  &time_of_fault)
    {
      const auto fail = [&](const std::string &fault,
                            const std::string &remedy) {
        throw InputError(text(load.expression().path(),
                              " = ",
                              quote(load.expression().text()),
                              ": ",
                              fault,
                              " at t = ",
                              time_of_fault,
                              "\n  allowed: functions that are continuous"
                              "\n  remedy:  ",
                              remedy));
      };
      if (enclosed.is_infinite)
        fail("is not finite", "a function that is finite up to Time/End time");
      if (!time_of_fault.empty())
        fail("jumps", load.no_jump);
    }



    /**
     * The time in which a wave passes the bodies whose inertia the program has
     * left out by itself, in a file in SI units; else 0.
     */
    double
    left_out_wave(const Scene &scene)
    {
      const RodParameters &rod = scene.parameters.rod;
      if (!rod.is_given() || rod.small_terms != "automatic" ||
          !scene.fields.has_displacement || scene.material.has_inertia())
        return 0.;
      return rod.length * scene.row.length() *
             std::sqrt(rod.density / rod.youngs_modulus) /
             *scene.parameters.scales.time;
    }



    /**
     * Warns of a force that changes so fast that inertia matters which the
     * program has left out by itself: by more than a part of its range.
     *
     * @param load at one place
     */
    void
    warn_of_left_out_inertia(const TimeFunction       &load,
                             const Scene              &scene,
                             const EnclosedLoad       &enclosed,
                             std::vector<std::string> &warnings)
    {
      // A sine is nearly a parabola over 1.4 of its angle, and a held body
      // swings beyond its rest by the square of omega over its own, pi/2 in
      // the time of a wave: 2 %
      constexpr double waves = 6.;
      const double     wave  = left_out_wave(scene);
      if (wave == 0. || enclosed.is_infinite)
        return;
      const QuantityUnits units(scene.parameters);
      const auto          warn = [&](const std::string &change) {
        const std::string warning =
          load.expression.path() + change +
          ", and Rod/Small terms = automatic has left out inertia: the body "
                   "would swing beyond its rest, after a jump by up to as much as it "
                   "moves; remedy: Rod/Small terms = kept, in a run as short as the "
                   "swing";
        if (std::find(warnings.begin(), warnings.end(), warning) ==
            warnings.end())
          warnings.push_back(warning);
      };
      if (!enclosed.is_resolved)
        return warn(" changes too fast to be followed");
      const LoadHistory &history = enclosed.history;
      const double       part =
        Tolerances::harmless_change *
        range_of(load, history, scene.parameters.time.end_time);
      double     shortest = waves * wave, begin = 0.;
      bool       is_fast = false;
      const auto look    = [&](const double from, const double to) {
        if (to - from >= shortest ||
            std::abs(load.value(to) - load.value(from)) <= part)
          return;
        shortest = to - from;
        begin    = from;
        is_fast  = true;
      };
      for (const LoadStretch &stretch : history.stretches)
        look(stretch.begin, stretch.begin + stretch.width);
      const std::vector<LoadBreak> &breaks = history.breaks;
      for (std::size_t i = 0; i < breaks.size(); ++i)
        {
          look(breaks[i].old_time, breaks[i].new_time);
          if (i + 1 < breaks.size())
            look(breaks[i].new_time, breaks[i + 1].old_time);
        }
      if (!is_fast)
        return;
      const bool is_jump =
        shortest <= Tolerances::same_time * scene.parameters.time.end_time;
      warn((is_jump ?
              " jumps" :
              " changes within " + units.text_for_entry("time", shortest)) +
           " at t = " + units.text_for_entry("time", begin));
    }



    /** Adds a load in time to the history. */
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
      LoadHistory together;
      for (const TimeFunction &function : load.at_places)
        {
          EnclosedLoad enclosed = enclose_load(function, time.end_time);
          if (load.kind == force)
            warn_of_left_out_inertia(function, scene, enclosed, warnings);
          const auto jump =
            std::find_if(enclosed.history.breaks.begin(),
                         enclosed.history.breaks.end(),
                         [](const LoadBreak &at) { return at.is_jump; });
          if (!load.no_jump.empty())
            check_continuity(load,
                             enclosed,
                             enclosed.is_infinite ? words(enclosed.time) :
                             jump != enclosed.history.breaks.end() ?
                                                    words(jump->time) :
                                                    "");
          if (!enclosed.is_resolved)
            {
              history.is_complete = false;
              if (time.has_error_control())
                warnings.push_back(text(
                  load.expression().path(),
                  enclosed.is_infinite ? " is not finite at t = " :
                                         " changes too fast near t = ",
                  words(enclosed.time),
                  enclosed.is_infinite ? "" : " to be seen before the run",
                  ": steps do not look for its jumps and pulses (Time/Break "
                  "points and Time/Maximum step size help them)"));
              return;
            }
          together.add(enclosed.history);
        }
      if (!time.has_error_control())
        {
          together.stretches.clear();
          // a rigid obstacle whose slope jumps within a step would throw its
          // nodes; with no dispersion there is no other step than that in which
          // a wave passes a cell
          for (LoadBreak &at : together.breaks)
            at.ends_steps =
              !load.is_dirichlet && !scene.scheme.has_no_dispersion;
        }
      history.add(together);
    }



    /**
     * True if a load jumps: if its change from one side of a break to the other
     * is no part of its change around; not beyond the end time, where the jumps
     * of another run may be.
     */
    bool
    jumps_at(const LoadBreak &at, const Load &load, const double end_time)
    {
      const double width = std::max(Tolerances::same_time * at.new_time,
                                    std::numeric_limits<double>::min());
      const double first = std::max(at.old_time - width, 0.);
      const double last =
        std::min(at.new_time + width, std::max(at.new_time, end_time));
      const auto jumps = [&](const TimeFunction &f) {
        const double before = f.value(at.old_time),
                     behind = f.value(at.new_time);
        const double change = std::abs(behind - before);
        return change > Tolerances::rounding_of_solution *
                          std::max(std::abs(before), std::abs(behind)) &&
               change > 0.5 * std::abs(f.value(last) - f.value(first));
      };
      return std::any_of(load.at_places.begin(), load.at_places.end(), jumps);
    }
  } // namespace



  namespace
  {
    /** How far its values are apart in a span of time. */
    double
    range_of(const Load &load, const double begin, const double end)
    {
      constexpr unsigned int n_times  = 64;
      const TimeFunction    &function = load.at_places.front();
      Interval               values(function.value(begin));
      for (unsigned int i = 1; i <= n_times; ++i)
        values =
          hull(values, function.value(begin + (end - begin) * i / n_times));
      return values.width();
    }
  } // namespace



  template <int dim>
  std::string
  changing_loads(const Scene            &scene,
                 const ProblemData<dim> &data,
                 const double            from,
                 const double            to)
  {
    // a load that jumps at an end of the step does so within some rounding
    const double end_time = scene.parameters.time.end_time;
    const double slack    = Tolerances::same_time * end_time;
    std::string  paths;
    for (const Load &load : loads_in_time<dim>(scene, data))
      {
        const double in_step =
          range_of(load, std::max(from - slack, 0.), to + slack);
        if (in_step > 0.5 * range_of(load, 0., end_time))
          paths += (paths.empty() ? "" : ", ") + load.expression().path();
      }
    return paths;
  }



  namespace
  {
    /** Doubts about tables of coefficients that have no row at a temperature of
     * the start or around the body. */
    template <int dim>
    void
    doubt_temperatures(const Scene                           &scene,
                       const ProblemData<dim>                &data,
                       const std::vector<const Expression *> &coefficients,
                       const double                           begin,
                       const double                           end,
                       std::vector<std::string>              &doubts)
    {
      const SceneHeat                            &heat = scene.heat;
      std::vector<std::pair<std::string, double>> all;
      const double inside = Tolerances::in_cell * (end - begin);
      for (const double x : {begin + inside, end - inside})
        {
          Point<dim> place;
          place[0] = x;
          all.emplace_back("at an initial temperature",
                           data.initial_fields->value(place));
        }
      if (heat.has_given_temperature || heat.left_exchange > 0.)
        all.emplace_back(heat.has_given_temperature ?
                           "at the temperature of the left end" :
                           "at the temperature around the left end",
                         heat.fixed_end_temperature);
      if (heat.right_temperature)
        all.emplace_back("at the temperature of the right end",
                         *heat.right_temperature);
      else if (heat.has_exchange() && !scene.obstacle_mass)
        all.emplace_back("at the temperature of the obstacle",
                         heat.obstacle_temperature);
      if (heat.has_lateral_exchange())
        all.emplace_back("at the temperature around the sides",
                         heat.ambient_temperature);
      for (const Expression *const one : coefficients)
        {
          std::map<std::string, std::string> places; // of each file
          for (const auto &[where, theta] : all)
            {
              const double variables[] = {0., 0., theta, 0.};
              for (const std::string &file : one->tables_left(variables))
                if (std::string &told = places[file]; told.empty())
                  told = where;
                else if (told.find(where) == std::string::npos)
                  told += " or " + where;
            }
          for (const auto &[file, told] : places)
            doubts.push_back(one->doubt_beyond(file, told));
        }
    }
  } // namespace



  template <int dim>
  LoadHistory
  load_history(const Scene              &scene,
               const ProblemData<dim>   &data,
               std::vector<std::string> &warnings)
  {
    const TimeParameters    &time = scene.parameters.time;
    LoadHistory              history;
    std::vector<std::string> doubts;
    if (scene.profile)
      {
        doubts = scene.profile->doubts();
        doubt_temperatures(scene,
                           data,
                           scene.profile->coefficients().of_temperature(),
                           0.,
                           1.,
                           doubts);
      }
    for (const RowBody &body : scene.row.bodies)
      if (body.profile)
        {
          std::vector<double> sizes;
          for (unsigned int i = 0; i < body.n_cells; ++i)
            sizes.push_back(scene.row.cells[body.first_cell + i].size);
          for (const std::string &doubt :
               body.profile->doubts(sizes,
                                    scene.parameters.mesh.degree,
                                    QuantityUnits(scene.parameters)))
            doubts.push_back(doubt);
          doubt_temperatures(scene,
                             data,
                             body.profile->of_temperature(),
                             body.begin,
                             body.end,
                             doubts);
        }
    for (const std::string &doubt : doubts)
      warnings.push_back(doubt);
    const std::vector<Load> loads = loads_in_time<dim>(scene, data);
    for (const Load &load : loads)
      for (const std::string &doubt : load.expression().doubts_of_tables())
        warnings.push_back(text(load.expression().path(), ": ", doubt));
    for (const Load &load : loads)
      for (const double at : {0., time.end_time})
        {
          const double variables[] = {1., 0., 0., at};
          for (const std::string &file :
               load.expression().tables_left(variables))
            warnings.push_back(load.expression().doubt_beyond(
              file,
              "at t = " +
                QuantityUnits(scene.parameters).text_for_entry("time", at)));
        }
    for (const Load &load : loads)
      if (time.end_time > 0. &&
          (time.has_error_control() || scene.scheme.has_no_dispersion ||
           !load.no_jump.empty()))
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
    for (const Load &load : loads)
      if (load.kind != other_load)
        for (LoadBreak &at : history.breaks)
          if (at.is_jump && jumps_at(at, load, time.end_time))
            at.jumping |= load.kind;
    return history;
  }



#define INSTANTIATE(dim)                                         \
  template LoadHistory load_history(const Scene &,               \
                                    const ProblemData<dim> &,    \
                                    std::vector<std::string> &); \
  template std::string changing_loads(const Scene &,             \
                                      const ProblemData<dim> &,  \
                                      const double,              \
                                      const double)

  INSTANTIATE(1);
  INSTANTIATE(2);
  INSTANTIATE(3);

#undef INSTANTIATE
} // namespace ThermoContact
