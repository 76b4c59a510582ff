// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef thermocontact_scene_scene_h
#define thermocontact_scene_scene_h

#include <thermocontact/base/special_numbers.h>
#include <thermocontact/contact/contact_law.h>
#include <thermocontact/contact/heat_exchange.h>
#include <thermocontact/input/parameters.h>
#include <thermocontact/input/time_function.h>
#include <thermocontact/method/body_geometry.h>
#include <thermocontact/method/rest_profile.h>
#include <thermocontact/method/scheme.h>
#include <thermocontact/scene/body_profile.h>
#include <thermocontact/scene/row.h>
#include <thermocontact/scene/scheme_choice.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <optional>
#include <string>
#include <tuple>

namespace ThermoContact
{
  /** The fields of a scene; an absent one has no unknowns and no matrices. */
  struct SceneFields
  {
    bool has_temperature;
    bool has_displacement;

    /** Number of scalar unknowns per node. */
    unsigned int
    n_components(const unsigned int dim) const
    {
      return (has_temperature ? 1 : 0) + (has_displacement ? dim : 0);
    }

    /** All members, to compare: a binding that leaves one out does not
     * compile. */
    auto
    members() const
    {
      const auto &[a, b] = *this;
      return std::tie(a, b);
    }
  };



  /** The coefficients that a scene has, doc/model.md (M1.1), (M1.2), (M1.6). */
  struct Material
  {
    double inertia;        ///< $b\ge0$
    double viscosity;      ///< $\zeta\ge0$
    double thermal_stress; ///< $a$ of $-a\theta$; 0 if a field is absent
    double heating;        ///< $a$ of $-a\,\mathrm{div}\,u_t$; 0 if it is off
    double lambda;         ///< Lame coefficients of unit P-wave modulus
    double two_mu;
    bool   has_dashpots; ///< at the ends of a rod

    /** All members, to compare: a binding that leaves one out does not
     * compile. */
    auto
    members() const
    {
      const auto &[a, b, c, d, e, f, g] = *this;
      return std::tie(a, b, c, d, e, f, g);
    }

    Elasticity
    elasticity() const
    {
      return {lambda, two_mu};
    }

    bool
    has_inertia() const
    {
      return inertia > 0.;
    }

    bool
    has_viscosity() const
    {
      return viscosity > 0.;
    }

    /**
     * The factor of $S_\zeta$, which contains the dashpots: $\zeta$, or 1
     * where they alone resist velocities.
     */
    double
    viscous_factor() const
    {
      return has_viscosity() ? viscosity : has_dashpots ? 1. : 0.;
    }

    bool
    has_thermal_stress() const
    {
      return thermal_stress != 0.;
    }

    /** True if the motion heats the body, so that fields act on each other. */
    bool
    has_heating() const
    {
      return heating != 0.;
    }

    /** The thermal stress works and takes no heat for it. */
    bool
    is_driven_by_heat() const
    {
      return has_thermal_stress() && !has_heating();
    }

    /** Of the body, by $b$ and $\zeta$. */
    NodeOrder
    order() const
    {
      return has_inertia()   ? NodeOrder::inertial :
             has_viscosity() ? NodeOrder::viscous :
                               NodeOrder::quasi_static;
    }

    /** True if displacements are in equilibrium at every time, $b=\zeta=0$. */
    bool
    is_static() const
    {
      return order() == NodeOrder::quasi_static;
    }
  };



  /**
   * Heat between the contact end and the obstacle, (M1.3), between the lateral
   * faces and the surroundings, (M5.5), and the steady profile
   * $\theta_s=\theta_A-c(\theta_A-\theta_{obs})x$ of one coefficient, (M2.1).
   */
  struct SceneHeat
  {
    std::unique_ptr<const HeatExchange> exchange;

    /**
     * $\theta_A$ of the end $x=0$; if it varies, its value at $t=0$; if none
     * is given there, the temperature $\theta_{sA}$ of its surroundings.
     */
    double fixed_end_temperature;

