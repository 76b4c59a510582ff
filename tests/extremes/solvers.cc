// SPDX-License-Identifier: LGPL-2.1-or-later
//
// Random bodies in two and three dimensions (random_body.h): Poisson ratios
// from -0.5 to 0.499, cells with sides in ratios of 1 to 20, compliances from
// 1e-12 to 1e6 and rigid obstacles, no inertia, no viscosity, steps from 1e-9
// to 1e3. Each runs four steps with the direct and with the iterative solver of
// stages, at Linear tolerance = 1e-10. Either
//
//   agrees      temperatures, displacements, velocities and pressures at the
//               end are the same to 1e-6 of the largest values of the run, and
//               to 1e-5 the velocities, which at nodes without mass are
//               quotients of small displacements and steps: the tolerance
//               bounds residuals, and an error is larger by the condition of
//               the matrix with unit diagonal, at most 1e4 here;
//   explained   the iterative solver ends the run, or refuses the scene, with a
//               message that names the remedy Solver/Linear solver = direct (or
//               automatic).
//
// In the suite at most one in ten may be explained; scripts/extremes runs as
// many as one wants. The environment is that of campaign.cc.

#include <thermocontact/base/exceptions.h>
#include <thermocontact/simulation/simulation.h>

#include <deal.II/base/mpi.h>

#include <cmath>
#include <cstdlib>
#include <iostream>
#include <memory>

#include "../matched_spaces.h"
#include "random_body.h"

using namespace ThermoContact;

namespace
{
  using ThermoContact::Vector;

  /** Temperature, displacement, velocity, pressure. */
  using Sizes = std::array<double, 4>;

  const Sizes bounds{{1e-6, 1e-6, 1e-5, 1e-6}};

  unsigned int
  from_environment(const char *name, const unsigned int value)
  {
    const char *text = std::getenv(name);
    return text && *text ? std::stoul(text) : value;
  }



  template <int dim>
  struct Run
  {
    std::unique_ptr<Simulation<dim>> simulation;
    Sizes                            largest{};
    std::string                      message; ///< of what ended it early
    bool                             has_contact = false;

    Run(const TestScene &scene, const std::string &solver)
    {
      Overrides overrides = scene.overrides;
      overrides.push_back("Solver/Linear solver=" + solver);
      if (solver == "iterative")
        overrides.push_back("Solver/Linear tolerance=1e-10");
      try
        {
          simulation =
            std::make_unique<Simulation<dim>>(read_parameters("", overrides),
                                              MPI_COMM_SELF);
          simulation->run({[this](const Simulation<dim> &s) { observe(s); }});
        }
      catch (const std::exception &error)
        {
          message = error.what();
        }
    }

    void
    observe(const Simulation<dim> &s)
    {
      const State &state = s.state();
      raise(largest[0], state.temperature.linfty_norm());
      raise(largest[1], state.displacement.linfty_norm());
      raise(largest[2], state.velocity.linfty_norm());
      for (const double p : state.contact_pressure)
        raise(largest[3], p);
      has_contact |= s.record().in_contact;
    }
  };



  template <int dim>
  Sizes
  differences(const Run<dim> &direct, const Run<dim> &iterative)
  {
    const MatchedSpaces<dim> spaces(direct.simulation->discretization(),
                                    iterative.simulation->discretization());
    const State             &x     = direct.simulation->state();
    const State             &y     = iterative.simulation->state();
    const Sizes             &scale = direct.largest;
    Sizes                    result{};
    const auto               compare = [&](const unsigned int i,
                             const Field::Block field,
                             const Vector      &a,
                             const Vector      &b) {
      if (scale[i] > 0.)
        raise(result[i], spaces.difference(field, a, b, scale[i]));
    };
    compare(0, Field::temperature, x.temperature, y.temperature);
    compare(1, Field::displacement, x.displacement, y.displacement);
    compare(2, Field::displacement, x.velocity, y.velocity);
    for (unsigned int i = 0; i < x.contact_pressure.size(); ++i)
      if (scale[3] > 0.)
        raise(result[3],
              std::abs(x.contact_pressure[i] - y.contact_pressure[i]) /
                scale[3]);
    return result;
  }



  struct Counts
  {
    unsigned int n_scenes = 0, n_agree = 0, n_explained = 0, n_contact = 0;
  };



  template <int dim>
  void
  judge(const TestScene &scene, Counts &counts)
  {
    const Run<dim>     direct(scene, "direct"), iterative(scene, "iterative");
    std::ostringstream verdict;
    ++counts.n_scenes;
    counts.n_contact += direct.has_contact;
    if (!iterative.message.empty())
      {
        const bool is_explained =
          iterative.message.find("Solver/Linear solver = ") !=
            std::string::npos ||
          iterative.message == direct.message;
        counts.n_explained += is_explained;
        verdict << (is_explained ? "explained" : "FAILS") << ": "
                << iterative.message;
      }
    else if (!direct.message.empty())
      verdict << "FAILS with the direct solver alone: " << direct.message;
    else
      {
        const Sizes sizes  = differences(direct, iterative);
        bool        agrees = true;
        for (unsigned int i = 0; i < sizes.size(); ++i)
          agrees = agrees && sizes[i] <= bounds[i];
        counts.n_agree += agrees;
        verdict << (agrees ? "agrees" : "DIFFERS");
        for (const double size : sizes)
          verdict << ' ' << size;
        verdict << ", iterations "
                << iterative.simulation->counters().max_linear_iterations;
      }
    const bool is_fault = verdict.str()[0] == 'F' || verdict.str()[0] == 'D';
    if (!is_fault && !from_environment("EXTREMES_VERBOSE", 0))
      return;
    std::cout << scene.name << ' ' << verdict.str() << ", contact "
              << direct.has_contact;
    for (const std::string &o : scene.overrides)
      std::cout << " --set '" << o << "'";
    std::cout << std::endl;
  }
} // namespace



int
main(int argc, char **argv)
{
  dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  initlog();
  const unsigned int n     = from_environment("EXTREMES_BODIES", 20);
  const unsigned int seed  = from_environment("EXTREMES_SEED", 1);
  const unsigned int first = from_environment("EXTREMES_FIRST", 0);
  Counts             counts;
  for (unsigned int i = 0; i < n; ++i)
    {
      const TestScene scene = RandomBody(seed, first + i).draw();
      if (scene.overrides.front() == "Dimension=3")
        judge<3>(scene, counts);
      else
        judge<2>(scene, counts);
    }
  std::cout << counts.n_scenes << " bodies, " << counts.n_contact
            << " with contact: " << counts.n_agree << " agree, "
            << counts.n_explained << " explained" << std::endl;
  const bool is_good = counts.n_agree + counts.n_explained == counts.n_scenes &&
                       10 * counts.n_explained <= counts.n_scenes;
  deallog << "direct and iterative solver: every body agrees or is explained, "
          << "at most one in ten explained " << is_good << ", many in contact "
          << (3 * counts.n_contact >= counts.n_scenes) << std::endl;
  return !is_good;
}
