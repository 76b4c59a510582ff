// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef thermocontact_multigrid_stage_hierarchies_h
#define thermocontact_multigrid_stage_hierarchies_h

#include <thermocontact/multigrid/stage_factors.h>
#include <thermocontact/multigrid/stage_multigrid.h>

#include <array>
#include <limits>
#include <list>
#include <memory>
#include <vector>

namespace ThermoContact
{
  /**
   * The preconditioners of both fields for the stage lengths that were used
   * last: step sizes come back. V-cycles, or factors of the body for stages
   * that are not shorter than the first one for which factorise() was called:
   * the longer a stage, the less inertia helps.
   */
  template <int dim>
  class StageHierarchies
  {
  public:
    /** @param body borrowed */
    explicit StageHierarchies(const Body<dim> &body);

    const MultigridLevels<dim, float> &
    levels() const
    {
      return levels_;
    }

    /** Factors for the present stage length and longer ones. */
    void
    factorise();

    /** Whether the present stage length has factors. */
    bool
    has_factors() const
    {
      return !hierarchies.empty() && current().tau >= shortest_factorised_;
    }

    /** The shortest stage with factors; infinite: V-cycles for all. */
    double
    shortest_factorised() const
    {
      return shortest_factorised_;
    }

    /** Rows of the largest matrix that has factors. */
    types::global_dof_index
    n_factorized_unknowns() const;

    /** The preconditioners for a stage length; null: no such field. */
    struct Hierarchy
    {
      double                               tau;
      std::unique_ptr<StagePreconditioner> heat;
      std::unique_ptr<StagePreconditioner> momentum;
      std::array<Vector, 2>                diagonals; ///< of the blocks

      /** Contact nodes that the momentum block has springs or holds at. */
      std::vector<bool> active_set;

      /** The last of these sets that had nodes, whose factors are kept. */
      std::vector<bool> last_contact;
    };

    /** Makes those of a stage length current. */
    void
    provide(const double tau);

    /** Gives the current momentum block the contact rows of a set of nodes. */
    void
    set_contact(const std::vector<bool> &active_set, const ContactRows &rows);

    /**
     * What has been made so far: preconditioners of stage lengths and, for sets
     * of contact nodes, their coarsest levels.
     */
    unsigned int
    n_made() const
    {
      return n_made_;
    }

    const Hierarchy &
    current() const
    {
      return hierarchies.front();
    }

    /** Those that are there, the current one in front. */
    const std::list<Hierarchy> &
    all() const
    {
      return hierarchies;
    }

    /** Forgets them, and has factors for stages of that length and longer. */
    void
    clear(const double shortest_factorised)
    {
      hierarchies.clear();
      shortest_factorised_ = shortest_factorised;
    }

  private:
    const Body<dim>                         &body;
    const MultigridLevels<dim, float>        levels_;
    std::unique_ptr<const BodyMatrices<dim>> matrices; ///< once needed
    std::list<Hierarchy>                     hierarchies;
    unsigned int                             n_made_ = 0;
    double shortest_factorised_ = std::numeric_limits<double>::infinity();
  };
} // namespace ThermoContact

#endif
