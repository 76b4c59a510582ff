// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef thermocontact_method_damped_contact_h
#define thermocontact_method_damped_contact_h

#include <thermocontact/method/contact_law.h>

#include <deal.II/lac/full_matrix.h>

#include <vector>

namespace ThermoContact
{
  /**
   * Where contact nodes are and how they move as their velocities v at the end
   * of a stage have it: penetrations $s=\tilde s+\tau v$.
   */
  struct NodesInMotion
  {
    /** Stage length; 0: the penetrations are $\tilde s$ whatever v. */
    double tau = 0.;

    std::vector<double> start;         ///< $\tilde s$
    std::vector<double> free_velocity; ///< v without contact

    /** Nodes that stay closed, with pressures of either sign; empty: none. */
    std::vector<bool> is_held = {};

    /**
     * Penetrations $\tilde s_2$ at a second stop on the other side, where the
     * velocity is $-v$ and the pressure negative; empty: there is none.
     */
    std::vector<double> far_start = {};
  };



  /**
   * Contact with a damped obstacle, whose pressure $\varphi(s)[1+cv]_+$ grows
   * with the velocity of a node and with the penetration that it leads to,
   * doc/model.md (M.83), (M.84). The unknowns are the velocities: as
   * differences of penetrations they would lose digits in short stages. A node
   * that is held continues with $-\varphi(-s)[1+cv_0]_+$, where $v_0$ is its
   * velocity at $s=0$. No mesh, no communication.
   */
  class DampedContact
  {
  public:
    /** The law, with damping, is borrowed. */
    explicit DampedContact(const ContactLaw &law);

    /**
     * Computes the pressures.
     *
     * @param response loss of velocity of node i per unit pressure at node j
     * @param pressure in: of a nearby problem, which starts the search; out:
     *   one value per node
     * @return number of iterations
     * @throw ComputationError as solve_nodal_contact()
     */
    unsigned int
    solve(const dealii::FullMatrix<double> &response,
          const NodesInMotion              &nodes,
          std::vector<double>              &pressure) const;

    /** $dp/dv$ of node @p i at the velocity @p v. */
    double
    stiffness(const NodesInMotion &nodes,
              const unsigned int   i,
              const double         v) const;

  private:
    const ContactLaw &law;
  };
} // namespace ThermoContact

#endif
