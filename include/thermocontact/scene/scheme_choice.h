// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef thermocontact_scene_scheme_choice_h
#define thermocontact_scene_scheme_choice_h

#include <thermocontact/contact/contact_law.h>
#include <thermocontact/input/parameters.h>

#include <string>
#include <vector>

namespace ThermoContact
{
  /** An entry that is written as automatic, and the value that it has. */
  struct ChosenEntry
  {
    std::string path, value;
  };



  /** The choice of Time/Scheme, Mesh/Cells and Mesh/Degree = automatic. */
  struct SchemeChoice
  {
    Parameters               parameters; ///< none of them is automatic any more
    std::vector<ChosenEntry> entries;    ///< the entries that were
    std::string              reason;     ///< of the scheme; empty: it was given

    /**
     * Waves have fronts for which the mesh has too few nodes, in a scheme in
     * which these ring.
     */
    bool has_unresolved_fronts = false;

    /** Rods of a row share the cells of section Mesh. */
    bool shares_cells = false;

    /** The value of @p path where it was chosen, or nullptr. */
    const std::string *
    find(const std::string &path) const;
  };



  /**
   * Decides them, doc/numerics.md section "Which scheme". Fronts are sent
   * through a body with inertia by an obstacle, a traction that jumps, the jump
   * of the velocity of the fixed end, or initial values that jump. Viscosity
   * spreads them over $\sqrt{\zeta/\sqrt b}$ while they pass the body, and a
   * linear obstacle makes none shorter than its compliance, or than the wave of
   * a mass that swings on it; sharp ones have less than
   * Tolerances::nodes_of_front nodes of the default mesh in that length. A rod
   * with sharp fronts has the default scheme on a mesh that resolves them, if a
   * stage with it costs no more than a step of the scheme without dispersion in
   * as many cells as the tolerance asks for; else that one, unless an entry is
   * against it or cells times steps are more than Tolerances::most_cell_steps.
   * All else has the default scheme and mesh.
   *
   * Applied to its own result it changes nothing.
   *
   * @param written entries, perhaps ones that check_scene() refuses
   */
  SchemeChoice
  choose_scheme(const Parameters &written);

  /**
   * The automatic cells of the scheme without dispersion, of second order:
   * twice as many as the root of one over the tolerance.
   */
  unsigned int
  cells_of_tolerance(const double tolerance);

  /** True if initial values, a traction or the fixed end of a rod make fronts,
   * without an obstacle. */
  bool
  has_fronts_of_data(const Parameters &parameters);

  /**
   * The viscosity does not damp the oscillations of a contact node with mass
   * between its neighbour and its obstacle, (C1.2): a mass $bw$, $w$ the length
   * of the body that it stands for, on the springs $1/w$ and $1/\varepsilon$
   * with the damper $\zeta/w$, which is critical for
   * $\zeta^2=4bw^2(1+w/\varepsilon)$; without a compliance, as a rigid obstacle
   * throws it back by its neighbours, $\zeta^2<b(h/p)^2$.
   */
  bool
  contact_nodes_oscillate(const Parameters &parameters, const ContactLaw &law);

  /**
   * True if no wave has kinks on a mesh: there is none, or viscosity spreads
   * them over Tolerances::nodes_of_front nodes.
   */
  bool
  has_smooth_waves(const Parameters &parameters);
} // namespace ThermoContact

#endif
