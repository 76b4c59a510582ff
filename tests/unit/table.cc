// SPDX-License-Identifier: LGPL-2.1-or-later
//
// Measured loads. Rows (0, 2), (1, 4), (3, 0): linear between them, constant
// beyond: 2 at -1, 3 at 0.5, 2 at 2, 0 at 5, the slopes 2 at 0.5, -2 at 2; as a
// load to T = 4 kinks at 1 and 3. Squares of 0, 1, 2, 3 by a monotone cubic:
// its slopes at 1 and 2 are the harmonic means of 1, 3 and of 3, 5, which
// are 1.5 and 3.75, so that at 1.5 it is (1 + 4)/2 + (1.5 - 3.75)/8 = 2.21875;
// no kinks. In units: 2 kN at 1500 ms are 2000 at 1.5; kN are no measure of
// pressures, unless a factor makes them one, ms none of lengths. Each fault
// names file and row.

#include <thermocontact/base/exceptions.h>
#include <thermocontact/input/load_enclosure.h>

#include <fstream>
#include <string>

#include "../tests.h"

using namespace ThermoContact;

namespace
{
  Expression
  read(const std::string              &text,
       const bool                      has_units = false,
       const std::vector<std::string> &units     = {})
  {
    ExpressionNames names;
    names.variables = {"", "", "", "t"};
    names.has_units = has_units;
    names.units     = units;
    return Expression("Boundary/right/Traction", text, names);
  }



  void
  print_fault(const std::string &rows,
              const std::string &text      = "table(bad.csv, t)",
              const bool         has_units = false)
  {
    std::ofstream("bad.csv") << rows;
    try
      {
        read(text, has_units);
        deallog << text << ": read" << std::endl;
      }
    catch (const InputError &error)
      {
        deallog << error.what() << std::endl;
      }
  }
} // namespace



void
main_table()
{
  initlog();
  std::ofstream("force.csv") << "# measured\ntime, force\n0, 2\n1, 4\n3, 0\n";
  const TimeFunction force(read("table(force.csv, t)"));
  for (const double t : {-1., 0.5, 2., 5.})
    deallog << force.value(t) << ' ' << force.derivatives(t).first << ", ";
  deallog << "kinks";
  for (const LoadBreak &at : enclose_load(force, 4.).history.breaks)
    deallog << ' ' << at.time << (at.is_jump ? " jump" : "");
  deallog << std::endl;

  std::ofstream("squares.csv") << "t,u,v\n0,5,0\n1,5,1\n2,5,4\n3,5,9\n";
  const TimeFunction squares(read("smooth(squares.csv, v, t)"));
  deallog << squares.value(1.) << ' ' << squares.value(1.5) << ", kinks "
          << enclose_load(squares, 2.9).history.breaks.size() << std::endl;

  std::ofstream("units.csv") << "time [ms],force [kN]\n0,0\n1500,2\n3000,2\n";
  deallog << TimeFunction(read("table(units.csv, t)", true)).value(1.5)
          << std::endl;

  for (const std::string text :
       {"table(units.csv, t)", "2*table(units.csv, t)"})
    for (const std::string unit : {"s", "m"})
      try
        {
          read(text, true, {"", "", "", unit, "Pa"});
          deallog << text << ": read" << std::endl;
        }
      catch (const InputError &error)
        {
          deallog << error.what() << std::endl;
        }

  print_fault("0,1\n1,2\n");
  print_fault("t [ms],f\n0,1\n1,2\n");
  print_fault("t [ms],f [m^2]\n0,1\n1,2\n", "table(bad.csv, t)", true);
  print_fault("time,force\n0,1\n1,2\n", "table(bad.csv, forse, t)");
  print_fault("t f\n0 1\n1 2\n");
  print_fault("t,f\n0,1\n1\n");
  print_fault("t,f\n0,1\n1,x\n");
  print_fault("t,f\n10:00:00,1\n10:00:01,2\n");
  print_fault("t,f\n0,1\n0,2\n");
  print_fault("t,f\n0,1\n");
  print_fault("t,f\n0,1\n1,2\n", "smooth(bad.csv, t)");
}
