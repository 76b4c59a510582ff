// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef thermocontact_base_atomic_file_h
#define thermocontact_base_atomic_file_h

#include <string>

namespace ThermoContact
{
  /** What a file is called while it is written. */
  constexpr char part_suffix[] = ".part";

  /**
   * Replaces the file at @p path by @p text, in one piece: whoever reads it
   * sees the old or the new file whatever happens. On one rank.
   *
   * @param is_durable wait until its content would survive a loss of power;
   *   sync_directory() does the same for its name
   * @return what is wrong, with the path, or nothing; then the old file is as
   *   it was and nothing else is left
   */
  std::string
  write_atomically(const std::string &path,
                   const std::string &text,
                   const bool         is_durable = false);

  /**
   * The end of write_atomically(): the file that was written beside @p path
   * takes its place.
   *
   * @param fault what was wrong with writing it, or nothing
   * @return what is wrong, with the path; then what was written is gone
   */
  std::string
  put_in_place(const std::string &path, std::string fault);

  /**
   * Waits until the file at @p path would survive a loss of power.
   *
   * @return what is wrong, with the path, or nothing
   */
  std::string
  sync_file(const std::string &path);

  /** Waits until the entries of @p directory would survive a loss of power. */
  void
  sync_directory(const std::string &directory);
} // namespace ThermoContact

#endif
