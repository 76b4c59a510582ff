// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef thermocontact_space_point_values_h
#define thermocontact_space_point_values_h

#include <thermocontact/scene/scene.h>
#include <thermocontact/space/discretization.h>
#include <thermocontact/space/state.h>

#include <array>
#include <utility>
#include <vector>

namespace ThermoContact
{
  /** Where fields are evaluated. */
  template <int dim>
  struct Place
  {
    Point<dim> position;

    /**
     * The cells that contain this point are the ones to evaluate in, on the
     * boundary of which @p position may lie; @p position itself if nothing
     * chooses between the cells that meet there.
     */
    Point<dim> cell_point;
  };



  /**
   * Places along the axis of the body: degree + 1 in each cell, equidistant and
   * in order of x, the last one of a cell where the first one of the next is.
   * Collective; the same on all ranks.
   */
  template <int dim>
  std::vector<Place<dim>>
  places_on_axis(const Discretization<dim> &discretization);



  /**
   * Evaluates temperature, axial displacement and velocity, and the axial
   * stress
   * @f[
   *   \sigma_{xx} = 2\mu\,\partial_x w_x + \lambda\,\mathrm{div}\,w - a\theta,
   *   \qquad w = u + \zeta v,
   * @f]
   * at given places. The stress, which jumps between cells, is the mean of the
   * cells of a place. The cells and the values of the shape functions are found
   * once. Collective.
   */
  template <int dim>
  class PointValues
  {
  public:
    enum Quantity
    {
      temperature,
      displacement,
      velocity,
      stress,
      n_quantities
    };

    /** Of the quantities, in the order of the enumeration. */
    static constexpr std::array<const char *, n_quantities> names = {
      {"temperature", "displacement", "velocity", "stress"}};

    /**
     * The references are borrowed.
     *
     * @param places in the body; the same on all ranks
     */
    PointValues(const Scene                   &scene,
                const Discretization<dim>     &discretization,
                const std::vector<Place<dim>> &places);

    /**
     * @return on all ranks, valid until the next call: the values of the first
     *   quantity at all places, then those of the next. NaN for a field that
     * the scene does not have, and for the velocity at $t=0$ if $b=\zeta=0$.
     * @throw InputError on all ranks if a coefficient has a value at a place
     * that is not allowed
     */
    const std::vector<double> &
    evaluate(const State &state);

    /**
     * One value at each place, likewise: of the axial component of a
     * displacement or velocity alone.
     */
    const std::vector<double> &
    evaluate_axial(const Vector &vector);

  private:
    /** Linear form of the nodal values of a field. */
    enum Form
    {
      temperature_form,
      displacement_form,
      strain_form, ///< $2\mu\,\partial_x w_x+\lambda\,\mathrm{div}\,w$

      // of a row, whose bodies have coefficients of their own, (M10.1)
      viscous_form, ///< of $w=v$, times $\zeta$ over that of the scene
      thermal_form, ///< $\theta$, times $a$ over that of the scene
      n_forms
    };

    /** Entry of a form: a term of the value at one place. */
    struct Term
    {
      unsigned int place;
      unsigned int entry; ///< position in the local part of the vector
      double       weight;
    };

    /** A term before it is known which rank owns the degree of freedom. */
    struct Share
    {
      unsigned int            form;
      unsigned int            place;
      types::global_dof_index dof; ///< within its block
      double                  weight;

      template <class Archive>
      void
      serialize(Archive &archive, const unsigned int)
      {
        archive &form &place &dof &weight;
      }
    };

    using Cell = typename DoFHandler<dim>::active_cell_iterator;

    /** A basis function at a place. */
    struct BasisAt
    {
      double theta        = 0.;
      double displacement = 0.; ///< along x
      double stress       = 0.; ///< along x, as of strain_form
    };

    /** All of a cell there. */
    std::vector<BasisAt>
    basis_at(const Cell &cell, const Point<dim> &position) const;

    /** A cell of a place, in a scene that has coefficients of the temperature,
     * (M10.8). */
    struct NonlinearPlace
    {
      unsigned int        place;
      Cell                cell;
      Point<dim>          position;
      double              weight;        ///< 1 / number of its cells
      std::vector<double> value, stress; ///< of BasisAt
    };

    const Scene                           &scene;
    const Discretization<dim>             &discretization;
    const unsigned int                     n_places;
    std::vector<NonlinearPlace>            nonlinear_places;
    std::array<std::vector<Term>, n_forms> terms;
    std::vector<double>                    values;
    std::vector<double>                    axial_values;
    Vector                                 velocity_memory;

    /**
     * Adds the shares of one cell at one place, not yet divided by the number
     * of cells.
     */
    void
    add_shares(const Cell         &cell,
               const Point<dim>   &position,
               const unsigned int  place,
               std::vector<Share> &shares) const;

    /** Calls @p visit(cell, place) for the cells of places that this rank
     * owns. */
    template <typename Visit>
    void
    visit_cells(const std::vector<Place<dim>> &places,
                const Visit                   &visit) const;

    void
    add_values(const Form     form,
               const Vector  &vector,
               const double   factor,
               const Quantity quantity);

    /** @param n_cells of each place */
    void
    find_nonlinear_places(const std::vector<Place<dim>> &places,
                          const std::vector<double>     &n_cells);

    /** The stress in a scene that has coefficients of the temperature. Throws
     * as evaluate(). */
    void
    add_nonlinear_stress(const State &state);

    /** The stress in all other scenes, by forms. */
    void
    add_linear_stress(const State &state, const Vector &velocity);

    /** The values of a quantity are NaN. */
    void
    set_absent(const Quantity quantity);
  };
} // namespace ThermoContact

#endif
