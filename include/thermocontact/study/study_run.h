// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef thermocontact_study_study_run_h
#define thermocontact_study_study_run_h

#include <thermocontact/base/interruption.h>
#include <thermocontact/base/special_numbers.h>
#include <thermocontact/report/key_results.h>
#include <thermocontact/study/scene_reader.h>
#include <thermocontact/study/shared_spaces.h>
#include <thermocontact/study/study_plan.h>
#include <thermocontact/study/trajectory.h>

#include <map>
#include <string>
#include <vector>

namespace ThermoContact
{
  /** Cost and results of a run of a study. */
  struct StudyRun
  {
    std::string failure; ///< empty: done

    /** By their keys in summary.json: dofs, steps and the like. */
    std::map<std::string, unsigned int> counts;
    std::vector<double> loop_seconds; ///< of each repetition, in order of size
    Trajectory          trajectory;

    /** NaN without a reference. */
    Trajectory::Difference error{nan};

    KeyResults               key_results; ///< none of a run that failed
    std::vector<std::string> warnings;    ///< also of a run that failed

    /** Of its scene, which may have another rod than others of the study. */
    ScalesParameters scales;
  };



  /**
   * Runs scenes of a study, one after the other, on this rank alone, and keeps
   * what the next one shares with them.
   */
  class StudyRunner
  {
  public:
    /**
     * Both are borrowed.
     *
     * @param signals a signal ends the run
     */
    StudyRunner(const StudyPlan &plan, const SignalWatch &signals)
      : plan(plan)
      , signals(signals)
      , reader(plan.assignments)
    {}

    /**
     * Runs the scene with @p overrides.
     *
     * @param n_repetitions of the same run, for its time
     * @param directory where the run leaves all its files; empty: it leaves
     *   none
     * @return cost and results; a run that cannot be made or fails says so there
     * @throw Interruption if a signal has come
     */
    StudyRun
    execute(const Overrides   &overrides,
            const unsigned int n_repetitions,
            const std::string &directory);

  private:
    const StudyPlan   &plan;
    const SignalWatch &signals;
    SceneReader        reader;
    SharedSpaces       spaces;
  };
} // namespace ThermoContact

#endif
