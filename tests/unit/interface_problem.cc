// SPDX-License-Identifier: LGPL-2.1-or-later
//
// Laws of contact nodes by their resolvents, and contact of many nodes; no
// mesh.
//
// 1. One node by hand, z = x + r p:
//      linear, eps = 0.01, r = 0.03: z 0.02 gives p 0.02/0.04 = 0.5; z 0: 0
//      rigid, r = 0.03: z 0.03 gives 1; z -1: 0
//      held, rigid, r = 2: z -3 gives -3/2
//      two sides, linear, eps = 1, r = 1, play 2: z 2 gives 1, z -1: 0, z -6
//        is 4 beyond the rear obstacle: -2. Seen from the rear one, where z is
//        2 larger: the same
//      damped, eps = 1/2, c = 2, tau = 1: start -1, v = 3/2 has s = 1/2 and
//        p = 1 (1 + 3) = 4, so that r = 1/4 leaves it of z = 5/2. Start 1, v =
//        -1/4: s = 3/4, p = 3/2 * 1/2 = 3/4, r = 1 leaves it of 1/2. Start 3,
//        z = -1: 1 + c v < 0, p = 0. tau = 0, start 1, v = 1/2: p = 2 * 2 = 4,
//        r = 1/8, z = 1. Held, start 1/4, v = -1/2: s = -1/4, p = -1/2 (1 -
//        2/4) = -1/4, r = 1 leaves it of -3/4
//      dashpot, eps = 1/2, d = 1/2, tau = 1: start -1, v = 3/2 has p = 1 + 3/4
//        = 7/4, r = 2 leaves it of z = 5; at v = 1 the graph is vertical up to
//        1/2, so that z = 5/4 and r = 1 have p = 1/4. Start 1, z = -9/10: p =
//        1/5 - 9/20 < 0: 0. tau = 1/2, v = -4/5: s = 3/5, p = 6/5 - 2/5 = 4/5,
//        r = 1, z = 0. tau = 0, start 1/8, v = -1: 1/4 - 1/2 < 0: 0; held -1/4,
//        r = 1, z = -5/4
//      mean, eps = 1, r = 2: from -1 to -0.5: 0; from 1, z 3: s = 1, p = 1;
//        from 0, z 4: s = 2, p = 1; from -1, z 3.5: 2 s^2 - 2.5 s - 3.5 = 0,
//        s = (2.5 + sqrt(34.25))/4, p = (3.5 - s)/2 = 0.70595625; from 1, z
//        -2: s = -(1 + sqrt(13))/2, p = (-2 - s)/2 = 0.15138782. From 1 to
//        beyond a rear obstacle, play 1, r = 0, z -3: (2^2 - 1^2)/2 over -4:
//        -3/8
// 2. Two nodes, W = [2 1; 1 2], rigid. Free (3, 3): p = (1, 1); (2, 0.5): node
//    1 alone would leave node 2 at 0.5 - 1 < 0: (1, 0); (1, -3) with node 2
//    held: W p = (1, -3), p = (5/3, -7/3). A small change (3, 5) with eps = 1
//    about a solution with both closed: [3 1; 1 3] dp, dp = (1/2, 3/2). A NaN
//    at either node makes both pressures NaN, so that the state is not finite.
// 3. 1000 random problems of up to 30 nodes: W = A^T A + c I or smooth like
//    exp(-|x - y|), of size 1e-4 to 1e4; at each node nothing, rigid, linear,
//    power law or damped, eps/r from 1e-10 to 1e6, a third of them two-sided, a
//    tenth held. x = x_free - W p has to lie on the graph of each law, to 1e-11
//    of the largest term, from zero pressures and from others, that is the same
//    solution.
// 4. Slopes: P' of each law is the difference quotient of P, to 1e-5.
// 5. 300 random problems of 3 by tangents, where a body only knows linear
//    systems, c = 1, eps/r from 1e-4: r p as in 3, to 1e-7 of the largest r p
//    or x_free, and no more than 20 systems. Linear laws of which all are held:
//    one system.
// 6. W = [1 -2; -2 1], rigid, free (1, 1): p_1 = 1 + 2 p_2 and p_2 = 1 + 2 p_1
//    have no solution that pushes: errors that say so.

#include <thermocontact/base/exceptions.h>
#include <thermocontact/contact/contact_law.h>
#include <thermocontact/contact/interface_problem.h>

