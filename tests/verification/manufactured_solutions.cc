// SPDX-License-Identifier: LGPL-2.1-or-later
//
// Orders of convergence of backward Euler on manufactured solutions. With
// amplitudes alpha(t), beta(t) and, along the axis, phi = sin 2x and
// psi = e^x - 1, which vanish at the fixed end,
//   theta = theta_A + alpha phi cos(kappa y),
//   u     = beta psi (cos(kappa y), r sin(kappa y)),   r = kappa (1 - 1/e).
// In 1-D kappa = r = 0. In 2-D the width is 1 and kappa = pi: u_y = 0, no
// shear stress and no heat flux at y = 0, 1; no shear stress at x = 1 either,
// since r psi'(1) = kappa (1 - 1/e) e = kappa psi(1).
//
// Sources. psi'' = psi', and lambda + 2 mu = 1. From the strains
//   e_xx = beta psi' cos,  e_yy = beta r kappa psi cos,
//   2 e_xy = beta (r psi' - kappa psi) sin
// the elastic stresses s = C e are
//   s_xx = beta (psi' + lambda r kappa psi) cos,
//   s_yy = beta (lambda psi' + r kappa psi) cos,
//   s_xy = beta mu (r psi' - kappa psi) sin,
// and their divergence is
//   x: beta ((1 + (lambda + mu) r kappa) psi' - mu kappa^2 psi) cos,
//   y: beta ((mu r - (lambda + mu) kappa) psi' - r kappa^2 psi) sin.
// Viscosity turns the factor beta into delta = beta + zeta beta_t. With
// grad theta = alpha (phi' cos, -kappa phi sin), doc/model.md (M1.1)-(M1.4) say
//   q   = (alpha_t phi - alpha (phi'' - kappa^2 phi)
//          + a beta_t (psi' + r kappa psi)) cos,
//   f_x = (b beta_tt psi - delta ((1 + (lambda + mu) r kappa) psi'
//          - mu kappa^2 psi) + a alpha phi') cos,
//   f_y = (b beta_tt r psi - delta ((mu r - (lambda + mu) kappa) psi'
//          - r kappa^2 psi) - a alpha kappa phi) sin,
//   t   = delta (psi' + lambda r kappa psi) cos - a theta + [u_x - g]_+/eps,
//   h   = alpha phi' cos + k (theta - theta_obs), the last two at x = 1.
//
// 1. Order in h: alpha = 1 + t, beta = 1/2 + t. Backward Euler is exact in
//    time, since beta_tt = 0 and the initial velocity is beta_t psi. Expected
//    at t = 1/2: p + 1 in L2, p in the H1 seminorm, also where the obstacle is
//    met: the end of the rod moves from u(1) = 0.859 to 1.718 and touches
//    throughout for g = 0.1, never for g = 10. In 2-D u_x(1,y) has both signs,
//    so that a part of the nodes is in contact, and the part grows.
// 2. Order in dt: alpha = e^-t, beta = 1/2 + sin t, on a mesh whose error is
//    far below. Expected at t = 0.7: 1.
// Orders are those between two meshes or steps, one half of the other; an
// order within 0.05 of an integer is printed as that integer.

#include <thermocontact/simulation/simulation.h>

#include <deal.II/base/function_parser.h>
#include <deal.II/base/mpi.h>
#include <deal.II/base/quadrature_lib.h>

#include <deal.II/numerics/vector_tools_integrate_difference.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <iomanip>
#include <map>
#include <regex>
#include <sstream>

#include "../tests.h"

using namespace ThermoContact;

namespace
{
  /** Expressions in t of the amplitudes and of their derivatives. */
  struct Amplitudes
  {
    std::string alpha, alpha_t, beta, beta_t, beta_tt;
  };

  const Amplitudes linear = {"1+t", "1", "1/2+t", "1", "0"};
  const Amplitudes smooth = {"exp(-t)",
                             "-exp(-t)",
                             "1/2+sin(t)",
                             "cos(t)",
                             "-sin(t)"};

