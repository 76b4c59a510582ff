// SPDX-License-Identifier: LGPL-2.1-or-later

#include <thermocontact/base/table_file.h>

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>

namespace ThermoContact
{
  std::string
  file_fault(const std::string &path, const std::string &what)
  {
    return path + ": " + what +
           (errno != 0 ? std::string(": ") + std::strerror(errno) : "") +
           "\n  remedy:  check free space and rights, then go on with "
           "--resume if the run has checkpoints; or give another "
           "Output/Directory";
  }



  TableFile::~TableFile()
  {
    close();
  }



  void
  TableFile::open(const std::string &new_path)
  {
    close();
    path = new_path;
    open_descriptor(O_CREAT | O_TRUNC);
  }



  void
  TableFile::reopen(const std::string &new_path, const std::uint64_t size)
  {
    close();
    path = new_path;
    open_descriptor(0);
    if (descriptor < 0)
      return;
    const off_t end = lseek(descriptor, 0, SEEK_END);
    if (end < 0 || static_cast<std::uint64_t>(end) < size)
      {
        errno = 0;
        fail("is shorter than the checkpoint says");
      }
    else if (ftruncate(descriptor, size) != 0 ||
             lseek(descriptor, size, SEEK_SET) < 0)
      fail("cannot be cut back");
    n_written = size;
  }



  void
  TableFile::open_descriptor(const int flags)
  {
    fault.clear();
    rows.clear();
    n_written = 0;
    do
      descriptor = ::open(path.c_str(), O_WRONLY | O_CLOEXEC | flags, 0666);
    while (descriptor < 0 && errno == EINTR);
    if (descriptor < 0)
      fail("cannot be opened");
  }



  void
  TableFile::close()
  {
    if (descriptor < 0)
      return;
    write_rows();
    ::close(descriptor);
    descriptor = -1;
  }



  void
  TableFile::fail(const std::string &what)
  {
    if (fault.empty())
      fault = file_fault(path, what);
  }



  void
  TableFile::write_rows()
  {
    std::size_t n = 0;
    while (fault.empty() && n < rows.size())
      {
        const ssize_t part =
          ::write(descriptor, rows.data() + n, rows.size() - n);
        if (part >= 0)
          n += part;
        else if (errno != EINTR)
          {
            fail("cannot be written");
            // part of a row may be there
            if (ftruncate(descriptor, n_written) != 0)
              return;
          }
      }
    if (fault.empty())
      n_written += rows.size();
    rows.clear();
  }



  std::string
  TableFile::flush()
  {
    if (descriptor >= 0)
      write_rows();
    return fault;
  }



  std::string
  TableFile::sync()
  {
    flush();
    if (descriptor >= 0 && fault.empty() && fsync(descriptor) != 0)
      fail("cannot be written to the disk");
    return fault;
  }
} // namespace ThermoContact
