// SPDX-License-Identifier: LGPL-2.1-or-later

#include <thermocontact/method/bracketed_root.h>
#include <thermocontact/method/damped_contact.h>
#include <thermocontact/method/nodal_contact.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace ThermoContact
{
  namespace
  {
    /** Pressure of one node at one stop as a function of its velocity. */
    class DampedStop
    {
    public:
      /** @param start $\tilde s$ */
      DampedStop(const ContactLaw &law,
                 const double      tau,
                 const double      start,
                 const bool        is_held)
        : law(law)
        , c(law.damping())
        , tau(tau)
        , start(start)
        , is_held(is_held)
      {}

      double
      pressure(const double v) const
      {
        const double s = penetration(v);
        return s > 0.  ? law.damped_pressure(s, v) :
               is_held ? -law.pressure(-s) * factor_at_touch() :
                         0.;
      }

      double
      stiffness(const double v) const
      {
        const double s = penetration(v);
        if (s > 0.)
          {
            const double elastic = law.pressure(s);
            const double factor  = 1. + c * v;
            return factor > 0. ?
                     tau * factor / law.tangent(elastic) + c * elastic :
                     0.;
          }
        return is_held ?
                 tau * factor_at_touch() / law.tangent(law.pressure(-s)) :
                 0.;
      }

      double
      local_pressure(const double free_velocity, const double receptance) const
      {
        const double touch = velocity_at_touch();
        const double low   = std::max(touch, -1. / c);
        if (!(free_velocity > low))
          return is_held && free_velocity < touch ?
                   pull(free_velocity - touch, receptance) :
                   0.;
        const auto excess = [&](const double v) {
          return v + receptance * pressure(v) - free_velocity;
        };
        // 1 - c (1/c) may be rounding, which a hard obstacle takes for contact
        if (excess(low) >= 0.)
          return (free_velocity - low) / receptance;
        const auto [v, above] = bracketed_root(excess, low, free_velocity);
        // of the two the one that loses less by the rounding of v, also next
        // to the velocity at which the pressure begins
        return receptance * (pressure(above) - pressure(v)) > above - v ?
                 (free_velocity - v) / receptance :
                 pressure(v);
      }

    private:
      const ContactLaw &law;
      const double      c;
      const double      tau;
      const double      start;
      const bool        is_held;

      double
      penetration(const double v) const
      {
        return start + tau * v;
      }

      /** The velocity with which the node ends at $s=0$. */
      double
      velocity_at_touch() const
      {
        constexpr double infinity = std::numeric_limits<double>::infinity();
        return tau > 0. ? -start / tau : start > 0. ? -infinity : infinity;
      }

      double
      factor_at_touch() const
      {
        return std::max(0., 1. + c * velocity_at_touch());
      }

      /** Negative pressure of a node that is held. */
      double
      pull(const double beyond_touch, const double receptance) const
      {
        const double factor = factor_at_touch();
        if (factor == 0.)
          return 0.;
        return factor * law.local_closed_pressure(tau * beyond_touch,
                                                  tau * receptance * factor);
      }
    };



    /** The pressure of each node as a function of its velocity. */
    class LawOfVelocities : public NodalLaws
    {
    public:
      LawOfVelocities(const ContactLaw &law, const NodesInMotion &nodes)
        : law(law)
        , nodes(nodes)
      {}

      double
      pressure(const unsigned int i, const double v) const override
      {
        const double p = near_stop(i).pressure(v);
        return p == 0. && has_far_stop(i) ? 0. - far_stop(i).pressure(-v) : p;
      }

      double
      stiffness(const unsigned int i,
                const double       v,
                const double) const override
      {
        const double by_near = near_stop(i).stiffness(v);
        return has_far_stop(i) ? by_near + far_stop(i).stiffness(-v) : by_near;
      }

      double
      local_pressure(const unsigned int i,
                     const double       free_velocity,
                     const double       receptance) const override
      {
        const double p = near_stop(i).local_pressure(free_velocity, receptance);
        return p == 0. && has_far_stop(i) ?
                 0. - far_stop(i).local_pressure(-free_velocity, receptance) :
                 p;
      }

      double
      position(const unsigned int,
               const double free_velocity,
               const double receptance,
               const double pressure) const override
      {
        return free_velocity - receptance * pressure;
      }

    private:
      const ContactLaw    &law;
      const NodesInMotion &nodes;

      bool
      is_held(const unsigned int i) const
      {
        return nodes.tau > 0. && !nodes.is_held.empty() && nodes.is_held[i];
      }

      bool
      has_far_stop(const unsigned int i) const
      {
        return !nodes.far_start.empty() && !is_held(i);
      }

      DampedStop
      near_stop(const unsigned int i) const
      {
        return {law, nodes.tau, nodes.start[i], is_held(i)};
      }

      DampedStop
      far_stop(const unsigned int i) const
      {
        return {law, nodes.tau, nodes.far_start[i], false};
      }
    };
  } // namespace



  DampedContact::DampedContact(const ContactLaw &law)
    : law(law)
  {}



  unsigned int
  DampedContact::solve(const dealii::FullMatrix<double> &response,
                       const NodesInMotion              &nodes,
                       std::vector<double>              &pressure) const
  {
    const LawOfVelocities laws(law, nodes);
    const unsigned int    n = nodes.start.size();
    pressure.resize(n, 0.);
    if (n == 1)
      {
        pressure[0] =
          laws.local_pressure(0, nodes.free_velocity[0], response(0, 0));
        return 1;
      }
    std::vector<double> velocity(nodes.free_velocity);
    for (unsigned int i = 0; i < n; ++i)
      for (unsigned int j = 0; j < n; ++j)
        velocity[i] -= response(i, j) * pressure[j];
    return solve_nodal_contact(
      laws, response, nodes.free_velocity, std::move(velocity), pressure);
  }



  double
  DampedContact::stiffness(const NodesInMotion &nodes,
                           const unsigned int   i,
                           const double         v) const
  {
    return LawOfVelocities(law, nodes).stiffness(i, v, 0.);
  }
} // namespace ThermoContact
