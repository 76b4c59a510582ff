// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef thermocontact_space_linear_system_h
#define thermocontact_space_linear_system_h

#include <thermocontact/base/tolerances.h>
#include <thermocontact/rod/rod_factors.h>
#include <thermocontact/space/direct_solver.h>
#include <thermocontact/space/flexible_gmres.h>
#include <thermocontact/space/system_coefficients.h>
#include <thermocontact/space/thermoviscoelastic_operator.h>

#include <deal.II/lac/full_matrix.h>

#include <array>
#include <cmath>
#include <memory>
#include <optional>
#include <vector>

namespace ThermoContact
{
  /** About the inverses of the blocks of a system without factors, symmetric.
   */
  class Preconditioner
  {
  public:
    virtual ~Preconditioner() = default;

    /** Makes the preconditioners of the blocks of a stage of this length anew,
     * without springs, as in a run that is resumed. */
    virtual void
    make(const double tau) = 0;

    /** As LinearSystem::set_springs(). */
    virtual void
    set_springs(const std::vector<double> &springs) = 0;

    virtual void
    vmult(const Field::Block field, Vector &z, const Vector &r) const = 0;

    /** Number of factors or preconditioners made so far. */
    virtual unsigned int
    n_made() const = 0;

    /** Unknowns of the coarsest level of the larger field. */
    virtual types::global_dof_index
    n_factorized_unknowns() const = 0;
  };



  /**
   * A linear system of SystemCoefficients, made for many right-hand sides. Rows
   * of constrained degrees of freedom say that the unknown vanishes.
   *
   * The blocks along a rod in one process are eliminated one after the other;
   * sparse factors (KLU) are for all other bodies that have matrices, for rods
   * whose blocks grow on the way, and for those with a diagonal; bodies without
   * matrices have Krylov's methods, GMRES for a stage and conjugate gradients
   * for one field. The rows of the contact end have a full inverse if there are
   * matrices.
   *
   * The fields of a system are one matrix if each acts on the other; if the
   * displacement does not act on the temperature, the rows of heat are solved
   * first. Where heat does not flow, full inverses and conjugate gradients
   * solve for the displacement of a system of both fields, with the temperature
   * eliminated: $E+c_hc_s/h_m\,a^2D^TM^{-1}D$.
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
      contact_end ///< displacements along x of all nodes of the contact end
    };

    /**
     * @param equations borrowed
     * @param coefficients of the system; of the contact end and for conjugate
     *   gradients those of one field, or of both without conduction
     * @param diagonal added to the heat block; null: none
     * @param preconditioner of iterations, borrowed; null: the diagonal, with
     *   which there are conjugate gradients alone
     * @throw ComputationError if a matrix cannot be factorised
     */
    LinearSystem(const ThermoviscoelasticOperator<dim> &equations,
                 const SystemCoefficients              &coefficients,
                 const Vector                          *diagonal = nullptr,
                 const Rows                             rows     = Rows::all,
                 Preconditioner *preconditioner                  = nullptr);

    /** The same of equations that it takes over, such as tangents. */
    LinearSystem(std::unique_ptr<const ThermoviscoelasticOperator<dim>> own,
                 const SystemCoefficients &coefficients,
                 const Rows                rows = Rows::all);

