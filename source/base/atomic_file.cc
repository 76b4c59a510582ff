// SPDX-License-Identifier: LGPL-2.1-or-later

#include <thermocontact/base/atomic_file.h>
#include <thermocontact/base/table_file.h>

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <cstring>

namespace ThermoContact
{
  std::string
  write_atomically(const std::string &path,
                   const std::string &text,
                   const bool         is_durable)
  {
    const std::string part = path + part_suffix;
    std::string       fault;
    {
      TableFile file;
      file.open(part, text);
      fault = is_durable ? file.sync() : file.flush();
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
    return fault.rfind(part, 0) == 0 ? path + fault.substr(part.size()) : fault;
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
