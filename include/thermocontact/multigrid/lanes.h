// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef thermocontact_multigrid_lanes_h
#define thermocontact_multigrid_lanes_h

#include <array>

namespace ThermoContact
{
  namespace internal
  {
    template <typename Number>
    struct LanesData;

    template <>
    struct LanesData<float>
    {
      typedef float Type __attribute__((vector_size(16), may_alias));
    };

    template <>
    struct LanesData<double>
    {
      typedef double Type __attribute__((vector_size(16), may_alias));
    };
  } // namespace internal



  /**
   * 16 bytes of numbers that one instruction treats together: what every
   * processor of 64 bits has, so that programs run on all of them.
   */
  template <typename Number>
  struct Lanes
  {
    static constexpr unsigned int n_lanes = 16 / sizeof(Number);

    typename internal::LanesData<Number>::Type data;

    /** A view of numbers that are aligned to 16 bytes. */
    static const Lanes *
    in(const Number *numbers)
    {
      return reinterpret_cast<const Lanes *>(numbers);
    }

    Lanes &
    operator+=(const Lanes other)
    {
      data += other.data;
      return *this;
    }

    Lanes &
    operator*=(const Lanes other)
    {
      data *= other.data;
      return *this;
    }

    friend Lanes
    operator+(Lanes a, const Lanes b)
    {
      return a += b;
    }

    friend Lanes
    operator*(Lanes a, const Lanes b)
    {
      return a *= b;
    }

    friend Lanes
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



  /** Numbers of values in a line along the body and across it. */
  using LineSizes = std::array<int, 2>;

  /** Matrices for the lines along the body and across it. */
  template <typename Number>
  using LineMatrices = std::array<const Lanes<Number> *, 2>;



  /**
   * Applies a matrix to all lines of values of a cell along a direction.
   *
   * @tparam n_along,n_across lines have that many values; 0: @p sizes
   * @tparam add to @p y, which may else be @p x
   * @param matrices row by row, their entries the same in all lanes
   */
  template <int  dim,
            int  direction,
            int  n_along,
            int  n_across,
            bool add,
            typename Number>
  inline __attribute__((always_inline)) void
  apply_along(const LineMatrices<Number> &matrices,
              const Lanes<Number>        *x,
              Lanes<Number>              *y,
              const LineSizes            &sizes)
  {
    constexpr int max_values = 31; // of the largest degree, 30
    constexpr int n_static   = direction == 0 ? n_along : n_across;
    const int     along      = n_along > 0 ? n_along : sizes[0];
    const int     across     = n_across > 0 ? n_across : sizes[1];
    const int     n          = direction == 0 ? along : across;
    const int     stride =
      direction == 0 ? 1 : along * power_of(across, direction - 1);
    const int            n_blocks = power_of(across, dim - 1 - direction);
    const Lanes<Number> *matrix   = matrices[direction > 0];
    Lanes<Number>        line[n_static > 0 ? n_static : max_values];
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



  /** The matrices along all directions, in place. */
  template <int dim, int n_along, int n_across, typename Number>
  inline __attribute__((always_inline)) void
  apply_along_all(const LineMatrices<Number> &matrices,
                  Lanes<Number>              *x,
                  const LineSizes            &sizes)
  {
    apply_along<dim, 0, n_along, n_across, false>(matrices, x, x, sizes);
    apply_along<dim, 1, n_along, n_across, false>(matrices, x, x, sizes);
    if constexpr (dim == 3)
      apply_along<dim, 2, n_along, n_across, false>(matrices, x, x, sizes);
  }



  /** Derivatives of the values @p x along all directions. */
  template <int dim, int n_along, int n_across, typename Number>
  inline __attribute__((always_inline)) void
  differentiate(const LineMatrices<Number>             &matrices,
                const Lanes<Number>                    *x,
                const std::array<Lanes<Number> *, dim> &derivatives,
                const LineSizes                        &sizes)
  {
    apply_along<dim, 0, n_along, n_across, false>(matrices,
                                                  x,
                                                  derivatives[0],
                                                  sizes);
    apply_along<dim, 1, n_along, n_across, false>(matrices,
                                                  x,
                                                  derivatives[1],
                                                  sizes);
    if constexpr (dim == 3)
      apply_along<dim, 2, n_along, n_across, false>(matrices,
                                                    x,
                                                    derivatives[2],
                                                    sizes);
  }



  /** Adds the transpose of differentiate() to @p x. */
  template <int dim, int n_along, int n_across, typename Number>
  inline __attribute__((always_inline)) void
  add_transposed(const LineMatrices<Number>             &transposed,
                 const std::array<Lanes<Number> *, dim> &derivatives,
                 Lanes<Number>                          *x,
                 const LineSizes                        &sizes)
  {
    apply_along<dim, 0, n_along, n_across, true>(transposed,
                                                 derivatives[0],
                                                 x,
                                                 sizes);
    apply_along<dim, 1, n_along, n_across, true>(transposed,
                                                 derivatives[1],
                                                 x,
                                                 sizes);
    if constexpr (dim == 3)
      apply_along<dim, 2, n_along, n_across, true>(transposed,
                                                   derivatives[2],
                                                   x,
                                                   sizes);
  }
} // namespace ThermoContact

#endif
