// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef thermocontact_forecast_coarse_rod_h
#define thermocontact_forecast_coarse_rod_h

#include <thermocontact/scene/scene.h>

#include <deal.II/base/tensor.h>

#include <vector>

namespace ThermoContact
{
  /**
   * A rod without sources on a few linear elements, finer towards its ends,
   * (M.44), in large steps of an L-stable scheme of order 2, (M.46): what is
   * known before a run is read off it. All couplings of the scene, and exact
   * contact in each stage, but for the damping of the obstacle and a stop
   * behind; a heat exchange that varies has the coefficient of the reference.
   */
  class CoarseRod
  {
  public:
    /** Values at the nodes, the one at the fixed end first. */
    struct State
    {
      std::vector<double> temperature, displacement, velocity;
    };

    /**
     * @param scene borrowed: a rod with inertia and a law of contact
     * @throw InputError if an initial value cannot be evaluated
     */
    explicit CoarseRod(const Scene &scene);

    /** At $t=0$; not finite where an initial value is not. */
    const State &
    initial_state() const
    {
      return initial;
    }

    /**
     * A step of length @p dt.
     *
     * @param meets_obstacle false: it goes through
     * @return pressure at its end
     */
    double
    step(State &state, const double dt, const bool meets_obstacle);

    /**
     * Distances of neighbouring nodes, from the fixed end on, (M.44).
     *
     * @param smallest the one at the contact end, at most 1/64
     */
    static std::vector<double>
    cell_sizes(const double smallest);

  private:
    using Block  = dealii::Tensor<2, 2>; ///< rows and columns (theta, v)
    using Vector = std::vector<dealii::Tensor<1, 2>>;

    const Scene              &scene;
    const std::vector<double> h; ///< cell i ends at node i + 1
    State                     initial;

    // the factors of a stage of length tau, without the node at the fixed end
    double             tau = 0.;
    std::vector<Block> lower, inverse, upper;

    /** Loss of displacement of the end per unit pressure in a stage, and how
     * temperatures and velocities respond. */
    double receptance = 0.;
    Vector response;

    void
    factorize(const double tau);

    void
    solve(Vector &vector) const;

    /** A stage from @p base, which it moves to its end. */
    double
    stage(State &base, const bool meets_obstacle) const;
  };
} // namespace ThermoContact

#endif
