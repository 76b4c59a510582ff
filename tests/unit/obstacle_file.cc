// SPDX-License-Identifier: LGPL-2.1-or-later
//
// obstacle.vtu of a round rod, radius 0.2, two cells of degree 2 across: its
// nodes are at y = 0, 0.05, 0.1, 0.15, 0.2. The one on the axis has no
// pressure, since it has no weight, but the obstacle is there, too: four lines
// between neighbours in the order of y, and gaps 0.02 + y^2/2 from 0.02 at the
// tip to 0.04, which is also the range that the screen shows. With a rear stop
// at 0.01 there are four lines more, 0.01 behind the end.

#include <thermocontact/output/contact_face_file.h>
#include <thermocontact/space/body.h>

#include <deal.II/base/mpi.h>

#include <string>
#include <vector>

#include "../tests.h"

using namespace ThermoContact;

namespace
{
  /** For each line y of its ends, and what a component is there. */
  void
  print(const VtuCells<1, 2> &shape, const unsigned int component)
  {
    for (const auto &line : shape.cells())
      deallog << "  " << line.vertices[0][1] << " to " << line.vertices[1][1]
              << ": " << line.data(component, 0) << ' '
              << line.data(component, 1) << std::endl;
  }
} // namespace



void
main_obstacle_file()
{
  initlog();
  const std::vector<std::string> entries = {"Dimension=2",
                                            "Mesh/Geometry=axisymmetric",
                                            "Mesh/Width=0.2",
                                            "Mesh/Cells=2",
                                            "Mesh/Cells across=2",
                                            "Mesh/Degree=2",
                                            "Contact/Gap=0.02+y^2/2"};
  for (const bool has_rear_stop : {false, true})
    {
      std::vector<std::string> all(entries);
      if (has_rear_stop)
        all.push_back("Contact/Rear gap=0.01");
      const Scene       scene(read_parameters("", all));
      const Body<2>     body(scene, MPI_COMM_SELF);
      const auto       &gaps = body.obstacle.gaps_at_start();
      const OutputUnits units(scene.parameters);
      if (!has_rear_stop)
        deallog << "nodes with pressure " << body.contact_end().n_nodes()
                << ", gap" << std::endl;
      else
        deallog << "range " << *std::min_element(gaps.begin(), gaps.end())
                << ' ' << *std::max_element(gaps.begin(), gaps.end())
                << std::endl
                << "with a rear stop, x - 1" << std::endl;
      print(obstacle_shape(body, units, *contact_gap<2>(scene)), has_rear_stop);
    }
}
