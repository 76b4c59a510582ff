// SPDX-License-Identifier: LGPL-2.1-or-later
//
// Bodies in two and three dimensions whose coefficients are expressions,
// doc/model.md (M10.9), against closed forms. nu = 0 unless something else is
// said, sides free, width W.
//
// 1. Bending of a layered beam at rest: u = k (x (y - c), -x^2/2), stress
//    E(y) k (y - c) along x, with c the mean of y by E. E = 1 + 20 |y - 0.03|
//    (W = 0.1): a kink, at which the mesh has a line: with degree 4 the
//    traction at nodes and all products are integrated exactly, without the
//    line errors would be 1e-3. A block with E = 1 + 20 |y - 0.03| likewise.
// 2. A bimetal strip, E = 4 and 1, thermal stress 2 a and a, below and above
//    y = 0.03, at theta = 10: the strain e + k y of a section is that without
//    force and moment, two linear equations. It is free at the right end, where
//    a layer as thick as the strip dies out as exp(-2.1 x/W) at least.
// 3. Heat across two layers, insulated all around: cos(q1 y) and
//    A cos(q2 (W - y)), q = sqrt(s c/K), with A and s by continuity of
//    temperature and heat flux at y = 0.4 W; it decays by exp(-s t).
// 4. Coefficients of x alone, rollers: the rod of section Bodies with the same
//    cells, at every row, with contact, all coefficients, degree 2 and 3. The
//    wave speed is the same everywhere (E = density), so that both meshes are.
//    Without inertia, zeta = 1/2 and four times that in the right half, a
//    traction f = 1/10 starts with v(1) = f/zeta (1/2 + 1/8) = 1/8.
// 5. Layers that are numbers, E = 2, density 2, ...: the scene whose entries of
//    section Model are twice as large, to rounding.
// 6. Everything varies, in x and y, elastic and rigid contact of nodes with and
//    without mass: E + D + N - W is that of the start to 1e-12.
// 7. Mirrored in y, E(W - y), ...: the mirror image.
// 8. Coefficients of the temperature: on rollers the rod with the same ones, at
//    every row, and E + D + N - W that of the start. A strip at rest with free
//    sides, theta = 10 everywhere, pulled by T, E = 1 + theta/10 = 2, a (1 +
//    theta/20) = 1.5 a: two linear equations for its strains.
// 9. Poisson ratios: along a block on rollers the strains are T over the P-wave
//    moduli, Y (1 - nu)/((1 + nu)(1 - 2 nu)), where the Young's modulus Y is
//    the same; layers with free sides whose Y/(1 - nu^2) is the same, Y_0, are
//    all strained by e = T/Y_0, and get thinner by nu/(1 - nu) e. A free block
//    that is heated evenly expands by a (1 - nu)/(1 + nu) theta of the scene's
//    nu, whatever its own, since alpha is the same: 0.3*0.8/1.2.
// 10. The mesh: lines at y = 0.02 and 0.07, at x = 0.3; an oblique jump is
//    doubted; jumps on the faces of the body make no cells. A kink at y = 0.03
//    is one for cells of degree 2, two below it and four above.

#include <thermocontact/space/load_scan.h>
#include <thermocontact/space/point_values.h>

#include <deal.II/base/function.h>

#include <deal.II/numerics/fe_field_function.h>
#include <deal.II/numerics/vector_tools_interpolate.h>

#include <algorithm>
#include <cmath>
#include <memory>

#include "../tests.h"

#include "../recorded_run.h"

using namespace ThermoContact;

namespace
{
  const Overrides elastic = {"Model/Fields=displacement", "Model/Viscosity=0"};

  const Overrides at_rest = {"Model/Inertia=0",
                             "Model/Viscosity=0",
                             "Boundary/left/Support=sliding",
                             "Boundary/right/Support=free",
                             "Boundary/sides/Support=free",
                             "Time/Scheme=sdirk2",
                             "Time/Step size=0.1",
                             "Time/End time=0.1"};



  Overrides
  dimension(const unsigned int dim)
  {
    return {"Dimension=" + std::to_string(dim)};
  }



