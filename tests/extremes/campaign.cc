// SPDX-License-Identifier: LGPL-2.1-or-later
//
// Scenes at the ends of every parameter and in their corners (table.h), and
// scenes drawn at random (random_scene.h). Each must run to its end (or for as
// many steps as are wanted), but those of the table that are to be refused,
// with a message that names the entry. What must hold in each run, at the
// initial state and at the end of every step (checks.h):
//
//   finite         all columns of contact.csv.
//   laws           pressures of damped obstacles are those of (M4.2),
//                  coefficients of the heat exchange those of (C5.2), at
//                  penetrations and velocities that are known to rounding.
//   contact        p >= 0, g - u_n + eps p >= 0, and = 0 where p > 0, at every
//                  contact node: (M1.4), (M1.5), which stiffly accurate schemes
//                  satisfy at the end of a step. 1e-12 of the largest term is
//                  rounding, more where cells are flat; a miss of an event by s
//                  is no violation, because the step that makes it ends with p
//                  = s/eps.
//   energy         without loads it changes by the physical dissipation alone
//                  in a step of energy conserving (section 13), and does not
//                  grow in one of backward Euler (D4.1), nor in one of the
//                  other schemes in which no stage asked for the state of
//                  contact: then the step is linear, and an A-stable scheme
//                  does not increase the norm of a dissipative linear system
//                  (von Neumann 1951), here the energy relative to its minimum.
//                  1e-12 of the absolute terms is rounding, as in
//                  tests/verification/energy_decay.cc, and what EnergyRounding
//                  derives for fine meshes.
//   audit          energy(0) + work = energy + dissipation + that of the
//   obstacle
//                  + numerical dissipation. Backward Euler computes each of
//                  them by a formula of its own (D4.1)-(D4.4).
//   events         begin and end take turns.
//
// And of whole runs (variations.h), those of the table one of the first two:
//   scaling        (M1.1)-(M1.5) are positively homogeneous in initial values,
//                  theta_A, theta_obs, g and loads, and the program has no
//                  absolute threshold. The factors are the powers of two next
//                  to 1e-100, 1e-8, 1e8, 1e100, which rounding cannot tell from
//                  1: so even chaotic scenes must agree, to 1e-13; those of
//                  power laws, whose powers are rounded, to 1e-6, but not
//                  where they are below the smallest normal number, nor if
//                  values that differ by the rounding of powers make as much of
//                  a difference. epsilon scales like g^(1-1/m), the damping
//                  like 1/g, gap and pressure in a heat exchange do not scale.
//   sign           a and theta change sign together: the same u.
//   period         of random scenes: Output/Period at whose multiples steps end
//   anyway, or that is
//                  longer than the run, changes nothing.
//   steady state   (M3.1), (M5.6) to 1e-9, after T = 1e6 or 20 steps of 1e6;
//   after one
//                  such step to what the tableau leaves of the slowest mode.
//   warnings       a preload and a corner layer are announced.
//
// In the suite 40 random scenes run; scripts/extremes runs as many as one
// wants. The environment says so: EXTREMES_SCENES, EXTREMES_SEED,
// EXTREMES_FIRST (index of the first), EXTREMES_LAWS (0: the scenes of
// random_scene.h as they are, 1: with laws and drives), EXTREMES_VERBOSE (a
// line for each scene).

#include <deal.II/base/mpi.h>

#include <chrono>
#include <cstdlib>
#include <iostream>

#include "random_laws.h"
#include "random_scene.h"
#include "table.h"
#include "variations.h"

using namespace ThermoContact;

namespace
{
  /** What became of a scene; no faults: it passes. */
  struct Verdict
  {
    std::string faults;
    bool        is_refused  = false;
    bool        is_stopped  = false;
    bool        has_contact = false;
    double      growth      = 0.;
    double      variation   = 0.; ///< largest of scaling and sign

    void
    add(const std::string &fault, const double value)
    {
      std::ostringstream text;
      text << "    " << fault << " (" << value << ")\n";
      faults += text.str();
    }

    void
    add(const std::string &fault, const std::string &detail)
    {
      faults += "    " + fault + ": " + detail + "\n";
    }
  };



  unsigned int
  from_environment(const char *name, const unsigned int value)
  {
    const char *text = std::getenv(name);
    return text && *text ? std::stoul(text) : value;
  }



