// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef thermocontact_simulation_energy_monitor_h
#define thermocontact_simulation_energy_monitor_h

#include <thermocontact/scene/scene.h>
#include <thermocontact/space/energy.h>

#include <string>

namespace ThermoContact
{
  /**
   * Monitors the energy of a run without loads, which physics never lets grow
   * (M2.3). A scheme may let it grow by what its errors explain: rounding for
   * schemes that cannot create energy, the tolerance of each step with
   * error-controlled steps, a thousandth with fixed steps of the other schemes;
   * iterations of linear systems a thousandth by their residuals. Arithmetic
   * only.
   */
  class EnergyMonitor
  {
  public:
    /**
     * Monitors nothing if something does work in the scene.
     *
     * @param scene borrowed
     */
    explicit EnergyMonitor(const Scene &scene);

    /** Begins anew from a state with energy @p terms. */
    void
    start(const EnergyTerms &terms);

    /**
     * Takes the state after a step.
     *
     * @param algebraic energy that residuals have brought in in the step, which
     *   the scheme has not created
     * @return a warning with the step and the remedy at the first step after
     *   which there is more energy than that, else nothing
     */
    std::string
    add(const unsigned int step,
        const double       time,
        const EnergyTerms &terms,
        const double       algebraic);

    /** The part that changes during a run, for checkpoints. */
    template <class Archive>
    void
    serialize(Archive &archive, const unsigned int)
    {
      archive &smallest &scale &brought_in &n_steps &has_warned;
    }

  private:
    const Scene &scene;
    const bool   is_active;

    /** A release within a cell gives back the energy that the mean over the
     * cell has lost, (C6.15): the energy is compared with its first value. */
    const bool   gives_back;
    const double allowed_per_run;  ///< relative to the scale
    const double allowed_per_step; ///< likewise
    double       smallest;         ///< energy so far
    double       scale;            ///< largest sum of absolute terms so far
    double       brought_in;       ///< by residuals so far
    unsigned int n_steps;          ///< since the smallest
    bool         has_warned;
  };
} // namespace ThermoContact

#endif
