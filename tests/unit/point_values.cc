// SPDX-License-Identifier: LGPL-2.1-or-later
//
// Values at points against the functions that were interpolated, each rank
// alone (MPI_COMM_SELF) and both together, in the interior of cells, on
// vertices, faces and ends, on a graded mesh.
//
// 1. Polynomials of the space, degree p in each direction, are represented
//    exactly, and so are their derivatives: with y the sum of the other
//    coordinates (one at a time),
//      theta = 1 + 2 x^p,  u_x = x^p (1 + y),  v_x = 3 x,  u_y = v_y = y,
//    so that sigma_xx = (lambda + 2 mu) (p x^(p-1) (1 + y) + 3 zeta)
//      + lambda (dim - 1) (1 + zeta) - a theta, lambda + 2 mu = 1.
// 2. u = |x - 1/2| with a vertex at 1/2: sigma_xx = -1 and 1 in the cells to
//    the left and right, 0 as their mean.
// 3. Fields that the scene does not have are NaN, and so is the velocity of a
//    static scene at t = 0. The value at a node is the nodal value to the last
//    digit.
// 4. With the mass of a cell at its middle, four cells and the nodal
//    velocities 1, -1, 3, -5, 7: nodes inside have half of their own and
//    a quarter of each neighbour's, -1/2 + 1/4 + 3/4 = 1/2, 0 and 0, the
//    right end its own, 7; the left end 1/4 if it is moved by t/4, 0 if it is
//    held. Free, with 3 in the place of -1, it has (1 + 3)/2 = 2, and behind it
//    are 3/2 + 1/4 + 3/4 = 5/2, 3/2 + 3/4 - 5/4 = 1, 0 and 7.
// 5. Places on the axis: p + 1 per cell, from 0 to 1, each cell beginning where
//    the last one ends.

#include <thermocontact/space/point_values.h>

#include <deal.II/base/function.h>
#include <deal.II/base/mpi.h>

#include <deal.II/numerics/vector_tools.h>

#include <cmath>
#include <functional>

#include "../tests.h"

using namespace ThermoContact;

namespace
{
  using ThermoContact::Vector;

  /** Component c of @p values is that of temperature, displacement. */
  template <int dim>
  class Fields : public Function<dim>
  {
  public:
    using Values =
      std::function<double(const Point<dim> &, const unsigned int)>;

    Fields(const unsigned int n_components, const Values &values)
      : Function<dim>(n_components)
      , values(values)
    {}

    double
    value(const Point<dim> &point, const unsigned int c) const override
    {
      return values(point, c);
    }

  private:
    const Values values;
  };



  /** 0: temperature, 1 ... dim: displacement; for the fields of the scene. */
  template <int dim>
  void
  set_fields(const Discretization<dim>          &space,
             const typename Fields<dim>::Values &values,
             Vector                             &temperature,
             Vector                             &displacement)
  {
    const unsigned int skip   = space.has_field(Field::temperature) ? 0 : 1;
    auto               system = space.make_system_vector();
    VectorTools::interpolate(space.mapping(),
                             space.dof_handler(),
                             Fields<dim>(space.n_components(),
                                         [&](const Point<dim>  &point,
                                             const unsigned int c) {
                                           return values(point, c + skip);
                                         }),
                             system);
    space.split(system, temperature, displacement);
  }



  template <int dim>
  double
  sum_across(const Point<dim> &point)
  {
    double sum = 0.;
    for (unsigned int d = 1; d < dim; ++d)
      sum += point[d];
    return sum;
  }



  template <int dim>
  Parameters
  make_parameters(const unsigned int degree)
  {
    Parameters parameters;
    parameters.dimension           = dim;
    parameters.mesh.degree         = degree;
    parameters.mesh.cells          = 4;
    parameters.mesh.grading        = 0.3;
    parameters.mesh.cells_across   = 2;
    parameters.mesh.width          = 0.5;
    parameters.model.poisson_ratio = dim == 1 ? 0. : 0.3;
    return parameters;
  }



