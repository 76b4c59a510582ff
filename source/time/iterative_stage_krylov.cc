// SPDX-License-Identifier: LGPL-2.1-or-later

#include <thermocontact/base/exceptions.h>
#include <thermocontact/base/number_text.h>
#include <thermocontact/base/text.h>
#include <thermocontact/time/iterative_stage.h>

namespace ThermoContact
{
  namespace
  {
    constexpr unsigned int max_iterations = 300;
  } // namespace



  /** The stage matrix with contact, rows scaled. */
  template <int dim>
  class IterativeStage<dim>::Matrix
  {
  public:
    explicit Matrix(const IterativeStage &stage)
      : stage(stage)
    {}

    void
    vmult(BlockVector &y, const BlockVector &x) const
    {
      stage.apply(y, x);
      Vector       &y_u = y.block(Field::displacement);
      const Vector &x_u = x.block(Field::displacement);
      for (const auto &[node, entry] :
           stage.body.contact_end().entries(Field::displacement))
        if (stage.is_active[node])
          {
            if (stage.contact.held.size() > 0)
              y_u.local_element(entry) = x_u.local_element(entry);
            else
              y_u.local_element(entry) +=
                stage.contact.springs.local_element(entry) *
                x_u.local_element(entry);
          }
      y.scale(stage.weights);
    }

  private:
    const IterativeStage &stage;
  };



  /** V-cycles, the temperature first; rows scaled back. */
  template <int dim>
  class IterativeStage<dim>::Preconditioner
  {
  public:
    /** @param scratch of the layout of the unknowns; both are borrowed */
    Preconditioner(const IterativeStage &stage, BlockVector &scratch)
      : stage(stage)
      , rhs(scratch.block(Field::displacement))
      , heat_rhs(scratch.block(Field::temperature))
    {}

    void
    vmult(BlockVector &z, const BlockVector &r) const
    {
      const auto &hierarchy = stage.hierarchies.current();
      const bool  has_heat  = hierarchy.heat && stage.has_heat;
      Vector     &z_theta   = z.block(Field::temperature);
      if (has_heat)
        {
          heat_rhs.copy_locally_owned_data_from(r.block(Field::temperature));
          heat_rhs.scale(stage.inverse_weights.block(Field::temperature));
          hierarchy.heat->vmult(z_theta, heat_rhs);
        }
      else
        z_theta = 0.;
      if (!hierarchy.momentum)
        return;
      rhs.copy_locally_owned_data_from(r.block(Field::displacement));
      rhs.scale(stage.inverse_weights.block(Field::displacement));
      if (has_heat)
        {
          stage.body.equations.add_thermal_stress(z_theta, stage.tau, rhs);
          // held rows keep their residual, which is zero
          for (const auto &[node, entry] :
               stage.body.contact_end().entries(Field::displacement))
            if (stage.is_active[node] && stage.contact.held.size() > 0)
              rhs.local_element(entry) = 0.;
        }
      hierarchy.momentum->vmult(z.block(Field::displacement), rhs);
    }

  private:
    const IterativeStage &stage;
    Vector               &rhs;
    Vector               &heat_rhs;
  };



  template <int dim>
  unsigned int
  IterativeStage<dim>::add_correction(const double tolerance)
  {
    has_residual = false; // its place is used
    const FlexibleGmres::Result result =
      krylov.solve(Matrix(*this),
                   Preconditioner(*this, residual),
                   tolerance,
                   max_iterations,
                   scaled_residual,
                   correction);
    if (!(result.residual <= tolerance))
      give_up(result.residual, tolerance, result.n_iterations);
    solution += correction;
    return result.n_iterations;
  }



  template <int dim>
  void
  IterativeStage<dim>::give_up(const double       residual,
                               const double       tolerance,
                               const unsigned int n_iterations) const
  {
    throw ComputationError(
      text("the iterative solver reached a relative residual of ",
           significant(residual, few_digits),
           " instead of ",
           significant(tolerance, few_digits),
           " in ",
           n_iterations,
           " iterations, for a stage of length ",
           significant(tau, few_digits),
           "\n  remedy:  Solver/Linear solver = direct, a larger "
           "Solver/Linear tolerance, cells that are cubes, a larger "
           "Contact/Compliance, or a Model/Poisson ratio farther from 1/2"));
  }



  template unsigned int
  IterativeStage<2>::add_correction(const double);
  template unsigned int
  IterativeStage<3>::add_correction(const double);
  template void
  IterativeStage<2>::give_up(const double,
                             const double,
                             const unsigned int) const;
  template void
  IterativeStage<3>::give_up(const double,
                             const double,
                             const unsigned int) const;
} // namespace ThermoContact
