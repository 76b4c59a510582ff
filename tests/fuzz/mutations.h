// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef thermocontact_fuzz_mutations_h
#define thermocontact_fuzz_mutations_h

#include <random>
#include <string>
#include <vector>

#include "entries.h"

namespace ThermoContact
{
  /**
   * Makes parameter files out of valid ones: entries get other values, listed
   * here or from other files, and about half of them get faults.
   */
  class Mutations
  {
  public:
    /** @param files texts of valid parameter files */
    explicit Mutations(const std::vector<std::string> &files);

    /**
     * The file of a number: the same one each time. The first of each 1e9 are
     * the valid ones as they are.
     */
    std::string
    make(const unsigned long number) const;

    /** That it is one of the valid ones. */
    bool
    is_valid(const unsigned long number) const;

  private:
    using Generator = std::mt19937_64;

    /** What files of one kind, scenes or rods in units, may say. */
    struct Values
    {
      std::vector<Group> listed;   ///< in scene_values.txt, rod_values.txt
      std::vector<Group> of_files; ///< what the valid ones say
    };

    std::vector<std::string> files;
    std::vector<bool>        is_rod; ///< a rod in units, by file
    Values                   of_scenes, of_rods;
    std::vector<std::string> lines;
    std::vector<std::string> tokens;

    /** A valid one; those of rods in units are few, and taken more often. */
    std::size_t
    pick_file(Generator &generator) const;

    /** Entries for a file, and values for them. */
    const Group &
    new_entries(const bool for_rod, Generator &generator) const;

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