  /** The axial displacement or another quantity at a place. */
  template <int dim>
  double
  value_at(Simulation<dim>                          &simulation,
           const Point<dim>                         &place,
           const typename PointValues<dim>::Quantity quantity)
  {
    PointValues<dim> values(simulation.body().scene,
                            simulation.body().discretization,
                            {{place, place}});
    return values.evaluate(simulation.state())[quantity];
  }



  /** How much wider a strip is at x = 0.4 than it was. */
  double
  value_across(Simulation<2> &simulation)
  {
    const Discretization<2> &space = simulation.body().discretization;
    const auto all = space.with_ghosts(simulation.state().temperature,
                                       simulation.state().displacement);
    const Functions::FEFieldFunction<2, std::decay_t<decltype(all)>> field(
      space.dof_handler(), all, space.mapping());
    const unsigned int y = space.n_components() - 1;
    return field.value({0.4, 0.1 - 1e-14}, y) - field.value({0.4, 1e-14}, y);
  }



  // ------------------------------------------------------ 1. bending

  template <int dim>
  void
  check_bending()
  {
    // c by Simpson's rule, exact for the parabola E y on both sides of 0.03
    const auto E = [](const double y) { return 1. + 20. * std::abs(y - 0.03); };
    double     force = 0., moment = 0.;
    for (const auto &[begin, end] : {std::pair(0., 0.03), std::pair(0.03, 0.1)})
      for (const auto &[place, weight] : {std::pair(begin, 1.),
                                          std::pair(0.5 * (begin + end), 4.),
                                          std::pair(end, 1.)})
        {
          force += weight * (end - begin) / 6. * E(place);
          moment += weight * (end - begin) / 6. * E(place) * place;
        }
    const double    c = moment / force, k = 0.02;
    const Overrides load = {
      "Boundary/right/Traction=0.02*(1+20*abs(y-0.03))*(y-" + number(c) + ")"};
    Simulation<dim> simulation(
      read_parameters(
        "",
        at_rest + elastic + load + dimension(dim) +
          body("beam", {"Stiffness=1+20*abs(y-0.03)"}) +
          Overrides{"Mesh/Degree=4", "Mesh/Cells=2", "Mesh/Cells across=2"}),
      MPI_COMM_SELF);
    simulation.run({});
    double u = 0., stress = 0.;
    for (const double x : {0.4, 0.9})
      for (const double y : {0.01, 0.05, 0.08})
        {
          Point<dim> place;
          place[0]       = x;
          place[1]       = y;
          place[dim - 1] = dim == 3 ? 0.04 : y;
          raise(u,
                std::abs(
                  value_at(simulation, place, PointValues<dim>::displacement) -
                  k * x * (y - c)));
          raise(stress,
                std::abs(value_at(simulation, place, PointValues<dim>::stress) -
                         k * E(y) * (y - c)));
        }
    deallog << "bending, " << dim << "-D: u " << within(u, 1e-12) << ", stress "
            << within(stress, 1e-10) << std::endl;
  }



  // ---------------------------------------------------- 2. bimetal strip

  void
  check_bimetal()
  {
    const double W = 0.1, h = 0.03, theta = 10., a = 0.017;
    // integrals of E, E y, E y^2, a theta and a theta y
    const double E0 = 4. * h + (W - h), E1 = 2. * h * h + 0.5 * (W * W - h * h),
                 E2 = (4. * h * h * h + W * W * W - h * h * h) / 3.,
                 N  = a * theta * (2. * h + W - h),
                 M  = a * theta * (h * h + 0.5 * (W * W - h * h));
    const double D = E0 * E2 - E1 * E1, e = (N * E2 - M * E1) / D,
                 k = (E0 * M - E1 * N) / D;
    Simulation<2> simulation(
      read_parameters("",
                      at_rest + dimension(2) +
                        body("strip",
                             {"Stiffness=if(y<0.03,4,1)",
                              "Coupling=if(y<0.03,2,1)"}) +
                        Overrides{"Initial values/Temperature=theta_A",
                                  "Boundary/right/Heat exchange=0",
                                  "Mesh/Degree=3",
                                  "Mesh/Cells=20",
                                  "Mesh/Cells across=3"}),
      MPI_COMM_SELF);
    simulation.run({});
    double u = 0., stress = 0.;
    for (const double y : {0.01, 0.05, 0.08})
      {
        const Point<2> place(0.1, y);
        raise(u,
              std::abs(
                value_at(simulation, place, PointValues<2>::displacement) -
                0.1 * (e + k * y)));
        raise(stress,
              std::abs(value_at(simulation, place, PointValues<2>::stress) -
                       (y < h ? 4. * (e + k * y) - 2. * a * theta :
                                e + k * y - a * theta)));
      }
    deallog << "bimetal strip: u " << within(u, 1e-9) << ", stress "
            << within(stress, 1e-7) << std::endl;
  }