  template <int dim>
  double
  polynomial_error(const unsigned int degree,
                   const std::string &fields,
                   const MPI_Comm     communicator)
  {
    Parameters parameters   = make_parameters<dim>(degree);
    parameters.model.fields = fields;
    const Scene               scene(parameters);
    const Discretization<dim> space(scene, communicator);
    const double              p = degree;

    State  state = space.make_state();
    Vector unused(state.temperature);
    set_fields<dim>(
      space,
      [p](const Point<dim> &x, const unsigned int c) {
        return c == 0 ? 1. + 2. * std::pow(x[0], p) :
               c == 1 ? std::pow(x[0], p) * (1. + sum_across(x)) :
                        x[c - 1];
      },
      state.temperature,
      state.displacement);
    set_fields<dim>(
      space,
      [](const Point<dim> &x, const unsigned int c) {
        return c == 1 ? 3. * x[0] : x[c == 0 ? 0 : c - 1];
      },
      unused,
      state.velocity);

    std::vector<Place<dim>> places = places_on_axis(space);
    for (const double x : {0., 0.123, 0.5, 0.9, 1.})
      for (const double y : {0., 0.1, 0.25, 0.5})
        {
          Point<dim> point;
          for (unsigned int d = 0; d < dim; ++d)
            point[d] = d == 0 ? x : y;
          places.push_back({point, point});
        }
    PointValues<dim> point_values(scene, space, places);
    const auto      &values = point_values.evaluate(state);

    const double nu = parameters.model.poisson_ratio, lambda = nu / (1. - nu),
                 zeta = parameters.model.viscosity,
                 a    = scene.material.thermal_stress;
    double error      = 0.;
    for (unsigned int i = 0; i < places.size(); ++i)
      {
        const double x = places[i].position[0], xp = std::pow(x, p),
                     y           = sum_across(places[i].position);
        const double expected[4] = {1. + 2. * xp,
                                    xp * (1. + y),
                                    3. * x,
                                    p * std::pow(x, p - 1.) * (1. + y) +
                                      3. * zeta +
                                      lambda * (dim - 1) * (1. + zeta) -
                                      a * (1. + 2. * xp)};
        for (unsigned int f = 0; f < 4; ++f)
          {
            const double value = values[f * places.size() + i];
            if (space.has_field(f == 0 ? Field::temperature :
                                         Field::displacement))
              raise(error, std::abs(value - expected[f]));
            else if (!std::isnan(value))
              error = 1.;
          }
      }
    return Utilities::MPI::max(error, MPI_COMM_WORLD);
  }



  template <int dim>
  void
  test_polynomials(const std::string &fields)
  {
    for (const unsigned int degree : {1, 2, 3})
      deallog << dim << "-D, " << fields << ", degree " << degree
              << ": exact on one rank "
              << within(polynomial_error<dim>(degree, fields, MPI_COMM_SELF),
                        1e-12)
              << ", on two "
              << within(polynomial_error<dim>(degree, fields, MPI_COMM_WORLD),
                        1e-12)
              << std::endl;
  }



  template <int dim>
  void
  test_kink(const MPI_Comm communicator)
  {
    Parameters parameters   = make_parameters<dim>(2);
    parameters.mesh.grading = 1.;
    parameters.model.fields = "displacement";
    const Scene               scene(parameters);
    const Discretization<dim> space(scene, communicator);
    State                     state = space.make_state();
    set_fields<dim>(
      space,
      [](const Point<dim> &x, const unsigned int c) {
        return c == 1 ? std::abs(x[0] - 0.5) : 0.;
      },
      state.temperature,
      state.displacement);

    std::vector<Place<dim>> places(3);
    for (unsigned int i = 0; i < 3; ++i)
      for (unsigned int d = 0; d < dim; ++d)
        {
          places[i].position[d]   = d == 0 ? 0.5 : 0.25;
          places[i].cell_point[d] = d == 0 ? 0.4 + 0.1 * i : 0.25;
        }
    PointValues<dim> point_values(scene, space, places);
    const auto      &values = point_values.evaluate(state);
    deallog << dim << "-D, stress left of a kink, mean, right:";
    for (unsigned int i = 0; i < 3; ++i)
      deallog << ' ' << std::lround(1e12 * values[9 + i]) * 1e-12;
    deallog << std::endl;
  }



