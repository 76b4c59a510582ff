// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef thermocontact_simulation_mesh_samples_h
#define thermocontact_simulation_mesh_samples_h

namespace ThermoContact
{
  /**
   * Which steps of a run the mesh is looked at in. Chosen steps: all. Steps of
   * one size, which are many and resolve nothing that lasts less than several:
   * of the first n, one in n/64, but one in 8 at least; besides all in which
   * contact begins or ends, and the 8 that follow them.
   */
  class MeshSamples
  {
  public:
    explicit MeshSamples(const bool takes_all);

    /** Takes the next step; whether it is to be looked at. */
    bool
    take(const double step_size, const bool is_in_contact);

    /** Of the step that was taken last, whether contact began or ended. */
    bool
    is_at_event() const;

    /** The time of the steps passed by since the last that was looked at. */
    double
    skipped_time() const;

    /** The same of the steps before a step that is looked at; 0 from then on.
     */
    double
    take_skipped_time();

    template <class Archive>
    void
    serialize(Archive &archive, const unsigned int)
    {
      archive &n_steps &n_skipped &n_since_event &time_skipped &in_contact;
    }

  private:
    bool         takes_all;
    unsigned int n_steps       = 0;
    unsigned int n_skipped     = 0;
    unsigned int n_since_event = 0;
    double       time_skipped  = 0.;
    bool         in_contact    = false;
  };
} // namespace ThermoContact

#endif
