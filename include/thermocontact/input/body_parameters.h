// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef thermocontact_input_body_parameters_h
#define thermocontact_input_body_parameters_h

#include <thermocontact/input/own_law.h>
#include <thermocontact/input/parameter_text.h>

#include <deal.II/base/parameter_handler.h>

#include <optional>
#include <string>
#include <vector>

namespace ThermoContact
{
  using dealii::ParameterHandler;

  /** A number, or else an expression of x along a rod, over the one of section
   * Model or Rod. */
  struct RodCoefficient
  {
    double      value = 1.;
    std::string expression;
  };



  /** A body of a row, section Bodies/NAME, (M10.1). */
  struct BodyParameters
  {
    std::string  name;
    std::string  kind   = "rod";
    double       length = 1.;
    unsigned int cells  = 0;  ///< 0: automatic, until a Scene has it
    double       mass   = 1.; ///< $m$

    RodCoefficient section;       ///< $A$
    RodCoefficient stiffness;     ///< $E$
    RodCoefficient density;       ///< $\rho$
    RodCoefficient viscosity;     ///< of $\zeta$
    RodCoefficient conductivity;  ///< $K$
    RodCoefficient heat_capacity; ///< $c$, or $C$ of a mass

    /** Of $a=E\alpha$, a number or an expression; none: as stiffness, so that
     * $\alpha$ is the same. */
    std::string coupling = "none";

    /** $\nu$, dim > 1, a number or an expression; none: of section Model. */
    std::string poisson_ratio = "none";

    std::string temperature  = "0";
    std::string displacement = "0";
    std::string velocity     = "0";

    bool
    is_mass() const
    {
      return kind == "mass";
    }

    /** Declares the section of the body of that name. */
    void
    add_parameters(ParameterHandler &prm);
  };



  /** Two neighbours of a row, section Contacts/LEFT RIGHT. */
  struct PairParameters
  {
    std::string           name;                  ///< "LEFT RIGHT"
    std::string           condition = "contact"; ///< or bonded, or a law
    std::optional<double> gap;                   ///< none: Contact/Gap
    std::optional<double> heat_exchange;         ///< none: Boundary/right
    OwnLaw                own_law{"", "", "none", {}, {}};

    bool
    is_bonded() const
    {
      return condition == "bonded";
    }

    /** The law is of a kind that need not be that of section Contact. */
    bool
    has_own_kind() const
    {
      return condition != "contact" && !is_bonded();
    }

    bool
    has_own_law() const
    {
      return has_own_kind() || (!is_bonded() && own_law.is_given());
    }

    /** The kind of law of a contact, @p general of section Contact. */
    const ContactLawKind &
    law_kind(const ContactLawKind &general) const
    {
      return has_own_kind() ? contact_law(condition) : general;
    }

    void
    add_parameters(ParameterHandler &prm);
  };



  /** The bodies of a row in the order of x, and pairs of neighbours. */
  struct RowParameters
  {
    std::vector<BodyParameters> bodies;
    std::vector<PairParameters> pairs;

    bool
    is_given() const
    {
      return !bodies.empty();
    }

    /** True if any body is more than a rigid mass. */
    bool
    has_rods() const;

    /** The pair "LEFT RIGHT"; null: no entry is given of it. */
    const PairParameters *
    find_pair(const std::string &name) const;

    /** Each pair of neighbours has a kind of law of its own or is bonded, and
     * one has. */
    bool
    have_own_kinds() const;

    /** Declares the sections that stand for those of any name. */
    static void
    add_templates(ParameterHandler &prm);

    /**
     * Declares and binds the sections that the assignments name, in the order
     * in which these do.
     *
     * @throw InputError if a name cannot be one of a body
     */
    void
    add_parameters(const std::vector<Assignment> &assignments,
                   ParameterHandler              &prm);
  };



  /**
   * The path of the entry or section as it is declared for all names:
   * Bodies/NAME/Length of Bodies/bar/Length. Other paths stay as they are.
   */
  std::string
  declared_path(const std::string &path);

  /** Whether the path is of a section that stands for those of any name. */
  bool
  is_template_path(const std::string &path);
} // namespace ThermoContact

#endif
