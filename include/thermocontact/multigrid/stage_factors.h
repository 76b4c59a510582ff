// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef thermocontact_multigrid_stage_factors_h
#define thermocontact_multigrid_stage_factors_h

#include <thermocontact/multigrid/stage_preconditioner.h>
#include <thermocontact/space/direct_solver.h>
#include <thermocontact/space/thermoviscoelastic_operator.h>

#include <memory>

namespace ThermoContact
{
  /** Expected of the factors of a body of degree 2 in 2-D or 3-D; measured. */
  double
  factor_bytes(const double n_unknowns, const unsigned int dim);



  /** The matrices of a body that has none, on the same mesh. */
  template <int dim>
  class BodyMatrices
  {
  public:
    explicit BodyMatrices(const Body<dim> &body);

    const ThermoviscoelasticOperator<dim> &
    operator_with_matrices() const
    {
      return equations;
    }

  private:
    const Scene                           scene;
    const Discretization<dim>             discretization;
    const ThermoviscoelasticOperator<dim> equations;
  };



  /** Sparse factors, for bodies whose V-cycles do not converge. */
  template <int dim>
  class StageFactors : public StagePreconditioner
  {
  public:
    /** @throw ComputationError if the matrix cannot be factorised */
    StageFactors(const BodyMatrices<dim> &matrices,
                 const Field::Block       field,
                 const double             tau);

    /** As StageMultigrid, keeps factors without contact and of the last rows.
     */
    void
    set_contact(const ContactRows *rows,
                const bool         are_as_before = false) override;

    void
    vmult(Vector &z, const Vector &r) const override;

  private:
    std::unique_ptr<DirectSolver> without_contact;
    std::unique_ptr<DirectSolver> with_contact; ///< last rows
    bool                          has_contact = false;
  };
} // namespace ThermoContact

#endif
