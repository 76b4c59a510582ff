// SPDX-License-Identifier: LGPL-2.1-or-later

#include "reach.h"

#include <sys/mman.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <iomanip>
#include <new>
#include <ostream>
#include <set>
#include <sstream>

namespace ThermoContact
{
  namespace
  {
    constexpr std::array<const char *, 8> columns = {{"accepted",
                                                      "in t",
                                                      "in y, z",
                                                      "in gap, p",
                                                      "study",
                                                      "body",
                                                      "rod runs",
                                                      "body runs"}};



    /** The words of a formula. */
    std::set<std::string>
    words_of(std::string text)
    {
      std::replace_if(
        text.begin(),
        text.end(),
        [](const unsigned char c) { return std::isalnum(c) == 0; },
        ' ');
      std::istringstream    stream(text);
      std::set<std::string> words;
      for (std::string word; stream >> word;)
        words.insert(word);
      return words;
    }
  } // namespace



  Reach::Reach()
  {
    for (const std::string &path : paths_read())
      rows.emplace(path, rows.size());
    void *const memory = mmap(nullptr,
                              rows.size() * columns.size() * sizeof(*counts),
                              PROT_READ | PROT_WRITE,
                              MAP_SHARED | MAP_ANONYMOUS,
                              -1,
                              0);
    if (memory == MAP_FAILED)
      throw std::bad_alloc();
    counts = static_cast<unsigned long *>(memory);
  }



  void
  Reach::add(const Reading &reading)
  {
    for (const auto &[path, value] : reading.entries)
      {
        const auto row = rows.find(path);
        if (row == rows.end())
          continue; // a scene's in a file of a rod: counted as that
        const auto depends = [words = words_of(value)](const char *const name) {
          return words.count(name) > 0;
        };
        const bool                             is_body = reading.dimension > 1;
        const std::array<bool, columns.size()> is_of   = {
            {true,
             depends("t"),
             depends("y") || depends("z"),
             depends("gap") || depends("pressure"),
             reading.is_study,
             is_body,
             reading.has_begun && !is_body,
             reading.has_begun && is_body}};
        for (unsigned int column = 0; column < columns.size(); ++column)
          counts[row->second * columns.size() + column] += is_of[column];
      }
  }



  void
  Reach::print(std::ostream &output) const
  {
    output << std::left << std::setw(36) << "entry" << std::right;
    for (const char *const column : columns)
      output << std::setw(10) << column;
    output << '\n';
    for (const auto &[path, row] : rows)
      {
        output << std::left << std::setw(36) << path << std::right;
        for (unsigned int column = 0; column < columns.size(); ++column)
          output << std::setw(10) << counts[row * columns.size() + column];
        output << '\n';
      }
  }



  std::vector<std::string>
  Reach::missed() const
  {
    std::vector<std::string> paths;
    for (const auto &[path, row] : rows)
      if (counts[row * columns.size()] == 0)
        paths.push_back(path);
    return paths;
  }
} // namespace ThermoContact
