// SPDX-License-Identifier: LGPL-2.1-or-later

#include <thermocontact/base/text.h>
#include <thermocontact/input/declared_entries.h>

#include <deal.II/base/utilities.h>

#include <boost/property_tree/ptree.hpp>

#include <cstring>
#include <sstream>

namespace ThermoContact
{
  namespace
  {
    using Tree = boost::property_tree::ptree;

    /** A name of an entry or section as declared: other bytes are _xx there. */
    std::string
    declared_name(const std::string &name)
    {
      std::string result;
      for (std::size_t i = 0; i < name.size(); ++i)
        if (name[i] == '_' && i + 2 < name.size())
          {
            result +=
              static_cast<char>(std::stoi(name.substr(i + 1, 2), nullptr, 16));
            i += 2;
          }
        else
          result += name[i];
      return result;
    }



    /**
     * An archive that a ParameterHandler is saved to: takes the tree of its
     * entries. Its formats of text, the other way to all entries, cost as much
     * as half of a short run.
     */
    class EntryCollector
    {
    public:
      explicit EntryCollector(std::vector<DeclaredEntry> &entries)
        : entries(entries)
      {}

      EntryCollector &
      operator&(const Tree &tree)
      {
        collect(tree, "");
        return *this;
      }

      /** Nothing else of it is of use. */
      template <typename Other>
      EntryCollector &
      operator&(const Other &)
      {
        return *this;
      }

    private:
      std::vector<DeclaredEntry> &entries;

      void
      collect(const Tree &node, const std::string &prefix)
      {
        for (const auto &[name, item] : node)
          if (const auto value = item.find("value");
              value != item.not_found() && item.count("pattern") > 0)
            {
              std::string text = item.get<std::string>("documentation"), kind;
              if (const auto bracket = text.rfind(" [");
                  bracket != std::string::npos && text.back() == ']')
                {
                  kind = text.substr(bracket + 2, text.size() - bracket - 3);
                  text.erase(bracket);
                }
              entries.push_back({prefix + declared_name(name),
                                 value->second.data(),
                                 item.get<std::string>("default_value"),
                                 text,
                                 item.get<std::string>("pattern_description"),
                                 kind});
            }
          else
            collect(item, prefix + declared_name(name) + "/");
      }
    };
  } // namespace



  std::vector<std::string>
  DeclaredEntry::variables(const unsigned int dim) const
  {
    const std::string        words = "an expression in ";
    const auto               begin = pattern.find(words);
    std::vector<std::string> known;
    if (begin == std::string::npos)
      return known;
    std::istringstream names(pattern.substr(begin + words.size()));
    for (std::string name; std::getline(names, name, ',');)
      {
        name = dealii::Utilities::trim(name.substr(0, name.find(']')));
        if (!((name == "y" && dim < 2) || (name == "z" && dim < 3)))
          known.push_back(name);
      }
    return known;
  }



  std::vector<DeclaredEntry>
  declared_entries(const ParameterHandler &prm)
  {
    std::vector<DeclaredEntry> entries;
    EntryCollector             collector(entries);
    prm.save(collector, 0);
    return entries;
  }



  std::string
  describe_pattern(std::string pattern)
  {
    const auto replace = [&pattern](const std::string &from,
                                    const std::string &to) {
      for (auto at = pattern.find(from); at != std::string::npos;
           at      = pattern.find(from, at + to.size()))
        pattern.replace(at, from.size(), to);
    };
    replace("[", "");
    replace("]", "");
    replace(" (inclusive)", "");
    replace("List of <", "");
    replace("> of length 0...100000 separated by <;>", ", ';' between them");
    replace(" -MAX_DOUBLE...MAX_DOUBLE", "");
    replace("...MAX_DOUBLE", " or more");
    replace("...", " to ");
    const bool is_range = pattern.find(" to ") != std::string::npos;
    replace("Integer range", "Integer");
    replace("Double", is_range ? "a number from" : "a number");
    replace("Integer", is_range ? "a whole number from" : "a whole number");
    replace("Bool", "true | false");
    replace("Anything", "any text");
    if (begins_with(pattern, "Selection "))
      {
        pattern.erase(0, std::strlen("Selection "));
        replace("|", " | ");
      }
    return dealii::Utilities::trim(pattern);
  }



  std::string
  describe_allowed(const DeclaredEntry &entry)
  {
    for (const ContactLawEntry &one : contact_law_entries())
      if (one.is_positive && entry.path == "Contact/" + one.name)
        return text("a positive number up to ", one.largest);
    return describe_pattern(entry.pattern);
  }
} // namespace ThermoContact
