// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef thermocontact_space_system_coefficients_h
#define thermocontact_space_system_coefficients_h

#include <thermocontact/base/types.h>
#include <thermocontact/rod/rod_factors.h>
#include <thermocontact/rod/rod_matrices.h>
#include <thermocontact/scene/scene.h>

#include <array>
#include <utility>

namespace ThermoContact
{
  /**
   * Which of the linear systems of a body it is,
   * @f[
   *   \begin{pmatrix} h_mM+h_k(K+kB) & c_h\,aD \\
   *     -c_s\,aD^T & e_m\,bM_u+e_v\,\zeta S_\zeta+e_s\,S \end{pmatrix} ,
   * @f]
   * doc/discretisation.md (D2.2). A field whose coefficients are zero is not
   * part of the system.
   * The systems of the program stand below.
   */
  struct SystemCoefficients
  {
    double heat_mass  = 0.; ///< $h_m$
    double conduction = 0.; ///< $h_k$

    double heating        = 0.; ///< $c_h$
    double thermal_stress = 0.; ///< $c_s$

    double inertia   = 0.; ///< $e_m$
    double viscosity = 0.; ///< $e_v$
    double stiffness = 0.; ///< $e_s$

    /** Whether rows of the field belong to the system, if the scene has it. */
    bool
    has(const Field::Block field) const
    {
      return field == Field::temperature ?
               heat_mass != 0. || conduction != 0. :
               inertia != 0. || viscosity != 0. || stiffness != 0.;
    }

    /** The system without the other field. */
    SystemCoefficients
    of(const Field::Block field) const
    {
      if (field == Field::temperature)
        return {heat_mass, conduction};
      return {0., 0., 0., 0., inertia, viscosity, stiffness};
    }

    /** The system for @p s times the temperature, its rows of heat times s. */
    SystemCoefficients
    scaled(const double s) const
    {
      SystemCoefficients c(*this);
      c.heating *= s;
      c.thermal_stress /= s;
      return c;
    }
  };



  /** $M$: heat at one instant, before it flows. */
  inline constexpr SystemCoefficients heat_at_once{1.};

  /** $K+kB$: heat of a body at rest. */
  inline constexpr SystemCoefficients heat_at_rest{0., 1.};

  /** $bM_u$: impulses and velocities, or forces and accelerations. */
  inline constexpr SystemCoefficients
    motion_by_inertia{0., 0., 0., 0., 1., 0., 0.};

  /** $\zeta S_\zeta+S$: forces on a body without inertia. */
  inline constexpr SystemCoefficients
    motion_by_stiffness{0., 0., 0., 0., 0., 1., 1.};

  /** $\zeta S_\zeta$: forces and velocities of a viscous body without inertia.
   */
  inline constexpr SystemCoefficients
    motion_by_viscosity{0., 0., 0., 0., 0., 1., 0.};

  /** Displacements of a body without inertia at once, with the heat of the
   * motion, which does not flow, (C4.4). */
  inline constexpr SystemCoefficients
    motion_at_once{1., 0., 1., 1., 0., 0., 1.};

  /** $S$: displacements at one instant. */
  inline constexpr SystemCoefficients
    motion_without_heat{0., 0., 0., 0., 0., 0., 1.};

  /** A stage of length @p tau for $(\theta',v)$, (D2.2). */
  inline SystemCoefficients
  stage_coefficients(const double tau)
  {
    return {1., tau, 1., tau * tau, 1., tau, tau * tau};
  }



  /** A sum of field matrices: mass, viscous stiffness, stiffness. */
  using BlockTerms = std::array<std::pair<double, FieldMatrix::Kind>, 3>;

  /** The block of a field in its own rows; conduction is its stiffness. */
  inline BlockTerms
  block_terms(const SystemCoefficients &c,
              const Material           &material,
              const Field::Block        field)
  {
    if (field == Field::temperature)
      return {{{c.heat_mass, FieldMatrix::heat_mass},
               {0., FieldMatrix::conduction},
               {c.conduction, FieldMatrix::conduction}}};
    return {{{c.inertia * material.inertia, FieldMatrix::momentum_mass},
             {c.viscosity * material.viscous_factor(),
              FieldMatrix::viscous_stiffness},
             {c.stiffness, FieldMatrix::stiffness}}};
  }



  /** The same, for the factors of a rod. */
  inline RodFactors<1>::Block
  rod_block(const SystemCoefficients &c,
            const Material           &material,
            const Field::Block        field)
  {
    const BlockTerms terms = block_terms(c, material, field);
    return {terms.begin(), terms.end()};
  }



  /** The factor of $D$ in the rows of heat, and of $D^T$ in the others. */
  struct CouplingFactors
  {
    double heating;
    double thermal_stress;
  };

  inline CouplingFactors
  coupling_factors(const SystemCoefficients &c, const Material &material)
  {
    return {c.heating * material.heating,
            -c.thermal_stress * material.thermal_stress};
  }



  struct MassAndStiffness
  {
    double mass;
    double stiffness;
  };

  /** The same with $S$ for $S_\zeta$, as for preconditioners. */
  inline MassAndStiffness
  mass_and_stiffness(const SystemCoefficients &c,
                     const Material           &material,
                     const Field::Block        field)
  {
    const BlockTerms terms = block_terms(c, material, field);
    return {terms[0].first, terms[1].first + terms[2].first};
  }
} // namespace ThermoContact

#endif
