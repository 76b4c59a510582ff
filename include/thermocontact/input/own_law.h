// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef thermocontact_input_own_law_h
#define thermocontact_input_own_law_h

#include <thermocontact/contact/contact_law.h>
#include <thermocontact/input/section_of_entries.h>

#include <map>
#include <optional>
#include <string>

namespace ThermoContact
{
  /**
   * Numbers of a contact law that stand in the place of those of section
   * Contact, for a stop behind or for a pair of bodies.
   */
  struct OwnLaw
  {
    std::string section; ///< of its entries

    /** The word that their names begin with there, "Rear", or nothing. */
    std::string first_word;

    /** The word of an entry that is as in section Contact. */
    std::string word;

    /** By the names of section Contact; none: as there. */
    std::map<std::string, std::optional<double>> numbers;

    std::optional<double> stiffness; ///< as ContactParameters::stiffness

    bool
    is_given() const;

    bool
    has_number(const std::string &name) const;

    /** The numbers of section Contact with its own. */
    ContactLawParameters
    instead_of(const ContactLawParameters &general) const;

    /** The path of its entry that section Contact has by this name. */
    std::string
    path(const std::string &name) const;

    /**
     * Declares its entries.
     *
     * @param whose "of the obstacle behind the end"; for the reference
     */
    void
    add_entries(SectionOfEntries &entry, const std::string &whose);
  };



  /** The path of the entry @p name of the law that has the entry @p path. */
  std::string
  path_in_same_law(const std::string &path, const std::string &name);
} // namespace ThermoContact

#endif
