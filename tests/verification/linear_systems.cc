// SPDX-License-Identifier: LGPL-2.1-or-later
//
// Linear systems at one instant and the contact nodes that they show, of a
// square of 8 x 8 cells of degree 2, with and without matrices. Each is asked
// for its equations: what is left of K y + N p = r, relative to r, and how far
// pressures are from their laws, relative to the largest of their terms; and
// the answers with matrices and without differ by what both leave.
//
// 1. All rows, (zeta + 1) S and b M_u: an elastic obstacle, p = x^+/0.01, and a
//    rigid one, x <= 0 <= p, x p = 0. The nodes stand on both sides of it at
//    first, some come and some go; none is held.
// 2. The rows of the contact end alone, S and, with the heat of a motion at
//    once, M theta + a D u = 0; the same differentiated, p' = x'/0.01 at nodes
//    in contact. a = 1.

#include <thermocontact/time/equilibrium.h>

#include <algorithm>
#include <cmath>

#include "../tests.h"

#include "../overrides.h"

using namespace ThermoContact;
using ThermoContact::Vector;

namespace
{
  constexpr double epsilon = 0.01;

  const Overrides square{"Dimension=2",
                         "Mesh/Width=1",
                         "Mesh/Degree=2",
                         "Mesh/Cells=8",
                         "Mesh/Cells across=8",
                         "Model/Poisson ratio=0.3",
                         "Model/Coupling=1",
                         "Boundary/sides/Support=free",
                         "Time/Scheme=backward euler",
                         "Time/Start=consistent",
                         "Time/Step size=0.1"};



  struct Answer
  {
    std::vector<double> at_nodes; ///< y
    std::vector<double> pressure;
    double              left   = 0.; ///< of the equations
    double              misfit = 0.; ///< to the laws
  };



  /** A field of forces that any numbering has at the same nodes. */
  Vector
  some_forces(const Body<2> &body)
  {
    Vector      forces = body.discretization.make_vector(Field::displacement);
    const auto &values = body.discretization.nodal_values(Field::displacement);
    for (unsigned int i = 0; i < values.size(); ++i)
      forces.local_element(i) =
        0.01 * std::sin(1. + 5. * values[i].node[0] + 9. * values[i].node[1] +
                        2. * values[i].component);
    body.equations.zero_constrained(Field::displacement, forces);
    return forces;
  }



  std::vector<double>
  some_positions(const Body<2> &body)
  {
    std::vector<double> position;
    for (const auto &node : body.contact_end().nodes())
      position.push_back(0.02 * (node.position[1] - 0.4));
    return position;
  }



  double
  misfit_of_laws(const bool                 is_rigid,
                 const std::vector<double> &x,
                 const std::vector<double> &p)
  {
    double misfit = 0., largest = 0.;
    for (unsigned int i = 0; i < x.size(); ++i)
      {
        const double compliance = is_rigid ? 1. : epsilon;
        largest =
          std::max({largest, std::abs(x[i]), std::abs(compliance * p[i])});
        misfit =
          std::max(misfit,
                   is_rigid ? std::abs(std::max(x[i], -p[i])) :
                              std::abs(epsilon * p[i] - std::max(0., x[i])));
      }
    return misfit / largest;
  }



  Answer
  solve_all(const Overrides &overrides,
            const bool       is_rigid,
            const bool       is_heavy)
  {
    const Scene               scene(read_parameters("", square + overrides));
    const Body<2>             body(scene, MPI_COMM_SELF);
    SolverCounters            counters;
    const SystemCoefficients &matrix =
      is_heavy ? motion_by_inertia : motion_by_stiffness;
    Equilibrium<2>             equilibrium(body, matrix, counters);
    const Vector               forces = some_forces(body);
    Vector                     y(forces), product(forces);
    const std::vector<NodeLaw> laws(body.contact_end().n_nodes(),
                                    NodeLaw(body.law()));
    std::vector<double>        x = some_positions(body);
    Answer                     answer;
    equilibrium.solve(forces, laws, x, 1., y, answer.pressure);

    body.contact_end().get_values(Field::displacement, y, answer.at_nodes);
    for (unsigned int i = 0; i < x.size(); ++i)
      x[i] += answer.at_nodes[i];
    answer.misfit = misfit_of_laws(is_rigid, x, answer.pressure);
    body.equations.product(matrix, Field::displacement, y, product);
    product -= forces;
    body.contact_end().subtract_load(Field::displacement,
                                     answer.pressure,
                                     -1.,
                                     product);
    answer.left = product.l2_norm() / forces.l2_norm();
    return answer;
  }



  /** Of the rows of the contact end, and of heat. */
  double
  left_by_nodes(const Body<2>             &body,
                const Vector              &u,
                const std::vector<double> &pressure,
                const std::vector<double> &load,
                Equilibrium<2>            &nodes)
  {
    const ContactEnd<2> &end = body.contact_end();
    Vector               force(u);
    Vector theta = body.discretization.make_vector(Field::temperature),
           heat(theta);
    nodes.add_heating(u, theta);
    body.equations.stiffness.vmult(force, u);
    body.equations.add_thermal_stress(theta, -1., force);
    std::vector<double> at_nodes;
    end.get_all_values(Field::displacement, force, at_nodes);
    double left = 0., largest = 0.;
    for (unsigned int i = 0; i < load.size(); ++i)
      {
        left    = std::max(left,
                        std::abs(at_nodes[i] - load[i] +
                                 end.nodes()[i].weight * pressure[i]));
        largest = std::max(largest, std::abs(load[i]));
      }
    if (theta.linfty_norm() == 0.)
      return left / largest;
    body.equations.heat_mass.vmult(heat, theta);
    body.equations.add_heating(u, 1., heat);
    body.equations.zero_constrained(Field::temperature, heat);
    Vector sources(theta);
    sources = 0.;
    body.equations.add_heating(u, 1., sources);
    return std::max(left / largest, heat.linfty_norm() / sources.linfty_norm());
  }



