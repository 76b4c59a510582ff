// SPDX-License-Identifier: LGPL-2.1-or-later
//
// 1. Parameter files that can be read; faults are in app/bad_file.
// 2. T = 71711.8845, dt = 3e-4: 239039615 steps of dt, although the quotient
//    rounds to more.
// 3. Meshes by hand. Three cells with the ratio 4 have the sizes 4/7, 2/7, 1/7,
//    two with the ratio 3 across 0.3 have 0.225, 0.075: aspect (4/7)/0.075,
//    and 1/7/4/3 between nodes of degree 3 after two refinements; 3 x 2 x 2
//    cells are 768 then, (36 + 1)(24 + 1) nodes, 25^2 at the end. 12 and 20
//    cells halve twice, 10 once.
// 4. Strips of 44 x 22 and 48 x 24 cells of degree 2 have 89 x 45 and 97 x 49
//    nodes with 3 unknowns each, 12015 and 14259: the second is beyond 13000.
//    Of 144 x 72 and 148 x 74 cells with energy conserving they are 125715 and
//    132759: the second is beyond 130000.
// 5. Of n letters (n + 1)/3 may be wrong, exchanged neighbours are one, if
//    there are at most 100; the first of the nearest ones is meant. Of 21
//    faults 20 are told.
// 6. Numbers without a unit on both sides of what is likely.

#include <thermocontact/base/exceptions.h>
#include <thermocontact/input/si_scene.h>
#include <thermocontact/input/unknown_names.h>

#include <algorithm>
#include <fstream>
#include <sstream>

#include "../tests.h"


using namespace ThermoContact;

namespace
{
  void
  read(const std::string &text)
  {
    Parameters               parameters;
    dealii::ParameterHandler prm;
    parameters.add_parameters(prm);
    std::istringstream input(text);
    ThermoContact::assign_entries(read_assignments(input, "rod.prm"),
                                  prm,
                                  parameters);
    check_scene(parameters);
    deallog << "read; viscosity " << parameters.model.viscosity << ", title '"
            << parameters.title << "'" << std::endl;
  }



  void
  test_files()
  {
    read("# a comment\nset Title = A = B # another\n"
         "subsection Model\n  set Viscosity = \\\n  0.5\nend\n");
    // in the section where it stands; what stands behind it holds
    std::ofstream("part.prm") << "set Viscosity = 0.5\nset Coupling = 0.1\n";
    read("subsection Model\n  include part.prm\n  set Viscosity = 2\nend\n");
  }



  /** What stands behind it holds. */
  void
  test_override()
  {
    Parameters               parameters;
    dealii::ParameterHandler prm;
    parameters.add_parameters(prm);
    for (const std::string rear : {"0.5", "none"})
      ThermoContact::assign_entries({{"here", "Contact/Rear gap", rear}},
                                    prm,
                                    parameters);
    deallog << "a rear stop that was taken back "
            << (parameters.contact.rear_gap ? "is there" : "is not")
            << std::endl;
  }



  void
  test_misprints()
  {
    const std::string hundred(100, 'x');
    for (const auto &[name, other] :
         std::vector<std::pair<std::string, std::string>>{{"a", "b"},
                                                          {"ab", "ac"},
                                                          {"abc", "acb"},
                                                          {"abcd", "abc"},
                                                          {"abcd", "abcdef"},
                                                          {"abcd", "abxy"},
                                                          {"abcde", "ABxye"},
                                                          {"abcde", "xyzde"},
                                                          {hundred + 'x',
                                                           hundred},
                                                          {hundred, hundred}})
      deallog << (did_you_mean(name, {"far away", other, other + 'z'}).empty() ?
                    "none " :
                    "near ");
    deallog << did_you_mean("abcde", {"abxye", "abcye", "abcdf"}) << std::endl;
    try
      {
        throw_faults(std::vector<std::string>(21, "x"));
      }
    catch (const InputError &error)
      {
        const std::string message = error.what();
        deallog << message.substr(0, 9) << ", told "
                << std::count(message.begin(), message.end(), 'x') << std::endl;
      }
  }



