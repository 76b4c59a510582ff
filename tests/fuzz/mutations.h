// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef thermocontact_fuzz_mutations_h
#define thermocontact_fuzz_mutations_h

#include <random>
#include <string>
#include <vector>

namespace ThermoContact
{
  /** Makes faulty parameter files out of valid ones. */
  class Mutations
  {
  public:
    /** @param files texts of valid parameter files */
    explicit Mutations(const std::vector<std::string> &files);

    /** The file of a number: the same one each time. */
    std::string
    make(const unsigned long number) const;

  private:
    using Generator = std::mt19937_64;

    std::vector<std::string> files;
    std::vector<std::string> lines;
    std::vector<std::string> tokens;

    /** Changes @p text at one place, in one of many ways. */
    void
    mutate(std::string &text, Generator &generator) const;

    /** Replaces, repeats, moves or removes a whole line. */
    void
    mutate_line(std::string &text, Generator &generator) const;

    /** What replaces a token: of another file, extreme, or odd. */
    std::string
    new_token(Generator &generator) const;
  };
} // namespace ThermoContact

#endif
