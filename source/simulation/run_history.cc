// SPDX-License-Identifier: LGPL-2.1-or-later

#include <thermocontact/simulation/run_history.h>

#include <algorithm>
#include <cmath>

namespace ThermoContact
{
  namespace
  {
    /**
     * True if the velocity of the contact end relative to the obstacle is, to
     * the order of the scheme, the rate of the penetration, on which alone the
     * force depends. Between two obstacles it is not, nor with the mean values
     * over steps of the scheme without dispersion.
     */
    bool
    has_rates(const Scene &scene)
    {
      const ContactLaw &law = *scene.contact.law;
      return scene.parameters.dimension == 1 && scene.scheme.order > 1 &&
             !scene.row.is_given() && !scene.scheme.has_mean_velocity &&
             !scene.scheme.has_no_dispersion && !law.is_rigid() &&
             !law.is_damped() && !scene.contact.is_two_sided();
    }
  } // namespace



  void
  RunHistory::warn(const std::string &warning)
  {
    if (!warning.empty() &&
        std::find(warnings.begin(), warnings.end(), warning) == warnings.end())
      warnings.push_back(warning);
  }



  void
  RunHistory::add_maxima(const Scene &scene, const double gap_rate)
  {
    const double force = std::abs(record.contact_force); // of either obstacle
    if (!has_rates(scene))
      {
        penetration_peak.add(record.time, record.penetration);
        force_peak.add(record.time, force);
      }
    else
      {
        const double rate = record.velocity_end - gap_rate;
        penetration_peak.add(record.time, record.penetration, rate);
        force_peak.add(record.time,
                       force,
                       force > 0. ? rate / scene.contact.law->tangent(force) :
                                    0.);
      }
    max_penetration   = std::fmax(max_penetration, penetration_peak.top());
    max_contact_force = std::fmax(max_contact_force, force_peak.top());
  }



  void
  RunHistory::add_step(const TimeStep &time_step, const StepResult &result)
  {
    ++record.step;
    record.step_size        = time_step.size;
    record.iterations       = result.n_iterations;
    const double old_energy = record.energy;
    add_jump(result); // energies that a jump has, too
    record.dissipation += result.dissipation;
    record.lateral_dissipation += result.lateral_dissipation;
    record.algebraic += result.algebraic;
    record.contact_dissipation += result.contact_dissipation;
    if (!result.is_prescribed)
      max_energy_increase =
        std::max(max_energy_increase, record.energy - old_energy - result.work);
  }



  void
  RunHistory::add_jump(const StepResult &result)
  {
    record.energy_terms = result.energy;
    record.energy       = result.energy.sum();
    record.work += result.work;
    record.numerical_dissipation += result.numerical_dissipation;
    record.contact_impulse += result.impulse;
    for (unsigned int i = 0; i < result.impulses.size(); ++i)
      record.contacts[i].contact_impulse += result.impulses[i];
  }
} // namespace ThermoContact
