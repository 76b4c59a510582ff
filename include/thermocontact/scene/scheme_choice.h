// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef thermocontact_scene_scheme_choice_h
#define thermocontact_scene_scheme_choice_h

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



  /** What becomes of Time/Scheme, Mesh/Cells and Mesh/Degree = automatic. */
  struct SchemeChoice
  {
    Parameters               parameters; ///< none of them is automatic any more
    std::vector<ChosenEntry> entries;    ///< those that were
    std::string              reason;     ///< of the scheme; empty: it was given

    /**
     * Waves have fronts for which the mesh has too few nodes, in a scheme in
     * which these ring.
     */
    bool has_unresolved_fronts = false;

    /** The value of @p path where it was chosen, or nullptr. */
    const std::string *
    find(const std::string &path) const;
  };



  /**
   * Decides them, doc/numerics.md section "Which scheme". Fronts are what an
   * obstacle, a traction that jumps, the jump of the velocity of the fixed end,
   * or initial values that jump send through a body with inertia. Viscosity
   * spreads them over
   * $\sqrt{\zeta/\sqrt b}$ while they pass the body, a linear obstacle over
   * $\varepsilon$; sharp ones have less than Tolerances::nodes_of_front nodes
   * of the automatic mesh in that length. A rod with sharp fronts has the
   * scheme without dispersion, unless an entry is against it or cells times
   * steps are more than Tolerances::most_cell_steps. Its cells are those that
   * the tolerance asks for, its steps those in which a wave passes one. All
   * else has the default scheme.
   *
   * Applied to its own result it changes nothing.
   *
   * @param written entries, perhaps ones that check_scene() refuses
   */
  SchemeChoice
  choose_scheme(const Parameters &written);

  /**
   * True if no wave has kinks on a mesh: there is none, or viscosity spreads
   * them over Tolerances::nodes_of_front nodes.
   */
  bool
  has_smooth_waves(const Parameters &parameters);
} // namespace ThermoContact

#endif
