// SPDX-License-Identifier: LGPL-2.1-or-later

#include <thermocontact/base/text.h>
#include <thermocontact/input/scope_page.h>

#include <deal.II/base/utilities.h>

#include <cctype>
#include <regex>
#include <sstream>
#include <vector>

namespace ThermoContact
{
  namespace
  {
    /** The cells of a row of a table, of three columns, or nothing. */
    std::vector<std::string>
    cells_of(const std::string &line)
    {
      const auto words = dealii::Utilities::split_string_list(line, '|');
      return words.size() == 4 && line.front() == '|' ?
               std::vector<std::string>(words.begin() + 1, words.end()) :
               std::vector<std::string>();
    }



    /** Without the signs of Markdown. */
    std::string
    plain(const std::string &text)
    {
      const std::regex link(R"(\[([^\]]*)\]\([^)]*\))"), code("`");
      return std::regex_replace(std::regex_replace(text, link, "$1"), code, "");
    }



    std::string
    lower_case(std::string text)
    {
      for (char &letter : text)
        letter = std::tolower(static_cast<unsigned char>(letter));
      return text;
    }



    /** Whether @p name has @p phrase as whole words, or as their plural. */
    bool
    has_phrase(const std::string &name, const std::string &phrase)
    {
      const auto is_letter = [&name](const std::size_t at) {
        return at < name.size() &&
               std::isalpha(static_cast<unsigned char>(name[at])) != 0;
      };
      for (std::size_t begin = name.find(phrase); begin != name.npos;
           begin             = name.find(phrase, begin + 1))
        {
                      std::size_t end = begin + phrase.size();
                      if (end < name.size() && name[end] == 's')
            ++end;
          if (!is_letter(end) && (begin == 0 || !is_letter(begin - 1)))
            return true;
        }
      return false;
    }
  } // namespace



  std::string
  scope_answer(const std::string &name)
  {
    const std::string  asked = lower_case(name);
    std::string        answer;
    std::size_t        longest = 0; // the phrase that says most
    std::istringstream page(scope_page);
    for (std::string line; std::getline(page, line);)
      if (const std::vector<std::string> cells = cells_of(line); !cells.empty())
        for (const std::string &word :
             dealii::Utilities::split_string_list(cells[0], ','))
          if (word.size() > longest && has_phrase(asked, lower_case(word)))
            {
              longest = word.size();
              answer  = "\n  answer:  " + word + " is " + plain(cells[1]) +
                       "\n  remedy:  " +
                       (cells[2].empty() ? "leave it out" : plain(cells[2])) +
                       "\n  more:    doc/scope.md";
            }
    return answer;
  }
} // namespace ThermoContact
