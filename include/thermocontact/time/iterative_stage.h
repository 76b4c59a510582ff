// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef thermocontact_time_iterative_stage_h
#define thermocontact_time_iterative_stage_h

#include <thermocontact/contact/interface_problem.h>
#include <thermocontact/multigrid/stage_hierarchies.h>
#include <thermocontact/space/body.h>
#include <thermocontact/time/flexible_gmres.h>

#include <array>
#include <string>
#include <utility>
#include <vector>

namespace ThermoContact
{
  /**
   * The linear system of a stage of a large body for a given set of nodes in
   * contact, doc/discretisation.md (D8.1), (D8.2), (D8.3), (D8.4), (C2.9). An
   * elastic obstacle adds springs to the diagonal of (D2.2), a rigid one
   * prescribes the velocity that ends at it. GMRES, preconditioned from the
   * right by one V-cycle for each field, the temperature first, solves it from
   * the present solution on.
   */
  template <int dim>
  class IterativeStage
  {
  public:
    /** @param body borrowed; it has no matrices */
    explicit IterativeStage(const Body<dim> &body);

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
     * Instead of a new stage the displacement $\tau v$ and what goes with it,
     * by pressures at the active nodes alone: at a rigid obstacle it is given
     * there, at an elastic one pressures resist what it lacks, (C3.2). Of the
     * length of the present stage.
     *
     * @param displacement at the contact nodes
     */
    void
    prepare_displacement(const std::vector<double> &displacement);

    /** Takes the place of what contact nodes meet, and of where they start. */
    void
    set_laws(const std::vector<NodeLaw> &new_laws,
             const std::vector<double>  &new_start)
    {
      laws  = new_laws;
      start = new_start;
    }

    void
    set_laws(const std::vector<NodeLaw> &new_laws)
    {
      laws = new_laws;
    }

    const std::vector<NodeLaw> &
    contact_laws() const
    {
      return laws;
    }

    /** Receptances of the contact nodes alone, by the diagonal of (D2.2). */
    std::vector<double>
    receptances() const;

    /** Puts springs and held nodes of the branches in place. */
    void
    set_branches(const std::vector<int> &branch);

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
    restore(const double stage_length, const std::vector<bool> &last_contact);

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

    /** Pressures of the solution at the active nodes, else 0; (C2.9). */
    void
    get_pressures(std::vector<double> &pressure);

    /** Positions of the contact nodes at the end of the stage. */
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

    /**
     * What the user is to know since the last call: residuals that rounding
     * holds above the tolerance.
     */
    std::vector<std::string>
    take_warnings()
    {
      return std::exchange(warnings, {});
    }

  private:
    const Body<dim>      &body;
    StageHierarchies<dim> hierarchies;

    double               tau      = 0.;
    bool                 has_heat = true; ///< its temperature is unknown
    std::vector<NodeLaw> laws;
    std::vector<double>  start;             ///< positions at the beginning
    std::vector<int>     branch;            ///< at the end
    std::vector<double>  known_penetration; ///< of its obstacle, (C6.5)
    std::vector<bool>    is_active;
    ContactRows          contact;
    BlockVector          rhs;                  ///< without contact
    BlockVector          solution;             ///< $(\tau\theta',v)$
    BlockVector          residual;             ///< without contact
    bool                 has_residual = false; ///< it is that of the solution
    BlockVector          weights;              ///< of the residuals
    BlockVector          inverse_weights;
    BlockVector          correction;
    BlockVector          scaled_residual;

    FlexibleGmres krylov;

    double largest_residual = 0.; ///< of the present stage, at the start
    double told_rounding    = 0.; ///< the largest one warned of

    std::vector<std::string> warnings;

    /** Local rows of contact nodes without mass; empty: none, or all are. */
    std::vector<bool> massless_rows;

    bool
    is_massless(const unsigned int row) const
    {
      return !massless_rows.empty() && massless_rows[row];
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

    /** Norms of a vector of momentum rows over the roots of the diagonal. */
    Sizes
    momentum_sizes(const Vector &rows) const;

    /** Springs and held nodes, and preconditioners that heed them. */
    void
    set_rows(const std::vector<bool> &is_active);

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
