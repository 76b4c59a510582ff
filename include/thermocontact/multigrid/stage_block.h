// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef thermocontact_multigrid_stage_block_h
#define thermocontact_multigrid_stage_block_h

#include <thermocontact/multigrid/band_factors.h>
#include <thermocontact/multigrid/multigrid_levels.h>

#include <memory>
#include <optional>
#include <utility>
#include <vector>

namespace ThermoContact
{
  /** The degrees of freedom at the contact end that a stage changes. */
  struct ContactRows
  {
    /** Added to the diagonal: springs of an elastic obstacle; or empty. */
    Vector springs;

    /** 1 where a rigid obstacle prescribes the velocity, else 0; or empty. */
    Vector held;
  };



  /**
   * The block of one field of the stage matrix (D2.2) on one level, without
   * matrix, over a scale: $M+\tau(K+kB)$ or $bM_u+\tau\zeta S_\zeta+\tau^2S$,
   * with springs at contact nodes.
   * On coarser levels the heat exchange is springs, too. Prescribed degrees of
   * freedom are left out: vectors are zero there, and so are products.
   */
  template <int dim, typename Number>
  class StageBlock
  {
  public:
    /** @param levels borrowed */
    StageBlock(const MultigridLevels<dim, Number> &levels,
               const unsigned int                  level,
               const Field::Block                  field,
               const double                        tau,
               const double                        scale = 1.);

    void
    vmult(LevelVector<Number> &y, const LevelVector<Number> &x) const;

    /**
     * Diagonal, 1 for prescribed ones; without stiffness, as SubspaceFactors
     * need it, Tolerances::stiffest_spring for these.
     */
    Vector
    diagonal(const bool has_stiffness = true) const;

    LevelVector<Number>
    make_vector() const
    {
      return levels.products(level).make_vector(field);
    }

    /** The factors of displacements, not yet made. */
    std::optional<SubspaceFactors<dim, Number>>
    subspace_factors() const;

    /** On the coarsest level, 1 on the diagonal for prescribed ones. */
    std::unique_ptr<const BandFactors>
    factors() const;

    /** Takes over springs and held nodes of this level. */
    void
    set_contact(const ContactRows &rows);

    /** Zero for all prescribed degrees of freedom. */
    template <typename AnyNumber>
    void
    zero_prescribed(LevelVector<AnyNumber> &vector) const
    {
      for (const unsigned int entry : prescribed)
        vector.local_element(entry) = 0.;
    }

  private:
    const MultigridLevels<dim, Number> &levels;
    const unsigned int                  level;
    const Field::Block                  field;
    const double                        mass;      ///< factor of $M$, $M_u$
    const double                        stiffness; ///< of $K+kB$, $S$
    const double                        scale;
    std::vector<unsigned int>           prescribed; ///< local entries

    /** Local entries with the stiffness of their springs, over the scale. */
    std::vector<std::pair<unsigned int, Number>> springs;

    /** To a product with zeros there and with no springs so far. */
    template <typename AnyNumber>
    void
    complete(LevelVector<AnyNumber> &y, const LevelVector<AnyNumber> &x) const
    {
      for (const auto &[entry, spring] : springs)
        y.local_element(entry) += spring * x.local_element(entry);
      zero_prescribed(y);
    }
  };
} // namespace ThermoContact

#endif
