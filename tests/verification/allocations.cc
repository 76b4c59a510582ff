// SPDX-License-Identifier: LGPL-2.1-or-later
//
// The time loop of a rod allocates nothing while its contact node has mass:
// calls of the allocator between two accepted steps, without observers that
// write, are counted by replacing the functions of the C library that all
// others use. Not counted: steps in which contact begins or ends, the step
// after them, which gets its direction anew, attempts with a factorisation or a
// response of their own, and the last step, which looks back on the mesh.
//
// Counted by hand: the paper's experiment 1 with 250 linear cells and 1000
// fixed steps; the default scene with steps of tolerance 1e-6, T = 10; a rigid
// obstacle; two rods with two contacts; elastic impact with the scheme without
// dispersion.
// At least half of all steps count; none of them allocates.

#include <thermocontact/simulation/simulation.h>

#include <deal.II/base/mpi.h>

#include <cerrno>
#include <cstddef>
#include <string>

#include "../tests.h"

namespace
{
  unsigned long n_allocations = 0;
}

extern "C"
{
  void *__libc_malloc(std::size_t);
  void *__libc_calloc(std::size_t, std::size_t);
  void       *
  __libc_realloc(void *, std::size_t);
  void *__libc_memalign(std::size_t, std::size_t);

  void *
  malloc(std::size_t size)
  {
    ++n_allocations;
    return __libc_malloc(size);
  }

  void *
  calloc(std::size_t n, std::size_t size)
  {
    ++n_allocations;
    return __libc_calloc(n, size);
  }

  void *
  realloc(void *memory, std::size_t size)
  {
    ++n_allocations;
    return __libc_realloc(memory, size);
  }

  int
  posix_memalign(void **memory, std::size_t alignment, std::size_t size)
  {
    ++n_allocations;
    *memory = __libc_memalign(alignment, size);
    return *memory == nullptr ? ENOMEM : 0;
  }

  void *
  aligned_alloc(std::size_t alignment, std::size_t size)
  {
    ++n_allocations;
    return __libc_memalign(alignment, size);
  }
}

using namespace ThermoContact;

namespace
{
  void
  check(const std::string              &name,
        const std::string              &file,
        const std::vector<std::string> &overrides)
  {
    Simulation<1> simulation(read_parameters(file, overrides), MPI_COMM_SELF);
    unsigned long before = 0, total = 0;
    unsigned int  n_events = 0, n_factorizations = 0, n_responses = 0;
    unsigned int  n_steps = 0, n_counted = 0;
    bool          is_after_event = true; // and the first one
    const auto    observe        = [&](const Simulation<1> &s) {
      const unsigned long  now       = n_allocations;
      const SolverCounters counters  = s.counters();
      const bool           has_event = s.events().size() != n_events;
      if (s.record().step > 0)
        {
          ++n_steps;
          if (!has_event && !is_after_event &&
              s.record().time < s.parameters().time.end_time &&
              counters.factorizations == n_factorizations &&
              counters.responses == n_responses)
            {
              ++n_counted;
              total += now - before;
            }
        }
      is_after_event   = has_event || s.record().step == 0;
      n_events         = s.events().size();
      n_factorizations = counters.factorizations;
      n_responses      = counters.responses;
      before           = n_allocations;
    };
    simulation.run({observe});
    deallog << name << ": half of the steps count "
            << (2 * n_counted >= n_steps) << ", allocations " << total
            << std::endl;
  }
} // namespace



void
main_allocations()
{
  initlog();
  {
    // the allocator is replaced
    const unsigned long       before = n_allocations;
    const std::vector<double> memory(1000);
    const unsigned long       made = n_allocations - before;
    deallog << "a vector: allocations " << made << std::endl;
  }
  check("experiment 1", "paper/experiment-1.prm", {"Time/End time=1"});
  check("default scene", "", {"Time/Tolerance=1e-6"});
  check("rigid obstacle",
        "",
        {"Contact/Condition=rigid", "Time/Tolerance=1e-6", "Time/End time=3"});
  check("end traction",
        "",
        {"Boundary/right/Traction=0.1*t",
         "Time/Tolerance=1e-6",
         "Time/End time=3"});
  check("row",
        "",
        {"Model/Fields=displacement",
         "Bodies/a/Length=0.5",
         "Bodies/a/Velocity=x",
         "Bodies/b/Length=0.5",
         "Contact/Compliance=0.1",
         "Time/Scheme=sdirk4",
         "Time/Tolerance=1e-6",
         "Time/End time=3"});
  check("box",
        "",
        {"Model/Fields=displacement",
         "Model/Viscosity=0",
         "Contact/Condition=rigid",
         "Mesh/Degree=1",
         "Mesh/Cells=200",
         "Time/Scheme=box",
         "Time/Step size=0.005",
         "Time/End time=3"});
}
