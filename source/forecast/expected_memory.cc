// SPDX-License-Identifier: LGPL-2.1-or-later

#include <thermocontact/base/exceptions.h>
#include <thermocontact/base/text.h>
#include <thermocontact/forecast/expected_memory.h>
#include <thermocontact/time/monolithic_solver.h>

#include <cmath>

namespace ThermoContact
{
  namespace
  {
    // Measured, doc/bodies.md.
    constexpr double bytes_of_process   = 1.7e8;
    constexpr double bytes_by_iteration = 700.; // per unknown



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



    double
    expected_unknowns(const Scene &scene)
    {
      const unsigned int dim = scene.parameters.dimension;
      return scene.parameters.mesh.n_nodes(dim) *
             scene.fields.n_components(dim);
    }
  } // namespace



  double
  expected_memory(const Scene &scene, const unsigned int n_ranks)
  {
    const unsigned int dim        = scene.parameters.dimension;
    const double       n_unknowns = expected_unknowns(scene);
    const double       processes  = n_ranks * bytes_of_process;
    if (dim == 1)
      return processes; // its matrices are small
    if (scene.linear_solver.is_iterative)
      return processes + bytes_by_iteration * n_unknowns;
    // neighbours of a node are as many as nodes of the cells around it
    const double width = (scene.parameters.mesh.degree + 1.) / 3.;
    const double n_kept =
      scene.parameters.time.has_error_control() ?
        n_kept_factorizations(dim, static_cast<std::size_t>(n_unknowns)) :
        1.;
    return processes + std::pow(width, dim) * matrix_bytes(dim) * n_unknowns +
           std::pow(width, dim - 1.) * n_kept * factor_bytes(n_unknowns, dim);
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
           significant(expected_unknowns(scene), 3),
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