#include <cmath>
#include <random>

#include "../tests.h"

using namespace ThermoContact;
using dealii::FullMatrix;

namespace
{
  using Values = std::vector<double>;

  std::unique_ptr<const ContactLaw>
  linear(const double eps, const double c = 0., const double d = 0.)
  {
    return contact_law("normal compliance")
      .make({{"Compliance", eps}, {"Damping", c}, {"Dashpot", d}});
  }

  std::unique_ptr<const ContactLaw>
  rigid()
  {
    return contact_law("rigid").make({});
  }

  NodeLaw
  damped(const ContactLaw &law,
         const double      start,
         const double      tau,
         const bool        is_held = false)
  {
    NodeLaw node(law);
    node.is_in_velocity = true;
    node.start          = start;
    node.tau            = tau;
    node.is_held        = is_held;
    return node;
  }

  double
  mean(const ContactLaw &law,
       const double      start,
       const double      z,
       const double      r,
       const double      play = NodeLaw().play)
  {
    NodeLaw node(law);
    node.mean_from = start;
    node.play      = play;
    return node.resolve(z, r).pressure;
  }

  void
  test_one_node()
  {
    const auto stiff = linear(0.01), soft = linear(1.), wall = rigid();
    NodeLaw    held(*wall);
    held.is_held = true;
    deallog << "linear " << stiff->resolve(0.02, 0.03).pressure << ' '
            << stiff->resolve(0., 0.03).pressure << ", rigid "
            << wall->resolve(0.03, 0.03).pressure << ' '
            << wall->resolve(-1., 0.03).pressure << ", held "
            << held.resolve(-3., 2.).pressure << std::endl;
    NodeLaw front(*soft);
    front.play         = 2.;
    NodeLaw      rear  = front;
    const double shift = rear.face(-1, 0.);
    deallog << "two sides:";
    for (const double z : {2., -1., -6.})
      deallog << ' ' << front.resolve(z, 1.).pressure << ' '
              << rear.resolve(z + shift, 1.).pressure;
    deallog << std::endl;
    const auto law = linear(0.5, 2.);
    deallog << "damped: closing "
            << damped(*law, -1., 1.).resolve(2.5, 0.25).pressure << ", opening "
            << damped(*law, 1., 1.).resolve(0.5, 1.).pressure
            << ", left behind "
            << damped(*law, 3., 1.).resolve(-1., 1.).pressure << ", in place "
            << damped(*law, 1., 0.).resolve(1., 0.125).pressure << ", held "
            << damped(*law, 0.25, 1., true).resolve(-0.75, 1.).pressure
            << std::endl;
    const auto buffer = linear(0.5, 0., 0.5);
    deallog << "dashpot: closing "
            << damped(*buffer, -1., 1.).resolve(5., 2.).pressure
            << ", touching "
            << damped(*buffer, -1., 1.).resolve(1.25, 1.).pressure
            << ", left behind "
            << damped(*buffer, 1., 1.).resolve(-0.9, 1.).pressure
            << ", opening " << damped(*buffer, 1., 0.5).resolve(0., 1.).pressure
            << ", in place "
            << damped(*buffer, 0.125, 0.).resolve(-1., 1.).pressure << ", held "
            << damped(*buffer, 0.125, 0., true).resolve(-1.25, 1.).pressure
            << std::endl;
    deallog << "mean: " << mean(*soft, -1., -0.5, 2.) << ' '
            << mean(*soft, 1., 3., 2.) << ' ' << mean(*soft, 0., 4., 2.) << ' '
            << mean(*soft, -1., 3.5, 2.) << ' ' << mean(*soft, 1., -2., 2.)
            << ", to the other side " << mean(*soft, 1., -3., 0., 1.)
            << std::endl;
  }

