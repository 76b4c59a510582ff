// SPDX-License-Identifier: LGPL-2.1-or-later

#include <thermocontact/base/exceptions.h>
#include <thermocontact/base/special_numbers.h>
#include <thermocontact/base/tolerances.h>
#include <thermocontact/contact/contact_law.h>
#include <thermocontact/contact/interface_problem.h>

#include <algorithm>
#include <cmath>

namespace ThermoContact
{
  using dealii::FullMatrix;

  namespace
  {
    /** Shortened steps in a row after which the nodes take a sweep. */
    constexpr unsigned int max_short_steps = 3;

    /** Sets of tangents that Newton's method may take at once. */
    constexpr unsigned int max_sets_of_many_changes = 20;

    /** The loss of node @p i by the pressures of the others. */
    double
    loss_by_others(const FullMatrix<double>  &receptance,
                   const std::vector<double> &pressure,
                   const unsigned int         i)
    {
      double sum = 0.;
      for (unsigned int j = 0; j < pressure.size(); ++j)
        if (j != i)
          sum += receptance(i, j) * pressure[j];
      return sum;
    }
  } // namespace



  void
  respond_to_change(const FullMatrix<double>  &receptance,
                    const std::vector<double> &slope,
                    FullMatrix<double>        &change)
  {
    // nodes without slope follow from the others
    std::vector<unsigned int> closed, all_columns;
    for (unsigned int i = 0; i < slope.size(); ++i)
      if (slope[i] > 0.)
        closed.push_back(i);
    for (unsigned int j = 0; j < change.n(); ++j)
      all_columns.push_back(j);
    const unsigned int m = closed.size();
    if (m == 0)
      return;
    FullMatrix<double> matrix(m, m), rhs(m, change.n()), z(m, change.n());
    for (unsigned int i = 0; i < m; ++i)
      for (unsigned int j = 0; j < m; ++j)
        matrix(i, j) =
          i == j ? 1. : receptance(closed[i], closed[j]) * slope[closed[j]];
    rhs.extract_submatrix_from(change, closed, all_columns);
    matrix.gauss_jordan();
    matrix.mmult(z, rhs);
    for (unsigned int i = 0; i < slope.size(); ++i)
      if (!(slope[i] > 0.))
        for (unsigned int j = 0; j < m; ++j)
          {
            const double factor = receptance(i, closed[j]) * slope[closed[j]];
            for (unsigned int k = 0; k < change.n(); ++k)
              change(i, k) -= factor * z(j, k);
          }
    z.scatter_matrix_to(closed, all_columns, change);
  }



  std::vector<double>
  product(const FullMatrix<double> &matrix, const std::vector<double> &x)
  {
    std::vector<double> y(matrix.m(), 0.);
    for (unsigned int i = 0; i < matrix.m(); ++i)
      for (unsigned int j = 0; j < matrix.n(); ++j)
        y[i] += matrix(i, j) * x[j];
    return y;
  }



  std::vector<double>
  change_of_pressure(const FullMatrix<double>  &receptance,
                     const std::vector<double> &slope,
                     const std::vector<double> &free_change)
  {
    const unsigned int n = slope.size();
    FullMatrix<double> change(n, 1);
    for (unsigned int i = 0; i < n; ++i)
      change(i, 0) = free_change[i];
    respond_to_change(receptance, slope, change);
    std::vector<double> pressure(n);
    for (unsigned int i = 0; i < n; ++i)
      pressure[i] = slope[i] * change(i, 0);
    return pressure;
  }



  namespace
  {
    /** A body whose W is known. */
    class DenseResponse : public InterfaceOperator
    {
    public:
      DenseResponse(const FullMatrix<double>  &receptance,
                    const std::vector<double> &free)
        : receptance(receptance)
        , free(free)
      {}

      bool
      is_dense() const override
      {
        return true;
      }

