// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef thermocontact_contact_event_locator_h
#define thermocontact_contact_event_locator_h

#include <thermocontact/contact/contact_law.h>
#include <thermocontact/method/cubic_hermite.h>

#include <cmath>
#include <optional>
#include <vector>

namespace ThermoContact
{
  /** Begin or end of contact. */
  struct ContactEvent
  {
    enum Kind
    {
      begin,
      end
    };

    double time     = 0.;
    Kind   kind     = begin;
    double velocity = 0.; ///< $u_t(1)-g'$ of the free end next to that time,
                          ///< $u_t(1)$ at the obstacle behind
    int side = 1;         ///< of the obstacle; -1: the one behind the end

    /** Which contact of a row, from the left. */
    unsigned int contact = 0;

    double
    velocity_into() const
    {
      return side * velocity;
    }

    template <class Archive>
    void
    serialize(Archive &archive, const unsigned int)
    {
      archive &time &kind &velocity &side &contact;
    }
  };



  /** Of the contact that event @p i ends, since its begin; NaN of a begin. */
  double
  duration_of_contact(const std::vector<ContactEvent> &events,
                      const std::size_t                i);



  /** Where in a step contact begins or ends, from a scheme that knows it. */
  struct ContactChange
  {
    double time;
    double velocity; ///< as ContactEvent has it
  };



  /** The contact nodes at one time. */
  struct ContactValues
  {
    double              time = 0.;
    std::vector<double> displacement; ///< normal, $u_n$

    /** Of one obstacle. */
    struct Side
    {
      std::vector<double> penetration; ///< $-\infty$: there is none
      std::vector<double> velocity;    ///< into it

      template <class Archive>
      void
      serialize(Archive &archive, const unsigned int)
      {
        archive &penetration &velocity;
      }
    };

    Side front; ///< $u_n-g$, $v_n-g'$
    Side rear;  ///< behind the nodes, $-u_n-g_2$, $-v_n$

    /**
     * Of either sign in a closed step. With damping, but for a dashpot, the
     * pressure of the penetration at rest, of its sign, in all steps.
     */
    std::vector<double> pressure;

    /** The values of one node, in the memory of @p of_node. */
    void
    get_node(const unsigned int node, ContactValues &of_node) const;

    template <class Archive>
    void
    serialize(Archive &archive, const unsigned int)
    {
      archive &time &displacement &front &rear &pressure;
    }
  };



  /**
   * The same as one of the obstacles sees them, the one behind the nodes if
   * side is -1: penetrations, velocities and pressures are positive into it.
   */
  struct LocalValues
  {
    const ContactValues &values;
    int                  side;

    const ContactValues::Side &
    of_side() const
    {
      return side > 0 ? values.front : values.rear;
    }

    unsigned int
    size() const
    {
      return values.pressure.size();
    }

    double
    penetration(const unsigned int node) const
    {
      return of_side().penetration[node];
    }

    /** Of the other obstacle. */
    double
    opposite_penetration(const unsigned int node) const
    {
      return LocalValues{values, -side}.penetration(node);
    }

    double
    velocity(const unsigned int node) const
    {
      return of_side().velocity[node];
    }

    double
    pressure(const unsigned int node) const
    {
      return side * values.pressure[node];
    }

    /** A pull, or the sign of an open gap, is no contact with an obstacle
     * that is not there. */
    bool
    is_in_contact(const unsigned int node) const
    {
      return pressure(node) > 0. && !std::isinf(penetration(node));
    }

    bool
    is_any_in_contact() const;

    /** The node that contact changes first or last. */
    unsigned int
    foremost() const;

    /** False if a node is nearer to the other obstacle. */
    bool
    are_all_local() const;
  };



  /** Values with which a contact event is compared; per unit cross-section. */
  struct BodyScales
  {
    double energy   = 0.; ///< largest elastic or kinetic energy E
    double momentum = 0.; ///< $\sqrt{2bE}$
  };



  /** The memory of an EventLocator of a run so far. */
  struct ContactProgress
  {
    /** Largest values so far. */
    struct Scales
    {
      double displacement = 0.;
      double pressure     = 0.;

      void
      add(const LocalValues &values);
    };

    ContactMode               mode_ = ContactMode::unilateral;
    ContactValues             present;
    bool                      is_in_contact = false; ///< as the events say
    std::vector<ContactEvent> pending; ///< at the start of the step
    Scales                    largest;
    int                       side = 1; ///< of the last contact

