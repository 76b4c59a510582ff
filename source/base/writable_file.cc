// SPDX-License-Identifier: LGPL-2.1-or-later

#include <thermocontact/base/writable_file.h>

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>

namespace ThermoContact
{
  WritableFile::~WritableFile()
  {
    if (is_open())
      close(descriptor);
  }



  void
  WritableFile::open(const std::string &new_path, const bool is_new)
  {
    path            = new_path;
    const int flags = O_WRONLY | O_CLOEXEC | (is_new ? O_CREAT | O_TRUNC : 0);
    do
      descriptor = ::open(path.c_str(), flags, 0666);
    while (descriptor < 0 && errno == EINTR);
    if (descriptor < 0)
      fail("cannot be opened");
  }



  void
  WritableFile::write(const std::string_view bytes, const std::uint64_t begin)
  {
    std::size_t n = 0;
    while (fault_.empty() && n < bytes.size())
      {
        const ssize_t written =
          pwrite(descriptor, bytes.data() + n, bytes.size() - n, begin + n);
        if (written >= 0)
          n += written;
        else if (errno != EINTR)
          fail("cannot be written");
      }
  }



  void
  WritableFile::cut(const std::uint64_t size)
  {
    if (!is_open())
      return;
    const off_t end = lseek(descriptor, 0, SEEK_END);
    if (end < 0 || static_cast<std::uint64_t>(end) < size)
      {
        errno = 0;
        fail("is shorter than the checkpoint says");
      }
    else if (ftruncate(descriptor, size) != 0)
      fail("cannot be cut back");
  }



  void
  WritableFile::sync()
  {
    if (fault_.empty() && fsync(descriptor) != 0)
      fail("cannot be written to the disk");
  }



  void
  WritableFile::fail(const std::string &what)
  {
    if (fault_.empty())
      fault_ = path + ": " + what +
               (errno != 0 ? std::string(": ") + std::strerror(errno) : "") +
               "\n  remedy:  check free space and rights, then go on with "
               "--resume if the run has checkpoints; or give another "
               "Output/Directory";
  }
} // namespace ThermoContact