  // ------------------------------------------------ 3. heat across layers

  void
  check_heat_across()
  {
    const double W = 1., h = 0.4, K1 = 2., c1 = 1., K2 = 0.5, c2 = 3.;
    const auto   q1 = [&](const double s) { return std::sqrt(s * c1 / K1); };
    const auto   q2 = [&](const double s) { return std::sqrt(s * c2 / K2); };
    // heat flux of both layers at h, over cosines: zero of this function
    const auto excess = [&](const double s) {
      return K1 * q1(s) * std::sin(q1(s) * h) * std::cos(q2(s) * (W - h)) +
             K2 * q2(s) * std::sin(q2(s) * (W - h)) * std::cos(q1(s) * h);
    };
    double low = 0.5, high = 4.;
    for (unsigned int i = 0; i < 100; ++i)
      {
        const double middle                              = 0.5 * (low + high);
        (excess(low) * excess(middle) > 0. ? low : high) = middle;
      }
    const double s = low, A = std::cos(q1(s) * h) / std::cos(q2(s) * (W - h));
    const std::string start = "if(y<0.4,cos(" + number(q1(s)) + "*y)," +
                              number(A) + "*cos(" + number(q2(s)) + "*(1-y)))";
    Simulation<2> simulation(
      read_parameters("",
                      dimension(2) +
                        body("slab",
                             {"Conductivity=if(y<0.4,2,0.5)",
                              "Heat capacity=if(y<0.4,1,3)"}) +
                        Overrides{"Model/Fields=temperature",
                                  "Boundary/left/Temperature=none",
                                  "Boundary/left/Heat exchange=0",
                                  "Boundary/right/Heat exchange=0",
                                  "Initial values/Temperature=" + start,
                                  "Mesh/Width=1",
                                  "Mesh/Cells=1",
                                  "Mesh/Cells across=5",
                                  "Mesh/Degree=8",
                                  "Time/Tolerance=1e-10",
                                  "Time/End time=0.5"}),
      MPI_COMM_SELF);
    simulation.run({});
    double error = 0.;
    for (const double y : {0.1, 0.3, 0.5, 0.9})
      raise(
        error,
        std::abs(
          value_at(simulation, Point<2>(0.7, y), PointValues<2>::temperature) -
          std::exp(-0.5 * s) *
            (y < h ? std::cos(q1(s) * y) : A * std::cos(q2(s) * (W - y)))));
    deallog << "heat across layers: " << within(error, 1e-9) << std::endl;
  }



  // ------------------------------------------------------- 4. the rod

  const Overrides of_places = body("bar",
                                   {"Stiffness=if(x<0.4,1,2)*(1+x)",
                                    "Density=if(x<0.4,1,2)*(1+x)",
                                    "Viscosity=1-0.5*x",
                                    "Coupling=if(x<0.7,1,-3)",
                                    "Conductivity=exp(x)",
                                    "Heat capacity=if(x<0.4,3,1)"});

  const Overrides of_temperature =
    body("bar",
         {"Stiffness=if(x<0.4,1,2)*(1+x)/(1+0.02*theta)",
          "Density=if(x<0.4,1,2)*(1+x)",
          "Viscosity=(1-0.5*x)*exp(0.03*theta)",
          "Coupling=if(x<0.7,1,-3)*(1+0.03*theta)",
          "Conductivity=exp(x+0.03*theta)",
          "Heat capacity=if(x<0.4,3,1)*exp(0.05*theta)"});



