// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef thermocontact_simulation_error_norm_h
#define thermocontact_simulation_error_norm_h

#include <thermocontact/space/energy.h>

namespace ThermoContact
{
  /**
   * Measures the error estimate of a step relative to the solution so far,
   * doc/discretisation.md (D3.4):
   * @f[
   *   \left( \frac{\|e_\theta\|^2}
   *   {\max(\|\hat\theta\|^2,\,a^2E/\max(1,b))} +
   *   \frac{\|\nabla e_u\|^2 + b\|e_v\|^2 + \varepsilon e_p^2}
   *        {E} \right)^{1/2} , \qquad E=\max(\|\nabla u\|^2, b\|v\|^2) .
   * @f]
   * The maxima are over all accepted states and the one that the step has
   * reached; a field that is zero takes its scale from the first attempt at a
   * step that moves it, until one is accepted. There is no absolute floor:
   * scaling a scene changes nothing. $a\sqrt E$ is the temperature that
   * deformation makes at once; inertia lets strains of the energy $E$ change by
   * $\sqrt{E/b}$ in the time 1 in which heat flows. An error of the temperature
   * that is rounding of the temperature itself, of which $\hat\theta$ may be a
   * tiny part, counts as none, and so does one of the displacement, as large as
   * what solutions of stages leave, in a body whose end moves it so far that
   * its mechanical energy is rounding.
   */
  class ErrorNorm
  {
  public:
    /**
     * @param temperature_energy $\frac12\|\theta_s\|^2$
     * @param heating $a$ of the heat equation
     * @param inertia $b$
     * @param accuracy of displacements that a stage solves for, over the largest
     */
    ErrorNorm(const double temperature_energy,
              const double heating,
              const double inertia,
              const double accuracy);

    /** Takes a state that is accepted into the maxima. */
    void
    add(const EnergyTerms &energy);

    /**
     * A field that has been zero takes its scale from this attempt at a step,
     * whether it is accepted or not. Arguments as below.
     */
    void
    note_attempt(const EnergyTerms &energy, const double rigid_displacement);

    /**
     * Size of the error of a step.
     *
     * @param error half the squared norms of the estimate
     * @param energy of the state at the end of the step
     * @param rigid_displacement largest displacement there of a body whose end
     *   moves
     */
    double
    operator()(const EnergyTerms &error,
               const EnergyTerms &energy,
               const double       rigid_displacement) const;

    /**
     * Largest elastic or kinetic energy so far, or of the first attempt, and of
     * a state with this one.
     */
    double
    mechanical_energy(const EnergyTerms &energy) const;

    /** The part that changes during a run, for checkpoints. */
    template <class Archive>
    void
    serialize(Archive &archive, const unsigned int)
    {
      archive &max_thermal &max_mechanical &first_thermal &first_mechanical;
    }

  private:
    const double temperature_energy;
    const double heat_of_deformation; ///< $a^2/\max(1,b)$
    const double accuracy;
    double       max_thermal;
    double       max_mechanical;

    /** Of the first attempts that moved a field. */
    double first_thermal;
    double first_mechanical;

    /** True if the mechanical energy is rounding of a body that moves so far.
     */
    bool
    is_rounding(const EnergyTerms &energy,
                const double       rigid_displacement) const;
  };
} // namespace ThermoContact

#endif
