// SPDX-License-Identifier: LGPL-2.1-or-later
//
// usage: thermocontact_fuzz MINUTES FIRST_NUMBER DIRECTORY
//        thermocontact_fuzz --print NUMBER
//
// Reads mutated parameter files, scenes and rods in units, as --check and
// --units do: many in one process, and a new process after one that died. One
// in eight of those that are accepted takes its first steps, too, with all its
// files. Each file has a number from which --print makes it again. A file
// must be accepted or refused with a short message in UTF-8; what is accepted
// must be written and read back the same. Everything else is a finding: another
// exception, the end of the process (the sanitizers end it), 20 seconds for one
// file, a file written where none belongs. It is saved in DIRECTORY as
// finding-NUMBER.prm and .txt. How often each entry had a value of its own in
// a file that was accepted is in reach.txt there. Exit status 1 if there is a
// finding.

#include <thermocontact/base/exceptions.h>
#include <thermocontact/input/parameter_text.h>

#include <deal.II/base/mpi.h>

#include <sys/mman.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <csignal>
#include <cstdlib>
#include <ctime>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <sstream>

#include "mutations.h"
#include "reach.h"
#include "reading.h"
#include "seeds.h"

namespace ThermoContact
{
  namespace
  {
    namespace fs = std::filesystem;

    /** What parent and child both see. */
    struct Progress
    {
      volatile unsigned long number;
      volatile double        begin; ///< of that file, CPU seconds
      volatile unsigned long n_accepted, n_large, n_rods_in_units, n_studies,
        n_begun, n_refused, n_failed, n_findings;
    };



    /** CPU seconds of a process; a busy machine does not count. */
    double
    cpu_seconds(const pid_t process)
    {
      clockid_t clock;
      timespec  time = {0, 0};
      if (clock_getcpuclockid(process, &clock) == 0)
        clock_gettime(clock, &time);
      return time.tv_sec + 1e-9 * time.tv_nsec;
    }



    /** What a user would not want to read. */
    std::string
    find_fault(const std::string &message)
    {
      std::string line;
      if (message.size() > 3000)
        return "a long message";
      for (std::istringstream stream(message); std::getline(stream, line);)
        if (!is_plain_text(line))
          return "an unprintable message";
      return "";
    }



    void
    save(const std::string  &directory,
         const unsigned long number,
         const std::string  &text,
         const std::string  &reason,
         Progress           &progress)
    {
      ++progress.n_findings;
      const std::string name = directory + "/finding-" + std::to_string(number);
      std::ofstream(name + ".prm") << text;
      std::ofstream(name + ".txt") << reason << '\n';
      std::cout << "finding " << number << ": " << reason.substr(0, 300)
                << std::endl;
    }



    /** Reads files until the parent kills it. */
    [[noreturn]] void
    work(const Mutations   &mutations,
         const std::string &directory,
         Reach             &reach,
         Progress          &progress)
    {
      const auto n_files = [&directory]() {
        return std::distance(fs::directory_iterator("."),
                             fs::directory_iterator());
      };
      const std::string scratch = directory + "/scratch";
      while (true)
        {
          const unsigned long number = progress.number;
          const std::string   text   = mutations.make(number);
          progress.begin             = cpu_seconds(getpid());
          std::string fault;
          try
            {
              const Reading reading =
                read_as_program(text, number % 8 == 0 ? scratch : "");
              reach.add(reading);
              ++progress.n_accepted;
              progress.n_large += reading.is_large;
              progress.n_rods_in_units += reading.is_rod_in_units;
              progress.n_studies += reading.is_study;
              progress.n_begun += reading.has_begun;
            }
          catch (const InputError &error)
            {
              ++progress.n_refused;
              fault = find_fault(error.what());
              if (!fault.empty())
                fault += ": " + std::string(error.what());
              if (mutations.is_valid(number))
                fault = "a valid file is refused: " + std::string(error.what());
            }
          catch (const ComputationError &error)
            {
              ++progress.n_failed;
              fault = find_fault(error.what());
            }
          catch (const std::exception &error)
            {
              fault = std::string("an exception: ") + error.what();
            }
          if (number % 100 == 0 && n_files() > 0)
            fault = "a file was written, by one of the last 100";
          if (!fault.empty())
            save(directory, number, text, fault, progress);
          ++progress.number;
        }
    }