  void
  test_meshes()
  {
    MeshParameters mesh;
    mesh.cells          = 3;
    mesh.degree         = 3;
    mesh.refinements    = 2;
    mesh.grading        = 4.;
    mesh.width          = 0.3;
    mesh.cells_across   = 2;
    mesh.grading_across = 3.;
    deallog << "aspect " << mesh.cell_aspect() << ", spacing "
            << mesh.contact_spacing() << ", cells " << mesh.n_cells(3)
            << ", nodes " << mesh.n_nodes(2) << ' ' << mesh.n_contact_nodes(3)
            << ", halvings " << mesh.n_halvings();
    mesh.grading = mesh.grading_across = 1.;
    mesh.cells                         = 12;
    for (const unsigned int across : {20, 10})
      {
        mesh.cells_across = across;
        deallog << ' ' << mesh.n_halvings();
      }
    for (double *const grading : {&mesh.grading, &mesh.grading_across})
      {
        *grading = 2.;
        deallog << ' ' << mesh.n_halvings();
        *grading = 1.;
      }
    mesh.cells_across = 0; // squares
    for (const double width : {0.3, 0.01})
      {
        mesh.width = width;
        deallog << ", across " << mesh.n_cells_across();
      }
    deallog << std::endl;
  }



  void
  test_choice_of_solver()
  {
    Parameters strip;
    strip.dimension   = 2;
    strip.mesh.degree = 2;
    for (const unsigned int cells : {44, 48, 144, 148})
      {
        if (cells > 100)
          strip.time.scheme = "energy conserving";
        strip.mesh.cells        = cells;
        strip.mesh.cells_across = cells / 2;
        const Scene scene(strip);
        deallog << scene.linear_solver.name() << ": "
                << scene.linear_solver.reason << std::endl;
      }
  }



  void
  test_doubts()
  {
    const auto doubts = [](const std::string &path, const std::string &value) {
      return implausible_numbers(
        {{"here", "Rod/Viscosity", "1"}, {"here", path, value}});
    };
    struct Bound
    {
      std::vector<std::string> paths;
      std::string              inside, outside, base, unit;
    };
    for (const Bound &one : std::vector<Bound>{
           {{"Boundary/sides/Surroundings",
             "Boundary/left/Temperature",
             "Boundary/right/Surroundings",
             "Initial values/Temperature",
             "Rod/Reference temperature"},
            "151",
            "149",
            "K",
            "degC"},
           {{"Contact/Gap", "Contact/Rear gap"}, "0.9", "1.1", "m", "um"},
           {{"Contact/Gap", "Contact/Rear gap"}, "-0.9", "-1.1", "m", "um"},
           {{"Contact/Stiffness"}, "1.1e3", "900", "N/m", "N/mm"},
           {{"Rod/Cross-section area"}, "0.9", "1.1", "m^2", "mm^2"},
           {{"Rod/Density"}, "20.1", "19.9", "kg/m^3", "g/cm^3"},
           {{"Rod/Density"}, "2.9e4", "3.1e4", "kg/m^3", "g/m^3"},
           {{"Rod/Heat capacity"}, "10.1", "9.9", "J/(kg K)", "kJ/(kg K)"},
           {{"Rod/Length"}, "99", "101", "m", "mm"},
           {{"Rod/Linear expansion"}, "9e-4", "1.1e-3", "1/K", "um/(m K)"},
           {{"Rod/Linear expansion"}, "-9e-4", "-1.1e-3", "1/K", "um/(m K)"},
           {{"Rod/Young's modulus"}, "1.1e8", "9.9e3", "Pa", "GPa"},
           {{"Rod/Young's modulus"}, "1.1e8", "1.1e4", "Pa", "MPa"},
           {{"Rod/Young's modulus"}, "1.1e8", "9.9e7", "Pa", "MPa"}})
      for (const std::string &path : one.paths)
        if (const std::vector<std::string> said = doubts(path, one.outside);
            said !=
              std::vector<std::string>{path + " = " + one.outside +
                                       ": is that in " + one.base + ", or " +
                                       one.outside + ' ' + one.unit +
                                       "? With its unit it is not doubted"} ||
            !doubts(path, one.inside).empty() ||
            !doubts(path, one.outside + ' ' + one.base).empty())
          deallog << path << " = " << one.outside << " is doubted "
                  << said.size() << " times" << std::endl;
  }
} // namespace



void
main_parameters()
{
  initlog();
  test_files();
  test_override();

  TimeParameters time;
  time.end_time  = 71711.8845;
  time.step_size = 3e-4;
  deallog << "steps " << time.n_steps() << std::endl;
  test_misprints();
  test_meshes();
  test_choice_of_solver();
  test_doubts();
}
