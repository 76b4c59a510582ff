// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef thermocontact_scene_material_coefficients_h
#define thermocontact_scene_material_coefficients_h

#include <thermocontact/base/special_numbers.h>
#include <thermocontact/input/expression.h>
#include <thermocontact/input/parameters.h>
#include <thermocontact/input/time_function.h>
#include <thermocontact/method/load_history.h>

#include <array>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace ThermoContact
{
  /** Lame coefficients of unit P-wave modulus, (M1.6). */
  struct Elasticity
  {
    double lambda, two_mu;
  };

  /** @param nu Poisson ratio */
  inline Elasticity
  elasticity_of(const double nu)
  {
    return {nu / (1. - nu), (1. - 2. * nu) / (1. - nu)};
  }

  /** Factors of the terms of the equations in a body of section Bodies,
   * (M10.1), (M10.9), each times the section A of a rod, 1 for dim > 1:
   * stiffness $AE$ and viscosity $AE\zeta$ over P-wave moduli. The Poisson
   * ratio is of profiles alone. */
  struct EquationFactors
  {
    double section = 0., heat_mass = 0., conduction = 0., coupling = 0.,
           inertia = 0., stiffness = 0., viscosity = 0., poisson_ratio = 0.;

    EquationFactors &
    operator-=(const EquationFactors &other);
  };

  bool
  operator==(const EquationFactors &one, const EquationFactors &other);

  /** Coefficients with their derivatives in the temperature. */
  struct EquationTangents
  {
    EquationFactors value, slope;
  };



  /**
   * Jumps and kinks of a coefficient along a line through the body, whose
   * coordinate stands in place of the time, and where it varies fast.
   *
   * @param length of the line, from 0
   * @param coordinate for messages, "y at "
   * @throw InputError if it is not finite or changes too fast to be searched
   */
  LoadHistory
  history_along(const TimeFunction &coefficient,
                const double        length,
                const std::string  &coordinate = "");



  /** The coefficients of a body, numbers or expressions of its places. */
  class MaterialCoefficients
  {
  public:
    enum Name
    {
      section,
      stiffness,
      density,
      viscosity,
      coupling,
      conductivity,
      heat_capacity,
      poisson_ratio,
      n_names
    };

    /** All coefficients at a place, in the order of their names. */
    using Values = std::array<double, n_names>;

    /** Of the variables of an expression. */
    template <typename Number>
    using Variables = std::array<Number, 4>;

    /**
     * @param variables names that expressions of coefficients may have; "" for
     *   a variable without a name
     * @throw InputError if an expression cannot be read
     */
    MaterialCoefficients(const Parameters                 &parameters,
                         const BodyParameters             &body,
                         const std::array<std::string, 4> &variables);

    /** False: all of them are numbers. */
    bool
    vary() const;

    /** Those that are. */
    std::vector<const Expression *>
    expressions() const;

    /** Entries of those that are given, and not as 1, with their values. */
    std::vector<std::pair<std::string, std::string>>
    own_entries() const;

    bool
    is_number(const Name name) const
    {
      return !all[name].expression;
    }

    /** @throw InputError if the value is not allowed */
    template <typename Number>
    Number
    at(const Name name, const Variables<Number> &variables) const;

    /**
     * The members of EquationFactors in their order; throws likewise.
     *
     * @param known of coefficients that do not depend on theta; null: none
     */
    template <typename Number>
    std::array<Number, 8>
    terms(const Variables<Number> &variables,
          const Values            *known = nullptr) const;

    /** terms() of numbers. */
    EquationFactors
    in_equations(const Variables<double> &variables) const;

    /** @throw InputError if a value is not allowed */
    Values
    values(const Variables<double> &variables) const;

    /** in_equations() with the derivatives in theta of the branch that holds.
     *
     * @param known values() there at any theta; null: none are known */
    EquationTangents
    tangents(const Variables<double> &variables,
             const Values            *known = nullptr) const;

    /** The coefficients that depend on the temperature. */
    std::vector<const Expression *>
    of_temperature() const;

    /** Whether they are the same entries. */
    bool
    operator==(const MaterialCoefficients &other) const;

  private:
    struct Coefficient
    {
      std::string               entry;
      double                    number = 1.;
      std::optional<Expression> expression;
      double                    lower = 0., upper = infinity;
      bool                      may_equal_lower = false;
      std::string               allowed         = "positive numbers";
      bool                      is_of_theta     = false;
      bool                      is_given        = false;
    };

    std::array<std::string, 4>       variable_names;
    double                           length; ///< of the body
    double                           width;
    bool                             is_rod;
    std::array<Coefficient, n_names> all;

    /** The place that variables are, for messages: " at 30 % of the rod". */
    template <typename Number>
    std::string
    place_in_words(const Coefficient       &one,
                   const Variables<Number> &variables) const;
  };
} // namespace ThermoContact

#endif