  void
  test_two_nodes()
  {
    FullMatrix<double> W(2, 2);
    W(0, 0) = W(1, 1) = 2.;
    W(0, 1) = W(1, 0)         = 1.;
    const auto           wall = rigid(), soft = linear(1.);
    std::vector<NodeLaw> laws(2, NodeLaw(*wall));
    InterfaceProblem     problem;
    for (const Values &free :
         {Values{3., 3.}, Values{2., 0.5}, Values{1., -3.}})
      {
        laws[1].is_held = free[1] < 0.;
        Values p(2, 0.);
        problem.solve(W, laws, free, p);
        deallog << "free " << free[0] << ' ' << free[1] << ": p " << p[0] << ' '
                << p[1] << std::endl;
      }
    laws.assign(2, NodeLaw(*soft));
    Values p(2, 0.);
    problem.solve(W, laws, {9., 9.}, p);
    const Values change = change_of_pressure(W, problem.slopes(), {3., 5.});
    deallog << "small change: " << change[0] << ' ' << change[1] << std::endl;
    for (const Values &free :
         {Values{std::nan(""), 1.}, Values{1., std::nan("")}})
      {
        problem.solve(W, laws, free, p);
        deallog << "after a NaN: NaN " << (std::isnan(p[0]) && std::isnan(p[1]))
                << std::endl;
      }
  }

  /** A random problem; owns the laws of its nodes. */
  struct Problem
  {
    FullMatrix<double>                             W;
    Values                                         free;
    std::vector<std::unique_ptr<const ContactLaw>> obstacles;
    std::vector<NodeLaw>                           laws;

    Problem(std::mt19937 &generator, const bool is_moderate)
    {
      std::uniform_real_distribution<double> uniform(-1., 1.);
      const auto ten_to = [&](const double low, const double high) {
        return std::pow(10.,
                        low + 0.5 * (1. + uniform(generator)) * (high - low));
      };
      const unsigned int sizes[]     = {1, 2, 3, 5, 10, 30};
      const double       exponents[] = {1.2, 1.5, 2., 3., 6.};
      const unsigned int n           = sizes[generator() % 6];
      W.reinit(n, n);
      const double size  = ten_to(-4., 4.),
                   ridge = is_moderate ? 1. : ten_to(-4., 0.);
      if (generator() % 2)
        {
          FullMatrix<double> A(n, n);
          for (unsigned int i = 0; i < n; ++i)
            for (unsigned int j = 0; j < n; ++j)
              A(i, j) = uniform(generator);
          A.Tmmult(W, A);
        }
      else
        for (unsigned int i = 0; i < n; ++i)
          for (unsigned int j = 0; j < n; ++j)
            W(i, j) = std::exp(-5. * std::abs(double(i) - j) / n);
      for (unsigned int i = 0; i < n; ++i)
        W(i, i) += ridge;
      W *= size;
      const double scale = std::sqrt(size) * ten_to(-3., 3.);
      for (unsigned int i = 0; i < n; ++i)
        {
          free.push_back(scale * uniform(generator));
          const double eps = W(i, i) * ten_to(is_moderate ? -4. : -10., 6.);
          const unsigned int kind = generator() % 5;
          obstacles.push_back(
            kind == 0 ? rigid() :
            kind == 1 ? linear(eps) :
            kind == 2 ? contact_law("none").make({}) :
            kind == 3 ? contact_law("power law")
                          .make({{"Compliance", eps},
                                 {"Exponent", exponents[generator() % 5]},
                                 {"Damping", 0.},
                                 {"Dashpot", 0.}}) :
            i % 2 ? linear(eps, ten_to(-2., 2.) / scale) :
                    linear(eps, 0., ten_to(-2., 2.) / W(i, i)));
          laws.emplace_back(*obstacles.back());
          NodeLaw &law = laws.back();
          if (kind == 4)
            law = damped(*obstacles.back(),
                         scale * uniform(generator),
                         ten_to(-3., 0.));
          if (generator() % 3 == 0)
            law.play = scale * (1.01 + uniform(generator));
          else if (generator() % 9 == 0 && kind != 2)
            law.is_held = true;
        }
    }
  };

  /** Pressure of the law at x, where it is a function; no resolvent is used. */
  double
  pressure_at(const NodeLaw &law, const double x)
  {
    const double s = law.position(x);
    if (law.is_held && s < 0.)
      return law.is_in_velocity ?
               -law.law->pressure(-s) *
                   std::max(0., 1. - law.law->damping() * law.start / law.tau) +
                 law.law->dashpot() * x :
               -law.law->pressure(-s);
    const double v = law.is_in_velocity ? x : 0.;
    if (law.is_held)
      return law.is_in_velocity && law.law->dashpot() > 0. ?
               law.law->pressure(s) + law.law->dashpot() * v :
               law.law->damped_pressure(s, v);
    return law.law->damped_pressure(s, v) -
           law.law->damped_pressure(-s - law.play, -v);
  }

