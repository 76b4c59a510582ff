// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef thermocontact_time_monolithic_solver_h
#define thermocontact_time_monolithic_solver_h

#include <thermocontact/base/recently_used.h>
#include <thermocontact/contact/exchange_solver.h>
#include <thermocontact/contact/interface_problem.h>
#include <thermocontact/space/body.h>
#include <thermocontact/space/linear_system.h>
#include <thermocontact/time/stage_solver.h>

#include <array>
#include <memory>
#include <vector>

namespace ThermoContact
{
  /**
   * Step sizes whose factors are kept: as many as small bodies profit from, and
   * large ones have memory for.
   */
  unsigned int
  n_kept_factorizations(const unsigned int dim, const std::size_t n_unknowns);



  /**
   * The monolithic stage: both fields at once and contact exactly,
   * doc/discretisation.md (D2.2), (C2.1), (C2.2), (C2.4), with a heat exchange
   * that depends on it, (C5.1), (C5.2). One factorisation per stage length;
   * those used last are kept, since error-controlled steps come back to few
   * sizes. The response to unit pressures, and heat fluxes, is computed when it
   * is first needed.
   */
  template <int dim>
  class MonolithicSolver : public StageSolver
  {
  public:
    /** @param body borrowed */
    explicit MonolithicSolver(const Body<dim> &body);

    void
    solve(const State  &known,
          const double  tau,
          const Vector &heat_load,
          const Vector &momentum_load,
          ContactMode   mode,
          StageRates   &rates) override;

    /**
     * Stages of length @p tau are solved by these tangents from now on instead
     * of the equations of the body. Earlier factors are dropped.
     */
    void
    factorize(const double                                           tau,
              std::unique_ptr<const ThermoviscoelasticOperator<dim>> tangents);

    void
    subtract_response(const std::vector<AffineLaw> &laws,
                      const std::vector<double>    &displacement,
                      State                        &difference) override;

    types::global_dof_index
    n_factorized_unknowns() const override;

    std::string
    linear_solver() const override;

    RetainedFactorizations
    retained() const override;

    void
    restore(const RetainedFactorizations &retained) override;

    const FullMatrix<double> &
    response(const double tau) override;

    void
    apply_pressure(StageRates &rates) override;

  private:
    const Body<dim> &body;

    const HeatExchange &exchange;
    InterfaceProblem    problem;

    /** Rates per unit pressure, or heat flux, with the sign reversed. */
    struct UnitResponse
    {
      Vector temperature_rate;
      Vector velocity;
    };

    /** The stage matrix for one stage length and what goes with it. */
    struct Factorization
    {
      double            tau;
      LinearSystem<dim> system;

      /** To pressures: Field::displacement; to fluxes: Field::temperature. */
      std::array<std::vector<UnitResponse>, 2> unit_responses;

      EndResponse end; ///< their effect on the contact nodes

      bool
      has_response() const
      {
        return !unit_responses[Field::displacement].empty();
      }
    };

    RecentlyUsed<Factorization> factorizations;
    bool                        has_refused_blocks = false;

    Vector              heat_rhs;
    Vector              momentum_rhs;
    std::vector<double> end_values; ///< of the contact nodes, scratch
    std::vector<double> known_values;

    // the contact nodes of a stage: penetrations, or velocities where the law
    // has damping, as the laws measure them
    std::vector<NodeLaw> laws;
    std::vector<double>  start;    ///< local positions at the known values
    std::vector<double>  free;     ///< without pressure
    std::vector<double>  end_flux; ///< of heat into the obstacle

    /** Puts the factorisation for @p tau in front. */
    void
    provide_factorization(const double tau);

    void
    keep(const double tau, LinearSystem<dim> &&system);

    /** The rates of a stage for zero pressures, on which they depend linearly.
     */
    void
    solve_without_contact(const State  &known,
                          const double  tau,
                          const Vector &heat_load,
                          const Vector &momentum_load,
                          StageRates   &rates);

    /** $W$ of (C2.1) for the stage that was solved last. */
    const FullMatrix<double> &
    response();

    /** All that the scene needs. */
    void
    compute_response(Factorization &factorization);

    /** To unit loads of the contact nodes on one of the fields. */
    void
    compute_unit_responses(const Field::Block load,
                           Factorization     &factorization);

    /** The loss of @p field at the contact nodes by unit loads on @p load. */
    FullMatrix<double>
    loss_at_end(const Field::Block   field,
                const Field::Block   load,
                const Factorization &factorization) const;

    /** Takes the responses to loads of the contact nodes from the rates. */
    void
    subtract_responses(const Field::Block         load,
                       const std::vector<double> &densities,
                       StageRates                &rates) const;

    /** The laws of a stage, and the nodes at its end without pressure. */
    void
    set_interface(const State      &known,
                  const ContactMode mode,
                  const StageRates &rates);

    /** Pressures from the penetrations or velocities without contact. */
    void
    solve_contact(const State &known, StageRates &rates);

    /**
     * Whether the pressures of a stage have taken away so much of the
     * motion without contact that rounding of it spoils what is left: a body
     * in equilibrium with the obstacle, in a short stage
     * (doc/contact-in-time.md section 2).
     */
    bool
    has_lost_digits(const State &known, const StageRates &rates);

    /**
     * Iterative refinement of a stage and its pressures, (D2.2) and (C3.2),
     * with the set of nodes in contact as it is.
     *
     * @param flux into the obstacle at the contact nodes, which stays as it is;
     *   empty: it is part of the matrix
     */
    void
    refine(const State               &known,
           const Vector              &heat_load,
           const Vector              &momentum_load,
           const std::vector<double> &flux,
           StageRates                &rates);

    /**
     * The right-hand sides become what the rates leave of (D2.2); @p products
     * are scratch.
     */
    void
    compute_residual(const State               &known,
                     const Vector              &heat_load,
                     const Vector              &momentum_load,
                     const std::vector<double> &flux,
                     const StageRates          &rates,
                     StageRates                &products);

    /** Pressures and heat fluxes from the end of the stage without them. */
    void
    solve_exchange(const State &known, StageRates &rates);
  };
} // namespace ThermoContact

#endif
