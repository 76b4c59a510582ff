// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef thermocontact_input_units_h
#define thermocontact_input_units_h

#include <thermocontact/input/parameter_text.h>

#include <deal.II/base/parameter_handler.h>

#include <optional>
#include <string>
#include <vector>

namespace ThermoContact
{
  /** A load that is constant for some time from t = 0 on, and 0 afterwards. */
  struct LoadInUnits
  {
    double value = 0.;

    /** As given, in the unit of times; none: as long as the run. */
    std::optional<double> duration;
  };



  /**
   * A rod in SI units: the entries of the files that --units reads. The values
   * here are an example, a rod of steel. Temperatures and times are as given,
   * in the units that the file names.
   */
  struct RodInUnits
  {
    std::string title;
    std::string small_terms = "dropped";

    double      length           = 1.;     ///< m
    double      area             = 1e-4;   ///< m^2
    double      density          = 7850.;  ///< kg/m^3
    double      youngs_modulus   = 2.1e11; ///< Pa
    double      poisson_ratio    = 0.3;    ///< 1
    std::string lateral_sides    = "free"; ///< or confined
    double      viscosity        = 5e3;    ///< Pa s
    double      linear_expansion = 1.2e-5; ///< 1/K
    double      conductivity     = 53.3;   ///< W/(m K)
    double      heat_capacity    = 440.;   ///< J/(kg K)

    std::string temperature_unit      = "automatic";
    double      reference_temperature = 293.15; ///< of the rod without stress
    double      initial_temperature   = 293.15;
    double      fixed_end_temperature = 393.15;   ///< a number,
    std::string fixed_end_expression;             ///< or else in t
    double      obstacle_temperature = 293.15;    ///< a number,
    std::string obstacle_expression;              ///< or else in t
    double      surrounding_temperature = 293.15; ///< if the sides lose heat

    double                gap = 5e-4;                  ///< m, a number,
    std::string           gap_expression;              ///< or else in t
    std::optional<double> rear_gap;                    ///< m; none: one stop
    std::optional<double> stiffness;                   ///< N/m^m; none: rigid
    double                exponent             = 1.;   ///< m
    double                damping              = 0.;   ///< s/m
    double                exchange_coefficient = 100.; ///< W/(m^2 K)

    double side_coefficient = 0.;   ///< W/(m^2 K), of the lateral sides
    double perimeter        = 0.04; ///< m; if they lose heat

    std::string base_motion      = "0"; ///< m, in t
    double      initial_velocity = 0.;  ///< m/s, of the contact end
    LoadInUnits body_force;             ///< N/m^3
    LoadInUnits heater;                 ///< W

    std::string time_unit = "automatic";
    double      end_time  = 129600.;

    /** Binds every member to an entry of @p prm. */
    void
    add_parameters(dealii::ParameterHandler &prm);

    /**
     * Stiffness $E^*$ of the material against axial strain: Young's modulus
     * if the lateral sides are free, the P-wave modulus
     * $E(1-\nu)/((1+\nu)(1-2\nu))$ if they cannot move.
     */
    double
    modulus() const;

    /**
     * Axial expansion $\alpha^*$ by temperature without axial stress:
     * $\alpha$, or $\alpha(1+\nu)/(1-\nu)$ if the lateral sides cannot move.
     */
    double
    expansion() const;

    /** A temperature of the file in kelvin; automatic is kelvin. */
    double
    in_kelvin(const double temperature) const;

    /** A time of the file in seconds; automatic is seconds. */
    double
    in_seconds(const double time) const;

    /** The fixed end moves. */
    bool
    has_moving_base() const;

    /** The obstacle moves. */
    bool
    has_moving_obstacle() const;

    /**
     * @throw InputError for temperatures that are no numbers above 0 K, or
     *   that may be degrees Celsius, as the file does not say that they are
     *   kelvin; for an obstacle without stiffness, or a rigid one with a law;
     *   for a rear stop without a gap; for a perimeter that no cross-section
     *   of that area has, or hardly any; for expressions that are none, a gap
     *   that is not finite, or a base that starts elsewhere
     */
    void
    check() const;

  private:
    /** The temperature of one entry; in expressions at many times. */
    void
    check_temperature(const std::string &name,
                      const double       value,
                      const std::string &expression) const;

    void
    check_obstacle() const;

    void
    check_gap() const;

    void
    check_sides() const;

    void
    check_base_motion() const;

    void
    add_rod(dealii::ParameterHandler &prm);

    void
    add_temperatures(dealii::ParameterHandler &prm);

    void
    add_obstacle(dealii::ParameterHandler &prm);

    void
    add_sides(dealii::ParameterHandler &prm);

    void
    add_loads(dealii::ParameterHandler &prm);
  };



  /** What one nondimensional unit is, doc/units.md (U.3). */
  struct UnitScales
  {
    double length;      ///< m; of displacements too
    double time;        ///< s, heat through the length of the rod
    double temperature; ///< K, above the reference temperature
    double stress;      ///< Pa
    double force;       ///< N
    double velocity;    ///< m/s
    double heat_flux;   ///< W/m^2
    double energy;      ///< J

    explicit UnitScales(const RodInUnits &rod);
  };



  /** The coefficients of the model, doc/units.md (U.4), (U.5), (U.6). */
  struct ScaledRod
  {
    double coupling;              ///< $a$
    double inertia;               ///< $b$
    double viscosity;             ///< $\zeta$
    double heat_exchange;         ///< $k$
    double compliance;            ///< $\varepsilon$; 0: rigid
    double damping;               ///< $c$
    double lateral_exchange;      ///< $m$ of the sides
    double ambient_temperature;   ///< $\theta_\infty$
    double gap;                   ///< $g$, if it is a number
    double rear_gap;              ///< $g_2$, if there is a rear stop
    double fixed_end_temperature; ///< $\theta_A$
    double obstacle_temperature;  ///< $\theta_{obs}$
    double initial_temperature;   ///< $\theta_0$
    double initial_velocity;      ///< $u_1(1)$
    double body_force;            ///< $f$
    double heat_source;           ///< $q$
    double end_time;              ///< $T$

    /** Of the loads; infinite if they last as long as the run. */
    double force_duration, heat_duration;

    explicit ScaledRod(const RodInUnits &rod);
  };



  /**
   * True for the statements of a file that --units reads: the file, not the
   * command line, has a section Rod.
   */
  bool
  is_rod_in_units(const std::vector<Assignment> &assignments);

  /** The scene of a rod in units. */
  struct UnitScene
  {
    /**
     * A parameter file, whose comments hold the scales and the factors that
     * turn nondimensional columns of contact.csv into SI units.
     */
    std::string text;

    std::vector<Assignment> assignments; ///< its statements
  };



  /**
   * The answer of --units to the statements of a file. Those of a scene among
   * them stand in it as they are.
   *
   * @param file_name what messages call the file
   * @throw InputError if an entry is not given or wrong, or one of a scene is
   *   what the rod decides
   */
  UnitScene
  scene_from_units(const std::string             &file_name,
                   const std::vector<Assignment> &assignments);
} // namespace ThermoContact

#endif
