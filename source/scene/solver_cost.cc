// SPDX-License-Identifier: LGPL-2.1-or-later

#include <thermocontact/scene/scene.h>
#include <thermocontact/scene/solver_cost.h>

#include <algorithm>
#include <cmath>

namespace ThermoContact
{
  SolverCost
  cost_of_factors(const Parameters &parameters,
                  const double      n_unknowns,
                  const bool        has_contact)
  {
    const unsigned int dim = parameters.dimension;
    const double       n   = n_unknowns;
    const double       stage =
      dim == 2 ? 2e-8 * std::pow(n, 1.4) : 3.5e-8 * std::pow(n, 1.54);
    const double factor =
      dim == 2 ? 2e-7 * std::pow(n, 1.5) : 5e-8 * std::pow(n, 2.);
    const double n_responses =
      has_contact ? parameters.mesh.n_contact_nodes(dim) : 0.;
    // neighbours of a node are as many as nodes of the cells around it
    const double width = (parameters.mesh.degree + 1.) / 3.;
    return {(dim == 2 ? 1e-5 : 3e-5) * std::pow(width, dim) * n,
            factor + n_responses * stage,
            stage};
  }



  SolverCost
  cost_of_iterations(const Parameters &parameters,
                     const Material   &material,
                     const double      n_unknowns)
  {
    const unsigned int dim      = parameters.dimension;
    const double       degree   = parameters.mesh.degree;
    const double       softness = std::pow(std::max(1., 0.57 / material.two_mu),
                                     material.has_inertia() ? 0.2 : 0.35);
    // smoothers do what keeps its volume where they can, doc/discretisation.md
    const double relative =
      degree > 1. && parameters.mesh.geometry != "axisymmetric" ?
        std::min(softness, 1.6) :
        softness;
    // fewer, larger cells have more couplings
    const double couplings = std::max(1., std::pow(degree / 4., dim - 1.));
    const double stage = (material.has_inertia() ? 1.4e-6 : 2e-6) * relative *
                         couplings * n_unknowns;
    return {1.2e-5 * n_unknowns, 0.1 * stage, stage};
  }



  double
  n_step_sizes(const Parameters &parameters, const double n_steps)
  {
    return parameters.time.has_error_control() ?
             std::min(1. + 0.25 * n_steps, 20.) :
             1.;
  }
} // namespace ThermoContact
