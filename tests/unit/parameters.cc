// SPDX-License-Identifier: LGPL-2.1-or-later
//
// Reading parameter files: every fault has a message with its line, and what is
// written is read back. T = 71711.8845, dt = 3e-4: 239039615 steps of dt,
// although the quotient rounds to more. A law that is not linear: only the
// scheme that conserves its energy refuses it.

#include <thermocontact/base/exceptions.h>

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
    try
      {
        ThermoContact::assign_entries(read_assignments(input, "rod.prm"),
                                      prm,
                                      parameters);
        check_unused_entries(parameters, prm);
        check_scene(parameters);
        deallog << "read; viscosity " << parameters.model.viscosity
                << ", title '" << parameters.title << "'" << std::endl;
      }
    catch (const InputError &error)
      {
        deallog << error.what() << std::endl;
      }
  }



  void
  test_files()
  {
    read("# a comment\nset Title = A = B # another\n"
         "subsection Model\n  set Viscosity = \\\n  0.5\nend\n");
    read("subsection Model\n  set Viscosity = 0.5\n  set Viscosity = 1\nend\n");
    read("subsection Model\n  set Viscosity = 0.5\n");
    read("set Title = x\nend\n");
    read("subsection Model\n  sett Viscosity = 0.5\nend\n");
    read("set Title\n");
    read("include other.prm\n");
    // in the section where it stands; what stands behind it holds
    std::ofstream("part.prm") << "set Viscosity = 0.5\nset Coupling = 0.1\n";
    read("subsection Model\n  include part.prm\n  set Viscosity = 2\nend\n");
    read("set Dimension = 2 \\");
    read("set Title = a\\b \\\n c\n");
    read("subsection Time\n  set Tolerances = 1e-5\nend\n");
    read(std::string("set Title = \0", 13));
    read("subsection Model\n  set Viskosity = 0.5\nend\n");
    read("set Viscosity = 0.5\n");
    read("subsection Modell\n  set Viscosity = 0.5\nend\n");
    read("subsection Model\n  set Viscosity = half\nend\n");
    read("subsection Model\n  set Poisson ratio = 0.3\nend\n");
    read(
      "set Dimension = 2\nsubsection Model\n  set Poisson ratio = 0.5\nend\n");
  }



  /** What is written can be read, and says the same. */
  void
  test_round_trip()
  {
    Parameters               parameters;
    dealii::ParameterHandler prm;
    parameters.add_parameters(prm);
    ThermoContact::assign_entries(
      {{"here", "Model/Viscosity", "0.12345678901234567"},
       {"here", "Contact/Condition", "rigid"},
       {"here", "Title", "a = b"}},
      prm,
      parameters);
    std::stringstream written;
    write_entries(declared_entries(prm), {"Contact/Compliance"}, written);

    Parameters               again;
    dealii::ParameterHandler prm_again;
    again.add_parameters(prm_again);
    const auto assignments = read_assignments(written, "used.prm");
    ThermoContact::assign_entries(assignments, prm_again, again);
    bool omitted = true;
    for (const Assignment &assignment : assignments)
      omitted &= assignment.path != "Contact/Compliance";
    std::stringstream written_again;
    write_entries(declared_entries(prm_again),
                  {"Contact/Compliance"},
                  written_again);
    deallog << "round trip: same number "
            << (again.model.viscosity == 0.12345678901234567) << ", same text "
            << (written.str() == written_again.str()) << ", omitted " << omitted
            << std::endl;
    for (const std::string rear :
         {"0.5", "none"}) // what stands behind it holds
      ThermoContact::assign_entries({{"here", "Contact/Rear gap", rear}},
                                    prm,
                                    parameters);
    deallog << "a rear stop that was taken back "
            << (parameters.contact.rear_gap ? "is there" : "is not")
            << std::endl;
  }



  void
  test_scheme_and_law()
  {
    const ContactLawKind cubic{"cubic", "for this test", {}, nullptr};
    const auto           law =
      contact_law("power law")
        .make({{"Compliance", 1.}, {"Exponent", 3.}, {"Damping", 0.}});
    for (const Scheme &scheme : schemes())
      try
        {
          check_scheme_fits_law(scheme, cubic, *law);
          deallog << scheme.name << ": treats any law" << std::endl;
        }
      catch (const InputError &error)
        {
          deallog << error.what() << std::endl;
        }
  }
} // namespace



void
main_parameters()
{
  initlog();
  test_files();
  test_round_trip();

  TimeParameters time;
  time.end_time  = 71711.8845;
  time.step_size = 3e-4;
  deallog << "steps " << time.n_steps() << std::endl;
  test_scheme_and_law();
}