    bool has_given_temperature; ///< at the end $x=0$

    double left_exchange; ///< $k_A\ge0$; 0 where a temperature is given

    /** $\theta_B$ of the end $x=1$, if it is given; heat is exchanged else. */
    std::optional<double> right_temperature;

    /** $\theta_A(t)$ if it varies; else null. */
    std::unique_ptr<const TimeFunction> fixed_end_drive;

    /** $\theta_{obs}$; if it varies, its value at $t=0$, $y=z=0$. */
    double obstacle_temperature;

    /** $\theta_{obs}$ of the coordinates and t if it is no number; else null.
     */
    std::unique_ptr<const Expression> obstacle_drive;

    /**
     * $k_s$ of the steady profile: $k$ at the gap of the undeformed body, or at
     * gap 0 if that is an expression. The profile is a reference: any will do.
     */
    double reference_coefficient;

    double lateral_exchange;    ///< $m\ge0$, of the lateral faces, (M5.5)
    double ambient_temperature; ///< $\theta_\infty$

    bool
    has_lateral_exchange() const
    {
      return lateral_exchange > 0.;
    }

    /** The data of the temperature of a rod at rest. */
    RodSurroundings
    surroundings() const
    {
      return {fixed_end_temperature,
              obstacle_temperature,
              lateral_exchange,
              ambient_temperature};
    }

    /** The largest difference to the temperature of the left end. */
    double
    temperature_range() const
    {
      const double drop =
        std::abs(fixed_end_temperature - obstacle_temperature);
      return has_lateral_exchange() ?
               std::max(drop,
                        std::abs(fixed_end_temperature - ambient_temperature)) :
               drop;
    }

    /** False if no heat is exchanged. */
    bool
    has_exchange() const
    {
      if (right_temperature)
        return false;
      return !exchange->is_in_matrices() || reference_coefficient > 0.;
    }

    /** The $k$ that matrices and loads contain: one that is constant, or 0. */
    double
    linear_coefficient() const
    {
      return exchange->is_in_matrices() ? reference_coefficient : 0.;
    }

    /** $k\theta_{obs}$ of it, what the obstacle gives by its temperature. */
    double
    obstacle_heat() const
    {
      return right_temperature ? 0. :
                                 linear_coefficient() * obstacle_temperature;
    }


    /** $c=k_s/(k_s+1)$, the part of the way to the obstacle's temperature. */
    double
    steady_drop() const
    {
      return reference_coefficient / (reference_coefficient + 1.);
    }

    /** Whether the profile at rest is steady_temperature() everywhere. */
    bool
    has_linear_profile() const
    {
      return !has_lateral_exchange();
    }

    /** $\theta_s(x)$ without a lateral heat exchange, (M2.1), (M2.4). */
    double
    steady_temperature(const double x) const
    {
      if (right_temperature)
        {
          // from the left end or its surroundings, with their resistance
          const double resistance = has_given_temperature ? 0. :
                                    left_exchange > 0.    ? 1. / left_exchange :
                                                            infinity;
          return *right_temperature +
                 (fixed_end_temperature - *right_temperature) * (1. - x) /
                   (1. + resistance);
        }
      if (has_given_temperature)
        return fixed_end_temperature -
               steady_drop() * (fixed_end_temperature - obstacle_temperature) *
                 x;
      if (left_exchange == 0.)
        return reference_coefficient > 0. ? obstacle_temperature :
                                            fixed_end_temperature;
      // the resistance of the obstacle and the body is 1/steady_drop()
      const double flux = steady_drop() *
                          (fixed_end_temperature - obstacle_temperature) /
                          (1. + steady_drop() / left_exchange);
      return fixed_end_temperature - flux / left_exchange - flux * x;
    }
  };



  /** The contact end and the obstacle. */
  struct SceneContact
  {
    /** In front, of section Contact; in a row none of whose contacts has that
     * one, the law of the first. */
    std::unique_ptr<const ContactLaw> law;

