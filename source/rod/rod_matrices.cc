// SPDX-License-Identifier: LGPL-2.1-or-later

#include <thermocontact/rod/fixed_degree.h>
#include <thermocontact/rod/rod_matrices.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace ThermoContact
{
  namespace
  {
    /** To a part of the largest entry of each matrix. */
    bool
    are_equal(const double      *a,
              const double      *b,
              const unsigned int n_entries,
              const double       tolerance)
    {
      for (unsigned int matrix = 0; matrix < RodMatrices::n_matrices;
           ++matrix, a += n_entries, b += n_entries)
        {
          double largest = 0.;
          for (unsigned int i = 0; i < n_entries; ++i)
            largest = std::max(largest, std::abs(b[i]));
          for (unsigned int i = 0; i < n_entries; ++i)
            if (!(std::abs(a[i] - b[i]) <= tolerance * largest))
              return false;
        }
      return true;
    }



    /**
     * Whether each row of the entries without the others adds up to what
     * rounding leaves of zero. Others that are larger than what remains do not:
     * a rod whose end has the temperature of the obstacle would exchange the
     * rounding of that of the vertex behind it.
     */
    bool
    rows_add_up_to_zero(const double      *entries,
                        const double      *others,
                        const unsigned int n)
    {
      double largest_sum = 0., largest = 0., largest_other = 0.;
      for (unsigned int i = 0; i < n; ++i)
        {
          double sum = 0.;
          for (unsigned int entry = i; entry < n * n; entry += n)
            {
              const double rest = entries[entry] - others[entry];
              sum += rest;
              largest       = std::max(largest, std::abs(rest));
              largest_other = std::max(largest_other, std::abs(others[entry]));
            }
          largest_sum = std::max(largest_sum, std::abs(sum));
        }
      return largest_other <= largest &&
             largest_sum <= n * n * std::numeric_limits<double>::epsilon() *
                              (largest + largest_other);
    }
  } // namespace



  RodMatrices::RodMatrices(
    const RodLayout                               &layout,
    const double                                   tolerance,
    const Entry                                   &entry,
    const std::vector<bool>                       &carries,
    const std::function<bool(const unsigned int)> &repeats)
    : layout_(layout)
  {
    const unsigned int  n = layout.nodes_per_cell();
    std::vector<double> of_cell(n_matrices * n * n);
    const auto          carries_cell = [&](const unsigned int cell) {
      return !carries.empty() && carries[cell];
    };
    for (unsigned int cell = 0; cell < layout.n_cells; ++cell)
      {
        if (repeats && repeats(cell))
          {
            ++runs_.back().end;
            continue;
          }
        auto value = of_cell.begin();
        for (unsigned int matrix = 0; matrix < n_matrices; ++matrix)
          for (unsigned int j = 0; j < n; ++j)
            for (unsigned int i = 0; i < n; ++i)
              *value++ = entry(static_cast<Matrix>(matrix), cell, i, j);
        if (!runs_.empty() && !runs_.back().carries && !carries_cell(cell) &&
            are_equal(of_cell.data(),
                      entries_.data() + runs_.back().first_entry,
                      n * n,
                      tolerance))
          {
            ++runs_.back().end;
            continue;
          }
        runs_.push_back(
          {cell, cell + 1, entries_.size(), false, false, carries_cell(cell)});
        entries_.insert(entries_.end(), of_cell.begin(), of_cell.end());
        set_losses(runs_.back());
      }
  }



  void
  RodMatrices::set_losses(Run &run)
  {
    const unsigned int  n    = layout_.nodes_per_cell();
    const double *const all  = entries(run, conduction);
    const double *const lost = entries(run, heat_exchange);
    run.loses_heat = std::any_of(lost, lost + n * n, [](const double entry) {
      return entry != 0.;
    });
    run.conducts_differences = rows_add_up_to_zero(all, lost, n);
    for (unsigned int i = 0; i < n; ++i)
      {
        double sum = 0.;
        for (unsigned int j = 0; j < n; ++j)
          sum += lost[j * n + i];
        losses_.push_back(sum);
      }
  }



  bool
  RodMatrices::takes_differences(const Run &run, const Matrix matrix) const
  {
    if (matrix == conduction)
      return run.conducts_differences;
    return matrix == divergence ||
           (!run.carries &&
            (matrix == stiffness || matrix == viscous_stiffness));
  }



  namespace
  {
    /** Entries of a cell for one term of a sum, and its vector. */
    struct Factors
    {
      const double *entries;
      const double *vector;
      double        factor;
      bool          takes_differences;
      const double *of_constant; ///< of a matrix of differences, or null
    };



    /** Entries of a row of linear cells: of its two neighbours and its own. */
    struct LinearRow
    {
      double        left, middle, right;
      const double *x;
    };



    /**
     * Rows @p begin to @p end of @p n sums at once. An index as wide as a
     * pointer: one that may wrap makes the compiler gather values one by one.
     */
    template <std::size_t n, bool has_base>
    void
    set_linear_rows(const std::size_t               begin,
                    const std::size_t               end,
                    const std::array<LinearRow, n> &rows,
                    const double                    factor,
                    const double *__restrict__ base,
                    double *__restrict__ y)
    {
      // constants of the loop, by name: else the compiler reads them each time
      const LinearRow a            = rows[0];
      const LinearRow b            = rows[n > 1 ? 1 : 0];
      const LinearRow c            = rows[n > 2 ? 2 : 0];
      const double *__restrict__ x = a.x;
      const double *__restrict__ v = b.x;
      const double *__restrict__ w = c.x;
#pragma omp simd
      for (std::size_t i = begin; i < end; ++i)
        {
          double sum = has_base ? factor * base[i] : 0.;
          sum += a.left * x[i - 1] + a.middle * x[i] + a.right * x[i + 1];
          if constexpr (n > 1)
            sum += b.left * v[i - 1] + b.middle * v[i] + b.right * v[i + 1];
          if constexpr (n > 2)
            sum += c.left * w[i - 1] + c.middle * w[i] + c.right * w[i + 1];
          y[i] = sum;
        }
    }



    /** Linear cells: three entries to a row, the same in all rows of a run. */
    template <std::size_t n, bool has_base>
    void
    add_linear(const RodMatrices::Run       &run,
               const std::array<Factors, n> &terms,
               const double                  factor,
               const double                 *base,
               double                       *y)
    {
      static_assert(n <= 3);
      std::array<LinearRow, n> rows;
      double                   last = has_base ? factor * base[run.end] : 0.;
      for (unsigned int k = 0; k < n; ++k)
        {
          // entries by columns: left vertex, right vertex
          const double *const a = terms[k].entries;
          const double *const x = terms[k].vector;
          const double        f = terms[k].factor;
          rows[k]               = {f * a[1], f * a[3] + f * a[0], f * a[2], x};
          y[run.begin] += f * a[0] * x[run.begin] + f * a[2] * x[run.begin + 1];
          last += f * a[1] * x[run.end - 1] + f * a[3] * x[run.end];
        }
      set_linear_rows<n, has_base>(
        run.begin + 1, run.end, rows, factor, base, y);
      y[run.end] = last;
    }



    /** Cells of any degree; of @p fixed_degree if it is not 0. */
    template <unsigned int fixed_degree, std::size_t n_terms>
    void
    add_cells_of_rod(const RodLayout                    &layout,
                     const RodMatrices::Run             &run,
                     const std::array<Factors, n_terms> &terms,
                     const double                        factor,
                     const double                       *base,
                     double *__restrict__ y)
    {
      const unsigned int p = fixed_degree > 0 ? fixed_degree : layout.degree;
      const unsigned int n = p + 1;
      for (unsigned int cell = run.begin; cell < run.end; ++cell)
        {
          const unsigned int left   = layout.left_vertex(cell);
          const unsigned int first  = cell * p + 1;
          double *__restrict__ rows = y + first;
          if (base == nullptr)
            for (unsigned int i = 0; i < p; ++i)
              rows[i] = 0.;
          else
            for (unsigned int i = 0; i < p; ++i)
              rows[i] = factor * base[first + i];
          double     left_row   = y[left];
          const auto add_column = [&](const double *column, const double x) {
            left_row += column[0] * x;
            for (unsigned int i = 0; i < p; ++i)
              rows[i] += column[i + 1] * x;
          };
          for (const Factors &term : terms)
            {
              const double x_left = term.vector[left];
              const double zero   = term.takes_differences ? x_left : 0.;
              if (!term.takes_differences)
                add_column(term.entries, term.factor * x_left);
              else if (term.of_constant != nullptr)
                add_column(term.of_constant, term.factor * x_left);
              for (unsigned int j = 1; j < n; ++j)
                add_column(term.entries + j * n,
                           term.factor * (term.vector[first + j - 1] - zero));
            }
          y[left] = left_row;
        }
    }
  } // namespace



  template <std::size_t n_terms>
  void
  RodMatrices::combine(const std::array<Term, n_terms> &terms,
                       const double                     factor,
                       const double                    *base,
                       double                          *y) const
  {
    y[0] = base == nullptr ? 0. : factor * base[0];
    with_fixed_degree(layout_.degree, [&](const auto degree) {
      for (const Run &run : runs_)
        {
          std::array<Factors, n_terms> of_run;
          for (unsigned int k = 0; k < n_terms; ++k)
            of_run[k] = {entries(run, terms[k].matrix),
                         terms[k].vector,
                         terms[k].factor,
                         takes_differences(run, terms[k].matrix),
                         of_constant(run, terms[k].matrix)};
          if constexpr (degree.value != 1)
            add_cells_of_rod<degree.value>(
              layout_, run, of_run, factor, base, y);
          else if (base == nullptr)
            add_linear<n_terms, false>(run, of_run, factor, base, y);
          else
            add_linear<n_terms, true>(run, of_run, factor, base, y);
        }
    });
  }



  template void
  RodMatrices::combine(const std::array<Term, 1> &,
                       const double,
                       const double *,
                       double *) const;
  template void
  RodMatrices::combine(const std::array<Term, 2> &,
                       const double,
                       const double *,
                       double *) const;
  template void
  RodMatrices::combine(const std::array<Term, 3> &,
                       const double,
                       const double *,
                       double *) const;



  namespace
  {
    /**
     * $\sum x\cdot Ax$ over the linear cells of a run. A stiffness is a sum of
     * squares of differences, the mass of one point to a cell of sums: as such
     * the energy of a displacement that is large beside its strain, or of a
     * velocity that alternates, keeps its digits. Indices are as wide as those
     * of set_linear_rows().
     */
    template <typename Value>
    double
    linear_form(const RodMatrices::Run &run, const double *a, const Value &x)
    {
      const double LL = a[0], LR_RL = a[1] + a[2], RR = a[3];
      const double size = 0.5 * std::abs(LR_RL), sign = LR_RL < 0. ? -1. : 1.;
      const double rounding = 4. * std::numeric_limits<double>::epsilon();
      double       sum      = 0.;
      if (std::max(std::abs(LL - size), std::abs(RR - size)) <= rounding * size)
        {
#pragma omp simd reduction(+ : sum)
          for (std::size_t i = run.begin; i < run.end; ++i)
            {
              const double joint = x(i + 1) + sign * x(i);
              sum += joint * joint;
            }
          return size * sum;
        }
#pragma omp simd reduction(+ : sum)
      for (std::size_t i = run.begin; i < run.end; ++i)
        {
          const double left = x(i), right = x(i + 1);
          sum += right * (RR * right + LR_RL * left) + LL * left * left;
        }
      return sum;
    }



    /** Cells of any degree. */
    template <unsigned int fixed_degree, typename Value>
    double
    form_of_cells(const RodLayout        &layout,
                  const RodMatrices::Run &run,
                  const double           *a,
                  const bool              takes_differences,
                  const double           *of_constant,
                  const Value            &x)
    {
      const unsigned int p   = fixed_degree > 0 ? fixed_degree : layout.degree;
      const unsigned int n   = p + 1;
      double             sum = 0.;
      for (unsigned int cell = run.begin; cell < run.end; ++cell)
        {
          const unsigned int first = cell * p + 1;
          const double       left  = x(layout.left_vertex(cell));
          const double       zero  = takes_differences ? left : 0.;
          for (unsigned int j = takes_differences; j < n; ++j)
            {
              const double *const column  = a + j * n;
              double              product = column[0] * (left - zero);
              for (unsigned int i = 0; i < p; ++i)
                product += column[i + 1] * (x(first + i) - zero);
              sum += product * (j == 0 ? left : x(first + j - 1) - zero);
            }
          if (takes_differences && of_constant != nullptr)
            {
              // (d + c) A (d + c) with a constant c
              double of_left = of_constant[0] * left;
              for (unsigned int i = 0; i < p; ++i)
                of_left += of_constant[i + 1] * (2. * x(first + i) - left);
              sum += left * of_left;
            }
        }
      return sum;
    }



    template <typename Value>
    double
    sum_of_forms(const RodMatrices        &matrices,
                 const RodMatrices::Matrix matrix,
                 const Value              &x)
    {
      const RodLayout &layout = matrices.layout();
      return with_fixed_degree(layout.degree, [&](const auto degree) {
        double sum = 0.;
        for (const RodMatrices::Run &run : matrices.runs())
          {
            const double *const a = matrices.entries(run, matrix);
            if constexpr (degree.value == 1)
              sum += linear_form(run, a, x);
            else
              sum +=
                form_of_cells<degree.value>(layout,
                                            run,
                                            a,
                                            matrices.takes_differences(run,
                                                                       matrix),
                                            matrices.of_constant(run, matrix),
                                            x);
          }
        return sum;
      });
    }
  } // namespace



  double
  RodMatrices::form(const Matrix matrix, const double *x) const
  {
    return sum_of_forms(*this, matrix, [x](const std::size_t i) {
      return x[i];
    });
  }



  double
  RodMatrices::form_of_difference(const Matrix  matrix,
                                  const double *x,
                                  const double *y) const
  {
    return sum_of_forms(*this, matrix, [x, y](const std::size_t i) {
      return x[i] - y[i];
    });
  }
} // namespace ThermoContact