    void
    report(const Progress &progress, const unsigned long first)
    {
      std::cout << progress.number - first << " files: " << progress.n_accepted
                << " accepted (" << progress.n_large
                << " without their matrices, too large; "
                << progress.n_rods_in_units << " rods in units, "
                << progress.n_studies << " studies; " << progress.n_begun
                << " began to run), " << progress.n_refused << " refused, "
                << progress.n_failed
                << " failed; findings: " << progress.n_findings << std::endl;
    }



    void
    report(const Reach &reach, const std::string &file_name)
    {
      std::ofstream file(file_name);
      reach.print(file);
      std::cout << "values tried of each entry: " << file_name << '\n';
      for (const std::string &path : reach.missed())
        std::cout << "  no file was accepted with a value of " << path << '\n';
    }



    /** Starts workers one after the other until the time is over. */
    int
    fuzz(const double        minutes,
         const unsigned long first,
         const std::string  &directory)
    {
      const Mutations mutations(valid_files());
      Reach           reach;
      auto           &progress = *static_cast<Progress *>(mmap(nullptr,
                                                     sizeof(Progress),
                                                     PROT_READ | PROT_WRITE,
                                                     MAP_SHARED | MAP_ANONYMOUS,
                                                     -1,
                                                     0));
      progress.number          = first;
      const auto end           = std::chrono::steady_clock::now() +
                       std::chrono::seconds(static_cast<long>(60 * minutes));
      const fs::path    folder = fs::absolute(directory);
      const std::string log    = folder / "worker.txt";
      fs::create_directories(folder / "empty");
      fs::current_path(folder / "empty");
      std::time_t last_report = std::time(nullptr);
      while (std::chrono::steady_clock::now() < end)
        {
          progress.begin    = 0.;
          const pid_t child = fork();
          if (child == 0)
            {
              prctl(PR_SET_PDEATHSIG, SIGKILL); // it ends with the parent
              if (freopen(log.c_str(), "w", stderr) == nullptr)
                std::exit(3);
              int                                      argc = 0;
              char                                   **argv = nullptr;
              dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
              work(mutations, folder, reach, progress);
            }
          int  status  = 0;
          bool is_late = false, is_over = false;
          while (waitpid(child, &status, WNOHANG) == 0)
            {
              usleep(100000);
              is_late = cpu_seconds(child) - progress.begin > 20.;
              is_over = std::chrono::steady_clock::now() >= end;
              if (is_late || is_over)
                kill(child, SIGKILL);
              if (std::time(nullptr) - last_report >= 60)
                {
                  last_report = std::time(nullptr);
                  report(progress, first);
                }
              if (is_late || is_over)
                {
                  waitpid(child, &status, 0);
                  break;
                }
            }
          if (is_over)
            break;
          std::ostringstream words;
          words << (is_late ? "more than 20 CPU seconds" : "the process ended")
                << '\n'
                << std::ifstream(log).rdbuf();
          save(folder,
               progress.number,
               mutations.make(progress.number),
               words.str(),
               progress);
          ++progress.number;
        }
      report(progress, first);
      report(reach, folder / "reach.txt");
      return progress.n_findings == 0 ? 0 : 1;
    }
  } // namespace
} // namespace ThermoContact



int
main(int argc, char **argv)
{
  using namespace ThermoContact;
  if (argc == 3 && std::string(argv[1]) == "--print")
    {
      std::cout << Mutations(valid_files()).make(std::stoul(argv[2]));
      return 0;
    }
  if (argc != 4)
    {
      std::cerr << "usage: thermocontact_fuzz MINUTES FIRST_NUMBER DIRECTORY\n"
                   "       thermocontact_fuzz --print NUMBER\n";
      return 2;
    }
  return fuzz(std::stod(argv[1]), std::stoul(argv[2]), argv[3]);
}
