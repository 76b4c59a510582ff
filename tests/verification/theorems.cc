// SPDX-License-Identifier: LGPL-2.1-or-later
//
// The stability estimates of section 4 of the paper, measured: the left-hand
// sides of its Theorems 4.1 and 4.3 and of Corollary 4.2 have bounds that do
// not depend on h and dt. Its scheme and its start, degree 1, data of
// experiment 1, which satisfy the hypotheses of Theorem 2.1; T = 2, with
// contact in every run.
//
// Below, Theta is relative to the steady profile, Theta^0_x = 10 (-2 pi
// sin(2 pi x) - (pi/2) cos(pi x/2)) + 5, r = x/2 - 1, u_1 = 20 x (x - 1)^2,
// ||u_1||^2 = 3.81, ||u_1x||^2 = 53.3. The proofs give for these data:
// * Theorem 4.1, before its constant swallows the data, and with U^1(1) = 0:
//     LHS <= ||Theta^1||^2 + ||u_1||^2 + dt^2 ||u_1x||^2
//            + T (a theta_A ||r||)^2/zeta,
//     ||Theta^1||^2 <= ||Theta^0||^2 + 2 a dt ||u_1x|| ||Theta^1||,
//   that is 253.62 + 0.07 + 3.81 + 0.02 + 0.17 < 258; interpolation of the
//   data on these meshes makes the norms smaller.
// * Corollary 4.2, by the sum of the line in its proof:
//     LHS <= ||Theta^0_x||^2 + k Theta^0(1)^2 + a^2 dt sum ||delta_ux||^2
//         <= 2357.39 + 25 + a^2 (258/zeta + 53.3/64) < 2383.
// * Theorem 4.3: the constant of the proof contains 1/eps^2 and says little.
//   Nearly all of the left-hand side is theta_t at the start, which decays at
//   once: it is largest for n = 2 and grows with smaller dt towards
//     ||theta_0xx - a u_1x||^2 + ||zeta u_1xx - a theta_0x||^2 + ||u_1x||^2
//     = 79101.0 + 54.1 + 53.3 < 79209.
//   Its terms of u alone, gamma and delta_u, which are bounded too, are
//   largest in the first contact: there the obstacle shows.
//
// 1. These bounds hold on all 25 pairs of h = 1/16, ..., 1/256 and dt = 1/64,
//    ..., 1/1024, and largest over smallest are at most 1.5, for the largest
//    over n and for n = N, except for Theorem 4.3: there at most 1.05 over h
//    at fixed dt, and 1.5 for its terms of u.
// 2. For h = 1/64 and dt down to 1/16384 the growth factor of each halving of
//    dt is smaller than the one before, and the last one at most 1.05.
//
// Norms by the matrices of doc/discretisation.md, section 1: M and M_u give
// ||.||^2, K + kB gives ||._x||^2 + k (.)(1)^2, S gives ||._x||^2. The velocity
// of the scheme is delta_u, and [U(1) - g]_+^2/eps = eps p^2.

#include <thermocontact/simulation/simulation.h>

#include <deal.II/base/mpi.h>

#include <algorithm>
#include <array>
#include <vector>

#include "../tests.h"

using namespace ThermoContact;

namespace
{
  using FieldVector = ThermoContact::Vector;
  using Matrix      = ThermoContact::LinearMap;

  /** Left-hand side of an estimate: a sum over the steps and other terms. */
  struct LeftHandSide
  {
    double sum     = 0.;
    double last    = 0.; ///< at n = N
    double largest = 0.; ///< over all n

    void
    add(const double summand, const double other_terms)
    {
      sum += summand;
      last = sum + other_terms;
      raise(largest, last);
    }
  };



  struct Estimates
  {
    LeftHandSide theorem_4_1, corollary_4_2, theorem_4_3,
      theorem_4_3_displacement;
  };



  FieldVector
  difference(const FieldVector &a,
             const FieldVector &b,
             const double       factor = 1.)
  {
    FieldVector result(a);
    result.sadd(factor, -factor, b);
    return result;
  }



