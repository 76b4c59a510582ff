// SPDX-License-Identifier: LGPL-2.1-or-later
//
// Checkpoints, on two ranks.
//
// 1. Files of a part from each rank: the parts in order, whichever of them is
//    empty; an older, longer file leaves nothing behind. A disk that is full
//    (/dev/full) for rank 1 alone, which has bytes where rank 0 has none, is
//    told to both, with the path. What cannot be put in place leaves the older
//    file and nothing else.
// 2. Checkpoints whose nodes are 1000 bytes on rank 0 and 80 MiB on rank 1:
//    each rank reads its own, and each can read that of the other. The peak of
//    the memory of rank 0 grows by less than half of what rank 1 has, since it
//    never holds all of it (measured: 1 MiB).
// 3. One byte of any part otherwise, a byte less or more at the end: the file
//    is damaged, and the previous checkpoint is read. With both damaged there
//    is none. A file that cannot be written leaves the earlier ones alone.
// 4. A checkpoint of one rank, read on two: the number of ranks is told, and
//    both can read its nodes.

#include <thermocontact/base/exceptions.h>
#include <thermocontact/base/parallel_file.h>
#include <thermocontact/output/checkpoint.h>

#include <deal.II/base/mpi.h>
#include <deal.II/base/utilities.h>

#include <filesystem>

#include "../tests.h"

using namespace ThermoContact;

namespace
{
  const std::string directory = "checkpoints";

  unsigned int
  rank()
  {
    return Utilities::MPI::this_mpi_process(MPI_COMM_WORLD);
  }



  /** True if it is true on all ranks. */
  bool
  everywhere(const bool condition)
  {
    return Utilities::MPI::min(condition ? 1 : 0, MPI_COMM_WORLD) == 1;
  }



  /** Bytes that depend on their place and on @p seed. */
  std::string
  pattern(const std::size_t size, const unsigned int seed)
  {
    std::string bytes(size, '\0');
    for (std::size_t i = 0; i < size; ++i)
      bytes[i] = static_cast<char>(i * 2654435761u >> 13) + seed;
    return bytes;
  }



  std::string
  contents(const std::string &path)
  {
    std::ostringstream text;
    text << std::ifstream(path, std::ios::binary).rdbuf();
    return text.str();
  }



  void
  test_parts()
  {
    const std::string path   = directory + "/parts";
    unsigned int      n_same = 0;
    for (const std::size_t size : {500, 20, 0})
      for (const unsigned int other : {0u, 1u})
        {
          const std::string part = rank() == other ? pattern(size, 1) : "";
          const std::string fault =
            write_parallel_file_atomically(path,
                                           {"a", part, "b"},
                                           MPI_COMM_WORLD);
          const std::string expected = other == 0 ?
                                         "a" + pattern(size, 1) + "bab" :
                                         "aba" + pattern(size, 1) + "b";
          n_same += everywhere(fault.empty() && contents(path) == expected);
          MPI_Barrier(MPI_COMM_WORLD);
        }
    deallog << "parts of 500, 20 and 0 bytes: as they were " << n_same
            << " of 6" << std::endl;
    const auto begins = [](const std::string &fault, const std::string &words) {
      return std::to_string(
               Utilities::MPI::sum(fault.rfind(words, 0) == 0 ? 1 : 0,
                                   MPI_COMM_WORLD)) +
             " ranks";
    };
    const std::string part = rank() == 1 ? "x" : "";
    deallog << "full disk: told by "
            << begins(write_parallel_file("/dev/full", {part}, MPI_COMM_WORLD),
                      "/dev/full: cannot be written: No space left")
            << ", no directory: by "
            << begins(write_parallel_file_atomically("no/file",
                                                     {part},
                                                     MPI_COMM_WORLD),
                      "no/file: cannot be opened: No such file")
            << std::endl;
    const std::string taken = directory + "/taken";
    if (rank() == 0)
      std::filesystem::create_directories(taken + "/by_a_directory");
    MPI_Barrier(MPI_COMM_WORLD);
    deallog << "in place of a directory: told by "
            << begins(write_parallel_file_atomically(taken,
                                                     {part},
                                                     MPI_COMM_WORLD),
                      taken + ": cannot be replaced")
            << (everywhere(!std::filesystem::exists(taken + ".part")) ?
                  ", nothing is left" :
                  ", a part is left")
            << std::endl;
  }



  Checkpoint
  make_checkpoint(const unsigned int step,
                  const std::size_t  size_of_last,
                  const unsigned int n_ranks = 2)
  {
    Checkpoint checkpoint;
    checkpoint.time                  = 0.1 * step;
    checkpoint.step                  = step;
    checkpoint.n_ranks               = n_ranks;
    checkpoint.parameters            = {{"Time/End time", "1"}};
    checkpoint.output.snapshot_times = {0., 0.5};
    checkpoint.progress              = "progress " + std::to_string(step);
    checkpoint.nodes = pattern(rank() == 0 ? 1000 : size_of_last, step);
    return checkpoint;
  }



