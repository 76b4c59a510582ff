// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef thermocontact_input_si_scene_h
#define thermocontact_input_si_scene_h

#include <thermocontact/input/declared_entries.h>
#include <thermocontact/input/parameter_text.h>
#include <thermocontact/input/parameters.h>

#include <string>
#include <vector>

namespace ThermoContact
{
  /** True if section Rod is given: the file is in SI units. */
  bool
  is_in_si(const std::vector<Assignment> &assignments);

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
   * The nondimensional scene of a file in SI units, doc/units.md: the only
   * place where the value of an entry loses its unit.
   *
   * @param assignments of the whole file; the last one of a path counts
   * @param entries all that there are
   * @param rod the section Rod of @p assignments
   * @return the values of @p assignments in the scene, in their order, then the
   *   entries that follow from them
   * @throw InputError if an entry that the scales follow from is not given, or
   *   another one that has no default in SI units; if a unit is none, or of
   *   another kind of quantity; if the rod decides an entry
   */
  std::vector<Assignment>
  without_units(const std::vector<Assignment>    &assignments,
                const std::vector<DeclaredEntry> &entries,
                const RodParameters              &rod);

  /**
   * Refuses units, and Contact/Stiffness, in a file without section Rod.
   *
   * @throw InputError
   */
  void
  refuse_units(const std::vector<Assignment> &assignments);

  /**
   * Gives @p entries, whose values are those of the scene, the values that a
   * file in SI units has, as used.prm shows them: the nondimensional ones, and
   * entries that follow from others, become remarks.
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
} // namespace ThermoContact

#endif
