// SPDX-License-Identifier: LGPL-2.1-or-later
//
// usage: thermocontact_forks COMMAND...
//
// Runs a command that runs the program hundreds of times, and ends with its
// status. Most of a short run is the loader's work on two hundred libraries and
// the start of MPI: both are done once here. The environment variable
// THERMOCONTACT_FORKS of the command names a socket; a line on each connection
// to it is a run,
//
//   {"arguments": [...], "directory": PATH, "stdout": FILE, "stderr": FILE,
//    "memory": BYTES, "file_size": BYTES, "seconds": SECONDS}
//
// where the last line may be left out, and null is no limit; it is a child of
// this process that calls the main() of the program, which is compiled here as
// it is, but for the start of MPI. The answer is its exit status, or minus the
// signal that ended it, on a line.

#include <deal.II/base/mpi.h>

#include <nlohmann/json.hpp>
#include <poll.h>
#include <sys/resource.h>
#include <sys/signalfd.h>
#include <sys/socket.h>
#include <sys/un.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cstdio>
#include <filesystem>
#include <map>
#include <optional>
#include <string>

namespace dealii::Utilities::MPI
{
  /** In the place of MPI_InitFinalize, in a process whose parent has started
   * MPI. */
  struct IsThere
  {
    IsThere(int &, char **&, unsigned int)
    {}
    ~IsThere()
    {}
  };
} // namespace dealii::Utilities::MPI

#define MPI_InitFinalize IsThere
#define main program_main
#include "../../source/main.cc"
#undef main
#undef MPI_InitFinalize

namespace
{
  void
  set_limit(const __rlimit_resource_t kind,
            const nlohmann::json     &request,
            const std::string        &name)
  {
    if (!request.contains(name) || request.at(name).is_null())
      return;
    const rlim_t limit  = request.at(name);
    const rlimit limits = {limit, limit};
    if (setrlimit(kind, &limits) != 0)
      std::abort();
  }



  int
  call_program(std::vector<std::string> words)
  {
    words.emplace(words.begin(), "thermocontact");
    std::vector<char *> pointers;
    for (std::string &word : words)
      pointers.push_back(word.data());
    pointers.push_back(nullptr);
    return program_main(words.size(), pointers.data());
  }



  [[noreturn]] void
  run_program(const nlohmann::json &request)
  {
    std::filesystem::current_path(request.at("directory").get<std::string>());
    const std::string out = request.at("stdout"), err = request.at("stderr");
    if (std::freopen("/dev/null", "r", stdin) == nullptr ||
        std::freopen(out.c_str(), "w", stdout) == nullptr ||
        std::freopen(err.c_str(), "w", stderr) == nullptr)
      std::abort();
    set_limit(RLIMIT_AS, request, "memory");
    set_limit(RLIMIT_FSIZE, request, "file_size");
    set_limit(RLIMIT_CPU, request, "seconds");

    const int status = call_program(request.at("arguments"));
    std::cout.flush();
    std::fflush(nullptr);
    _exit(status); // the destructors of two hundred libraries take a quarter
  }



  /** A short run, which finds symbols and starts TBB for all that follow. */
  void
  run_once(const std::string &directory)
  {
    if (call_program({"--quiet",
                      "--output",
                      directory + "/first",
                      "--set",
                      "Time/End time=0.01",
                      PRM_DIR "/paper/experiment-1.prm"}) != 0)
      std::abort();
    optind = 1; // as the next finds it
  }



  nlohmann::json
  read_request(const int connection)
  {
    std::string text;
    for (char part[4096]; text.empty() || text.back() != '\n';)
      if (const ssize_t n = read(connection, part, sizeof(part)); n > 0)
        text.append(part, n);
      else
        break;
    return nlohmann::json::parse(text, nullptr, false);
  }



  /**
   * Answers requests until the command has ended.
   *
   * @param listener socket of the connections
   * @param signals says that children have ended
   * @return exit status of the command
   */
  int
  serve(const int       listener,
        const int       signals,
        const pid_t     command,
        const sigset_t &before)
  {
    std::map<pid_t, int> connections; // of what runs
    std::optional<int>   end;
    while (!end || !connections.empty())
      {
        pollfd events[2] = {{listener, POLLIN, 0}, {signals, POLLIN, 0}};
        poll(events, 2, -1);
        if (events[1].revents != 0)
          {
            signalfd_siginfo ignored;
            if (read(signals, &ignored, sizeof(ignored)) < 0)
              return 1;
            int status = 0;
            for (pid_t child; (child = waitpid(-1, &status, WNOHANG)) > 0;)
              {
                const int code =
                  WIFSIGNALED(status) ? -WTERMSIG(status) : WEXITSTATUS(status);
                if (child == command)
                  end = code < 0 ? 128 - code : code;
                else if (const auto run = connections.find(child);
                         run != connections.end())
                  {
                    const std::string answer = std::to_string(code) + '\n';
                    send(run->second,
                         answer.data(),
                         answer.size(),
                         MSG_NOSIGNAL);
                    close(run->second);
                    connections.erase(run);
                  }
              }
          }
        if (events[0].revents != 0)
          {
            const int connection =
              accept4(listener, nullptr, nullptr, SOCK_CLOEXEC);
            const nlohmann::json request = read_request(connection);
            const pid_t          child   = request.is_object() ? fork() : -1;
            if (child == 0)
              {
                sigprocmask(SIG_SETMASK, &before, nullptr);
                run_program(request);
              }
            if (child > 0)
              connections[child] = connection;
            else
              close(connection); // who has asked waits no longer
          }
      }
    return *end;
  }
} // namespace



int
main(int argc, char **argv)
{
  std::string directory =
    std::filesystem::temp_directory_path() / "thermocontact-XXXXXX";
  const int   listener = socket(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0);
  sockaddr_un address  = {AF_UNIX, ""};
  if (argc < 2 || mkdtemp(directory.data()) == nullptr ||
      directory.size() + 7 >= sizeof(address.sun_path))
    return 2;
  (directory + "/forks").copy(address.sun_path, sizeof(address.sun_path) - 1);
  if (bind(listener, reinterpret_cast<sockaddr *>(&address), sizeof(address)) !=
        0 ||
      listen(listener, 100) != 0)
    return 2;
  setenv("THERMOCONTACT_FORKS", address.sun_path, 1);
  // mpiruns at the same time disturb each other in a common directory, and one
  // of Open MPI 5 does not start where an mpirun of the same process number was
  // killed
  for (const char *const name :
       {"OMPI_MCA_orte_tmpdir_base", "PRTE_MCA_prte_tmpdir_base"})
    setenv(name, directory.c_str(), 1);

  sigset_t of_children, before;
  sigemptyset(&of_children);
  sigaddset(&of_children, SIGCHLD);
  sigprocmask(SIG_BLOCK,
              &of_children,
              &before); // Open MPI's handler waits, too
  const pid_t command = fork();
  if (command == 0)
    {
      sigprocmask(SIG_SETMASK, &before, nullptr);
      execvp(argv[1], argv + 1);
      _exit(127);
    }
  const auto to_unset       = ThermoContact::declare_single_process();
  int        n_arguments    = 1;
  char      *program_name[] = {argv[0], nullptr};
  char     **arguments      = program_name;
  dealii::Utilities::MPI::MPI_InitFinalize mpi(n_arguments, arguments, 1);
  for (const char *const name : to_unset)
    unsetenv(name);
  run_once(directory);
  const int status =
    serve(listener, signalfd(-1, &of_children, SFD_CLOEXEC), command, before);
  std::filesystem::remove_all(directory);
  _exit(status); // the command has what was printed
}