    const ThermoviscoelasticOperator<dim> &
    of_equations() const
    {
      return equations;
    }

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
          Vector &displacement) const;

    /**
     * The same for a system of one field, or for the displacement alone of one
     * of both, on which no heat acts but that of the motion.
     *
     * @param solution out
     * @param rhs zero in constrained rows and those that are not solved for
     * @param tolerance residual that iterations may leave, as a part of what
     *   relaxed springs leave of @p rhs
     */
    void
    solve(Vector       &solution,
          const Vector &rhs,
          const double  tolerance = Tolerances::rounding_of_solution) const;

    /** It is solved to rounding at once, and has no springs. */
    bool
    has_factors() const
    {
      return equations.cell_products() == nullptr;
    }

    /**
     * Adds springs to the rows of the contact nodes in a system of the
     * displacement, or of both fields, that has no factors; with factors there
     * are none.
     *
     * @param new_springs stiffness; infinite: the node is held; empty: there
     *   are none, in a system of one field
     * @param new_relaxed values at which they have no force
     */
    void
    set_springs(const std::vector<double> &new_springs,
                const std::vector<double> &new_relaxed);

    /** Heat leaves at the contact nodes, by rows; for GMRES. Empty: none. */
    void
    set_conductance(const std::vector<double> &new_conductance);

    /** @p left = @p rhs - A @p solution, without springs. */
    void
    residual(Vector &left, const Vector &solution, const Vector &rhs) const;

    /** How residuals of both fields are measured, row by row, (D8.4). */
    struct Weights
    {
      BlockVector weights;
      BlockVector inverses;
    };

    /** The work of GMRES. */
    struct Iterations
    {
      unsigned int n        = 0;
      double       residual = 0.; ///< weighted
      bool         is_rounding =
        false; ///< the residual is above the tolerance, and nothing but that
    };

    /**
     * Solves for both fields from the present solution on by GMRES,
     * preconditioned from the right by blocks, the temperature first (D8.2).
     *
     * @param solution in: where to start, held nodes where they are held
     * @param rhs without springs
     * @param tolerance of the weighted residual; rounding may leave more
     * @param is_relative the tolerance is one of the first residual
     * @throw ComputationError if there are too many iterations, or if rounding
     *   leaves more than Tolerances::loose_residual
     */
    Iterations
    solve(BlockVector       &solution,
          const BlockVector &rhs,
          const Weights     &weights,
          const double       tolerance,
          const bool         is_relative);

    /** Residuals are computed anew: solution or right-hand side is another. */
    void
    restart();

    /** The right-hand side less the product with the solution, without springs.
     */
    const BlockVector &
    left(const BlockVector &solution, const BlockVector &rhs);

    /** $-c_h/h_m\,aM^{-1}Du$, the temperature that is eliminated. */
    void
    heat_of_motion(Vector &temperature, const Vector &displacement) const;

    /** Diagonal of a system that has no factors, without springs. */
    const Vector &
    row_diagonal() const;

    /** Residual of iterations that solve to rounding, as of solve(). */
    double
    tolerance() const
    {
      return heat ? Tolerances::adiabatic_residual :
                    Tolerances::rounding_of_solution;
    }

    /** Of conjugate gradients so far. */
    unsigned int
    n_iterations() const
    {
      return n_iterations_;
    }

    /** Number of solves for heat by which the inverse was made. */
    unsigned int
    n_responses() const
    {
      return heat ? inverse.m() : 0;
    }

    /** Number of matrices that were factorised. */
    unsigned int
    n_factorizations() const
    {
      return heat ? heat->system->n_factorizations() :
             !has_factors() || inverse.m() > 0 ? 0 :
             is_whole()                        ? 1 :
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
    std::unique_ptr<const ThermoviscoelasticOperator<dim>> own; ///< or null
    const ThermoviscoelasticOperator<dim>                 &equations;
    const SystemCoefficients                               coefficients;
    const Rows                                             rows;
    /** $\sqrt{c_s/c_h}$: $\tau$ of a stage for $(\theta',v)$. */
    const double          scale;
    std::optional<Vector> diagonal;
    double                refused_growth_ = 0.;

    /** The block of heat at once, whose unknowns are eliminated. */
    struct Elimination
    {
      std::unique_ptr<const LinearSystem<dim>> system;
      Vector                                   sources;
      Vector                                   temperature;
    };

    std::unique_ptr<Elimination> heat; ///< or null

    /** A matrix of both fields, and vectors of its numbering. */
    struct Whole
    {
      DirectSolver factors;
      SystemVector rhs;
      SystemVector solution;
    };

    // the whole of it, or for each field; of a rod, sparse, or neither
    std::unique_ptr<const RodFactors<2>>                rod_whole;
    std::array<std::unique_ptr<const RodFactors<1>>, 2> rod_fields;
    std::unique_ptr<Whole>                              whole;
    std::array<std::unique_ptr<DirectSolver>, 2>        fields;
    FullMatrix<double>                                  inverse;

    // of iterations
    Preconditioner *const         preconditioner;
    mutable std::optional<Vector> matrix_diagonal;  ///< made when needed
    std::vector<double>           springs, relaxed; ///< of the contact nodes
    std::vector<double>           conductance;      ///< of them; empty: none
    mutable unsigned int          n_iterations_ = 0;

    /** Of GMRES. */
    struct Krylov
    {
      FlexibleGmres gmres{60};
      BlockVector   left; ///< without springs
      BlockVector   scaled;
      BlockVector   correction;
      bool          has_left         = false;
      double        largest_residual = 0.; ///< at a start, since restart()
    };

    std::unique_ptr<Krylov> krylov;

    /** Of solutions that are corrected by their residuals. */
    struct Correction
    {
      Vector heat_residual, heat;
      Vector momentum_residual, momentum;
    };

    std::unique_ptr<Correction> correction; ///< or null

    bool
    has(const Field::Block field) const
    {
      return coefficients.has(field) && equations.space().has_field(field);
    }

    /** Of a system of one field, or with the other one eliminated. */
    Field::Block
    own_field() const
    {
      return has(Field::displacement) ? Field::displacement :
                                        Field::temperature;
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

    /** A contact node that a spring of infinite stiffness holds. */
    bool
    is_held(const unsigned int node) const
    {
      return std::isinf(springs[node]);
    }

    /** False if blocks grow: nothing is factorised then. */
    bool
    factorize_rod();

    void
    factorize_sparse();

    /** Of the contact end. */
    void
    invert();

    /** Sets unknowns that are not solved for to zero. */
    void
    restrict_rows(Vector &vector) const;

    /** @p y = A @p x, of the rows that are solved for, without springs. */
    void
    product(Vector &y, const Vector &x) const;

    void
    solve_field(const Field::Block field,
                Vector            &solution,
                const Vector      &rhs,
                const double       tolerance) const;

    /** The product of GMRES without springs. */
    void
    apply(BlockVector &y, const BlockVector &x) const;

    /** The force of the spring of a row at this value. */
    double
    spring_force(const unsigned int node, const double value) const
    {
      return springs[node] * (value - relaxed[node]);
    }

    /**
     * Residual with springs, weighted.
     *
     * @return the part of its norm by rounding of springs
     */
    double
    compute_scaled(const BlockVector &solution,
                   const BlockVector &rhs,
                   const Weights     &weights);

    /** Improves the solution until the estimate of GMRES is small enough. */
    FlexibleGmres::Result
    add_correction(BlockVector   &solution,
                   const Weights &weights,
                   const double   tolerance);

    [[noreturn]] void
    give_up(const double       residual,
            const double       tolerance,
            const unsigned int n_iterations) const;

    class WeightedMatrix;
    class WeightedPreconditioner;

    void
    solve_by_iterations(const Field::Block field,
                        Vector            &solution,
                        const Vector      &rhs,
                        const double       tolerance) const;

    /** solve() without correction. */
    void
    solve_once(Vector &heat,
               Vector &momentum,
               Vector &temperature,
               Vector &displacement) const;
  };
} // namespace ThermoContact

#endif
