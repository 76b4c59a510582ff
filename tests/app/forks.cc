// SPDX-License-Identifier: LGPL-2.1-or-later
//
// usage: thermocontact_forks
//
// The program for scripts that run it hundreds of times: most of a short run is
// the loader's work on two hundred libraries, which is done once here. Each
// line of standard input is a run,
//
//   {"arguments": [...], "environment": {...}, "stdout": FILE, "stderr": FILE,
//    "memory": BYTES, "file_size": BYTES, "seconds": SECONDS}
//
// with null for no limit; it is a child of this process that calls the main()
// of the program, linked in as it is. The answer is its exit status, or minus
// the signal that ended it, on a line of standard output.

#include <nlohmann/json.hpp>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cstdio>
#include <cstdlib>
#include <iostream>
#include <string>
#include <vector>

// ld --wrap=main: the name of the program's main()
extern "C" int
__real_main(int argc, char **argv);

namespace
{
  void
  set_limit(const __rlimit_resource_t kind, const nlohmann::json &value)
  {
    if (value.is_null())
      return;
    const rlim_t limit   = value;
    const rlimit request = {limit, limit};
    if (setrlimit(kind, &request) != 0)
      std::abort();
  }



  [[noreturn]] void
  run_program(const nlohmann::json &request)
  {
    for (const auto &[name, value] : request.at("environment").items())
      setenv(name.c_str(), value.get<std::string>().c_str(), 1);
    const std::string out = request.at("stdout"), err = request.at("stderr");
    if (std::freopen("/dev/null", "r", stdin) == nullptr ||
        std::freopen(out.c_str(), "w", stdout) == nullptr ||
        std::freopen(err.c_str(), "w", stderr) == nullptr)
      std::abort();
    set_limit(RLIMIT_AS, request.at("memory"));
    set_limit(RLIMIT_FSIZE, request.at("file_size"));
    set_limit(RLIMIT_CPU, request.at("seconds"));

    std::vector<std::string> words = {"thermocontact"};
    for (const auto &argument : request.at("arguments"))
      words.push_back(argument);
    std::vector<char *> pointers;
    for (std::string &word : words)
      pointers.push_back(word.data());
    pointers.push_back(nullptr);
    const int status = __real_main(words.size(), pointers.data());
    std::cout.flush();
    std::fflush(nullptr);
    _exit(status); // the destructors of two hundred libraries take a quarter
  }
} // namespace



extern "C" int
__wrap_main(int, char **)
{
  for (std::string line; std::getline(std::cin, line);)
    {
      const nlohmann::json request = nlohmann::json::parse(line);
      const pid_t          child   = fork();
      if (child == 0)
        run_program(request);
      int status = 0;
      if (child < 0 || waitpid(child, &status, 0) != child)
        return 1;
      std::cout << (WIFSIGNALED(status) ? -WTERMSIG(status) :
                                          WEXITSTATUS(status))
                << std::endl;
    }
  return 0;
}
