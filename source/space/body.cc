// SPDX-License-Identifier: LGPL-2.1-or-later

#include <thermocontact/space/body.h>

namespace ThermoContact
{
  template <int dim>
  Body<dim>::Body(const Scene               &scene,
                  const MPI_Comm             communicator,
                  const AssembledSpace<dim> *shared)
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
    , surroundings(scene, contact_end())
    , energy(scene, discretization, equations, loads, surroundings)
    , driven_end(scene, discretization, equations, loads, energy)
    , obstacle(scene, contact_end())
    , boundary_flows(scene, discretization, equations, surroundings, loads)
    , nonlinear(make_nonlinear_terms(scene, equations))
  {}



  template <int dim>
  Body<dim>::~Body() = default;



  template struct Body<1>;
  template struct Body<2>;
  template struct Body<3>;
} // namespace ThermoContact
