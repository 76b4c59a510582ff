// SPDX-License-Identifier: LGPL-2.1-or-later

#include <thermocontact/base/exceptions.h>
#include <thermocontact/base/number_text.h>
#include <thermocontact/base/special_numbers.h>
#include <thermocontact/base/text.h>
#include <thermocontact/base/tolerances.h>
#include <thermocontact/input/parameter_file.h>
#include <thermocontact/scene/scene.h>

#include <algorithm>
#include <cmath>

namespace ThermoContact
{
  namespace
  {
    Material
    resolve_material(const Parameters &parameters, const SceneFields &fields)
    {
      const ModelParameters    &model      = parameters.model;
      const BoundaryParameters &boundary   = parameters.boundary;
      const Elasticity          elasticity = elasticity_of(model.poisson_ratio);
      const double              stress =
        fields.has_temperature && fields.has_displacement ? model.coupling : 0.;
      return {model.inertia,
              parameters.has_masses_alone() ? 0. : model.viscosity,
              stress,
              model.heating ? stress : 0.,
              elasticity.lambda,
              elasticity.two_mu,
              boundary.left.dashpot > 0. || boundary.right.dashpot > 0.};
    }



    std::optional<ObstacleMass>
    resolve_obstacle_mass(const Parameters  &parameters,
                          const SceneFields &fields)
    {
      const BodyParameters *const mass = parameters.obstacle_mass();
      if (mass == nullptr || !fields.has_displacement)
        return {};
      const auto at_start = [&](const char *entry, const std::string &text) {
        const std::string path         = "Bodies/" + mass->name + "/" + entry;
        const double      variables[4] = {};
        return Expression(path, text, parameters.names(path))
          .evaluate(variables);
      };
      return ObstacleMass{mass->mass,
                          parameters.boundary.right.spring,
                          parameters.boundary.right.dashpot,
                          at_start("Velocity", mass->velocity),
                          fields.has_temperature ?
                            std::optional(mass->heat_capacity.value) :
                            std::nullopt,
                          at_start("Temperature", mass->temperature)};
    }



    /** Null for an empty one. */
    std::unique_ptr<const Expression>
    read_expression(const Parameters  &parameters,
                    const std::string &path,
                    const std::string &text)
    {
      return text.empty() ?
               nullptr :
               std::make_unique<const Expression>(path,
                                                  text,
                                                  parameters.names(path));
    }



    /** SceneContact::gap. */
    double
    resolve_gap(const Parameters       &parameters,
                const Expression *const expression)
    {
      if (expression == nullptr)
        return parameters.contact.gap;
      if (parameters.dimension > 1 &&
          (expression->depends_on("y") || expression->depends_on("z")))
        return nan;
      return TimeFunction(*expression, dealii::Point<3>(1., 0., 0.)).value(0.);
    }



    /** The same of an expression in t. */
    std::unique_ptr<const TimeFunction>
    read_drive(const Parameters  &parameters,
               const std::string &path,
               const std::string &text)
    {
      const auto expression = read_expression(parameters, path, text);
      return expression ? std::make_unique<const TimeFunction>(*expression) :
                          nullptr;
    }



    /**
     * The heat exchange that Boundary/right/Heat exchange says.
     *
     * @throw InputError if it cannot be read
     */
    std::unique_ptr<const HeatExchange>
    resolve_exchange(const Parameters &parameters)
    {
      const auto expression =
        read_expression(parameters,
                        "Boundary/right/Heat exchange",
                        parameters.boundary.right.exchange_expression);
      const double k = parameters.boundary.right.heat_exchange;
      if (!expression && parameters.obstacle_mass() != nullptr && k > 0.)
        {
          HeatExchange::Dependence by;
          by.on_partner = true;
          return std::make_unique<const HeatExchange>(
            "k = " + significant(k, 6),
            by,
            [k](const double, const double, const ExchangeConditions &) {
              return k;
            });
        }
      if (!expression)
        return std::make_unique<const HeatExchange>(k);
      return std::make_unique<const HeatExchange>(
        "k = " + expression->text(),
        HeatExchange::Dependence{expression->depends_on("gap") ||
                                   expression->depends_on("pressure"),
                                 expression->depends_on("theta") ||
                                   expression->depends_on("theta_obs"),
                                 expression->depends_on("t")},
        [law = *expression](const double              gap,
                            const double              pressure,
                            const ExchangeConditions &there) {
          const double variables[] = {
            gap, pressure, there.temperature, there.surroundings, there.time};
          return law.evaluate(variables);
        });
    }