  /** @p found was read, and its nodes are those of @p b. */
  bool
  are_equal(const Checkpoint &found, const Checkpoint &b)
  {
    Checkpoint a = found;
    a.nodes      = read_nodes(found, rank());
    return everywhere(a.time == b.time && a.step == b.step &&
                      a.n_ranks == b.n_ranks && a.parameters == b.parameters &&
                      a.output.snapshot_times == b.output.snapshot_times &&
                      a.progress == b.progress && a.nodes == b.nodes);
  }



  /** High-water mark of the memory, in MiB. */
  double
  peak_memory()
  {
    Utilities::System::MemoryStats stats;
    Utilities::System::get_memory_stats(stats);
    return stats.VmHWM / 1024.;
  }



  void
  test_large()
  {
    const unsigned int megabytes  = 80;
    const Checkpoint   checkpoint = make_checkpoint(1, megabytes << 20);
    const double       before     = peak_memory();
    write_checkpoint(directory, checkpoint, MPI_COMM_WORLD);
    const Checkpoint  read     = read_checkpoint(directory, MPI_COMM_WORLD);
    const bool        is_same  = are_equal(read, checkpoint);
    const double      growth   = peak_memory() - before;
    const std::size_t of_other = read_nodes(read, 1 - rank()).size();
    deallog << megabytes << " MiB: " << (is_same ? "the same" : "another")
            << ", of the other rank " << (of_other >> 20) << " MiB, warning '"
            << read.warning << "', growth of rank 0 over half of it "
            << (growth < 0.5 * megabytes ? "below 1" : std::to_string(growth))
            << std::endl;
  }



  void
  write_text(const std::string &path, const std::string &text)
  {
    if (rank() == 0)
      std::ofstream(path, std::ios::binary) << text;
    MPI_Barrier(MPI_COMM_WORLD);
  }



  void
  test_damage()
  {
    const Checkpoint first = make_checkpoint(2, 500);
    const Checkpoint last  = make_checkpoint(3, 500);
    write_checkpoint(directory, first, MPI_COMM_WORLD);
    write_checkpoint(directory, last, MPI_COMM_WORLD);
    const std::string path   = directory + "/checkpoint.bin";
    const std::string text   = contents(path);
    const auto        change = [&text](const std::size_t from_end) {
      std::string changed = text;
      changed[changed.size() - from_end] ^= 1;
      return changed;
    };
    const auto read = [&](const std::string &name, const std::string &damaged) {
      write_text(path, damaged);
      const Checkpoint found = read_checkpoint(directory, MPI_COMM_WORLD);
      deallog << name << ": "
              << (are_equal(found, first) ? "the previous one" :
                  are_equal(found, last)  ? "the newest one" :
                                            "another one")
              << (found.warning.empty() ? "" : "; ")
              << found.warning.substr(0, found.warning.find('\n')) << std::endl;
    };
    read("whole", text);
    read("part of rank 1", change(1));
    read("part of rank 0", change(501));
    read("first part", change(1501));
    read("a byte less", text.substr(0, text.size() - 1));
    read("a byte more", text + '\0');
    write_text(directory + "/checkpoint.previous.bin", change(1));
    try
      {
        write_text(path, change(1));
        read_checkpoint(directory, MPI_COMM_WORLD);
      }
    catch (const InputError &error)
      {
        const std::string fault = error.what();
        deallog << "both: " << fault.substr(0, fault.find('\n')) << std::endl;
      }

    write_text(path, text);
    if (rank() == 0)
      std::filesystem::create_directory(directory + "/checkpoint.next.bin");
    try
      {
        write_checkpoint(directory, first, MPI_COMM_WORLD);
      }
    catch (const ComputationError &error)
      {
        const Checkpoint found = read_checkpoint(directory, MPI_COMM_WORLD);
        deallog << "cannot be written: "
                << (are_equal(found, last) ? "the earlier one" : "another one")
                << std::endl;
      }
  }



  void
  test_other_ranks()
  {
    if (rank() == 0)
      std::filesystem::remove(directory + "/checkpoint.next.bin");
    if (rank() == 0)
      write_checkpoint(directory, make_checkpoint(4, 0, 1), MPI_COMM_SELF);
    MPI_Barrier(MPI_COMM_WORLD);
    const Checkpoint found = read_checkpoint(directory, MPI_COMM_WORLD);
    deallog << "of " << found.n_ranks << " rank: step " << found.step << ", "
            << (everywhere(read_nodes(found, 0) == pattern(1000, 4)) ?
                  "its nodes" :
                  "other nodes")
            << std::endl;
  }
} // namespace



void
main_checkpoint()
{
  if (rank() == 0)
    {
      initlog();
      std::filesystem::remove_all(directory);
      std::filesystem::create_directory(directory);
    }
  test_parts();
  test_large();
  test_damage();
  test_other_ranks();
}
