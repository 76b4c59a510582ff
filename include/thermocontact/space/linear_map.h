// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef thermocontact_space_linear_map_h
#define thermocontact_space_linear_map_h

#include <thermocontact/base/types.h>
#include <thermocontact/rod/rod_matrices.h>

#include <functional>
#include <utility>

namespace ThermoContact
{
  /**
   * A linear map between vectors of fields, whether it is a matrix or computed
   * cell by cell. Knows nothing of constraints.
   */
  class LinearMap
  {
  public:
    virtual ~LinearMap() = default;

    /** @p y $=A$ @p x; the layouts are those of its rows and columns. */
    virtual void
    vmult(Vector &y, const Vector &x) const = 0;

    /**
     * $x\cdot Ax$ of a symmetric map.
     *
     * @param product scratch of the layout of @p x
     */
    virtual double
    form(const Vector &x, Vector &product) const
    {
      vmult(product, x);
      return x * product;
    }

    /**
     * $(x-y)\cdot A(x-y)$ of a symmetric map.
     *
     * @param difference,product scratch of the layout of @p x
     */
    virtual double
    form_of_difference(const Vector &x,
                       const Vector &y,
                       Vector       &difference,
                       Vector       &product) const
    {
      difference = x;
      difference -= y;
      return form(difference, product);
    }
  };



  /** A matrix, which is borrowed. */
  class MatrixMap : public LinearMap
  {
  public:
    explicit MatrixMap(const SparseMatrix &matrix)
      : matrix(matrix)
    {}

    void
    vmult(Vector &y, const Vector &x) const override
    {
      matrix.vmult(y, x);
    }

  private:
    const SparseMatrix &matrix;
  };



  /** A matrix of a rod, which is borrowed. */
  class RodMap : public LinearMap
  {
  public:
    RodMap(const RodMatrices &matrices, const RodMatrices::Matrix matrix)
      : matrices(matrices)
      , matrix(matrix)
    {}

    void
    vmult(Vector &y, const Vector &x) const override
    {
      matrices.combine<1>({{{1., matrix, x.begin()}}}, 0., nullptr, y.begin());
    }

    double
    form(const Vector &x, Vector &) const override
    {
      return matrices.form(matrix, x.begin());
    }

    double
    form_of_difference(const Vector &x,
                       const Vector &y,
                       Vector &,
                       Vector &) const override
    {
      return matrices.form_of_difference(matrix, x.begin(), y.begin());
    }

  private:
    const RodMatrices        &matrices;
    const RodMatrices::Matrix matrix;
  };



  /** A function that computes the product. */
  class FunctionMap : public LinearMap
  {
  public:
    using Product = std::function<void(Vector &, const Vector &)>;

    explicit FunctionMap(Product product)
      : product(std::move(product))
    {}

    void
    vmult(Vector &y, const Vector &x) const override
    {
      product(y, x);
    }

  private:
    const Product product;
  };
} // namespace ThermoContact

#endif
