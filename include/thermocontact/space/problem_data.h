// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef thermocontact_space_problem_data_h
#define thermocontact_space_problem_data_h

#include <thermocontact/base/types.h>
#include <thermocontact/scene/spatial_scene.h>
#include <thermocontact/space/expression_function.h>

#include <deal.II/base/function.h>

#include <memory>

namespace ThermoContact
{
  /**
   * $g$ of the undeformed body at the places of its contact end, doc/model.md
   * (M1.4); its time is 0.
   */
  template <int dim>
  std::unique_ptr<Function<dim>>
  contact_gap(const SpatialScene &scene);



  /**
   * The functions of a scene, read from its expressions: initial values and
   * sources. A source whose expression is 0 is absent, so that nothing is
   * integrated for it.
   */
  template <int dim>
  class ProblemData
  {
  public:
    /**
     * Reads and evaluates every expression once.
     *
     * @throw InputError naming entry and expression if one cannot be read,
     *   has the wrong number of components, or is not finite at a sample of
     *   points at $t=0$
     */
    explicit ProblemData(const Scene &scene);

    /**
     * Initial values $(\theta_0, u_0)$ of the fields that the scene has, with
     * the components of its FESystem. A displacement that has to be computed,
     * $b=\zeta=0$, is 0 here.
     */
    const Function<dim> &
    initial_fields() const;

    /** $(0, u_1)$ likewise; 0 without inertia. */
    const Function<dim> &
    initial_velocity() const;

    /** Heat source $q$, or nullptr. */
    const ExpressionFunction<dim> *
    heat_source() const;

    /** Body force $f$, dim components, or nullptr. */
    const ExpressionFunction<dim> *
    body_force() const;

    /** End traction $t$, or nullptr. */
    const ExpressionFunction<dim> *
    end_traction() const;

    /** End heat flux $h$, or nullptr. */
    const ExpressionFunction<dim> *
    end_heat_flux() const;

    /**
     * By how much the obstacle is warmer than SceneHeat::obstacle_temperature;
     * or nullptr if its temperature does not vary.
     */
    const ExpressionFunction<dim> *
    obstacle_warming() const;

    /** True if any source is present. */
    bool
    has_sources() const;

    /**
     * Nothing depends on the coordinates across the axis, and no vector has
     * components across.
     */
    bool
    is_along_axis() const;

    /** Sets the time at which the sources are evaluated. */
    void
    set_time(const double time);

  private:
    std::unique_ptr<ExpressionFunction<dim>> initial_fields_;
    std::unique_ptr<ExpressionFunction<dim>> initial_velocity_;
    std::unique_ptr<ExpressionFunction<dim>> heat_source_;
    std::unique_ptr<ExpressionFunction<dim>> body_force_;
    std::unique_ptr<ExpressionFunction<dim>> end_traction_;
    std::unique_ptr<ExpressionFunction<dim>> end_heat_flux_;
    std::unique_ptr<ExpressionFunction<dim>> obstacle_warming_;
  };
} // namespace ThermoContact

#endif
