// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef thermocontact_base_writable_file_h
#define thermocontact_base_writable_file_h

#include <cstdint>
#include <string>
#include <string_view>

namespace ThermoContact
{
  /**
   * A file that is written at places, closed at the end of its life. Its first
   * fault is kept as a message, and nothing is written after it.
   */
  class WritableFile
  {
  public:
    WritableFile() = default;

    WritableFile(const WritableFile &) = delete;
    WritableFile &
    operator=(const WritableFile &) = delete;

    ~WritableFile();

    /** Opens the file at @p path; @p is_new: made, or emptied. Once. */
    void
    open(const std::string &path, const bool is_new);

    bool
    is_open() const
    {
      return descriptor >= 0;
    }

    /** Writes @p bytes behind the first @p begin ones of the file. */
    void
    write(const std::string_view bytes, const std::uint64_t begin);

    /** Cuts off all behind @p size bytes; a fault if the file is shorter. */
    void
    cut(const std::uint64_t size);

    /** The bytes written so far survive a loss of power. */
    void
    sync();

    /** The fault, with path and remedy, or nothing. */
    const std::string &
    fault() const
    {
      return fault_;
    }

  private:
    std::string path;
    int         descriptor = -1;
    std::string fault_;

    /** Remembers the first fault, from errno. */
    void
    fail(const std::string &what);
  };



  /** Behind the name of a file while it is written. */
  constexpr char part_suffix[] = ".part";

  /**
   * Replaces the file at @p path by @p text, in one piece: whoever reads it
   * sees the old or the new file whatever happens. On one rank.
   *
   * @return the fault, with the path, or nothing; after a fault the old file
   *   is as it was and nothing else is left
   */
  std::string
  write_atomically(const std::string &path, const std::string &text);

  /**
   * The end of write_atomically(): the file that was written beside @p path
   * takes its place.
   *
   * @param fault of writing it, or nothing
   * @return the fault, with the path; then the new file is gone
   */
  std::string
  put_in_place(const std::string &path, std::string fault);

  /**
   * Waits until the file at @p path would survive a loss of power.
   *
   * @return the fault, with the path, or nothing
   */
  std::string
  sync_file(const std::string &path);

  /** Waits until the entries of @p directory would survive a loss of power. */
  void
  sync_directory(const std::string &directory);
} // namespace ThermoContact

#endif