    /** Where the step to the present one began, if the margin has gone on
     * smoothly since then and has no velocities. */
    ContactValues last;
    bool          has_last = false;

    /** For checkpoints; after a step that was accepted. */
    template <class Archive>
    void
    serialize(Archive &archive, const unsigned int)
    {
      archive &mode_ &present &is_in_contact &pending &side &last &has_last
        &largest.displacement &largest.pressure;
    }
  };



  /**
   * Follows the state of contact and finds the instants where it changes,
   * doc/contact-in-time.md section 3, so that steps can end there: between them
   * the solution is smooth and schemes keep their order. Knows neither mesh nor
   * communication.
   *
   * A step is computed with the state of contact held (open or closed for all
   * nodes), and is right if the margin s of every node stays positive: the gap
   * $g-u_n$ of an open node, the penetration $u_n-g$ of a closed one, the
   * pressure with a rigid obstacle. Within the step the cubic Hermite
   * interpolant of s finds single, double and grazing zeros.
   *
   * A step that ends near a zero is as good as one that ends there: the contact
   * force misses the impulse $\int p\,ds/|\dot s|$, which is to be below
   * a tenth of the tolerance of the momentum of the body, or s itself is below
   * a hundredth of the tolerance of the displacement and of the penetration
   * that all the energy of the body could make. Only the latter counts if the
   * heat exchange changes with contact, too: by how much, no impulse says. The
   * time of the event is that of the zero all the same.
   *
   * With several nodes in different states, and if events are not to be
   * located, steps are unilateral. An event within such a step is found by
   * linear interpolation of the smallest gap. The first node to touch and the
   * last to leave make the events; a body that is in contact at the start
   * begins contact there.
   *
   * Attempts at a step change what the next attempt supposes, and nothing else:
   * events count when the step after them is accepted.
   */
  class EventLocator : private ContactProgress
  {
  public:
    /**
     * @param law in front, borrowed
     * @param is_active false: all steps are unilateral
     * @param nodes their order
     * @param tolerance relative accuracy of an event
     * @param has_small_changes false: more than the contact force changes at
     *   an event, so that a miss by a small impulse is not a small one
     * @param has_velocity false: velocities of a static body say nothing, so
     *   that margins are interpolated linearly
     * @param rear_law borrowed; none: as in front
     */
    EventLocator(const ContactLaw &law,
                 const bool        is_active,
                 const NodeOrder   nodes,
                 const double      tolerance,
                 const bool        has_small_changes = true,
                 const bool        has_velocity      = true,
                 const ContactLaw *rear_law          = nullptr);

    /** Forgets all and takes the initial state. */
    void
    start(const ContactValues &initial, std::vector<ContactEvent> &events);

    /** How the next attempt is to be computed. */
    ContactMode
    mode() const
    {
      return mode_;
    }

    /** The contact changes that a step in the present mode shows. */
    struct Finding
    {
      enum Kind
      {
        nothing,  ///< contact is the same at its end
        at_start, ///< contact changes before the step
        within,   ///< contact changes at @p time: take the step to there
        at_end    ///< contact changes at its end
      };

      Kind   kind              = nothing;
      double time              = 0.;
      bool   changes_all_nodes = true; ///< all nodes change together

      /** The node that changes first. */
      unsigned int node = 0;

      /** Of nodes with mass: to be added to their velocity. */
      double change_of_velocity = 0.;

      int obstacle = 1; ///< 1 or -1, in front or behind

      /** The finding at one contact of a row with several. */
      struct OfContact
      {
        Kind kind     = nothing;
        int  obstacle = 1;
      };

      /** Of each; empty: nothing changes. */
      std::vector<OfContact> of_contacts = {};
    };

    /**
     * Looks for a change of contact in a step to @p next.
     *
     * @param is_aimed the step was to end at an event
     * @param scales of the body so far
     */
    Finding
    examine(const ContactValues &next,
            const bool           is_aimed,
            const BodyScales    &scales) const;

    /**
     * Contact changes at @p time, before the step that was examined last or
     * so soon that it is not worth a step: the mode is switched where the body
     * stands, and the event is pending until a step is accepted. If one is
     * already, contact is about to change at once in both modes: that event is
     * taken back and the next attempt is unilateral.
     *
     * @param change_of_velocity from where the body stands to that time, into
     *   the obstacle
     * @param new_side of the obstacle, as examine() has it
     * @return true if the mode was switched
     */
    bool
    switch_at_start(const double time,
                    const double change_of_velocity = 0.,
                    const int    new_side           = 1);

