// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef thermocontact_contact_contact_law_h
#define thermocontact_contact_contact_law_h

#include <thermocontact/contact/interface_law.h>

#include <algorithm>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace ThermoContact
{
  /** The state of the contact nodes that a stage supposes. */
  enum class ContactMode
  {
    unilateral, ///< the contact law itself, (C2.4)
    open,       ///< $p=0$ for any gap
    closed      ///< in contact at all nodes, pressures of either sign
  };



  /**
   * The order in time of the equation of motion, of a body or at its contact
   * nodes: by it an event leaves values as they are, or changes them at once.
   */
  enum class NodeOrder
  {
    inertial, ///< mass: displacement and temperature go on, the velocity jumps
    viscous,  ///< no mass: displacement and temperature go on
    quasi_static ///< neither: they are in equilibrium at every time
  };



  /**
   * Contact condition at one node of the contact boundary: a monotone relation
   * between its penetration $s=u_n-g$ and its pressure $p$. No mesh, no matrix.
   *
   * In contact $s=s(p)$ with $s(0)=0$, else $p=0$ and $s\le0$, doc/model.md
   * (M1.4), (M1.5). The relation is asked for as $s(p)$ since that exists for
   * all obstacles: it is zero for a rigid one. Its resolvent is the local
   * problem of one node, (C2.2): the pressure that leaves the penetration
   * $z-rp=s(p)$, or 0 if $z\le0$. Nondimensional; pressures are positive if
   * they push the body back.
   */
  class ContactLaw : public InterfaceLaw
  {
  public:
    /**
     * @param damping,dashpot $c,d\ge0$, doc/model.md (M4.2):
     *   $p=[\varphi(s)[1+cv]_++dv]_+$ where $s\ge0$
     */
    explicit ContactLaw(const double damping = 0., const double dashpot = 0.)
      : damping_(damping)
      , dashpot_(dashpot)
    {}

    /** The obstacle with its numbers, for the screen. */
    std::string
    description() const;

    /** False if there is no obstacle. */
    virtual bool
    is_active() const
    {
      return true;
    }

    /** True if nothing penetrates: $s(p)=0$. */
    virtual bool
    is_rigid() const
    {
      return false;
    }

    /** $c$. */
    double
    damping() const
    {
      return damping_;
    }

    /** $d$. */
    double
    dashpot() const
    {
      return dashpot_;
    }

    /**
     * The pressure depends on the velocity. Then all else here is the elastic
     * law at $v=0$, its resolvent, too.
     */
    bool
    is_damped() const
    {
      return damping_ > 0. || dashpot_ > 0.;
    }

    /**
     * Contact ends with the pressure, and not with the penetration alone: a
     * dashpot has pressure at the first touch, and none where the node leaves
     * faster than the obstacle follows.
     */
    bool
    ends_with_pressure() const
    {
      return is_rigid() || dashpot_ > 0.;
    }

    /** Contact goes on without pressure while there is penetration. */
    bool
    can_be_silent() const
    {
      return damping_ > 0. && dashpot_ == 0.;
    }

    /** True if the pressure is proportional to the penetration, or the other
     * way round: on a rigid obstacle, or without one. */
    bool
    is_linear() const
    {
      return !is_damped() && has_constant_tangent();
    }

    /** $[1+cv]_+$. */
    double
    velocity_factor(const double v) const
    {
      return std::max(0., 1. + damping_ * v);
    }

    /**
     * Pressure that a penetration causes. 0 for negative ones and where the law
     * does not say, as for a rigid obstacle.
     */
    virtual double
    pressure(const double penetration) const = 0;

    /** Pressure that a penetration causes, at the normal velocity @p v. */
    double
    damped_pressure(const double penetration, const double v) const;

    /**
     * The same of a node that is held: odd in the penetration at rest, and of
     * either sign. At an instant; in a stage a node that is pulled has the
     * factor of the velocity with which it would touch, see Damped: both pull
     * by the miss of an event alone.
     */
    double
    held_pressure(const double penetration, const double v) const;

    /**
     * Impulse of the pressure on the way from the surface to a penetration, at
     * one velocity, times this velocity: its work.
     */
    double
    work_to(const double penetration, const double v) const;

    /** $s(p)$; odd, for the pressures of either sign of a held contact. */
    virtual double
    penetration(const double pressure) const = 0;

    /**
     * $ds/dp\ge0$; finite, but for $p=0$ where contact begins without
     * stiffness.
     */
    virtual double
    tangent(const double pressure) const = 0;

    /**
     * $\varepsilon$ of an obstacle that gives way by the same for all
     * pressures; nothing of all others.
     */
    std::optional<double>
    compliance() const
    {
      return is_active() && !is_rigid() && is_linear() ?
               std::optional<double>(tangent(1.)) :
               std::nullopt;
    }

    /**
     * Energy $\int p\,ds\ge0$ per unit area that the obstacle stores under a
     * pressure.
     */
    virtual double
    energy(const double pressure) const = 0;

    /** The penetration at which the obstacle stores an energy per area. */
    virtual double
    penetration_of_energy(const double energy) const = 0;

    /**
     * Mean pressure on the way between two penetrations,
     * $\int p\,ds/(s_1-s_0)$, to rounding also where they are close. 0 where
     * the law does not say, as for a rigid obstacle.
     */
    double
    mean_pressure(const double s_0, const double s_1) const;

    /**
     * The dissipation of a backward Euler step at the node, per area, (D4.3):
     * the work of the pressure at its end less the energy that is stored. Not
     * negative.
     *
     * @param change of the displacement over the step
     * @param old_penetration,old_pressure at its beginning
     * @param pressure at its end
     */
    virtual double
    numerical_dissipation(const double change,
                          const double old_penetration,
                          const double old_pressure,
                          const double pressure) const;

  protected:
    /** mean_pressure() between two positive penetrations. */
    virtual double
    mean_in_contact(const double s_0, const double s_1) const = 0;

    /** True if the tangent is the same for all pressures. */
    virtual bool
    has_constant_tangent() const
    {
      return true;
    }

    /** The obstacle without damping, with its numbers. */
    virtual std::string
    undamped_description() const = 0;

  private:
    const double damping_;
    const double dashpot_;
  };



  /** An obstacle that stores no energy: a rigid one, or none. */
  class StoresNothing : public ContactLaw
  {
  public:
    double
    pressure(const double) const override
    {
      return 0.;
    }

    double
    penetration(const double) const override
    {
      return 0.;
    }

    double
    tangent(const double) const override
    {
      return 0.;
    }

    double
    energy(const double) const override
    {
      return 0.;
    }

    double
    penetration_of_energy(const double) const override
    {
      return 0.;
    }

  protected:
    double
    mean_in_contact(const double, const double) const override
    {
      return 0.;
    }
  };



  /** A number of section Contact that a contact law is made of. */
  struct ContactLawEntry
  {
    std::string name;
    std::string kind; ///< of quantity
    double      default_value, smallest, largest;

    /** 0 is refused; a scene in SI units has no default of it. */
    bool is_positive;

    std::string text; ///< what it is, for the parameter reference
  };



  /** The values of such entries by their names. */
  using ContactLawParameters = std::map<std::string, double>;



  /** A kind of contact law: its name and the way to make it. */
  struct ContactLawKind
  {
    std::string name; ///< value of Contact/Condition
    std::string text; ///< what it is, for the parameter reference

    std::vector<ContactLawEntry> entries; ///< beside the entries of all laws

    std::function<std::unique_ptr<const ContactLaw>(
      const ContactLawParameters &)>
      make;

    /** True if it has an entry of that name. */
    bool
    uses(const std::string &entry) const;
  };



  /**
   * The contact laws of the program, the default first. To add one: a file that
   * defines its kind, and its name in the list.
   */
  const std::vector<ContactLawKind> &
  contact_laws();

  /** The kind of that name, which exists. */
  const ContactLawKind &
  contact_law(const std::string &name);

  /** The entries of all laws, each once. */
  std::vector<ContactLawEntry>
  contact_law_entries();

  /** Their default values. */
  ContactLawParameters
  default_law_parameters();

  // entries of several laws: $\varepsilon>0$, $c\ge0$ and $d\ge0$
  ContactLawEntry
  compliance_entry();

  ContactLawEntry
  damping_entry();

  ContactLawEntry
  dashpot_entry();

  // kinds that are asked for by name
  ContactLawKind
  normal_compliance();

  ContactLawKind
  rigid_obstacle();

  ContactLawKind
  no_obstacle();
} // namespace ThermoContact

#endif
