// SPDX-License-Identifier: LGPL-2.1-or-later

#include <thermocontact/base/special_numbers.h>
#include <thermocontact/contact/step_contact.h>
#include <thermocontact/method/bracketed_root.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace ThermoContact
{
  namespace
  {
    /** Where the node ends at one of the obstacles. */
    struct SideEnd
    {
      double penetration; ///< $s^1$
      double pressure;    ///< of the law there, without damping
    };



    /** One of the obstacles, as the node sees it. */
    class StepObstacle
    {
    public:
      /**
       * @param sign 1: in front of the node; -1: behind it
       * @param rate of its place
       */
      StepObstacle(const ContactLaw &law,
                   const int         sign,
                   const double      start,
                   const double      rate,
                   const double      size)
        : sign(sign)
        , law(law)
        , start(start)
        , start_pressure(law.pressure(start))
        , rate(rate)
        , size(size)
      {}

      const int sign;

      /** w of a node that ends at its surface. */
      double
      touching_velocity() const
      {
        return rate - sign * start / size;
      }

      /** Of a node with this w that ends outside. */
      SideEnd
      end_outside(const double velocity) const
      {
        return {std::min(start + size * sign * (velocity - rate), 0.), 0.};
      }

      SideEnd
      end_of_pressure(const double pressure) const
      {
        return {law.penetration(pressure), pressure};
      }

      /** Mean pressure on the way there, without damping. */
      double
      elastic_mean(const SideEnd &end, const double weight) const
      {
        return weight * end.pressure +
               (1. - weight) * law.mean_pressure(start, end.penetration);
      }

      /** Factor of the pressure by damping. */
      double
      damping_factor(const SideEnd &end) const
      {
        return law.velocity_factor(velocity(end));
      }

      double
      mean(const SideEnd &end, const double weight) const
      {
        const double of_spring =
          elastic_mean(end, weight) * damping_factor(end);
        // only the way within the obstacle moves its dashpot
        return law.dashpot() == 0. ?
                 of_spring :
                 std::max(0.,
                          of_spring + law.dashpot() *
                                        (std::max(end.penetration, 0.) -
                                         std::max(start, 0.)) /
                                        size);
      }

      double
      damping_power(const SideEnd &end, const double weight) const
      {
        return !law.is_damped() ?
                 0. :
                 (mean(end, weight) - elastic_mean(end, weight)) *
                   velocity(end);
      }

      /**
       * The weight of the law at the end with which the end of a step does not
       * swing about that of a longer one, (C6.11).
       */
      double
      weight(const SideEnd &end, const double response) const
      {
        const double largest = std::max(start_pressure, end.pressure);
        if (!(largest > 0.))
          return 0.;
        const double stiffness = damping_factor(end) / law.tangent(largest);
        return std::max(0.,
                        1. - 2. * (1. + response * law.dashpot()) /
                               (response * size * stiffness));
      }

    private:
      const ContactLaw &law;
      const double      start;
      const double      start_pressure;
      const double      rate;
      const double      size;

      double
      velocity(const SideEnd &end) const
      {
        return (end.penetration - start) / size;
      }
    };



    class StepProblem
    {
    public:
      StepProblem(const ContactLaw &front,
                  const ContactLaw &rear,
                  const StepPath   &path)
        : is_rigid(front.is_rigid())
        , path(path)
        , obstacles{{{front, 1, path.front, path.front_rate, path.size},
                     {rear, -1, path.rear, 0., path.size}}}
        , n(std::isfinite(path.rear) ? 2 : 1)
      {}

      StepContact
      solve() const
      {
        const StepContact at_end = solve({{1., 1.}});
        if (is_rigid ||
            (at_end.pressure == 0. && path.front <= 0. && path.rear <= 0.))
          return at_end;
        const Ends ends = at_end.end_pressure == 0. ?
                            ends_at(at_end.velocity) :
                            ends_under(at_end.end_pressure > 0. ? 0 : 1,
                                       std::abs(at_end.end_pressure));
        Weights    weights{};
        for (unsigned int i = 0; i < n; ++i)
          weights[i] = obstacles[i].weight(ends.at[i], path.response);
        return solve(weights);
      }

    private:
      const bool                        is_rigid;
      const StepPath                   &path;
      const std::array<StepObstacle, 2> obstacles;
      const unsigned int                n; ///< of them

      using Weights = std::array<double, 2>;

      struct Ends
      {
        double                 velocity; ///< w
        std::array<SideEnd, 2> at;
      };

      StepContact
      solve(const Weights &weights) const
      {
        for (unsigned int i = 0; i < n; ++i)
          {
            const StepObstacle &o = obstacles[i];
            if (o.sign * (path.free_velocity - o.touching_velocity()) >
                  path.negligible_velocity &&
                o.sign * excess(ends_under(i, 0.), weights) < 0.)
              return closed(i, weights);
          }
        return open(weights);
      }

      Ends
      ends_at(const double velocity) const
      {
        Ends ends{velocity, {}};
        for (unsigned int i = 0; i < n; ++i)
          ends.at[i] = obstacles[i].end_outside(velocity);
        return ends;
      }

      /** The node ends in an obstacle, under this pressure of it. */
      Ends
      ends_under(const unsigned int i, const double pressure) const
      {
        const StepObstacle &o   = obstacles[i];
        const SideEnd       end = o.end_of_pressure(pressure);
        Ends                ends =
          ends_at(o.touching_velocity() + o.sign * end.penetration / path.size);
        ends.at[i] = end;
        return ends;
      }

      double
      mean(const Ends &ends, const Weights &weights) const
      {
        double sum = 0.;
        for (unsigned int i = 0; i < n; ++i)
          sum += obstacles[i].sign * obstacles[i].mean(ends.at[i], weights[i]);
        return sum;
      }

      /** Grows with w. */
      double
      excess(const Ends &ends, const Weights &weights) const
      {
        return ends.velocity + path.response * mean(ends, weights) -
               path.free_velocity;
      }

      StepContact
      finish(const Ends    &ends,
             const double   end_pressure,
             const Weights &weights) const
      {
        StepContact contact;
        contact.velocity     = ends.velocity;
        contact.pressure     = mean(ends, weights);
        contact.end_pressure = end_pressure;
        contact.weight       = std::max(weights[0], weights[1]);
        for (unsigned int i = 0; i < n; ++i)
          contact.damping_power +=
            obstacles[i].damping_power(ends.at[i], weights[i]);
        return contact;
      }

      /** The node ends within an obstacle. */
      StepContact
      closed(const unsigned int i, const Weights &weights) const
      {
        const int  sign   = obstacles[i].sign;
        const auto beyond = [&](const double pressure) {
          return sign * excess(ends_under(i, pressure), weights);
        };
        // the pressure of a rigid obstacle
        const double rigid =
          0. - excess(ends_under(i, 0.), weights) / path.response;
        if (is_rigid)
          {
            StepContact contact;
            contact.velocity = obstacles[i].touching_velocity();
            contact.pressure = contact.end_pressure = rigid;
            contact.weight                          = 1.;
            return contact;
          }
        double low = 0., high = std::abs(rigid);
        for (; beyond(high) < 0. && std::isfinite(high); high *= 4.)
          low = high;
        const double pressure = bracketed_root(beyond, low, high).first;
        return finish(ends_under(i, pressure), sign * pressure, weights);
      }

      /** The node ends at neither. */
      StepContact
      open(const Weights &weights) const
      {
        const auto function = [&](const double velocity) {
          return excess(ends_at(velocity), weights);
        };
        // pushed by the obstacle that it leaves, at most as at its surface
        double low = path.free_velocity, high = low;
        for (unsigned int i = 0; i < n; ++i)
          {
            const StepObstacle &o = obstacles[i];
            (o.sign > 0 ? low : high) -=
              o.sign * path.response *
              o.mean(o.end_of_pressure(0.), weights[i]);
          }
        return finish(ends_at(low == high ?
                                low :
                                bracketed_root(function, low, high).first),
                      0.,
                      weights);
      }
    };
  } // namespace



  StepContact
  solve_step_contact(const ContactLaw &front,
                     const ContactLaw &rear,
                     const StepPath   &path)
  {
    return StepProblem(front, rear, path).solve();
  }
} // namespace ThermoContact
