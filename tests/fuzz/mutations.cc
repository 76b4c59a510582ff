// SPDX-License-Identifier: LGPL-2.1-or-later

#include <thermocontact/input/si_scene.h>

#include "mutations.h"

#include <sstream>

#include "entries.h"

namespace ThermoContact
{
  namespace
  {
    const std::vector<std::string> odd_tokens = {"0",
                                                 "-0",
                                                 "-1",
                                                 "1e308",
                                                 "-1e308",
                                                 "1e-308",
                                                 "1e-320",
                                                 "1e309",
                                                 "nan",
                                                 "-nan",
                                                 "inf",
                                                 "-inf",
                                                 "automatic",
                                                 "99999999999",
                                                 "1e5",
                                                 "1e15",
                                                 "1e16",
                                                 "4294967295",
                                                 "2147483648",
                                                 "-2147483649",
                                                 "18446744073709551616",
                                                 "0x10",
                                                 "1e",
                                                 "1.5.2",
                                                 ".",
                                                 "1,5",
                                                 "+1",
                                                 "true",
                                                 "none",
                                                 "set",
                                                 "end",
                                                 "subsection",
                                                 "subsection Model",
                                                 "=",
                                                 "==",
                                                 "#",
                                                 "\\",
                                                 ";",
                                                 ";;",
                                                 "|",
                                                 "(",
                                                 ")",
                                                 "((((((((((",
                                                 "/",
                                                 "Model/",
                                                 "x",
                                                 "y",
                                                 "t",
                                                 "theta_A",
                                                 "pi",
                                                 "if(x<1,1,2)",
                                                 "x>0.5",
                                                 "1/x",
                                                 "1/(x-0.5)",
                                                 "rand()",
                                                 "sqrt(-x)",
                                                 "x^x",
                                                 "exp(1000*x)",
                                                 "sin (x)",
                                                 "gap",
                                                 "pressure",
                                                 "exp(-gap)",
                                                 "sin(2*pi*t)",
                                                 "sin(1e6*t)",
                                                 "if(t<0.1,1,0)",
                                                 "1/t",
                                                 "t^1.5",
                                                 "theta",
                                                 "273.15",
                                                 "20 C",
                                                 "ms",
                                                 "us",
                                                 "C",
                                                 "infinity",
                                                 "sin(x",
                                                 "x ? 1 : 2",
                                                 "\"x\"",
                                                 "x=2",
                                                 "\xC2\xA0",
                                                 "\xEF\xBB\xBF",
                                                 "\xE2\x80\xAF",
                                                 "\xF0\x9F\x94\xA5",
                                                 "\xFF\xFE",
                                                 "\xED\xA0\x80",
                                                 "\x1B[31m",
                                                 "\r",
                                                 "\r\n",
                                                 "\t",
                                                 "%s%n",
                                                 "../../x",
                                                 "/dev/null",
                                                 "."};

    /** Numbers of files with the same seed of scripts/fuzz. */
    constexpr unsigned long n_of_seed = 1000000000;

    std::size_t
    pick(const std::size_t n, std::mt19937_64 &generator)
    {
      return n == 0 ? 0 : generator() % n;
    }



    std::vector<std::string>
    split_lines(const std::string &text)
    {
      std::vector<std::string> lines;
      std::istringstream       stream(text);
      for (std::string line; std::getline(stream, line);)
        lines.push_back(line);
      return lines;
    }
  } // namespace



  Mutations::Mutations(const std::vector<std::string> &files)
    : files(files)
    , tokens(odd_tokens)
  {
    of_scenes.listed = listed_values("scene_values.txt");
    of_rods.listed   = listed_values("rod_values.txt");
    for (const std::string &file : files)
      {
        const std::vector<Assignment> given = statements(file);
        is_rod.push_back(is_in_si(given));
        for (const Assignment &entry : given)
          if (!entry.is_section())
            (is_rod.back() ? of_rods : of_scenes).of_files.push_back({entry});
      }
    for (const std::string &file : files)
      for (const std::string &line : split_lines(file))
        {
          lines.push_back(line);
          std::istringstream stream(line.substr(0, line.find('#')));
          for (std::string token; stream >> token;)
            tokens.push_back(token);
        }
  }



