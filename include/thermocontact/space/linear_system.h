// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef thermocontact_space_linear_system_h
#define thermocontact_space_linear_system_h

#include <thermocontact/rod/rod_factors.h>
#include <thermocontact/space/direct_solver.h>
#include <thermocontact/space/system_coefficients.h>
#include <thermocontact/space/thermoviscoelastic_operator.h>

#include <array>
#include <memory>

namespace ThermoContact
{
  /**
   * A linear system of SystemCoefficients, made for many right-hand sides. Rows
   * of constrained degrees of freedom say that the unknown vanishes.
   *
   * There are three ways to solve it. The blocks along a rod in one process are
   * eliminated one after the other; sparse factors (KLU) are for all other
   * bodies that have matrices, for rods whose blocks grow on the way, and for
   * those with a diagonal; bodies without matrices have conjugate gradients
   * with the diagonal, for systems of one field. The fields of a system are one
   * matrix if each acts on the other; if the displacement does not act on the
   * temperature, the rows of heat are solved first.
   *
   * The sum of a mass and a stiffness has the mass to the last digit of the
   * stiffness alone, 1e-14 of it with 250 cells: as if a friction were there,
   * which adds up over the steps. Stages of a rod by sparse factors are
   * therefore corrected once by the residual, in which no sum is formed.
   */
  template <int dim>
  class LinearSystem
  {
  public:
    /** The rows that are solved for; unknowns of all others are zero. */
    enum class Rows
    {
      all,
      off_contact ///< without displacements along x of the contact nodes
    };

    /**
     * @param equations borrowed
     * @param coefficients of the system; without matrices those of one field
     * @param diagonal added to the heat block; null: none
     * @param rows off_contact: of bodies without matrices alone
     * @throw ComputationError if a matrix cannot be factorised
     */
    LinearSystem(const ThermoviscoelasticOperator<dim> &equations,
                 const SystemCoefficients              &coefficients,
                 const Vector                          *diagonal = nullptr,
                 const Rows                             rows     = Rows::all);

    /**
     * Solves for the fields of the system; vectors of the other field are not
     * used.
     *
     * @param heat,momentum the right-hand side, zero in constrained rows; both
     *   may be changed
     * @param temperature,displacement out: the solution, e.g. $\theta'$, $v$
     * @throw ComputationError if an iteration does not converge
     */
    void
    solve(Vector &heat,
          Vector &momentum,
          Vector &temperature,
          Vector &displacement);

    /** The same for a system of one field. */
    void
    solve(Vector &solution, const Vector &rhs) const
    {
      solve_field(own_field(), solution, rhs);
    }

    /** Number of matrices that were factorised. */
    unsigned int
    n_factorizations() const
    {
      return inverse_diagonal.size() > 0 ? 0 :
             is_whole()                  ? 1 :
                          has(Field::temperature) + has(Field::displacement);
    }

    /**
     * How much the blocks of a rod would have grown that was left to sparse
     * factors; 0: it was not.
     */
    double
    refused_growth() const
    {
      return refused_growth_;
    }

    /** The product of conjugate gradients. */
    void
    vmult(Vector &y, const Vector &x) const;

  private:
    const ThermoviscoelasticOperator<dim> &equations;
    const SystemCoefficients               coefficients;
    const Rows                             rows;
    const double                           scale; ///< $\tau$ of a stage
    Vector                                 diagonal;
    double                                 refused_growth_ = 0.;
    bool                                   is_corrected;

    // the whole of it, or for each field; of a rod, sparse, or neither
    std::unique_ptr<const RodFactors<2>>                rod_whole;
    std::array<std::unique_ptr<const RodFactors<1>>, 2> rod_fields;
    std::unique_ptr<DirectSolver>                       whole;
    std::array<std::unique_ptr<DirectSolver>, 2>        fields;
    Vector                                              inverse_diagonal;

    SystemVector system_rhs, system_solution;
    Vector       heat_residual, heat_correction;
    Vector       momentum_residual, momentum_correction;

    bool
    has(const Field::Block field) const
    {
      return coefficients.has(field) && equations.space().has_field(field);
    }

    /** Of a system of one field. */
    Field::Block
    own_field() const
    {
      return has(Field::temperature) ? Field::temperature : Field::displacement;
    }

    /** Each of its fields acts on the other. */
    bool
    is_whole() const
    {
      return coefficients.heating != 0. && equations.is_coupled();
    }

    bool
    is_along_rod() const
    {
      return rod_whole || rod_fields[0] || rod_fields[1];
    }

    /** False if blocks grow: nothing is factorised then. */
    bool
    factorize_rod();

    void
    factorize_sparse();

    void
    set_inverse_diagonal();

    void
    solve_field(const Field::Block field,
                Vector            &solution,
                const Vector      &rhs) const;

    /** solve() without correction. */
    void
    solve_once(Vector &heat,
               Vector &momentum,
               Vector &temperature,
               Vector &displacement);
  };
} // namespace ThermoContact

#endif
