// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef thermocontact_simulation_spatial_error_monitor_h
#define thermocontact_simulation_spatial_error_monitor_h

#include <thermocontact/contact/event_locator.h>
#include <thermocontact/rod/rod_matrices.h>
#include <thermocontact/scene/scene.h>
#include <thermocontact/simulation/run_history.h>
#include <thermocontact/space/discretization.h>

#include <array>
#include <string>
#include <vector>

namespace ThermoContact
{
  /**
   * The part of a field that the mesh of a rod leaves out, over the run,
   * (D9.1): estimated by the last two coefficients of the Legendre expansion in
   * each cell, or, for degrees 1 and 2, by the next ones that neighbours let
   * expect. Squares of norms, integrated over time.
   */
  struct MeshTail
  {
    double upper = 0.; ///< of the highest coefficients
    double lower = 0.; ///< of those before them

    /**
     * The error to be expected, relative to @p scale, the square of a norm, for
     * @p duration: the geometric mean of the highest coefficients and of those
     * that would follow.
     */
    double
    error(const double scale, const double duration) const;

    /** Ratio by which coefficients decay to the next one; at most 1. */
    double
    rate() const;

    /** Adds @p tail, which was there for the time @p weight. */
    void
    add(const double weight, const MeshTail &tail);

    template <class Archive>
    void
    serialize(Archive &archive, const unsigned int)
    {
      archive &upper &lower;
    }
  };



  /**
   * Estimates whether the mesh of a rod resolves what moves through it, by a
   * few products with short vectors in each of the first 64 steps and in one of
   * eight from then on, each for the time since the last. Of bodies in two and
   * three dimensions it knows at how many nodes across a part of the end
   * touches.
   *
   * The mean over the run counts. At single instants, after a start or
   * an impact, layers are thinner than any cell, and do no harm.
   */
  class SpatialErrorMonitor
  {
  public:
    /** @param scene borrowed */
    template <int dim>
    SpatialErrorMonitor(const Scene               &scene,
                        const Discretization<dim> &discretization);

    /**
     * Takes an accepted state.
     *
     * @param record of that state: its size of the step, energy and contact
     */
    void
    add(const State &state, const StepRecord &record);

    /** Estimated error of a field that the scene has, relative to it. */
    double
    error(const Field::Block field) const;

    /**
     * At the end of a run: the fault of the mesh, and the degree or the number
     * of cells to take; nothing if there is none. Once.
     */
    std::string
    take_warning();

    /** The part that changes during a run, for checkpoints. */
    template <class Archive>
    void
    serialize(Archive &archive, const unsigned int)
    {
      archive &heat &strain &n_steps &duration &time_skipped &max_thermal
        &max_mechanical &has_warned &largest_force &touching;
    }

  private:
    const Scene        &scene;
    const RodLayout     layout;
    std::vector<double> cell_sizes;

    /** The parts of a cell in differences of neighbours; of low degrees. */
    struct CellFactors
    {
      double coefficient = 0.; ///< of the product with the nodal values
      double before      = 0.; ///< of the coefficient of the cell before
      double square      = 0.; ///< of the square of a difference
    };

    /** By field. */
    std::vector<CellFactors> factors[2];

    /** Of the nodes of a cell in its last two Legendre coefficients. */
    std::vector<double> upper_weights, lower_weights;

    MeshTail     heat, strain; ///< over the time so far
    unsigned int n_steps        = 0;
    double       duration       = 0.; ///< from the start to the last sample
    double       time_skipped   = 0.; ///< of the steps since then
    double       max_thermal    = 0.;
    double       max_mechanical = 0.;
    bool         has_warned     = false;
    double       largest_force  = 0.; ///< of a body

    /** Numbers of the nodes that touched then; none if all did. */
    std::vector<unsigned int> touching;

    /** y and z of the contact nodes of a body. */
    std::vector<std::array<double, 2>> places_across;
    bool                               has_half; ///< the axis is a side

    void
    note_contact(const State &state, const double force);

    /** take_warning() for a body. */
    std::string
    doubt_of_contact() const;

    /** The nodal values of a cell, weighted. */
    double
    product(const std::vector<double> &weights,
            const unsigned int         cell,
            const Vector              &vector) const;

    /** Makes the factors of a field. @param n_derivatives 1 for the strain, else 0 */
    void
    make_factors(const Field::Block field, const unsigned int n_derivatives);

    /**
     * The tail of a field at one time.
     *
     * @param n_derivatives 1 for the strain, 0 for the temperature
     */
    MeshTail
    tail(const Field::Block field,
         const Vector      &vector,
         const unsigned int n_derivatives) const;

    void
    add_last_coefficients(const Vector &vector,
                          const double  upper_factor,
                          const double  lower_factor,
                          const int     power,
                          MeshTail     &tail) const;

    void
    add_differences(const Field::Block field,
                    const Vector      &vector,
                    MeshTail          &tail) const;

    /** What to take for a mesh whose error is too large. */
    std::string
    remedy(const double error, const double rate) const;
  };



  /**
   * Spacing of the contact nodes with which a mesh has the largest force of an
   * impact on a linear obstacle, doc/discretisation.md section 9: the length
   * $\sqrt{\zeta t/b}$ over which viscosity spreads it in the time t of (D7.3)
   * in which the obstacle gives way; 0 at a rigid one, whose force has no
   * limit. Infinite where viscosity or inertia have no part in it.
   */
  double
  spacing_of_largest_force(const Scene &scene);

  /**
   * True if there was an impact, and the end node stands for more than half of
   * that, or the mesh has fronts that it does not resolve (SchemeChoice).
   */
  bool
  is_largest_force_of_mesh(const Scene                     &scene,
                           const std::vector<ContactEvent> &events);

  /**
   * Part of its jump by which a front of the scheme without dispersion
   * overshoots at the largest force, since the shortest waves stay behind: from
   * above. 0 of other schemes.
   */
  double
  overshoot_of_fronts(const Scene &scene, const RunHistory &history);

  /**
   * Why, and what to do about it: the only place where a run says so. Empty
   * where the largest force is not that of the mesh, and no front overshoots by
   * more than a percent.
   */
  std::string
  warning_of_largest_force(const Scene &scene, const RunHistory &history);
} // namespace ThermoContact

#endif