    /** Of the obstacle behind the end, of the same kind; none: as in front. */
    std::unique_ptr<const ContactLaw> rear_law;

    /** Of the contacts of bodies of a row, the first nodes, that have laws of
     * their own; none: as in front. */
    std::vector<std::unique_ptr<const ContactLaw>> pair_laws;

    /**
     * $g$ of the undeformed body, at $t=0$ if the obstacle moves; NaN if it is
     * not the same everywhere.
     */
    double gap;

    /** $g_2$ of an obstacle behind the end, of a row its right end, (M4.3);
     * infinite: there is none. */
    double rear_gap = infinity;

    /** Of the contact nodes; meaningless without obstacle. */
    NodeOrder order;

    /** The mass of the contact nodes is moved to others, (C1.1). */
    bool has_massless_nodes;

    /** They have it, and nothing damps them on an obstacle that gives way:
     * $\varepsilon$ of the hardest such one; none: they do not bounce. */
    std::optional<double> bouncing_compliance;

    /** Steps end where contact begins or ends. */
    bool locates_events;

    /** The law of the obstacle in front, 1, or behind, -1. */
    const ContactLaw &
    law_of(const int side) const
    {
      return side < 0 && rear_law ? *rear_law : *law;
    }

    /** The law of a contact node, in front of it, 1, or behind, -1. */
    const ContactLaw &
    law_at(const unsigned int node, const int side = 1) const
    {
      if (node < pair_laws.size())
        return pair_laws[node] ? *pair_laws[node] : *law;
      return law_of(side);
    }

    /** The law that gives a contact node this pressure. */
    const ContactLaw &
    law_under(const double pressure, const unsigned int node) const
    {
      return law_at(node, pressure < 0. ? -1 : 1);
    }

    /** Penetration of a contact node under this pressure, without damping. */
    double
    penetration_under(const double pressure, const unsigned int node) const
    {
      return law_under(pressure, node).penetration(std::abs(pressure));
    }

    /** Whether one of the laws has a property. */
    template <typename Has>
    bool
    any(const Has &has) const
    {
      return has(*law) || has(law_of(-1)) ||
             std::any_of(pair_laws.begin(),
                         pair_laws.end(),
                         [&](const auto &one) { return one && has(*one); });
    }

    /** Nothing penetrates at one of the contacts. */
    bool
    has_rigid() const
    {
      return any([](const ContactLaw &one) { return one.is_rigid(); });
    }

    /** Others give way beside it. */
    bool
    has_rigid_beside_elastic() const
    {
      return has_rigid() &&
             any([](const ContactLaw &one) { return !one.is_rigid(); });
    }

    /** A pressure depends on the velocity. */
    bool
    is_damped() const
    {
      return any([](const ContactLaw &one) { return one.is_damped(); });
    }

    /** $d$, (M4.2), of the obstacle that has the largest one. */
    double
    dashpot() const
    {
      double largest = 0.;
      any([&](const ContactLaw &one) {
        largest = std::max(largest, one.dashpot());
        return false;
      });
      return largest;
    }

    bool
    has_dashpot() const
    {
      return dashpot() > 0.;
    }

    /** Of the hardest obstacle that has one. */
    std::optional<double>
    compliance() const
    {
      std::optional<double> smallest;
      any([&](const ContactLaw &one) {
        if (const auto compliance = one.compliance())
          smallest = std::min(smallest.value_or(infinity), *compliance);
        return false;
      });
      return smallest;
    }

    bool
    has_uniform_gap() const
    {
      return !std::isnan(gap);
    }

    bool
    is_two_sided() const
    {
      return std::isfinite(rear_gap);
    }

    /** $g_2$ of a contact node; infinite where bodies meet. */
    double
    rear_gap_at(const unsigned int node) const
    {
      return node < pair_laws.size() ? infinity : rear_gap;
    }

