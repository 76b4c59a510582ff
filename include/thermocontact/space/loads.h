// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef thermocontact_space_loads_h
#define thermocontact_space_loads_h

#include <thermocontact/base/types.h>
#include <thermocontact/space/cell_shape.h>
#include <thermocontact/space/discretization.h>
#include <thermocontact/space/enclosed_function.h>
#include <thermocontact/space/problem_data.h>

#include <deal.II/base/polynomial.h>

#include <deal.II/fe/fe_values.h>

#include <array>
#include <map>
#include <optional>
#include <utility>
#include <vector>

namespace ThermoContact
{
  /** A time whose loads are a part of a mean, with its weight. */
  struct WeightedTime
  {
    double time;
    double weight;
  };



  /** The times of a mean of loads. Their weights add up to 1; one is negative
   * where a rule asks for it. */
  using MeanOfTimes = std::vector<WeightedTime>;



  /**
   * The loads of the semidiscrete equations, doc/discretisation.md (D1.1),
   * (D1.2):
   * @f[
   *   \ell_\theta = k\,\theta_{obs}\int_{\Gamma_C}\eta_i +
   *     \theta_\infty\,L1 + \int q\,\eta_i + \int_{\Gamma_C} h\,\eta_i ,
   *   \quad
   *   \ell_u = \int f\cdot\varphi_i + w_i\,t(x_i) .
   * @f]
   * The traction t acts at the contact nodes, as the pressure does.
   */
  template <int dim>
  class Loads
  {
  public:
    /** The references are borrowed; the time of @p data is set from here. */
    Loads(const Scene               &scene,
          const Discretization<dim> &discretization,
          ProblemData<dim>          &data);

    /**
     * The part of $\ell_\theta$ that is no source: heat by the temperatures of
     * obstacle and surroundings.
     */
    const Vector &
    outer_heat() const
    {
      return outer_heat_;
    }

    /** Also those that coefficients of the temperature add later. */
    bool
    has_sources() const
    {
      return !data.sources.empty() || has_nonlinear_terms;
    }

    /**
     * Both loads at @p time. Integrates the sources that the scene has, once if
     * none depends on the time; without sources a copy.
     */
    void
    assemble(const double time, Vector &heat, Vector &momentum);

    /** The mean of both loads. */
    void
    assemble(const MeanOfTimes &times, Vector &heat, Vector &momentum);

    /** The part of both loads that acts on one end, without outer_heat(). */
    void
    assemble_end(const types::boundary_id part,
                 const double             time,
                 Vector                  &heat,
                 Vector                  &momentum);

    /** Its mean. */
    void
    assemble_end(const types::boundary_id part,
                 const MeanOfTimes       &times,
                 Vector                  &heat,
                 Vector                  &momentum);

    /** $\int\varphi_i$ over an end, of the first component of a field. */
    Vector
    weights_of_end(const types::boundary_id part, const Field::Block field);

    /** The derivative in time of $\ell_u$, of the branch that holds then. */
    void
    assemble_momentum_rate(const double time, Vector &momentum);

  private:
    const Discretization<dim> &discretization;
    ProblemData<dim>          &data;
    const double               exchange_coefficient; ///< if it is a number
    const double               inertia;              ///< $b$
    const double               obstacle_mass;        ///< 0: it has none
    const bool    has_nonlinear_terms; ///< SceneSources::has_nonlinear_terms
    const bool    is_steady;           ///< no source depends on the time
    FEValues<dim> fe_values;
    FEFaceValues<dim> face_values;

    /** Basis functions of a field along an axis of the unit cell, and their
     * numbers in its cells. */
    const std::vector<Polynomials::Polynomial<double>> along_axis;
    const std::vector<unsigned int>                    lexicographic;
    std::array<std::vector<double>, dim>               at_point; ///< scratch

    AffineConstraints<double> unconstrained;
    BlockVector               sources;
    dealii::Vector<double>    cell_load;
    Vector                    outer_heat_;

    /** Both loads, once they are known, if they are steady. */
    std::optional<std::pair<Vector, Vector>> steady_loads;

    /**
     * Adds a function that acts on a field, times a factor of the place, to
     * the load of a cell: by @p values, or, where its @p rule has pieces in
     * @p box, which is the cell or its face, by the rule.
     */
    template <typename Factor>
    void
    add(const FEValuesBase<dim>        &values,
        const CellShape<dim>           &cell,
        const BoundingBox<dim>         &box,
        const Function<dim>            &function,
        const PiecewiseRule<dim> *const rule,
        const Field::Block              field,
        const Factor                   &factor);

    /** Adds a value times the basis functions of a component at a point of the
     * unit cell to the load of a cell. */
    void
    add_at_point(const Point<dim>  &unit_point,
                 const unsigned int component,
                 const double       value);

    /** The rule for a source at its time; null for none. */
    const PiecewiseRule<dim> *
    rule(const EnclosedFunction<dim> *const source);

    std::map<const EnclosedFunction<dim> *, PiecewiseRule<dim>> rules;

    /**
     * Adds a load on a part of the boundary to the sources, times a factor:
     * a heat flux into the body, or a force along the axis.
     *
     * @param load null: it is 1
     */
    void
    integrate_face(const types::boundary_id     part,
                   const Field::Block           field,
                   const EnclosedFunction<dim> *load,
                   const double                 factor = 1.);

    /** Adds what acts on an end, but for the traction at contact nodes. */
    void
    integrate_end(const types::boundary_id part);

    /** The mean of loads that @p at assembles at a time. */
    template <typename At>
    void
    add_up(const MeanOfTimes &times,
           const At          &at,
           Vector            &heat,
           Vector            &momentum) const;

    /** Integral over the contact end, of the axial component. */
    double
    sum_over_end(const Function<dim> &load) const;

    /** Adds the traction at contact nodes. */
    void
    add_end_traction(Vector &momentum) const;

    /** Adds heat source and body force. */
    void
    integrate_volume();

    /** The force on a mass at the right end of a gap of a row, (M10.1). */
    void
    add_force_on_mass(
      const typename DoFHandler<dim>::active_cell_iterator &cell);

    /** Adds the part of the sources that acts on a field. */
    void
    add_sources(const Field::Block field, Vector &load) const;

    void
    distribute(const typename DoFHandler<dim>::active_cell_iterator &cell);
  };
} // namespace ThermoContact

#endif
