// SPDX-License-Identifier: LGPL-2.1-or-later

#include <thermocontact/base/text.h>
#include <thermocontact/base/writable_file.h>

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
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



  std::string
  write_atomically(const std::string &path, const std::string &text)
  {
    const std::string part = path + part_suffix;
    std::string       fault;
    {
      WritableFile file;
      file.open(part, true);
      file.write(text, 0);
      fault = file.fault();
    }
    return put_in_place(path, fault);
  }



  std::string
  put_in_place(const std::string &path, std::string fault)
  {
    const std::string part = path + part_suffix;
    if (fault.empty() && std::rename(part.c_str(), path.c_str()) != 0)
      fault = path + ": cannot be replaced\n  remedy:  check the rights of "
                     "file and directory";
    if (fault.empty())
      return "";
    std::remove(part.c_str());
    // the user knows the file by its name
    return begins_with(fault, part) ? path + fault.substr(part.size()) : fault;
  }



  std::string
  sync_file(const std::string &path)
  {
    const int         descriptor = open(path.c_str(), O_RDONLY | O_CLOEXEC);
    const bool        is_synced  = descriptor >= 0 && fsync(descriptor) == 0;
    const std::string fault =
      is_synced ?
        "" :
        path + ": cannot be written to the disk: " + std::strerror(errno) +
          "\n  remedy:  check the disk, and leave the files of a run that goes on where they are";
    if (descriptor >= 0)
      close(descriptor);
    return fault;
  }



  void
  sync_directory(const std::string &directory)
  {
    // Some file systems have no such thing: then there is nothing to wait for.
    const int descriptor =
      open(directory.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
    if (descriptor < 0)
      return;
    (void)fsync(descriptor);
    close(descriptor);
  }
} // namespace ThermoContact
