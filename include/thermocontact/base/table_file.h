// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef thermocontact_base_table_file_h
#define thermocontact_base_table_file_h

#include <thermocontact/base/writable_file.h>

namespace ThermoContact
{
  /**
   * A file that grows by whole rows, text or binary. Rows are collected and
   * written in larger pieces; a piece that does not fit on the disk is taken
   * back, so that the file ends with a whole row whatever happens.
   *
   * Used on one rank. Faults are returned as messages, to be told to all ranks
   * by throw_everywhere(); a file that has failed stays failed.
   */
  class TableFile
  {
  public:
    /** Writes the rows that are left, if it can. */
    ~TableFile();

    /**
     * Begins a new file at @p path with @p head, or goes on with the one that
     * is there behind its first @p size bytes, if that is not 0; the
     * bytes after them are cut off. A fault shows at the next flush().
     */
    void
    open(const std::string  &path,
         const std::string  &head,
         const std::uint64_t size = 0);

    bool
    is_open() const
    {
      return file.is_open();
    }

    /**
     * Appends one row; @p append adds it to the rows that are not yet written,
     * whose memory is kept, so that the next rows allocate nothing. Not called
     * if the file is not open.
     */
    template <typename Append>
    void
    append_row(const Append &append)
    {
      if (!is_open())
        return;
      append(rows);
      if (rows.size() >= piece_size)
        write_rows();
    }

    /**
     * Hands all rows to the operating system: other programs see them.
     *
     * @return the fault, with path and remedy, or nothing
     */
    std::string
    flush();

    /** flush(), and the rows survive a loss of power; same return value. */
    std::string
    sync();

    /** Length of the file in bytes, with the rows that are not flushed. */
    std::uint64_t
    size() const
    {
      return n_written + rows.size();
    }

  private:
    /** Bytes that are collected before they are written. */
    static constexpr std::size_t piece_size = 1 << 16;

    WritableFile  file;
    std::string   rows;          ///< not yet written
    std::uint64_t n_written = 0; ///< bytes

    void
    write_rows();
  };
} // namespace ThermoContact

#endif
