// SPDX-License-Identifier: LGPL-2.1-or-later
//
// Drives and a traction that come as pulses, error-controlled: each is seen,
// and what they move and heat is right to 30 tolerances.
//
// 48 scenes: a pulse phi(t) to 1 around t = 0.37 T, T = 5, of width w T, w =
// 1e-4, 1e-3, 1e-2, 0.1, 0.3, 1: exp(-((t - 0.37 T)/(w T/2))^2) less its value
// at t = 0, or a rectangle, that begins at 0.05 T or later; of the base, which
// must not jump, a trapezoid with ramps of a fifth of the width. It is
//   theta_A, or theta_obs with k = 2:  theta(1) and the mean of theta,
//   u_A, or a traction, b = 1, zeta = 0.2, no obstacle:  u(1) and u_t(1)
// of a rod of n = 32 linear cells h, from rest. The transform of its nodal
// values y_0 ... y_n solves, with the mass mu = p and the stiffness alpha = 1,
// or mu = p^2 and alpha = 1 + zeta p,
//   (mu h/6 - alpha/h) (y_{i-1} + y_{i+1}) + (2 mu h/3 + 2 alpha/h) y_i = 0,
//   y_0 given, (mu h/6 - alpha/h) y_{n-1} + (mu h/3 + alpha/h + k) y_n = load,
// so that y_i = A q^i + B q^(n-i), where q + 1/q = (2 + 4 r)/(1 - r) and r = mu
// h^2/(6 alpha): sums of it are geometric. The response S(t) to a step is the
// inverse of y/p, by Talbot's contour with 32 points (1e-10), at 4001 points in
// the root of t with splines between them; that to a pulse is
// sum_j [phi(t_j)] S(t - t_j) + int S(t - s) phi'(s) ds, by Gauss's rule in the
// root of t - s.
//
// Errors at all rows, relative to the largest value of the field in the rod,
// which is 1 for theta_A and u_A, and the largest slope of phi for the velocity
// of a base; and below a quarter of the largest value of the column, so that no
// pulse is missed. Measured: 7.3 tolerances for the shortest trapezoid, else at
// most 1.2.

#include <thermocontact/simulation/simulation.h>

#include <deal.II/base/mpi.h>
#include <deal.II/base/quadrature_lib.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <functional>
#include <string>
#include <vector>

#include "../recorded_run.h"
#include "../step_response.h"

using namespace ThermoContact;
using numbers::PI;
using Complex = std::complex<double>;

namespace
{
  constexpr double T         = 5.;
  constexpr double centre    = 0.37 * T;
  constexpr double tolerance = 1e-5;
  constexpr double zeta      = 0.2;
  constexpr double k         = 2.;



  enum class Shape
  {
    smooth,
    rectangle,
    trapezoid
  };



  struct Pulse
  {
    double width;
    Shape  shape;

    double
    bell(const double t) const
    {
      const double x = (t - centre) / (width / 2.);
      return std::exp(-x * x);
    }



    double
    begin() const
    {
      return std::max(centre - width / 2., 0.05 * T);
    }



    double
    end() const
    {
      return centre + width / 2.;
    }



    double
    ramp() const
    {
      return width / 5.;
    }



    double
    largest_slope() const
    {
      return shape == Shape::smooth ? std::sqrt(8. / std::exp(1.)) / width :
                                      1. / ramp();
    }



    std::string
    expression() const
    {
      const std::string from = number(begin()), to = number(end());
      if (shape == Shape::smooth)
        return "exp(-((t-" + number(centre) + ")/" + number(width / 2.) +
               ")^2)-" + number(bell(0.));
      if (shape == Shape::rectangle)
        return "if(t>" + from + ",if(t<" + to + ",1,0),0)";
      return "max(0,min(1,min((t-" + from + ")/" + number(ramp()) + ",(" + to +
             "-t)/" + number(ramp()) + ")))";
    }



    /** Integral of S(t - s) phi'(s) over s from a to b, at most up to t. */
    static double
    integral(const StepResponse                  &S,
             const double                         t,
             const double                         a,
             const double                         b,
             const std::function<double(double)> &slope,
             const unsigned int                   n)
    {
      static const QGauss<1> rule(4);
      const double           from = std::sqrt(std::max(0., t - b));
      const double           size = (std::sqrt(std::max(0., t - a)) - from) / n;
      double                 sum  = 0.;
      if (size > 0.)
        for (unsigned int i = 0; i < n; ++i)
          for (unsigned int q = 0; q < rule.size(); ++q)
            {
              const double root = from + size * (i + rule.point(q)[0]);
              sum += size * rule.weight(q) * 2. * root * S(root * root) *
                     slope(t - root * root);
            }
      return sum;
    }



    double
    response(const StepResponse &S, const double t) const
    {
      constexpr double behind = 1e-12; // a jump are rows at it
      if (shape == Shape::rectangle)
        return S(t + behind - begin()) - S(t + behind - end());
      if (shape == Shape::trapezoid)
        {
          const auto one = [&](const double) { return 1. / ramp(); };
          return integral(S, t, begin(), begin() + ramp(), one, 10) -
                 integral(S, t, end() - ramp(), end(), one, 10);
        }
      return integral(
        S,
        t,
        std::max(0., centre - 3.5 * width),
        centre + 3.5 * width,
        [&](const double s) {
          return -8. * (s - centre) / (width * width) * bell(s);
        },
        100);
    }
  };



  struct Column
  {
    double StepRecord::*value;
    StepResponse        response;

    /** Largest value of the field elsewhere, for phi and for its slope. */
    double of_pulse = 0., of_slope = 0.;
  };