    /** The displacement with which a node touches the obstacle in front, 1,
     * that is at this gap, or the one behind, -1. */
    double
    place(const int side, const unsigned int node, const double gap) const
    {
      return side > 0 ? gap : -rear_gap_at(node);
    }

    /** True if an obstacle in front of a node at this gap reaches the one
     * behind. */
    bool
    stops_overlap(const unsigned int node, const double gap_in_front) const
    {
      return !(gap_in_front + rear_gap_at(node) > 0.);
    }

    bool
    has_mass() const
    {
      return order == NodeOrder::inertial;
    }

    /** The contact nodes are in equilibrium with the obstacle at all times. */
    bool
    is_in_equilibrium() const
    {
      return law->is_active() && order == NodeOrder::quasi_static;
    }

    /** A node that meets the obstacle is stopped at once. */
    bool
    stops_nodes() const
    {
      return has_rigid() && !is_in_equilibrium();
    }

    /** That takes an impulse. */
    bool
    has_impacts() const
    {
      return has_rigid() && has_mass();
    }
  };



  /**
   * A rigid mass that is the obstacle of a body in several dimensions,
   * (M10.10); per area of the contact end, as a pressure.
   */
  struct ObstacleMass
  {
    double mass;
    double spring, dashpot; ///< that hold it from behind
    double velocity;        ///< at the start

    /** $C$ per area, and the temperature at the start; none: the scene has no
     * temperature. */
    std::optional<double> heat_capacity;
    double                temperature;

    /** The same whatever its start. */
    ObstacleMass
    without_start() const
    {
      return {mass, spring, dashpot, 0., heat_capacity, 0.};
    }
  };

  inline bool
  operator==(const ObstacleMass &one, const ObstacleMass &other)
  {
    return one.mass == other.mass && one.spring == other.spring &&
           one.dashpot == other.dashpot && one.velocity == other.velocity &&
           one.heat_capacity == other.heat_capacity &&
           one.temperature == other.temperature;
  }



  /** How the linear systems of stages are solved. */
  struct LinearSolver
  {
    bool is_iterative;

    /** Direct, by blocks along the rod, where one process has all of it. */
    bool is_along_rod;

    double tolerance; ///< relative residual; of the iterative one

    std::string reason; ///< of the choice

    /** The part of the scene that needs sparse factors; empty: none does. */
    std::string needs_factors;

    std::string
    name() const
    {
      return is_iterative ? "iterative" : "direct";
    }
  };



  /** Which sources act on a field of the scene. */
  struct SceneSources
  {
    bool has_heat_source;
    bool has_body_force;
    bool has_end_traction;
    bool has_end_heat_flux;
    bool has_left_traction;
    bool has_left_heat_flux;
    bool has_varying_obstacle;   ///< its temperature; of a constant exchange
    bool has_driven_exchange;    ///< that is none, or its obstacle, in time
    bool has_driven_temperature; ///< of the fixed end
    bool has_moving_end;         ///< the fixed end
    bool has_moving_obstacle;
    bool has_nonlinear_terms; ///< of coefficients of the temperature,
                              ///< (M10.8)

    bool
    any() const
    {
      return has_heat_source || has_body_force || has_end_traction ||
             has_end_heat_flux || has_left_traction || has_left_heat_flux ||
             has_varying_obstacle || has_driven_exchange || drives_end() ||
             has_moving_obstacle || has_nonlinear_terms;
    }

    /** The fixed end is heated or moved as a function of time. */
    bool
    drives_end() const
    {
      return has_driven_temperature || has_moving_end;
    }
  };



  /**
   * All parts of a run, resolved once from the entries: every question such as
   * whether the obstacle is rigid or the body static is answered here, and
   * absent parts are not asked for again.
   */
  struct Scene
  {
    /**
     * @param parameters may be ones that check_scene() refuses
     * @throw InputError if the heat exchange, the gap, the temperature of the
     *   obstacle or a drive of the fixed end is no valid expression
     */
    explicit Scene(const Parameters &parameters);

