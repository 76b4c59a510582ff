// SPDX-License-Identifier: LGPL-2.1-or-later
//
// Random bodies in two and three dimensions (random_body.h): Poisson ratios
// from -0.5 to 0.499, cells with sides in ratios of 1 to 20, compliances from
// 1e-12 to 1e6 and rigid obstacles, no inertia, no viscosity, steps from 1e-9
// to 1e3. Each runs four steps with the direct and with the iterative solver of
// stages, at Linear tolerance = 1e-10. Either
//
//   agrees      temperatures, displacements, velocities and pressures at the
//               end are the same to 1e-6 of the largest values of the run: the
//               tolerance bounds residuals, and an error is larger by the
//               condition of the matrix with unit diagonal, 1e3 to 1e5 here,
//               if it is of the smoothest kind. Two bounds are larger. Bodies
//               without mass and viscosity, and contact nodes without them,
//               have velocities that are differences of displacements over a
//               stage: what rounding makes of them (rounding_of_velocity.h),
//               and, in a last step that is shorter than those before, what
//               the tolerance has left of their displacements, 1e3 times the
//               tolerance of u in a unit of time and of u at most, over that
//               step. Nothing but inertia holds a body with free sides whose
//               end slides: what is left of its momentum, the tolerance times
//               the largest velocity, displaces it by that times the time;
//   explained   the iterative solver ends the run, or refuses the scene, with a
//               message that names the remedy Solver/Linear solver = direct (or
//               automatic).
//
// In the suite at most one in ten may be explained; scripts/extremes runs as
// many as one wants. The environment is that of campaign.cc. Four bodies of
// seed 1 are always among them, whose velocities come out of equilibrium: 72 is
// at rest, 64, 140 and 177 have steps below 1e-8.

#include <thermocontact/base/exceptions.h>
#include <thermocontact/base/text.h>
#include <thermocontact/simulation/simulation.h>

#include <deal.II/base/mpi.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <iostream>
#include <limits>
#include <memory>

#include "../matched_spaces.h"
#include "../rounding_of_velocity.h"
#include "random_body.h"

using namespace ThermoContact;

namespace
{
  using ThermoContact::Vector;

  /** Temperature, displacement, velocity, pressure. */
  using Sizes = std::array<double, 4>;

  constexpr double relative_bound = 1e-6;
  constexpr double tolerance      = 1e-10;

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
    double shortest_step = std::numeric_limits<double>::max();
    double longest_step  = 0.;

    Run(const TestScene &scene, const std::string &solver)
    {
      Overrides overrides = scene.overrides;
      overrides.push_back("Solver/Linear solver=" + solver);
      if (solver == "iterative")
        overrides.push_back("Solver/Linear tolerance=" + text(tolerance));
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
      if (state.time == 0.)
        return;
      shortest_step = std::min(shortest_step, s.record().step_size);
      longest_step  = std::max(longest_step, s.record().step_size);
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



  /** Those of the comment at the top, relative to the largest values. */
  template <int dim>
  Sizes
  bounds(const Run<dim> &direct)
  {
    Sizes result;
    result.fill(relative_bound);
    const Scene &scene = direct.simulation->scene();
    const double u = direct.largest[1], v = direct.largest[2];
    if (v == 0. || u == 0.)
      return result;
    if (scene.material.is_static() || scene.contact.is_in_equilibrium())
      {
        const double left = 1e3 * tolerance * std::min(1., direct.longest_step);
        result[2] +=
          (rounding_of_velocity(scene.scheme.name, u, direct.shortest_step) +
           left * u / direct.shortest_step) /
          v;
      }
    if (scene.has_sliding_end && !scene.has_rollers)
      result[1] += tolerance * v * direct.simulation->state().time / u;
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
        const Sizes sizes   = differences(direct, iterative);
        const Sizes allowed = bounds(direct);
        bool        agrees  = true;
        for (unsigned int i = 0; i < sizes.size(); ++i)
          agrees = agrees && sizes[i] <= allowed[i];
        counts.n_agree += agrees;
        verdict << (agrees ? "agrees" : "DIFFERS");
        for (unsigned int i = 0; i < sizes.size(); ++i)
          {
            verdict << ' ' << sizes[i];
            if (allowed[i] > 1.1 * relative_bound)
              verdict << " (of " << allowed[i] << ')';
          }
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
  const auto         run = [&counts](RandomBody &&body) {
    const TestScene scene = body.draw();
    if (scene.overrides.front() == "Dimension=3")
      judge<3>(scene, counts);
    else
      judge<2>(scene, counts);
  };
  for (unsigned int i = 0; i < n; ++i)
    run(RandomBody(seed, first + i));
  for (const unsigned int i : {64, 72, 140, 177})
    if (seed != 1 || i < first || i >= first + n)
      run(RandomBody(1, i));
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
