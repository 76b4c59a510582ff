// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef thermocontact_space_linear_map_h
#define thermocontact_space_linear_map_h

#include <thermocontact/base/types.h>

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
