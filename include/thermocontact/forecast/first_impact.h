// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef thermocontact_forecast_first_impact_h
#define thermocontact_forecast_first_impact_h

#include <thermocontact/scene/scene.h>

#include <array>
#include <complex>
#include <optional>
#include <utility>
#include <vector>

namespace ThermoContact
{
  /** What the rod does at its first impact, estimated. */
  struct FirstImpact
  {
    double time        = 0.;
    double velocity    = 0.; ///< $u_t(1)>0$ just before
    double penetration = 0.; ///< largest of the contact; 0: rigid obstacle
    double force       = 0.; ///< largest of the contact; none if rigid
  };



  /**
   * The end displacement of the rod that meets no obstacle, in its modes: an
   * exact series for the Kelvin-Voigt rod under the thermal stress of the
   * initial temperature, doc/model.md (M.44).
   */
  class FreeMotion
  {
  public:
    /** @param scene a rod with inertia and without sources */
    explicit FreeMotion(const Scene &scene);

    /** Displacement and velocity of the end at @p time. */
    std::pair<double, double>
    end_values(const double time) const;

    /** $a\int\theta_0$, the free expansion of the initial temperature. */
    double
    initial_expansion() const
    {
      return initial_expansion_;
    }

  private:
    /** $c_1 e^{r_1t}+c_2 e^{r_2t}$, with the value of the mode at the end. */
    struct Mode
    {
      std::array<std::complex<double>, 2> rates;
      std::array<std::complex<double>, 2> amplitudes;
    };

    std::vector<Mode> modes;
    double            offset;
    double            initial_expansion_;
  };



  /**
   * Estimates the first impact of a rod that its initial values throw against
   * the obstacle, doc/model.md (M.44), (M.45).
   *
   * @return nothing where that would not be honest: no inertia or no obstacle,
   *   more than one dimension, sources, initial contact, no impact before the
   *   end time, or one that heat rather than momentum decides
   */
  std::optional<FirstImpact>
  first_impact(const Scene &scene);



  /**
   * Displacement that the end of a rod loses per unit pressure in a stage of
   * length @p tau, $\chi(\tau)$ of doc/model.md (M.20), without coupling.
   */
  double
  rod_response(const Material &material, const double tau);
} // namespace ThermoContact

#endif