  /** As options of the program. */
  std::string
  options(const TestScene &scene)
  {
    std::string text;
    for (const std::string &o : scene.overrides)
      text += " --set '" + o + "'";
    return text;
  }



  bool
  contains(const std::vector<std::string> &texts, const std::string &part)
  {
    return std::any_of(texts.begin(), texts.end(), [&](const std::string &t) {
      return t.find(part) != std::string::npos;
    });
  }



  /** Of variations that rounding cannot tell from the scene. */
  constexpr double exact = 1e-13;



  /**
   * One that no step has to end at: the third of fixed steps, or beyond the
   * run. 0 if the scene has one.
   */
  double
  harmless_period(const Parameters &parameters)
  {
    const TimeParameters &time = parameters.time;
    return parameters.output.period > 0. ? 0. :
           time.step_size                ? 3. * *time.step_size :
                                           2. * time.end_time;
  }



  /**
   * Values that differ by what powers are rounded, 1e-100^(1-1/m) by 1e-14,
   * make another run of it.
   */
  bool
  is_chaotic(const Parameters  &parameters,
             const unsigned int max_steps,
             const RunResult   &run,
             const double       allowed)
  {
    const double    nearly_one = 1. + std::ldexp(1., -46);
    const RunResult result =
      run_scene(scaled(parameters, nearly_one, nearly_one), max_steps);
    return !(difference(run, result, 1., 1., parameters.time.end_time, false) <=
             allowed);
  }



  void
  vary(const TestScene  &scene,
       const Parameters &parameters,
       const RunResult  &run,
       const double      factor,
       Verdict          &verdict)
  {
    const auto compare = [&](const std::string &what,
                             const Parameters  &varied,
                             const double       thermal,
                             const double       mechanical,
                             const double       allowed) {
      const RunResult result = run_scene(varied, scene.max_steps);
      const double    value  = difference(run,
                                      result,
                                      thermal,
                                      mechanical,
                                      parameters.time.end_time,
                                      allowed == exact);
      if (mechanical > 0. && mechanical != 1. &&
          (run.has_underflow || result.has_underflow))
        return;
      if (!(value <= allowed) && allowed > exact &&
          is_chaotic(parameters, scene.max_steps, run, allowed))
        return;
      if (allowed == exact)
        raise(verdict.variation, value);
      if (!(value <= allowed))
        verdict.add(what, value);
    };
    std::ostringstream name;
    name << "scaling by " << factor;
    const bool has_powers = parameters.contact.condition == "power law" &&
                            parameters.contact.exponent != 1.;
    if (scene.variations != TestScene::sign_alone)
      compare(name.str(),
              scaled(parameters, factor, factor),
              factor,
              factor,
              has_powers ? 1e-6 : exact);

    Parameters mirrored = scaled(parameters, -1., 1.);
    mirrored.model.coupling *= -1.;
    if (scene.variations != TestScene::scaling_alone)
      compare("sign of a and theta", mirrored, -1., 1., exact);
    if (const double period = harmless_period(parameters);
        period > 0. && scene.variations == TestScene::all)
      {
        Parameters other    = parameters;
        other.output.period = period;
        compare("Output/Period", other, 1., 1., exact);
      }
  }



  // of the table's scenes, b = 1: pi/2 is the lowest frequency of the rod with
  // a free end, contact raises it; the heat equation has pi^2/4 or more
  const double slowest_rate = 1.57;



  /** To rounding, but for what a single long step leaves of the slowest mode.
   */
  void
  check_steady_state(const Parameters &parameters,
                     const RunResult  &run,
                     Verdict          &verdict)
  {
    double tolerance = 1e-9;
    if (run.last.step == 1)
      tolerance += 2. * remainder_of_one_step(parameters.time.scheme,
                                              slowest_rate,
                                              run.last.step_size);
    const double distance = distance_from_steady_state(run, parameters);
    if (!(distance <= tolerance))
      verdict.add("distance from the steady state", distance);
  }