  template <int dim>
  double
  difference_from_rod(const Overrides   &coefficients,
                      const unsigned int degree,
                      const Overrides   &more)
  {
    const Overrides scene = coefficients +
                            Overrides{"Model/Viscosity=0.05",
                                      "Model/Coupling=0.3",
                                      "Contact/Massless nodes=off",
                                      "Sources/Body force=0.3*x*exp(-t)",
                                      "Sources/Heat source=x",
                                      entry("Mesh/Degree", degree),
                                      "Time/Scheme=sdirk4",
                                      "Time/Step size=0.02",
                                      "Time/End time=1"} +
                            more;
    const RecordedRun rod = run<1>("", scene + body("bar", {"Cells=10"}));
    const RecordedRun of_body =
      run<dim>("",
               scene + dimension(dim) +
                 Overrides{"Initial values/Temperature=0",
                           "Initial values/Displacement=0",
                           "Initial values/Velocity=0",
                           "Model/Poisson ratio=0.3",
                           "Boundary/sides/Support=rollers",
                           "Mesh/Cells=10",
                           "Mesh/Cells across=1"});
    double difference = rod.rows.size() == of_body.rows.size() ? 0. : 1.;
    for (unsigned int i = 0; i < rod.rows.size() && difference < 1.; ++i)
      for (const auto part : {&StepRecord::displacement_end,
                              &StepRecord::velocity_end,
                              &StepRecord::contact_force,
                              &StepRecord::temperature_end,
                              &StepRecord::temperature_mean})
        raise(difference, std::abs(rod.rows[i].*part - of_body.rows[i].*part));
    return difference;
  }



  /** The velocity with which a viscous body begins to move. */
  void
  check_viscous()
  {
    const StepRecord pulled =
      run<2>("",
             Overrides{"Dimension=2",
                       "Model/Fields=displacement",
                       "Model/Inertia=0",
                       "Model/Viscosity=0.5",
                       "Boundary/right/Support=free",
                       "Boundary/right/Traction=0.1",
                       "Boundary/sides/Support=rollers",
                       "Mesh/Cells=2",
                       "Mesh/Cells across=1",
                       "Mesh/Degree=2",
                       "Time/End time=0.1"} +
               body("plate", {"Viscosity=if(x<0.5,1,4)"}))
        .rows.front();
    deallog << "viscous: v(1) "
            << within(std::abs(pulled.velocity_end - 0.125), 1e-11)
            << std::endl;
  }



  // ------------------------------------------------------- 5. numbers

  void
  check_numbers()
  {
    const Overrides   common = {"Dimension=2",
                                "Boundary/sides/Support=free",
                                "Model/Poisson ratio=0.3",
                                "Contact/Gap=0.01",
                                "Contact/Massless nodes=off",
                                "Initial values/Velocity=0.5*x",
                                "Mesh/Cells=6",
                                "Mesh/Cells across=2",
                                "Mesh/Degree=2",
                                "Boundary/right/Heat exchange=1",
                                "Time/Scheme=sdirk4",
                                "Time/Step size=0.02",
                                "Time/End time=0.4"};
    const RecordedRun one =
      run<2>("",
             common +
               body("plate", {"Density=3", "Viscosity=0.5", "Coupling=-2"}));
    const RecordedRun other =
      run<2>("",
             common + Overrides{"Model/Inertia=3",
                                "Model/Viscosity=0.1",
                                "Model/Coupling=-0.034"});
    double difference = 0., force = 0.;
    for (unsigned int i = 0; i < one.rows.size(); ++i)
      for (const auto part : {&StepRecord::displacement_end,
                              &StepRecord::contact_force,
                              &StepRecord::temperature_end})
        {
          raise(difference, std::abs(one.rows[i].*part - other.rows[i].*part));
          raise(force, one.rows[i].contact_force);
        }
    deallog << "numbers: " << (force > 0.1) << ' '
            << noise_within(difference, 1e-10) << std::endl;
  }



  // -------------------------------------------- 6. balance, 7. mirror image

  const Overrides all_vary = {"Stiffness=if(y<0.03,1,2)*(1+x)",
                              "Density=if(x<0.6,1,2)*(1+5*y)",
                              "Viscosity=1-0.5*x+y",
                              "Coupling=if(y<0.03,1,-3)",
                              "Conductivity=exp(x+4*y)",
                              "Heat capacity=if(x<0.6,3,1)"};

