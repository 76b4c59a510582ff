// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef thermocontact_space_obstacle_motion_h
#define thermocontact_space_obstacle_motion_h

#include <thermocontact/input/time_function.h>
#include <thermocontact/scene/scene.h>
#include <thermocontact/space/contact_end.h>

#include <vector>

namespace ThermoContact
{
  /**
   * Gaps $g(t)$ of the contact nodes, or $g(y,z,t)$ at their places, with their
   * rates; doc/contact-in-time.md section 8. The gaps of an obstacle that
   * stands still never change. Nondimensional; the obstacle goes away from the
   * body where the rate is positive.
   */
  template <int dim>
  class ObstacleMotion
  {
  public:
    /**
     * @param end of the body
     * @throw InputError if a gap is not finite
     */
    ObstacleMotion(const Scene &scene, const ContactEnd<dim> &end);

    /** Of all nodes of the end, undeformed. */
    const std::vector<double> &
    gaps_at_start() const
    {
      return gaps_at_start_;
    }

    /** False: it stands still, and what follows does nothing. */
    bool
    is_active() const
    {
      return !gaps.empty();
    }

    /**
     * Gap and its derivatives at each node.
     *
     * @throw ComputationError if a gap is not finite
     */
    void
    get_derivatives(const double                  time,
                    std::vector<TimeDerivatives> &derivatives) const;

    /**
     * The obstacle of a state is where it is at @p time, with the rates at
     * @p rate_time, the same or at the other side of a jump of the rates there.
     */
    void
    place(const double time, const double rate_time, State &state) const;

    /**
     * The rates of the gaps of a state are those at @p time, which may be
     * behind a jump of the rates at the time of the state.
     */
    void
    set_rates(const double time, State &state) const;

  private:
    const unsigned int  n_nodes;
    const SceneContact &contact;
    std::vector<double> gaps_at_start_;

    /** The gaps between the bodies of a row, whose nodes are the first ones;
     * they stay. */
    std::vector<TimeDerivatives> gaps_of_bodies;

    /** The gaps at all nodes before the obstacle, or the same one; empty if it
     * rests. */
    std::vector<TimeFunction> gaps;

    mutable std::vector<TimeDerivatives> scratch;
  };
} // namespace ThermoContact

#endif
