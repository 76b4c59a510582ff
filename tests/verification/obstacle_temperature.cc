// SPDX-License-Identifier: LGPL-2.1-or-later
//
// An obstacle whose temperature is an expression in t (y, z), heat alone;
// doc/model.md (M5.9).
//
// 1. theta_obs = sin(w t), w = 5, k = 2, theta_A = 0, from rest: after the
//    transient, exp(-5.2 t), the profile is periodic,
//      theta = Im(A sinh(c x) exp(i w t)), c^2 = i w,
//      A (c cosh c + k sinh c) = k
//    by -theta_x = k (theta - theta_obs) at x = 1. theta(1) and the heat flux
//    k (theta(1) - theta_obs) for 6 < t < 8 to 1e-7, tolerance 1e-9.
// 2. A jump of theta_obs from 1 to 3 at t = 1/2 is a heat flux of 2 k that
//    begins there: end and mean temperatures, energy and work to 1e-12 of the
//    largest at t = 1 in the same steps, backward Euler; the heat fluxes into
//    the obstacle differ by 2 k.
// 3. theta_obs = 20 y t in a strip of width 0.1 has the mean t: mean
//    temperatures of the end and the body are those of a rod with theta_obs =
//    t, to 1e-10, since means over the cross-section solve its equation.

#include <thermocontact/simulation/simulation.h>

#include <deal.II/base/mpi.h>

#include <cmath>
#include <complex>
#include <string>
#include <vector>

#include "../tests.h"

#include "../recorded_run.h"

using namespace ThermoContact;

namespace
{
  const Overrides heat{"Model/Fields=temperature",
                       "Boundary/left/Temperature=0",
                       "Boundary/right/Heat exchange=2",
                       "Initial values/Temperature=0"};

  const Overrides euler{"Time/Scheme=backward euler", "Time/Step size=0.01"};



  void
  check_periodic()
  {
    const double               w = 5., k    = 2.;
    const std::complex<double> i(0., 1.), c = std::sqrt(i * w);
    const std::complex<double> A = k / (c * std::cosh(c) + k * std::sinh(c));
    double                     error = 0.;
    unsigned int               n     = 0;
    for (const StepRecord &r :
         run<1>("",
                heat + Overrides{"Boundary/right/Surroundings=sin(5*t)",
                                 "Time/Tolerance=1e-9",
                                 "Time/End time=8"})
           .rows)
      if (r.time > 6.)
        {
          const double theta =
            (A * std::sinh(c) * std::exp(i * w * r.time)).imag();
          raise(error, std::abs(r.temperature_end - theta));
          raise(error,
                std::abs(r.heat_flux_end - k * (theta - std::sin(w * r.time))));
          ++n;
        }
    deallog << "periodic: many rows " << (n > 20) << ", temperature and flux "
            << within(error, 1e-7) << std::endl;
  }



  void
  check_jump()
  {
    const Overrides  scene = heat + euler + Overrides{"Time/End time=1"};
    const StepRecord varying =
      run<1>("",
             scene + Overrides{"Boundary/right/Surroundings="
                               "if(t<0.495,1,3)"})
        .rows.back();
    const StepRecord flux =
      run<1>("",
             scene + Overrides{"Boundary/right/Surroundings=1",
                               "Boundary/right/Heat flux="
                               "if(t<0.495,0,4)"})
        .rows.back();
    double error = 0.;
    raise(error, std::abs(varying.temperature_end / flux.temperature_end - 1.));
    raise(error,
          std::abs(varying.temperature_mean / flux.temperature_mean - 1.));
    raise(error, std::abs(varying.energy / flux.energy - 1.));
    raise(error, std::abs(varying.work / flux.work - 1.));
    raise(error, std::abs(varying.heat_flux_end - flux.heat_flux_end + 4.));
    deallog << "jump: that of a heat flux " << within(error, 1e-12)
            << std::endl;
  }



  void
  check_strip()
  {
    const Overrides scene =
      heat + euler +
      Overrides{"Time/End time=1", "Mesh/Cells=4", "Mesh/Degree=2"};
    const StepRecord rod =
      run<1>("", scene + Overrides{"Boundary/right/Surroundings=t"})
        .rows.back();
    const StepRecord strip =
      run<2>("",
             scene + Overrides{"Dimension=2",
                               "Mesh/Cells across=2",
                               "Boundary/right/Surroundings=20*y*t"})
        .rows.back();
    deallog << "strip: means of the rod "
            << within(std::abs(strip.temperature_end - rod.temperature_end),
                      1e-10)
            << ' '
            << within(std::abs(strip.temperature_mean - rod.temperature_mean),
                      1e-10)
            << ' '
            << within(std::abs(strip.heat_flux_end - rod.heat_flux_end), 1e-10)
            << std::endl;
  }
} // namespace



void
main_obstacle_temperature()
{
  initlog();
  check_periodic();
  check_jump();
  check_strip();
}