  template <int dim>
  const double wave_number = dim == 1 ? 0. : numbers::PI; // kappa

  template <int dim>
  const double lateral_ratio = (1. - std::exp(-1.)) * wave_number<dim>; // r



  template <int dim>
  class ExactSolution : public Function<dim>
  {
  public:
    ExactSolution(const Amplitudes &amplitudes,
                  const double      theta_A,
                  const double      time)
      : Function<dim>(1 + dim)
      , theta_A(theta_A)
    {
      FunctionParser<1> parser(2);
      parser.initialize("t", amplitudes.alpha + ";" + amplitudes.beta, {});
      factors = {{parser.value(Point<1>(time), 0),
                  parser.value(Point<1>(time), 1),
                  parser.value(Point<1>(time), 1) * lateral_ratio<dim>}};
    }

    double
    value(const Point<dim> &point, const unsigned int c) const override
    {
      const double x = point[0], y = wave_number<dim> * point[dim - 1];
      return (c == 0 ? theta_A : 0.) +
             factors[c] * (c == 0 ? std::sin(2. * x) : std::expm1(x)) *
               (c < 2 ? std::cos(y) : std::sin(y));
    }

    Tensor<1, dim>
    gradient(const Point<dim> &point, const unsigned int c) const override
    {
      const double   x = point[0], y = wave_number<dim> * point[dim - 1];
      Tensor<1, dim> result;
      result[dim - 1] = factors[c] * wave_number<dim> *
                        (c == 0 ? std::sin(2. * x) : std::expm1(x)) *
                        (c < 2 ? -std::sin(y) : std::cos(y));
      result[0] = factors[c] * (c == 0 ? 2. * std::cos(2. * x) : std::exp(x)) *
                  (c < 2 ? std::cos(y) : std::sin(y));
      return result;
    }

  private:
    const double          theta_A;
    std::array<double, 3> factors; ///< alpha, beta, beta r
  };



  /** A number as an expression. */
  std::string
  text(const double value)
  {
    std::ostringstream stream;
    stream << std::setprecision(17) << value;
    return stream.str();
  }



  /** Replaces the symbols of the comment on top by expressions in x, y, t. */
  template <int dim>
  std::string
  expand(std::string       formula,
         const Amplitudes &amplitudes,
         const Parameters &parameters)
  {
    const double nu = parameters.model.poisson_ratio;
    const std::map<std::string, std::string> meaning = {
      {"b", text(parameters.model.inertia)},
      {"zeta", text(parameters.model.viscosity)},
      {"a", text(parameters.model.coupling)},
      {"lambda", text(nu / (1. - nu))},
      {"mu", text(0.5 * (1. - 2. * nu) / (1. - nu))},
      {"k", text(parameters.boundary.right.heat_exchange)},
      {"theta_obs", text(parameters.boundary.right.surroundings)},
      {"eps", text(parameters.contact.law.at("Compliance"))},
      {"g", text(parameters.contact.gap)},
      {"kappa", text(wave_number<dim>)},
      {"r", text(lateral_ratio<dim>)},
      {"alpha", amplitudes.alpha},
      {"alpha_t", amplitudes.alpha_t},
      {"beta", amplitudes.beta},
      {"beta_t", amplitudes.beta_t},
      {"beta_tt", amplitudes.beta_tt},
      {"phi", "sin(2*x)"},
      {"phi_x", "2*cos(2*x)"},
      {"phi_xx", "-4*sin(2*x)"},
      {"psi", "exp(x)-1"},
      {"psi_x", "exp(x)"},
      {"cos_y", dim == 1 ? "1" : "cos(pi*y)"},
      {"sin_y", dim == 1 ? "0" : "sin(pi*y)"}};
    for (const auto &[symbol, expression] : meaning)
      {
        const std::regex word("\\b" + symbol + "\\b");
        formula = std::regex_replace(formula, word, "(" + expression + ")");
      }
    return formula;
  }



