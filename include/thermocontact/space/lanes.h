// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef thermocontact_space_lanes_h
#define thermocontact_space_lanes_h

#include <array>
#include <cstring>
#include <type_traits>

namespace ThermoContact
{
  namespace internal
  {
    template <typename Number>
    struct LanesData;

    template <>
    struct LanesData<float>
    {
      typedef float Type
        __attribute__((vector_size(THERMOCONTACT_LANE_BYTES), may_alias));
    };

    template <>
    struct LanesData<double>
    {
      typedef double Type
        __attribute__((vector_size(THERMOCONTACT_LANE_BYTES), may_alias));
    };
  } // namespace internal



  /**
   * Numbers that one instruction treats together: 32 bytes of them, or 16,
   * which every processor of 64 bits has (CMakeLists.txt). Functions are
   * inlined without optimisation, too: sources for different processors are
   * linked.
   */
  template <typename Number>
  struct Lanes
  {
    static constexpr unsigned int n_lanes =
      THERMOCONTACT_LANE_BYTES / sizeof(Number);

    typename internal::LanesData<Number>::Type data;

    /** A view of numbers that are aligned to as many bytes. */
    static const Lanes *
    in(const Number *numbers)
    {
      return reinterpret_cast<const Lanes *>(numbers);
    }

    /** From numbers that may begin anywhere. */
    [[gnu::always_inline]] static Lanes
    load(const Number *numbers)
    {
      Lanes lanes;
      std::memcpy(&lanes.data, numbers, sizeof(lanes.data));
      return lanes;
    }

    [[gnu::always_inline]] void
    store(Number *numbers) const
    {
      std::memcpy(numbers, &data, sizeof(data));
    }

    [[gnu::always_inline]] static Lanes
    all(const Number number)
    {
      return {typename internal::LanesData<Number>::Type{} + number};
    }

    [[gnu::always_inline]] Lanes &
    operator+=(const Lanes other)
    {
      data += other.data;
      return *this;
    }

    [[gnu::always_inline]] Lanes &
    operator*=(const Lanes other)
    {
      data *= other.data;
      return *this;
    }

    [[gnu::always_inline]] friend Lanes
    operator+(Lanes a, const Lanes b)
    {
      return a += b;
    }

    [[gnu::always_inline]] friend Lanes
    operator*(Lanes a, const Lanes b)
    {
      return a *= b;
    }

    [[gnu::always_inline]] friend Lanes
    operator*(const Lanes a, const Number b)
    {
      return {a.data * b};
    }
  };



  constexpr int
  power_of(const int base, const int exponent)
  {
    return exponent <= 0 ? 1 : base * power_of(base, exponent - 1);
  }



  /**
   * Applies a matrix to all lines of values of a cell along a direction.
   *
   * @tparam n_static lines have that many values; 0: @p n_values
   * @tparam add to @p y, which may else be @p x
   * @param matrix row by row, its entries the same in all lanes
   */
  template <int dim, int direction, int n_static, bool add, typename Number>
  inline __attribute__((always_inline)) void
  apply_along(const Lanes<Number> *matrix,
              const Lanes<Number> *x,
              Lanes<Number>       *y,
              const int            n_values)
  {
    constexpr int max_values = 31; // of the largest degree, 30
    const int     n          = n_static > 0 ? n_static : n_values;
    const int     stride     = power_of(n, direction);
    const int     n_blocks   = power_of(n, dim - 1 - direction);
    Lanes<Number> line[n_static > 0 ? n_static : max_values];
    for (int block = 0; block < n_blocks; ++block)
      for (int inner = 0; inner < stride; ++inner)
        {
          const int first = block * n * stride + inner;
          for (int j = 0; j < n; ++j)
            line[j] = x[first + j * stride];
          for (int i = 0; i < n; ++i)
            {
              Lanes<Number> sum = matrix[i * n] * line[0];
              for (int j = 1; j < n; ++j)
                sum += matrix[i * n + j] * line[j];
              if (add)
                y[first + i * stride] += sum;
              else
                y[first + i * stride] = sum;
            }
        }
  }



  /** The same matrix along all directions, in place. */
  template <int dim, int n_static, typename Number>
  inline __attribute__((always_inline)) void
  apply_along_all(const Lanes<Number> *matrix, Lanes<Number> *x, const int n)
  {
    apply_along<dim, 0, n_static, false>(matrix, x, x, n);
    apply_along<dim, 1, n_static, false>(matrix, x, x, n);
    if constexpr (dim == 3)
      apply_along<dim, 2, n_static, false>(matrix, x, x, n);
  }



  /** Calls @p act with 0 to @p n - 1, at most 2, known when compiling. */
  template <int n, typename Act>
  inline __attribute__((always_inline)) void
  along_all(const Act &act)
  {
    act(std::integral_constant<int, 0>());
    if constexpr (n > 1)
      act(std::integral_constant<int, 1>());
    if constexpr (n > 2)
      act(std::integral_constant<int, 2>());
  }



  /** Derivatives of the values @p x along all directions. */
  template <int dim, int n_static, typename Number>
  inline __attribute__((always_inline)) void
  differentiate(const Lanes<Number>                    *matrix,
                const Lanes<Number>                    *x,
                const std::array<Lanes<Number> *, dim> &derivatives,
                const int                               n)
  {
    apply_along<dim, 0, n_static, false>(matrix, x, derivatives[0], n);
    apply_along<dim, 1, n_static, false>(matrix, x, derivatives[1], n);
    if constexpr (dim == 3)
      apply_along<dim, 2, n_static, false>(matrix, x, derivatives[2], n);
  }



  /** Adds the transpose of differentiate() to @p x. */
  template <int dim, int n_static, typename Number>
  inline __attribute__((always_inline)) void
  add_transposed(const Lanes<Number>                    *transposed,
                 const std::array<Lanes<Number> *, dim> &derivatives,
                 Lanes<Number>                          *x,
                 const int                               n)
  {
    apply_along<dim, 0, n_static, true>(transposed, derivatives[0], x, n);
    apply_along<dim, 1, n_static, true>(transposed, derivatives[1], x, n);
    if constexpr (dim == 3)
      apply_along<dim, 2, n_static, true>(transposed, derivatives[2], x, n);
  }
} // namespace ThermoContact

#endif
