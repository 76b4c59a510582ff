// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef thermocontact_input_si_scene_h
#define thermocontact_input_si_scene_h

#include <thermocontact/contact/contact_law.h>
#include <thermocontact/input/declared_entries.h>
#include <thermocontact/input/parameter_text.h>
#include <thermocontact/input/quantity_units.h>

#include <map>
#include <optional>
#include <string>
#include <vector>

namespace ThermoContact
{
  /** True if section Rod is given: the file is in SI units. */
  bool
  is_in_si(const std::vector<Assignment> &assignments);

  /** True if section Bodies has bodies, and each is a mass. */
  bool
  have_masses_alone(const std::vector<Assignment> &assignments);

  /**
   * Makes a scene of masses alone one in SI units if it has a number with a
   * unit or a stiffness, and no section Rod: adds one of 1 m, 1 m^2, 1 kg/m^3
   * and 1 Pa, with which all numbers are those in SI base units. Not with a
   * temperature, whose scales are those of a material.
   */
  void
  add_scales_of_masses(std::vector<Assignment> &assignments);

  /**
   * The value of an entry in SI base units, without the unit: "3e-05" of "30
   * um". A text without a unit, and that of an entry that is no quantity, stay
   * as they are.
   *
   * @throw InputError if the unit is none, or of another kind of quantity
   */
  std::string
  without_unit(const Assignment &assignment);

  /** The unit of without_unit(); empty if the entry is no quantity. */
  std::string
  unit_of_entry(const std::string &path);



  /**
   * Makes a nondimensional scene of entries in SI units, doc/units.md. The only
   * place where the value of an entry loses its unit: a number is divided by
   * the scale of its kind of quantity; so is an expression, whose variables
   * become those of the scene times their scales.
   */
  class SiScene
  {
  public:
    /**
     * @param assignments of the whole file, the last one of a path; values
     *   of section Rod are known to fit
     * @param constants values of section Constants
     * @throw InputError if an entry that the scales follow from is not given,
     *   or another one that has no default in SI units
     */
    SiScene(const std::vector<Assignment>       &assignments,
            const std::map<std::string, double> &constants);

    /**
     * The value of one of the entries in the scene.
     *
     * @throw InputError if the unit is none, or of another kind of quantity, or
     *   the rod decides the entry
     */
    std::string
    value(const Assignment &assignment) const;

    /** The entries that follow from the others. */
    std::vector<Assignment>
    derived() const;

  private:
    const std::vector<Assignment>       &assignments;
    const std::map<std::string, double> &constants;
    const unsigned int                   dim;
    const bool                           has_temperature, has_displacement;
    const bool                           has_row;     ///< of bodies
    const bool                           is_confined; ///< no lateral strain
    const ContactLawKind                &law;         ///< of section Contact
    ScalesParameters                     scales;
    ConversionsByKind                    conversions; ///< to SI base units

    /** The last value that an entry is given. */
    std::optional<std::string>
    given(const std::string &path) const;

    /** All that the scales, and entries without a default, need. */
    void
    check_complete() const;

    /** The area of the body is that of its mesh. */
    void
    check_area() const;

    /** The number of an entry of section Rod; 0 if it is not given. */
    double
    rod(const std::string &entry) const;

    /** Modulus E* against axial strain, (U.1). */
    double
    modulus() const;

    void
    set_scales();

    /** The nondimensional number that an entry is given, or not a number. */
    double
    number(const std::string &path) const;

    /** One of the values of an entry that ';' or ',' separate. */
    std::string
    scaled(const Assignment &assignment, const std::string &text) const;

    /**
     * An expression in the variables of the scene.
     *
     * @throw InputError where it is written, if it is none
     */
    std::string
    in_scene_variables(const Assignment  &assignment,
                       const std::string &text) const;

    /** Paths of the stiffnesses of contact laws that are given. */
    std::vector<std::string>
    given_stiffnesses() const;

    /** True if the scene has the obstacle, or the contact, of this entry. */
    bool
    has_law_at(const std::string &path) const;

    /** The contact law that the entry at @p path is of. */
    const ContactLawKind &
    law_at(const std::string &path) const;

    /** Exponent m of that law. */
    double
    law_exponent(const std::string &path) const;

    /** A contact has Gap or this number of its law from section Contact. */
    bool
    takes_from_section(const std::string &entry) const;

    /**
     * A contact without a stiffness needs one of its own where that of section
     * Contact is of another power of the penetration.
     *
     * @throw InputError
     */
    void
    check_exponents() const;

    /** True for the time of a term that is dropped. */
    bool
    is_small(const double seconds) const;
  };



  /**
   * Refuses units, and stiffnesses of contacts, in a file without section Rod.
   *
   * @throw InputError
   */
  void
  refuse_units(const Assignment &assignment);

  /**
   * Gives @p entries, whose values are those of the scene, the values that a
   * file in SI units has, as used.prm shows them: the nondimensional ones, and
   * entries that follow from others, become remarks. Of another file those that
   * files in SI units alone have are removed.
   */
  void
  add_units(const std::vector<Assignment> &assignments,
            std::vector<DeclaredEntry>    &entries);

  /**
   * Leaves of @p entries those of the scene without units that have not their
   * default, with what a file in SI units has for them as remarks.
   */
  void
  remove_units(const std::vector<Assignment> &assignments,
               std::vector<DeclaredEntry>    &entries);



  /**
   * Doubts about numbers of a file in SI units that are unlikely in their SI
   * base unit, with the unit that was probably meant. A number with its unit is
   * not doubted.
   */
  std::vector<std::string>
  implausible_numbers(const std::vector<Assignment> &assignments);
} // namespace ThermoContact

#endif
