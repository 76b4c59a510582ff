// SPDX-License-Identifier: LGPL-2.1-or-later

#include <thermocontact/base/exceptions.h>
#include <thermocontact/base/text.h>
#include <thermocontact/input/parameter_text.h>

#include <deal.II/base/utilities.h>

#include <boost/locale/utf.hpp>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <sstream>

namespace ThermoContact
{
  namespace
  {
    using dealii::Utilities::trim;

    // bytes; far more than any scene needs
    constexpr std::size_t max_file_size      = 64 << 20;
    constexpr std::size_t max_statement_size = 20000;

    /** The character at byte @p i of a text that may be UTF-8. */
    struct Character
    {
      Character(const std::string &text, const std::size_t i)
      {
        namespace utf    = boost::locale::utf;
        auto       next  = text.begin() + i;
        const auto point = utf::utf_traits<char>::decode(next, text.end());
        is_valid         = point != utf::illegal && point != utf::incomplete;
        n_bytes          = is_valid ? next - text.begin() - i : 1;
        code_point = is_valid ? point : static_cast<unsigned char>(text[i]);
      }

      bool        is_valid; ///< false: one byte that is not UTF-8
      std::size_t n_bytes;
      unsigned    code_point;
    };



    bool
    is_control(const unsigned code_point)
    {
      return code_point < 0x20 || (code_point >= 0x7F && code_point < 0xA0);
    }



    /** Looks like nothing or like a blank, and is neither. */
    bool
    is_invisible(const unsigned code_point)
    {
      return is_control(code_point) || code_point == 0xA0 ||
             code_point == 0xAD ||
             (code_point >= 0x2000 && code_point < 0x2010) ||
             (code_point >= 0x2028 && code_point < 0x2030) ||
             (code_point >= 0x205F && code_point < 0x2070) ||
             code_point == 0x3000 || code_point == 0xFEFF;
    }



    /** Names the fault of a line that no editor shows, or nothing. */
    std::string
    find_unreadable(const std::string &line)
    {
      if (line.find('\0') != std::string::npos)
        return "not a text file";
      const auto carriage_return = line.find('\r');
      if (carriage_return != std::string::npos &&
          carriage_return + 1 < line.size())
        return "a carriage return within the line";
      return "";
    }



    [[noreturn]] void
    fail(const std::string &place,
         const std::string &fault,
         const std::string &remedy)
    {
      throw InputError(place + ": " + fault + "\n  remedy:  " + remedy);
    }



    constexpr unsigned int max_depth = 10; // of sections, and of files



    /** Collects the statements of a file and of those that it includes. */
    class StatementReader
    {
    public:
      std::vector<Assignment> statements;

      /** @throw InputError with all faults */
      void
      read(std::istream &input, const std::string &name)
      {
        read_file(input, name, "", 0);
        throw_faults(faults);
      }

    private:
      struct OpenSection
      {
        std::string place;
        std::string path; ///< "Section/"
      };

      std::vector<std::string> faults;

