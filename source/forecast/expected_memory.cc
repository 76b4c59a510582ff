// SPDX-License-Identifier: LGPL-2.1-or-later

#include <thermocontact/base/exceptions.h>
#include <thermocontact/base/text.h>
#include <thermocontact/forecast/forecast.h>
#include <thermocontact/time/monolithic_solver.h>

#include <algorithm>
#include <cmath>

namespace ThermoContact
{
  namespace
  {
    // Measured, doc/bodies.md.
    constexpr double seconds_of_process = 0.4;
    constexpr double bytes_of_process   = 1.7e8;
    // Per unknown; and where no lines of nodes across the body are alike.
    constexpr double bytes_by_iteration = 600., bytes_of_lines = 500.;



    /** Of a matrix of degree 2 per unknown, mesh and vectors included. */
    double
    matrix_bytes(const unsigned int dim)
    {
      return dim == 2 ? 1500. : 4000.;
    }



    /** Of the factors of such a matrix. */
    double
    factor_bytes(const double n_unknowns, const unsigned int dim)
    {
      return dim == 2 ? 330. * std::pow(n_unknowns, 1.22) :
                        92. * std::pow(n_unknowns, 1.54);
    }



    /** Sets of factors of a Reset: its Equilibrium, where it is not trivial. */
    unsigned int
    n_equilibria(const Scene &scene)
    {
      const ContactLaw &law = *scene.contact.law;
      return !scene.material.has_inertia() ||
             (law.is_active() && law.is_rigid());
    }
  } // namespace



  double
  expected_memory(const Scene &scene, const unsigned int n_ranks)
  {
    const unsigned int dim        = scene.parameters.dimension;
    const double       n_unknowns = scene.n_unknowns();
    const double       processes  = n_ranks * bytes_of_process;
    if (dim == 1)
      return processes; // its matrices are small
    if (scene.linear_solver.is_iterative)
      {
        const MeshParameters &mesh = scene.parameters.mesh;
        const bool            has_equal_lines =
          dim == 2 || mesh.grading == 1. || mesh.grading_across == 1.;
        return processes +
               (bytes_by_iteration + (has_equal_lines ? 0. : bytes_of_lines)) *
                 n_unknowns;
      }
    // neighbours of a node are as many as nodes of the cells around it
    const double width = (scene.parameters.mesh.degree + 1.) / 3.;
    const double n_kept =
      scene.parameters.time.has_error_control() ?
        n_kept_factorizations(dim, static_cast<std::size_t>(n_unknowns)) :
        1.;
    return processes + std::pow(width, dim) * matrix_bytes(dim) * n_unknowns +
           (n_kept + n_equilibria(scene)) * factor_bytes(n_unknowns, dim);
  }



  double
  expected_cpu_seconds(const Scene &scene, const double n_steps)
  {
    const double n_sizes = n_step_sizes(scene.parameters, n_steps);
    return seconds_of_process +
           scene.linear_solver.cost.seconds(n_sizes + n_equilibria(scene),
                                            n_steps * scene.scheme.n_stages);
  }



  void
  check_memory(const Scene       &scene,
               const unsigned int n_ranks,
               const double       available,
               const double       share)
  {
    const double expected = share * expected_memory(scene, n_ranks);
    if (expected <= 2. * available)
      return;
    const bool is_iterative = scene.linear_solver.is_iterative;
    throw InputError(
      text(is_iterative ? "Mesh/Cells" : "Solver/Linear solver",
           ": with ",
           significant(scene.n_unknowns(), 3),
           " unknowns, ",
           scene.linear_solver.name(),
           ", the run takes about ",
           significant(expected / 1e9, 2),
           " GB of memory here, where there are ",
           significant(available / 1e9, 2),
           "\n  allowed: what takes less than twice as much as there is, since "
           "the forecast may be off by as much\n  remedy:  fewer Mesh/Cells, a "
           "lower Mesh/Degree",
           is_iterative ? ", ranks on other machines" :
                          ", Solver/Linear solver = iterative"));
  }
} // namespace ThermoContact
