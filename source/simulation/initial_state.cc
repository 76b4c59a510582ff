// SPDX-License-Identifier: LGPL-2.1-or-later

#include <thermocontact/base/exceptions.h>
#include <thermocontact/base/special_numbers.h>
#include <thermocontact/base/text.h>
#include <thermocontact/base/tolerances.h>
#include <thermocontact/input/quantity_units.h>
#include <thermocontact/simulation/exchange_of_law.h>
#include <thermocontact/simulation/initial_state.h>
#include <thermocontact/space/cell_shape.h>
#include <thermocontact/space/h1_projection.h>
#include <thermocontact/space/node_laws.h>

#include <deal.II/base/quadrature_lib.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace ThermoContact
{
  namespace
  {
    /** Difference of the initial temperature and the fixed end. */
    template <int dim>
    double
    mismatch_of_fixed_end(const Body<dim> &body, const State &state)
    {
      return body.discretization.largest_constrained(
        Field::temperature,
        state.temperature,
        body.scene.heat.fixed_end_temperature,
        body.scene.heat.right_temperature.value_or(0.));
    }



    /** True if that is no rounding. */
    template <int dim>
    bool
    starts_with_layer(const Body<dim> &body, const State &state)
    {
      return mismatch_of_fixed_end(body, state) >
             Tolerances::rounding_of_data *
               std::max(std::abs(body.scene.heat.fixed_end_temperature),
                        state.temperature.linfty_norm());
    }



    /** The fixed end must be fixed; warns of a corner layer. */
    template <int dim>
    void
    check_values(const Body<dim>          &body,
                 const State              &state,
                 std::vector<std::string> &warnings)
    {
      const Discretization<dim>     &discretization = body.discretization;
      const InitialValuesParameters &initial =
        body.scene.parameters.initial_values;
      // an end that moves gets its velocity from its drive in the first step
      Vector velocity_of_rest(state.velocity);
      for (const unsigned int e : body.driven_end.entries(Field::displacement))
        velocity_of_rest.begin()[e] = 0.;
      for (const auto &[name, expression, field, remedy] :
           {std::make_tuple("Displacement",
                            initial.displacement,
                            &std::as_const(state.displacement),
                            "a body that is nearer to the obstacle has a "
                            "smaller Contact/Gap"),
            std::make_tuple("Velocity",
                            initial.velocity,
                            &std::as_const(velocity_of_rest),
                            "a body that flies at an obstacle has a free end, "
                            "Boundary/left/Support = free")})
        if (discretization.largest_constrained(Field::displacement,
                                               *field,
                                               0.) >
            Tolerances::rounding_of_data * field->linfty_norm())
          throw InputError(
            std::string("Initial values/") + name + " = " + expression +
            ": not zero at the fixed end x = 0 or normal to rollers\n  allowed: "
            "an expression that vanishes there, e.g. 20*x*(x-1)^2\n  "
            "remedy:  " +
            remedy);

      if (!body.scene.fields.has_temperature || !starts_with_layer(body, state))
        return;
      const QuantityUnits units(body.scene.parameters);
      warnings.push_back(text(
        body.scene.row.is_given() ? "Bodies: the initial temperature" :
                                    "Initial values/Temperature",
        " differs by ",
        units.text("temperature difference",
                   mismatch_of_fixed_end(body, state)),
        body.scene.heat.right_temperature ?
          " from the temperature of an end that is held" :
          " from theta_A = " +
            units.text("temperature", body.scene.heat.fixed_end_temperature) +
            " at the fixed end",
        ": a corner layer starts there"));
    }



    /**
     * The cells of a scheme whose velocities are means of cells, (C6.13), have
     * those of the initial velocity, which may jump; the right end of a rod
     * has its value.
     */
    void
    set_means_of_cells(const Body<1> &body, Vector &velocity)
    {
      const Scene           &scene     = body.scene;
      const unsigned int     component = scene.fields.has_temperature ? 1 : 0;
      const PiecewiseRule<1> rule(*body.data.initial_velocity,
                                  {{Point<1>(),
                                    body.discretization.geometry().corner()}},
                                  8);
      std::vector<double>    means;
      for (const auto &cell :
           body.discretization.dof_handler().active_cell_iterators())
        {
          const Quadrature<1> points =
            rule(CellShape<1>(cell).bounding_box(), component);
          const auto velocity_at = [&](const Point<1> &place) {
            return body.data.initial_velocity->value(place, component);
          };
          const double middle = velocity_at(cell->center());
          double       rest   = 0.; // none, to the bit, if it is constant
          for (unsigned int q = 0; q < points.size(); ++q)
            rest += points.weight(q) * (velocity_at(points.point(q)) - middle);
          means.push_back(middle + rest / cell->measure());
        }
      double *const v       = velocity.begin();
      const auto    set_rod = [&](const unsigned int first,
                               const unsigned int last) {
        for (unsigned int i = last; i-- > first;)
          v[i] = 2. * means[i] - v[i + 1];
      };
      if (!scene.row.is_given())
        set_rod(0, means.size());
      // from the right: bonded rods share a node, which the right one sets
      const std::vector<RowBody> &bodies = scene.row.bodies;
      for (auto rod = bodies.rbegin(); rod != bodies.rend(); ++rod)
        if (rod->n_cells > 0)
          set_rod(rod->first_cell, rod->first_cell + rod->n_cells);
    }



    /**
     * Warns of an initial temperature of which the nodes of the mesh miss a
     * part, as of a spot between them. In a cell of a rod the projection has
     * the mean of the expression from degree 2 on.
     */
    template <int dim>
    void
    warn_of_lost_heat(const Body<dim>          &body,
                      const State              &state,
                      std::vector<std::string> &warnings)
    {
      const Discretization<dim>   &discretization = body.discretization;
      const FiniteElement<dim>    &fe    = discretization.finite_element();
      const EnclosedFunction<dim> &given = *body.data.initial_fields;
      if (dim == 1 && fe.degree > 1)
        return;
      const PiecewiseRule<dim> rule(given,
                                    {{Point<dim>(),
                                      discretization.geometry().corner()}},
                                    fe.degree + 4);
      const auto               for_each_cell = [&](const auto &visit) {
        for (const auto &cell :
             discretization.dof_handler().active_cell_iterators())
          if (cell->is_locally_owned() && !discretization.is_gap(cell))
            visit(cell, CellShape<dim>(cell));
      };
      bool is_rough = false;
      for_each_cell([&](const auto &, const CellShape<dim> &shape) {
        is_rough = is_rough || !rule.is_smooth(shape.bounding_box(), 0);
      });
      if (Utilities::MPI::max(is_rough ? 1 : 0,
                              discretization.communicator()) == 0)
        return;

      // integrals of the basis functions
      Vector weights(discretization.owned_by_block()[Field::temperature],
                     discretization.relevant_by_block()[Field::temperature],
                     discretization.communicator());
      std::vector<types::global_dof_index> dofs(fe.dofs_per_cell);
      double                               mean = 0., spread = 0.;
      const auto                           sum = [&](const double part) {
        return Utilities::MPI::sum(part, discretization.communicator());
      };
      for_each_cell([&](const auto &cell, const CellShape<dim> &shape) {
        cell->get_dof_indices(dofs);
        const Quadrature<dim> points = rule(shape.bounding_box(), 0);
        for (unsigned int q = 0; q < points.size(); ++q)
          {
            const Point<dim> place = points.point(q);
            const double     weight =
              points.weight(q) * discretization.geometry().weight_at(place);
            mean += weight * given.value(place, 0);
            for (unsigned int i = 0; i < fe.base_element(0).dofs_per_cell; ++i)
              weights(dofs[fe.component_to_system_index(0, i)]) +=
                weight *
                fe.base_element(0).shape_value(i, shape.unit_point(place));
          }
      });
      weights.compress(VectorOperation::add);
      const double volume = weights.l1_norm();
      mean                = sum(mean) / volume;
      for_each_cell([&](const auto &, const CellShape<dim> &shape) {
        const Quadrature<dim> points = rule(shape.bounding_box(), 0);
        for (unsigned int q = 0; q < points.size(); ++q)
          spread += points.weight(q) *
                    discretization.geometry().weight_at(points.point(q)) *
                    std::abs(given.value(points.point(q), 0) - mean);
      });
      spread               = sum(spread) / volume;
      const double of_mesh = weights * state.temperature / volume;
      if (std::abs(of_mesh - mean) <= Tolerances::lost_heat * spread)
        return;
      const QuantityUnits units(body.scene.parameters);
      warnings.push_back(
        text(body.scene.row.is_given() ? "Bodies: the initial temperature" :
                                         "Initial values/Temperature",
             " has the mean ",
             units.text("temperature", mean),
             ", on the nodes of the mesh ",
             units.text("temperature", of_mesh),
             ": it varies between them; remedy: more ",
             body.scene.row.is_given() ? "Cells of bodies" : "Mesh/Cells",
             dim == 1 ? ", or Mesh/Degree = 2 or more" : ""));
    }



    std::string
    length_text(const Scene &scene, const double length)
    {
      return QuantityUnits(scene.parameters).text_for_entry("length", length);
    }



    /** The entry of the gap before an obstacle, with what it says. */
    std::string
    entry_of_gap(const Scene &scene, const bool is_behind)
    {
      if (is_behind)
        return "Contact/Rear gap = " +
               length_text(scene, scene.contact.rear_gap);
      return "Contact/Gap" +
             (scene.contact.has_uniform_gap() ?
                " = " + length_text(scene, scene.contact.gap) :
              QuantityUnits(scene.parameters).is_si() ?
                "" :
                " = " + scene.parameters.contact.gap_expression);
    }



    /** True if @p displacement and @p gap are one but for rounding. */
    bool
    are_one(const double displacement, const double gap)
    {
      return displacement == gap ||
             std::abs(displacement - gap) <
               Tolerances::rounding_of_data *
                 std::max(std::abs(displacement), std::abs(gap));
    }



    /**
     * The initial displacement decides on contact with a rigid obstacle for its
     * projection: a node on it, but for rounding, is there, and one before it
     * not behind it.
     */
    template <int dim>
    void
    stay_before_obstacle(const Body<dim> &body, State &state)
    {
      if (!body.scene.contact.law->is_rigid() ||
          body.scene.material.is_static() || body.scene.row.is_given())
        return; // the bodies of a row are told where they are
      const unsigned int component =
        body.discretization.first_component(Field::displacement);
      for (const auto &[i, entry] :
           body.contact_end().entries(Field::displacement))
        {
          const ContactNode<dim> &node = body.contact_end().nodes()[i];
          const double            given =
            body.data.initial_fields->value(node.position, component);
          double       &projected = state.displacement.begin()[entry];
          double        position  = given;
          const NodeLaw law =
            make_node_law(body.scene.contact, i, state.gap[i], position);
          const double place =
            body.scene.contact.place(law.side, i, state.gap[i]);
          if (are_one(given, place) ||
              (law.penetration(position) < 0. &&
               law.penetration(projected - place) > 0.))
            projected = place;
        }
    }



    /** The gap of a shaped obstacle is known at its nodes. */
    template <int dim>
    void
    check_overlap(const Body<dim> &body, const State &state)
    {
      double smallest = infinity;
      for (unsigned int i = 0; i < state.gap.size(); ++i)
        if (body.scene.contact.stops_overlap(i, state.gap[i]))
          smallest = std::min(smallest, state.gap[i]);
      if (smallest == infinity)
        return;
      throw InputError(entry_of_gap(body.scene, true) + "\n  allowed: above " +
                       length_text(body.scene, -smallest) +
                       ", minus the smallest Contact/Gap\n  remedy:  a larger "
                       "one: the stops overlap");
    }



    /** A rigid obstacle must not be penetrated. */
    template <int dim>
    void
    check_penetration(const Body<dim> &body,
                      const double     first_step_size,
                      const State     &state)
    {
      const Scene &scene = body.scene;
      if (!scene.contact.has_rigid() || scene.material.is_static())
        return; // a static body is in equilibrium with the obstacle
      const QuantityUnits units(scene.parameters);
      const double        prescribed_time =
        scene.has_prescribed_start && scene.parameters.time.end_time > 0. ?
                 first_step_size :
                 0.;
      ContactValues values;
      get_contact_values(body, state, values);
      const std::vector<double> &displacement = values.displacement;
      for (const auto *obstacle : {&values.front, &values.rear})
        {
          std::vector<double> penetration = obstacle->penetration;
          for (unsigned int i = 0; i < penetration.size(); ++i)
            if (!scene.contact.law_at(i).is_rigid())
              penetration[i] = -infinity;
          const std::string entry =
            entry_of_gap(scene, obstacle == &values.rear) + ": the ";
          const unsigned int deepest =
            std::max_element(penetration.begin(), penetration.end()) -
            penetration.begin();
          const std::string depth = units.text("length", penetration[deepest]);
          const std::string remedy_of_row =
            "another Displacement of a body, or Contact/Condition = normal "
            "compliance";
          if (penetration[deepest] > 0. && scene.row.is_given() &&
              obstacle == &values.front)
            throw InputError(
              "Contacts: " + scene.row.contact_names()[deepest] +
              " overlap by " + depth +
              " at the start, and are rigid\n  remedy:  a larger gap there, " +
              remedy_of_row);
          if (penetration[deepest] > 0.)
            throw InputError(
              entry + "initial displacement " +
              units.text("length", displacement[deepest]) + " of the end" +
              (scene.contact.has_uniform_gap() ?
                 "" :
                 ", where the gap is " +
                   units.text("length", state.gap[deepest]) + ',') +
              " penetrates the rigid obstacle\n  remedy:  a larger gap, " +
              (scene.row.is_given() ?
                 remedy_of_row :
                 "another Initial values/Displacement, or Contact/Condition = "
                 "normal compliance"));
          for (unsigned int i = 0; i < penetration.size(); ++i)
            if (const double way = prescribed_time * obstacle->velocity[i];
                penetration[i] + way >
                Tolerances::rounding_of_data *
                  (std::abs(displacement[i]) + std::abs(way)))
              throw InputError(
                entry + "prescribed first step of the paper would penetrate "
                        "the rigid obstacle\n  remedy:  Time/Start = "
                        "consistent, or a smaller Time/Step size");
        }
    }



    /** Warns of a body that is in contact at the start, and of a preload. */
    template <int dim>
    void
    warn_of_contact(const Body<dim>          &body,
                    const State              &state,
                    std::vector<std::string> &warnings)
    {
      const auto  &gaps = body.obstacle.gaps_at_start();
      const double gap  = *std::min_element(gaps.begin(), gaps.end());
      // of the largest magnitude: one behind the end pushes with a negative one
      const double pressure =
        *std::max_element(state.contact.pressure.begin(),
                          state.contact.pressure.end(),
                          [](const double p, const double q) {
                            return std::abs(p) < std::abs(q);
                          });
      if (!body.law().is_active() || (gap >= 0. && pressure == 0.))
        return;
      std::vector<double> displacement;
      body.contact_end().get_values(Field::displacement,
                                    state.displacement,
                                    displacement);
      const QuantityUnits units(body.scene.parameters);
      if (body.scene.row.is_given())
        {
          for (unsigned int i = 0; i < state.contact.pressure.size(); ++i)
            if (state.contact.pressure[i] != 0.)
              warnings.push_back(text(
                "Contacts: ",
                body.scene.row.contact_names()[i],
                " press on each other at the start with ",
                units.text("stress", std::abs(state.contact.pressure[i]))));
          return;
        }
      warnings.push_back(text(
        entry_of_gap(body.scene, false),
        ": ",
        gap < 0. ? "negative, the undeformed body overlaps the obstacle "
                   "(preload)" :
                   "the body is in contact at the start",
        ", end displacement ",
        units.text("length",
                   *std::max_element(displacement.begin(), displacement.end())),
        ", initial pressure ",
        units.text("stress", pressure)));
    }
  } // namespace



  template <int dim>
  State
  initial_state(Body<dim>                &body,
                Reset<dim>               &reset,
                const double              first_step_size,
                std::vector<std::string> &warnings)
  {
    const Discretization<dim> &discretization = body.discretization;
    State                      state          = body.make_state();
    body.obstacle.place(0., 0., state);
    {
      const H1Projection<dim> projection(body.scene,
                                         discretization,
                                         body.equations.cell_products());
      projection.project(*body.data.initial_fields,
                         state.temperature,
                         state.displacement);
      Vector unused(state.temperature);
      projection.project(*body.data.initial_velocity, unused, state.velocity);
    }
    if (body.scene.fields.has_temperature)
      warn_of_lost_heat(body, state, warnings);
    discretization.set_zero_in_gaps(state);
    if (const auto entry = discretization.obstacle_entry(Field::displacement))
      state.velocity.begin()[*entry] = body.scene.obstacle_mass->velocity;
    if (const auto entry = discretization.obstacle_entry(Field::temperature))
      state.temperature.begin()[*entry] = body.scene.obstacle_mass->temperature;
    check_values(body, state, warnings);
    if constexpr (dim == 1)
      if (body.scene.has_midpoint_mass)
        set_means_of_cells(body, state.velocity);
    check_overlap(body, state);
    stay_before_obstacle(body, state);
    check_penetration(body, first_step_size, state);
    if (body.scene.fields.has_temperature && !starts_with_layer(body, state))
      for (const unsigned int entry :
           discretization.constrained_entries(Field::temperature))
        state.temperature.begin()[entry] =
          discretization.is_right_end(entry) ?
            *body.scene.heat.right_temperature :
            body.scene.heat.fixed_end_temperature;

    set_pressures_of_law(body, state);
    reset.complete(state);
    warn_of_contact(body, state, warnings);

    set_exchange_of_law(body, state);
    return state;
  }



#define INSTANTIATE(dim)                     \
  template State initial_state(Body<dim> &,  \
                               Reset<dim> &, \
                               const double, \
                               std::vector<std::string> &)

  INSTANTIATE(1);
  INSTANTIATE(2);
  INSTANTIATE(3);

#undef INSTANTIATE
} // namespace ThermoContact