    /**
     * The nodes leave at once where contact has begun before the step that was
     * examined last: its end is pending behind its begin.
     *
     * @param stopped the nodes with mass, after the impact on a rigid obstacle
     */
    void
    release(const ContactValues &stopped);

    /**
     * The next attempt is unilateral: nodes do not change together, or zeros
     * are not to be had.
     */
    void
    finish_by_law();

    /**
     * The step to @p next is accepted; appends the event that it begins with
     * and the one that it ends with.
     *
     * @param finding of examine(); nothing for a unilateral step
     * @param known of a unilateral step; else found between its ends
     */
    void
    accept(const ContactValues                &next,
           const Finding                      &finding,
           std::vector<ContactEvent>          &events,
           const std::optional<ContactChange> &known = std::nullopt);

    /**
     * Nodes with pressure, and those whose gap is as good as zero: not above
     * the miss that an event may have, (C3.1).
     */
    std::vector<bool>
    closed_nodes(const ContactValues &values) const;

    /** The state that was accepted last was computed anew. */
    void
    set_present(const ContactValues &values)
    {
      present  = values;
      has_last = false;
    }

    /** The course of the margin before now tells nothing of the one behind:
     * loads have a jump or a kink. */
    void
    forget_last()
    {
      has_last = false;
    }

    /** The part that changes during a run. */
    const ContactProgress &
    progress() const
    {
      return *this;
    }

    void
    restore(const ContactProgress &progress)
    {
      ContactProgress::operator=(progress);
    }

    using ContactProgress::serialize;

  private:
    const ContactLaw &law;
    const ContactLaw *rear_law;
    const bool        is_active;
    const NodeOrder   nodes;
    const double      tolerance;
    const bool        has_small_changes;
    const bool        has_velocity;

    /**
     * A margin without slopes from s0 to s1 at @p end: the parabola through the
     * step end before, too, without which a dip between two ends is not seen;
     * a line if there is none.
     *
     * @param at_last the margin there
     */
    CubicHermite
    course(const double at_last,
           const double s0,
           const double s1,
           const double end) const;

    /** The law of the obstacle in front, 1, or behind, -1. */
    const ContactLaw &
    law_of(const int obstacle) const
    {
      return obstacle < 0 && rear_law != nullptr ? *rear_law : law;
    }

    /** True if the margin of a node is its pressure; all are at one obstacle.
     */
    bool
    is_margin_pressure() const
    {
      return mode_ == ContactMode::closed && law_of(side).ends_with_pressure();
    }

    /** Margin s of a node over the step. */
    CubicHermite
    margin(const LocalValues &next, const unsigned int node) const;

    /** examine() for the obstacle that sees these values. */
    Finding
    examine_local(const LocalValues &next,
                  const bool         is_aimed,
                  const BodyScales  &scales) const;

    /**
     * Change of the velocity of a node with mass from one part of a step to
     * another, by its margin; else 0.
     */
    double
    change_of_velocity(const CubicHermite &s,
                       const double        from,
                       const double        to,
                       const double        size) const;

    /** Of an event, a hundredth of what an error of this size may be, (C3.1).
     */
    double
    allowed_miss(const double size) const
    {
      return 0.01 * tolerance * size;
    }

    /** True if a margin s is as good as zero, (C3.1). */
    bool
    is_near(const ContactLaw &local_law,
            const double      s,
            const double      rate,
            const Scales     &sizes,
            const BodyScales &scales) const;

    ContactMode
    mode_of(const ContactValues &values) const;

    /**
     * The same of nodes without pressure: the law has to say whether one that
     * leaves faster than a dashpot follows comes back before it is outside.
     */
    ContactMode
    mode_without_pressure(const ContactValues &values) const;

    /** What vanishes where contact of a node begins or ends, for interpolation:
     * its gap, or minus its pressure within an obstacle with a dashpot. */
    double
    way_to_contact(const LocalValues &local, const unsigned int node) const;

    void
    add_event(const ContactEvent &event, std::vector<ContactEvent> &events);

    /** The events within a unilateral step, if there are any. */
    void
    accept_unilateral(const ContactValues                &next,
                      const std::optional<ContactChange> &known,
                      std::vector<ContactEvent>          &events);
  };
} // namespace ThermoContact

#endif