      /** @param section in which it begins: nothing, or "Section/" */
      void
      read_file(std::istream      &input,
                const std::string &name,
                const std::string &section,
                const unsigned int n_files)
      {
        std::vector<OpenSection> open_sections{{"", section}};
        std::string              line, physical_line;
        unsigned int             n_lines = 0;
        while (std::getline(input, physical_line))
          {
            ++n_lines;
            const auto place = [&]() {
              return quote(name) + ", line " + std::to_string(n_lines);
            };
            if (const std::string fault = find_unreadable(physical_line);
                !fault.empty())
              fail(place(),
                   fault,
                   "give a parameter file, as text in UTF-8 with the line ends "
                   "of Unix or Windows");
            if (n_lines == 1 && begins_with(physical_line, "\xEF\xBB\xBF"))
              physical_line.erase(0, 3); // some editors mark UTF-8 so

            line += physical_line.substr(0, physical_line.find('#'));
            if (line.size() > max_statement_size)
              fail(place(),
                   "a statement of more than " +
                     std::to_string(max_statement_size) + " characters, '" +
                     quote(trim(line)) + "'",
                   "give a parameter file (.prm)");
            if (const std::string trimmed = trim(line);
                !trimmed.empty() && trimmed.back() == '\\')
              {
                line = trimmed.substr(0, trimmed.size() - 1) + " ";
                continue;
              }
            if (const std::string statement = trim(line); !statement.empty())
              try
                {
                  read_statement(
                    statement, place(), name, n_files, open_sections);
                }
              catch (const InputError &error)
                {
                  if (statements.empty())
                    throw; // no parameter file at all
                  faults.emplace_back(error.what());
                }
            line.clear();
          }

        if (!faults.empty())
          return; // they are told at the end
        if (!trim(line).empty())
          fail(quote(name),
               "the last line ends in '\\'",
               "complete the line or remove the '\\'");
        if (open_sections.size() > 1)
          fail(open_sections.back().place,
               "'end' is missing for subsection " +
                 quote(open_sections.back().path.substr(
                         0, open_sections.back().path.size() - 1),
                       60),
               "close each subsection with 'end'");
      }



      void
      read_statement(const std::string        &statement,
                     const std::string        &place,
                     const std::string        &name,
                     const unsigned int        n_files,
                     std::vector<OpenSection> &open_sections)
      {
        const auto        blank = statement.find_first_of(" \t");
        const std::string verb  = statement.substr(0, blank);
        const std::string rest =
          blank == std::string::npos ? "" : trim(statement.substr(blank));
        const auto        equal_sign = rest.find('=');
        const std::string entry      = equal_sign == std::string::npos ?
                                         "" :
                                         trim(rest.substr(0, equal_sign));
        const std::string section    = open_sections.back().path;

        if (verb == "subsection" && !rest.empty())
          {
            if (open_sections.size() > max_depth)
              fail(place,
                   "ten sections within each other",
                   "close each subsection with 'end'");
            open_sections.push_back({place, section + rest + "/"});
            statements.push_back({place, open_sections.back().path, ""});
          }
        else if (verb == "end" && rest.empty())
          {
            if (open_sections.size() == 1)
              fail(place, "'end' without 'subsection'", "remove the line");
            open_sections.pop_back();
          }
        else if (verb == "include" && !rest.empty())
          include(rest, place, name, section, n_files);
        else if (verb == "set" && !entry.empty() && entry.back() != '/')
          statements.push_back(
            {place, section + entry, trim(rest.substr(equal_sign + 1))});
        else
          fail(place,
               "cannot read '" + quote(statement) + "'",
               "a line is 'set Entry = value', 'subsection Name', 'end', "
               "'include FILE', a comment after '#', or empty");
      }



      void
      include(const std::string &file,
              const std::string &place,
              const std::string &name,
              const std::string &section,
              const unsigned int n_files)
      {
        if (n_files >= max_depth)
          fail(place, "ten files that include each other", "remove the line");
        const std::filesystem::path path =
          std::filesystem::path(name).parent_path() / file;
        std::string text;
        try
          {
            text = read_text(path.string());
          }
        catch (const InputError &error)
          {
            throw InputError(place + ": include " + error.what());
          }
        std::istringstream stream(text);
        read_file(stream, path.string(), section, n_files + 1);
      }
    };
  } // namespace



  std::string
  quote(const std::string &text, const unsigned int max_length)
  {
    std::string  quoted;
    unsigned int length = 0;
    for (std::size_t i = 0; i < text.size();)
      {
        if (++length > max_length)
          return quoted + "...";
        const Character character(text, i);
        if (!character.is_valid || is_invisible(character.code_point))
          {
            char number[16];
            std::snprintf(number,
                          sizeof(number),
                          character.is_valid ? "<U+%04X>" : "<byte %02X>",
                          character.code_point);
            quoted += number;
          }
        else
          quoted += text.substr(i, character.n_bytes);
        i += character.n_bytes;
      }
    return quoted;
  }