  /** Sets initial values and sources. */
  template <int dim>
  void
  set_data(const Amplitudes &amplitudes, Parameters &parameters)
  {
    const auto expression = [&](const std::string &formula) {
      return expand<dim>(formula, amplitudes, parameters);
    };
    const auto initial = [&](const std::string &formula) {
      const std::regex time_symbol("\\bt\\b");
      return std::regex_replace(expression(formula), time_symbol, "0");
    };
    const auto vector = [](const std::string &axial,
                           const std::string &lateral) {
      return dim == 1 ? axial : axial + ";" + lateral;
    };
    const std::string theta = "(theta_A+alpha*phi*cos_y)";
    const std::string delta = "(beta+zeta*beta_t)";

    parameters.initial_values.temperature = initial(theta);
    parameters.initial_values.displacement =
      vector(initial("beta*psi*cos_y"), initial("beta*r*psi*sin_y"));
    parameters.initial_values.velocity =
      vector(initial("beta_t*psi*cos_y"), initial("beta_t*r*psi*sin_y"));

    parameters.sources.heat_source =
      expression("(alpha_t*phi-alpha*(phi_xx-kappa^2*phi)"
                 "+a*beta_t*(psi_x+r*kappa*psi))*cos_y");
    parameters.sources.body_force =
      vector(expression("(b*beta_tt*psi-" + delta +
                        "*((1+(lambda+mu)*r*kappa)*psi_x-mu*kappa^2*psi)"
                        "+a*alpha*phi_x)*cos_y"),
             expression("(b*beta_tt*r*psi-" + delta +
                        "*((mu*r-(lambda+mu)*kappa)*psi_x-r*kappa^2*psi)"
                        "-a*alpha*kappa*phi)*sin_y"));
    parameters.boundary.right.traction =
      expression(delta + "*(psi_x+lambda*r*kappa*psi)*cos_y-a*" + theta +
                 "+max(beta*psi*cos_y-g,0)/eps");
    parameters.boundary.right.heat_flux =
      expression("alpha*phi_x*cos_y+k*(" + theta + "-theta_obs)");
  }



  /** A square of @p cells x @p cells in 2-D. */
  struct Resolution
  {
    unsigned int degree, cells, n_steps;
  };

  struct Result
  {
    double temperature_L2, temperature_H1, displacement_L2, displacement_H1;
    double pressure;
    std::string contact; ///< in words
  };



  template <int dim>
  Result
  compute_errors(const Simulation<dim> &simulation,
                 const Amplitudes      &amplitudes)
  {
    const Discretization<dim> &discretization = simulation.discretization();
    const State               &state          = simulation.state();
    const Parameters          &parameters     = simulation.parameters();
    auto                       solution = discretization.make_system_vector();
    discretization.join(state.temperature, state.displacement, solution);
    const ExactSolution<dim> exact(amplitudes,
                                   parameters.boundary.left.temperature,
                                   state.time);

    const auto error = [&](const VectorTools::NormType norm,
                           const unsigned int          first,
                           const unsigned int          last) {
      const ComponentSelectFunction<dim> components({first, last}, 1 + dim);
      const QGauss<dim>      quadrature(discretization.degree() + 4);
      dealii::Vector<double> of_cells;
      VectorTools::integrate_difference(discretization.mapping(),
                                        discretization.dof_handler(),
                                        solution,
                                        exact,
                                        of_cells,
                                        quadrature,
                                        norm,
                                        &components);
      return of_cells.l2_norm();
    };
    Point<dim> end; // the first contact node
    end[0]                   = 1.;
    const double penetration = exact.value(end, 1) - parameters.contact.gap;
    return {error(VectorTools::L2_norm, 0, 1),
            error(VectorTools::H1_seminorm, 0, 1),
            error(VectorTools::L2_norm, 1, 1 + dim),
            error(VectorTools::H1_seminorm, 1, 1 + dim),
            std::abs(state.contact.pressure[0] -
                     std::max(penetration, 0.) /
                       parameters.contact.law.at("Compliance")),
            ""};
  }