      void
      solve(const std::vector<AffineLaw> &laws,
            const bool /*is_last*/,
            std::vector<double> &position,
            std::vector<double> &pressure) override
      {
        // z + (W - R) p = x_free with p = P' (z - x_0)
        const unsigned int  n = laws.size();
        std::vector<double> slope(n), of_offsets(n);
        FullMatrix<double>  z(n, 1);
        for (unsigned int i = 0; i < n; ++i)
          {
            slope[i]      = laws[i].slope(receptance(i, i));
            of_offsets[i] = slope[i] * laws[i].offset;
          }
        for (unsigned int i = 0; i < n; ++i)
          z(i, 0) = free[i] + loss_by_others(receptance, of_offsets, i);
        respond_to_change(receptance, slope, z);
        for (unsigned int i = 0; i < n; ++i)
          pressure[i] = laws[i].pressure(z(i, 0), receptance(i, i));
        for (unsigned int i = 0; i < n; ++i)
          position[i] = z(i, 0) - receptance(i, i) * pressure[i];
      }

      void
      sweep(const std::vector<NodeLaw> &laws,
            std::vector<double>        &position,
            std::vector<double>        &pressure) override
      {
        for (unsigned int i = 0; i < laws.size(); ++i)
          pressure[i] =
            laws[i]
              .resolve(free[i] - loss_by_others(receptance, pressure, i),
                       receptance(i, i))
              .pressure;
        set_positions(pressure, position);
      }

      void
      set_positions(const std::vector<double> &pressure,
                    std::vector<double>       &position) const
      {
        for (unsigned int i = 0; i < pressure.size(); ++i)
          position[i] = free[i] - loss_by_others(receptance, pressure, i) -
                        receptance(i, i) * pressure[i];
      }

    private:
      const FullMatrix<double>  &receptance;
      const std::vector<double> &free;
    };
  } // namespace



  unsigned int
  InterfaceProblem::solve(const FullMatrix<double>   &receptance,
                          const std::vector<NodeLaw> &laws,
                          const std::vector<double>  &free,
                          std::vector<double>        &pressure)
  {
    const unsigned int n = laws.size();
    pressure.resize(n, 0.);
    slopes_.assign(n, 0.);
    tangents_.assign(n, AffineLaw());
    if (std::any_of(free.begin(), free.begin() + n, [](const double x) {
          return std::isnan(x);
        }))
      {
        // no law says what it does: the state that follows is not finite
        pressure.assign(n, nan);
        return 1;
      }
    unsigned int n_sets = 1;
    z.assign(free.begin(), free.begin() + n);
    if (n > 1)
      {
        std::vector<double> own(n), position(n);
        for (unsigned int i = 0; i < n; ++i)
          own[i] = receptance(i, i);
        DenseResponse body(receptance, free);
        body.set_positions(pressure, position);
        n_sets = solve_by_tangents(body,
                                   laws,
                                   own,
                                   Tolerances::rounding_of_solution,
                                   position,
                                   pressure);
        for (unsigned int i = 0; i < n; ++i)
          z[i] = position[i] + own[i] * pressure[i];
      }
    for (unsigned int i = 0; i < n; ++i)
      {
        const NodalPressure p = laws[i].resolve(z[i], receptance(i, i));
        pressure[i]           = p.pressure;
        slopes_[i]            = p.tangent.slope(receptance(i, i));
        tangents_[i]          = p.tangent;
      }
    return n_sets;
  }



  namespace
  {
    /** Nodes at some $z$, with pressures that are not those of their laws. */
    struct NodesOfBody
    {
      std::vector<double> z, pressure;

      // of their laws there
      std::vector<double>    pressure_of_law; ///< $P(z)$
      std::vector<AffineLaw> tangent;
      std::vector<double>    defect;    ///< $r|P(z)-p|$
      double                 norm = 0.; ///< of it, its square

      void
      meet(const std::vector<NodeLaw> &laws,
           const std::vector<double>  &receptance)
      {
        pressure_of_law.resize(z.size());
        tangent.resize(z.size());
        defect.resize(z.size());
        norm = 0.;
        for (unsigned int i = 0; i < z.size(); ++i)
          {
            const NodalPressure p = laws[i].resolve(z[i], receptance[i]);
            pressure_of_law[i]    = p.pressure;
            tangent[i]            = p.tangent;
            defect[i] = receptance[i] * std::abs(p.pressure - pressure[i]);
            norm += defect[i] * defect[i];
          }
      }
    };



