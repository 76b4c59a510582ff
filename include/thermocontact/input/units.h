// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef thermocontact_input_units_h
#define thermocontact_input_units_h

#include <thermocontact/input/parameter_text.h>

#include <deal.II/base/parameter_handler.h>

#include <iosfwd>
#include <optional>
#include <string>
#include <vector>

namespace ThermoContact
{
  /**
   * A rod in SI units, with temperatures in kelvin: the entries of the files
   * that --units reads. The values here are an example, a rod of steel.
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

    double reference_temperature = 293.15; ///< K, of the rod without stress
    double initial_temperature   = 293.15; ///< K
    double fixed_end_temperature = 393.15; ///< K
    double obstacle_temperature  = 293.15; ///< K

    double                gap = 5e-4;                  ///< m
    std::optional<double> stiffness;                   ///< N/m; none: rigid
    double                exchange_coefficient = 100.; ///< W/(m^2 K)

    double end_time = 129600.; ///< s

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

  private:
    void
    add_rod(dealii::ParameterHandler &prm);

    void
    add_temperatures(dealii::ParameterHandler &prm);

    void
    add_obstacle(dealii::ParameterHandler &prm);
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



  /** The coefficients of the model, doc/units.md (U.4). */
  struct ScaledRod
  {
    double coupling;              ///< $a$
    double inertia;               ///< $b$
    double viscosity;             ///< $\zeta$
    double heat_exchange;         ///< $k$
    double compliance;            ///< $\varepsilon$; 0: rigid
    double gap;                   ///< $g$
    double fixed_end_temperature; ///< $\theta_A$
    double obstacle_temperature;  ///< $\theta_{obs}$
    double initial_temperature;   ///< $\theta_0$
    double end_time;              ///< $T$

    explicit ScaledRod(const RodInUnits &rod);
  };



  /**
   * The answer of --units to the statements of a file: a parameter file of the
   * scene, whose comments hold the scales and the factors that turn the columns
   * of contact.csv into SI units.
   *
   * @param file_name what messages call the file
   * @throw InputError if an entry is not given or wrong
   */
  std::string
  scene_from_units(const std::string             &file_name,
                   const std::vector<Assignment> &assignments);
} // namespace ThermoContact

#endif
