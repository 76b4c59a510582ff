// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef thermocontact_space_linear_map_h
#define thermocontact_space_linear_map_h

#include <thermocontact/base/types.h>
#include <thermocontact/rod/rod_matrices.h>

#include <functional>

namespace ThermoContact
{
  /**
   * A linear map between vectors of fields, whether it is a matrix or computed
   * cell by cell. Knows nothing of constraints.
   */
  struct LinearMap
  {
    /** @p y $=A$ @p x; the layouts are those of its rows and columns. */
    std::function<void(Vector &y, const Vector &x)> vmult;

    /** @p y $+=$ @p factor $Ax$; @p product is scratch of the layout of y. */
    void
    add(const double factor, const Vector &x, Vector &y, Vector &product) const
    {
      if (own_add)
        return own_add(factor, x, y);
      vmult(product, x);
      y.add(factor, product);
    }

    /** Computes $(x-y)\cdot A(x-y)$ with more digits, y may be null; else
     * empty. */
    std::function<double(const Vector &x, const Vector *y)> own_form = nullptr;

    /** add() without scratch, which costs as much memory traffic again; else
     * empty. */
    std::function<void(const double factor, const Vector &x, Vector &y)>
      own_add = nullptr;

    /** Its name among those of RodMatrices, if it is the map of a rod. */
    FieldMatrix::Kind of_rod = FieldMatrix::n_matrices;

    /**
     * $(x-y)\cdot A(x-y)$ of a symmetric map.
     *
     * @param y null: zero
     * @param difference,product scratch of the layout of @p x
     */
    double
    form(const Vector &x,
         const Vector *y,
         Vector       &difference,
         Vector       &product) const
    {
      if (own_form)
        return own_form(x, y);
      if (y != nullptr)
        {
          difference = x;
          difference -= *y;
        }
      const Vector &argument = y != nullptr ? difference : x;
      vmult(product, argument);
      return argument * product;
    }
  };
} // namespace ThermoContact

#endif
