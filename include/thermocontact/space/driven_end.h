// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef thermocontact_space_driven_end_h
#define thermocontact_space_driven_end_h

#include <thermocontact/space/energy.h>

#include <vector>

namespace ThermoContact
{
  /**
   * Scalars that are functions of time at the end of a stage,
   * doc/discretisation.md (D6.1), (C8.1); empty: there are none.
   */
  struct PrescribedStage
  {
    std::vector<double> values;        ///< $\theta_D$, $u_D$, $g$
    std::vector<double> rates;         ///< $\theta'_D$, $v_D$, $g'$
    std::vector<double> accelerations; ///< $v'_D$, $g''$
  };



  /**
   * Positions of the unknowns of the fixed end within the locally owned part of
   * a block: temperatures, or displacements along the axis.
   */
  template <int dim>
  std::vector<unsigned int>
  entries_of_fixed_end(const Discretization<dim> &space,
                       const Field::Block         field);



  /**
   * The fixed end of a scene in which its temperature or its displacement is a
   * function of time. Constrained unknowns then have values and rates that are
   * not zero, and both act on the rest of the body through the columns of the
   * matrices that solvers leave out.
   */
  template <int dim>
  class DrivenEnd
  {
  public:
    /** All arguments are borrowed. */
    DrivenEnd(const Scene                           &scene,
              const Discretization<dim>             &discretization,
              const ThermoviscoelasticOperator<dim> &equations,
              const Loads<dim>                      &loads,
              const Energy<dim>                     &energy);

    /** False: everything here does nothing. */
    bool
    is_active() const
    {
      return scene.sources.drives_end();
    }

    /**
     * Positions of driven unknowns within the locally owned part of a block:
     * temperatures, or displacements along the axis, of the fixed end.
     */
    const std::vector<unsigned int> &
    entries(const Field::Block field) const
    {
      return entries_[field];
    }

    /**
     * Puts a motion of the entries() into the equations of a stage: its values
     * into the known ones, its rates into the loads, so that a solver, for
     * which rates vanish at the fixed end, finds the others; (D6.2).
     */
    void
    constrain(const PrescribedStage &temperature,
              const PrescribedStage &displacement,
              State                 &known,
              Vector                &heat_load,
              Vector                &momentum_load) const;

    /** Sets entries() of a field; does nothing if @p values is empty. */
    void
    set(const Field::Block         field,
        const std::vector<double> &values,
        Vector                    &vector) const;

    /**
     * Power of the drive of the end, per unit cross-section: the heat that
     * flows in there beyond the heat flow at rest times $\hat\theta_D$, and the
     * force on the end times its velocity; (D6.3). Collective.
     *
     * @param state at the end of a stage, with the motion
     * @param temperature_rate,acceleration $\theta'$ and $v'$, with the motion
     * @param heat_load,momentum_load loads alone
     */
    double
    power(const State  &state,
          const Vector &temperature_rate,
          const Vector &acceleration,
          const Vector &heat_load,
          const Vector &momentum_load) const;

    /** Sets the velocity of the end to that of the drive at @p time. */
    void
    set_velocity(const double time, Vector &velocity) const;

  private:
    const Scene                           &scene;
    const Discretization<dim>             &discretization;
    const ThermoviscoelasticOperator<dim> &equations;
    const Loads<dim>                      &loads;
    const Energy<dim>                     &energy;
    std::vector<std::vector<unsigned int>> entries_;
    mutable Vector                         heat_lift; ///< zero but for the end
    mutable Vector                         heat_product;
    mutable Vector                         momentum_lift;
    mutable Vector                         momentum_product;

    /** Heat flow through each entry of the end beyond that of rest. */
    double
    heat_power(const State  &state,
               const Vector &temperature_rate,
               const Vector &heat_load) const;

    double
    force_power(const State  &state,
                const Vector &acceleration,
                const Vector &momentum_load) const;
  };
} // namespace ThermoContact

#endif
