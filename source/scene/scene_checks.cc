// SPDX-License-Identifier: LGPL-2.1-or-later

#include <thermocontact/base/exceptions.h>
#include <thermocontact/base/text.h>
#include <thermocontact/base/tolerances.h>
#include <thermocontact/input/parameter_file.h>
#include <thermocontact/input/parameters.h>
#include <thermocontact/input/quantity_units.h>
#include <thermocontact/scene/box_limits.h>
#include <thermocontact/scene/scene_checks.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace ThermoContact
{
  namespace
  {
    /**
     * Throws for an entry whose value a pattern accepts but the program does
     * not.
     */
    template <typename Value>
    [[noreturn]] void
    refuse(const std::string &path,
           const Value       &value,
           const std::string &allowed,
           const std::string &remedy)
    {
      throw InputError(text(
        path, " = ", value, "\n  allowed: ", allowed, "\n  remedy:  ", remedy));
    }



    /** A value of an entry that many scenes cannot have. */
    struct Refusal
    {
      std::string path, value, allowed;

      void
      since(const bool         is_true,
            const std::string &reason,
            const std::string &remedy) const
      {
        if (is_true)
          refuse(path, value, allowed + ", since " + reason, remedy);
      }
    };



    /**
     * A reason: terms are zero by @p entry; a file in SI units, which cannot
     * have that entry, leaves out inertia by another one.
     */
    std::string
    left_out(const Scene &scene, const std::string &entry = "Model/Inertia = 0")
    {
      const RodParameters &rod = scene.parameters.rod;
      return rod.is_given() ?
               "Rod/Small terms = " + rod.small_terms + " leaves out inertia" :
               entry;
    }



    /** The remedy for that. */
    std::string
    take_in(const Scene       &scene,
            const std::string &entry = "Model/Inertia above 0")
    {
      return scene.parameters.rod.is_given() ? "Rod/Small terms = kept" : entry;
    }



    std::string
    name_of_scheme(const Scene &scene)
    {
      return "Time/Scheme = " + scene.scheme.name;
    }



    /** A remedy: the default scheme, and why. */
    std::string
    take_default_scheme(const std::string &reason)
    {
      return "Time/Scheme = " + default_scheme().name + ": " + reason;
    }



    /** An obstacle whose pressure depends on the velocity. */
    void
    check_damping(const Scene       &scene,
                  const std::string &damping,
                  const std::string &dashpot,
                  const ContactLaw  &law)
    {
      if (!law.is_damped())
        return;
      const double  c = law.damping(), d = law.dashpot();
      const Refusal damped = c > 0. ? Refusal{damping, text(c), "0"} :
                                      Refusal{dashpot, text(d), "0"};
      damped.since(scene.is_fixed_point,
                   "Solver/Step solver = fixed point",
                   "Solver/Step solver = monolithic: the iteration of the "
                   "paper is for an elastic obstacle");
      damped.since(!scene.scheme.needs_linear_contact.empty(),
                   name_of_scheme(scene),
                   take_default_scheme(
                     "an obstacle with damping has no potential, of which "
                     "that scheme needs the gradient"));
      damped.since(scene.contact.has_massless_nodes &&
                     !scene.material.has_viscosity(),
                   scene.parameters.rod.is_given() ?
                     "Contact/Massless nodes = on and Rod/Viscosity = 0" :
                     "Contact/Massless nodes = on and Model/Viscosity = 0",
                   "Contact/Massless nodes = automatic: nodes without mass and "
                   "viscosity are in equilibrium at all times, which a damped "
                   "obstacle does not leave them");
      if (d == 0.)
        return;
      const Refusal stops{dashpot, text(d), "0"};
      stops.since(scene.contact.has_massless_nodes,
                  "Contact/Massless nodes = on",
                  "Contact/Massless nodes = automatic: a dashpot stops a "
                  "node without mass at once");
      stops.since(scene.material.is_static(),
                  left_out(scene, "Model/Inertia = 0 and Model/Viscosity = 0"),
                  take_in(scene, "Model/Viscosity above 0") +
                    ": a dashpot stops a body without inertia and viscosity "
                    "at once");
    }



    /** Section Contact. */
    void
    check_contact(const Scene &scene)
    {
      const Parameters     &parameters = scene.parameters;
      const ContactLawKind &law = contact_law(parameters.contact.condition);
      const auto            refuse_zero = [&](const ContactLawEntry &entry,
                                   const std::string     &path,
                                   const double           value) {
        if (entry.is_positive && !(value > 0.))
          refuse(path,
                 value,
                 "a positive number",
                 "for a rigid obstacle set Contact/Condition = rigid");
      };
      if (parameters.uses_general_law())
        for (const ContactLawEntry &entry : law.entries)
          refuse_zero(entry,
                      "Contact/" + entry.name,
                      parameters.contact.law.at(entry.name));
      for (const auto &[own, kind] : parameters.own_laws())
        for (const ContactLawEntry &entry : kind->entries)
          refuse_zero(entry,
                      own->path(entry.name),
                      own->instead_of(parameters.contact.law).at(entry.name));
      const double gap = scene.contact.gap, rear_gap = scene.contact.rear_gap;
      if (gap + rear_gap <= 0.)
        refuse("Contact/Rear gap",
               rear_gap,
               text("above ", -gap, ", minus Contact/Gap"),
               "a larger one: the stops overlap");
      check_damping(scene,
                    "Contact/Damping",
                    "Contact/Dashpot",
                    *scene.contact.law);
      for (const auto &[own, kind] : parameters.own_laws())
        {
          check_damping(scene,
                        own->path("Damping"),
                        own->path("Dashpot"),
                        *kind->make(own->instead_of(parameters.contact.law)));
          for (const auto &[name, value] : own->numbers)
            {
              const Refusal     number{own->path(name),
                                   text(value.value_or(0.)),
                                   own->word};
              const std::string remedy = number.path + " = " + own->word;
              number.since(value && !scene.scheme.needs_linear_contact.empty(),
                           name_of_scheme(scene),
                           remedy);
              number.since(value && scene.is_fixed_point,
                           "Solver/Step solver = fixed point",
                           remedy);
            }
        }
    }



    void
    check_mass_matrix(const Scene &scene)
    {
      Refusal{"Mesh/Mass matrix", "lumped", "consistent"}.since(
        scene.has_lumped_mass && !scene.geometry->has_uniform_weight(),
        "Mesh/Geometry = " + scene.parameters.mesh.geometry,
        "Mesh/Mass matrix = consistent: lumped nodes on the axis would have no "
        "mass");
    }



    /** The scenes of a scheme without dispersion: Scheme::has_no_dispersion. */
    void
    check_dispersion(const Scene &scene)
    {
      if (!scene.scheme.has_no_dispersion)
        return;
      const Refusal scheme{"Time/Scheme",
                           scene.scheme.name,
                           "a scheme of another name"};
      for (const BoxLimit &limit : limits_of_box(scene.parameters))
        scheme.since(!limit.remedy.empty(), limit.entry, limit.remedy);
    }



    void
    check_step_sizes(const Scene &scene)
    {
      const TimeParameters &time  = scene.parameters.time;
      const auto            first = time.first_step_size;
      if (!time.has_error_control())
        {
          if (!(*time.step_size > 0.))
            refuse("Time/Step size",
                   *time.step_size,
                   "dt > 0, or automatic",
                   "the paper uses 0.001");
          if (time.end_time / *time.step_size > 1e9)
            refuse("Time/Step size",
                   *time.step_size,
                   "at most 1e9 steps up to Time/End time",
                   "enlarge the step or shorten the run");
          return;
        }
      Refusal{"Time/Step size", "automatic", "a number"}.since(
        !scene.scheme.has_error_estimate,
        name_of_scheme(scene) + " has no error estimate",
        "Time/Step size = 0.001, or Time/Scheme = " + default_scheme().name);
      if (first && (!(*first > 0.) || *first < time.minimum_step_size))
        refuse("Time/First step size",
               *first,
               *first > 0. ? "not below Time/Minimum step size" : "dt > 0",
               "Time/First step size = automatic");
      if (!(time.maximum_step_size > 0.) ||
          time.maximum_step_size < time.minimum_step_size)
        refuse("Time/Maximum step size",
               time.maximum_step_size,
               "positive and not below Time/Minimum step size",
               "Time/Maximum step size = infinity");
    }



    void
    check_start(const Scene &scene)
    {
      const Parameters &parameters = scene.parameters;
      if (parameters.time.start != "paper")
        return;
      const Refusal     start{"Time/Start", "paper", "consistent or automatic"};
      const std::string remedy = "Time/Start = automatic: ";
      start.since(!scene.scheme.is_backward_euler,
                  name_of_scheme(scene),
                  "the prescribed first step of the paper is of order 1");
      start.since(!scene.material.has_inertia(),
                  left_out(scene),
                  remedy +
                    "a body without inertia has no velocity to start with");
      start.since(scene.heat.exchange->dependence().any(),
                  "Boundary/right/Heat exchange is an expression",
                  remedy +
                    "the heat equation alone does not know the pressure");
      start.since(parameters.contact.massless_nodes == "on",
                  "Contact/Massless nodes = on",
                  "Contact/Massless nodes = automatic, which leaves the "
                  "paper's start its mass");
    }



    /** An exchange that depends on the contact needs contact; in rows the sides
     * of a contact have two temperatures. */
    void
    check_exchange(const Scene &scene)
    {
      const Parameters &parameters = scene.parameters;
      if (!scene.heat.exchange->dependence().any())
        return;
      const Refusal                   exchange{"Boundary/right/Heat exchange",
                             parameters.boundary.right.exchange_expression,
                             "a number"};
      const HeatExchange::Dependence &by = scene.heat.exchange->dependence();
      exchange.since(by.on_contact && !scene.contact.law->is_active(),
                     scene.fields.has_displacement ?
                       "Contact/Condition = " + parameters.contact.condition :
                       "Model/Fields = " + parameters.model.fields,
                     "there is neither gap nor pressure");
      Refusal{"Boundary/right/Heat exchange",
              parameters.boundary.right.exchange_expression,
              "an expression in gap, pressure, t"}
        .since(by.on_temperature &&
                 (!scene.row.contacts.empty() || scene.obstacle_mass),
               "two bodies meet, and their temperatures are two",
               "an exchange without theta and theta_obs");
      exchange.since(!scene.row.contacts.empty() && !scene.row.meets_obstacle &&
                       !scene.heat.right_temperature,
                     "bodies of a row meet, and its right end meets nothing",
                     "Boundary/right/Temperature, or Boundary/right/Support = "
                     "contact");
      exchange.since(!scene.scheme.needs_constant_exchange.empty(),
                     name_of_scheme(scene),
                     take_default_scheme(scene.scheme.needs_constant_exchange));
    }



    /**
     * Whether somewhere on the end the rate of @p motion has no limit at $t=0$,
     * as that of sqrt(t). It has one where an enclosure of the rate over the
     * start is finite. A rate that this leaves open, as of $t^{3/2}$, grows
     * towards zero or does not, in the middle, or else in quarters of the end:
     * a condition on the place may have both of its branches.
     *
     * @param y, z of the end, or of a part of it
     */
    bool
    has_unbounded_rate(const Expression &motion,
                       const double      end_time,
                       const Interval   &y,
                       const Interval   &z,
                       const unsigned    n_divisions = 4)
    {
      constexpr double  smallest = std::numeric_limits<double>::epsilon();
      const IntervalJet start({0., smallest * end_time}, 1., 0.);
      const IntervalJet everywhere[] = {IntervalJet(1.),
                                        {y, 0., 0.},
                                        {z, 0., 0.},
                                        start};
      if (motion.evaluate(everywhere).first.is_finite())
        return false;
      const TimeFunction middle(motion,
                                dealii::Point<3>(1., y.middle(), z.middle()));
      const auto         rate = [&](const double part) {
        return std::abs(middle.derivatives(part * end_time).first);
      };
      // of a rate with a limit 1; 1.3 of log(t), 90 of that of sqrt(t)
      if (const double near = rate(smallest);
          near > 1.2 * rate(std::pow(smallest, 0.75)))
        return true;
      if (n_divisions > 0 && y.width() > 0.)
        for (const Interval &part_y :
             {Interval(y.low, y.middle()), Interval(y.middle(), y.high)})
          for (const Interval &part_z :
               {Interval(z.low, z.middle()), Interval(z.middle(), z.high)})
            if (has_unbounded_rate(
                  motion, end_time, part_y, part_z, n_divisions - 1))
              return true;
      return false;
    }



    /** Largest absolute value of many on $[0,T]$: a scale, no bound. */
    double
    sampled_magnitude(const TimeFunction &function, const double end_time)
    {
      constexpr unsigned int n_times = 97;
      double                 largest = 0.;
      for (unsigned int i = 0; i <= n_times; ++i)
        largest =
          std::max(largest, std::abs(function.value(end_time * i / n_times)));
      return largest;
    }



    /** Motions of the obstacle, or of the fixed end. */
    void
    check_drives(const Scene &scene)
    {
      const TimeParameters &time = scene.parameters.time;
      // of both
      const auto check_rate = [&](const Refusal    &refusal,
                                  const Expression &motion,
                                  const double      width) {
        if (has_unbounded_rate(motion, time.end_time, {0., width}, {0., width}))
          refuse(refusal.path,
                 refusal.value,
                 "a velocity that stays finite at t = 0",
                 "a motion that begins like t or t^2");
      };
      const auto check_start = [&](const Refusal     &refusal,
                                   const std::string &reason) {
        refusal.since(time.start == "paper",
                      "Time/Start = paper",
                      "Time/Start = automatic: the paper prescribes the first "
                      "step " +
                        reason);
      };
      if (scene.sources.has_moving_obstacle)
        {
          const Refusal gap{"Contact/Gap",
                            quote(scene.gap_expression->text()),
                            "an expression without t"};
          check_rate(gap, *scene.gap_expression, scene.parameters.mesh.width);
          check_start(gap, "before an obstacle that rests");
        }
      if (!scene.sources.has_moving_end)
        return;
      const TimeFunction &motion = *scene.fixed_end_motion;
      const Refusal       end{"Boundary/left/Displacement",
                        quote(motion.expression.text()),
                        "0"};
      const double        start = motion.value(0.);
      if (std::abs(start) > Tolerances::rounding_of_data *
                              sampled_magnitude(motion, time.end_time))
        refuse(end.path,
               end.value,
               text("zero at t = 0, where it is ", start),
               "subtract that: displacements are relative to where the end is "
               "at the start");
      check_rate(end, motion.expression, 0.);
      end.since(!scene.scheme.needs_resting_end.empty(),
                name_of_scheme(scene),
                take_default_scheme(scene.scheme.needs_resting_end));
      check_start(end, "of a body whose end rests");
    }



    void
    check_scheme(const Scene &scene)
    {
      const Parameters &parameters = scene.parameters;
      const Scheme     &scheme     = scene.scheme;
      Refusal{"Time/Scheme", scheme.name, "a scheme of another name"}.since(
        !scheme.needs_inertia.empty() && !scene.material.has_inertia(),
        left_out(scene),
        take_default_scheme(scheme.needs_inertia));
      if (!scene.contact.law->is_active())
        return;
      Refusal{"Contact/Massless nodes", "off", "on or automatic"}.since(
        scheme.needs_massless_contact &&
          parameters.contact.massless_nodes == "off",
        name_of_scheme(scene),
        "Contact/Massless nodes = automatic");
      check_scheme_fits_law(scheme,
                            contact_law(parameters.contact.condition),
                            *scene.contact.law);
      Refusal{"Time/Locate contact events",
              parameters.time.locate_contact_events,
              "false or automatic"}
        .since(!scheme.cannot_hold_contact.empty() &&
                 parameters.time.locates_contact_events(),
               name_of_scheme(scene),
               scheme.cannot_hold_contact + "; " + default_scheme().name +
                 " can end its steps at events");
    }



    void
    check_fixed_point(const Scene &scene)
    {
      if (!scene.is_fixed_point)
        return;
      const Parameters &parameters = scene.parameters;
      const Refusal     solver{"Solver/Step solver",
                           parameters.solver.step_solver,
                           "monolithic"};
      const std::string iteration = "the iteration of the paper ";
      solver.since(!scene.scheme.is_backward_euler,
                   name_of_scheme(scene),
                   iteration + "belongs to Time/Scheme = " +
                     find_scheme([](const Scheme &s) {
                       return s.is_backward_euler;
                     })->name);
      solver.since(scene.contact.law->is_active() &&
                     !scene.contact.law->compliance(),
                   "Contact/Condition = " + parameters.contact.condition,
                   iteration + "needs an elastic obstacle");
      solver.since(!scene.fields.has_temperature ||
                     !scene.material.has_inertia(),
                   !scene.material.has_inertia() ?
                     left_out(scene) :
                     "Model/Fields = " + parameters.model.fields,
                   "Solver/Step solver = monolithic: " + iteration +
                     "belongs to its full model");
      solver.since(scene.heat.exchange->dependence().any(),
                   "Boundary/right/Heat exchange is an expression",
                   iteration + "has a constant one");
      Refusal{"Time/Locate contact events",
              parameters.time.locate_contact_events,
              "false or automatic"}
        .since(parameters.time.locates_contact_events(),
               "Solver/Step solver = fixed point",
               "Solver/Step solver = monolithic, which can hold a contact "
               "state fixed");
    }



    void
    check_mesh(const Scene &scene)
    {
      const Parameters     &parameters = scene.parameters;
      const MeshParameters &mesh       = parameters.mesh;
      const unsigned int    dim        = parameters.dimension;
      if ((1. + dim) * mesh.n_nodes(dim) > 1e9)
        refuse("Mesh/Cells",
               mesh.cells,
               text("at most 1e9 unknowns with Mesh/Degree = ",
                    mesh.degree,
                    ", Mesh/Refinements = ",
                    mesh.refinements,
                    dim > 1 ?
                      text(", Mesh/Cells across = ", mesh.n_cells_across()) :
                      ""),
               "a coarser mesh");
      if (mesh.n_nodes(1) == 2. && scene.contact.law->is_active() &&
          scene.material.has_inertia() &&
          (parameters.contact.massless_nodes == "on" ||
           scene.scheme.needs_massless_contact))
        refuse("Mesh/Cells",
               mesh.cells,
               "at least 2, or Mesh/Degree above 1, for massless contact nodes",
               "a finer mesh: their mass moves to nodes that are not held");
    }



    /** Springs, dashpots and masses of the ends of a rod. */
    void
    check_attached(const Scene &scene)
    {
      const Parameters         &parameters = scene.parameters;
      const BoundaryParameters &boundary   = parameters.boundary;
      for (const auto &[path, is_there] :
           {std::pair("Boundary/right/Support = clamped",
                      boundary.right.is_clamped()),
            std::pair("Boundary/right/Temperature",
                      boundary.right.temperature.has_value())})
        if (is_there && parameters.dimension > 1)
          refuse("Dimension",
                 parameters.dimension,
                 std::string("1, since ") + path,
                 "Boundary/right/Heat exchange of a large value, or a rod");
      const auto check_end = [&](const std::string                  &part,
                                 const BoundaryParameters::Attached &end,
                                 const bool is_contact_end) {
        for (const auto &[name, value, resists_velocity] :
             {std::make_tuple("Spring", end.spring, false),
              std::make_tuple("Dashpot", end.dashpot, true),
              std::make_tuple("Mass", end.mass, true)})
          {
            if (value == 0.)
              continue;
            const std::string path    = part + name;
            const bool        is_mass = path == part + "Mass";
            const Refusal     attached{path, text(value), "0"};
            attached.since(
              parameters.dimension > 1 &&
                (is_mass || !is_contact_end || !scene.obstacle_mass),
              text("Dimension = ", parameters.dimension),
              is_mass || !is_contact_end ?
                path + " = 0: only rods carry something on their ends" :
                path + " = 0, or a second subsection of Bodies, Kind = mass, "
                       "which carries it");
            attached.since(is_mass && !scene.material.has_inertia(),
                           left_out(scene),
                           take_in(scene,
                                   "Model/Inertia above 0, such as 1e-3 of the "
                                   "mass"));
            attached.since(
              resists_velocity && scene.material.is_static(),
              left_out(scene, "Model/Inertia = 0 and Model/Viscosity = 0"),
              take_in(scene, "one of them above 0") +
                ": a body without inertia and viscosity moves at "
                "once where a load jumps, against any dashpot");
            attached.since(scene.is_fixed_point,
                           "Solver/Step solver = fixed point",
                           "Solver/Step solver = monolithic");
            attached.since(scene.scheme.needs_massless_contact &&
                             scene.contact.law->is_active() && is_contact_end &&
                             resists_velocity,
                           name_of_scheme(scene),
                           take_default_scheme(
                             "the contact nodes of that one carry nothing that "
                             "resists velocities"));
          }
      };
      if (scene.has_free_end)
        check_end("Boundary/left/", boundary.left, false);
      check_end("Boundary/right/", boundary.right, true);
      const bool has_mass = boundary.right.mass > 0.;
      Refusal{"Contact/Massless nodes", "on", "automatic or off"}.since(
        parameters.contact.massless_nodes == "on" &&
          (has_mass || boundary.right.dashpot > 0.),
        has_mass ? "Boundary/right/Mass above 0" :
                   "Boundary/right/Dashpot above 0",
        "Contact/Massless nodes = automatic: the contact node carries it");
    }



    /**
     * Of a body that is free at its end something else resists a motion of the
     * whole, of the order of its equation: inertia, or else a dashpot if it is
     * viscous, a spring if it is not.
     */
    void
    check_hold(const Scene &scene)
    {
      if (!scene.has_free_end || !scene.fields.has_displacement ||
          scene.row.is_given())
        return;
      const BoundaryParameters &boundary = scene.parameters.boundary;
      const Refusal support{"Boundary/left/Support", "free", "clamped"};
      const bool    is_viscous = scene.material.order() == NodeOrder::viscous;
      const double  resistance =
        is_viscous ? boundary.left.dashpot + boundary.right.dashpot :
                      boundary.left.spring + boundary.right.spring;
      support.since(!scene.material.has_inertia() && resistance == 0.,
                    left_out(scene),
                    text(take_in(scene),
                         scene.parameters.dimension > 1 ? "" :
                         is_viscous ? ", or Boundary/left/Dashpot" :
                                      ", or Boundary/left/Spring",
                         ": nothing resists a motion of the whole body"));
      support.since(scene.is_fixed_point,
                    "Solver/Step solver = fixed point",
                    "Solver/Step solver = monolithic");
    }



    /**
     * Rigid contacts of a mass with another one or with the obstacle follow
     * Newton's law of impact, (M10.6), one at a time.
     */
    void
    check_contacts_of_masses(const Scene &scene)
    {
      const Parameters                  &parameters = scene.parameters;
      const auto                         e = parameters.contact.restitution;
      const std::vector<BodyParameters> &bodies = parameters.row.bodies;
      if (e && !(*e >= 0. && *e <= 1.))
        refuse("Contact/Restitution",
               *e,
               "none, or from 0 to 1",
               "1 for a contact without loss");
      const std::size_t n        = bodies.size();
      const auto        is_rigid = [&](const std::size_t i) {
        const std::vector<RowContact> &contacts = scene.row.contacts;
        const auto                     number =
          std::find_if(contacts.begin(), contacts.end(), [&](const auto &one) {
            return i + 1 < n &&
                   one.name == bodies[i].name + ' ' + bodies[i + 1].name;
          });
        return scene.contact.has_impacts() &&
               scene.contact.law_at(number - contacts.begin()).is_rigid();
      };
      const auto is_of = [&](const std::size_t i) {
        return bodies[i].is_mass() &&
               (i + 1 < n ? bodies[i + 1].is_mass() :
                            scene.row.meets_obstacle) &&
               is_rigid(i);
      };
      bool has_any = false;
      for (std::size_t i = 0; i < n; ++i)
        {
          has_any = has_any || is_of(i);
          if (i > 0 && is_of(i - 1) && is_of(i))
            refuse("Bodies/" + bodies[i].name + "/Kind",
                   "mass",
                   "a rod, since rigid contacts of masses are on both sides of "
                   "it",
                   "a rod in its place, or an elastic Contact/Condition: who "
                   "hits whom first is not defined");
        }
      const Refusal restitution{"Contact/Restitution",
                                e ? text(*e) : "none",
                                e ? "none" : "a number from 0 to 1"};
      restitution.since(has_any && !e,
                        "rigid masses meet",
                        "Contact/Restitution = 1: without loss; 0 is without "
                        "rebound");
      restitution.since(e && !has_any,
                        "no rigid masses meet at a rigid contact",
                        "Contact/Restitution = none: what rods do follows from "
                        "their waves; Contact/Damping of an elastic obstacle "
                        "takes energy");
      Refusal{"Time/Scheme", scene.scheme.name, "box or automatic"}.since(
        e && !scene.scheme.has_no_dispersion,
        "Contact/Restitution is given",
        "Time/Scheme = automatic");
    }



    /** Without inertia each body of a row is held, by an end or a neighbour. */
    void
    check_hold_of_row(const Scene &scene)
    {
      if (!scene.fields.has_displacement || scene.material.has_inertia())
        return;
      const BoundaryParameters &boundary = scene.parameters.boundary;
      const bool                is_held_left =
        !scene.has_free_end || boundary.left.spring > 0.;
      const bool is_held_right =
        boundary.right.is_clamped() || boundary.right.spring > 0.;
      const std::size_t n_parts  = scene.row.contacts.size() + 1;
      const bool        are_held = n_parts == 1 ?
                                     is_held_left || is_held_right :
                                     n_parts == 2 && is_held_left && is_held_right;
      const bool        is_in_si = scene.parameters.rod.is_given();
      std::string       remedy   = "Contacts/A B/Condition = bonded, or " +
                           take_in(scene) +
                           (is_in_si ? " in a run as short as waves" : "");
      if (n_parts == 1 || (n_parts == 2 && is_held_left))
        remedy =
          "Boundary/right/Support = clamped for the last body, " + remedy;
      if (!are_held)
        refuse(is_in_si ? "Rod/Small terms" : "Model/Inertia",
               is_in_si ? scene.parameters.rod.small_terms : "0",
               std::string(is_in_si ? "kept" : "above 0") +
                 ", since a body of the row is held by nothing",
               remedy);
    }



    void
    check_heat_capacity(const BodyParameters &body)
    {
      const std::string path = "Bodies/" + body.name;
      Refusal{path + "/Heat capacity",
              body.heat_capacity.expression,
              "a number"}
        .since(body.is_mass() && !body.heat_capacity.expression.empty(),
               path + "/Kind = mass, which has one temperature",
               "its heat capacity as a number");
    }



    /** Entries refused to rows, masses that are obstacles, and coefficients of
     * theta. */
    void
    check_entries_beside_bodies(const Scene &scene, const std::string &reason)
    {
      const Parameters &parameters = scene.parameters;
      Refusal{"Solver/Step solver", "fixed point", "monolithic"}.since(
        scene.is_fixed_point, reason, "Solver/Step solver = monolithic");
      Refusal{"Time/Scheme", scene.scheme.name, "a scheme of another name"}
        .since(scene.scheme.integrator == IntegratorKind::energy_conserving,
               reason,
               "Time/Scheme = automatic");
      Refusal{"Time/Start", "paper", "automatic or consistent"}.since(
        parameters.time.start == "paper", reason, "Time/Start = automatic");
      Refusal{"Contact/Massless nodes", "on", "automatic or off"}.since(
        parameters.contact.massless_nodes == "on",
        reason,
        "Contact/Massless nodes = automatic");
    }



    /** Coefficients of the temperature, (M10.8), act in the stages alone. */
    void
    check_coefficients_of_temperature(const Scene &scene)
    {
      std::vector<const Expression *> all;
      for (const RowBody &body : scene.row.bodies)
        if (body.profile)
          for (const Expression *const one : body.profile->of_temperature())
            all.push_back(one);
      if (scene.profile)
        all = scene.profile->coefficients().of_temperature();
      for (const Expression *const one : all)
        {
          const Refusal expression{one->path(),
                                   one->text(),
                                   "a number or an expression of places"};
          expression.since(!scene.fields.has_temperature,
                           "Model/Fields = " + scene.parameters.model.fields,
                           "Model/Fields = temperature and displacement");
          check_entries_beside_bodies(scene, one->path() + " depends on theta");
        }
    }



    /** Entries that an obstacle with a mass cannot have, (M10.10). */
    void
    check_obstacle_mass(const Scene &scene)
    {
      const Parameters           &parameters = scene.parameters;
      const BodyParameters *const mass       = parameters.obstacle_mass();
      if (mass == nullptr)
        return;
      const std::string path = "Bodies/" + mass->name;
      const std::string name = path + " = a mass";
      const auto        no   = [&](const bool         is_there,
                          const std::string &entry,
                          const std::string &value,
                          const std::string &allowed,
                          const std::string &remedy) {
        Refusal{entry, value, allowed}.since(is_there, name, remedy);
      };
      no(!parse_number(mass->velocity),
         path + "/Velocity",
         mass->velocity,
         "a number",
         "a number: all of a mass has one velocity");
      no(!equal_values(mass->displacement, "0"),
         path + "/Displacement",
         mass->displacement,
         "0",
         "Contact/Gap, its distance at the start");
      check_heat_capacity(*mass);
      no(!parse_number(mass->temperature),
         path + "/Temperature",
         mass->temperature,
         "a number",
         "a number: all of a mass has one temperature");
      no(!scene.fields.has_displacement,
         "Model/Fields",
         "temperature",
         "temperature and displacement or displacement",
         "Model/Fields = displacement");
      const bool is_in_si = parameters.rod.is_given();
      no(!scene.material.has_inertia(),
         is_in_si ? "Rod/Small terms" : "Model/Inertia",
         is_in_si ? parameters.rod.small_terms : "0",
         is_in_si ? "kept" : "above 0",
         take_in(scene) + ": a mass is inertia alone");
      const std::string &support = parameters.boundary.right.support;
      no(support != "contact",
         "Boundary/right/Support",
         support,
         "contact",
         "Boundary/right/Support = contact");
      no(!scene.contact.law->is_active() || scene.contact.law->is_rigid(),
         "Contact/Condition",
         parameters.contact.condition,
         "an elastic obstacle",
         "Contact/Condition = normal compliance");
      no(scene.sources.has_moving_obstacle,
         "Contact/Gap",
         parameters.contact.gap_expression,
         "a number or an expression in y and z",
         path + "/Velocity: the mass moves by itself");
      no(scene.contact.is_two_sided(),
         "Contact/Rear gap",
         text(scene.contact.rear_gap),
         "none",
         "Contact/Rear gap = none: the pressure of a node acts on the mass, "
         "which one behind the body would not");
      check_entries_beside_bodies(scene, name);
    }



    /** Entries that the material of a body in several dimensions cannot have,
     * (M10.9). */
    void
    check_material(const Scene &scene)
    {
      const Parameters &parameters = scene.parameters;
      if (!scene.profile)
        return;
      const std::string dimension = text("Dimension = ", parameters.dimension);
      const std::vector<BodyParameters> &bodies = parameters.row.bodies;
      if (bodies.size() > 2 || (bodies.size() == 2 && !bodies[1].is_mass()))
        refuse("Bodies/" + bodies.back().name,
               "one more body",
               "one body, and a mass behind it, since " + dimension,
               "layers as expressions of x, y or z, such as Bodies/" +
                 bodies[0].name + "/Stiffness = if(y<0.05, 2, 1)");
      if (!parameters.row.pairs.empty())
        refuse("Contacts/" + parameters.row.pairs[0].name,
               "a pair of bodies",
               "none, since " + dimension,
               "section Contact: the body meets the obstacle, or the mass");
      const BodyParameters &body = bodies[0];
      const auto            no   = [&](const bool         is_there,
                          const std::string &entry,
                          const std::string &value,
                          const std::string &allowed,
                          const std::string &remedy) {
        Refusal{"Bodies/" + body.name + "/" + entry, value, allowed}.since(
          is_there, dimension, remedy);
      };
      no(body.is_mass(),
         "Kind",
         "mass",
         "rod",
         "Bodies/" + body.name + "/Kind = rod: the body comes first");
      no(body.length != 1.,
         "Length",
         text(body.length),
         "1",
         "Mesh/Width: the length of a strip or block is the unit");
      no(body.cells != 0, "Cells", text(body.cells), "automatic", "Mesh/Cells");
      no(body.section.value != 1. || !body.section.expression.empty(),
         "Section",
         body.section.expression.empty() ? text(body.section.value) :
                                           body.section.expression,
         "1",
         "Mesh/Width");
      for (const auto &[entry, value] :
           {std::pair("Temperature", body.temperature),
            std::pair("Displacement", body.displacement),
            std::pair("Velocity", body.velocity)})
        no(!equal_values(value, "0"),
           entry,
           value,
           "0",
           std::string("Initial values/") + entry);
      check_coefficients_of_temperature(scene);
      check_obstacle_mass(scene);
      const MeshParameters &mesh = parameters.mesh;
      for (const auto &[path, number, grading, planes] :
           {std::tuple("Mesh/Cells", mesh.cells, mesh.grading, mesh.planes[0]),
            std::tuple("Mesh/Cells across",
                       mesh.n_cells_across(),
                       mesh.grading_across,
                       mesh.planes[1])})
        {
          const std::string jumps =
            "cells end where the material jumps or has a kink";
          if (number < planes.size() + 1)
            refuse(path,
                   number,
                   text("from ", planes.size() + 1, " on, since ", jumps),
                   text(path, " = ", planes.size() + 1));
          if (grading != 1. && !planes.empty())
            refuse(std::string("Mesh/Grading") +
                     (path == std::string("Mesh/Cells") ? "" : " across"),
                   grading,
                   "1, since " + jumps,
                   std::string("more ") + path);
        }
    }



    /**
     * Rigid contacts beside others: schemes but for the one without dispersion
     * hold or release all contacts at once. Without inertia a rigid contact
     * has a velocity where an elastic one has a pressure, at an instant; a
     * damped one relates both.
     */
    void
    check_kinds_of_contacts(const Scene &scene)
    {
      const Parameters   &parameters = scene.parameters;
      const SceneContact &contact    = scene.contact;
      for (const PairParameters &pair : parameters.row.pairs)
        {
          const std::string path = "Contacts/" + pair.name + "/Condition";
          const Refusal     own{path, pair.condition, "contact or bonded"};
          if (!pair.has_own_kind())
            continue;
          own.since(parameters.contact.condition == no_obstacle().name,
                    "Contact/Condition = none, of all contacts",
                    "Boundary/right/Support = free instead of it");
          own.since(contact.has_rigid_beside_elastic() && contact.is_damped() &&
                      !scene.material.has_inertia(),
                    left_out(scene) +
                      " and a contact is damped, whose pressure "
                      "follows from the velocity that a rigid one "
                      "beside it takes",
                    "an elastic Condition for all contacts, or no Damping and "
                    "Dashpot");
        }
      const unsigned int n = scene.row.n_contacts();
      Refusal{"Time/Scheme", scene.scheme.name, "box or automatic"}.since(
        contact.has_impacts() && n > 1 && !scene.scheme.has_no_dispersion,
        contact.has_rigid_beside_elastic() ?
          "the row has rigid contacts of bodies with inertia beside others" :
          text("the row has ", n, " rigid contacts of bodies with inertia"),
        "Time/Scheme = automatic, or Contact/Condition = normal compliance");
    }



    /** Entries that a row of bodies cannot have, (M10.1). */
    void
    check_row(const Scene &scene)
    {
      check_contacts_of_masses(scene);
      const Parameters &parameters = scene.parameters;
      if (!scene.row.is_given())
        return;
      const BodyRow &row  = scene.row;
      const auto     name = "section Bodies makes a row";
      Refusal{"Mesh/Grading", text(parameters.mesh.grading), "1"}.since(
        parameters.mesh.grading != 1.,
        name,
        "Bodies/NAME/Cells: each rod has its own");
      check_entries_beside_bodies(scene, name);
      Refusal{"Contact/Gap",
              parameters.contact.gap_expression,
              "a number, since Boundary/right/Support = " +
                parameters.boundary.right.support}
        .since(!parameters.contact.gap_expression.empty() &&
                 !scene.row.meets_obstacle,
               name,
               "Boundary/right/Support = contact");
      const auto no_load = [](const std::string &path,
                              const double       value,
                              const std::string &mass) {
        Refusal{path, text(value), "0"}.since(
          value > 0.,
          "the row ends there with the mass " + mass,
          "Bodies/" + mass + "/Mass: springs and dashpots are of rods");
      };
      const auto no_loads = [&](const std::string                  &part,
                                const BoundaryParameters::Attached &end,
                                const BodyParameters               &body) {
        if (!body.is_mass())
          return;
        no_load(part + "Spring", end.spring, body.name);
        no_load(part + "Dashpot", end.dashpot, body.name);
        no_load(part + "Mass", end.mass, body.name);
      };
      no_loads("Boundary/left/",
               parameters.boundary.left,
               parameters.row.bodies.front());
      no_loads("Boundary/right/",
               parameters.boundary.right,
               parameters.row.bodies.back());
      Refusal{"Boundary/left/Support", parameters.boundary.left.support, "free"}
        .since(row.begins_with_mass() && scene.fields.has_displacement &&
                 !scene.has_free_end,
               "the row begins with a mass",
               "Boundary/left/Support = free, or a rod before it");
      const BoundaryParameters::Left &left = parameters.boundary.left;
      const bool                      is_hot_mass =
        row.begins_with_mass() && scene.fields.has_temperature;
      const std::string before_mass =
        "a rod before the mass: nothing conducts heat into a first mass from "
        "the left";
      Refusal{"Boundary/left/Temperature",
              left.temperature_expression.empty() ? text(left.temperature) :
                                                    left.temperature_expression,
              "none"}
        .since(is_hot_mass && left.has_temperature(),
               "the row begins with a mass",
               "Boundary/left/Temperature = none, or " + before_mass);
      Refusal{"Boundary/left/Heat exchange", text(left.heat_exchange), "0"}
        .since(is_hot_mass && !left.has_temperature() &&
                 left.heat_exchange > 0.,
               "the row begins with a mass",
               before_mass);
      Refusal{"Boundary/left/Heat flux", left.heat_flux, "0"}.since(
        is_hot_mass && scene.sources.has_left_heat_flux,
        "the row begins with a mass",
        before_mass);
      const bool ends_with_mass = parameters.row.bodies.back().is_mass();
      Refusal{"Boundary/right/Support", "clamped", "free or contact"}.since(
        ends_with_mass && parameters.boundary.right.is_clamped(),
        "the row ends with a mass",
        "Boundary/right/Support = free, or a rod behind the mass");
      Refusal{"Boundary/right/Temperature",
              text(parameters.boundary.right.temperature.value_or(0.)),
              "none"}
        .since(ends_with_mass && scene.heat.right_temperature.has_value(),
               "the row ends with a mass",
               "Boundary/right/Temperature = none, or a rod behind the mass");
      Refusal{"Boundary/left/Traction", parameters.boundary.left.traction, "0"}
        .since(row.begins_with_mass() && scene.sources.has_left_traction,
               "the row begins with a mass",
               "Sources/Body force, which acts on masses, too");
      for (const BodyParameters &body : parameters.row.bodies)
        {
          const std::string path = "Bodies/" + body.name;
          check_heat_capacity(body);
          Refusal{path + "/Kind", "mass", "rod"}.since(
            body.is_mass() && scene.fields.has_displacement &&
              !scene.material.has_inertia(),
            left_out(scene),
            take_in(scene) + ": a mass is inertia alone");
        }
      check_kinds_of_contacts(scene);
      for (const RowContact &contact : row.contacts)
        if (contact.exchange && !scene.heat.exchange->is_in_matrices())
          refuse("Contacts/" + contact.name + "/Heat exchange",
                 *contact.exchange,
                 "none, since Boundary/right/Heat exchange is an expression",
                 "one of them: a number for each contact, or the expression "
                 "for all");
      check_hold_of_row(scene);
      check_coefficients_of_temperature(scene);
      for (const auto &position : parameters.probe_positions())
        {
          const double             x = position[0];
          std::vector<std::string> spans;
          bool                     is_in_rod = false;
          for (const RowBody &body : row.bodies)
            if (body.n_cells > 0)
              {
                const double rounding =
                  Tolerances::rounding_of_data * row.length();
                is_in_rod = is_in_rod || (x >= body.begin - rounding &&
                                          x <= body.end + rounding);
                spans.push_back(parameters.text_of_coordinate(body.begin) +
                                " to " +
                                parameters.text_of_coordinate(body.end));
              }
          if (!is_in_rod)
            refuse("Output/Probes",
                   parameters.output.probes,
                   "x in a rod, gaps counted: " + join_words(spans),
                   "a place in one of them");
        }
    }



    /** Nothing may push across its axis a body that nothing holds there. */
    void
    check_support(const Scene &scene)
    {
      const Parameters &parameters = scene.parameters;
      if (scene.has_symmetry && scene.heat.has_lateral_exchange())
        refuse("Boundary/sides/Heat exchange",
               scene.heat.lateral_exchange,
               "0, since Boundary/sides/Support = symmetric",
               "the whole body, whose lateral faces exchange heat alike");
      if (!scene.has_pins() || !scene.sources.has_body_force)
        return;
      const std::string path              = "Sources/Body force";
      ExpressionNames   names             = parameters.names(path);
      names.constants["theta_A"]          = scene.heat.fixed_end_temperature;
      const std::vector<Expression> force = read_components(
        path, parameters.sources.body_force, parameters.dimension, names);
      const double no_variables[4] = {};
      for (unsigned int d = 1; d < parameters.dimension; ++d)
        if (!force[d].is_constant() || force[d].evaluate(no_variables) != 0.)
          refuse(path,
                 parameters.sources.body_force,
                 "a force along the axis, since Boundary/left/Support = "
                 "sliding, Boundary/sides/Support = free and " +
                   left_out(scene),
                 "Boundary/sides/Support = symmetric or rollers, or "
                 "Boundary/left/Support = clamped: nothing holds the body "
                 "across its axis");
    }



    /** Scenes that need factors have to have them; a tolerance has to be
     * reached. */
    void
    check_linear_solver(const Scene &scene)
    {
      const auto tolerance = scene.parameters.solver.linear_tolerance;
      if (tolerance && !(*tolerance >= Tolerances::rounding_of_sum &&
                         *tolerance < Tolerances::loosest_residual))
        refuse("Solver/Linear tolerance",
               *tolerance,
               "at least 1e-14 and below 0.01",
               "Solver/Linear tolerance = automatic");
      Refusal{"Solver/Linear solver", "iterative", "direct or automatic"}.since(
        scene.linear_solver.is_iterative &&
          !scene.linear_solver.needs_factors.empty(),
        scene.linear_solver.needs_factors,
        "Solver/Linear solver = automatic");
    }
  } // namespace



  void
  check_scales(const Parameters &parameters)
  {
    const ScalesParameters &scales = parameters.scales;
    if (!scales.is_given())
      return;
    const bool has_temperature = parameters.model.fields != "displacement" ||
                                 scales.temperature ||
                                 scales.reference_temperature;
    for (const ScalesParameters::Scale &scale : ScalesParameters::all())
      {
        const std::optional<double> value = scales.*scale.value;
        const std::string           entry = std::string("Scales/") + scale.name;
        if (scale.is_needed && (has_temperature || !scale.is_thermal) && !value)
          refuse(entry,
                 "none",
                 "a number, since the scene has other scales",
                 "give all scales, as --units writes them, or remove section "
                 "Scales");
        if (value && !(*value > 0.))
          refuse(entry,
                 0,
                 "a positive number",
                 "the SI value of one unit of the scene");
      }
  }



  namespace
  {
    /** The time in which a wave passes a cell of a rod without a row. */
    double
    passage_without_row(const Scene &scene)
    {
      return scene.parameters.mesh.contact_spacing() *
             std::sqrt(scene.material.inertia);
    }



    /** Part of a cell by which the shortest waves stay behind in a step, if
     * they pass a cell in another time. */
    double
    delay(const double passage, const TimeParameters &time)
    {
      return std::abs(*time.step_size / passage - 1.);
    }



    /** dispersion_warning() of the rods of a row. */
    std::string
    dispersion_warning_of_row(const Scene &scene)
    {
      const Parameters   &parameters = scene.parameters;
      const auto          size       = parameters.time.step_size;
      const QuantityUnits units(parameters);
      if (!scene.has_midpoint_mass || !size)
        return "";
      std::vector<std::string> others;
      for (const BodyParameters &body : parameters.row.bodies)
        if (!body.is_mass())
          for (const double passage : passages_of_cells(parameters, body))
            if (delay(passage, parameters.time) * parameters.time.n_steps() >
                Tolerances::drift_of_waves)
              {
                others.push_back(body.name + " (" +
                                 units.text("time", passage) + ")");
                break;
              }
      return others.empty() ?
               "" :
               text("Time/Step size = ",
                    units.text("time", *size),
                    ": waves travel without dispersion where they pass a cell "
                    "in that time, and not in ",
                    join_words(others),
                    "; remedy: lengths whose passages have a common measure, "
                    "or more Mesh/Cells");
    }
  } // namespace



  double
  delay_by_passages(const Scene &scene)
  {
    const Parameters &parameters = scene.parameters;
    if (!scene.has_midpoint_mass || !parameters.time.step_size)
      return 0.;
    if (!parameters.has_row())
      return delay(passage_without_row(scene), parameters.time);
    double largest = 0.;
    for (const BodyParameters &body : parameters.row.bodies)
      if (!body.is_mass())
        for (const double passage : passages_of_cells(parameters, body))
          largest = std::max(largest, delay(passage, parameters.time));
    return largest;
  }



  bool
  has_dispersion(const Scene &scene)
  {
    return delay_by_passages(scene) > Tolerances::same_step_size;
  }



  double
  stiffness_by_heat(const Scene &scene)
  {
    const double general =
      scene.material.thermal_stress * scene.material.heating;
    if (general == 0. || !scene.parameters.has_row())
      return general;
    double largest = 0.;
    for (const BodyParameters &body : scene.parameters.row.bodies)
      if (!body.is_mass())
        for (const bool is_left : {true, false})
          {
            const EquationFactors end =
              RodProfile(scene.parameters, body).at_end(is_left);
            largest = std::max(largest,
                               general * end.coupling * end.coupling /
                                 (end.stiffness * end.heat_mass));
          }
    return largest;
  }



  std::string
  dispersion_warning(const Scene &scene)
  {
    if (scene.row.is_given())
      return dispersion_warning_of_row(scene);
    const auto             size    = scene.parameters.time.step_size;
    const double           passage = passage_without_row(scene);
    const QuantityUnits    units(scene.parameters);
    constexpr unsigned int digits = 12; // sizes may differ by less than show
    return !(delay_by_passages(scene) > Tolerances::same_step_size) ?
             "" :
             text("Time/Step size = ",
                  units.text("time", *size, digits),
                  ": with ",
                  name_of_scheme(scene),
                  " waves travel without dispersion in steps of h sqrt(b) = ",
                  units.text("time", passage, digits),
                  " alone; others are worse than with other schemes");
  }



  std::string
  oscillation_warning(const Scene &scene)
  {
    if (!scene.contact.bouncing_compliance ||
        !scene.parameters.time.has_error_control())
      return "";
    const double mass =
      scene.material.inertia * scene.parameters.mesh.contact_node_length();
    const double compliance = *scene.contact.bouncing_compliance;
    return text(
      "Contact/Massless nodes = ",
      scene.parameters.contact.massless_nodes,
      ": contact nodes with mass bounce on an obstacle so hard, with "
      "a period of about ",
      QuantityUnits(scene.parameters)
        .text("time", 2. * dealii::numbers::PI * std::sqrt(mass * compliance)),
      ": steps follow them, and can be many more than the forecast; remedy: ",
      scene.contact.is_damped() ?
        "damping of this obstacle, too, as the other one has it" :
        "Contact/Massless nodes = automatic");
  }



  std::string
  resolution_warning(const Scene &scene)
  {
    const Parameters   &parameters = scene.parameters;
    const auto          size       = parameters.time.step_size;
    const QuantityUnits units(parameters);
    if (!scene.has_bodies() || !size)
      return "";
    std::vector<std::string> unresolved;
    for (const MassContact &contact : mass_contacts(parameters))
      if (contact.time < Tolerances::steps_of_contact * *size)
        unresolved.push_back(contact.name + " (" +
                             units.text("time", contact.time) + ")");
    return unresolved.empty() ?
             "" :
             text("Time/Step size = ",
                  units.text("time", *size),
                  ": forces of contacts with a mass take about the time in "
                  "brackets, which steps do not resolve, ",
                  join_words(unresolved),
                  ": peaks, durations, velocities and impulses there are of "
                  "the steps; remedy: more Mesh/Cells, or a smaller Time/Step "
                  "size of masses alone");
  }



  std::string
  impact_warning(const Scene &scene)
  {
    const double mass = scene.parameters.boundary.right.mass;
    return mass == 0. || !scene.contact.stops_nodes() ?
             "" :
             "Boundary/right/Mass = " +
               QuantityUnits(scene.parameters).text_for_entry("mass", mass) +
               ": it stops at the rigid obstacle without rebound, and its "
               "energy is lost; remedy: Contact/Condition = normal compliance, "
               "which gives it back";
  }



  void
  check_scheme_fits_law(const Scheme         &scheme,
                        const ContactLawKind &kind,
                        const ContactLaw     &law)
  {
    Refusal{"Time/Scheme", scheme.name, "a scheme of another name"}.since(
      !scheme.needs_linear_contact.empty() && !law.is_linear(),
      "Contact/Condition = " + kind.name,
      take_default_scheme(scheme.needs_linear_contact));
  }



  void
  check_error_bars(const Parameters &parameters)
  {
    Refusal{"Output/Error bars", "true", "false"}.since(
      parameters.output.has_error_bars && parameters.study.is_active(),
      "Study/Vary makes a study",
      "Study/Reference, to which the errors of all runs are measured");
  }



  void
  check_scene(const Parameters &parameters)
  {
    check_scene(Scene(parameters));
  }



  void
  check_scene(const Scene &scene)
  {
    const Parameters &parameters = scene.parameters;
    const double      nu         = parameters.model.poisson_ratio;
    if (!(nu > -1. && nu < 0.5))
      refuse("Model/Poisson ratio",
             nu,
             "-1 < nu < 0.5",
             "stay below 0.5, the incompressible limit");
    check_scales(parameters);
    check_mass_matrix(scene);
    check_contact(scene);
    check_mesh(scene);
    parameters.probe_positions();
    check_step_sizes(scene);
    check_start(scene);
    check_exchange(scene);
    check_drives(scene);
    check_fixed_point(scene);
    check_scheme(scene);
    check_dispersion(scene);
    check_attached(scene);
    check_hold(scene);
    check_row(scene);
    check_material(scene);
    check_support(scene);
    check_linear_solver(scene);
    check_error_bars(parameters);
  }
} // namespace ThermoContact
