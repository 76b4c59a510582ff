// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef thermocontact_scene_solver_cost_h
#define thermocontact_scene_solver_cost_h

#include <thermocontact/input/parameters.h>

namespace ThermoContact
{
  struct Material;

  /**
   * Processor time of a solver of the stages of a body, seconds, within a
   * factor of about two on the processors of doc/performance.md; doc/bodies.md
   * has the formulas.
   */
  struct SolverCost
  {
    double set_up;
    double size;  ///< of a step; factors and the responses to contact nodes
    double stage; ///< all its active sets together

    double
    seconds(const double n_sizes, const double n_stages) const
    {
      return set_up + n_sizes * size + n_stages * stage;
    }
  };



  /**
   * Of sparse factors.
   *
   * @param n_unknowns of all fields
   * @param has_contact each contact node has a response
   */
  SolverCost
  cost_of_factors(const Parameters &parameters,
                  const double      n_unknowns,
                  const bool        has_contact);



  /**
   * Of Krylov's method with multigrid: $\nu\to1/2$ takes more time, less so
   * with inertia.
   */
  SolverCost
  cost_of_iterations(const Parameters &parameters,
                     const Material   &material,
                     const double      n_unknowns);



  /** Sizes of so many steps, of those that a tolerance chooses. */
  double
  n_step_sizes(const Parameters &parameters, const double n_steps);
} // namespace ThermoContact

#endif
