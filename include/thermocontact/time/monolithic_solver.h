// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef thermocontact_time_monolithic_solver_h
#define thermocontact_time_monolithic_solver_h

#include <thermocontact/method/contact_solver.h>
#include <thermocontact/space/body.h>
#include <thermocontact/time/stage_factorization.h>
#include <thermocontact/time/stage_solver.h>

#include <deal.II/lac/full_matrix.h>

#include <list>

namespace ThermoContact
{
  /**
   * The monolithic stage: both fields at once and contact exactly, doc/model.md
   * (M.15)-(M.18). One factorisation per stage length; those used last are
   * kept, since error-controlled steps come back to few sizes. The response to
   * unit pressures is computed when a node first reaches the obstacle.
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

    bool
    can_hold_nodes() const override
    {
      return true;
    }

    void
    keep_contact(const std::vector<bool>   &is_closed,
                 const std::vector<double> &pressure,
                 State                     &difference) override;

    types::global_dof_index
    n_factorized_unknowns() const override;

    RetainedFactorizations
    retained() const override;

    void
    restore(const RetainedFactorizations &retained) override;

    /**
     * The rates of a stage for zero pressures, to be followed by
     * apply_pressure(); parameters as for solve().
     */
    void
    solve_without_contact(const State  &known,
                          const double  tau,
                          const Vector &heat_load,
                          const Vector &momentum_load,
                          StageRates   &rates);

    /** $W$ of (M.16) for the stage that was solved last. */
    const FullMatrix<double> &
    response();

    /**
     * Adds the response to @p rates.pressure to the rates of the stage that was
     * solved last without contact.
     */
    void
    apply_pressure(StageRates &rates) const;

  private:
    const Body<dim>    &body;
    const ContactSolver contact_solver;

    /** Rates per unit pressure at a node, with the sign reversed. */
    struct UnitResponse
    {
      Vector temperature_rate;
      Vector velocity;
    };

    /** The stage matrix for one stage length and what goes with it. */
    struct Factorization
    {
      StageFactorization<dim>   matrix;
      std::vector<UnitResponse> unit_responses;
      FullMatrix<double>        response; ///< $W$
    };

    const unsigned int       max_factorizations;
    std::list<Factorization> factorizations; ///< the one used last in front

    Vector              heat_rhs;
    Vector              momentum_rhs;
    std::vector<double> known_penetration;
    std::vector<double> free_penetration;

    /** Puts the factorisation for @p tau in front. */
    void
    provide_factorization(const double tau);

    void
    compute_response(Factorization &factorization);

    /** Pressures from the penetrations without contact. */
    void
    solve_contact(const State      &known,
                  const ContactMode mode,
                  StageRates       &rates);
  };
} // namespace ThermoContact

#endif
