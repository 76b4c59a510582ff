// SPDX-License-Identifier: LGPL-2.1-or-later

#include <thermocontact/base/special_numbers.h>
#include <thermocontact/contact/step_contact.h>
#include <thermocontact/method/bracketed_root.h>

#include <algorithm>
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
    class StepSide
    {
    public:
      StepSide(const ContactLaw &law, const double start, const double size)
        : law(law)
        , start(start)
        , start_pressure(law.pressure(start))
        , size(size)
      {}

      /** Velocity into it at which the node ends at its surface. */
      double
      velocity_to_touch() const
      {
        return -start / size;
      }

      /** Of a node with this velocity into it that ends outside. */
      SideEnd
      end_outside(const double velocity) const
      {
        return {std::min(start + size * velocity, 0.), 0.};
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

      /** What damping multiplies it with. */
      double
      damping_factor(const SideEnd &end) const
      {
        return std::max(0., 1. + law.damping() * velocity(end));
      }

      double
      mean(const SideEnd &end, const double weight) const
      {
        return elastic_mean(end, weight) * damping_factor(end);
      }

      double
      damping_power(const SideEnd &end, const double weight) const
      {
        return law.damping() == 0. ?
                 0. :
                 elastic_mean(end, weight) * (damping_factor(end) - 1.) *
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
        return std::max(0., 1. - 2. / (response * size * stiffness));
      }

    private:
      const ContactLaw &law;
      const double      start;
      const double      start_pressure;
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
      StepProblem(const ContactLaw &law, const StepPath &path)
        : law(law)
        , path(path)
        , front(law, path.front, path.size)
        , rear(law, path.rear, path.size)
        , has_rear(std::isfinite(path.rear))
      {}

      StepContact
      solve(const double front_weight, const double rear_weight) const
      {
        const Problem problem{front_weight, rear_weight};
        if (path.free_velocity - touch(1) > path.negligible_velocity &&
            excess(at_touch(1), problem) < 0.)
          return closed(1, problem);
        if (has_rear &&
            touch(-1) - path.free_velocity > path.negligible_velocity &&
            excess(at_touch(-1), problem) > 0.)
          return closed(-1, problem);
        return open(problem);
      }

      StepContact
      solve() const
      {
        if (law.is_rigid())
          return solve(1., 1.);
        const StepContact at_end = solve(1., 1.);
        if (at_end.pressure == 0. && path.front <= 0. && path.rear <= 0.)
          return at_end;
        const Ends ends = ends_of(at_end);
        return solve(front.weight(ends.front, path.response),
                     has_rear ? rear.weight(ends.rear, path.response) : 0.);
      }

    private:
      const ContactLaw &law;
      const StepPath   &path;
      const StepSide    front, rear;
      const bool        has_rear;

      struct Problem
      {
        double front_weight, rear_weight;
      };

      struct Ends
      {
        double  velocity; ///< w
        SideEnd front, rear;
      };

      /** w with which the node ends at the surface of an obstacle. */
      double
      touch(const int side) const
      {
        return side > 0 ? path.front_rate + front.velocity_to_touch() :
                          0. - rear.velocity_to_touch();
      }

      SideEnd
      front_end(const double velocity) const
      {
        return front.end_outside(velocity - path.front_rate);
      }

      SideEnd
      rear_end(const double velocity) const
      {
        return has_rear ? rear.end_outside(-velocity) : SideEnd{-infinity, 0.};
      }

      Ends
      ends_at(const double velocity) const
      {
        return {velocity, front_end(velocity), rear_end(velocity)};
      }

      /** The node ends in an obstacle, under this pressure of it. */
      Ends
      ends_under(const int side, const double pressure) const
      {
        const double velocity =
          touch(side) + side * law.penetration(pressure) / path.size;
        return {velocity,
                side > 0 ? front.end_of_pressure(pressure) :
                           front_end(velocity),
                side < 0 ? rear.end_of_pressure(pressure) : rear_end(velocity)};
      }

      Ends
      at_touch(const int side) const
      {
        return ends_under(side, 0.);
      }

      Ends
      ends_of(const StepContact &contact) const
      {
        return contact.end_pressure == 0. ?
                 ends_at(contact.velocity) :
                 ends_under(contact.end_pressure > 0. ? 1 : -1,
                            std::abs(contact.end_pressure));
      }

      double
      mean(const Ends &ends, const Problem &problem) const
      {
        return front.mean(ends.front, problem.front_weight) -
               (has_rear ? rear.mean(ends.rear, problem.rear_weight) : 0.);
      }

      /** Grows with w. */
      double
      excess(const Ends &ends, const Problem &problem) const
      {
        return ends.velocity + path.response * mean(ends, problem) -
               path.free_velocity;
      }

      StepContact
      finish(const Ends    &ends,
             const double   end_pressure,
             const Problem &problem) const
      {
        StepContact contact;
        contact.velocity     = ends.velocity;
        contact.pressure     = mean(ends, problem);
        contact.end_pressure = end_pressure;
        contact.weight = std::max(problem.front_weight, problem.rear_weight);
        contact.damping_power =
          front.damping_power(ends.front, problem.front_weight) +
          (has_rear ? rear.damping_power(ends.rear, problem.rear_weight) : 0.);
        return contact;
      }

      /** The node ends within an obstacle. */
      StepContact
      closed(const int side, const Problem &problem) const
      {
        const auto beyond = [&](const double pressure) {
          return side * excess(ends_under(side, pressure), problem);
        };
        // that of a rigid obstacle
        const double rigid =
          0. - excess(at_touch(side), problem) / path.response;
        if (law.is_rigid())
          {
            StepContact contact;
            contact.velocity = touch(side);
            contact.pressure = contact.end_pressure = rigid;
            contact.weight                          = 1.;
            return contact;
          }
        double low = 0., high = std::abs(rigid);
        for (; beyond(high) < 0. && std::isfinite(high); high *= 4.)
          low = high;
        const double pressure = bracketed_root(beyond, low, high).first;
        return finish(ends_under(side, pressure), side * pressure, problem);
      }

      /** The node ends at neither. */
      StepContact
      open(const Problem &problem) const
      {
        const double free     = path.free_velocity;
        const auto   function = [&](const double velocity) {
          return excess(ends_at(velocity), problem);
        };
        // pushed by what it leaves, at most as at its surface
        const double by_front =
          path.response *
          front.mean(front.end_of_pressure(0.), problem.front_weight);
        const double by_rear =
          has_rear ? path.response * rear.mean(rear.end_of_pressure(0.),
                                               problem.rear_weight) :
                     0.;
        const double velocity =
          by_front == 0. && by_rear == 0. ?
            free :
            bracketed_root(function, free - by_front, free + by_rear).first;
        return finish(ends_at(velocity), 0., problem);
      }
    };
  } // namespace



  StepContact
  solve_step_contact(const ContactLaw &law, const StepPath &path)
  {
    return StepProblem(law, path).solve();
  }
} // namespace ThermoContact
