// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef thermocontact_space_body_h
#define thermocontact_space_body_h

#include <thermocontact/scene/scene.h>
#include <thermocontact/space/assembled_space.h>
#include <thermocontact/space/boundary_flows.h>
#include <thermocontact/space/driven_end.h>
#include <thermocontact/space/energy.h>
#include <thermocontact/space/loads.h>
#include <thermocontact/space/nonlinear_terms.h>
#include <thermocontact/space/obstacle_motion.h>
#include <thermocontact/space/problem_data.h>
#include <thermocontact/space/surroundings.h>
#include <thermocontact/space/thermoviscoelastic_operator.h>

#include <algorithm>
#include <memory>
#include <vector>

namespace ThermoContact
{
  /**
   * The body of a scene, discretised in space: spaces, matrices, loads and
   * energy of the semidiscrete equations, doc/discretisation.md (D1.1), (D1.2),
   * with the data of the scene. Integrators need no more.
   *
   * Constant but for the time at which the loads were evaluated last.
   */
  template <int dim>
  struct Body
  {
    /**
     * Collective.
     *
     * @param scene borrowed
     * @param shared of such a scene, borrowed; null: the body has its own
     * @throw InputError if an expression of the scene cannot be evaluated
     */
    Body(const Scene               &scene,
         const MPI_Comm             communicator,
         const AssembledSpace<dim> *shared = nullptr);

    ~Body(); // compiled once

    const Scene                                     &scene;
    ProblemData<dim>                                 data;
    const std::unique_ptr<const AssembledSpace<dim>> own_space;
    const AssembledSpace<dim>                       &space;
    const Discretization<dim>                       &discretization;
    const ThermoviscoelasticOperator<dim>            equations;
    Loads<dim>                                       loads;
    const Surroundings<dim>                          surroundings;
    const Energy<dim>                                energy;
    const DrivenEnd<dim>                             driven_end;
    const ObstacleMotion<dim>                        obstacle;
    BoundaryFlows<dim>                               boundary_flows;

    /** Null where no coefficient depends on the temperature. */
    const std::unique_ptr<const NonlinearTerms<dim>> nonlinear;

    /** The law of the obstacle in front; contacts of a row may have their own,
     * SceneContact::law_at(). */
    const ContactLaw &
    law() const
    {
      return *scene.contact.law;
    }

    /** A state of zeros with the gaps at $t=0$. */
    State
    make_state() const
    {
      State state = discretization.make_state();
      std::copy_n(obstacle.gaps_at_start().begin(),
                  state.gap.size(),
                  state.gap.begin());
      return state;
    }

    const ContactEnd<dim> &
    contact_end() const
    {
      return discretization.contact_end();
    }
  };
} // namespace ThermoContact

#endif
