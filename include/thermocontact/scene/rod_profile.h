// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef thermocontact_scene_rod_profile_h
#define thermocontact_scene_rod_profile_h

#include <thermocontact/input/expression.h>
#include <thermocontact/input/parameters.h>
#include <thermocontact/input/quantity_units.h>
#include <thermocontact/scene/material_coefficients.h>

#include <string>
#include <vector>

namespace ThermoContact
{
  /**
   * The coefficients of a rod of a row along its length, (M10.1): numbers, or
   * expressions of $x$, which is 0 at the left end of the rod and its length at
   * the right one, nondimensional, and of the temperature. Where they jump at
   * $\theta=0$ the mesh has nodes, and where they have kinks if its cells are
   * not linear: the rod has parts in which they are smooth.
   */
  class RodProfile
  {
  public:
    /**
     * @param parameters whose degree decides whether kinks end parts
     * @throw InputError if an expression cannot be read, changes too fast to be
     *   searched for jumps, or has values that are not allowed
     */
    RodProfile(const Parameters &parameters, const BodyParameters &rod);

    /** False: all of them are numbers. */
    bool
    varies() const;

    /** The coefficients that depend on the temperature; of this object. */
    std::vector<const Expression *>
    of_temperature() const
    {
      return all.of_temperature();
    }

    /**
     * At a place and a temperature; at a jump it is the expression's choice.
     *
     * @throw InputError if a value is not allowed
     */
    EquationFactors
    at(const double x, const double theta = 0.) const;

    /** at(), with the derivatives in the temperature of the branch that holds;
     * throws likewise. */
    EquationTangents
    tangents(const double x, const double theta) const;

    /** Right inside one of the ends. */
    EquationFactors
    at_end(const bool is_left) const;

    /** Parts between jumps and kinks, at least one. */
    unsigned int
    n_parts() const
    {
      return ends.size() - 1;
    }

    /**
     * Doubts about tables, and about coefficients that vary within a cell, for
     * the user to look at.
     *
     * @param cells sizes of the cells of the rod, of degree @p degree
     */
    std::vector<std::string>
    doubts(const std::vector<double> &cells,
           const unsigned int         degree,
           const QuantityUnits       &units) const;

    /**
     * The constants of a linear cell, (M10.7): means, of stiffness and
     * conductivity over the parts in series.
     */
    EquationFactors
    of_cell(const double begin, const double end) const;

    /** The time $\int\sqrt{b\rho/E}\,dx$ in which a wave passes each part. */
    std::vector<double>
    passages() const;

    /** The numbers of cells of the parts, of all together @p wanted or else one
     * for each, such that waves pass cells in like times. */
    std::vector<unsigned int>
    cells_of_parts(const unsigned int wanted) const;

    /** The sizes of the cells, which waves pass in the same time within a
     * part. */
    std::vector<double>
    cell_sizes(const unsigned int n_cells) const;

    /** Whether it is made of the same expressions. */
    bool
    operator==(const RodProfile &other) const;

  private:
    double               length;
    double               inertia; ///< $b$
    MaterialCoefficients all;     ///< of theta and, where loads have t, of x
    std::vector<double>  ends;    ///< of the parts, with 0

    /** Where a coefficient is a parabola over the shortest length. */
    struct Narrowest
    {
      std::string entry;
      std::string cells; ///< the entry of their number
      LoadStretch stretch;
    };

    std::vector<Narrowest> narrowest; ///< cells of degree 1 have means

    double
    value(const MaterialCoefficients::Name name, const double x) const;

    /** $\sqrt{b\rho/E}$ */
    double
    slowness(const double x) const;

    /** A piece of a part in which the slowness is resolved. */
    struct Piece
    {
      double end;
      double time; ///< up to there, from the begin of the part
    };

    std::vector<Piece>
    pieces(const double begin, const double end) const;

    /** Where a wave from @p begin is at a time. */
    double
    place_of(const double              time,
             const double              begin,
             const std::vector<Piece> &all) const;

    /** Whether the slowness is the same everywhere. */
    bool
    has_one_speed() const;

    /** Adds jumps of a coefficient, or kinks, too, to the ends of parts. */
    void
    find_breaks(const Expression  &coefficient,
                const bool         takes_kinks,
                const std::string &body);

    /** Keeps where a coefficient changes over the shortest length. */
    void
    note_narrowest(const Expression  &coefficient,
                   const LoadHistory &along,
                   const std::string &body);
  };
} // namespace ThermoContact

#endif
