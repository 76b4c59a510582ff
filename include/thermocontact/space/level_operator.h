// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef thermocontact_space_level_operator_h
#define thermocontact_space_level_operator_h

#include <thermocontact/base/types.h>

#include <algorithm>

namespace ThermoContact
{
  /** Components of a field of a body: 1 of the temperature, dim of the
   * displacement. */
  template <int dim>
  constexpr unsigned int
  n_components(const Field::Block field)
  {
    return field == Field::temperature ? 1 : dim;
  }



  /** A vector of one field on a level of a V-cycle. */
  template <typename Number>
  using LevelVector = LinearAlgebra::distributed::Vector<Number>;

  /** The same values, owned ones alone, as numbers of another type. */
  template <typename To, typename From>
  void
  copy_values(LevelVector<To> &to, const LevelVector<From> &from)
  {
    std::copy(from.begin(), from.end(), to.begin());
  }



  /** Products with the stage matrices of one level. */
  template <typename Number>
  class LevelOperator
  {
  public:
    virtual ~LevelOperator() = default;

    /** A vector of zeros with the ghosts that products need. */
    virtual LevelVector<Number>
    make_vector(const Field::Block field) const = 0;

    /**
     * @p y = (@p mass M + @p stiffness K) @p x, or with $M_u$ and $S$; of a
     * body with the heat exchange, (K + kB + L). Without constraints.
     * Collective.
     */
    virtual void
    vmult(const Field::Block         field,
          const double               mass,
          const double               stiffness,
          LevelVector<Number>       &y,
          const LevelVector<Number> &x) const = 0;

    /** Of the matrix of vmult(). Collective. */
    virtual LevelVector<Number>
    diagonal(const Field::Block field,
             const double       mass,
             const double       stiffness) const = 0;
  };
} // namespace ThermoContact

#endif
