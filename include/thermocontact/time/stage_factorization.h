// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef thermocontact_time_stage_factorization_h
#define thermocontact_time_stage_factorization_h

#include <thermocontact/rod/rod_factors.h>
#include <thermocontact/space/direct_solver.h>
#include <thermocontact/space/thermoviscoelastic_operator.h>

#include <memory>
#include <string>

namespace ThermoContact
{
  /**
   * The factorised stage matrix of doc/discretisation.md (D2.2) for one stage
   * length, in as many pieces as the scene allows: fields that act on each
   * other are one matrix; if the motion does not heat the body, or a field is
   * absent, each field has a matrix of its own, and the heat equation is solved
   * first. The matrices of a rod in one process are eliminated by blocks along
   * it; if blocks grow on the way, and otherwise, they are left to sparse
   * factors.
   *
   * The sum of a mass and a stiffness has the mass to the last digit of the
   * stiffness alone, 1e-14 of it with 250 cells: as if a friction were there,
   * which adds up over the steps. Solutions of a rod by sparse factors are
   * therefore corrected once by the residual, in which no sum is formed.
   */
  template <int dim>
  class StageFactorization
  {
  public:
    /**
     * The references are borrowed.
     *
     * @throw ComputationError if a matrix cannot be factorised
     */
    StageFactorization(const Discretization<dim>             &discretization,
                       const ThermoviscoelasticOperator<dim> &stage_operator,
                       const double                           tau);

    /**
     * Solves (D2.2) without contact.
     *
     * @param heat_rhs,momentum_rhs its right-hand side; both may be
     *   changed
     * @param temperature_rate,velocity out: $\theta'$, $v$
     */
    void
    solve(Vector &heat_rhs,
          Vector &momentum_rhs,
          Vector &temperature_rate,
          Vector &velocity);

    double
    tau() const
    {
      return tau_;
    }

    /** Number of matrices. */
    unsigned int
    n_factorizations() const
    {
      return stage_operator.is_coupled() ?
               1 :
               discretization.has_field(Field::temperature) +
                 discretization.has_field(Field::displacement);
    }

    /** Why a rod was left to sparse factors; empty: it was not. */
    std::string
    warning() const;

  private:
    const Discretization<dim>             &discretization;
    const ThermoviscoelasticOperator<dim> &stage_operator;
    const double                           tau_;
    double                                 refused_growth;
    std::unique_ptr<const RodFactors<2>>   rod_whole;
    std::unique_ptr<const RodFactors<1>>   rod_heat;
    std::unique_ptr<const RodFactors<1>>   rod_momentum;
    std::unique_ptr<DirectSolver>          whole;
    std::unique_ptr<DirectSolver>          heat;
    std::unique_ptr<DirectSolver>          momentum;
    SystemVector                           system_rhs;
    SystemVector                           system_rates;
    Vector                                 heat_residual;
    Vector                                 momentum_residual;
    Vector                                 heat_correction;
    Vector                                 momentum_correction;

    /** solve() by the factors as they are. */
    void
    solve_once(Vector &heat_rhs,
               Vector &momentum_rhs,
               Vector &temperature_rate,
               Vector &velocity);

    /** False if blocks grow: nothing is factorised then. */
    bool
    factorize_rod(const RodMatrices &matrices, const Material &material);

    void
    factorize_sparse();
  };
} // namespace ThermoContact

#endif