  struct Scenario
  {
    std::string         name;
    Overrides           overrides;
    std::string         entry;
    Shape               rough;
    std::vector<Column> columns;
  };



  /** Transforms of the nodal values of linear cells, by unit data. */
  struct Nodes
  {
    static constexpr unsigned int n = 32;
    static constexpr double       h = 1. / n;

    Complex q, q_n, A, B;

    Nodes(const Complex mass,
          const Complex stiffness,
          const double  exchange,
          const Complex first_value,
          const Complex load)
    {
      const Complex r    = mass * h * h / (6. * stiffness);
      const Complex half = (1. + 2. * r) / (1. - r);
      const Complex root = std::sqrt(half * half - 1.);
      q   = std::abs(half - root) < 1. ? half - root : half + root;
      q_n = std::pow(q, n);
      const Complex side = mass * h / 6. - stiffness / h;
      const Complex last = mass * h / 3. + stiffness / h + exchange;
      const Complex of_A = last * q_n + side * q_n / q;
      B = (load - first_value * of_A) / (last + side * q - q_n * of_A);
      A = first_value - B * q_n;
    }



    Complex
    end() const
    {
      return A * q_n + B;
    }



    /** All with the weight h, the first and the last one with half of it. */
    Complex
    mean() const
    {
      return (A + B) * h * (1. - q_n) * (1. + q) / (2. * (1. - q));
    }
  };



  Nodes
  heated(const Complex p, const double first, const double obstacle)
  {
    return Nodes(p, 1., k, first, k * obstacle);
  }



  Nodes
  moved(const Complex p, const double first, const double traction)
  {
    return Nodes(p * p, 1. + zeta * p, 0., first, traction);
  }



  std::vector<Column>
  temperatures(const double first, const double obstacle, const double least)
  {
    return {{&StepRecord::temperature_end,
             StepResponse([=](const Complex p) {
               return heated(p, first, obstacle).end();
             }),
             least},
            {&StepRecord::temperature_mean,
             StepResponse([=](const Complex p) {
               return heated(p, first, obstacle).mean();
             }),
             least}};
  }



  std::vector<Column>
  motions(const double first, const double traction, const double least)
  {
    return {{&StepRecord::displacement_end,
             StepResponse([=](const Complex p) {
               return moved(p, first, traction).end();
             }),
             least},
            {&StepRecord::velocity_end,
             StepResponse([=](const Complex p) {
               return p * moved(p, first, traction).end();
             }),
             0.,
             least}};
  }



  std::vector<Scenario>
  scenarios()
  {
    const Overrides heat{"Model/Fields=temperature",
                         "Boundary/Heat exchange=2",
                         "Initial values/Temperature=0"};
    const Overrides motion{"Model/Fields=displacement",
                           "Model/Viscosity=0.2",
                           "Contact/Condition=none",
                           "Initial values/Displacement=0",
                           "Initial values/Velocity=0"};
    return {{"fixed end temperature",
             heat,
             "Boundary/Fixed end temperature",
             Shape::rectangle,
             temperatures(1., 0., 1.)},
            {"obstacle temperature",
             heat + Overrides{"Boundary/Fixed end temperature=0"},
             "Boundary/Obstacle temperature",
             Shape::rectangle,
             temperatures(0., 1., 0.)},
            {"fixed end displacement",
             motion,
             "Boundary/Fixed end displacement",
             Shape::trapezoid,
             motions(1., 0., 1.)},
            {"end traction",
             motion,
             "Sources/End traction",
             Shape::rectangle,
             motions(0., 1., 0.)}};
  }



  /**
   * Largest error of a column of a run, in tolerances of the largest value of
   * its field, or infinity if it is a quarter of the largest value of the
   * column.
   */
  double
  error_of(const RecordedRun &result, const Column &column, const Pulse &pulse)
  {
    double error = 0., largest = 0.;
    for (const StepRecord &r : result.rows)
      {
        const double exact = pulse.response(column.response, r.time);
        raise(error, std::abs(r.*column.value - exact));
        raise(largest, std::abs(exact));
      }
    if (!(error < 0.25 * largest))
      return std::numeric_limits<double>::infinity();
    const double elsewhere =
      std::max(column.of_pulse, column.of_slope * pulse.largest_slope());
    return error / std::max(largest, elsewhere) / tolerance;
  }
} // namespace



void
main_drive_pulses()
{
  initlog();
  for (const Scenario &scenario : scenarios())
    for (const Shape shape : {scenario.rough, Shape::smooth})
      {
        unsigned int n_good = 0;
        for (const double width : {1e-4, 1e-3, 1e-2, 0.1, 0.3, 1.})
          {
            const Pulse       pulse{width * T, shape};
            const RecordedRun result =
              run<1>("",
                     scenario.overrides +
                       Overrides{scenario.entry + "=" + pulse.expression(),
                                 "Mesh/Cells=32",
                                 "Mesh/Grading=1",
                                 "Mesh/Degree=1",
                                 "Time/End time=5",
                                 "Time/Tolerance=" + number(tolerance)});
            bool is_good = true;
            for (const Column &column : scenario.columns)
              {
                const double error = error_of(result, column, pulse);
                is_good &= error <= 30.;
                if (!(error <= 30.))
                  deallog << "width " << width << ": error " << error
                          << " tolerances" << std::endl;
              }
            n_good += is_good;
          }
        deallog << scenario.name
                << (shape == Shape::smooth ? ", smooth" : ", rectangular")
                << ": within 30 tolerances " << n_good << " of 6" << std::endl;
      }
}
