// SPDX-License-Identifier: LGPL-2.1-or-later

#include <thermocontact/base/table_file.h>

namespace ThermoContact
{
  TableFile::~TableFile()
  {
    write_rows();
  }



  void
  TableFile::open(const std::string  &path,
                  const std::string  &head,
                  const std::uint64_t size)
  {
    file.open(path, size == 0);
    n_written = size;
    if (size > 0)
      file.cut(size);
    else
      rows = head;
  }



  void
  TableFile::write_rows()
  {
    file.write(rows, n_written);
    if (file.fault().empty())
      n_written += rows.size();
    else
      file.cut(n_written); // part of a row may be there
    rows.clear();
  }



  std::string
  TableFile::flush()
  {
    if (is_open())
      write_rows();
    return file.fault();
  }



  std::string
  TableFile::sync()
  {
    flush();
    if (is_open())
      file.sync();
    return file.fault();
  }
} // namespace ThermoContact
