// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef thermocontact_simulation_measurements_h
#define thermocontact_simulation_measurements_h

#include <thermocontact/contact/event_locator.h>
#include <thermocontact/space/body.h>
#include <thermocontact/space/point_values.h>
#include <thermocontact/space/state.h>

#include <memory>
#include <type_traits>
#include <vector>

namespace ThermoContact
{
  /** One contact of a row of bodies: a row of contacts/LEFT-RIGHT.csv. */
  struct ContactRecord
  {
    double time            = 0.;
    double gap             = 0.; ///< $g-u_{left}+u_{right}$
    double velocity        = 0.; ///< into the contact, relative
    double contact_force   = 0.;
    double contact_impulse = 0.;
    double heat_flux       = 0.; ///< to the right
    bool   in_contact      = false;

    template <class Archive>
    void
    serialize(Archive &archive, const unsigned int)
    {
      archive &time &gap &velocity &contact_force &contact_impulse &heat_flux
        &in_contact;
    }
  };



  /**
   * One row of contact.csv. Extensive quantities are per unit cross-section;
   * values at the contact end are means over it. Values of a field that the
   * scene does not have are NaN.
   */
  struct StepRecord
  {
    unsigned int step                  = 0;
    double       time                  = 0.;
    double       step_size             = 0.;
    double       displacement_end      = 0.; ///< $u(1)$, axial
    double       displacement_mid      = 0.; ///< $u(1/2)$, on the axis
    double       velocity_end          = 0.; ///< $u_t(1)$ of the scheme
    double       stress_end            = 0.; ///< $-p+t$
    double       gap                   = 0.; ///< $g-u$, the smallest
    double       penetration           = 0.; ///< $s(p)$, the largest
    double       contact_force         = 0.; ///< mean of p; negative behind
    double       contact_impulse       = 0.; ///< $\sum\Delta t\,p$
    double       temperature_end       = 0.;
    double       heat_flux_end         = 0.; ///< $k(\theta-\theta_{obs})$
    double       energy                = 0.; ///< $\hat E$, (M2.2)
    double       dissipation           = 0.; ///< sum of (D4.2)
    double       numerical_dissipation = 0.; ///< sum of $N$, (D4.3) or (D3.2)
    bool         in_contact            = false;
    unsigned int iterations            = 0;
    double       work                  = 0.; ///< sum of (D4.4)
    double       temperature_mean      = 0.;
    double       algebraic             = 0.; ///< sum of (D8.5)
    double       contact_dissipation   = 0.; ///< sum of (D4.7)
    double       lateral_heat_flux     = 0.; ///< to the surroundings
    double       lateral_dissipation   = 0.; ///< sum of (D4.5)
    double       contact_area          = 0.; ///< part of the face with $p>0$
    double       max_pressure          = 0.;
    double       min_gap               = 0.; ///< $g-u$

    /** Means of $p$ times $y$, $z$ from the axis; 0 where the axis is a side.
     */
    double moment_y = 0.;
    double moment_z = 0.;

    double obstacle_displacement = 0.; ///< of one that has a mass
    double obstacle_velocity     = 0.;
    double obstacle_temperature  = 0.;

    EnergyTerms energy_terms; ///< the terms of energy; not in the file

    std::vector<ContactRecord> contacts;   ///< of a row of bodies; likewise
    BoundarySums               boundaries; ///< up to there; likewise

    /**
     * The columns of contact.csv in their order: calls @p column with the name
     * and the member of each, or a function of a record that gives its number,
     * and, if not all scenes have it, with one that says of a Scene whether it
     * does.
     */
    template <class Column>
    static void
    for_each_column(const Column &column)
    {
      using R = StepRecord;
      column("step", &R::step);
      column("time", &R::time);
      column("step_size", &R::step_size);
      column("displacement_end", &R::displacement_end);
      column("displacement_mid", &R::displacement_mid);
      column("velocity_end", &R::velocity_end);
      column("stress_end", &R::stress_end);
      column("gap", &R::gap);
      column("penetration", &R::penetration);
      column("contact_force", &R::contact_force);
      column("contact_impulse", &R::contact_impulse);
      column("temperature_end", &R::temperature_end);
      column("heat_flux_end", &R::heat_flux_end);
      column("energy", &R::energy);
      column("dissipation", &R::dissipation);
      column("numerical_dissipation", &R::numerical_dissipation);
      column("in_contact", &R::in_contact);
      column("iterations", &R::iterations);
      column("work", &R::work);
      column("temperature_mean", &R::temperature_mean);
      const auto has_face = [](const Scene &scene) {
        return scene.parameters.dimension > 1;
      };
      column("contact_area", &R::contact_area, has_face);
      column("max_pressure", &R::max_pressure, has_face);
      column("min_gap", &R::min_gap, has_face);
      column("moment_y", &R::moment_y, has_face);
      column("moment_z", &R::moment_z, has_face);
      column("algebraic", &R::algebraic, [](const Scene &scene) {
        return scene.linear_solver.is_iterative;
      });
      column("contact_dissipation",
             &R::contact_dissipation,
             [](const Scene &scene) {
               return scene.contact.is_damped() ||
                      scene.parameters.contact.restitution.has_value();
             });
      const auto has_lateral_exchange = [](const Scene &scene) {
        return scene.heat.has_lateral_exchange();
      };
      column("lateral_heat_flux", &R::lateral_heat_flux, has_lateral_exchange);
      column("lateral_dissipation",
             &R::lateral_dissipation,
             has_lateral_exchange);
      const auto has_obstacle_mass = [](const Scene &scene) {
        return scene.obstacle_mass.has_value();
      };
      column("obstacle_displacement",
             &R::obstacle_displacement,
             has_obstacle_mass);
      column("obstacle_velocity", &R::obstacle_velocity, has_obstacle_mass);
      column("obstacle_temperature",
             &R::obstacle_temperature,
             [](const Scene &scene) {
               return scene.obstacle_mass && scene.obstacle_mass->heat_capacity;
             });
    }

    template <class Archive>
    void
    serialize(Archive &archive, const unsigned int)
    {
      for_each_column([&](const char *, const auto value, const auto &...) {
        if constexpr (std::is_member_object_pointer<decltype(value)>::value)
          archive &(this->*value);
      });
      archive &energy_terms &contacts &boundaries;
    }
  };



  /**
   * Evaluates the quantities of a state that users follow over time.
   * Collective.
   */
  template <int dim>
  class Measurements
  {
  public:
    /** @param body borrowed; the time of its sources is set from here */
    explicit Measurements(Body<dim> &body);

    /**
     * Fills the members of @p record that are functions of @p state alone: the
     * end and mid values, gap, penetration, force, heat flux, mean temperature.
     */
    void
    measure(const State &state, StepRecord &record);

  private:
    Body<dim> &body;

    /**
     * In the middle of the body and, where nodes do not have the velocity, of
     * the last cell.
     */
    std::unique_ptr<PointValues<dim>> on_axis;

    std::unique_ptr<PointValues<dim>> at_right_end; ///< if it is clamped

    Vector               mean_weights;
    std::vector<double>  contact_values;
    std::vector<NodeLaw> contact_laws;
    ContactValues        row_values;

    void
    measure_displacement(const State &state, StepRecord &record);

    void
    measure_face(const State &state, StepRecord &record);

    /** The contacts of a row, and what the columns mean there, (M10.5). */
    void
    measure_row(const State &state, StepRecord &record);

    /** Mean traction on the contact end; 0 if there is none. */
    double
    mean_traction();

    void
    measure_temperature(const State &state, StepRecord &record);
  };
} // namespace ThermoContact

#endif