    /**
     * Looks at the exchange of an end that is as warm as what is around it.
     *
     * @param largest_gap up to which it is checked
     * @throw InputError if it is negative or not finite at a gap up to there or
     *   a pressure up to 1
     */
    void
    check_sign_of_exchange(const SceneHeat &heat, const double largest_gap)
    {
      constexpr unsigned int n = 1000;
      try
        {
          for (const double temperature :
               {heat.fixed_end_temperature, heat.obstacle_temperature})
            for (unsigned int i = 0; i <= n; ++i)
              {
                const double             part = static_cast<double>(i) / n;
                const ExchangeConditions there{temperature,
                                               heat.obstacle_temperature};
                heat.exchange->coefficient(-part * largest_gap, 0., there);
                heat.exchange->coefficient(0., part, there);
              }
        }
      catch (const ComputationError &error)
        {
          throw InputError(error.what());
        }
    }



    SceneHeat
    resolve_heat(const Parameters       &parameters,
                 const Expression *const gap_expression)
    {
      const BoundaryParameters &boundary = parameters.boundary;
      const double initial_gap = resolve_gap(parameters, gap_expression);
      const double gap         = std::isnan(initial_gap) ? 0. : initial_gap;
      const double rear_gap    = parameters.contact.rear_gap.value_or(gap);
      SceneHeat    heat;
      heat.exchange                        = resolve_exchange(parameters);
      const BoundaryParameters::Left &left = boundary.left;
      heat.has_given_temperature           = left.has_temperature();
      heat.left_exchange = heat.has_given_temperature ? 0. : left.heat_exchange;
      heat.right_temperature = boundary.right.temperature;
      if (heat.has_given_temperature)
        heat.fixed_end_drive = read_drive(parameters,
                                          "Boundary/left/Temperature",
                                          boundary.left.temperature_expression);
      heat.fixed_end_temperature =
        heat.fixed_end_drive       ? heat.fixed_end_drive->value(0.) :
        heat.has_given_temperature ? left.temperature :
                                     left.surroundings;
      heat.obstacle_drive =
        read_expression(parameters,
                        "Boundary/right/Surroundings",
                        boundary.right.surroundings_expression);
      heat.obstacle_temperature =
        heat.obstacle_drive ?
          TimeFunction(*heat.obstacle_drive, dealii::Point<3>(1., 0., 0.))
            .value(0.) :
          boundary.right.surroundings;
      check_sign_of_exchange(heat, std::max({gap, rear_gap, 1.}));
      heat.reference_coefficient = // at the nearer obstacle
        heat.exchange->coefficient(-std::min(gap, rear_gap),
                                   0.,
                                   {heat.obstacle_temperature,
                                    heat.obstacle_temperature});
      heat.lateral_exchange    = boundary.sides.heat_exchange;
      heat.ambient_temperature = boundary.sides.surroundings;
      return heat;
    }



    std::unique_ptr<const TimeFunction>
    resolve_motion(const Parameters &parameters, const SceneFields &fields)
    {
      const std::string &text = parameters.boundary.left.displacement;
      return fields.has_displacement && !parameters.boundary.left.is_free() &&
                 !equal_values(text, "0") ?
               read_drive(parameters, "Boundary/left/Displacement", text) :
               nullptr;
    }



    SceneSources
    resolve_sources(const Parameters       &parameters,
                    const SceneFields      &fields,
                    const SceneHeat        &heat,
                    const Expression *const gap,
                    const bool              has_nonlinear_terms,
                    const bool              has_motion,
                    const bool              has_obstacle)
    {
      const SourceParameters &sources = parameters.sources;

      const auto acts = [](const bool has_field, const std::string &text) {
        return has_field && !equal_values(text, "0");
      };
      return {
        acts(fields.has_temperature, sources.heat_source),
        acts(fields.has_displacement, sources.body_force),
        acts(fields.has_displacement, parameters.boundary.right.traction),
        acts(fields.has_temperature, parameters.boundary.right.heat_flux),
        parameters.boundary.left.is_free() &&
          acts(fields.has_displacement, parameters.boundary.left.traction),
        !heat.has_given_temperature &&
          acts(fields.has_temperature, parameters.boundary.left.heat_flux),
        fields.has_temperature && heat.linear_coefficient() > 0. &&
          heat.obstacle_drive != nullptr,
        fields.has_temperature && !heat.exchange->is_in_matrices() &&
          (heat.obstacle_drive || heat.exchange->dependence().on_time),
        fields.has_temperature && heat.fixed_end_drive != nullptr,
        has_motion,
        has_obstacle && gap != nullptr && gap->depends_on("t"),
        has_nonlinear_terms};
    }



