// SPDX-License-Identifier: LGPL-2.1-or-later

#include <thermocontact/input/declared_entries.h>

#include <deal.II/base/utilities.h>

#include <nlohmann/json.hpp>

#include <cstring>
#include <sstream>

namespace ThermoContact
{
  namespace
  {
    using Json = nlohmann::ordered_json;

    void
    collect_entries(const Json                 &node,
                    const std::string          &prefix,
                    std::vector<DeclaredEntry> &entries)
    {
      for (const auto &item : node.items())
        if (item.value().contains("pattern_description"))
          entries.push_back({prefix + item.key(),
                             item.value().at("value"),
                             item.value().at("default_value"),
                             item.value().at("documentation"),
                             item.value().at("pattern_description")});
        else
          collect_entries(item.value(), prefix + item.key() + "/", entries);
    }
  } // namespace



  std::vector<DeclaredEntry>
  declared_entries(const ParameterHandler &prm)
  {
    std::stringstream text;
    prm.print_parameters(text,
                         ParameterHandler::JSON |
                           ParameterHandler::KeepDeclarationOrder);
    std::vector<DeclaredEntry> entries;
    collect_entries(Json::parse(text), "", entries);
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
    if (pattern.rfind("Selection ", 0) == 0)
      {
        pattern.erase(0, std::strlen("Selection "));
        replace("|", " | ");
      }
    return dealii::Utilities::trim(pattern);
  }
} // namespace ThermoContact
