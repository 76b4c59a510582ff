// SPDX-License-Identifier: LGPL-2.1-or-later

#include <thermocontact/rod/fixed_degree.h>
#include <thermocontact/rod/rod_matrices.h>

#include <algorithm>

namespace ThermoContact
{
  RodMatrices::RodMatrices(const RodLayout &layout, const Entry &entry)
    : layout_(layout)
  {
    const unsigned int  n = layout.nodes_per_cell();
    std::vector<double> of_cell(n_matrices * n * n);
    for (unsigned int cell = 0; cell < layout.n_cells; ++cell)
      {
        auto value = of_cell.begin();
        for (unsigned int matrix = 0; matrix < n_matrices; ++matrix)
          for (unsigned int j = 0; j < n; ++j)
            for (unsigned int i = 0; i < n; ++i)
              // the left neighbour has this one
              *value++ = i == 0 && j == 0 && cell > 0 ?
                           0. :
                           entry(static_cast<Matrix>(matrix),
                                 layout.node(cell, i),
                                 layout.node(cell, j));
        if (!runs_.empty() && std::equal(of_cell.begin(),
                                         of_cell.end(),
                                         entries_.begin() +
                                           runs_.back().first_entry))
          {
            ++runs_.back().end;
            continue;
          }
        runs_.push_back({cell, cell + 1, entries_.size()});
        entries_.insert(entries_.end(), of_cell.begin(), of_cell.end());
      }
  }



  namespace
  {
    /** Entries of a cell for one term of a sum, and its vector. */
    struct Factors
    {
      const double *entries;
      const double *vector;
      double        factor;
    };



    /** Linear cells: three entries to a row, the same in all rows of a run. */
    template <std::size_t n>
    void
    add_linear(const RodMatrices::Run       &run,
               const std::array<Factors, n> &terms,
               const double                  factor,
               const double                 *base,
               double *__restrict__          y)
    {
      // L: left vertex, R: right vertex; first the row
      double        LL[n], RL[n], LR[n], RR[n], RR_LL[n];
      const double *x[n];
      for (unsigned int k = 0; k < n; ++k)
        {
          const double *const a = terms[k].entries;
          LL[k]                 = terms[k].factor * a[0];
          RL[k]                 = terms[k].factor * a[1];
          LR[k]                 = terms[k].factor * a[2];
          RR[k]                 = terms[k].factor * a[3];
          RR_LL[k]              = RR[k] + LL[k];
          x[k]                  = terms[k].vector;
        }
      for (unsigned int k = 0; k < n; ++k)
        y[run.begin] += LL[k] * x[k][run.begin] + LR[k] * x[k][run.begin + 1];
      const auto add_rows = [&](const auto &base_value) {
#pragma omp simd
        for (unsigned int i = run.begin + 1; i < run.end; ++i)
          {
            double sum = base_value(i);
            for (unsigned int k = 0; k < n; ++k)
              sum +=
                RL[k] * x[k][i - 1] + RR_LL[k] * x[k][i] + LR[k] * x[k][i + 1];
            y[i] = sum;
          }
        double last = base_value(run.end);
        for (unsigned int k = 0; k < n; ++k)
          last += RL[k] * x[k][run.end - 1] + RR[k] * x[k][run.end];
        y[run.end] = last;
      };
      if (base == nullptr)
        add_rows([](const unsigned int) { return 0.; });
      else
        add_rows([&](const unsigned int i) { return factor * base[i]; });
    }



    /** Cells of any degree; of that of the compiler if it is not 0. */
    template <unsigned int fixed_degree, std::size_t n_terms>
    void
    add_cells(const RodLayout                    &layout,
              const RodMatrices::Run             &run,
              const std::array<Factors, n_terms> &terms,
              const double                        factor,
              const double                       *base,
              double *__restrict__                y)
    {
      const unsigned int p = fixed_degree > 0 ? fixed_degree : layout.degree;
      const unsigned int n = p + 1;
      for (unsigned int cell = run.begin; cell < run.end; ++cell)
        {
          const unsigned int   left  = layout.left_vertex(cell);
          const unsigned int   first = cell * p + 1;
          double *__restrict__ rows  = y + first;
          if (base == nullptr)
            for (unsigned int i = 0; i < p; ++i)
              rows[i] = 0.;
          else
            for (unsigned int i = 0; i < p; ++i)
              rows[i] = factor * base[first + i];
          double left_row = y[left];
          for (const Factors &term : terms)
            for (unsigned int j = 0; j < n; ++j)
              {
                const double *const column = term.entries + j * n;
                const double        x =
                  term.factor * term.vector[j == 0 ? left : first + j - 1];
                left_row += column[0] * x;
                for (unsigned int i = 0; i < p; ++i)
                  rows[i] += column[i + 1] * x;
              }
          y[left] = left_row;
        }
    }



    /** $\sum x\cdot Ax$ over the linear cells of a run. */
    template <typename Value>
    double
    linear_form(const RodMatrices::Run &run,
                const double           *a,
                const Value            &x)
    {
      const double LL = a[0], LR_RL = a[1] + a[2], RR = a[3];
      double       sum = 0.;
#pragma omp simd reduction(+ : sum)
      for (unsigned int i = run.begin; i < run.end; ++i)
        {
          const double left = x(i), right = x(i + 1);
          sum += right * (RR * right + LR_RL * left);
        }
      for (unsigned int i = run.begin; LL != 0. && i < run.end; ++i)
        sum += LL * x(i) * x(i);
      return sum;
    }



    /** Cells of any degree. */
    template <unsigned int fixed_degree, typename Value>
    double
    form_of_cells(const RodLayout        &layout,
                  const RodMatrices::Run &run,
                  const double           *a,
                  const Value            &x)
    {
      const unsigned int p = fixed_degree > 0 ? fixed_degree : layout.degree;
      const unsigned int n = p + 1;
      double             sum = 0.;
      for (unsigned int cell = run.begin; cell < run.end; ++cell)
        {
          const unsigned int first = cell * p + 1;
          const double       left  = x(layout.left_vertex(cell));
          for (unsigned int j = 0; j < n; ++j)
            {
              const double *const column  = a + j * n;
              double              product = column[0] * left;
              for (unsigned int i = 0; i < p; ++i)
                product += column[i + 1] * x(first + i);
              sum += product * (j == 0 ? left : x(first + j - 1));
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
              sum += form_of_cells<degree.value>(layout, run, a, x);
          }
        return sum;
      });
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
                         terms[k].factor};
          if constexpr (degree.value == 1)
            add_linear(run, of_run, factor, base, y);
          else
            add_cells<degree.value>(layout_, run, of_run, factor, base, y);
        }
    });
  }



  double
  RodMatrices::form(const Matrix matrix, const double *x) const
  {
    return sum_of_forms(*this, matrix, [x](const unsigned int i) {
      return x[i];
    });
  }



  double
  RodMatrices::form_of_difference(const Matrix  matrix,
                                  const double *x,
                                  const double *y) const
  {
    return sum_of_forms(*this, matrix, [x, y](const unsigned int i) {
      return x[i] - y[i];
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
} // namespace ThermoContact