  void
  judge_run(const TestScene &scene, const double factor, Verdict &verdict)
  {
    const Parameters parameters = read_parameters("", scene.overrides);
    const RunResult  run        = run_scene(parameters, scene.max_steps);
    for (const auto &[what, value] : run.failures)
      verdict.add(what, value);
    verdict.has_contact = run.has_contact;
    verdict.growth      = run.growth;
    verdict.is_stopped  = run.status == RunResult::stopped;
    if (verdict.is_stopped)
      verdict.add("stops", run.message);
    if (scene.expectation == TestScene::warns &&
        !contains(run.warnings, scene.message))
      verdict.add("does not warn of", scene.message);
    if (scene.ends_steady)
      check_steady_state(parameters, run, verdict);
    vary(scene, parameters, run, factor, verdict);
  }



  Verdict
  judge(const TestScene &scene, const double factor)
  {
    Verdict verdict;
    try
      {
        judge_run(scene, factor, verdict);
        if (scene.expectation == TestScene::refused)
          verdict.add("is not refused", "");
      }
    catch (const InputError &error)
      {
        verdict.is_refused = true;
        if (scene.expectation != TestScene::refused)
          verdict.add("is refused", error.what());
        else if (std::string(error.what()).find(scene.message) ==
                 std::string::npos)
          verdict.add("is refused without the words " + scene.message,
                      error.what());
        else if (std::string(error.what()).find("\n  allowed: ") ==
                   std::string::npos &&
                 std::string(error.what()).find("\n  remedy:  ") ==
                   std::string::npos)
          verdict.add("is refused without allowed values or remedy",
                      error.what());
      }
    catch (const std::exception &error)
      {
        verdict.add("throws", error.what());
      }
    return verdict;
  }



  struct Summary
  {
    unsigned int n_scenes = 0, n_passed = 0, n_refused = 0, n_stopped = 0,
                 n_with_contact = 0;
  };



  void
  run_scenes(const std::vector<TestScene> &scenes,
             const unsigned int            first,
             Summary                      &summary)
  {
    const std::vector<int> exponents  = {-332, -27, 27, 332};
    const bool             is_verbose = from_environment("EXTREMES_VERBOSE", 0);
    for (unsigned int i = 0; i < scenes.size(); ++i)
      {
        const auto    begin   = std::chrono::steady_clock::now();
        const double  factor  = std::ldexp(1., exponents[(first + i) % 4]);
        const Verdict verdict = judge(scenes[i], factor);
        const bool    passes  = verdict.faults.empty();
        ++summary.n_scenes;
        summary.n_passed += passes;
        summary.n_refused += verdict.is_refused;
        summary.n_stopped += verdict.is_stopped;
        summary.n_with_contact += verdict.has_contact;
        if (!passes)
          deallog << scenes[i].name << " fails\n"
                  << verdict.faults << "   " << options(scenes[i]) << std::endl;
        if (is_verbose)
          std::cout << (passes ? "pass " : "FAIL ") << scenes[i].name
                    << ": contact " << verdict.has_contact << ", refused "
                    << verdict.is_refused << ", stopped " << verdict.is_stopped
                    << ", growth " << verdict.growth << ", variation "
                    << verdict.variation << ", seconds "
                    << std::chrono::duration<double>(
                         std::chrono::steady_clock::now() - begin)
                         .count()
                    << options(scenes[i]) << std::endl;
      }
  }
} // namespace



int
main(int argc, char **argv)
{
  Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  initlog();
  const unsigned int n_random = from_environment("EXTREMES_SCENES", 40);
  const unsigned int seed     = from_environment("EXTREMES_SEED", 1);
  const unsigned int first    = from_environment("EXTREMES_FIRST", 0);
  const bool         has_laws = from_environment("EXTREMES_LAWS", 1);

  Summary table;
  if (!from_environment("EXTREMES_NO_TABLE", 0))
    run_scenes(table_scenes(), 0, table);
  deallog << "table: " << table.n_passed << " of " << table.n_scenes
          << " scenes pass, " << table.n_refused << " of them by being refused"
          << std::endl;

  Summary random;
  for (unsigned int i = first; i < first + n_random; ++i)
    run_scenes({has_laws ? RandomLaws(seed, i).draw() :
                           RandomScene(seed, i).draw()},
               i,
               random);
  deallog << "random, seed " << seed << ": " << random.n_passed << " of "
          << random.n_scenes << " scenes pass" << std::endl;
  std::cout << "random: " << random.n_with_contact << " with contact, "
            << random.n_stopped << " stopped, " << random.n_refused
            << " refused" << std::endl;
  return table.n_passed < table.n_scenes || random.n_passed < random.n_scenes;
}
