// SPDX-License-Identifier: LGPL-2.1-or-later
//
// Mesh/Geometry = axisymmetric, a round rod.
//
// Orders of convergence on a manufactured solution. With the radius R = 1/2,
//      psi = X(x) g(r),  X = 1 - cos pi x,  g = r^2/2 - r^6/(6 R^4),
//      u = beta grad psi = beta (X' g, X g'),  theta = theta_A +
//      alpha S (1 + g),  S = sin(pi x/2),
//    there is no displacement at x = 0 (X = X' = 0) and across r = 0 and r = R
//    (g' = r - r^5/R^4), no shear stress 2 mu X' g' there and at x = 1, and no
//    flux of heat at r = R. With g'' + g'/r = h = 2 - 6 r^4/R^4 and D =
//    div grad psi = X'' g + X h the elastic force is div C e(grad psi) = grad
//    D, as lambda + 2 mu = 1 and curl grad = 0. So
//      f = -delta grad D + a alpha grad(S (1 + g)),  delta = beta + zeta
//      beta_t,
//      q = alpha_t S (1 + g) - alpha (S'' (1 + g) + S h) + a beta_t D,
//      t = delta (lambda D + 2 mu X'' g) - a theta + p  and
//      end heat flux k (theta - theta_obs)  at x = 1,
//    where u_x = 0, so that p = -gap/eps. alpha = 1 + t, beta = 1/2 + t:
//    backward Euler is exact in time. Expected: p + 1 in L2, p in the H1
//    seminorm, in the norms with weight r.

#include <thermocontact/simulation/simulation.h>

#include <deal.II/base/mpi.h>
#include <deal.II/base/quadrature_lib.h>

#include <deal.II/numerics/vector_tools_integrate_difference.h>

#include <array>
#include <cmath>
#include <regex>

#include "../tests.h"

using namespace ThermoContact;

namespace
{
  const double radius = 0.5;

  class ExactSolution : public Function<2>
  {
  public:
    explicit ExactSolution(const double time)
      : Function<2>(3)
      , alpha(1. + time)
      , beta(0.5 + time)
    {}

    double
    value(const Point<2> &point, const unsigned int c) const override
    {
      const double x = point[0], r = point[1], pi = numbers::PI;
      const double R4  = std::pow(radius, 4);
      const double g   = r * r / 2. - std::pow(r, 6) / (6. * R4);
      const double g_r = r - std::pow(r, 5) / R4;
      return c == 0 ? 3. + alpha * std::sin(0.5 * pi * x) * (1. + g) :
             c == 1 ? beta * pi * std::sin(pi * x) * g :
                      beta * (1. - std::cos(pi * x)) * g_r;
    }

    Tensor<1, 2>
    gradient(const Point<2> &point, const unsigned int c) const override
    {
      const double x = point[0], r = point[1], pi = numbers::PI;
      const double R4   = std::pow(radius, 4);
      const double g    = r * r / 2. - std::pow(r, 6) / (6. * R4);
      const double g_r  = r - std::pow(r, 5) / R4;
      const double g_rr = 1. - 5. * std::pow(r, 4) / R4;
      Tensor<1, 2> result;
      if (c == 0)
        {
          result[0] = alpha * 0.5 * pi * std::cos(0.5 * pi * x) * (1. + g);
          result[1] = alpha * std::sin(0.5 * pi * x) * g_r;
        }
      else
        {
          const double X = 1. - std::cos(pi * x), X_x = pi * std::sin(pi * x),
                       X_xx = pi * pi * std::cos(pi * x);
          result[0]         = beta * (c == 1 ? X_xx * g : X_x * g_r);
          result[1]         = beta * (c == 1 ? X_x * g_r : X * g_rr);
        }
      return result;
    }

  private:
    const double alpha, beta;
  };



  /** Replaces the symbols of the comment on top by expressions in x, y, t. */
  std::string
  expand(std::string formula)
  {
    const std::vector<std::pair<std::string, std::string>> meaning = {
      {"D_x", "X_xxx*g+X_x*h"},
      {"D_r", "X_xx*g_r-24*X*y^3/R^4"},
      {"D", "X_xx*g+X*h"},
      {"theta", "3+alpha*S*(1+g)"},
      {"delta", "beta+0.5"},
      {"alpha", "1+t"},
      {"beta", "1/2+t"},
      {"a", "0.25"},
      {"lambda", "3/7"},
      {"mu", "2/7"},
      {"X", "1-cos(pi*x)"},
      {"X_x", "pi*sin(pi*x)"},
      {"X_xx", "pi^2*cos(pi*x)"},
      {"X_xxx", "-pi^3*sin(pi*x)"},
      {"S", "sin(pi*x/2)"},
      {"S_x", "pi/2*cos(pi*x/2)"},
      {"S_xx", "-pi^2/4*sin(pi*x/2)"},
      {"g", "y^2/2-y^6/(6*R^4)"},
      {"g_r", "y-y^5/R^4"},
      {"h", "2-6*y^4/R^4"},
      {"R", "0.5"}};
    for (const auto &[symbol, expression] : meaning)
      formula = std::regex_replace(formula,
                                   std::regex("\\b" + symbol + "\\b"),
                                   "(" + expression + ")");
    return formula;
  }



