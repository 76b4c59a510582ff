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

    /** Cuts off what is behind @p size bytes; a fault if the file is shorter.
     */
    void
    cut(const std::uint64_t size);

    /** What is written survives a loss of power. */
    void
    sync();

    /** What is wrong, with path and remedy, or nothing. */
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
} // namespace ThermoContact

#endif
