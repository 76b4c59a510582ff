// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef thermocontact_study_study_h
#define thermocontact_study_study_h

#include <thermocontact/input/parameter_file.h>
#include <thermocontact/study/trajectory.h>
#include <thermocontact/time/stage_solver.h>

#include <deal.II/base/mpi.h>

#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace ThermoContact
{
  /** One run of a study: what it varies, what it cost, what came out. */
  struct StudyRun
  {
    /** Overrides of the scene. */
    std::vector<std::pair<std::string, std::string>> overrides;

    /** Number of the set of combinations that it belongs to, from 0. */
    unsigned int set = 0;

    /** Values of all entries that the study varies, as the run has them. */
    std::vector<std::string> entries;

    std::string         failure; ///< empty: done
    unsigned int        n_dofs           = 0;
    unsigned int        n_steps          = 0;
    unsigned int        n_rejected_steps = 0;
    unsigned int        n_factorizations = 0;
    unsigned int        n_solves         = 0;
    std::vector<double> loop_seconds; ///< of each repetition, in order of size
    Trajectory          trajectory;
    std::optional<Trajectory::Difference> error; ///< none without reference

    template <typename Archive>
    void
    serialize(Archive &archive, const unsigned int)
    {
      archive &failure &n_dofs &n_steps &n_rejected_steps &n_factorizations
        &n_solves &loop_seconds &trajectory;
    }
  };



  /**
   * Runs a scene many times with varied entries, each run on one rank, and
   * measures each against a reference run. The runs are dealt over the ranks
   * and write no files unless asked to.
   */
  class Study
  {
  public:
    /**
     * Plans the runs. Entry names and values are checked here, so that a
     * misprint is an error of the study and no failed run.
     *
     * @param assignments of the parameter file and the command line
     * @throw InputError on a notation that cannot be read, an unknown entry, a
     *   value that does not fit, an entry of section Study or Output/Directory
     */
    Study(const std::vector<Assignment> &assignments,
          const StudyParameters         &parameters);

    /**
     * Runs all, the reference first. Collective on MPI_COMM_WORLD; afterwards
     * rank 0 has all results.
     *
     * @param directory where single runs leave their files, if they are asked
     *   for, in folders run-0, run-1, ...
     * @throw InputError, ComputationError if the reference run cannot be done
     */
    void
    run(const std::string &directory);

    /** Paths "Section/Entry" of all entries that are varied. */
    const std::vector<std::string> &
    varied() const
    {
      return varied_;
    }

    const std::vector<StudyRun> &
    runs() const
    {
      return runs_;
    }

    const StudyParameters &
    parameters() const
    {
      return parameters_;
    }

  private:
    const std::vector<Assignment> assignments;
    const StudyParameters         parameters_;
    std::vector<std::string>      varied_;
    std::vector<StudyRun>         runs_;
    std::optional<StudyRun>       reference;

    /** @throw InputError if it cannot run, or ends before @p longest */
    void
    check_reference(const double longest) const;

    /** Reads the values of a scene with overrides into @p prm. */
    void
    assign(const StudyRun &run, dealii::ParameterHandler &prm) const;

    /** Runs a scene, once or repeatedly; its failure is set if it fails. */
    void
    execute(StudyRun          &run,
            const unsigned int n_repetitions,
            const std::string &directory) const;
  };
} // namespace ThermoContact

#endif
