// SPDX-License-Identifier: LGPL-2.1-or-later

#include <thermocontact/base/exceptions.h>
#include <thermocontact/method/conserving_contact.h>
#include <thermocontact/method/scheme.h>

#include <deal.II/lac/vector.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace ThermoContact
{
  namespace
  {
    double
    largest_entry(const std::vector<double> &vector)
    {
      double largest = 0.;
      for (const double entry : vector)
        largest = std::max(largest, std::abs(entry));
      return largest;
    }



    /** Inverse of the rows and columns of @p is_active, zero elsewhere. */
    dealii::FullMatrix<double>
    inverse_on(const std::vector<bool>          &is_active,
               const dealii::FullMatrix<double> &matrix)
    {
      const unsigned int        n = is_active.size();
      std::vector<unsigned int> active;
      for (unsigned int i = 0; i < n; ++i)
        if (is_active[i])
          active.push_back(i);
      dealii::FullMatrix<double> inverse(n, n);
      if (active.empty())
        return inverse;
      dealii::FullMatrix<double> part(active.size(), active.size());
      part.extract_submatrix_from(matrix, active, active);
      part.gauss_jordan();
      part.scatter_matrix_to(active, active, inverse);
      return inverse;
    }



    /** Newton's step for $p-\bar p(A-2Bp)=0$. */
    void
    newton_update(const dealii::FullMatrix<double> &derivative,
                  const dealii::FullMatrix<double> &receptance,
                  const dealii::Vector<double>     &residual,
                  dealii::Vector<double>           &update)
    {
      const unsigned int         n = residual.size();
      dealii::FullMatrix<double> jacobian(n, n);
      derivative.mmult(jacobian, receptance);
      jacobian *= 2.;
      for (unsigned int i = 0; i < n; ++i)
        jacobian(i, i) += 1.;
      jacobian.gauss_jordan();
      jacobian.vmult(update, residual);
    }



    /** Size of the terms that positions at the end of a step are made of. */
    double
    position_scale(const double                      displacement_scale,
                   const NodesBeforeStops           &start,
                   const NodesBeforeStops           &free_end,
                   const dealii::FullMatrix<double> &receptance,
                   const std::vector<double>        &pressure)
    {
      double scale = 0.;
      for (unsigned int i = 0; i < pressure.size(); ++i)
        {
          double sum = displacement_scale +
                       std::abs(start.at_nearer_stop(start, i)) +
                       std::abs(start.at_nearer_stop(free_end, i));
          for (unsigned int j = 0; j < pressure.size(); ++j)
            sum += 2. * std::abs(receptance(i, j) * pressure[j]);
          scale = std::max(scale, sum);
        }
      return scale;
    }
  } // namespace



  NodesBeforeStops
  NodesBeforeStops::on_way_to(const NodesBeforeStops &end,
                              const double            part) const
  {
    NodesBeforeStops result(*this);
    for (unsigned int i = 0; i < front.size(); ++i)
      result.front[i] = front[i] + part * (end.front[i] - front[i]);
    for (unsigned int i = 0; i < rear.size(); ++i)
      result.rear[i] = rear[i] + part * (end.rear[i] - rear[i]);
    return result;
  }



  ConservingContact::ConservingContact(
    const ContactLaw                 &law,
    const dealii::FullMatrix<double> &receptance)
    : law(law)
    , static_receptance(receptance)
    , contact_solver(law)
  {}



  void
  ConservingContact::equilibrium(const NodesBeforeStops &s,
                                 std::vector<double>    &pressure) const
  {
    if (s.rear.empty())
      {
        contact_solver.solve(static_receptance, s.front, pressure);
        return;
      }
    // a stop that is far away has no digits left of what the nodes do
    NearerStops stops;
    stops.near = s.front;
    stops.far  = s.rear;
    stops.choose();
    stops.turn(pressure);
    contact_solver.solve(
      stops.turned(static_receptance), stops.near, pressure, {}, stops.far);
    stops.turn(pressure);
  }



  double
  ConservingContact::step_pressure_of_node(const double start,
                                           const double free_end,
                                           const double receptance) const
  {
    // p(d) = [d]_+ / e, V(d) = [d]_+^2 / (2e); free_end > end if there is
    // pressure.
    const double e = law.tangent(0.) + static_receptance(0, 0);
    const double r = std::max(receptance, 0.); // its rounding may be negative
    if (start <= 0.)
      {
        if (free_end <= 0.)
          return 0.;
        // end = x > 0: p = x^2 / (2e (x - start)) = (free_end - x) / (2r)
        const double half = 0.5 * e * (free_end + start);
        const double root =
          std::hypot(half, std::sqrt((r + e) * e * free_end * -start));
        const double x = half > 0. ? (half + root) / (r + e) :
                                     -e * free_end * start / (root - half);
        return x * x / (2. * e * (x - start));
      }
    const double p = 0.5 * (start + free_end) / (e + r);
    if (free_end - 2. * r * p >= 0.)
      return p; // in contact all the time
    // end < 0: 2e p (start - end) = start^2, end = free_end - 2r p
    const double half = e * (start - free_end);
    return start * start /
           (half + std::hypot(half, 2. * std::sqrt(e * r) * start));
  }



  double
  ConservingContact::step_pressure_of_node(const double near_start,
                                           const double near_end,
                                           const double receptance,
                                           const double far_start,
                                           const double far_end) const
  {
    const double p = step_pressure_of_node(near_start, near_end, receptance);
    const double r = std::max(receptance, 0.);
    if (far_start <= 0. && far_end + 2. * r * p <= 0.)
      return p;
    const double far_p = step_pressure_of_node(far_start, far_end, receptance);
    if (near_start <= 0. && near_end + 2. * r * far_p <= 0.)
      return 0. - far_p;
    return crossing_pressure(law.tangent(0.) + static_receptance(0, 0),
                             near_start,
                             near_end,
                             2. * r,
                             -near_start - far_start);
  }



  double
  ConservingContact::step_pressure_of_node(const NodesBeforeStops &start,
                                           const NodesBeforeStops &free_end,
                                           const double receptance) const
  {
    const double s = start.front[0], end = free_end.front[0];
    if (start.rear.empty())
      return step_pressure_of_node(s, end, receptance);
    const double rear = start.rear[0], rear_end = free_end.rear[0];
    return nearer_stop(s, rear) > 0 ?
             step_pressure_of_node(s, end, receptance, rear, rear_end) :
             0. - step_pressure_of_node(rear, rear_end, receptance, s, end);
  }



  double
  ConservingContact::distance_to_change(const Stretch &stretch,
                                        const double   peep) const
  {
    double     distance = std::numeric_limits<double>::infinity();
    const auto look     = [&](const double value, const double rate) {
      if (rate < 0.)
        distance = std::min(distance, std::max(-value / rate, peep));
    };
    const unsigned int n = stretch.is_active.size();
    for (unsigned int i = 0; i < n; ++i)
      {
        const double p = stretch.p(i), change = stretch.change(i);
        if (stretch.is_active[i])
          {
            look(stretch.is_rear[i] ? -p : p,
                 stretch.is_rear[i] ? -change : change);
            continue;
          }
        double by_pressure = 0., by_change = 0.;
        for (unsigned int j = 0; j < n; ++j)
          {
            by_pressure += static_receptance(i, j) * stretch.p(j);
            by_change += static_receptance(i, j) * stretch.change(j);
          }
        look(by_pressure - stretch.begin.front[i],
             by_change - stretch.slope(i));
        if (!stretch.begin.rear.empty())
          look(-by_pressure - stretch.begin.rear[i],
               stretch.slope(i) - by_change);
      }
    return distance;
  }



  void
  ConservingContact::mean_pressure(const NodesBeforeStops     &start,
                                   const NodesBeforeStops     &end,
                                   std::vector<double>        &mean,
                                   dealii::FullMatrix<double> &derivative) const
  {
    const unsigned int n = start.front.size();
    mean.assign(n, 0.);
    derivative.reinit(n, n);
    dealii::FullMatrix<double> matrix(static_receptance);
    for (unsigned int i = 0; i < n; ++i)
      matrix(i, i) += law.tangent(0.);

    // Where nodes change together, the set that follows is that of a point a
    // little further on; what is wrong up to there is of second order in it.
    // Nodes that move within rounding are not seen to change: then further on.
    const double           smallest_peep = 1e-10;
    double                 peep          = smallest_peep;
    std::vector<double>    pressure(n, 0.);
    dealii::Vector<double> at_stop(n);
    Stretch                stretch;
    stretch.is_active.resize(n);
    stretch.is_rear.resize(n);
    for (dealii::Vector<double> *vector :
         {&stretch.slope, &stretch.p, &stretch.change})
      vector->reinit(n);
    for (unsigned int i = 0; i < n; ++i)
      stretch.slope(i) = start.is_nearer_to_rear(i) ?
                           start.rear[i] - end.rear[i] :
                           end.front[i] - start.front[i];
    for (double xi = 0.; xi < 1.;)
      {
        equilibrium(start.on_way_to(end, xi + peep), pressure);
        stretch.begin = start.on_way_to(end, xi);
        for (unsigned int i = 0; i < n; ++i)
          {
            stretch.is_active[i] = pressure[i] != 0.;
            stretch.is_rear[i]   = pressure[i] < 0.;
            at_stop(i)           = stretch.is_rear[i] ? -stretch.begin.rear[i] :
                                                        stretch.begin.front[i];
          }
        const dealii::FullMatrix<double> inverse =
          inverse_on(stretch.is_active, matrix);
        inverse.vmult(stretch.p, at_stop);
        inverse.vmult(stretch.change, stretch.slope);

        const double next =
          std::min(1., xi + distance_to_change(stretch, peep));
        const double length = next - xi;
        for (unsigned int i = 0; i < n; ++i)
          mean[i] += length * (stretch.p(i) + 0.5 * length * stretch.change(i));
        derivative.add(0.5 * (next * next - xi * xi), inverse);
        peep = next > xi + peep ? smallest_peep : 2. * peep;
        xi   = next;
      }
  }



  unsigned int
  ConservingContact::step_pressure(const NodesBeforeStops           &start,
                                   const NodesBeforeStops           &free_end,
                                   const dealii::FullMatrix<double> &receptance,
                                   const double         displacement_scale,
                                   std::vector<double> &pressure) const
  {
    const unsigned int n = start.front.size();
    if (n == 1)
      {
        pressure[0] = step_pressure_of_node(start, free_end, receptance(0, 0));
        return 1;
      }

    NodesBeforeStops           end;
    std::vector<double>        mean;
    dealii::FullMatrix<double> derivative;
    dealii::Vector<double>     residual(n), update(n);
    const auto                 evaluate = [&](const std::vector<double> &p) {
      end = free_end;
      for (unsigned int i = 0; i < n; ++i)
        for (unsigned int j = 0; j < n; ++j)
          end.front[i] -= 2. * receptance(i, j) * p[j];
      for (unsigned int i = 0; i < end.rear.size(); ++i)
        for (unsigned int j = 0; j < n; ++j)
          end.rear[i] += 2. * receptance(i, j) * p[j];
      mean_pressure(start, end, mean, derivative);
      for (unsigned int i = 0; i < n; ++i)
        residual(i) = p[i] - mean[i];
      return residual.linfty_norm();
    };
    double norm = evaluate(pressure);
    for (unsigned int iteration = 1; iteration <= 50; ++iteration)
      {
        if (norm <=
            1e-14 * std::max(largest_entry(pressure), largest_entry(mean)))
          return iteration;
        newton_update(derivative, receptance, residual, update);
        const std::vector<double> old_pressure = pressure;
        const double              old_norm     = norm;
        for (double factor = 1.; factor > 1e-3; factor *= 0.5)
          {
            for (unsigned int i = 0; i < n; ++i)
              pressure[i] = old_pressure[i] - factor * update(i);
            norm = evaluate(pressure);
            if (norm < old_norm)
              break;
          }
        // at the rounding of the displacements no step is an improvement
        if (norm >= old_norm &&
            old_norm <= 1e-14 * (derivative.linfty_norm() *
                                   position_scale(displacement_scale,
                                                  start,
                                                  free_end,
                                                  receptance,
                                                  old_pressure) +
                                 largest_entry(old_pressure)))
          {
            pressure = old_pressure;
            return iteration;
          }
      }
    throw ComputationError(
      "the pressures of " + std::to_string(n) +
      " contact nodes that conserve energy were not found\n  remedy:  a smaller "
      "Time/Step size, or Time/Scheme = " +
      default_scheme().name);
  }
} // namespace ThermoContact