  /** How far (x, p) is from the graph, in units of x; r steepens p. */
  double
  distance_to_graph(const NodeLaw &law,
                    const double   x,
                    const double   p,
                    const double   r)
  {
    if (law.law->is_rigid())
      return law.is_held ? std::abs(x) :
             p > 0.      ? std::abs(x) :
             p < 0.      ? std::abs(-x - law.play) :
                           std::max({x, -x - law.play, 0.});
    const double direct = r * std::abs(p - pressure_at(law, x));
    if (law.is_in_velocity || p == 0. || !law.law->is_active())
      return direct;
    return std::min(direct, std::abs(law.position_of_pressure(p) - x));
  }

  double
  miss(const Problem &problem, const Values &p)
  {
    double largest = 0., scale = 0.;
    for (unsigned int i = 0; i < p.size(); ++i)
      {
        double loss = 0.;
        for (unsigned int j = 0; j < p.size(); ++j)
          {
            loss += problem.W(i, j) * p[j];
            scale = std::max(scale, std::abs(problem.W(i, j) * p[j]));
          }
        scale = std::max({scale, std::abs(problem.free[i]), std::abs(loss)});
        const double x = problem.free[i] - loss;
        double       distance =
          distance_to_graph(problem.laws[i], x, p[i], problem.W(i, i));
        if (problem.laws[i].is_in_velocity) // the rounding of x, as steep as p
          for (const double h : {1e-12 * scale, -1e-12 * scale})
            {
              const double a = pressure_at(problem.laws[i], x + h);
              const double b = pressure_at(problem.laws[i], x - h);
              if (std::min(a, b) <= p[i] && p[i] <= std::max(a, b))
                distance = std::min(distance, std::abs(h));
            }
        raise(largest, distance);
      }
    return scale == 0. ? largest : largest / scale;
  }

  void
  test_random()
  {
    std::mt19937                           generator(11);
    std::uniform_real_distribution<double> uniform(-1., 1.);
    double                                 worst = 0., change = 0.;
    unsigned int                           n_front = 0, n_rear = 0, n_open = 0;
    for (unsigned int k = 0; k < 1000; ++k)
      {
        const Problem    problem(generator, false);
        InterfaceProblem solver;
        Values           p(problem.laws.size(), 0.), other(p);
        for (unsigned int i = 0; i < p.size(); ++i)
          other[i] = problem.free[i] / problem.W(i, i) * uniform(generator);
        solver.solve(problem.W, problem.laws, problem.free, p);
        solver.solve(problem.W, problem.laws, problem.free, other);
        raise(worst, miss(problem, p));
        raise(worst, miss(problem, other));
        double largest = 0.;
        for (const double q : p)
          raise(largest, std::abs(q));
        for (unsigned int i = 0; i < p.size(); ++i)
          {
            if (largest > 0.)
              raise(change, std::abs(p[i] - other[i]) / largest);
            ++(p[i] > 0. ? n_front : p[i] < 0. ? n_rear : n_open);
          }
      }
    deallog << "random problems: nodes pushed from both sides and open "
            << (n_front > 1000 && n_rear > 300 && n_open > 1000)
            << ", on the graph of their laws " << within(worst, 1e-11)
            << ", from another start the same " << within(change, 1e-7)
            << std::endl;
  }

  void
  test_slopes()
  {
    const auto power = contact_law("power law")
                         .make({{"Compliance", 0.3},
                                {"Exponent", 2.},
                                {"Damping", 0.},
                                {"Dashpot", 0.}});
    const auto soft = linear(0.4), wall = rigid(), lossy = linear(0.4, 2.),
               buffer         = linear(0.4, 2., 3.);
    std::vector<NodeLaw> laws = {NodeLaw(*power),
                                 NodeLaw(*soft),
                                 NodeLaw(*wall),
                                 damped(*lossy, -0.2, 0.5),
                                 damped(*buffer, -0.2, 0.5),
                                 damped(*buffer, 0.2, 0.5, true)};
    NodeLaw              two(*power);
    two.play        = 0.1;
    NodeLaw means   = NodeLaw(*power);
    means.mean_from = 0.3;
    laws.push_back(two);
    laws.push_back(means);
    double worst = 0.;
    for (const NodeLaw &law : laws)
      for (const double z : {0.7, 1.3, -0.8})
        {
          const double h = 1e-5, r = 0.6;
          const double slope =
            (law.resolve(z + h, r).pressure - law.resolve(z - h, r).pressure) /
            (2. * h);
          raise(worst, std::abs(slope - law.resolve(z, r).tangent.slope(r)));
        }
    deallog << "slopes " << noise_within(worst, 1e-5) << std::endl;
  }

