// SPDX-License-Identifier: LGPL-2.1-or-later

#include <thermocontact/base/tolerances.h>
#include <thermocontact/multigrid/chebyshev_smoother.h>

#include <deal.II/lac/tridiagonal_matrix.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace ThermoContact
{
  namespace
  {
    constexpr unsigned int n_estimate_iterations = 12;

    /** Of an estimate, which is from below. */
    constexpr double safety = 1.2;



    /** Of a symmetric tridiagonal matrix; 1 if it is empty. */
    double
    largest_eigenvalue(const std::vector<double> &diagonal,
                       const std::vector<double> &off_diagonal)
    {
      if (diagonal.empty())
        return 1.;
      TridiagonalMatrix<double> matrix(diagonal.size(), true);
      for (unsigned int i = 0; i < diagonal.size(); ++i)
        {
          matrix(i, i) = diagonal[i];
          if (i + 1 < diagonal.size())
            matrix(i, i + 1) = off_diagonal[i];
        }
      matrix.compute_eigenvalues();
      return matrix.eigenvalue(diagonal.size() - 1);
    }
  } // namespace



  template <int dim, typename Number>
  ChebyshevSmoother<dim, Number>::ChebyshevSmoother(
    const StageBlock<dim, Number> &block,
    const unsigned int             degree,
    const double                   range)
    : block(block)
    , degree(degree)
    , range(range)
    , subspaces(block.subspace_factors())
  {
    update_diagonal();
  }



  template <int dim, typename Number>
  void
  ChebyshevSmoother<dim, Number>::update_diagonal()
  {
    if (subspaces)
      {
        subspaces->update(block.diagonal(false));
        return;
      }
    inverse_diagonal = block.make_vector();
    copy_values(inverse_diagonal, block.diagonal());
    for (Number &value : inverse_diagonal)
      value = 1 / value;
    block.zero_prescribed(inverse_diagonal);
  }



  template <int dim, typename Number>
  void
  ChebyshevSmoother<dim, Number>::precondition(
    LevelVector<Number> &residual) const
  {
    if (subspaces)
      subspaces->apply(residual);
    else
      residual.scale(inverse_diagonal);
  }



  template <int dim, typename Number>
  void
  ChebyshevSmoother<dim, Number>::estimate_eigenvalue()
  {
    // conjugate gradients, which find the ends of the spectrum first; they end
    // at the rounding of Number, where a block is next to its diagonal
    LevelVector<Number> r(block.make_vector()), z(r), p(r), product(r);
    const auto          first = r.get_partitioner()->local_range().first;
    for (unsigned int i = 0; i < r.locally_owned_size(); ++i)
      r.local_element(i) = Number((first + i) % 11) - 5;
    block.zero_prescribed(r);
    z = r;
    precondition(z);
    p                            = z;
    double              rz       = r * z;
    const double        smallest = Tolerances::rounding_of_single_squares * rz;
    std::vector<double> diagonal, off_diagonal;
    double              beta_over_alpha = 0.;
    while (diagonal.size() < n_estimate_iterations && rz > smallest)
      {
        block.vmult(product, p);
        const double alpha = rz / (p * product);
        r.add(-alpha, product);
        z = r;
        precondition(z);
        const double next = r * z, beta = next / rz;
        diagonal.push_back(1. / alpha + beta_over_alpha);
        off_diagonal.push_back(std::sqrt(std::max(beta, 0.)) / alpha);
        beta_over_alpha = beta / alpha;
        rz              = next;
        p.sadd(beta, z);
      }
    const double largest = safety * largest_eigenvalue(diagonal, off_diagonal);
    theta                = 0.5 * (largest + largest / range);
    delta                = 0.5 * (largest - largest / range);
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
    if (subspaces)
      {
        work.product.sadd(-1., b);
        subspaces->apply(work.product);
      }
    const Number *__restrict product = work.product.begin();
    const Number *__restrict rhs     = b.begin();
    const Number *__restrict inverse = inverse_diagonal.begin();
    Number *__restrict update        = work.update.begin();
    Number *__restrict values        = x.begin();
    const Number       f_update = of_update, f_residual = of_residual;
    const bool         is_done = subspaces.has_value();
    const unsigned int n       = x.locally_owned_size();
    for (unsigned int i = 0; i < n; ++i)
      {
        // the first update may be anything
        update[i] = (f_update == 0 ? 0 : f_update * update[i]) +
                    f_residual * (is_done ? product[i] :
                                            inverse[i] * (rhs[i] - product[i]));
        values[i] += update[i];
      }
  }



  template <int dim, typename Number>
  void
  ChebyshevSmoother<dim, Number>::smooth(LevelVector<Number>       &x,
                                         const LevelVector<Number> &b,
                                         const Work                &work,
                                         const bool from_zero) const
  {
    if (from_zero)
      {
        work.update = b;
        precondition(work.update);
        work.update *= 1. / theta;
        x = work.update;
      }
    else
      advance(x, b, work, 0., 1. / theta);
    double rho = delta / theta;
    for (unsigned int k = 1; k < degree; ++k)
      {
        const double next = 1. / (2. * theta / delta - rho);
        advance(x, b, work, next * rho, 2. * next / delta);
        rho = next;
      }
  }



  template class ChebyshevSmoother<2, float>;
  template class ChebyshevSmoother<2, double>;
  template class ChebyshevSmoother<3, float>;
  template class ChebyshevSmoother<3, double>;
} // namespace ThermoContact
