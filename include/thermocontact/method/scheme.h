// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef thermocontact_method_scheme_h
#define thermocontact_method_scheme_h

#include <functional>
#include <string>
#include <vector>

namespace ThermoContact
{
  /** Kinds of integrators in time, make_integrator(). */
  enum class IntegratorKind
  {
    dirk,              ///< the stages of a Butcher tableau
    energy_conserving, ///< the midpoint rule of doc/contact-in-time.md section
                       ///< 6
    box                ///< the one without dispersion there
  };



  /**
   * A time integration scheme: all that the rest of the program may ask about
   * it.
   */
  struct Scheme
  {
    IntegratorKind integrator = IntegratorKind::dirk;

    std::string  name; ///< value of Time/Scheme
    std::string  text; ///< its meaning, for the parameter reference
    unsigned int order = 1;

    /** Systems to solve in a step. */
    unsigned int n_stages = 1;

    /** Its steps can follow a tolerance. */
    bool has_error_estimate = false;

    /** Its errors can increase the energy of a body that nothing drives. */
    bool can_create_energy = true;

    /** Why it needs a body with inertia; empty: it does not. */
    std::string needs_inertia;

    /** Its contact nodes have no mass. */
    bool needs_massless_contact = false;

    /** Why it treats linear contact laws alone; empty: it treats all. */
    std::string needs_linear_contact;

    /** Why its heat exchange cannot depend on the contact; empty: it can. */
    std::string needs_constant_exchange;

    /** Why its fixed end cannot move; empty: it can. */
    std::string needs_resting_end;

    /** The velocity of its contact nodes is the mean one of a step. */
    bool has_mean_velocity = false;

    /**
     * Waves in an elastic rod have no dispersion in its steps, in which they
     * pass one of the equal linear cells: a scheme for these alone, whose mass
     * matrix of displacements has one point to a cell, (C6.8).
     */
    bool has_no_dispersion = false;

    /** The viscosity acts on its contact nodes. */
    bool has_viscous_contact = true;

    /**
     * Why a step cannot hold the state of contact, so that steps do not end
     * where it changes; empty: it can.
     */
    std::string cannot_hold_contact;

    /**
     * The scheme of the paper: it may have the paper's prescribed first step
     * and fixed point iteration.
     */
    bool is_backward_euler = false;

    /** Steps under a tolerance $\epsilon$ are about as many as $\epsilon^{-e}$.
     */
    double step_exponent = 0.25;
  };



  /**
   * The schemes of the program: each Butcher tableau, and those that have an
   * integrator of their own.
   */
  const std::vector<Scheme> &
  schemes();

  /** The scheme of that name, which exists. */
  const Scheme &
  scheme(const std::string &name);

  /** The one for all purposes: steps from a tolerance. */
  const Scheme &
  default_scheme();

  /** The first that @p is_wanted, or nullptr. */
  const Scheme *
  find_scheme(const std::function<bool(const Scheme &)> &is_wanted);
} // namespace ThermoContact

#endif