  std::string
  initial(const std::string &formula)
  {
    return std::regex_replace(expand(formula), std::regex("\\bt\\b"), "0");
  }



  std::array<double, 4>
  errors(const unsigned int degree, const unsigned int cells)
  {
    Parameters parameters                   = read_parameters("");
    parameters.dimension                    = 2;
    parameters.model.inertia                = 2.;
    parameters.model.viscosity              = 0.5;
    parameters.model.coupling               = 0.25;
    parameters.model.poisson_ratio          = 0.3;
    parameters.boundary.left.temperature    = 3.;
    parameters.boundary.right.heat_exchange = 2.;
    parameters.boundary.right.surroundings  = 1.;
    parameters.contact.law.at("Compliance") = 0.05;
    parameters.contact.gap                  = -0.1;
    parameters.mesh.geometry                = "axisymmetric";
    parameters.mesh.cells                   = 2 * cells;
    parameters.mesh.cells_across            = cells;
    parameters.mesh.width                   = radius;
    parameters.mesh.degree                  = degree;
    parameters.time.scheme                  = "backward euler";
    parameters.time.start                   = "consistent";
    parameters.time.end_time                = 0.5;
    parameters.time.step_size               = 0.1;
    parameters.initial_values.temperature   = initial("theta");
    parameters.initial_values.displacement =
      initial("beta*X_x*g") + ";" + initial("beta*X*g_r");
    parameters.initial_values.velocity =
      initial("X_x*g") + ";" + initial("X*g_r");
    parameters.sources.heat_source =
      expand("S*(1+g)-alpha*(S_xx*(1+g)+S*h)+a*D");
    parameters.sources.body_force = expand("-delta*D_x+a*alpha*S_x*(1+g)") +
                                    ";" + expand("-delta*D_r+a*alpha*S*g_r");
    parameters.boundary.right.traction =
      expand("delta*(lambda*D+2*mu*X_xx*g)-a*theta+0.1/0.05");
    parameters.boundary.right.heat_flux = expand("2*(theta-1)");
    check_scene(parameters);

    Simulation<2> simulation(parameters, MPI_COMM_SELF);
    simulation.run({});
    const Discretization<2> &space    = simulation.discretization();
    const State             &state    = simulation.state();
    SystemVector             solution = space.make_system_vector();
    space.join(state.temperature, state.displacement, solution);
    const ExactSolution exact(state.time);

    std::array<double, 4> result;
    unsigned int          i = 0;
    for (const auto &[first, last] : {std::pair(0, 1), std::pair(1, 3)})
      for (const auto norm : {VectorTools::L2_norm, VectorTools::H1_seminorm})
        {
          /** The radius, for the components that count. */
          class Weight : public Function<2>
          {
          public:
            Weight(const unsigned int first, const unsigned int last)
              : Function<2>(3)
              , first(first)
              , last(last)
            {}

            double
            value(const Point<2> &point, const unsigned int c) const override
            {
              return c >= first && c < last ? point[1] : 0.;
            }

          private:
            const unsigned int first, last;
          };

          const Weight           weight(first, last);
          dealii::Vector<double> of_cells;
          VectorTools::integrate_difference(space.mapping(),
                                            space.dof_handler(),
                                            solution,
                                            exact,
                                            of_cells,
                                            QGauss<2>(degree + 4),
                                            norm,
                                            &weight);
          result[i++] = of_cells.l2_norm();
        }
    return result;
  }



  void
  check_orders()
  {
    for (const unsigned int degree : {1, 2, 3})
      {
        const unsigned int cells   = degree == 1 ? 16 : degree == 2 ? 6 : 10;
        const auto         coarse  = errors(degree, cells);
        const auto         fine    = errors(degree, 2 * cells);
        const char *const  names[] = {"temperature L2",
                                      "H1",
                                      "displacement L2",
                                      "H1"};
        deallog << "degree " << degree << ": ";
        for (unsigned int i = 0; i < 4; ++i)
          {
            const double order = std::log2(coarse[i] / fine[i]);
            deallog << names[i] << ' '
                    << (std::abs(order - std::round(order)) <= 0.15 ?
                          std::round(order) :
                          order)
                    << (i < 3 ? ", " : "");
          }
        deallog << std::endl;
      }
  }
} // namespace



void
main_round_rod()
{
  initlog();

  check_orders();
}
