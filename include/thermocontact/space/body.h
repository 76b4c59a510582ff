// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef thermocontact_space_body_h
#define thermocontact_space_body_h

#include <thermocontact/scene/scene.h>
#include <thermocontact/space/assembled_space.h>
#include <thermocontact/space/driven_end.h>
#include <thermocontact/space/energy.h>
#include <thermocontact/space/loads.h>
#include <thermocontact/space/obstacle_motion.h>
#include <thermocontact/space/problem_data.h>
#include <thermocontact/space/thermoviscoelastic_operator.h>

#include <memory>
#include <vector>

namespace ThermoContact
{
  /**
   * The body of a scene, discretised in space: spaces, matrices, loads and
   * energy of the semidiscrete equations, doc/model.md (M.11), (M.12), with
   * what the scene says of them. What happens in time needs no more.
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
         const AssembledSpace<dim> *shared = nullptr)
      : scene(scene)
      , data(scene)
      , own_space(
          shared != nullptr ?
            nullptr :
            std::make_unique<const AssembledSpace<dim>>(scene, communicator))
      , space(shared != nullptr ? *shared : *own_space)
      , discretization(space.discretization)
      , equations(scene, discretization, space.matrices.get())
      , loads(scene, discretization, data)
      , energy(scene, discretization, equations, loads)
      , driven_end(scene, discretization, equations, loads, energy)
      , obstacle(scene, contact_end())
    {}

    const Scene                                     &scene;
    ProblemData<dim>                                 data;
    const std::unique_ptr<const AssembledSpace<dim>> own_space;
    const AssembledSpace<dim>                       &space;
    const Discretization<dim>                       &discretization;
    const ThermoviscoelasticOperator<dim>            equations;
    Loads<dim>                                       loads;
    const Energy<dim>                                energy;
    const DrivenEnd<dim>                             driven_end;
    const ObstacleMotion<dim>                        obstacle;

    /** The contact law, which every node has. */
    const ContactLaw &
    law() const
    {
      return *scene.contact.law;
    }

    const ContactEnd<dim> &
    contact_end() const
    {
      return discretization.contact_end();
    }

    /**
     * The pressures become those of the displacements and velocities, as the
     * law says; 0 where it says nothing, as for a rigid obstacle. Collective.
     */
    void
    set_pressures_of_law(State &state) const
    {
      std::vector<double> penetration, velocity;
      contact_end().get_penetrations(state, penetration);
      contact_end().get_relative_velocities(state, velocity);
      for (unsigned int i = 0; i < penetration.size(); ++i)
        state.contact_pressure[i] =
          law().damped_pressure(penetration[i], velocity[i]);
      if (!scene.contact.rear_gap)
        return;
      contact_end().get_rear_penetrations(state.displacement,
                                          *scene.contact.rear_gap,
                                          penetration);
      for (unsigned int i = 0; i < penetration.size(); ++i)
        state.contact_pressure[i] -=
          law().damped_pressure(penetration[i], -velocity[i]);
    }
  };
} // namespace ThermoContact

#endif
