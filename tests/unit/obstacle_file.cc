// SPDX-License-Identifier: LGPL-2.1-or-later
//
// obstacle.vtu of a round rod, radius 0.2, two cells of degree 2 across: its
// nodes are at y = 0, 0.05, 0.1, 0.15, 0.2. The one on the axis has no
// pressure, since it has no weight, but the obstacle is there, too: five points
// in the order of y, four lines between neighbours, and gaps 0.02 + y^2/2 from
// 0.02 at the tip to 0.04, which is also the range that the screen shows. With
// a rear stop at 0.01 there are five points more, 0.01 behind the end, and
// their lines.

#include <thermocontact/output/contact_face_file.h>
#include <thermocontact/space/body.h>

#include <deal.II/base/mpi.h>

#include <limits>

#include "../tests.h"

using namespace ThermoContact;

namespace
{
  /** The numbers of the array that is called @p name. */
  std::vector<double>
  numbers_of(const std::string &file, const std::string &name)
  {
    const std::size_t   begin = file.find('>', file.find(name)) + 1;
    std::istringstream  text(file.substr(begin, file.find('<', begin) - begin));
    std::vector<double> result;
    for (double number; text >> number;)
      result.push_back(number);
    return result;
  }
} // namespace



void
main_obstacle_file()
{
  initlog();
  Parameters           parameters = read_parameters("",
                                          {"Dimension=2",
                                                     "Mesh/Geometry=axisymmetric",
                                                     "Mesh/Width=0.2",
                                                     "Mesh/Cells=2",
                                                     "Mesh/Cells across=2",
                                                     "Mesh/Degree=2",
                                                     "Contact/Gap=0.02+y^2/2"});
  const Scene          scene(parameters);
  const Body<2>        body(scene, MPI_COMM_SELF);
  const ContactEnd<2> &end = body.contact_end();
  const std::string    file =
    obstacle_file(end,
                  OutputUnits(parameters),
                  std::numeric_limits<double>::infinity());

  const std::vector<double> gaps   = numbers_of(file, "\"gap\"");
  const std::vector<double> points = numbers_of(file, "NumberOfComponents");
  deallog << "nodes with pressure " << end.n_nodes() << ", points at y";
  for (unsigned int i = 1; i < points.size(); i += 3)
    deallog << ' ' << points[i];
  deallog << std::endl << "gaps";
  for (const double gap : gaps)
    deallog << ' ' << gap;
  deallog << std::endl << "lines";
  for (const double node : numbers_of(file, "connectivity"))
    deallog << ' ' << node;
  deallog << std::endl
          << "range " << end.range_of_gap().first << ' '
          << end.range_of_gap().second << std::endl;

  const std::string both = obstacle_file(end, OutputUnits(parameters), 0.01);
  const std::vector<double> places = numbers_of(both, "displacement");
  deallog << "with a rear stop: at x - 1";
  for (unsigned int i = 0; i < places.size(); i += 3)
    deallog << ' ' << places[i];
  deallog << std::endl << "lines";
  for (const double node : numbers_of(both, "connectivity"))
    deallog << ' ' << node;
  deallog << std::endl;
}
