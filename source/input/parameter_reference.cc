// SPDX-License-Identifier: LGPL-2.1-or-later

#include <thermocontact/input/declared_entries.h>
#include <thermocontact/input/parameter_file.h>
#include <thermocontact/input/unknown_names.h>

#include <deal.II/base/utilities.h>

#include <cstring>
#include <ostream>
#include <string>

namespace ThermoContact
{
  namespace
  {
    /** Plain text as Markdown, in a table: its special characters escaped. */
    std::string
    escape(const std::string &text)
    {
      std::string escaped;
      for (const char c : text)
        {
          if (std::strchr("\\`*_<|$#@[]", c) != nullptr)
            escaped += '\\';
          escaped += c;
        }
      return escaped;
    }



    /** The allowed values of an entry; the words of a list as code. */
    std::string
    allowed_values(const DeclaredEntry &entry)
    {
      const std::string words =
        dealii::Utilities::replace_in_string(describe_allowed(entry),
                                             "a number from ",
                                             "");
      if (words.find(" | ") == std::string::npos)
        return escape(words);
      std::string list;
      for (const std::string &word :
           dealii::Utilities::split_string_list(words, '|'))
        list += (list.empty() ? "`" : ", `") + word + "`";
      return list;
    }
  } // namespace



  void
  write_parameter_reference(const ParameterHandler &prm, std::ostream &output)
  {
    const std::string table = "| entry | default | allowed | meaning |\n"
                              "|---|---|---|---|\n";
    output << R"(# Parameters

Every entry of a parameter file, as `thermocontact --print-parameters=markdown`
writes this page. An entry stands in its section (`subsection Mesh` ... `end`), and
one that is not given has its default. On the command line
`--set 'Mesh/Cells=16'` overrides it.

)" << table;
    std::string open_section;
    for (const DeclaredEntry &entry : declared_entries(prm))
      {
        const std::string section = section_of(entry.path);
        if (section != open_section)
          output << "\n## " << section << "\n\n" << table;
        open_section = section;
        output << "| `" << name_of(entry.path) << "` | "
               << (entry.default_value.empty() ?
                     "(empty)" :
                     '`' + entry.default_value + '`')
               << " | " << allowed_values(entry) << " | " << escape(entry.text)
               << " |\n";
      }
  }
} // namespace ThermoContact