  const Overrides all_of_temperature = {
    "Stiffness=if(y<0.03,1,2)*(1+x)/(1+0.01*theta)",
    "Poisson ratio=0.1+x*y",
    "Density=if(x<0.6,1,2)*(1+5*y)",
    "Viscosity=(1-0.5*x+y)*exp(0.03*theta)",
    "Coupling=if(y<0.03,1,-3)*(1+0.02*theta)",
    "Conductivity=exp(x+4*y+0.03*theta)",
    "Heat capacity=if(x<0.6,3,1)*exp(0.02*theta)"};

  const Overrides mirrored = {"Stiffness=if(y>0.07,1,2)*(1+x)",
                              "Density=if(x<0.6,1,2)*(1.5-5*y)",
                              "Viscosity=1.1-0.5*x-y",
                              "Coupling=if(y>0.07,1,-3)",
                              "Conductivity=exp(x+0.4-4*y)",
                              "Heat capacity=if(x<0.6,3,1)"};

  const Overrides thrown = {"Dimension=2",
                            "Model/Viscosity=0.05",
                            "Model/Coupling=0.3",
                            "Model/Poisson ratio=0.2",
                            "Boundary/sides/Support=free",
                            "Contact/Gap=0.01",
                            "Initial values/Velocity=0.5*x",
                            "Mesh/Cells=5",
                            "Mesh/Cells across=3",
                            "Mesh/Degree=2",
                            "Time/Tolerance=1e-4",
                            "Time/End time=0.3"};



  void
  check_balance(const std::string &name,
                const Overrides   &contact,
                const Overrides   &coefficients = all_vary)
  {
    const RecordedRun result =
      run<2>("", thrown + body("plate", coefficients) + contact);
    double defect = 0., force = 0., dissipation = 0.;
    for (const StepRecord &row : result.rows)
      {
        raise(defect,
              std::abs(row.energy + row.dissipation +
                       row.numerical_dissipation + row.contact_dissipation -
                       row.work - result.rows[0].energy));
        raise(force, row.contact_force);
        dissipation = row.dissipation;
      }
    deallog << "balance, " << name << ": " << (force > 0.1) << ' '
            << (dissipation > 1e-3) << ' ' << noise_within(defect, 1e-12)
            << std::endl;
  }



  void
  check_mirror_image(const std::string &name,
                     const Overrides   &coefficients,
                     const Overrides   &image)
  {
    const RecordedRun one   = run<2>("", thrown + body("plate", coefficients)),
                      other = run<2>("", thrown + body("plate", image));
    double difference       = one.rows.size() == other.rows.size() ? 0. : 1.;
    double moment           = 0.;
    for (unsigned int i = 0; i < one.rows.size() && difference < 1.; ++i)
      {
        raise(difference,
              std::abs(one.rows[i].contact_force -
                       other.rows[i].contact_force));
        raise(difference,
              std::abs(one.rows[i].moment_y + other.rows[i].moment_y));
        raise(moment, std::abs(one.rows[i].moment_y));
      }
    deallog << "mirror image" << name << ": " << (moment > 1e-6) << ' '
            << noise_within(difference, 1e-9) << std::endl;
  }



  // --------------------------------------------------- 8. of temperature

