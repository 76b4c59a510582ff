// SPDX-License-Identifier: LGPL-2.1-or-later

#include <thermocontact/multigrid/chebyshev_smoother.h>

#include <deal.II/lac/diagonal_matrix.h>
#include <deal.II/lac/precondition.h>

namespace ThermoContact
{
  namespace
  {
    /** The largest eigenvalue of smoothing over the smallest. */
    constexpr double smoothing_range = 15.;

    constexpr unsigned int n_estimate_iterations = 12;
  } // namespace



  template <int dim, typename Number>
  ChebyshevSmoother<dim, Number>::ChebyshevSmoother(
    const StageBlock<dim, Number> &block,
    const unsigned int             degree)
    : block(block)
    , degree(degree)
  {
    update_diagonal();
  }



  template <int dim, typename Number>
  void
  ChebyshevSmoother<dim, Number>::update_diagonal()
  {
    inverse_diagonal = block.make_vector();
    copy_values(inverse_diagonal, block.diagonal());
    for (Number &value : inverse_diagonal)
      value = 1 / value;
    block.zero_prescribed(inverse_diagonal);
  }



  template <int dim, typename Number>
  void
  ChebyshevSmoother<dim, Number>::estimate_eigenvalue()
  {
    using Diagonal = DiagonalMatrix<LevelVector<Number>>;
    using Estimate = PreconditionChebyshev<StageBlock<dim, Number>,
                                           LevelVector<Number>,
                                           Diagonal>;
    typename Estimate::AdditionalData data;
    data.smoothing_range              = smoothing_range;
    data.eig_cg_n_iterations          = n_estimate_iterations;
    data.preconditioner               = std::make_shared<Diagonal>();
    data.preconditioner->get_vector() = inverse_diagonal;
    Estimate estimate;
    estimate.initialize(block, data);
    const double largest =
      estimate.estimate_eigenvalues(inverse_diagonal).max_eigenvalue_estimate;
    theta = 0.5 * (largest + largest / smoothing_range);
    delta = 0.5 * (largest - largest / smoothing_range);
  }



  template <int dim, typename Number>
  void
  ChebyshevSmoother<dim, Number>::advance(LevelVector<Number>       &x,
                                          const LevelVector<Number> &b,
                                          const Work                &work,
                                          const double               of_update,
                                          const double of_residual) const
  {
    block.vmult(work.product, x);
    const Number *__restrict product = work.product.begin();
    const Number *__restrict rhs     = b.begin();
    const Number *__restrict inverse = inverse_diagonal.begin();
    Number *__restrict update        = work.update.begin();
    Number *__restrict values        = x.begin();
    const Number       f_update = of_update, f_residual = of_residual;
    const unsigned int n = x.locally_owned_size();
    if (f_update == 0)
      for (unsigned int i = 0; i < n; ++i)
        {
          update[i] = f_residual * inverse[i] * (rhs[i] - product[i]);
          values[i] += update[i];
        }
    else
      for (unsigned int i = 0; i < n; ++i)
        {
          update[i] = f_update * update[i] +
                      f_residual * inverse[i] * (rhs[i] - product[i]);
          values[i] += update[i];
        }
  }



  template <int dim, typename Number>
  void
  ChebyshevSmoother<dim, Number>::go_on(LevelVector<Number>       &x,
                                        const LevelVector<Number> &b,
                                        const Work                &work) const
  {
    double rho = delta / theta;
    for (unsigned int k = 1; k < degree; ++k)
      {
        const double next = 1. / (2. * theta / delta - rho);
        advance(x, b, work, next * rho, 2. * next / delta);
        rho = next;
      }
  }



  template <int dim, typename Number>
  void
  ChebyshevSmoother<dim, Number>::smooth_zero(LevelVector<Number>       &x,
                                              const LevelVector<Number> &b,
                                              const Work &work) const
  {
    const Number *__restrict rhs     = b.begin();
    const Number *__restrict inverse = inverse_diagonal.begin();
    Number *__restrict update        = work.update.begin();
    Number *__restrict values        = x.begin();
    const Number       factor        = 1. / theta;
    const unsigned int n             = x.locally_owned_size();
    for (unsigned int i = 0; i < n; ++i)
      values[i] = update[i] = factor * inverse[i] * rhs[i];
    go_on(x, b, work);
  }



  template <int dim, typename Number>
  void
  ChebyshevSmoother<dim, Number>::smooth(LevelVector<Number>       &x,
                                         const LevelVector<Number> &b,
                                         const Work                &work) const
  {
    advance(x, b, work, 0., 1. / theta);
    go_on(x, b, work);
  }



  template class ChebyshevSmoother<2, float>;
  template class ChebyshevSmoother<2, double>;
  template class ChebyshevSmoother<3, float>;
  template class ChebyshevSmoother<3, double>;
} // namespace ThermoContact