  /** Linear systems for laws that are straight lines, by the matrix W. */
  class DenseBody : public InterfaceOperator
  {
  public:
    explicit DenseBody(const Problem &problem)
      : problem(problem)
    {}

    void
    solve(const std::vector<AffineLaw> &laws,
          const bool,
          Values &position,
          Values &pressure) override
    {
      const unsigned int     n = laws.size();
      FullMatrix<double>     matrix(n, n);
      dealii::Vector<double> rhs(n), p(n);
      for (unsigned int i = 0; i < n; ++i)
        if (laws[i].is_open())
          matrix(i, i) = 1.;
        else
          {
            for (unsigned int j = 0; j < n; ++j)
              matrix(i, j) = laws[j].is_open() ? 0. : problem.W(i, j);
            matrix(i, i) += laws[i].compliance;
            rhs(i) = problem.free[i] - laws[i].offset;
          }
      matrix.gauss_jordan();
      matrix.vmult(p, rhs);
      position = problem.free;
      pressure.assign(p.begin(), p.end());
      for (unsigned int i = 0; i < n; ++i)
        for (unsigned int j = 0; j < n; ++j)
          position[i] -= problem.W(i, j) * p(j);
    }

  private:
    const Problem &problem;
  };

  void
  test_tangents()
  {
    std::mt19937 generator(12);
    double       worst = 0.;
    unsigned int most = 0, of_held = 0;
    for (unsigned int k = 0; k < 300; ++k)
      {
        Problem problem(generator, true);
        Values  p(problem.laws.size(), 0.), q(p), x(problem.free), r;
        bool    is_held = k >= 200;
        for (unsigned int i = 0; i < p.size(); ++i)
          {
            problem.laws[i].is_held |= k >= 200;
            is_held &= problem.obstacles[i]->is_linear();
            r.push_back(problem.W(i, i));
          }
        InterfaceProblem().solve(problem.W, problem.laws, problem.free, p);
        DenseBody          body(problem);
        const unsigned int n_sets =
          solve_by_tangents(body, problem.laws, r, 1e-10, x, q);
        unsigned int &sets = is_held ? of_held : most;
        sets               = std::max(sets, n_sets);
        double largest     = 0.;
        for (unsigned int i = 0; i < p.size(); ++i)
          largest = std::max(
            {largest, std::abs(r[i] * p[i]), std::abs(problem.free[i])});
        for (unsigned int i = 0; i < p.size(); ++i)
          raise(worst, r[i] * std::abs(p[i] - q[i]) / largest);
      }
    deallog << "by tangents: the same to 1e-7 " << within(worst, 1e-7)
            << ", at most 20 systems " << (most <= 20) << ", of held nodes "
            << of_held << std::endl;
  }

  void
  test_failures()
  {
    std::mt19937 generator(1);
    Problem      problem(generator, true);
    const auto   wall = rigid();
    problem.W.reinit(2, 2);
    problem.W(0, 0) = problem.W(1, 1) = 1.;
    problem.W(0, 1) = problem.W(1, 0) = -2.;
    problem.free                      = {1., 1.};
    problem.laws.assign(2, NodeLaw(*wall));
    Values    p(2, 0.), x(problem.free);
    DenseBody body(problem);
    for (const bool by_tangents : {false, true})
      try
        {
          if (by_tangents)
            solve_by_tangents(body, problem.laws, {1., 1.}, 1e-10, x, p);
          else
            InterfaceProblem().solve(problem.W, problem.laws, problem.free, p);
          deallog << "solved" << std::endl;
        }
      catch (const ComputationError &error)
        {
          deallog << error.what() << std::endl;
        }
  }
} // namespace

void
main_interface_problem()
{
  initlog();
  test_one_node();
  test_two_nodes();
  test_random();
  test_slopes();
  test_tangents();
  test_failures();
}
