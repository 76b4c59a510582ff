// SPDX-License-Identifier: LGPL-2.1-or-later

#include <thermocontact/base/exceptions.h>
#include <thermocontact/base/special_numbers.h>
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
    // Per unknown, without what grows with the degree.
    constexpr double bytes_by_iteration = 600.;
    // Dense matrices of the contact nodes in a step that conserves energy.
    constexpr double n_dense_matrices = 10.;



    /**
     * Of a body without matrices, by its degree: values of basis functions at
     * the points of all faces of a cell in all orientations, with the rules of
     * loads and of heat exchange; entries between contact nodes without mass,
     * twice, and while they are collected in a tree.
     */
    double
    bytes_of_degree(const Scene &scene, const unsigned int n_ranks)
    {
      const MeshParameters &mesh           = scene.parameters.mesh;
      const unsigned int    dim            = scene.parameters.dimension;
      const double          degree         = mesh.degree;
      const double          n_faces        = dim == 2 ? 4. * 2. : 6. * 8.;
      constexpr double      bytes_of_entry = 16. + 12. + 72.;
      const double          tables =
        n_faces * std::pow(degree + 1., dim) *
        (std::pow(degree + 3., dim - 1.) + std::pow(degree + 1., dim - 1.));
      const double n_entries = scene.contact.has_massless_nodes ?
                                 mesh.n_contact_cells(dim) * degree *
                                   std::pow(degree + 1., 2. * (dim - 1.)) :
                                 0.;
      return n_ranks * sizeof(double) * tables + bytes_of_entry * n_entries;
    }



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



    /** Number of responses to the contact nodes: the direct solver has one for
     * each node, the iterative solver for a scheme that needs them. */
    double
    n_responses(const Scene &scene)
    {
      const unsigned int dim = scene.parameters.dimension;
      return scene.contact.law->is_active() &&
                 (!scene.linear_solver.is_iterative ||
                  scene.scheme.integrator ==
                    IntegratorKind::energy_conserving) ?
               scene.parameters.mesh.n_contact_nodes(dim) :
               0.;
    }



    /** A Reset has factors of its own: its Equilibrium is not trivial. */
    bool
    has_equilibrium(const Scene &scene)
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
      return processes + bytes_by_iteration * n_unknowns +
             bytes_of_degree(scene, n_ranks) +
             n_ranks * n_dense_matrices * sizeof(double) *
               std::pow(n_responses(scene), 2);
    // neighbours of a node are as many as nodes of the cells around it
    const double width = (scene.parameters.mesh.degree + 1.) / 3.;
    const double n_kept =
      scene.parameters.time.has_error_control() ?
        n_kept_factorizations(dim, static_cast<std::size_t>(n_unknowns)) :
        1.;
    return processes + std::pow(width, dim) * matrix_bytes(dim) * n_unknowns +
           (n_kept + has_equilibrium(scene)) * factor_bytes(n_unknowns, dim);
  }



  double
  expected_cpu_seconds(const Scene &scene, const double n_steps)
  {
    const Parameters  &parameters = scene.parameters;
    const unsigned int dim        = parameters.dimension;
    const double       n          = scene.n_unknowns();
    const double       n_stages   = n_steps * scene.scheme.n_stages;
    const double       n_made =
      has_equilibrium(scene) + (parameters.time.has_error_control() ?
                                  std::min(1. + 0.25 * n_steps, 20.) :
                                  1.);
    if (scene.linear_solver.is_iterative)
      {
        // iterations grow where a body hardly changes its volume, and smoothers
        // do not treat such motions, doc/discretisation.md
        const double softness =
          std::min(std::pow(std::max(1., 0.57 / scene.material.two_mu), 0.35),
                   parameters.mesh.degree > 1 &&
                       scene.geometry->has_uniform_weight() ?
                     1.6 :
                     infinity);
        return seconds_of_process +
               n *
                 (1.2e-5 + 2e-6 * softness *
                             (n_stages + n_made * (0.1 + n_responses(scene))));
      }
    const double stage =
      dim == 2 ? 2e-8 * std::pow(n, 1.4) : 3.5e-8 * std::pow(n, 1.54);
    const double factors =
      dim == 2 ? 2e-7 * std::pow(n, 1.5) : 5e-8 * std::pow(n, 2.);
    // of coefficients of the temperature: iterations of Newton's method, each
    // with integrals over all cells
    const double n_tangents =
      scene.sources.has_nonlinear_terms ? 3. * n_stages : 0.;
    const double n_points  = std::pow(parameters.mesh.degree + 1., dim),
                 n_in_cell = (dim + 1.) * n_points;
    const double integrals =
      4e-9 * n_points * n_in_cell * n_in_cell * parameters.mesh.n_cells(dim);
    return seconds_of_process + 3e-5 * n +
           n_made * (factors + n_responses(scene) * stage) + n_stages * stage +
           n_tangents * (factors + integrals);
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
           "\n  allowed: less than twice the memory that there is, since the "
           "forecast may be off by as much\n  remedy:  fewer Mesh/Cells, a "
           "lower Mesh/Degree",
           is_iterative ? ", ranks on other machines" :
                          ", Solver/Linear solver = iterative"));
  }
} // namespace ThermoContact
