// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef thermocontact_multigrid_stage_hierarchies_h
#define thermocontact_multigrid_stage_hierarchies_h

#include <thermocontact/base/recently_used.h>
#include <thermocontact/multigrid/stage_multigrid.h>
#include <thermocontact/space/linear_system.h>

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
  class StageHierarchies : public Preconditioner
  {
  public:
    /** @param body borrowed */
    explicit StageHierarchies(const Body<dim> &body);

    const MultigridLevels<dim, float> &
    levels() const
    {
      return levels_;
    }

    /** The preconditioners for a stage length; null: no such field. */
    struct Hierarchy
    {
      double                                      tau;
      std::unique_ptr<StageMultigrid<dim, float>> heat;
      std::unique_ptr<StageMultigrid<dim, float>> momentum;
      std::array<Vector, 2>                       diagonals; ///< of the blocks

      /** Springs of the contact nodes that the momentum block has. */
      std::vector<double> springs;

      /** The last that were not all zero, whose factors are kept. */
      std::vector<double> last_contact;
    };

    /** Makes the hierarchy of a stage length current. */
    void
    provide(const double tau);

    void
    make(const double tau) override
    {
      clear();
      provide(tau);
    }

    /**
     * Gives the current momentum block springs at the contact nodes, added to
     * its diagonal; infinite ones hold a node. Of the same nodes it keeps those
     * that it has while none is half or twice as stiff.
     */
    void
    set_springs(const std::vector<double> &springs) override;

    /** The current V-cycle of a field. */
    void
    vmult(const Field::Block field, Vector &z, const Vector &r) const override
    {
      const Hierarchy &cycles = current();
      (field == Field::temperature ? cycles.heat : cycles.momentum)
        ->vmult(z, r);
    }

    /**
     * All made so far: preconditioners of stage lengths and, for sets of
     * contact nodes, their coarsest levels.
     */
    unsigned int
    n_made() const override
    {
      return n_made_;
    }

    types::global_dof_index
    n_factorized_unknowns() const override;

    const Hierarchy &
    current() const
    {
      return hierarchies.front();
    }

    /** All hierarchies, the current one in front. */
    const std::list<Hierarchy> &
    all() const
    {
      return hierarchies.all();
    }

    /** How many are kept. */
    static constexpr unsigned int
    most_kept()
    {
      return 4;
    }

    void
    clear()
    {
      hierarchies.clear();
    }

  private:
    const Body<dim>                  &body;
    const MultigridLevels<dim, float> levels_;
    RecentlyUsed<Hierarchy>           hierarchies;
    unsigned int                      n_made_ = 0;
  };
} // namespace ThermoContact

#endif
