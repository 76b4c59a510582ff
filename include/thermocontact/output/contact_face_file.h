// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef thermocontact_output_contact_face_file_h
#define thermocontact_output_contact_face_file_h

#include <thermocontact/output/output_units.h>
#include <thermocontact/space/body.h>
#include <thermocontact/space/state.h>

#include <deal.II/base/data_out_base.h>

#include <string>
#include <vector>

namespace ThermoContact
{
  /**
   * The contact end of a body in two or three dimensions as a VTU file, a line
   * or a surface through the contact nodes: contact_pressure, gap ($g-u$),
   * in_contact (1 where $p>0$), and temperature, if the scene has it.
   * Collective.
   *
   * @return on rank 0, the file; elsewhere nothing
   */
  template <int dim>
  std::string
  contact_face_file(const Body<dim>             &body,
                    const State                 &state,
                    const DataOutBase::VtkFlags &flags,
                    const OutputUnits           &units);



  /**
   * The cells of the grid that contact nodes, in order of their positions,
   * form: 2 corners of a line, or 4 of a quadrilateral in the order of VTK,
   * cell after cell.
   */
  template <int dim>
  std::vector<unsigned int>
  contact_face_corners(const std::vector<ContactNode<dim>> &nodes);
} // namespace ThermoContact

#endif
