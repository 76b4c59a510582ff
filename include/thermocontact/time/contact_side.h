// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef thermocontact_time_contact_side_h
#define thermocontact_time_contact_side_h

#include <thermocontact/space/body.h>

#include <vector>

namespace ThermoContact
{
  /** The waves in the middle of a cell near a contact. */
  struct CellValues
  {
    double velocity    = 0.;
    double strain      = 0.; ///< with the viscous part of the stress
    double temperature = 0.;
  };



  /**
   * A body at a contact as the waves in it see it: the end of a rod, or a rigid
   * mass, which has no cells. Displacements and velocities are positive into
   * the contact, so that the contact has the sum of its sides.
   */
  struct ContactSide
  {
    double       sign;   ///< of motions along x into the contact
    unsigned int node;   ///< its place in a vector of displacements
    int          inward; ///< from there to the next node; 0: a mass
    unsigned int n_cells;
    double       cell_size;
    double       impedance;      ///< $A\sqrt{b\rho E}$; of a mass 0
    double       stiffness;      ///< $AE$
    double       viscosity;      ///< $\zeta$
    double       thermal_stress; ///< $Aa$

    bool
    is_mass() const
    {
      return inward == 0;
    }

    /** The node @p cell cells from the contact. */
    unsigned int
    node_behind(const unsigned int cell) const
    {
      return node + inward * static_cast<int>(cell);
    }

    /** At the contact. */
    double
    value(const Vector &vector) const
    {
      return sign * vector.begin()[node];
    }

    /** At its neighbour. */
    double
    inner_value(const Vector &vector) const
    {
      return sign * vector.begin()[node_behind(1)];
    }

    /** In the middle of a cell, of a scalar. */
    double
    middle(const Vector &vector, const unsigned int cell) const
    {
      return 0.5 * (vector.begin()[node_behind(cell)] +
                    vector.begin()[node_behind(cell + 1)]);
    }

    /** The derivative in x in a cell. */
    double
    difference(const Vector &vector, const unsigned int cell) const
    {
      return sign *
             (vector.begin()[node_behind(cell)] -
              vector.begin()[node_behind(cell + 1)]) /
             cell_size;
    }

    /** Without the stress of viscosity. */
    CellValues
    values_in(const State &state, const unsigned int cell) const
    {
      CellValues values;
      values.velocity = sign * middle(state.velocity, cell);
      values.strain   = difference(state.displacement, cell);
      if (state.temperature.size() > 0)
        values.temperature = middle(state.temperature, cell);
      return values;
    }

    /** Waves pass its cells, which viscosity does not smooth. */
    bool
    has_waves() const
    {
      return viscosity * stiffness < impedance * cell_size;
    }
  };



  /** The one or two bodies at each contact, from the left. */
  std::vector<std::vector<ContactSide>>
  contact_sides(const Body<1> &body);
} // namespace ThermoContact

#endif