    bool
    resolve_prescribed_start(const Parameters  &parameters,
                             const SceneFields &fields,
                             const SceneHeat   &heat,
                             const Scheme      &scheme,
                             const bool         has_motion)
    {
      return fields.has_displacement && parameters.model.inertia > 0. &&
             heat.exchange->is_in_matrices() && !has_motion &&
             (parameters.time.start == "paper" ||
              (parameters.time.start == "automatic" &&
               scheme.is_backward_euler &&
               parameters.contact.massless_nodes != "on"));
    }



    /**
     * Contact nodes have no mass, (C1.1), where they would oscillate, or if
     * several of them meet a rigid obstacle one by one; and if the scheme needs
     * it.
     */
    bool
    resolve_massless_nodes(const Parameters   &parameters,
                           const SceneContact &contact,
                           const Scheme       &scheme,
                           const bool          has_nonlinear_terms,
                           const bool          has_prescribed_start)
    {
      const ContactLaw &law = *contact.law;
      if (!law.is_active() || parameters.model.inertia == 0. ||
          parameters.mesh.n_nodes(1) == 2.)
        return false;
      const BoundaryParameters::Right &right = parameters.boundary.right;
      if (scheme.has_no_dispersion || right.mass > 0. || right.dashpot > 0. ||
          parameters.has_row() || parameters.obstacle_mass() != nullptr ||
          has_nonlinear_terms)
        // its mass matrix knows no single nodes, they carry something, what
        // they meet moves by itself, or their stress is that of tangents
        return false;
      if (parameters.contact.massless_nodes != "automatic")
        return parameters.contact.massless_nodes == "on";
      if (contact.is_damped())
        return false; // it acts on what has inertia
      if (has_prescribed_start)
        return false; // the paper's scheme, as it is
      return scheme.needs_massless_contact ||
             (parameters.dimension > 1 && law.is_rigid()) ||
             contact.any([&](const ContactLaw &one) {
               return contact_nodes_oscillate(parameters, one);
             });
    }



    /** Of this kind and these numbers; none where nothing can meet. */
    std::unique_ptr<const ContactLaw>
    resolve_law(const Parameters  &parameters,
                const SceneFields &fields,
                const BodyRow     &row,
                const RowLaw      &law)
    {
      const bool can_meet =
        fields.has_displacement &&
        (row.is_given() ? row.n_contacts() > 0 :
                          parameters.boundary.right.meets_obstacle());
      return (can_meet ? contact_law(law.kind) : no_obstacle())
        .make(law.numbers);
    }



    /** The law of section Contact; the first one of a row that has it nowhere.
     */
    RowLaw
    general_law(const Parameters &parameters, const BodyRow &row)
    {
      if (!parameters.uses_general_law() && !row.contacts.empty())
        return *row.contacts.front().law;
      return {parameters.contact.condition, parameters.contact.law};
    }



    SceneContact
    resolve_contact(const Parameters       &parameters,
                    const Expression *const gap,
                    const SceneFields      &fields,
                    const BodyRow          &row,
                    const Material         &material,
                    const Scheme           &scheme,
                    const bool              has_nonlinear_terms,
                    const bool              has_prescribed_start)
    {
      SceneContact contact;
      const RowLaw general = general_law(parameters, row);
      contact.law          = resolve_law(parameters, fields, row, general);
      if (contact.law->is_active() && parameters.contact.has_own_rear_law())
        contact.rear_law = resolve_law(
          parameters,
          fields,
          row,
          {general.kind,
           parameters.contact.own_rear_law.instead_of(general.numbers)});
      for (const RowContact &pair : row.contacts)
        contact.pair_laws.push_back(
          pair.law ? resolve_law(parameters, fields, row, *pair.law) : nullptr);
      contact.gap = resolve_gap(parameters, gap);
      if (contact.law->is_active() && parameters.contact.rear_gap &&
          parameters.boundary.right.meets_obstacle())
        contact.rear_gap = *parameters.contact.rear_gap;
      contact.has_massless_nodes = resolve_massless_nodes(
        parameters, contact, scheme, has_nonlinear_terms, has_prescribed_start);
      for (const int side : {1, -1})
        {
          const ContactLaw &law        = contact.law_of(side);
          const auto        compliance = law.compliance();
          if (material.has_inertia() && !contact.has_massless_nodes &&
              !row.is_given() && !parameters.obstacle_mass() && compliance &&
              !law.is_damped() && contact_nodes_oscillate(parameters, law))
            contact.bouncing_compliance =
              std::min(contact.bouncing_compliance.value_or(infinity),
                       *compliance);
        }
      contact.order = material.has_inertia() && !contact.has_massless_nodes ?
                        NodeOrder::inertial :
                      material.has_viscosity() && scheme.has_viscous_contact ?
                        NodeOrder::viscous :
                        NodeOrder::quasi_static;
      contact.locates_events =
        contact.law->is_active() && parameters.time.locates_contact_events();
      return contact;
    }



