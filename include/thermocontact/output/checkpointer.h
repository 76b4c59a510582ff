// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef thermocontact_output_checkpointer_h
#define thermocontact_output_checkpointer_h

#include <thermocontact/base/interruption.h>
#include <thermocontact/output/output.h>

#include <deal.II/base/timer.h>

#include <map>
#include <string>

namespace ThermoContact
{
  /**
   * Writes checkpoints: at the start, after each interval of wall-clock time
   * and at the end, and when a signal asks the run to end. An observer of a
   * Simulation, to be called after its Output.
   */
  template <int dim>
  class Checkpointer
  {
  public:
    /**
     * @param directory of the run
     * @param parameters path and value of every parameter
     * @param simulation Output/Checkpoint interval 0: only when it is to end
     * @param output borrowed
     */
    Checkpointer(const std::string                        &directory,
                 const std::map<std::string, std::string> &parameters,
                 const Simulation<dim>                    &simulation,
                 Output<dim>                              &output);

    /**
     * Writes a checkpoint if one is due. Collective.
     *
     * @throw ComputationError naming the file that cannot be written
     * @throw Interruption after a signal
     */
    void
    observe(const Simulation<dim> &simulation);

    /** The same, if a signal has come; else nothing. Collective. */
    void
    observe_signal(const Simulation<dim> &simulation);

    /** Seconds spent in checkpoints. */
    double
    seconds() const
    {
      return timer.wall_time();
    }

  private:
    const std::string                        directory;
    const std::map<std::string, std::string> parameters;
    const double                             interval; ///< seconds
    const double                             end_time;
    Output<dim>                             &output;
    const MPI_Comm                           communicator;
    const SignalWatch                        signals;
    Timer                                    timer;
    Timer                                    since_last;

    /** The largest number that any rank has. */
    int
    common(const int number) const;

    /** As rank 0 sees the time. */
    bool
    is_due(const StepRecord &record) const;
  };
} // namespace ThermoContact

#endif