    Scene(const Scene &) = delete; // whose parameters are its own

    const SchemeChoice scheme_choice; ///< of entries that are automatic

    /** For files and words: as written, but for those. */
    const Parameters &parameters = scheme_choice.parameters;

    const SceneFields fields;
    const BodyRow     row; ///< of bodies, or empty

    /** The material of a body in several dimensions, if it is given. */
    const std::optional<BodyProfile> profile;

    /** The obstacle, if it moves by itself; with a displacement. */
    const std::optional<ObstacleMass> obstacle_mass;

    const std::unique_ptr<const BodyGeometry> geometry;
    const Material                            material;

    /** $g$ of the coordinates and t, if it is no number; else null. */
    const std::unique_ptr<const Expression> gap_expression;

    const SceneHeat heat;

    /** $u_A(t)$ of a fixed end that moves; else null. */
    const std::unique_ptr<const TimeFunction> fixed_end_motion;

    const SceneSources sources;
    const Scheme      &scheme;

    /** The first step has the prescribed velocity of the paper, (D5.1). */
    const bool has_prescribed_start;

    const SceneContact contact;

    /** Lateral faces have no normal displacement; dim > 1. */
    const bool has_rollers;

    /** Those at y = 0 and z = 0 have none: planes of symmetry; dim > 1. */
    const bool has_symmetry;

    /** The fixed end may move across the axis; dim > 1. */
    const bool has_sliding_end;

    /** The end $x=0$ is free. */
    const bool has_free_end;

    const bool has_lumped_mass;

    /** The mass matrix of Scheme::has_no_dispersion. */
    const bool has_midpoint_mass;

    /** Stages are solved by the iteration of the paper. */
    const bool is_fixed_point;

    const LinearSolver linear_solver;

    /**
     * Nothing holds the body across its axis and no inertia resists, so that
     * corners of the fixed end do, which needs no force.
     */
    bool
    has_pins() const
    {
      return parameters.dimension > 1 && fields.has_displacement &&
             has_sliding_end && !has_rollers && !has_symmetry &&
             !geometry->has_axis_at_side() && !material.has_inertia();
    }

    /** Section Bodies is given: coefficients are factors of (M10.1). */
    bool
    has_bodies() const
    {
      return row.is_given() || profile;
    }

    /** A contact has a law of this kind. */
    bool
    has_law_of(const ContactLawKind &kind) const
    {
      return (parameters.uses_general_law() &&
              parameters.contact.condition == kind.name) ||
             std::any_of(row.contacts.begin(),
                         row.contacts.end(),
                         [&](const RowContact &contact) {
                           return contact.law && contact.law->kind == kind.name;
                         });
    }

    /** Of both fields, held ones among them. */
    double
    n_unknowns() const
    {
      const unsigned int dim = parameters.dimension;
      return parameters.mesh.n_nodes(dim) * fields.n_components(dim);
    }

    /**
     * True if anything does work: sources, heat that drives the body, an
     * obstacle of its own temperature whose heat exchange varies, or what is
     * around a row of bodies, whose profile is not that of its rest.
     */
    bool
    has_work() const
    {
      return sources.any() || material.is_driven_by_heat() ||
             (has_bodies() && fields.has_temperature) ||
             (!heat.exchange->is_in_matrices() &&
              heat.temperature_range() > 0.);
    }

    /**
     * The viscosity leaves out the contact nodes, whose forces are elastic and
     * thermal alone, (C6.1).
     */
    bool
    has_elastic_contact_nodes() const
    {
      return contact.has_massless_nodes && !scheme.has_viscous_contact &&
             material.has_viscosity();
    }
  };



  /** The fields that a scene has. */
  std::vector<std::string>
  scene_fields(const Scene &scene);

  /** The terms that a scene contains, in words. */
  std::vector<std::string>
  scene_terms(const Scene &scene);
} // namespace ThermoContact

#endif
