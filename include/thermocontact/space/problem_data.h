// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef thermocontact_space_problem_data_h
#define thermocontact_space_problem_data_h

#include <thermocontact/base/types.h>
#include <thermocontact/scene/scene.h>
#include <thermocontact/space/expression_function.h>

#include <memory>
#include <vector>

namespace ThermoContact
{
  /**
   * $g$ of the undeformed body at the places of its contact end, doc/model.md
   * (M1.4); its time is 0.
   */
  template <int dim>
  std::unique_ptr<Function<dim>>
  contact_gap(const Scene &scene);



  /**
   * The functions of a scene, read from its expressions: initial values and
   * sources. A source whose expression is 0 is absent, so that nothing is
   * integrated for it.
   */
  template <int dim>
  struct ProblemData
  {
    /**
     * Reads and evaluates every expression once.
     *
     * @throw InputError naming entry and expression if one cannot be read,
     *   has the wrong number of components, or is not finite at a sample of
     *   points at $t=0$
     */
    explicit ProblemData(const Scene &scene);

    using Data = std::unique_ptr<ExpressionFunction<dim>>;

    /**
     * Initial values $(\theta_0, u_0)$ of the fields that the scene has, with
     * the components of its FESystem. A displacement that has to be computed,
     * $b=\zeta=0$, is 0 here.
     */
    const std::unique_ptr<EnclosedFunction<dim>> initial_fields;

    /** $(0, u_1)$ likewise; 0 without inertia. */
    const std::unique_ptr<EnclosedFunction<dim>> initial_velocity;

    // sources, or null
    const Data heat_source;    ///< $q$
    const Data body_force;     ///< $f$, dim components
    const Data end_traction;   ///< $t$
    const Data end_heat_flux;  ///< $h$
    const Data left_traction;  ///< $t_A$
    const Data left_heat_flux; ///< $h_A$

    /**
     * By how much the obstacle is warmer than SceneHeat::obstacle_temperature;
     * null if its temperature does not vary.
     */
    const Data obstacle_warming;

    /** The sources that there are. */
    const std::vector<ExpressionFunction<dim> *> sources;

    /**
     * Nothing depends on the coordinates across the axis, and no vector has
     * components across.
     */
    bool
    is_along_axis() const;

    /** Sets the time at which the sources are evaluated. */
    void
    set_time(const double time);
  };
} // namespace ThermoContact

#endif
