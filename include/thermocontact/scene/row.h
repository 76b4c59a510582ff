// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef thermocontact_scene_row_h
#define thermocontact_scene_row_h

#include <thermocontact/input/parameters.h>
#include <thermocontact/scene/rod_profile.h>

#include <optional>
#include <string>
#include <vector>

namespace ThermoContact
{
  /**
   * A cell of the mesh of a row: of a rod, whose coefficients are factors of
   * those of the scene, (M10.1); or the gap between two bodies, which has none.
   */
  struct RowCell
  {
    double size   = 0.;
    bool   is_gap = false;

    unsigned int    body   = 0;     ///< of a rod
    double          begin  = 0.;    ///< in the rod
    bool            varies = false; ///< the coefficients do within the cell
    EquationFactors whole;          ///< of the cell; none if it varies
  };



  /** A rigid mass: one vertex of the mesh, between gaps. */
  struct RowMass
  {
    unsigned int vertex; ///< from the left
    double       mass;
    double       heat_capacity; ///< $C$
  };



  /** The contact law of two bodies, if it is not that of section Contact. */
  struct RowLaw
  {
    std::string          kind; ///< its name
    ContactLawParameters numbers;
  };

  inline bool
  operator==(const RowLaw &one, const RowLaw &other)
  {
    return one.kind == other.kind && one.numbers == other.numbers;
  }



  /** Two bodies that can meet, across a cell of the mesh. */
  struct RowContact
  {
    std::string  name; ///< "LEFT RIGHT"
    unsigned int cell;
    double       gap; ///< $g$ of the undeformed bodies

    std::optional<double> exchange; ///< $k$ of its own

    std::optional<RowLaw> law; ///< of its own
  };



  /** One of the bodies, from the left. */
  struct RowBody
  {
    std::string  name;
    double       begin, end; ///< $x$ of its ends
    unsigned int first_cell; ///< of a rod
    unsigned int n_cells;    ///< 0: a mass

    std::optional<RodProfile> profile; ///< of coefficients that vary

    std::string temperature, displacement, velocity; ///< in $x-x_{begin}$
  };



  /**
   * Rods and masses along x as one mesh: bodies are parts of it, and the gaps
   * between them cells without any coefficient, across which contact acts. All
   * equations, states and sums are then those of one body. Empty: the scene
   * has one body, not in a row.
   */
  struct BodyRow
  {
    std::vector<RowBody>    bodies;
    std::vector<RowCell>    cells;
    std::vector<RowMass>    masses;
    std::vector<RowContact> contacts;

    /** The last body may meet the obstacle of section Contact. */
    bool meets_obstacle = false;

    bool
    is_given() const
    {
      return !cells.empty();
    }

    double
    length() const
    {
      return is_given() ? bodies.back().end : 1.;
    }

    /** Coefficients of the equations in a cell, @p x in the row; of a cell with
     * means heat and conduction are those at $\theta=0$. */
    EquationFactors
    in_equations(const unsigned int cell,
                 const double       x,
                 const double       theta = 0.) const;

    /** Coefficients of the rod there, (M10.7), (M10.8).
     *
     * @throw InputError if a value is not allowed */
    EquationFactors
    of_rod(const unsigned int cell,
           const double       x,
           const double       theta = 0.) const;

    /**
     * What the equations of a cell have beyond the coefficients at
     * $\theta=0$, (M10.8): the difference at a place, where the cell has means
     * of stiffnesses in series as a part of these.
     */
    EquationTangents
    beyond_zero(const unsigned int      cell,
                const EquationTangents &at_theta,
                const EquationFactors  &at_zero) const;

    /** The coefficients of a rod depend on its temperature. */
    bool
    depends_on_temperature() const;

    /** A rod has coefficients that vary. */
    bool
    has_varying_rods() const;

    /** "LEFT-RIGHT" of each contact, in their order; "LEFT-obstacle". */
    std::vector<std::string>
    contact_names() const;

    /** The place in a rod that is nearest to the middle; none: there are masses
     * alone. */
    std::optional<double>
    middle() const;

    /** The first body is a mass, behind a vertex that means nothing. */
    bool
    begins_with_mass() const
    {
      return is_given() && bodies.front().n_cells == 0;
    }

    /** Contacts of bodies, and the one with the obstacle. */
    unsigned int
    n_contacts() const
    {
      return contacts.size() + (meets_obstacle ? 1 : 0);
    }

    /** $x$ where the last rod with all that are bonded to it begins, less half
     * the gap before it. */
    double
    begin_of_last_part() const;

    /** The body that has this place, the first of two that touch. */
    const RowBody &
    body_at(const double x) const;
  };



  bool
  operator==(const BodyRow &one, const BodyRow &other);

  /**
   * @param parameters whose bodies have numbers of cells
   * @throw InputError if a pair is not of neighbours, bonded to a mass, or has
   *   no gap
   */
  BodyRow
  resolve_row(const Parameters &parameters);

  /** The times in which a wave passes a cell of each part of a rod of a row. */
  std::vector<double>
  passages_of_cells(const Parameters &parameters, const BodyParameters &rod);

  /**
   * True if the motion of a row has waves, velocities that jump, or impacts
   * that go through bodies which stand side by side: not of masses alone that
   * are apart and whose contacts give way.
   */
  bool
  has_waves_or_impacts(const Parameters &parameters);

  /** A contact with a mass, and the time that its force takes. */
  struct MassContact
  {
    std::string name;
    double      time; ///< $\sqrt{m\varepsilon}$, or $m/Z$ on a rigid rod
  };

  /**
   * The contacts of a row with masses. Of a law that is not linear
   * $\varepsilon$ is its tangent under the energy that the mass has at the
   * start; rigid masses that meet have none, (M10.6).
   */
  std::vector<MassContact>
  mass_contacts(const Parameters &parameters);

  /**
   * The time in which waves pass the cells of all rods, or the mean of these
   * times where they differ; of masses alone a thousandth of the run, or a
   * fiftieth of the time of a contact.
   */
  double
  passage_of_row_cell(const Parameters &parameters);

  /**
   * Gives the rods of a row cells, where these are automatic: of all together
   * about @p n_cells, by length or, if @p by_passage, such that a wave passes
   * each cell in the same time, as nearly as whole numbers allow.
   */
  void
  choose_row_cells(const double n_cells,
                   const bool   by_passage,
                   Parameters  &parameters);
} // namespace ThermoContact

#endif