  void
  test_details(const MPI_Comm communicator)
  {
    Parameters parameters      = make_parameters<1>(4);
    parameters.model.inertia   = 0.;
    parameters.model.viscosity = 0.;
    const Scene             scene(parameters);
    const Discretization<1> space(scene, communicator);
    State                   state = space.make_state();
    const auto              f = [](const Point<1> &x, const unsigned int c) {
      return std::exp(x[0]) / (3. + c);
    };
    set_fields<1>(space, f, state.temperature, state.displacement);
    state.velocity = state.displacement;

    const double   inner = space.dof_handler().begin()->vertex(1)[0];
    PointValues<1> point_values(scene,
                                space,
                                {{Point<1>(inner), Point<1>(inner)},
                                 {Point<1>(1.), Point<1>(1.)}});
    auto           values = point_values.evaluate(state);
    const bool     is_exact =
      values[0] == f(Point<1>(inner), 0) && values[1] == f(Point<1>(1.), 0) &&
      values[2] == f(Point<1>(inner), 1) && values[3] == f(Point<1>(1.), 1);
    const bool is_nan = std::isnan(values[4]) && std::isnan(values[5]);
    state.time        = 1.;
    values            = point_values.evaluate(state);
    deallog << "nodal values to the last digit " << is_exact
            << ", no velocity at the start of a static scene " << is_nan
            << ", later " << (values[4] == values[2]) << std::endl;
  }



  void
  test_velocities_of_cells(const std::string         &support,
                           const std::string         &displacement,
                           const std::vector<double> &velocities)
  {
    Parameters parameters                 = make_parameters<1>(1);
    parameters.time.scheme                = "box";
    parameters.mesh.grading               = 1.;
    parameters.model.fields               = "displacement";
    parameters.boundary.left.support      = support;
    parameters.boundary.left.displacement = displacement;
    const Scene             scene(parameters);
    const Discretization<1> space(scene, MPI_COMM_SELF);
    State                   state = space.make_state();
    std::copy(velocities.begin(), velocities.end(), state.velocity.begin());
    std::vector<Place<1>> places;
    for (unsigned int i = 0; i < velocities.size(); ++i)
      places.push_back({Point<1>(0.25 * i), Point<1>(0.25 * i)});
    PointValues<1> point_values(scene, space, places);
    const auto    &values = point_values.evaluate(state);
    deallog << "mass at the middle of cells, end " << support
            << ", u = " << displacement << ": velocities";
    for (unsigned int i = 0; i < places.size(); ++i)
      deallog << ' ' << values[PointValues<1>::velocity * places.size() + i];
    deallog << std::endl;
  }



  template <int dim>
  void
  test_axis(const unsigned int cells_across)
  {
    Parameters parameters        = make_parameters<dim>(3);
    parameters.mesh.cells_across = cells_across;
    parameters.mesh.refinements  = 1;
    const Scene               scene(parameters);
    const Discretization<dim> space(scene, MPI_COMM_WORLD);
    const auto                places     = places_on_axis(space);
    double                    hole       = 0.;
    unsigned int              n_standing = 0;
    for (unsigned int i = 1; i < places.size(); ++i)
      {
        const double step = places[i].position[0] - places[i - 1].position[0];
        if (i % 4 == 0)
          raise(hole, std::abs(step));
        else
          n_standing += !(step > 0.);
      }
    deallog << dim << "-D, " << cells_across
            << " cells across, places on the axis " << places.size()
            << ", from " << places.front().position[0] << " to "
            << places.back().position[0] << ", holes " << within(hole, 0.)
            << ", not behind the last one " << n_standing << std::endl;
  }
} // namespace



void
main_point_values()
{
  if (Utilities::MPI::this_mpi_process(MPI_COMM_WORLD) == 0)
    {
      initlog();
      deallog << "ranks " << Utilities::MPI::n_mpi_processes(MPI_COMM_WORLD)
              << std::endl;
    }
  else
    deallog.depth_console(0);

  test_polynomials<1>("temperature and displacement");
  test_polynomials<1>("temperature");
  test_polynomials<1>("displacement");
  test_polynomials<2>("temperature and displacement");
  test_polynomials<2>("displacement");
  test_polynomials<3>("temperature and displacement");
  for (const MPI_Comm communicator : {MPI_COMM_SELF, MPI_COMM_WORLD})
    {
      test_kink<1>(communicator);
      test_kink<2>(communicator);
      test_kink<3>(communicator);
      test_details(communicator);
    }
  test_velocities_of_cells("clamped", "t/4", {1., -1., 3., -5., 7.});
  test_velocities_of_cells("clamped", "0", {1., -1., 3., -5., 7.});
  test_velocities_of_cells("free", "0", {1., 3., 3., -5., 7.});
  test_axis<1>(1);
  test_axis<2>(2);
  test_axis<2>(3);
  test_axis<3>(2);
}