  std::string
  Mutations::new_token(Generator &generator) const
  {
    switch (pick(8, generator))
      {
        case 0:
          {
            const std::size_t n      = std::size_t(1) << pick(16, generator);
            const char        letter = "x(9 \\;\n1-"[pick(9, generator)];
            if (letter == '(' && pick(2, generator) == 0)
              return std::string(n / 4, '(') + 't' + std::string(n / 4, ')');
            return std::string(n, letter);
          }
        case 1:
          return std::to_string(static_cast<double>(generator()) / (1 << 30));
        case 2:
        case 3:
          return tokens[pick(tokens.size(), generator)];
        default:
          return odd_tokens[pick(odd_tokens.size(), generator)];
      }
  }



  std::size_t
  Mutations::pick_file(Generator &generator) const
  {
    const bool  for_rod = pick(5, generator) == 0;
    std::size_t file    = pick(files.size(), generator);
    while (for_rod && !is_rod[file])
      file = (file + 1) % files.size();
    return file;
  }



  const Group &
  Mutations::new_entries(const bool for_rod, Generator &generator) const
  {
    // what is none of the rod stands in its scene
    const Values &values =
      for_rod && pick(3, generator) > 0 ? of_rods : of_scenes;
    const std::vector<Group> &list =
      pick(3, generator) > 0 ? values.listed : values.of_files;
    return list[pick(list.size(), generator)];
  }



  void
  Mutations::mutate_line(std::string &text, Generator &generator) const
  {
    std::vector<std::string> parts = split_lines(text);
    if (parts.empty())
      parts.emplace_back();
    const std::size_t at = pick(parts.size(), generator);
    switch (pick(6, generator))
      {
        case 0:
          parts.erase(parts.begin() + at);
          break;
        case 1:
          parts.insert(parts.begin() + at, parts[at]);
          break;
        case 2:
          std::swap(parts[at], parts[pick(parts.size(), generator)]);
          break;
        case 3:
          parts[at] = lines[pick(lines.size(), generator)];
          break;
        case 4:
          parts.insert(parts.begin() + at,
                       lines[pick(lines.size(), generator)]);
          break;
        default: // another value
          parts[at] = parts[at].substr(0, parts[at].find('=')) + "= " +
                      new_token(generator);
      }
    text.clear();
    for (const std::string &part : parts)
      text += part + "\n";
  }



  void
  Mutations::mutate(std::string &text, Generator &generator) const
  {
    const std::size_t at = pick(text.size(), generator);
    switch (pick(10, generator))
      {
        case 0:
          if (!text.empty())
            text[at] = static_cast<char>(text[at] ^ (1 << pick(8, generator)));
          break;
        case 1:
          text.insert(at, 1, static_cast<char>(generator() & 0xFF));
          break;
        case 2:
          if (pick(4, generator) == 0)
            text.erase(at);
          else
            text.erase(at, 1 + pick(20, generator));
          break;
        case 3:
        case 4:
          {
            // a token of the text gives way to another one
            const auto begin = text.find_first_not_of(" \n=", at);
            if (begin != std::string::npos)
              text.replace(begin,
                           text.find_first_of(" \n", begin) - begin,
                           new_token(generator));
            break;
          }
        case 5:
          text.insert(at, new_token(generator));
          break;
        default:
          mutate_line(text, generator);
      }
  }



  bool
  Mutations::is_valid(const unsigned long number) const
  {
    return number % n_of_seed < files.size();
  }



  std::string
  Mutations::make(const unsigned long number) const
  {
    if (is_valid(number))
      return files[number % n_of_seed];
    Generator         generator(number);
    const std::size_t file     = pick_file(generator);
    const std::size_t n_groups = pick(5, generator);
    std::string       text     = files[file];
    for (std::size_t n = 0; n < n_groups; ++n)
      for (const Assignment &entry : new_entries(is_rod[file], generator))
        text = with_entry(text, entry);
    if (n_groups > 0 && pick(3, generator) > 0)
      return text;
    for (std::size_t n = 1 + pick(4, generator); n > 0; --n)
      mutate(text, generator);
    return text;
  }
} // namespace ThermoContact