    /** LinearSolver::needs_factors. */
    std::string
    reason_for_factors(const Parameters &parameters)
    {
      if (parameters.dimension == 1)
        return "Dimension = 1";
      if (parameters.has_material())
        return "section Bodies is given";
      return "";
    }



    /**
     * Unknowns from which on iterations cost less than factors, within a factor
     * of two: 250 stages in 50 steps take some ten seconds there, measured; in
     * two dimensions ten times as many with the scheme that conserves energy
     * and the iteration of the paper, whose steps have one size. A number that
     * is known before the run, and the same on every machine.
     */
    double
    most_unknowns_of_factors(const unsigned int dim, const bool has_one_size)
    {
      if (dim == 3)
        return 3000.;
      return has_one_size ? 130000. : 13000.;
    }



    LinearSolver
    resolve_linear_solver(const Parameters  &parameters,
                          const SceneFields &fields,
                          const Scheme      &scheme,
                          const bool         is_fixed_point)
    {
      const std::string       needs_factors = reason_for_factors(parameters);
      const SolverParameters &solver        = parameters.solver;
      const unsigned int      dim           = parameters.dimension;
      LinearSolver            result{false,
                          false,
                          is_fixed_point ? Tolerances::rounding_of_solution :
                                                      solver.linear_tolerance.value_or(
                                             Tolerances::default_residual),
                          needs_factors,
                          needs_factors};
      if (solver.linear_solver != "automatic")
        {
          result.is_iterative = solver.linear_solver == "iterative";
          result.reason = "Solver/Linear solver = " + solver.linear_solver;
        }
      else if (!needs_factors.empty())
        result.is_along_rod = dim == 1;
      else
        {
          const double n_unknowns = parameters.mesh.n_nodes(dim) *
                                    fields.n_components(dim),
                       most = most_unknowns_of_factors(
                         dim,
                         is_fixed_point || scheme.integrator ==
                                             IntegratorKind::energy_conserving);
          result.is_iterative = n_unknowns > most;
          result.reason =
            text(significant(n_unknowns, 3),
                 " unknowns, ",
                 result.is_iterative ? "more than " : "not more than ",
                 most);
        }
      return result;
    }
  } // namespace



  Scene::Scene(const Parameters &written)
    : scheme_choice(choose_scheme(written))
    , fields{parameters.model.fields != "displacement",
             parameters.model.fields != "temperature"}
    , row(resolve_row(parameters))
    , profile(parameters.has_material() ?
                std::optional<BodyProfile>(parameters) :
                std::nullopt)
    , obstacle_mass(resolve_obstacle_mass(parameters, fields))
    , geometry(parameters.mesh.make_geometry(parameters.dimension))
    , material(resolve_material(parameters, fields))
    , gap_expression(read_expression(parameters,
                                     "Contact/Gap",
                                     parameters.contact.gap_expression))
    , heat(resolve_heat(parameters, gap_expression.get()))
    , fixed_end_motion(resolve_motion(parameters, fields))
    , sources(resolve_sources(
        parameters,
        fields,
        heat,
        gap_expression.get(),
        row.depends_on_temperature() ||
          (profile && profile->depends_on_temperature()),
        fixed_end_motion != nullptr,
        resolve_law(parameters, fields, row, general_law(parameters, row))
          ->is_active()))
    , scheme(ThermoContact::scheme(parameters.time.scheme))
    , has_prescribed_start(
        resolve_prescribed_start(parameters,
                                 fields,
                                 heat,
                                 scheme,
                                 fixed_end_motion != nullptr ||
                                   sources.has_moving_obstacle ||
                                   sources.has_nonlinear_terms))
    , contact(resolve_contact(parameters,
                              gap_expression.get(),
                              fields,
                              row,
                              material,
                              scheme,
                              sources.has_nonlinear_terms,
                              has_prescribed_start))
    , has_rollers(parameters.boundary.sides.support == "rollers")
    , has_symmetry(parameters.boundary.sides.support == "symmetric")
    , has_sliding_end(parameters.boundary.left.support == "sliding")
    , has_free_end(parameters.boundary.left.is_free())
    , has_lumped_mass(parameters.mesh.mass_matrix == "lumped")
    , has_midpoint_mass(scheme.has_no_dispersion)
    , is_fixed_point(parameters.solver.step_solver == "fixed point")
    , linear_solver(
        resolve_linear_solver(parameters, fields, scheme, is_fixed_point))
  {}



