// SPDX-License-Identifier: LGPL-2.1-or-later

#include <thermocontact/base/text.h>
#include <thermocontact/input/own_law.h>

#include <deal.II/base/utilities.h>

#include <algorithm>
#include <cctype>

namespace ThermoContact
{
  namespace
  {
    const std::string rear = "Rear";



    /** A name that stands behind a word begins with a small letter. */
    std::string
    name_behind(const std::string &first_word, std::string name)
    {
      if (first_word.empty())
        return name;
      name.front() = static_cast<char>(std::tolower(name.front()));
      return first_word + ' ' + name;
    }
  } // namespace



  bool
  OwnLaw::is_given() const
  {
    return std::any_of(numbers.begin(), numbers.end(), [](const auto &entry) {
      return entry.second.has_value();
    });
  }



  bool
  OwnLaw::has_number(const std::string &name) const
  {
    const auto entry = numbers.find(name);
    return entry != numbers.end() && entry->second.has_value();
  }



  ContactLawParameters
  OwnLaw::instead_of(const ContactLawParameters &general) const
  {
    ContactLawParameters result = general;
    for (const auto &[name, value] : numbers)
      if (value)
        result[name] = *value;
    return result;
  }



  std::string
  OwnLaw::path(const std::string &name) const
  {
    return section + '/' + name_behind(first_word, name);
  }



  void
  OwnLaw::add_entries(SectionOfEntries &entry, const std::string &whose)
  {
    const auto name_of_entry = [this](const std::string &name) {
      return name_behind(first_word, name);
    };
    // by name, since copies of a map have nodes of their own
    for (const ContactLawEntry &one : contact_law_entries())
      entry
        .unbound(name_of_entry(one.name),
                 word,
                 NumberOrText::word_or_number(
                   word, dealii::Patterns::Double(one.smallest, one.largest)),
                 [this, name = one.name](const std::string &given) {
                   numbers[name].reset();
                   if (given != word)
                     numbers[name] = dealii::Utilities::string_to_double(given);
                 })
        .means(one.name + ' ' + whose + "; " + word + ": Contact/" + one.name +
                 '.',
               one.kind);
    entry(name_of_entry("Stiffness"), stiffness, NumberOrText::word("none"))
      .means("In place of " + name_of_entry("Compliance") +
               ", as Contact/Stiffness.",
             "stiffness");
  }



  std::string
  path_in_same_law(const std::string &path, const std::string &name)
  {
    const auto slash = path.find_last_of('/');
    return path.substr(0, slash + 1) +
           name_behind(begins_with(path.substr(slash + 1), rear + ' ') ? rear :
                                                                         "",
                       name);
  }
} // namespace ThermoContact
