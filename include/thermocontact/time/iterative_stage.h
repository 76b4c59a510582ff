// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef thermocontact_time_iterative_stage_h
#define thermocontact_time_iterative_stage_h

#include <thermocontact/contact/interface_problem.h>
#include <thermocontact/multigrid/stage_hierarchies.h>
#include <thermocontact/space/body.h>
#include <thermocontact/time/flexible_gmres.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <vector>

namespace ThermoContact
{
  /**
   * The linear system of a stage of a large body whose contact nodes meet
   * straight lines, doc/discretisation.md (D8.1), (D8.2), (D8.3), (D8.4),
   * (C2.10). Those with a compliance add springs to the diagonal of (D2.2), a
   * rigid one prescribes the velocity that ends at it. GMRES, preconditioned
   * from the right by one V-cycle for each field, the temperature first, solves
   * it from the present solution on.
   */
  template <int dim>
  class IterativeStage
  {
  public:
    /**
     * @param body borrowed; it has no matrices
     * @param warnings of residuals that rounding holds above the tolerance are
     *   appended to; borrowed
     */
    IterativeStage(const Body<dim> &body, std::vector<std::string> &warnings);

    /** The preconditioners of the stage lengths used last. */
    StageHierarchies<dim> &
    preconditioners()
    {
      return hierarchies;
    }

    const StageHierarchies<dim> &
    preconditioners() const
    {
      return hierarchies;
    }

    /**
     * A new stage; its solution starts at the velocity at its beginning.
     *
     * @param pressure that is expected: residuals are compared to the forces
     *   that are left beside it
     * @param with_heat false: the temperature stays as it is
     */
    void
    prepare(const State               &known,
            const double               stage_length,
            const Vector              &heat_load,
            const Vector              &momentum_load,
            const std::vector<double> &pressure,
            const bool                 with_heat);

    /**
     * Instead of a new stage what pressures at the contact nodes alone do.
     * Of the length of the present stage.
     */
    void
    prepare_pressures();

    /**
     * Heat leaves through the contact nodes with these $k_i$ beside that of the
     * matrices, (C5.2). None does until it is called.
     */
    void
    set_exchange(const std::vector<double> &coefficient);

    /**
     * What the laws of the contact nodes are relations of:
     * $x=x_{start}+f\,v$. All are open until set_laws().
     */
    void
    set_interface(const std::vector<double> &start, const double factor);

    /**
     * Receptances of the contact nodes alone, loss of x per unit pressure, by
     * the diagonal of (D2.2).
     */
    std::vector<double>
    receptances() const;

    /** Puts springs and held nodes in place. */
    void
    set_laws(const std::vector<AffineLaw> &new_laws);

    /** What residuals are compared to: terms of the stage, or the first one. */
    enum class Measure
    {
      of_terms,
      of_start
    };

    /**
     * Makes the preconditioners of a stage length again.
     *
     * @param last_contact of StageHierarchies::Hierarchy
     */
    void
    restore(const double stage_length, const std::vector<double> &last_contact);

    /**
     * Solves for the present set.
     *
     * @param tolerance relative residual, (D8.4); what rounding leaves may be
     *   more
     * @return number of iterations
     * @throw ComputationError if there are too many, or if rounding leaves more
     *   than 1e-5
     */
    unsigned int
    solve(const double tolerance, const Measure measure = Measure::of_terms);

    /** Pressures of the solution, 0 at open nodes; (C2.10). */
    void
    get_pressures(std::vector<double> &pressure);

    /** x of the contact nodes at the end of the stage. */
    void
    get_positions(std::vector<double> &position) const;

    /** $\tau\theta'$ or $v$. */
    const Vector &
    unknowns(const Field::Block field) const
    {
      return solution.block(field);
    }

    /** What is left of the rows (D8.1), without contact. */
    const Vector &
    unsolved(const Field::Block field) const
    {
      return residual.block(field);
    }

    /** $\tau$ of the present stage. */
    double
    length() const
    {
      return tau;
    }

    /** The largest residual that was warned of. */
    double
    told_rounding() const
    {
      return told_rounding_;
    }

    /** Warns of twice as much only. */
    void
    has_told(const double rounding)
    {
      told_rounding_ = rounding;
    }

  private:
    const Body<dim>          &body;
    std::vector<std::string> &warnings;
    StageHierarchies<dim>     hierarchies;

    SystemCoefficients     coefficients;
    double                 tau      = 0.;
    bool                   has_heat = true;      ///< its temperature is unknown
    double                 factor   = 0.;        ///< f of set_interface()
    std::vector<double>    start;                ///< x with $v=0$
    std::vector<AffineLaw> laws;                 ///< of the contact nodes
    std::vector<double>    springs;              ///< of rows of (D2.2)
    std::vector<double>    conductance;          ///< $\tau wk$; empty: none
    std::vector<double>    excess_temperature;   ///< of nodes at the beginning
    BlockVector            rhs;                  ///< without contact
    BlockVector            solution;             ///< $(\tau\theta',v)$
    BlockVector            residual;             ///< without contact
    bool                   has_residual = false; ///< it is that of the solution
    BlockVector            weights;              ///< of the residuals
    BlockVector            inverse_weights;
    BlockVector            correction;
    BlockVector            scaled_residual;

    FlexibleGmres krylov;

    double largest_residual = 0.; ///< of the present stage, at the start
    double told_rounding_   = 0.;

    /** Local rows of contact nodes without mass; empty: none, or all are. */
    std::vector<bool> massless_rows;

    bool
    is_massless(const unsigned int row) const
    {
      return !massless_rows.empty() && massless_rows[row];
    }

    /** The obstacle of a node is rigid, its velocity prescribed. */
    bool
    is_held(const unsigned int node) const
    {
      return std::isinf(springs[node]);
    }

    bool
    has_contact() const;

    /** The velocity at which the pressure of a node is 0. */
    double
    touching_velocity(const unsigned int node) const
    {
      return (laws[node].offset - start[node]) / factor;
    }

    /** The force of a row at this velocity, $\tau w p$ of (C2.10). */
    double
    spring_force(const unsigned int node, const double v) const
    {
      return springs[node] * (v - touching_velocity(node));
    }

    /**
     * Makes residuals relative, doc/discretisation.md (D8.4): one over the root
     * of the diagonal and over the size of the terms.
     */
    void
    set_weights(const State &known, const std::vector<double> &pressure);

    void
    set_heat_weights(const State &known);

    void
    set_momentum_weights(const State               &known,
                         const std::vector<double> &pressure);

    /** Rows with mass, and those of contact nodes without it among them. */
    using Sizes = std::array<double, 2>;

    double largest_diagonal = 0.; ///< of the momentum block

    /**
     * Norms of a vector of momentum rows over the roots of the diagonal,
     * (D8.4). A force at nodes without mass moves the others through them, too.
     */
    Sizes
    momentum_sizes(const Vector &rows) const;

    /** @p y = the matrix of the stage without contact times @p x. */
    void
    apply(BlockVector &y, const BlockVector &x) const;

    /** If it is not there. */
    void
    compute_residual();

    /**
     * The residual of the present set, with contact and scaled.
     *
     * @return what rounding of springs contributes to its norm
     */
    double
    compute_scaled_residual();

    /** Improves the solution until the estimate of GMRES is small enough. */
    FlexibleGmres::Result
    add_correction(const double tolerance);

    [[noreturn]] void
    give_up(const double       residual,
            const double       tolerance,
            const unsigned int n_iterations) const;

    class Matrix;
    class Preconditioner;
  };
} // namespace ThermoContact

#endif