  bool
  is_plain_text(const std::string &text)
  {
    for (std::size_t i = 0; i < text.size();)
      {
        const Character character(text, i);
        if (!character.is_valid ||
            (is_control(character.code_point) && text[i] != '\t'))
          return false;
        i += character.n_bytes;
      }
    return true;
  }



  std::string
  read_text(const std::string &file_name, const std::string &wanted)
  {
    const bool  is_standard_input = file_name == "-";
    std::string remedy =
      "give " + (wanted.empty() ? "a parameter file (.prm)" : wanted);
    if (std::error_code absent;
        std::filesystem::exists(file_name + "/used.prm", absent))
      remedy += ": " + quote(file_name) + "/used.prm is the file of its run";
    const std::string place =
      is_standard_input ? "standard input" : quote(file_name);
    std::error_code not_found; // the stream says why
    if (std::filesystem::is_directory(file_name, not_found))
      fail(place, "is a directory", remedy);
    std::ifstream file;
    if (!is_standard_input)
      file.open(file_name, std::ios::binary);
    std::istream &input = is_standard_input ? std::cin : file;
    if (!input)
      fail(place,
           std::string("cannot be opened: ") + std::strerror(errno),
           "check its path");

    std::string             text;
    std::array<char, 65536> buffer;
    while (input && text.size() <= max_file_size)
      {
        input.read(buffer.data(), buffer.size());
        text.append(buffer.data(), input.gcount());
      }
    if (input.bad())
      fail(place, "cannot be read to its end", "check the file and the disk");
    if (text.size() > max_file_size)
      fail(place, "is larger than 64 MB", remedy);
    if (text.find_first_not_of(" \t\r\n\f\v") == std::string::npos)
      fail(place,
           "is empty",
           wanted.empty() ? "give another file; for the default scene one with "
                            "a comment, e.g. '# defaults'" :
                            remedy);
    return text;
  }



  std::vector<Assignment>
  read_assignments(std::istream &input, const std::string &name)
  {
    StatementReader reader;
    reader.read(input, name);
    return reader.statements;
  }



  std::vector<Assignment>
  read_parameter_file(const std::string &file_name)
  {
    const std::string  text = read_text(file_name);
    std::istringstream stream(text);
    return read_assignments(stream,
                            file_name == "-" ? "standard input" : file_name);
  }



  const Assignment *
  last_assignment(const std::vector<Assignment> &assignments,
                  const std::string             &path)
  {
    const auto last = std::find_if(assignments.rbegin(),
                                   assignments.rend(),
                                   [&](const Assignment &assignment) {
                                     return assignment.path == path;
                                   });
    return last == assignments.rend() ? nullptr : &*last;
  }



  void
  refuse(const Assignment  &assignment,
         const std::string &fault,
         const std::string &allowed,
         const std::string &remedy)
  {
    throw InputError(assignment.place + ": " + assignment.path + " = " +
                     quote(assignment.value) + ": " + fault +
                     (allowed.empty() ? "" : "\n  allowed: " + allowed) +
                     (remedy.empty() ? "" : "\n  remedy:  " + remedy));
  }



  void
  throw_faults(const std::vector<std::string> &faults)
  {
    constexpr unsigned int max_faults = 20;
    if (faults.empty())
      return;
    std::string message =
      faults.size() == 1 ? "" : std::to_string(faults.size()) + " faults";
    for (unsigned int i = 0; i < faults.size() && i < max_faults; ++i)
      message += (message.empty() ? "" : "\n") + faults[i];
    throw InputError(message);
  }



  Assignment
  parse_override(const std::string &argument)
  {
    const auto        equal_sign = argument.find('=');
    const std::string path       = trim(argument.substr(0, equal_sign));
    if (equal_sign == std::string::npos || path.empty() || path.back() == '/')
      throw InputError(std::string(command_line_place) +
                       ": cannot read '--set " + quote(argument) +
                       "'\n  remedy:  --set 'Section/Entry=value'");
    return {command_line_place, path, trim(argument.substr(equal_sign + 1))};
  }
} // namespace ThermoContact
