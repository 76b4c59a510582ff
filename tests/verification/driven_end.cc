// SPDX-License-Identifier: LGPL-2.1-or-later
//
// A fixed end that is heated or moved as a function of time,
// doc/discretisation.md section 6.
//
// 1. theta_A = sin(w t), w = 5, k = 2, from rest: after the transient,
//    exp(-5.2 t), the profile is periodic,
//      theta(1) = Im(exp(i w t) / (cosh c + (k/c) sinh c)), c^2 = i w,
//    by theta_xx = i w theta and -theta_x = k theta at x = 1. To 1e-7 for
//    6 < t < 8, tolerance 1e-9.
// 2. u_A = sin(w t) without contact, b = 1, zeta = 0.1: with
//    kappa^2 = b w^2 / (1 + i zeta w) the solution is
//      u = Im(U exp(i w t)), U = cos(kappa (1-x)) / cos(kappa) ,
//    by -b w^2 U = (1 + i zeta w) U'' and U'(1) = 0. Five frequencies from
//    below the first resonance, at w = pi/2, to beyond the second, at 3 pi/2;
//    each starts on the solution, u_0 = Im U, u_1 = w Re U. u(1) and u_t(1) to
//    1e-7 of the largest |U| or w |U|, tolerance 1e-9.
// 3. Orders at fixed steps of
//      u = sin(3t) (1 + x^2/2), theta = cos(2t) (1 + x - x^2), a = 1/2 ,
//    which is in the space of degree 2: u_A = sin(3t), theta_A = cos(2t), and
//    sources and a traction that follow from (M1.1) to (M1.3); h = 0 for k = 1.
//    The error of u(1), u_t(1), theta(1) and the numerical dissipation, which
//    is what the balance of energy lacks, vanish with the order of the scheme,
//    within 0.2 from steps of 1/80 to 1/160, in the largest values of 0 < t
//    < 1.
// 4. theta_A jumps from 0 to 1 at t = 1/2, k = 0: the mean temperature is
//      1 - sum_n 2/k_n^2 exp(-k_n^2 s), k_n = (n+1/2) pi, s = t - 1/2 ;
//    a pulse of length 1e-3 to 20 is the difference of two jumps. u_A = [s]_+,
//    b = zeta = 1: the relative displacement starts with the velocity -1,
//      u(1) = s - sum_n (-1)^n 2/k_n (exp(r_1 s) - exp(r_2 s)) / (r_1 - r_2) ,
//      r^2 + k_n^2 r + k_n^2 = 0 .
//    Error control finds all three: errors below 30 tolerances of the largest
//    value at t = 1, tolerance 1e-6.
// 5. b = 0, zeta > 0: without loads and contact the rod moves with its end,
//    u(1) = u_A and u_t(1) = u_A', at the start, too; b = zeta = 0: u(1) = u_A.
//    Before a damped obstacle that is out of reach all nodes have u_A'.

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
  using Complex = std::complex<double>;

  const Complex i_unit(0., 1.);

  const Overrides heat{"Model/Fields=temperature",
                       "Initial values/Temperature=0"};

  const Overrides motion{"Model/Fields=displacement",
                         "Contact/Condition=none",
                         "Initial values/Displacement=0",
                         "Initial values/Velocity=0"};



  void
  check_periodic_heat()
  {
    const double  w = 5., k = 2.;
    const Complex c     = std::sqrt(i_unit * w);
    const Complex A     = 1. / (std::cosh(c) + k / c * std::sinh(c));
    double        error = 0.;
    unsigned int  n     = 0;
    for (const StepRecord &r :
         run<1>("",
                heat + Overrides{"Boundary/left/Temperature=sin(5*t)",
                                 "Boundary/right/Heat exchange=2",
                                 "Time/Tolerance=1e-9",
                                 "Time/End time=8"})
           .rows)
      if (r.time > 6.)
        {
          const double theta = (A * std::exp(i_unit * w * r.time)).imag();
          raise(error, std::abs(r.temperature_end - theta));
          raise(error, std::abs(r.heat_flux_end - k * theta));
          ++n;
        }
    deallog << "periodic heat: many rows " << (n > 20)
            << ", temperature and flux " << within(error, 1e-7) << std::endl;
  }



  /** $A\cos(\kappa(1-x))$ of complex numbers: real and imaginary part. */
  std::pair<std::string, std::string>
  cosine(const Complex factor, const Complex kappa)
  {
    std::ostringstream re, im;
    const auto part = [&](std::ostringstream &text, double a, double b) {
      text.precision(17);
      text << '(' << a << ")*cos(" << kappa.real() << "*(1-x))*cosh("
           << kappa.imag() << "*(1-x))+(" << b << ")*sin(" << kappa.real()
           << "*(1-x))*sinh(" << kappa.imag() << "*(1-x))";
    };
    part(re, factor.real(), factor.imag());
    part(im, factor.imag(), -factor.real());
    return {re.str(), im.str()};
  }



  void
  check_shaken_base()
  {
    const double zeta  = 0.1;
    double       error = 0.;
    for (const double w : {1., 1.5707963267948966, 3., 4.71238898038469, 6.})
      {
        const Complex      kappa        = w / std::sqrt(1. + i_unit * zeta * w);
        const Complex      end          = 1. / std::cos(kappa);
        const std::string  displacement = cosine(end, kappa).second;
        const std::string  velocity     = cosine(w * end, kappa).first;
        const double       largest      = std::max(1., std::abs(end));
        std::ostringstream drive;
        drive.precision(17);
        drive << "Boundary/left/Displacement=sin(" << w << "*t)";
        for (const StepRecord &r :
             run<1>("",
                    motion +
                      Overrides{entry("Model/Viscosity", zeta),
                                drive.str(),
                                "Initial values/Displacement=" + displacement,
                                "Initial values/Velocity=" + velocity,
                                "Mesh/Cells=4",
                                "Mesh/Degree=9",
                                "Time/Tolerance=1e-9",
                                "Time/End time=8"})
               .rows)
          {
            const Complex u = end * std::exp(i_unit * w * r.time);
            raise(error, std::abs(r.displacement_end - u.imag()) / largest);
            raise(error,
                  std::abs(r.velocity_end - w * u.real()) / (w * largest));
          }
      }
    deallog << "shaken base: two resonances " << within(error, 1e-7)
            << std::endl;
  }



  const Overrides manufactured{
    "Model/Viscosity=0.3",
    "Model/Coupling=0.5",
    "Contact/Condition=none",
    "Boundary/right/Heat exchange=1",
    "Boundary/left/Temperature=cos(2*t)",
    "Boundary/left/Displacement=sin(3*t)",
    "Initial values/Temperature=1+x-x^2",
    "Initial values/Displacement=0",
    "Initial values/Velocity=3*(1+x^2/2)",
    "Boundary/sides/Heat exchange=2",
    "Boundary/sides/Surroundings=5",
    "Sources/Heat source=-2*sin(2*t)*(1+x-x^2)+2*cos(2*t)+1.5*cos(3*t)*x"
    "+2*((1+x-x^2)*cos(2*t)-5)",
    "Sources/Body force=-9*sin(3*t)*(1+x^2/2)-(sin(3*t)+0.9*cos(3*t))"
    "+0.5*cos(2*t)*(1-2*x)",
    "Boundary/right/Traction=sin(3*t)+0.9*cos(3*t)-0.5*cos(2*t)",
    "Mesh/Cells=1",
    "Mesh/Degree=2",
    "Time/Start=consistent",
    "Time/End time=1"};



  /**
   * Largest errors of u, u_t and theta at the end of the rod, and of what the
   * energy lacks.
   */
  std::vector<double>
  errors_of(const std::string &scheme, const double size)
  {
    std::vector<double> errors(4, 0.);
    for (const StepRecord &r :
         run<1>("",
                manufactured + Overrides{"Time/Scheme=" + scheme,
                                         entry("Time/Step size", size)})
           .rows)
      {
        const double s = std::sin(3. * r.time), c = std::cos(3. * r.time);
        raise(errors[0], std::abs(r.displacement_end - 1.5 * s));
        raise(errors[1], std::abs(r.velocity_end - 4.5 * c));
        raise(errors[2], std::abs(r.temperature_end - std::cos(2. * r.time)));
        raise(errors[3], std::abs(r.numerical_dissipation));
      }
    return errors;
  }



  void
  check_orders()
  {
    const std::vector<std::pair<std::string, double>> schemes = {
      {"backward euler", 1.}, {"sdirk2", 2.}, {"sdirk3", 3.}, {"sdirk4", 4.}};
    for (const auto &[scheme, order] : schemes)
      {
        const auto coarse = errors_of(scheme, 1. / 80.);
        const auto fine   = errors_of(scheme, 1. / 160.);
        deallog << scheme << ": orders of u, u_t, theta, energy at least "
                << order << " - 0.2 ";
        for (unsigned int i = 0; i < coarse.size(); ++i)
          {
            const double measured = std::log2(coarse[i] / fine[i]);
            deallog << (measured > order - 0.2);
          }
        deallog << std::endl;
      }
  }



  /** Mean temperature a time after theta_A has jumped from 0 to 1. */
  double
  mean_after_jump(const double s)
  {
    double mean = 1.;
    for (int n = 100; n-- > 0;)
      {
        const double k = (n + 0.5) * numbers::PI;
        mean -= 2. / (k * k) * std::exp(-k * k * s);
      }
    return mean;
  }



  /** u(1) a time after a base begins to move with the velocity 1. */
  double
  end_of_pushed_rod(const double s)
  {
    Complex u = s;
    for (int n = 4000; n-- > 0;)
      {
        const double  k    = (n + 0.5) * numbers::PI;
        const Complex root = std::sqrt(Complex(k * k * k * k - 4. * k * k));
        const Complex r_1 = 0.5 * (-k * k + root), r_2 = 0.5 * (-k * k - root);
        u -= (n % 2 == 0 ? 2. : -2.) / k *
             (std::exp(r_1 * s) - std::exp(r_2 * s)) / root;
      }
    return u.real();
  }



  void
  check_breaks()
  {
    const Overrides fine{"Time/Tolerance=1e-6",
                         "Time/End time=1",
                         "Mesh/Cells=16",
                         "Mesh/Degree=4"};
    const Overrides insulated =
      heat + fine + Overrides{"Boundary/right/Heat exchange=0"};
    const auto mean = [&](const std::string &drive) {
      return run<1>("",
                    insulated + Overrides{"Boundary/left/Temperature=" + drive})
        .rows.back()
        .temperature_mean;
    };
    const double jump  = mean("if(t<0.5,0,1)") - mean_after_jump(0.5);
    const double pulse = mean("if(t>0.5,if(t<0.501,20,0),0)") -
                         20. * (mean_after_jump(0.5) - mean_after_jump(0.499));
    const double kink =
      run<1>("",
             motion + fine +
               Overrides{"Model/Viscosity=1",
                         "Boundary/left/Displacement=if(t<0.5,0,t-0.5)"})
        .rows.back()
        .displacement_end -
      end_of_pushed_rod(0.5);
    deallog << "jump, pulse and kink to 30 tolerances "
            << within(std::abs(jump), 3e-5) << ' '
            << within(std::abs(pulse) / 20., 3e-5) << ' '
            << within(std::abs(kink) / 0.5, 3e-5) << std::endl;
  }



  void
  check_rigid_motion()
  {
    double error = 0.;
    for (const double zeta : {0.3, 0.})
      for (const StepRecord &r :
           run<1>("",
                  Overrides{"Model/Fields=displacement",
                            "Contact/Condition=none",
                            "Model/Inertia=0",
                            zeta > 0. ? "Initial values/Displacement=0" :
                                        "Model/Inertia=0",
                            entry("Model/Viscosity", zeta),
                            "Time/Step size=0.01",
                            "Boundary/left/Displacement=t^2+3*t",
                            "Time/End time=0.5"})
             .rows)
        {
          const double t = r.time;
          raise(error, std::abs(r.displacement_end - t * t - 3. * t));
          if (zeta > 0.)
            raise(error, std::abs(r.velocity_end - 2. * t - 3.));
        }
    Simulation<1> damped(read_parameters("",
                                         {"Model/Fields=displacement",
                                          "Model/Inertia=0",
                                          "Model/Viscosity=0.3",
                                          "Initial values/Displacement=0",
                                          "Contact/Gap=1e3",
                                          "Contact/Damping=1",
                                          "Time/Step size=0.1",
                                          "Boundary/left/Displacement=t^2+3*t",
                                          "Time/End time=0.5"}),
                         MPI_COMM_SELF);
    damped.run({[&](const Simulation<1> &simulation) {
      const State &state = simulation.state();
      for (const double velocity : state.velocity)
        raise(error, std::abs(velocity - 2. * state.time - 3.));
    }});
    deallog << "no inertia: moves with its end " << within(error, 1e-9)
            << std::endl;
  }
} // namespace



void
main_driven_end()
{
  initlog();
  check_periodic_heat();
  check_shaken_base();
  check_orders();
  check_breaks();
  check_rigid_motion();
}
