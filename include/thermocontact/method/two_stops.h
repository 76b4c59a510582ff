// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef thermocontact_method_two_stops_h
#define thermocontact_method_two_stops_h

#include <deal.II/lac/full_matrix.h>

#include <vector>

namespace ThermoContact
{
  /**
   * The stop that a node is nearer to: 1 for the one in front, -1 for the one
   * behind. Nothing else decides between the two.
   *
   * @param front,rear penetrations $u-g$ and $-u-g_2$
   */
  inline int
  nearer_stop(const double front, const double rear)
  {
    return rear > front ? -1 : 1;
  }



  /**
   * Mean pressure of a node that goes from beyond one of two linear stops to
   * beyond the other in a step, which does the work of their potential
   * $([s]_+^2+[s_2]_+^2)/2\varepsilon$: $\bar p=(V(s_1)-V(s_0))/(s_1-s_0)$.
   *
   * @param compliance $\varepsilon$
   * @param start $s_0$
   * @param free_end $s_1+\chi\bar p$
   * @param receptance $\chi\ge0$
   * @param width between the stops
   */
  double
  crossing_pressure(const double compliance,
                    const double start,
                    const double free_end,
                    const double receptance,
                    const double width);



  /**
   * Contact nodes between two stops, each seen from the stop that is nearer to
   * it, doc/model.md (M.107): values of nodes at the rear stop are mirrored, so
   * that a positive one leads into the nearer stop, and a positive pressure is
   * the push of that stop. With one stop nothing is turned. No communication.
   */
  struct NearerStops
  {
    /** Penetrations at the nearer stop. */
    std::vector<double> near;

    /** Those at the other one; empty: there is one stop. */
    std::vector<double> far;

    /**
     * Decides which stop is the nearer one.
     *
     * @pre @p near has the penetrations at the front stop, @p far those at the
     *   rear one
     */
    void
    choose();

    /** False if there is one stop. */
    bool
    are_two() const
    {
      return !far.empty();
    }

    /** 1: the front stop is nearer; -1: the rear one. */
    double
    side(const unsigned int node) const
    {
      return are_two() ? sides[node] : 1.;
    }

    /** Sees a node from the stop @p new_side, 1 or -1, though not the nearer. */
    void
    see_from(const unsigned int node, const int new_side);

    /** Displacements, velocities or pressures become those seen, or back. */
    void
    turn(std::vector<double> &values) const;

    /** What rows of a matrix say of displacements. */
    void
    turn_rows(dealii::FullMatrix<double> &matrix) const;

    /** What columns of a matrix say for pressures. */
    void
    turn_columns(dealii::FullMatrix<double> &matrix) const;

    /** @p matrix with its rows and columns turned. */
    dealii::FullMatrix<double>
    turned(dealii::FullMatrix<double> matrix) const;

    /**
     * Some nodes with velocities in place of penetrations: how they move into
     * their stops. The other ones are out of reach.
     *
     * @param nodes which
     * @param velocity of all nodes
     */
    NearerStops
    in_motion(const std::vector<unsigned int> &nodes,
              const std::vector<double>       &velocity) const;

  private:
    std::vector<double> sides;
  };
} // namespace ThermoContact

#endif
