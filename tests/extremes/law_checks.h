// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef thermocontact_extremes_law_checks_h
#define thermocontact_extremes_law_checks_h

#include <thermocontact/simulation/simulation.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "../tests.h"

namespace ThermoContact
{
  /** Largest magnitudes over a run, that differences are measured by. */
  struct Scales
  {
    double displacement      = 0.;
    double velocity          = 0.;
    double gap               = 0.; ///< of the front stop
    double temperature       = 0.;
    double force             = 0.;
    double energy            = 0.; ///< of the absolute terms, work, dissipation
    double mechanical_energy = 0.; ///< kinetic or elastic
  };



  /**
   * By how much a value misses the range of a function of two variables around
   * (@p x, @p y), within @p dx and @p dy: what the values of x and y, which are
   * known to rounding, allow. Relative to 1e-9 of the largest of them.
   */
  template <typename Function>
  double
  miss_of_range(const double    value,
                const double    x,
                const double    dx,
                const double    y,
                const double    dy,
                const Function &function)
  {
    double low = value, high = value;
    bool   is_first = true;
    for (const double i : {-1., -0.5, 0., 0.5, 1.})
      for (const double j : {-1., -0.5, 0., 0.5, 1.})
        {
          const double f = function(x + i * dx, y + j * dy);
          low            = is_first ? f : std::min(low, f);
          high           = is_first ? f : std::max(high, f);
          is_first       = false;
        }
    const double miss = std::max(low - value, value - high);
    const double scale =
      1e-9 * std::max({std::abs(low), std::abs(high), std::abs(value)});
    return miss > 0. && scale > 0. ? miss / scale : 0.;
  }



  /**
   * How flat the cells at the contact end are, at least 1: their stiffness
   * along the body is that many times the one across, which is left with so
   * many digits less.
   */
  inline double
  flatness(const Parameters &parameters)
  {
    const MeshParameters &mesh = parameters.mesh;
    return parameters.dimension == 1 ?
             1. :
             std::max(1.,
                      mesh.width / mesh.cells_across / mesh.contact_spacing());
  }



  /**
   * What the laws of a damped obstacle (M4.2) and of a heat exchange that
   * depends on the contact (C5.2) leave to wish for in the present state, in
   * units of what is allowed. Penetrations are known to 1e-12 of the
   * displacements, velocities to 1e-12 of the largest and to those over the
   * step, of bodies with inertia to 1e-9 of the largest at worst. Pressures are
   * the remainder of the forces at the end, u_x + zeta v_x - a theta and p,
   * (M1.2), where derivatives are those of the cells there, and known to 1e-12
   * of the largest of them, or less if the cells are flat: a pressure that
   * vanishes, as between the sides of a coefficient that jumps with the
   * contact, comes out as their rounding.
   */
  template <int dim>
  std::map<std::string, double>
  misses_of_laws(const Simulation<dim> &simulation, const Scales &scales)
  {
    std::map<std::string, double> misses;
    const Scene                  &scene = simulation.scene();
    const ContactLaw             &law   = *scene.contact.law;
    const State                  &state = simulation.state();
    const bool is_damped                = law.is_active() && law.damping() > 0.;
    const bool varies                   = scene.fields.has_temperature &&
                        scene.fields.has_displacement &&
                        !scene.heat.exchange->is_constant();
    if (!is_damped && !varies)
      return misses;
    const auto          &end = simulation.body().contact_end();
    std::vector<double>  velocity;
    std::vector<NodeLaw> laws;
    std::vector<double>  position;
    get_node_laws(simulation.body(), state, laws, position);
    end.get_relative_velocities(state, velocity);
    const bool is_moved =
      scene.material.is_static() && state.was_moved_at_once();
    const double dt = simulation.record().step_size;
    for (unsigned int i = 0; i < laws.size(); ++i)
      {
        const double p    = laws[i].side * state.contact_pressure[i];
        const double near = laws[i].penetration(position[i]);
        const double ds =
          1e-12 * std::max({scales.displacement, std::abs(state.gap[i]), p});
        const double forces =
          (scene.fields.has_temperature ?
             std::abs(scene.material.thermal_stress) * scales.temperature :
             0.) +
          (scales.displacement + scene.material.viscosity * scales.velocity) /
            scene.parameters.mesh.contact_spacing() *
            flatness(scene.parameters) +
          p;
        double dv = 1e-12 * scales.velocity;
        if (dt > 0.)
          dv +=
            scene.contact.is_in_equilibrium() || !scene.material.has_inertia() ?
              ds / dt :
              std::min(ds / dt, 1e-9 * scales.velocity);
        // without inertia it is what is left of velocities of all forces
        if (!scene.material.has_inertia() && scene.material.has_viscosity())
          dv += 1e-12 * forces / scene.material.viscosity;
        if (is_damped && !is_moved)
          raise(misses["pressure of the damped law"],
                miss_of_range(p,
                              near,
                              ds,
                              laws[i].side * velocity[i],
                              dv,
                              [&](const double s, const double v) {
                                return law.damped_pressure(s, v);
                              }));
        if (varies)
          raise(misses["coefficient of the heat exchange"],
                miss_of_range(state.exchange_coefficient[i],
                              near,
                              ds,
                              p,
                              1e-12 * std::max(forces, scales.force),
                              [&](const double s, const double pressure) {
                                return scene.heat.exchange->coefficient(
                                  s, std::max(pressure, 0.));
                              }));
      }
    return misses;
  }
} // namespace ThermoContact

#endif
