// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef thermocontact_space_energy_h
#define thermocontact_space_energy_h

#include <thermocontact/contact/contact_law.h>
#include <thermocontact/space/loads.h>
#include <thermocontact/space/surroundings.h>
#include <thermocontact/space/thermoviscoelastic_operator.h>

namespace ThermoContact
{
  /** The energy (M2.2) term by term, per unit cross-section. */
  struct EnergyTerms
  {
    double thermal  = 0.; ///< $\frac12\|\hat\theta\|^2$
    double kinetic  = 0.; ///< $\frac b2\|v\|^2$
    double elastic  = 0.; ///< $\frac12(C\varepsilon(u),\varepsilon(u))$
    double obstacle = 0.; ///< $\frac\varepsilon2\|p\|_{\Gamma_C}^2$
    double coupling = 0.; ///< $-a(\theta_s,\mathrm{div}\,u)$

    double
    sum() const
    {
      return thermal + kinetic + elastic + obstacle + coupling;
    }

    /** Sum of absolute values: rounding of the sum is relative to it. */
    double
    magnitude() const;

    template <class Archive>
    void
    serialize(Archive &archive, const unsigned int)
    {
      archive &thermal &kinetic &elastic &obstacle &coupling;
    }
  };



  /**
   * Energy and its audit, doc/model.md (M2.2), (D4.1)-(D4.4), each line by its
   * own formula. All results are per unit cross-section area. Collective.
   * Energies steer steps and events: sums over ranks may differ in rounding
   * from one to the other, and all ranks get those of rank 0.
   */
  template <int dim>
  class Energy
  {
  public:
    /** The references are borrowed. */
    Energy(const Scene                           &scene,
           const Discretization<dim>             &discretization,
           const ThermoviscoelasticOperator<dim> &stage_operator,
           const Loads<dim>                      &loads,
           const Surroundings<dim>               &surroundings);

    /** $\hat E$ of (M2.2). */
    EnergyTerms
    energy(const State &state) const;

    /** The part of it that the obstacle stores; not that of rank 0. */
    double
    obstacle_energy(const State &state) const;

    /**
     * The quadratic terms of (M2.2) of a difference between two states at the
     * same time: half the squares of its norms in the energy. The difference
     * of the pressures is that of the displacements over $\varepsilon$ at the
     * nodes in contact.
     *
     * @param difference of temperature, displacement and velocity; its
     *   pressures are not used
     * @param pressure tells by its sign which nodes are in contact
     */
    EnergyTerms
    difference_energy(const State               &difference,
                      const std::vector<double> &pressure) const;

    /**
     * Rate of physical dissipation, (D4.2), (D4.5), without its $\Delta t$:
     * $\|\nabla\hat\theta\|^2+k\|\hat\theta\|_{\Gamma_C}^2+\zeta(C\varepsilon
     * (v),\varepsilon(v))\ge0$, with the $k$ of @p state.
     */
    double
    dissipation_rate(const State &state) const;

    /** The part of it that leaves through the lateral faces, (D4.5). */
    double
    lateral_dissipation_rate(const State &state) const;

    /**
     * Dissipation at the contact per time, (D4.7): the work that the obstacle
     * takes from the body and does not store; 0 without damping. Collective.
     */
    double
    damping_rate(const State &state) const;

    /**
     * Power of an obstacle that moves, (D4.8): its action on the body times its
     * velocity, $-\sum_iw_ip_ig'_i$ per unit cross-section, positive where it
     * moves towards the body.
     */
    double
    obstacle_power(const State &state) const;

    /**
     * Numerical dissipation of one backward Euler step, (D4.3); every term is
     * not negative. Both states carry the pressures of the scheme.
     */
    double
    numerical_dissipation(const State &old_state, const State &state) const;

    /** True if anything does work, Scene::has_work(). */
    bool
    has_work() const
    {
      return has_work_;
    }

    /**
     * Rate of work of the sources, of a heat exchange that is not the one of
     * the steady profile, and, if thermoelastic heating is off, of the thermal
     * stress, $a(\hat\theta,\mathrm{div}\,v)$; (D4.4) without its $\Delta t$.
     *
     * @param heat_load,momentum_load loads at the time of @p state as
     *   Loads::assemble() gives them
     */
    double
    work_rate(const Vector &heat_load,
              const Vector &momentum_load,
              const State  &state) const;

