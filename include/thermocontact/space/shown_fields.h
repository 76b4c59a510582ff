// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef thermocontact_space_shown_fields_h
#define thermocontact_space_shown_fields_h

#include <thermocontact/scene/scene.h>
#include <thermocontact/space/discretization.h>
#include <thermocontact/space/nonlinear_terms.h>
#include <thermocontact/space/state.h>

namespace ThermoContact
{
  /**
   * The velocity of a state as a field to look at. With
   * Scene::has_midpoint_mass velocities are those of cells, and nodal values
   * may alternate about them, doc/contact-in-time.md (C6.13): then those of a
   * node are the mean of its cells, at the right end of a rod its own, and at a
   * left end that nothing holds that of its cell.
   *
   * @param memory for the result, if it is not that of the state
   */
  const Vector &
  shown_velocity(const Scene &scene, const State &state, Vector &memory);



  /**
   * The fields of a state to look at, in all cells of a rank, and the stress
   * that belongs to them. Nondimensional.
   */
  template <int dim>
  class ShownFields
  {
  public:
    /** The scene and the discretisation are borrowed. Collective. */
    ShownFields(const Scene               &scene,
                const Discretization<dim> &discretization,
                const State               &state);

    using Cell = typename Discretization<dim>::Cell;

    /** Temperature and displacement. */
    const BlockVector &
    values() const
    {
      return values_;
    }

    /** Temperature, and shown_velocity() in the place of the displacement. */
    const BlockVector &
    velocities() const
    {
      return velocities_;
    }

    /**
     * The stress, (M1.2), (M10.1), (M10.8), over the section there, or a
     * component of it, as of stress_of().
     *
     * @param cell,place,theta where it is, and the temperature there
     * @param thermal,elastic,of_rate arguments of stress_of(), of the
     *   displacement and of the velocity to look at
     * @throw InputError on this rank if a coefficient has a value that is not
     *   allowed
     */
    template <typename Stress>
    Stress
    stress(const Cell       &cell,
           const Point<dim> &place,
           const double      theta,
           const Stress     &thermal,
           const Stress     &elastic,
           const Stress     &of_rate) const
    {
      return stress_of(scene.material,
                       discretization.in_equations(cell, place, theta),
                       thermal,
                       elastic,
                       of_rate) /
             discretization.of_material(cell, place).section;
    }

  private:
    const Scene               &scene;
    const Discretization<dim> &discretization;
    const BlockVector          values_;
    Vector                     memory; ///< of the velocity
    const BlockVector          velocities_;
  };
} // namespace ThermoContact

#endif
