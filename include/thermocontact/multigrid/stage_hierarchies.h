// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef thermocontact_multigrid_stage_hierarchies_h
#define thermocontact_multigrid_stage_hierarchies_h

#include <thermocontact/multigrid/stage_multigrid.h>

#include <array>
#include <list>
#include <memory>
#include <vector>

namespace ThermoContact
{
  /**
   * The preconditioners of both fields for the stage lengths that were used
   * last: step sizes come back.
   */
  template <int dim>
  class StageHierarchies
  {
  public:
    /** @param levels borrowed */
    explicit StageHierarchies(const MultigridLevels<dim> &levels);

    /** The preconditioners for a stage length; null: no such field. */
    struct Hierarchy
    {
      double                               tau;
      std::unique_ptr<StageMultigrid<dim>> heat;
      std::unique_ptr<StageMultigrid<dim>> momentum;
      std::array<Vector, 2>                diagonals; ///< of the blocks

      /** Contact nodes that the momentum block has springs or holds at. */
      std::vector<bool> active_set;
    };

    /**
     * Makes those of a stage length current.
     *
     * @return true if they had to be made
     */
    bool
    provide(const double tau);

    const Hierarchy &
    current() const
    {
      return hierarchies.front();
    }

    /** Gives the current momentum block the contact rows of a set of nodes. */
    void
    set_contact(const std::vector<bool> &active_set, const ContactRows &rows);

    /** Stage lengths that are there, the current one in front. */
    std::vector<double>
    lengths() const;

    void
    clear()
    {
      hierarchies.clear();
    }

  private:
    const MultigridLevels<dim> &levels;
    std::list<Hierarchy>        hierarchies;
  };
} // namespace ThermoContact

#endif