  std::array<Answer, 2>
  solve_nodes(const Overrides &overrides, const bool takes_heat)
  {
    const Scene                scene(read_parameters("", square + overrides));
    const Body<2>              body(scene, MPI_COMM_SELF);
    const ContactEnd<2>       &end = body.contact_end();
    SolverCounters             counters;
    Equilibrium<2>             nodes(body,
                         takes_heat ? motion_at_once : motion_without_heat,
                         counters,
                         Equilibrium<2>::Rows::contact_end);
    const std::vector<NodeLaw> laws(end.n_nodes(), NodeLaw(body.law()));
    std::vector<double>        x = some_positions(body), load, rate;
    for (const auto &node : end.all_nodes())
      {
        load.push_back(0.02 * std::cos(7. * node.position[1]));
        rate.push_back(0.02 * std::sin(5. * node.position[1]));
      }
    std::array<Answer, 2> answers;
    Vector forces = body.discretization.make_vector(Field::displacement);
    Vector change(forces);
    end.set_all_values(Field::displacement, load, forces);
    nodes.solve(forces, laws, x, 1., change, answers[0].pressure);
    end.get_all_values(Field::displacement, change, answers[0].at_nodes);
    for (unsigned int i = 0; i < x.size(); ++i)
      x[i] += answers[0].at_nodes[i];
    answers[0].misfit = misfit_of_laws(false, x, answers[0].pressure);
    answers[0].left =
      left_by_nodes(body, change, answers[0].pressure, load, nodes);

    nodes.solve_rates(forces, rate, {}, {}, change);
    end.get_all_values(Field::displacement, change, answers[1].at_nodes);
    for (unsigned int i = 0; i < x.size(); ++i)
      answers[1].pressure.push_back(answers[0].pressure[i] > 0. ?
                                      (rate[i] + answers[1].at_nodes[i]) /
                                        epsilon :
                                      0.);
    answers[1].left =
      left_by_nodes(body, change, answers[1].pressure, load, nodes);
    return answers;
  }



  double
  difference(const std::vector<double> &a, const std::vector<double> &b)
  {
    double largest = 0., found = a.size() == b.size() ? 0. : 1.;
    for (unsigned int i = 0; i < a.size(); ++i)
      {
        largest = std::max(largest, std::abs(a[i]));
        found   = std::max(found, std::abs(a[i] - b[i]));
      }
    return found / largest;
  }



  void
  show(const std::string &name, const std::array<Answer, 2> &answers)
  {
    unsigned int n_closed = 0;
    for (const double p : answers[0].pressure)
      n_closed += p != 0.;
    deallog << name << ": in contact "
            << (n_closed == 0                         ? "none" :
                n_closed < answers[0].pressure.size() ? "some" :
                                                        "all");
    for (const Answer &answer : answers)
      deallog << "; left " << within(answer.left, 1e-9) << ", misfit "
              << within(answer.misfit, 1e-9);
    deallog << "; differences "
            << within(difference(answers[0].at_nodes, answers[1].at_nodes),
                      1e-8)
            << ", "
            << within(difference(answers[0].pressure, answers[1].pressure),
                      1e-8)
            << std::endl;
  }
} // namespace



void
main_linear_systems()
{
  initlog();
  const std::array<Overrides, 2> solvers{
    {{"Solver/Linear solver=direct"}, {"Solver/Linear solver=iterative"}}};
  for (const bool is_heavy : {false, true})
    for (const bool is_rigid : {false, true})
      {
        const Overrides       of_body = is_heavy ?
                                          Overrides{"Contact/Massless nodes=off"} :
                                          Overrides{"Model/Inertia=0"};
        std::array<Answer, 2> answers;
        for (unsigned int i = 0; i < 2; ++i)
          answers[i] =
            solve_all(solvers[i] + of_body +
                        Overrides{is_rigid ? "Contact/Condition=rigid" :
                                             "Contact/Compliance=0.01"},
                      is_rigid,
                      is_heavy);
        show(std::string(is_heavy ? "b M_u" : "(zeta + 1) S") +
               (is_rigid ? ", rigid" : ", elastic"),
             answers);
      }
  for (const bool takes_heat : {false, true})
    {
      const Overrides elastic{"Model/Inertia=0", "Contact/Compliance=0.01"};
      const auto      direct = solve_nodes(solvers[0] + elastic, takes_heat),
                 iterative   = solve_nodes(solvers[1] + elastic, takes_heat);
      const std::string name = takes_heat ? "nodes with heat" : "nodes";
      show(name, {{direct[0], iterative[0]}});
      show(name + ", rates", {{direct[1], iterative[1]}});
    }
}
