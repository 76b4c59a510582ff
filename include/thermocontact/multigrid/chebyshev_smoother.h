// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef thermocontact_multigrid_chebyshev_smoother_h
#define thermocontact_multigrid_chebyshev_smoother_h

#include <thermocontact/multigrid/stage_block.h>

#include <optional>

namespace ThermoContact
{
  /**
   * Chebyshev polynomials in a StageBlock with its diagonal, or of
   * displacements with its LevelSubspaces, for the upper part of the spectrum
   * (Adams, Brezina, Hu and Tuminaro 2003): the iteration of
   * PreconditionChebyshev. Vectors are zero at prescribed degrees of freedom.
   */
  template <int dim, typename Number>
  class ChebyshevSmoother
  {
  public:
    /**
     * @param block borrowed
     * @param degree steps of a smoothing
     * @param range the largest eigenvalue of smoothing over the smallest
     */
    ChebyshevSmoother(const StageBlock<dim, Number> &block,
                      const unsigned int             degree,
                      const double                   range);

    /** Takes the diagonal or subspaces that the block has at present. */
    void
    update_diagonal();

    /** Estimates the largest eigenvalue of the present block. Collective. */
    void
    estimate_eigenvalue();

    /** Vectors to work with. */
    struct Work
    {
      LevelVector<Number> &product;
      LevelVector<Number> &update;
    };

    /** @param from_zero or from @p x */
    void
    smooth(LevelVector<Number>       &x,
           const LevelVector<Number> &b,
           const Work                &work,
           const bool                 from_zero) const;

  private:
    const StageBlock<dim, Number> &block;
    const unsigned int             degree;
    const double                   range;
    LevelVector<Number>            inverse_diagonal; ///< 0: prescribed; or
    std::optional<SubspaceFactors<dim, Number>> subspaces;
    double                                      theta = 1., delta = 0.;

    /** A residual becomes that over the diagonal or in the subspaces. */
    void
    precondition(LevelVector<Number> &residual) const;

    /** One step, with the factors of the last update and of the residual. */
    void
    advance(LevelVector<Number>       &x,
            const LevelVector<Number> &b,
            const Work                &work,
            const double               of_update,
            const double               of_residual) const;
  };
} // namespace ThermoContact

#endif