  void
  check_coefficients_of_temperature()
  {
    deallog << "of theta, rod: "
            << noise_within(difference_from_rod<2>(of_temperature,
                                                   2,
                                                   {"Contact/Gap=0.01"}),
                            1e-10)
            << ' '
            << noise_within(
                 difference_from_rod<2>(of_temperature,
                                        3,
                                        {"Contact/Gap=0.01",
                                         "Model/Thermoelastic heating=false",
                                         "Contact/Condition=normal "
                                         "compliance"}),
                 1e-10)
            << ' '
            << noise_within(difference_from_rod<3>(of_temperature,
                                                   2,
                                                   {"Contact/Gap=0.01",
                                                    "Mesh/Mass matrix=lumped",
                                                    "Time/End time=0.2"}),
                            1e-10)
            << std::endl;

    const double nu = 0.3, lambda = nu / (1. - nu), T = 0.1, a = 1.5 * 0.017;
    const double right[2]    = {(T + a * 10.) / 2., a * 10. / 2.};
    const double determinant = 1. - lambda * lambda;
    const double along       = (right[0] - lambda * right[1]) / determinant,
                 across      = (right[1] - lambda * right[0]) / determinant;
    Simulation<2> simulation(
      read_parameters("",
                      at_rest + dimension(2) +
                        body("strip",
                             {"Stiffness=1+theta/10",
                              "Coupling=1+theta/20",
                              "Conductivity=exp(theta)"}) +
                        Overrides{"Model/Poisson ratio=0.3",
                                  "Boundary/right/Traction=0.1",
                                  "Initial values/Temperature=theta_A",
                                  "Boundary/right/Heat exchange=0",
                                  "Mesh/Degree=1",
                                  "Mesh/Cells=3",
                                  "Mesh/Cells across=2"}),
      MPI_COMM_SELF);
    simulation.run({});
    const StepRecord &last  = simulation.record();
    const Point<2>    place = {0.4, 0.08};
    deallog
      << "of theta, free: u "
      << noise_within(std::abs(last.displacement_end - along), 1e-12) << ' '
      << noise_within(
           std::abs(value_at(simulation, place, PointValues<2>::displacement) -
                    0.4 * along),
           1e-12)
      << ", across "
      << noise_within(std::abs(value_across(simulation) - 0.1 * across), 1e-12)
      << ", stress "
      << noise_within(
           std::abs(value_at(simulation, place, PointValues<2>::stress) - T),
           1e-11)
      << std::endl;
  }



  // --------------------------------------------------- 9. Poisson ratios

  void
  check_poisson_ratios()
  {
    const auto p_wave = [](const double nu) {
      return (1. - nu) / ((1. + nu) * (1. - 2. * nu));
    };
    const StepRecord series =
      run<3>("",
             at_rest + elastic + dimension(3) +
               body("block", {"Poisson ratio=if(x<0.4,0.2,0.4)"}) +
               Overrides{"Model/Poisson ratio=0.2",
                         "Boundary/sides/Support=rollers",
                         "Boundary/right/Traction=0.1",
                         "Mesh/Cells=2",
                         "Mesh/Cells across=1",
                         "Mesh/Degree=1"})
        .rows.back();
    deallog << "Poisson ratios: along "
            << noise_within(std::abs(series.displacement_end -
                                     0.1 *
                                       (0.4 + 0.6 * p_wave(0.2) / p_wave(0.4))),
                            1e-12);

    const StepRecord heated =
      run<3>("",
             at_rest + dimension(3) +
               body("block", {"Poisson ratio=if(x<0.4,0.1,0.4)"}) +
               Overrides{"Model/Poisson ratio=0.2",
                         "Model/Coupling=0.3",
                         "Model/Thermoelastic heating=false",
                         "Initial values/Temperature=1",
                         "Boundary/left/Temperature=none",
                         "Boundary/right/Heat exchange=0",
                         "Mesh/Cells=2",
                         "Mesh/Cells across=1",
                         "Mesh/Degree=1"})
        .rows.back();
    deallog << ", heated "
            << noise_within(std::abs(heated.displacement_end - 0.2), 1e-12);

    const double  e = 0.02, Y = 1. / p_wave(0.2), h = 0.03, W = 0.1;
    Simulation<2> simulation(
      read_parameters("",
                      at_rest + elastic + dimension(2) +
                        body("strip",
                             {"Poisson ratio=if(y<0.03,-0.1,0.4)",
                              "Stiffness=if(y<0.03,0.99,0.84)"}) +
                        Overrides{"Model/Poisson ratio=0.2",
                                  "Boundary/right/Traction=" + number(e * Y),
                                  "Mesh/Cells=3",
                                  "Mesh/Cells across=2",
                                  "Mesh/Degree=1"}),
      MPI_COMM_SELF);
    simulation.run({});
    double u = 0., stress = 0.;
    for (const double y : {0.01, 0.05})
      {
        const Point<2> place(0.4, y);
        raise(u,
              std::abs(
                value_at(simulation, place, PointValues<2>::displacement) -
                0.4 * e));
        raise(stress,
              std::abs(value_at(simulation, place, PointValues<2>::stress) -
                       e * Y));
      }
    const double across = -e * (-0.1 / 1.1 * h + 0.4 / 0.6 * (W - h));
    deallog << ", layers u " << noise_within(u, 1e-12) << ", stress "
            << noise_within(stress, 1e-11) << ", across "
            << noise_within(std::abs(value_across(simulation) - across), 1e-12)
            << std::endl;
  }



