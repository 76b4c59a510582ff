// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef thermocontact_output_contact_face_file_h
#define thermocontact_output_contact_face_file_h

#include <thermocontact/output/vtu_cells.h>
#include <thermocontact/space/body.h>
#include <thermocontact/space/state.h>

namespace ThermoContact
{
  /**
   * The contact end of a body in two or three dimensions, a line or a surface
   * through the contact nodes: contact_pressure, gap ($g-u$), in_contact (as
   * in contact.csv), and temperature, if the scene has it. Collective.
   */
  template <int dim>
  VtuCells<dim - 1, dim>
  contact_face(const Body<dim>   &body,
               const State       &state,
               const OutputUnits &units);



  /**
   * The shape of an obstacle: the contact nodes of the undeformed end, their
   * gap and, so that what moves the body moves the obstacle to its place, the
   * displacement (gap, 0, 0); of one behind the end $(-g_2,0,0)$ at nodes
   * behind those.
   *
   * @param gap at the time of the file
   * @param moved displacement of an obstacle that has a mass
   */
  template <int dim>
  VtuCells<dim - 1, dim>
  obstacle_shape(const Body<dim>             &body,
                 const OutputUnits           &units,
                 const dealii::Function<dim> &gap,
                 const double                 moved = 0.);
} // namespace ThermoContact

#endif
