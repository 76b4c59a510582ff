// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef thermocontact_time_box_solver_h
#define thermocontact_time_box_solver_h

#include <thermocontact/base/recently_used.h>
#include <thermocontact/rod/rod_factors.h>
#include <thermocontact/space/body.h>
#include <thermocontact/time/stage_solver.h>

#include <array>
#include <memory>

namespace ThermoContact
{
  /**
   * The heat of a step at two times, $\Delta t/3$ and $\Delta t$, by the Radau
   * IIA method of order 3, doc/contact-in-time.md (C6.9).
   */
  struct HeatStages
  {
    static constexpr unsigned int n = 2;

    static constexpr std::array<double, n> times   = {{1. / 3., 1.}};
    static constexpr std::array<double, n> weights = {{0.75, 0.25}};

    static constexpr std::array<std::array<double, n>, n> coefficients = {
      {{{5. / 12., -1. / 12.}}, {{0.75, 0.25}}}};

    static constexpr std::array<std::array<double, n>, n> inverse = {
      {{{1.5, 0.5}}, {{-4.5, 2.5}}}};
  };



  /** The rates of a step: of heat at its stages, and the velocity in it. */
  struct BoxRates
  {
    std::array<Vector, HeatStages::n> temperature_rate; ///< $\theta'_i$
    Vector                            velocity;         ///< $w$
  };



  /**
   * The linear system of a step of the scheme `box`, (C6.9), for a rod: all
   * unknowns of a node are one block. Factors of the lengths used last are
   * kept, with the responses to a unit pressure and to unit heat fluxes.
   */
  class BoxSolver : public StageSolver
  {
  public:
    /** @param body borrowed */
    explicit BoxSolver(const Body<1> &body);

    /** Zero vectors of the right layout. */
    BoxRates
    make_rates() const;

    /**
     * Solves the system of a step by @p size. Rates vanish at the fixed end.
     *
     * @param right of heat at both stages and, times $\Delta t/2$, of momentum
     * @throw ComputationError if the blocks cannot be eliminated
     */
    void
    solve(const double size, const BoxRates &right, BoxRates &rates);

    /**
     * $(bM_u+\Delta t\,\zeta S)\,y=r$, of a viscous rod; y vanishes at the
     * fixed end.
     */
    void
    solve_viscous(const double size, const Vector &right, Vector &solution);

    /** The loss of the rates of such a step by a unit pressure at a contact.
     */
    const BoxRates &
    response_to_pressure(const double size, const unsigned int contact);

    /** Their loss by a unit heat flux through it in a stage. */
    const BoxRates &
    response_to_flux(const double       size,
                     const unsigned int contact,
                     const unsigned int stage);

    void
    solve(const State &,
          const double,
          const Vector &,
          const Vector &,
          ContactMode,
          StageRates &) override;

    types::global_dof_index
    n_factorized_unknowns() const override;

    std::string
    linear_solver() const override
    {
      return "block tridiagonal";
    }

    RetainedFactorizations
    retained() const override;

    void
    restore(const RetainedFactorizations &retained) override;

  private:
    const Body<1> &body;

    struct Factors
    {
      double                               tau; ///< size of the step
      std::unique_ptr<const RodFactors<3>> with_heat;
      std::unique_ptr<const RodFactors<1>> alone;
      std::unique_ptr<const RodFactors<1>> viscous;

      /** Contact by contact to a unit pressure, to a unit flux in each stage;
       * empty: unknown. */
      std::vector<BoxRates> responses;
    };

    RecentlyUsed<Factors> kept;

    /** The factors of a step by @p size. */
    Factors &
    provide(const double size);

    /** To the loads of one contact. */
    unsigned int
    n_responses() const
    {
      return body.scene.heat.exchange->is_in_matrices() ? 1 : 1 + HeatStages::n;
    }

    /** All that the scene needs. */
    void
    compute_responses(Factors &factors);

    void
    solve_by(const Factors  &factors,
             const BoxRates &right,
             BoxRates       &rates) const;
  };
} // namespace ThermoContact

#endif
