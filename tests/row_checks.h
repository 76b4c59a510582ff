// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef thermocontact_tests_row_checks_h
#define thermocontact_tests_row_checks_h

#include <algorithm>
#include <cmath>
#include <vector>

#include "recorded_run.h"
#include "tests.h"

namespace ThermoContact
{
  /** Numbers of a run: a vector for each row. */
  using Columns = std::vector<std::vector<double>>;

  /** All columns of contact.csv but the counters, and those of the faces. */
  inline Columns
  table_of(const std::vector<StepRecord> &rows)
  {
    Columns table;
    for (const StepRecord &r : rows)
      {
        const auto columns = all_columns(r);
        table.emplace_back(columns.begin(), columns.end());
        table.back().insert(table.back().end(),
                            {r.contact_dissipation,
                             r.lateral_heat_flux,
                             r.lateral_dissipation});
      }
    return table;
  }



  /**
   * Largest difference of a column, in parts of its largest value or of 0.1;
   * infinite if the numbers of rows differ. NaN equals NaN.
   */
  inline double
  difference(const Columns &a, const Columns &b)
  {
    if (a.size() != b.size() || a.empty())
      return std::numeric_limits<double>::infinity();
    double result = 0.;
    for (unsigned int j = 0; j < a[0].size(); ++j)
      {
        double change = 0., scale = 0.1;
        for (unsigned int i = 0; i < a.size(); ++i)
          if (!(std::isnan(a[i][j]) && std::isnan(b[i][j])))
            {
              raise(change, std::abs(a[i][j] - b[i][j]));
              raise(scale, std::abs(a[i][j]));
            }
        raise(result, change / scale);
      }
    return result;
  }



  /** What the energy of a run says, in parts of the sum of its terms. */
  struct Audit
  {
    /** Of energy(0) + work = energy + what is dissipated. */
    double defect = 0.;
    /** Largest increase of the energy in a step. */
    double increase = 0.;
    /** Most that the scheme or the obstacle gives back in a step. */
    double given = 0.;
    /** Work at the end. */
    double work = 0.;
    /** What the obstacle has taken at the end. */
    double taken = 0.;
  };

  inline Audit
  audit(const std::vector<StepRecord> &rows)
  {
    Audit  result;
    double scale = 0.;
    for (unsigned int i = 0; i < rows.size(); ++i)
      {
        const StepRecord &r = rows[i], &old = rows[i > 0 ? i - 1 : 0];
        raise(scale,
              rows[0].energy_terms.magnitude() + std::abs(r.work) +
                r.dissipation + r.contact_dissipation +
                std::abs(r.numerical_dissipation));
        raise(result.defect,
              std::abs(rows[0].energy + r.work - r.energy - r.dissipation -
                       r.contact_dissipation - r.numerical_dissipation));
        raise(result.increase, r.energy - old.energy);
        raise(result.given,
              std::max(old.numerical_dissipation - r.numerical_dissipation,
                       old.contact_dissipation - r.contact_dissipation));
      }
    result.work  = rows.back().work;
    result.taken = rows.back().contact_dissipation;
    for (double *value : {&result.defect,
                          &result.increase,
                          &result.given,
                          &result.work,
                          &result.taken})
      *value /= scale;
    return result;
  }
} // namespace ThermoContact

#endif
