// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef thermocontact_contact_interface_law_h
#define thermocontact_contact_interface_law_h

#include <thermocontact/base/special_numbers.h>

#include <algorithm>
#include <cmath>
#include <optional>

namespace ThermoContact
{
  class ContactLaw;



  /**
   * A law that is a straight line, $x=x_0+\kappa p$: vertical at a rigid
   * obstacle, where $\kappa=0$, and $p=0$ if $\kappa$ is infinite. The tangent
   * of another law, or all that a node has of one.
   */
  struct AffineLaw
  {
    double compliance = infinity; ///< $\kappa\ge0$
    double offset     = 0.;       ///< $x_0$

    bool
    is_open() const
    {
      return std::isinf(compliance);
    }

    /** $P(z;r)$ of InterfaceLaw. */
    double
    pressure(const double z, const double r) const
    {
      return is_open() ? 0. : (z - offset) / (compliance + r);
    }

    /** $P'(z)$, with $0\le rP'\le1$. */
    double
    slope(const double r) const
    {
      return 1. / (compliance + r);
    }
  };



  /** The pressure of a node, and the tangent of its law there. */
  struct NodalPressure
  {
    double    pressure = 0.;
    AffineLaw tangent;
  };



  /**
   * The law that a contact node meets: a monotone graph $p\in G(x)$ in the
   * plane of one number x of the node, its penetration or its velocity, and its
   * pressure p. Known by its resolvent, doc/contact-in-time.md (C2.2):
   * $p=P(z;r)$ is the pressure of a node alone, $p\in G(z-rp)$, which exists
   * once for all $z$ and $r>0$ (Minty 1962), however steep the graph is. No
   * mesh, no communication.
   */
  class InterfaceLaw
  {
  public:
    virtual ~InterfaceLaw() = default;

    /**
     * @param z x of the node without pressure
     * @param r loss of x per unit pressure, the receptance of the node; not
     *   negative, and positive for a graph with vertical parts
     */
    virtual NodalPressure
    resolve(const double z, const double r) const = 0;
  };



  /**
   * One law in front of the node, and one behind it that pushes back with
   * negative pressures: $G(x)=G_f(x-x_f)-G_r(-x-x_r)$. Both are borrowed, open
   * for negative arguments, and never closed at the same x.
   */
  class TwoSided : public InterfaceLaw
  {
  public:
    /** @param front_shift,rear_shift $x_f$, $x_r$ */
    TwoSided(const InterfaceLaw &front,
             const InterfaceLaw &rear,
             const double        front_shift,
             const double        rear_shift)
      : front(front)
      , rear(rear)
      , front_shift(front_shift)
      , rear_shift(rear_shift)
    {}

    NodalPressure
    resolve(const double z, const double r) const override;

  private:
    const InterfaceLaw &front;
    const InterfaceLaw &rear;
    const double        front_shift;
    const double        rear_shift;
  };



  /**
   * A damped obstacle in a stage of length $\tau$, in the plane of velocity and
   * pressure: $p=[\varphi(s)[1+cv]_++dv]_+$ at $s=\tilde s+\tau v\ge0$,
   * doc/contact-in-time.md (C2.7). The velocity is the unknown, since a
   * difference of penetrations has lost its digits in short stages. Held closed
   * it has either sign, and goes on with
   * $-\varphi(-s)[1+cv_0]_++dv$, where $v_0$ leads to $s=0$.
   */
  class Damped : public InterfaceLaw
  {
  public:
    /**
     * @param law borrowed
     * @param start $\tilde s$
     * @param tau not negative; 0, which a node that is held does not have: the
     *   penetration is $\tilde s$ whatever v
     */
    Damped(const ContactLaw &law,
           const double      start,
           const double      tau,
           const bool        is_held)
      : law(law)
      , start(start)
      , tau(tau)
      , is_held(is_held)
    {}

    NodalPressure
    resolve(const double z, const double r) const override;

  private:
    const ContactLaw &law;
    const double      start;
    const double      tau;
    const bool        is_held;

