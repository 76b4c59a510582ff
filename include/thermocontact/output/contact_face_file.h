// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef thermocontact_output_contact_face_file_h
#define thermocontact_output_contact_face_file_h

#include <thermocontact/output/output_units.h>
#include <thermocontact/space/body.h>
#include <thermocontact/space/state.h>

#include <deal.II/base/data_out_base.h>

#include <string>

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
   * A VTU file with the shape of an obstacle: the contact nodes of the
   * undeformed end, their gap and, so that what moves the body moves the
   * obstacle to its place, the displacement (gap, 0, 0); of one behind the end
   * (-rear_gap, 0, 0) at points behind those. Lines between the
   * nodes if dim = 2, quadrilaterals if dim = 3.
   *
   * @param rear_gap infinite: there is no obstacle behind the end
   * @param gap of an obstacle that moves, at the time of the file; else the
   *   gaps are those of the nodes
   */
  template <int dim>
  std::string
  obstacle_file(const ContactEnd<dim>       &end,
                const OutputUnits           &units,
                const double                 rear_gap,
                const dealii::Function<dim> *gap = nullptr);
} // namespace ThermoContact

#endif
