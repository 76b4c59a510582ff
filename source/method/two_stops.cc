// SPDX-License-Identifier: LGPL-2.1-or-later

#include <thermocontact/method/damped_contact.h>
#include <thermocontact/method/two_stops.h>

namespace ThermoContact
{
  namespace
  {
    /** At the front stop. */
    double
    pressure_of_stop(const ContactLaw &law,
                     const double      tau,
                     const double      start,
                     const double      free_velocity,
                     const double      receptance,
                     const bool        is_held)
    {
      if (law.damping() > 0.)
        {
          dealii::FullMatrix<double> response(1, 1);
          response(0, 0) = receptance / tau;
          std::vector<double> pressure(1, 0.);
          DampedContact(law).solve(response,
                                   {tau, {start}, {free_velocity}, {is_held}},
                                   pressure);
          return pressure[0];
        }
      const double free_penetration = start + tau * free_velocity;
      return is_held ? law.local_closed_pressure(free_penetration, receptance) :
                       law.local_pressure(free_penetration, receptance);
    }
  } // namespace



  double
  two_stops_pressure(const ContactLaw &law,
                     const StopReach  &reach,
                     const double      receptance,
                     const bool        is_held)
  {
    const bool is_front = is_held ?
                            reach.front > reach.rear :
                            reach.front + reach.tau * reach.free_velocity > 0.;
    return is_front ? pressure_of_stop(law,
                                       reach.tau,
                                       reach.front,
                                       reach.free_velocity,
                                       receptance,
                                       is_held) :
                      -pressure_of_stop(law,
                                        reach.tau,
                                        reach.rear,
                                        -reach.free_velocity,
                                        receptance,
                                        is_held);
  }
} // namespace ThermoContact