    // of the law without its dashpot

    double
    pressure(const double v) const;

    double
    penetration(const double v) const
    {
      return start + tau * v;
    }

    /** $v_0$. */
    double
    velocity_at_touch() const;

    double
    factor_at_touch() const;

    /** $dp/dv$. */
    double
    stiffness(const double v) const;

    double
    local_pressure(const double z, const double r) const;
  };



  /**
   * The mean of an elastic law over a step from $s_0$ to s, which does the work
   * of its potential V: $p=(V(s)-V(s_0))/(s-s_0)$, doc/contact-in-time.md
   * (C6.5), in front of the node and behind it.
   */
  class Mean : public InterfaceLaw
  {
  public:
    /**
     * @param law elastic; borrowed
     * @param start,rear_start $s_0$ at both sides
     */
    Mean(const ContactLaw &law, const double start, const double rear_start)
      : law(law)
      , start(start)
      , rear_start(rear_start)
    {}

    /** @p z is the penetration in front at the end of the step. */
    NodalPressure
    resolve(const double z, const double r) const override;

  private:
    const ContactLaw &law;
    const double      start;
    const double      rear_start;

    double
    pressure(const double s) const;
  };



  /**
   * The law of one contact node in one problem, made of the above: which
   * obstacle it meets, on one side or on two, held or not, damped or not.
   * Stages and equilibria know sides and branches by it alone; events and
   * steps that a node spends at both obstacles look at both. Positions are
   * measured from the obstacle that is local to the node, in the direction of
   * the displacement in front of it and behind it alike.
   */
  struct NodeLaw : public InterfaceLaw
  {
    /** Nothing to meet. */
    NodeLaw() = default;

    /** In front of the node alone. */
    explicit NodeLaw(const ContactLaw &law)
      : law(&law)
    {}

    const ContactLaw *law = nullptr; ///< borrowed

    /** Of the obstacle behind the node, borrowed; none: as in front. */
    const ContactLaw *rear_law = nullptr;

    /** 1: the local obstacle is the one in front; -1: the one behind. */
    int side = 1;

    /** Distance between the two; infinite: there is one. */
    double play = infinity;

    double front_rate = 0.; ///< $g'$; the obstacle behind the node rests

    bool is_held = false; ///< at the local one: the odd continuation of its law

    /**
     * x is a velocity, relative to the local obstacle, and the position
     * $\tilde s+\tau x$, measured from where that is at the end.
     */
    bool   is_in_velocity = false;
    double start          = 0.; ///< $\tilde s$
    double tau            = 0.;

    /** The pressure is the mean over a step that begins at this position. */
    std::optional<double> mean_from;

    NodalPressure
    resolve(const double z, const double r) const override;

    /** The law of the obstacle in front, 1, or behind, -1. */
    const ContactLaw &
    law_of(const int sign) const
    {
      return sign < 0 && rear_law != nullptr ? *rear_law : *law;
    }

    /** The law of the local obstacle. */
    const ContactLaw &
    local() const
    {
      return law_of(side);
    }

    /** True if the node is in contact at a position, with this pressure. */
    bool
    is_in_contact(const double position, const double pressure) const;

    /** The part of the local obstacle in a motion of the obstacle in front,
     * since the one behind rests. */
    double
    of_local(const double of_front) const
    {
      return side > 0 ? of_front : 0.;
    }

    /** Velocity of the local obstacle. */
    double
    local_rate() const
    {
      return of_local(front_rate);
    }

    /** Velocity of the obstacle that a node with this pressure meets. */
    double
    rate_under(const double pressure) const
    {
      return rate_of(sign_of(pressure));
    }

    /** Position at @p x, seen from the local obstacle. */
    double
    position(const double x) const
    {
      return is_in_velocity ? start + tau * x : x;
    }

    /** The local obstacle is the one on @p new_side, 1 or -1; returns the
     * position of a node at @p position as that one sees it. */
    double
    face(const int new_side, const double position);

