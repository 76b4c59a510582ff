// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef thermocontact_scene_body_profile_h
#define thermocontact_scene_body_profile_h

#include <thermocontact/input/parameters.h>
#include <thermocontact/scene/material_coefficients.h>

#include <array>
#include <string>
#include <vector>

namespace ThermoContact
{
  /**
   * The coefficients of a body in two or three dimensions, (M10.9): numbers, or
   * expressions of its places and temperature. Where they jump across a plane
   * at right angles to an axis the mesh has nodes, and where they have kinks
   * there if its cells are not linear; planes are found along a few lines
   * through the body.
   */
  class BodyProfile
  {
  public:
    /**
     * @param parameters of a scene with such a body; their degree decides
     *   whether kinks count, their width where the body is
     * @throw InputError if an expression cannot be read, changes too fast to be
     *   searched for jumps, or has values that are not allowed
     */
    explicit BodyProfile(const Parameters &parameters);

    /** False: all coefficients are numbers. */
    bool
    varies() const
    {
      return all.vary();
    }

    bool
    depends_on_temperature() const
    {
      return !all.of_temperature().empty();
    }

    const MaterialCoefficients &
    coefficients() const
    {
      return all;
    }

    /**
     * At a place, x, y and z, and a temperature; at a jump it is the
     * expression's choice.
     *
     * @throw InputError if a value is not allowed
     */
    EquationFactors
    at(const std::array<double, 3> &place, const double theta = 0.) const
    {
      return all.in_equations(variables(place, theta));
    }

    /** MaterialCoefficients::values() at theta = 0; throws likewise. */
    MaterialCoefficients::Values
    values(const std::array<double, 3> &place) const
    {
      return all.values(variables(place, 0.));
    }

    /** MaterialCoefficients::tangents() there; throws likewise. */
    EquationTangents
    tangents(const std::array<double, 3>              &place,
             const double                              theta,
             const MaterialCoefficients::Values *const known = nullptr) const
    {
      return all.tangents(variables(place, theta), known);
    }

    /** Where cells end, sorted: x, then y and z as one list; nondimensional. */
    const std::array<std::vector<double>, 2> &
    planes() const
    {
      return planes_;
    }

    /** Doubts about jumps that no mesh of boxes follows. */
    const std::vector<std::string> &
    doubts() const
    {
      return doubts_;
    }

    /** Whether it is made of the same numbers and expressions. */
    bool
    operator==(const BodyProfile &other) const
    {
      return all == other.all;
    }

  private:
    MaterialCoefficients               all; ///< of y, z and, for t, x
    std::array<std::vector<double>, 2> planes_;
    std::vector<std::string>           doubts_;

    static MaterialCoefficients::Variables<double>
    variables(const std::array<double, 3> &place, const double theta)
    {
      return {{place[1], place[2], theta, place[0]}};
    }

    /** Adds the planes of a coefficient across a direction. */
    void
    find_planes(const Parameters  &parameters,
                const Expression  &coefficient,
                const unsigned int direction);
  };
} // namespace ThermoContact

#endif