  // --------------------------------------------- what runs of a study share

  void
  check_shared()
  {
    const auto profile = [](const std::string &coupling) {
      return BodyProfile(read_parameters(
        "",
        dimension(2) + body("plate", {"Stiffness=2", "Coupling=" + coupling})));
    };
    deallog << "E = 2, Coupling none is none "
            << (profile("none") == profile("none")) << ", is 1 "
            << (profile("none") == profile("1")) << std::endl;
  }



  // ----------------------------------------------------------- 10. meshes

  void
  check_mesh(const std::string &name,
             const std::string &stiffness,
             const unsigned int degree = 1)
  {
    const Scene scene(
      read_parameters("",
                      dimension(2) + body("plate", {"Stiffness=" + stiffness}) +
                        Overrides{"Mesh/Cells=4",
                                  "Mesh/Cells across=6",
                                  "Mesh/Degree=" + std::to_string(degree)}));
    const ProblemData<2>     data(scene);
    std::vector<std::string> warnings;
    load_history<2>(scene, data, warnings);
    const MeshParameters &mesh = scene.parameters.mesh;
    deallog << name << ": along";
    for (const double size : mesh.cell_sizes())
      deallog << ' ' << size;
    deallog << ", across";
    for (const double size : mesh.cell_sizes_across())
      deallog << ' ' << size;
    deallog << ", doubts " << warnings.size() << std::endl;
    for (const std::string &warning : warnings)
      deallog << warning << std::endl;
  }
} // namespace



void
main_varying_bodies()
{
  initlog();
  check_bending<2>();
  check_bending<3>();
  check_bimetal();
  check_heat_across();
  deallog << "rod: "
          << noise_within(difference_from_rod<2>(of_places,
                                                 2,
                                                 {"Contact/Gap=0.01"}),
                          1e-10)
          << ' '
          << noise_within(difference_from_rod<3>(of_places,
                                                 2,
                                                 {"Contact/Gap=0.01",
                                                  "Mesh/Mass matrix=lumped"}),
                          1e-10)
          << ' '
          << noise_within(difference_from_rod<2>(of_places,
                                                 3,
                                                 {"Contact/Gap=0.01",
                                                  "Contact/Condition=normal "
                                                  "compliance"}),
                          1e-10)
          << std::endl;
  check_viscous();
  check_numbers();
  check_balance("elastic",
                {"Contact/Condition=normal compliance",
                 "Contact/Compliance=0.01"});
  check_balance("rigid", {"Contact/Condition=rigid"});
  check_balance("nodes with mass",
                {"Contact/Condition=normal compliance",
                 "Contact/Compliance=0.1",
                 "Contact/Massless nodes=off"});
  check_balance("of theta",
                {"Contact/Condition=normal compliance",
                 "Contact/Compliance=0.1"},
                all_of_temperature);
  check_mirror_image("", all_vary, mirrored);
  check_mirror_image(", of theta",
                     all_of_temperature,
                     {"Stiffness=if(y>0.07,1,2)*(1+x)/(1+0.01*theta)",
                      "Poisson ratio=0.1+x*(0.1-y)",
                      "Density=if(x<0.6,1,2)*(1.5-5*y)",
                      "Viscosity=(1.1-0.5*x-y)*exp(0.03*theta)",
                      "Coupling=if(y>0.07,1,-3)*(1+0.02*theta)",
                      "Conductivity=exp(x+0.4-4*y+0.03*theta)",
                      "Heat capacity=if(x<0.6,3,1)*exp(0.02*theta)"});
  check_coefficients_of_temperature();
  check_poisson_ratios();
  check_shared();
  check_mesh("layers", "if(y<0.02,1,if(y<0.07,2,3))*if(x<0.3,1,2)");
  check_mesh("inclusion", "if(x<0.5 && y<0.05,3,1)");
  check_mesh("oblique", "if(y<0.05+0.01*x,2,1)");
  check_mesh("jumps on faces", "if(x<1,1,2)*if(y>0,1,2)+if(x<1-1e-12,1,0)");
  for (const unsigned int degree : {1, 2})
    check_mesh("kink", "1+abs(y-0.03)", degree);
}
