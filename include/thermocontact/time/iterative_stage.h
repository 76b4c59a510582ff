// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef thermocontact_time_iterative_stage_h
#define thermocontact_time_iterative_stage_h

#include <thermocontact/multigrid/stage_hierarchies.h>
#include <thermocontact/space/body.h>
#include <thermocontact/space/linear_system.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <string>
#include <vector>

namespace ThermoContact
{
  /**
   * A stage of a large body, doc/discretisation.md (D8.1), (D8.2), (D8.3),
   * (D8.4): the right-hand side of its LinearSystem and how residuals are
   * weighted. V-cycles are the preconditioner.
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
     */
    void
    prepare(const State               &known,
            const double               stage_length,
            const Vector              &heat_load,
            const Vector              &momentum_load,
            const std::vector<double> &pressure);

    /**
     * Instead of a new stage what pressures at the contact nodes alone do.
     * Of the length of the present stage.
     */
    void
    prepare_pressures();

    /** Adds pressures on the contact nodes, which are open, to the loads of the
     * stage: forces() and unsolved() have them from now on. */
    void
    push(const std::vector<double> &pressure);

    /**
     * Heat leaves through the contact nodes with these $k_i$ beside that of the
     * matrices, (C5.2). Before it is called no heat leaves so.
     */
    void
    set_exchange(const std::vector<double> &coefficient);

    /** What the law of the exchange is told of the nodes as they are. */
    std::vector<ExchangeConditions>
    conditions() const;

    /** Springs of the contact nodes, LinearSystem::set_springs(). */
    void
    set_springs(const std::vector<double> &springs,
                const std::vector<double> &relaxed);

    /** Scale of residuals: terms of the stage, or the first residual. */
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
     * @param tolerance relative residual, (D8.4); rounding may leave more
     * @return number of iterations
     * @throw ComputationError if there are too many, or if rounding leaves more
     *   than 1e-5
     */
    unsigned int
    solve(const double tolerance, const Measure kind = Measure::of_terms);

    /** $\tau\theta'$ or $v$. */
    const Vector &
    unknowns(const Field::Block field) const
    {
      return solution.block(field);
    }

    /** To be changed by contact. */
    Vector &
    velocity()
    {
      return solution.block(Field::displacement);
    }

    /** Right-hand side of its rows, without springs. */
    const Vector &
    forces() const
    {
      return rhs.block(Field::displacement);
    }

    /** The residual of the rows (D8.1), without contact. */
    const Vector &
    unsolved(const Field::Block field) const
    {
      return system->left(solution, rhs).block(field);
    }

    /** $\tau$ of the present stage. */
    double
    length() const
    {
      return tau;
    }

    /** The largest residual that was warned of. */
    double
    reported_rounding() const
    {
      return reported_rounding_;
    }

    /** The next warning is of more than twice as much. */
    void
    set_reported_rounding(const double rounding)
    {
      reported_rounding_ = rounding;
    }

  private:
    const Body<dim>          &body;
    std::vector<std::string> &warnings;
    StageHierarchies<dim>     hierarchies;

    double                             tau = 0.;
    std::unique_ptr<LinearSystem<dim>> system; ///< of this length

    std::vector<double> conductance;        ///< $\tau wk$; empty: none
    std::vector<double> excess_temperature; ///< of nodes at the beginning
    double              load_time = 0.;     ///< of the stage
    BlockVector         rhs;                ///< without springs
    BlockVector         solution;           ///< $(\tau\theta',v)$

    typename LinearSystem<dim>::Weights measure; ///< of the residuals

    double reported_rounding_ = 0.;

    /** Local rows of contact nodes without mass; empty: none, or all are. */
    std::vector<bool> massless_rows;

    bool
    is_massless(const unsigned int row) const
    {
      return !massless_rows.empty() && massless_rows[row];
    }

    /** Makes the system and the preconditioners of a stage length. */
    void
    provide(const double stage_length);

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

    /** Makes residuals of the momentum relative to sizes; 0 both: they stay. */
    void
    set_momentum_size(const Sizes &sizes);

    bool has_momentum_size = false;

    double largest_diagonal = 0.; ///< of the momentum block

    /**
     * Norms of a vector of momentum rows over the roots of the diagonal,
     * (D8.4). A force at nodes without mass moves the others through them, too.
     */
    Sizes
    momentum_sizes(const Vector &rows) const;
  };
} // namespace ThermoContact

#endif