    /**
     * Work of the sources that push the body, and, if thermoelastic heating is
     * off, of the thermal stress, in a motion of the body at once: the part of
     * (D4.4) with $v$, per unit cross-section, nondimensional. Collective.
     *
     * @param state after it
     * @param motion change of the displacement, or its velocity for a rate
     */
    double
    work_of_motion(const Vector &momentum_load,
                   const State  &state,
                   const Vector &motion) const;

    /**
     * Nodal values of the steady profile $\theta_s$, relative to which heat has
     * energy: the temperature at rest, without sources, with the heat exchange
     * $k_s$ of the undeformed body. The interpolant of (M2.1), or, with a
     * lateral heat exchange, the solution of the semidiscrete equation (M5.7).
     * Of a row it is the temperature of the left end everywhere, and what is
     * around the bodies does work, (M10.3).
     */
    const Vector &
    steady_profile() const;

    /** $\frac12\|\theta_s\|^2$. */
    double
    steady_profile_energy() const;

  private:
    const Discretization<dim>             &discretization;
    const ThermoviscoelasticOperator<dim> &stage_operator;
    const Loads<dim>                      &loads;
    const Surroundings<dim>               &surroundings;
    const SceneContact                    &contact;
    const Material                        &material;
    const SceneHeat                       &heat;
    const bool                             has_work_;
    Vector                                 steady_profile_;
    std::vector<double>                    steady_end;    ///< at contact nodes
    Vector                                 steady_stress; ///< $D^T\theta_s$
    double reference_coefficient; ///< $k_s$ that the profile balances

    /** The heat of the surroundings of a row that its profile does not balance.
     */
    Vector unbalanced_heat;

    mutable Vector               heat_scratch;
    mutable Vector               heat_product;
    mutable Vector               momentum_scratch;
    mutable Vector               momentum_product;
    mutable std::vector<double>  end_displacement;
    mutable std::vector<double>  end_velocity;
    mutable std::vector<double>  old_end_displacement;
    mutable std::vector<double>  end_temperature;
    mutable std::vector<double>  end_pressure;
    mutable std::vector<double>  old_end_pressure;
    mutable std::vector<NodeLaw> laws;     ///< of the contact nodes
    mutable std::vector<double>  position; ///< of them

    /** The terms of rank 0, on all ranks. */
    EnergyTerms
    common(const EnergyTerms &terms) const;

    /** $\frac12\|\theta\|^2$ of a temperature, less another one if given. */
    double
    thermal_energy(const Vector &temperature,
                   const Vector *subtracted = nullptr) const;

    /** $\frac12(C\varepsilon(u),\varepsilon(u))$ of a displacement, less
     * another one if given. */
    double
    elastic_energy(const Vector &displacement,
                   const Vector *subtracted = nullptr) const;

    /** $\frac b2\|v\|^2$ of a velocity, less another one if given. */
    double
    kinetic_energy(const Vector &velocity,
                   const Vector *subtracted = nullptr) const;

    /** Per unit cross-section; 0 for a field that is absent. */
    double
    form(const Field::Block field,
         const LinearMap   &map,
         const Vector      &vector,
         const Vector      *subtracted = nullptr) const;

    /** (M2.1) or (M5.7). */
    void
    set_steady_profile();

    double
    contact_dissipation(const State &old_state, const State &state) const;

    /**
     * The pressures whose energy the obstacle stores: of @p state, or with damping of its penetrations at rest.
     *
     * Sets @p laws and @p position, of damped ones.
     *
     * @param scratch may be the result
     */
    const std::vector<double> &
    elastic_pressures(const State &state, std::vector<double> &scratch) const;

    /**
     * Mean over the contact end of $\hat\theta$ times @p power(i,
     * $\hat\theta_i$): of the exchange that matrices do not contain.
     */
    template <typename Power>
    double
    mean_of_end(const Vector &excess, const Power &power) const;
  };
} // namespace ThermoContact

#endif
