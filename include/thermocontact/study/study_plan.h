// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef thermocontact_study_study_plan_h
#define thermocontact_study_study_plan_h

#include <thermocontact/scene/scene.h>
#include <thermocontact/study/scene_reader.h>

#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace ThermoContact
{
  /**
   * The runs of a study, numbered from 0: all combinations of the values of
   * Study/Vary, set after set, the last axis of a set varying fastest. Entries
   * that go together are one axis. Runs are counted, not built.
   */
  class StudyPlan
  {
  public:
    /** More are most likely a misprint, and weeks. */
    static constexpr unsigned int max_runs = 100000;

    /**
     * Reads the notation and checks each entry and each value by itself, so
     * that a misprint is an error of the study and no failed run.
     *
     * @param assignments of the parameter file and the command line
     * @throw InputError on a notation that cannot be read, an unknown entry, a
     *   value that does not fit, an entry of section Study or Output/Directory,
     *   too many runs, a reference that cannot run or ends before a run does
     */
    StudyPlan(const std::vector<Assignment> &assignments,
              const StudyParameters         &parameters);

    unsigned int
    n_runs() const
    {
      return first_runs.back();
    }

    /** Number of the set that @p run belongs to, from 0. */
    unsigned int
    set_of(const unsigned int run) const;

    /** Entries that @p run overrides in the scene, in the order of Study/Vary. */
    Overrides
    overrides(const unsigned int run) const;

    /** "run 3: Contact/Gap = 0.1, Mesh/Cells = 4" */
    std::string
    description(const unsigned int run) const;

    /** Values of the entries varied in @p run. */
    std::vector<std::string>
    entries(const unsigned int run) const;

    /** Of the scene that the runs override: the input of read_scene(). */
    const std::vector<Assignment> assignments;

    /** An entry and the values that it is to have, one after the other. */
    struct Variation
    {
      std::string              path;
      std::vector<std::string> values;
    };

    /** Entries that vary together: as many values of each. */
    using Axis = std::vector<Variation>;

    const std::vector<std::vector<Axis>> sets;

    /** Paths of all entries that are varied, in the order of their names'
     * first use. */
    const std::vector<std::string> varied;

    /** Entries that the reference overrides; none: there is no reference. */
    const std::optional<Overrides> reference;

    /**
     * Reads and checks the scene with @p overrides.
     *
     * @param reader of the assignments; it has the entries then
     * @throw InputError if an entry is overridden twice or without effect, or
     *   the scene cannot be run
     */
    std::unique_ptr<const Scene>
    read_scene(const Overrides &overrides, SceneReader &reader) const;

  private:
    std::vector<unsigned int> first_runs;   ///< of the sets; at last their end
    std::vector<std::string>  own_values;   ///< the scene's, of those varied
    double                    longest = 0.; ///< largest Time/End time

    /** Each value by itself. */
    void
    check_values();

    /** @throw InputError if it cannot run, or ends before the longest run */
    void
    check_reference() const;
  };
} // namespace ThermoContact

#endif
