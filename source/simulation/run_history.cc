// SPDX-License-Identifier: LGPL-2.1-or-later

#include <thermocontact/simulation/run_history.h>

#include <algorithm>
#include <cmath>

namespace ThermoContact
{
  namespace
  {
    /**
     * True if the velocity of a contact is, to the order of the scheme, the
     * rate of the penetration, on which alone the force depends. Between two
     * obstacles it is not, nor with the mean values over steps of the scheme
     * without dispersion.
     */
    bool
    has_rates(const Scene &scene, const unsigned int number)
    {
      const ContactLaw &law = scene.contact.law_at(number);
      return scene.parameters.dimension == 1 && scene.scheme.order > 1 &&
             !scene.scheme.has_mean_velocity &&
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
    const SceneContact &contact = scene.contact;
    const auto          add     = [&](const unsigned int number,
                         const double       penetration,
                         const double       force, // of either obstacle
                         const double       rate) {
      Peaks     &at          = peaks[number];
      const bool rates_exist = has_rates(scene, number);
      at.penetration.add(record.time, penetration, rates_exist ? rate : nan);
      at.force.add(record.time,
                   force,
                   !rates_exist ? nan :
                                force > 0. ? rate / contact.law_at(number).tangent(force) :
                                             0.);
      max_penetration = std::fmax(max_penetration, at.penetration.top());
      max_contact_force = std::fmax(max_contact_force, at.force.top());
    };
    const std::vector<ContactRecord> &contacts = record.contacts;
    peaks.resize(std::max<std::size_t>(1, contacts.size()));
    if (contacts.empty())
      return add(0,
                 record.penetration,
                 std::abs(record.contact_force),
                 record.velocity_end - gap_rate);
    for (unsigned int i = 0; i < contacts.size(); ++i)
      {
        const double force = std::abs(contacts[i].contact_force);
        add(i,
            contact.is_damped() ?
              std::fmax(0., 0. - contacts[i].gap) :
              contact.penetration_under(contacts[i].contact_force, i),
            force,
            contacts[i].velocity);
      }
  }



  namespace
  {
    double
    largest_estimate(const std::vector<RunHistory::Peaks> &peaks,
                     SampledPeak RunHistory::Peaks::*const of)
    {
      double largest = nan;
      for (const RunHistory::Peaks &at : peaks)
        largest = std::fmax(largest, (at.*of).estimate());
      return largest;
    }



    const SampledPeak &
    largest_peak(const std::vector<RunHistory::Peaks> &peaks,
                 SampledPeak RunHistory::Peaks::*const of)
    {
      static const SampledPeak none;
      const auto               largest =
        std::max_element(peaks.begin(),
                         peaks.end(),
                         [of](const auto &one, const auto &other) {
                           return (one.*of).top() < (other.*of).top();
                         });
      return largest == peaks.end() ? none : (*largest).*of;
    }
  } // namespace



  double
  RunHistory::peak_force() const
  {
    return largest_estimate(peaks, &Peaks::force);
  }



  double
  RunHistory::peak_penetration() const
  {
    return largest_estimate(peaks, &Peaks::penetration);
  }



  const SampledPeak &
  RunHistory::largest_force() const
  {
    return largest_peak(peaks, &Peaks::force);
  }



  const SampledPeak &
  RunHistory::largest_penetration() const
  {
    return largest_peak(peaks, &Peaks::penetration);
  }



  void
  RunHistory::add_step(const TimeStep &time_step, const StepResult &result)
  {
    ++record.step;
    record.step_size        = time_step.size;
    record.iterations       = result.n_iterations;
    const double old_energy = record.energy;
    add_jump(result);
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
    record.dissipation += result.dissipation;
    record.lateral_dissipation += result.lateral_dissipation;
    record.numerical_dissipation += result.numerical_dissipation;
    record.algebraic += result.algebraic;
    record.contact_dissipation += result.contact_dissipation;
    record.boundaries.add(1., result.boundaries);
    record.contact_impulse += result.impulse;
    for (unsigned int i = 0; i < result.impulses.size(); ++i)
      record.contacts[i].contact_impulse += result.impulses[i];
  }
} // namespace ThermoContact