    /** The nodes at a part of the way. */
    NodesOfBody
    between(const NodesOfBody &from, const NodesOfBody &to, const double part)
    {
      NodesOfBody nodes(to);
      for (unsigned int i = 0; i < nodes.z.size(); ++i)
        {
          nodes.z[i] = from.z[i] + part * (to.z[i] - from.z[i]);
          nodes.pressure[i] =
            from.pressure[i] + part * (to.pressure[i] - from.pressure[i]);
        }
      return nodes;
    }
  } // namespace



  unsigned int
  solve_by_tangents(InterfaceOperator          &body,
                    const std::vector<NodeLaw> &laws,
                    const std::vector<double>  &receptance,
                    const double                rounding,
                    std::vector<double>        &position,
                    std::vector<double>        &pressure)
  {
    const unsigned int     n             = laws.size();
    bool                   is_last       = true; // if no node can change
    unsigned int           n_short_steps = 0;
    std::vector<AffineLaw> tangents(n);
    for (unsigned int i = 0; i < n; ++i)
      {
        const NodeLaw &law = laws[i];
        if (law.law == nullptr || !law.law->is_active())
          continue;
        is_last = is_last && law.is_held;
        if (body.is_dense() || law.is_held || pressure[i] != 0.)
          tangents[i] = body.is_dense() || law.is_in_velocity ?
                          law
                            .resolve(position[i] + receptance[i] * pressure[i],
                                     receptance[i])
                            .tangent :
                          law.tangent_of_pressure(pressure[i]);
      }

    is_last                     = is_last || body.is_dense();
    const unsigned int max_sets = max_sets_of_many_changes + 200 + 2 * n;
    NodesOfBody        present, next, trial;
    next.z.resize(n);
    next.pressure.resize(n);
    for (unsigned int n_sets = 1; n_sets <= max_sets;)
      {
        body.solve(tangents, is_last, position, pressure);
        double largest = 0.;
        for (unsigned int i = 0; i < n; ++i)
          {
            next.z[i]        = position[i] + receptance[i] * pressure[i];
            next.pressure[i] = tangents[i].pressure(next.z[i], receptance[i]);
            largest          = std::max(largest, std::abs(next.z[i]));
          }
        next.meet(laws, receptance);
        const auto is_settled = [&](const double defect) {
          return defect <= rounding * largest;
        };
        if (std::all_of(next.defect.begin(), next.defect.end(), is_settled))
          {
            if (is_last)
              {
                for (unsigned int i = 0; i < n; ++i)
                  if (!laws[i].is_held &&
                      !(pressure[i] *
                          next.tangent[i].pressure(next.z[i], receptance[i]) >
                        0.))
                    pressure[i] = 0.;
                return n_sets;
              }
            is_last = true;
            continue;
          }

        const bool takes_one =
          !body.is_dense() && n_sets >= max_sets_of_many_changes;
        double part = 1.;
        trial       = next;
        while (n_sets > 1 && !takes_one &&
               part > Tolerances::shortest_newton_step &&
               !(trial.norm < (1. - 0.2 * part) * present.norm))
          {
            part *= 0.5;
            trial = between(present, next, part);
            trial.meet(laws, receptance);
          }
        const bool is_short =
          part < 1. && part > Tolerances::shortest_newton_step;
        n_short_steps = part < 1. ? n_short_steps + 1 : 0;
        ++n_sets;
        if (body.is_dense() &&
            (n_short_steps > max_short_steps || (part < 1. && !is_short)))
          {
            // stalled: once each node alone
            pressure = present.pressure_of_law;
            body.sweep(laws, position, pressure);
            for (unsigned int i = 0; i < n; ++i)
              present.z[i] = position[i] + receptance[i] * pressure[i];
            present.pressure = pressure;
            present.meet(laws, receptance);
            tangents      = present.tangent;
            n_short_steps = 0;
            continue;
          }
        present = is_short ? trial : next;
        for (unsigned int i = 0; i < n; ++i)
          if (is_short || !is_settled(present.defect[i]))
            {
              tangents[i] = present.tangent[i];
              if (takes_one)
                break;
            }
      }
    throw ComputationError("the pressures of " + std::to_string(n) +
                           " contact nodes did not settle\n  remedy:  a larger "
                           "Contact/Compliance or a smaller Time/Step size");
  }
} // namespace ThermoContact