  std::vector<std::string>
  scene_fields(const Scene &scene)
  {
    std::vector<std::string> fields;
    if (scene.fields.has_temperature)
      fields.emplace_back("temperature");
    if (scene.fields.has_displacement)
      fields.emplace_back("displacement");
    return fields;
  }



  std::vector<std::string>
  scene_terms(const Scene &scene)
  {
    const Material          &material         = scene.material;
    const bool               has_temperature  = scene.fields.has_temperature;
    const bool               has_displacement = scene.fields.has_displacement;
    std::vector<std::string> terms;
    const auto add_if = [&terms](const bool has, const std::string &word) {
      if (has)
        terms.push_back(word);
    };
    add_if(has_temperature, "heat conduction");
    add_if(has_temperature && scene.heat.has_exchange(), "heat exchange");
    add_if(has_temperature && scene.heat.left_exchange > 0.,
           "heat exchange on the left");
    add_if(has_temperature && scene.heat.has_lateral_exchange(),
           "lateral heat exchange");
    add_if(has_displacement && material.has_inertia(), "inertia");
    add_if(has_displacement && !scene.parameters.has_masses_alone(),
           "elasticity");
    const auto &left  = scene.parameters.boundary.left;
    const auto &right = scene.parameters.boundary.right;
    add_if(has_displacement && scene.has_free_end, "free end on the left");
    for (const auto &[value, word] :
         {std::pair(left.spring, "spring on the left"),
          std::pair(left.dashpot, "dashpot on the left"),
          std::pair(left.mass, "mass on the left"),
          std::pair(right.spring, "spring on the right"),
          std::pair(right.dashpot, "dashpot on the right"),
          std::pair(right.mass, "mass on the right")})
      add_if(has_displacement && value > 0., word);
    add_if(scene.obstacle_mass.has_value(), "mass as the obstacle");
    add_if(has_displacement && material.has_viscosity(), "viscosity");
    add_if(material.has_thermal_stress(), "thermal stress");
    add_if(material.has_heating(), "thermoelastic heating");
    for (const ContactLawKind &kind : contact_laws())
      add_if(scene.contact.law->is_active() && scene.has_law_of(kind),
             kind.make(scene.parameters.contact.law)->is_rigid() ?
               "rigid contact" :
               kind.name);
    add_if(scene.contact.is_damped(), "damped contact");
    add_if(scene.contact.is_two_sided(), "two stops");
    add_if(scene.contact.has_massless_nodes, "massless contact nodes");
    add_if(scene.has_lumped_mass && (has_temperature || material.has_inertia()),
           "lumped mass");
    add_if(scene.has_midpoint_mass && material.has_inertia(),
           "mass in the middles of cells");
    add_if(scene.sources.has_heat_source, "heat source");
    add_if(scene.sources.has_body_force, "body force");
    add_if(scene.sources.has_end_traction, "end traction");
    add_if(scene.sources.has_end_heat_flux, "end heat flux");
    add_if(scene.sources.has_left_traction, "traction on the left");
    add_if(scene.sources.has_left_heat_flux, "heat flux on the left");
    add_if(scene.sources.has_varying_obstacle,
           "varying temperature of the obstacle");
    add_if(scene.sources.has_driven_exchange, "heat exchange in time");
    add_if(scene.sources.has_driven_temperature,
           "varying temperature of the fixed end");
    add_if(scene.sources.has_moving_end, "moving fixed end");
    add_if(scene.sources.has_moving_obstacle, "moving obstacle");
    add_if(scene.sources.has_nonlinear_terms,
           "coefficients of the temperature");
    return terms;
  }
} // namespace ThermoContact