  /** $x^TAx$. */
  double
  form(const Matrix &matrix, const FieldVector &x)
  {
    FieldVector product(x);
    matrix.vmult(product, x);
    return x * product;
  }



  /** Follows a run; the names are those of the paper. */
  class Follower
  {
  public:
    explicit Follower(Simulation<1> &simulation)
      : has_contact(false)
      , dt(simulation.parameters().time.step_size.value())
      , zeta(simulation.parameters().model.viscosity)
      , epsilon(simulation.parameters().contact.law.at("Compliance"))
      , heat_mass(simulation.body().equations.heat_mass)
      , conduction(simulation.body().equations.conduction)
      , momentum_mass(simulation.body().equations.momentum_mass)
      , stiffness(simulation.body().equations.stiffness)
    {}

    Estimates estimates;
    bool      has_contact;

    Simulation<1>::Observer
    observer()
    {
      return [this](const Simulation<1> &s) { observe(s); };
    }

  private:
    const double  dt;
    const double  zeta;
    const double  epsilon;
    const Matrix &heat_mass;
    const Matrix &conduction;
    const Matrix &momentum_mass;
    const Matrix &stiffness;
    State         old_state;
    FieldVector   old_delta_theta;
    FieldVector   old_gamma;

    void
    observe(const Simulation<1> &simulation)
    {
      const unsigned int n     = simulation.record().step;
      const State       &state = simulation.state();
      has_contact |= simulation.record().in_contact;
      if (n >= 1)
        {
          const FieldVector theta =
            difference(state.temperature,
                       simulation.body().energy.steady_profile());
          const FieldVector delta_theta =
            difference(state.temperature, old_state.temperature, 1. / dt);
          const FieldVector gamma =
            difference(state.velocity, old_state.velocity, 1. / dt);
          add_corollary_4_2(theta, delta_theta);
          if (n >= 2)
            add_theorem_4_1(state, theta, delta_theta, gamma);
          if (n >= 3)
            add_theorem_4_3(state, delta_theta, gamma);
          old_delta_theta = delta_theta;
          old_gamma       = gamma;
        }
      old_state = state;
    }

    void
    add_theorem_4_1(const State       &state,
                    const FieldVector &theta,
                    const FieldVector &delta_theta,
                    const FieldVector &gamma)
    {
      const double p         = state.contact.pressure[0];
      const double delta_ux2 = form(stiffness, state.velocity);
      estimates.theorem_4_1.add(
        dt * dt * form(heat_mass, delta_theta) + dt * form(conduction, theta) +
          dt * dt * form(momentum_mass, gamma) + dt * zeta * delta_ux2 +
          dt * dt * delta_ux2,
        form(heat_mass, theta) + form(momentum_mass, state.velocity) +
          form(stiffness, state.displacement) + epsilon * p * p);
    }

    void
    add_corollary_4_2(const FieldVector &theta, const FieldVector &delta_theta)
    {
      estimates.corollary_4_2.add(dt * form(heat_mass, delta_theta) +
                                    dt * dt * form(conduction, delta_theta),
                                  form(conduction, theta));
    }

    /** The number of the present step is the n + 1 of the theorem. */
    void
    add_theorem_4_3(const State       &state,
                    const FieldVector &delta_theta,
                    const FieldVector &gamma)
    {
      const double gamma_x2 = form(stiffness, gamma);
      const double heat_sum =
        form(heat_mass, difference(delta_theta, old_delta_theta)) +
        dt * form(conduction, delta_theta);
      const double heat = form(heat_mass, delta_theta);
      const double displacement_sum =
        form(momentum_mass, difference(gamma, old_gamma)) + dt * dt * gamma_x2 +
        zeta * dt * gamma_x2;
      const double displacement =
        form(momentum_mass, gamma) + form(stiffness, state.velocity);
      estimates.theorem_4_3.add(heat_sum + displacement_sum,
                                heat + displacement);
      estimates.theorem_4_3_displacement.add(displacement_sum, displacement);
    }
  };



