// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef thermocontact_scene_scene_checks_h
#define thermocontact_scene_scene_checks_h

#include <thermocontact/input/parameter_text.h>
#include <thermocontact/scene/scene.h>

#include <set>
#include <string>
#include <vector>

namespace ThermoContact
{
  /** An entry that a scene cannot use, and the setting that says so. */
  struct UnusedEntry
  {
    std::string path;   ///< "Section/Entry"
    std::string reason; ///< e.g. "Contact/Condition = rigid"
  };



  /** The entries that the scene cannot use. */
  std::vector<UnusedEntry>
  unused_entries(const Scene &scene);

  /** Their paths, which used.prm leaves out. */
  std::set<std::string>
  unused_paths(const Scene &scene);

  /**
   * Refuses values that the scene would ignore.
   *
   * @param prm bound to the parameters of the scene
   * @throw InputError that names all entries of unused_entries() that differ
   *   from their defaults, with their places
   */
  void
  check_unused_entries(const Scene                   &scene,
                       const std::vector<Assignment> &assignments,
                       const ParameterHandler        &prm);

  /**
   * Checks rules that a pattern for one entry cannot have: limits that exclude
   * their bound, combinations, the number of steps and of unknowns.
   *
   * @throw InputError naming section path, value, what is allowed, remedy
   */
  void
  check_scene(const Scene &scene);

  /** The same of the scene of these parameters. */
  void
  check_scene(const Parameters &parameters);

  /**
   * The part of it that asks whether a scheme can treat a contact law.
   *
   * @param law of that kind
   */
  void
  check_scheme_fits_law(const Scheme         &scheme,
                        const ContactLawKind &kind,
                        const ContactLaw     &law);

  /**
   * Error bars are of a run, not of a study; a part of check_scene().
   *
   * @throw InputError
   */
  void
  check_error_bars(const Parameters &parameters);

  /**
   * Checks that Scales are complete, and positive; a part of check_scene().
   *
   * @throw InputError
   */
  void
  check_scales(const Parameters &parameters);

  /** A warning if fixed steps give waves the dispersion that their mass matrix
   * would not have in others, (C6.8); or nothing. */
  std::string
  dispersion_warning(const Scene &scene);

  /** Largest part of a cell by which the shortest waves of the scheme without
   * dispersion stay behind in a step, where a cell is passed in another time; 0
   * of other schemes. */
  double
  delay_by_passages(const Scene &scene);

  /** True if these waves have any dispersion at all in some rod. */
  bool
  has_dispersion(const Scene &scene);

  /** $a^2$ of the rod in which it is largest, by which waves that exchange no
   * heat are stiffer; 0 without this heat. */
  double
  stiffness_by_heat(const Scene &scene);

  /** A warning if error-controlled steps have to follow the oscillations of
   * contact nodes with mass on a hard obstacle, which no forecast knows; or
   * nothing. */
  std::string
  oscillation_warning(const Scene &scene);

  /** A warning if a mass on the contact end meets a rigid obstacle, where it
   * stops without rebound and loses its energy; or nothing. */
  std::string
  impact_warning(const Scene &scene);

  /**
   * A warning of contacts with masses whose forces pass in a few steps, or
   * nothing: those are then of the steps.
   */
  std::string
  resolution_warning(const Scene &scene);
} // namespace ThermoContact

#endif