  /** Runs to @p end_time and returns the errors there. */
  template <int dim>
  Result
  solve(const Amplitudes &amplitudes,
        const double      gap,
        const double      end_time,
        const Resolution &resolution)
  {
    Parameters parameters                   = read_parameters("");
    parameters.dimension                    = dim;
    parameters.model.inertia                = 2.;
    parameters.model.viscosity              = 0.5;
    parameters.model.coupling               = 0.25;
    parameters.model.poisson_ratio          = 0.3;
    parameters.boundary.left.temperature    = 3.;
    parameters.boundary.right.heat_exchange = 2.;
    parameters.boundary.right.surroundings  = 1.;
    parameters.contact.law.at("Compliance") = 0.05;
    parameters.contact.gap                  = gap;
    parameters.mesh.cells                   = resolution.cells;
    parameters.mesh.cells_across            = resolution.cells;
    parameters.mesh.width                   = 1.;
    parameters.mesh.degree                  = resolution.degree;
    parameters.time.scheme                  = "backward euler";
    parameters.time.start                   = "consistent";
    parameters.time.end_time                = end_time;
    parameters.time.step_size               = end_time / resolution.n_steps;
    set_data<dim>(amplitudes, parameters);
    check_scene(parameters);

    Simulation<dim> simulation(parameters, MPI_COMM_SELF);
    unsigned int    n_positive = 0, n_zero = 0;
    const auto      observe = [&](const Simulation<dim> &s) {
      for (const double p : s.state().contact.pressure)
        (p > 0. ? n_positive : n_zero) += 1;
    };
    simulation.run({observe});

    Result result  = compute_errors(simulation, amplitudes);
    result.contact = n_positive == 0 ? "without contact" :
                     n_zero == 0     ? "in contact" :
                                       "in contact in part";
    return result;
  }



  /** The order, as an integer if it is within 0.05 of one. */
  std::string
  order(const double coarse, const double fine)
  {
    const double observed = std::log2(coarse / fine);
    return std::abs(observed - std::round(observed)) <= 0.05 ?
             text(std::round(observed)) :
             text(observed);
  }



  template <int dim>
  void
  check_order_in_space(const double       gap,
                       const unsigned int degree,
                       const unsigned int cells)
  {
    const Result coarse = solve<dim>(linear, gap, 0.5, {degree, cells, 5});
    const Result fine   = solve<dim>(linear, gap, 0.5, {degree, 2 * cells, 5});
    deallog << dim << "-D, degree " << degree << ", " << fine.contact
            << ": temperature L2 "
            << order(coarse.temperature_L2, fine.temperature_L2) << ", H1 "
            << order(coarse.temperature_H1, fine.temperature_H1)
            << "; displacement L2 "
            << order(coarse.displacement_L2, fine.displacement_L2) << ", H1 "
            << order(coarse.displacement_H1, fine.displacement_H1) << std::endl;
  }



  void
  check_order_in_time(const double gap, const unsigned int n_steps)
  {
    const Result coarse = solve<1>(smooth, gap, 0.7, {8, 8, n_steps});
    const Result fine   = solve<1>(smooth, gap, 0.7, {8, 8, 2 * n_steps});
    deallog << fine.contact << ": temperature "
            << order(coarse.temperature_L2, fine.temperature_L2)
            << ", displacement "
            << order(coarse.displacement_L2, fine.displacement_L2);
    if (fine.contact == "in contact")
      deallog << ", contact pressure " << order(coarse.pressure, fine.pressure);
    deallog << std::endl;
  }
} // namespace



void
main_manufactured_solutions()
{
  initlog();

  deallog << "order in h" << std::endl;
  for (const double gap : {10., 0.1})
    for (const unsigned int degree : {1, 2, 3})
      check_order_in_space<1>(gap, degree, 16);
  for (const double gap : {10., 0.1})
    for (const unsigned int degree : {1, 2})
      check_order_in_space<2>(gap, degree, 16);

  deallog << "order in dt" << std::endl;
  for (const double gap : {10., 0.1})
    check_order_in_time(gap, 160);
}