  Estimates
  run(const unsigned int cells, const double dt)
  {
    Parameters parameters =
      read_parameters("paper/experiment-1.prm", {"Time/End time=2"});
    parameters.mesh.cells     = cells;
    parameters.time.step_size = dt;
    Simulation<1> simulation(parameters, MPI_COMM_SELF);
    Follower      follower(simulation);
    simulation.run({follower.observer()});
    AssertThrow(follower.has_contact, ExcMessage("no contact"));
    return follower.estimates;
  }



  using Estimate = LeftHandSide Estimates::*;
  using Value    = double          LeftHandSide::*;

  double
  largest(const std::vector<Estimates> &runs, const Estimate estimate)
  {
    double result = 0.;
    for (const Estimates &estimates : runs)
      raise(result, (estimates.*estimate).largest);
    return result;
  }



  /** Largest over smallest of all runs. */
  double
  spread(const std::vector<Estimates> &runs,
         const Estimate                estimate,
         const Value                   value)
  {
    std::vector<double> values;
    for (const Estimates &estimates : runs)
      values.push_back(estimates.*estimate.*value);
    return *std::max_element(values.begin(), values.end()) /
           *std::min_element(values.begin(), values.end());
  }



  void
  print_bound_and_spread(const std::string            &name,
                         const std::vector<Estimates> &runs,
                         const Estimate                estimate,
                         const unsigned int            bound)
  {
    deallog << name << ": at most " << bound << ' '
            << within(largest(runs, estimate), bound)
            << "; largest over smallest at most 1.5, largest over n "
            << within(spread(runs, estimate, &LeftHandSide::largest), 1.5)
            << ", n = N "
            << within(spread(runs, estimate, &LeftHandSide::last), 1.5)
            << std::endl;
  }



  void
  check_all_meshes_and_steps()
  {
    std::vector<Estimates> runs;
    double                 spread_over_h = 0.;
    for (unsigned int n = 64; n <= 1024; n *= 2)
      {
        std::vector<Estimates> of_step;
        for (unsigned int cells = 16; cells <= 256; cells *= 2)
          of_step.push_back(run(cells, 1. / n));
        raise(spread_over_h,
              spread(of_step, &Estimates::theorem_4_3, &LeftHandSide::largest));
        runs.insert(runs.end(), of_step.begin(), of_step.end());
      }

    deallog << runs.size() << " pairs of h and dt" << std::endl;
    print_bound_and_spread("Theorem 4.1", runs, &Estimates::theorem_4_1, 258);
    print_bound_and_spread("Corollary 4.2",
                           runs,
                           &Estimates::corollary_4_2,
                           2383);
    deallog << "Theorem 4.3: "
            << within(largest(runs, &Estimates::theorem_4_3), 79209.)
            << "; largest over smallest at fixed dt "
            << within(spread_over_h, 1.05) << "; terms of u "
            << within(spread(runs,
                             &Estimates::theorem_4_3_displacement,
                             &LeftHandSide::largest),
                      1.5)
            << std::endl;
  }



  void
  check_growth()
  {
    double       last        = run(64, 1. / 64).theorem_4_3.largest;
    double       last_growth = 0.;
    unsigned int n_halvings = 0, n_smaller = 0;
    for (unsigned int n = 128; n <= 16384; n *= 2)
      {
        const double next   = run(64, 1. / n).theorem_4_3.largest;
        const double growth = next / last;
        if (++n_halvings > 1)
          n_smaller += growth < last_growth;
        last        = next;
        last_growth = growth;
      }
    deallog << "Theorem 4.3, " << n_halvings << " halvings of dt: growth "
            << "smaller than before " << n_smaller << ", at last "
            << within(last_growth, 1.05) << " " << within(last, 79209.)
            << std::endl;
  }
} // namespace



void
main_theorems()
{
  initlog();

  check_all_meshes_and_steps();
  check_growth();
}