    /** The local obstacle is the one that pushes a node so. */
    void
    face_pressure(const double pressure)
    {
      side = sign_of(side * pressure) * side;
    }

    /** The pressure without a pull of the local obstacle. */
    double
    without_pull(const double pressure) const
    {
      return side * std::max(side * pressure, 0.);
    }

    /** True if the node meets no obstacle at @p x, and none holds it. */
    bool
    is_open(const double x) const;

    /** Penetration of the nearer one; negative: minus the gap. */
    double
    penetration(const double position) const
    {
      return std::max(penetration_of(1, position),
                      penetration_of(-1, position));
    }

    /**
     * How penetration() grows with the position: 1 if the obstacle in front is
     * the nearer one, else -1.
     */
    int
    penetration_slope(const double position) const
    {
      return penetration_of(-1, position) > penetration_of(1, position) ? -1 :
                                                                          1;
    }

    /** The pressure at a position of a node with this velocity, not relative;
     * of a node that is held of either sign. */
    double
    pressure_at(const double position, const double velocity) const;

    /** The pressure that pushes the node back, without the pull of a held node.
     */
    double
    push(const double pressure) const
    {
      return is_held ? std::max(side * pressure, 0.) : std::abs(pressure);
    }

    /**
     * How far a node goes with $z=z_0+\xi z'$ until it is on another branch of
     * its law: where z is at one of its obstacles.
     *
     * @param lead smallest distance
     */
    double
    distance_to_branch(const double z,
                       const double rate,
                       const double lead) const;

    /** How that grows with the pressure: 1, -1, or 0 under a pull. */
    double
    push_slope(const double pressure) const
    {
      return is_held ? (side * pressure >= 0. ? side : 0.) :
                       (pressure < 0. ? -1. : 1.);
    }

    /** $\varphi(s)$ at a position, of either sign. */
    double
    elastic_pressure(const double position) const;

    /** The same; in front of a single obstacle the odd continuation. */
    double
    continued_pressure(const double position) const;

    /**
     * $\varphi(s)$ of a node with this pressure, of either sign, (M4.2): the
     * obstacle stores its energy. At a hard obstacle s has few digits, and
     * $p-\varphi(s)$ would have none: then it is $(p-d\,v)/(1+c\,v)$. A node
     * that goes in without a pressure does not know of the obstacle yet, in a
     * step that is held open and misses the begin of contact by s: zero.
     *
     * @param velocity of the node, not relative
     * @param rounding of the position
     */
    double
    elastic_pressure(const double position,
                     const double velocity,
                     const double pressure,
                     const double rounding) const;

    /**
     * ContactLaw::numerical_dissipation() of a step from @p position by @p
     * displacement, in which the obstacle in front moves by @p way.
     */
    double
    numerical_dissipation(const double position,
                          const double displacement,
                          const double way,
                          const double old_pressure,
                          const double pressure) const;

    /** The local position of a node that has this pressure at rest. */
    double
    position_of_pressure(const double pressure) const;

    /**
     * Tangent of the law in contact under this pressure, without damping; open
     * where contact begins without stiffness.
     */
    AffineLaw
    tangent_of_pressure(const double pressure) const;

  private:
    /** The law that a node with this pressure follows. */
    const ContactLaw &
    law_under(const double pressure) const
    {
      return law_of(is_held ? side : sign_of(pressure));
    }

    /** Penetration of the obstacle in front, 1, or behind, -1. */
    double
    penetration_of(const int sign, const double position) const
    {
      return sign == side ? sign * position : sign * position - play;
    }

    double
    rate_of(const int sign) const
    {
      return sign > 0 ? front_rate : 0.;
    }

    /** Position of the obstacle that pushes with this sign. */
    double
    obstacle(const int sign) const
    {
      return sign == side ? 0. : sign * play;
    }

    /** 1 or -1: of the obstacle that a node with this pressure meets. A single
     * one pulls, too. */
    int
    sign_of(const double pressure) const
    {
      return pressure < 0. && std::isfinite(play) ? -1 : 1;
    }
  };
} // namespace ThermoContact

#endif
