// SPDX-License-Identifier: LGPL-2.1-or-later
//
// Boundary/left/Support = sliding. Between two ends that slide on rigid
// walls and free sides, a body without viscosity and heat swings in the waves
// of infinite waveguides, sin(kx) along the axis with k = n pi. Their
// frequencies omega with b = 1 and nu = 0.3, from the roots of
//   symmetric waves of a plate of half thickness h = 0.1 (Rayleigh and Lamb):
//     (q^2 - k^2)^2 cos(ph) sin(qh) + 4 k^2 p q sin(ph) cos(qh) = 0 ,
//   longitudinal waves of a round rod of radius R = 0.1 (Pochhammer and Chree):
//     2p/R (q^2 + k^2) J_1(pR) J_1(qR) - (q^2 - k^2)^2 J_0(pR) J_1(qR)
//       - 4 k^2 p q J_1(pR) J_0(qR) = 0 ,
//   p^2 = omega^2 - k^2,  q^2 = omega^2/mu - k^2,  mu = 2/7:
//   omega/k for        n = 1           2           3           4
//     plate          0.9006844829  0.8909546597  0.8694362022  0.8256100595
//     round rod      0.8599472975  0.8537338247  0.8419918458  0.8223352167
// against the square roots of the eigenvalues of S v = omega^2 M_u v, where the
// contact nodes, which have pressures, do not move along the axis. Bound: 1e-5
// relative (4e-8 measured with degree 4). The ends that slide, the free sides
// and the axis r = 0 are those of the program; a clamped end misses the first
// frequency of the round rod by more than 1e-3.

#include <thermocontact/space/body.h>
#include <thermocontact/space/linear_system.h>

#include <deal.II/base/mpi.h>

#include <deal.II/lac/lapack_full_matrix.h>

#include <algorithm>
#include <cmath>

#include "../tests.h"

using namespace ThermoContact;

namespace
{
  // not dealii's template of that name
  using ThermoContact::Vector;

  /** Frequencies of a body whose ends x = 0 and x = 1 do not move along x. */
  class Frequencies
  {
  public:
    Frequencies(const Scene &scene, const unsigned int n_modes)
      : body(scene, MPI_COMM_SELF)
      , solver(body.equations,
               stage_coefficients(stage_length).of(Field::displacement))
    {
      find_responses();
      std::vector<Vector> modes;
      for (unsigned int i = 0; i < 2 * n_modes; ++i)
        {
          modes.push_back(body.discretization.make_vector(Field::displacement));
          for (unsigned int j = 0; j < modes[i].locally_owned_size(); ++j)
            modes[i].begin()[j] = std::sin(1. + 0.7 * i + (1.3 + 0.1 * i) * j);
        }
      for (unsigned int iteration = 0; iteration < 25; ++iteration)
        iterate(modes);
      values.resize(n_modes);
    }

    /** In ascending order. */
    std::vector<double> values;

  private:
    static constexpr double stage_length = 10.;

    Body<2>             body;
    LinearSystem<2>     solver; ///< of M_u + 100 S
    std::vector<Vector> responses;
    FullMatrix<double>  inverse_response;

    void
    find_responses()
    {
      const auto &end = body.contact_end();
      inverse_response =
        end.response_matrix([&](const unsigned int node) -> const Vector & {
          Vector load = body.discretization.make_vector(Field::displacement);
          for (const auto &[i, entry] : end.entries(Field::displacement))
            load.begin()[entry] = i == node ? 1. : 0.;
          Vector &response = responses.emplace_back(load);
          solver.solve(response, load);
          return response;
        });
      inverse_response.gauss_jordan();
    }

    /** Inverse iteration with forces that hold the contact nodes, then Ritz. */
    void
    iterate(std::vector<Vector> &modes)
    {
      const Vector zero = body.discretization.make_vector(Field::displacement);
      std::vector<double> held;
      for (Vector &mode : modes)
        {
          Vector load(zero);
          body.equations.momentum_mass.vmult(load, mode);
          for (const unsigned int entry :
               body.discretization.constrained_entries(Field::displacement))
            load.begin()[entry] = 0.;
          solver.solve(mode, load);
          body.contact_end().get_values(Field::displacement, mode, held);
          for (unsigned int i = 0; i < held.size(); ++i)
            for (unsigned int j = 0; j < held.size(); ++j)
              mode.add(-inverse_response(i, j) * held[j], responses[i]);
        }

      const unsigned int       n = modes.size();
      LAPACKFullMatrix<double> stiffness(n, n), mass(n, n);
      Vector                   product(zero);
      for (unsigned int i = 0; i < n; ++i)
        for (unsigned int j = 0; j < n; ++j)
          {
            body.equations.stiffness.vmult(product, modes[j]);
            stiffness(i, j) = modes[i] * product;
            body.equations.momentum_mass.vmult(product, modes[j]);
            mass(i, j) = modes[i] * product;
          }
      std::vector<dealii::Vector<double>> vectors(n);
      for (auto &vector : vectors)
        vector.reinit(n);
      stiffness.compute_generalized_eigenvalues_symmetric(mass, vectors);
      values.clear();
      std::vector<Vector> ritz;
      for (unsigned int i = 0; i < n; ++i)
        {
          values.push_back(
            std::sqrt(std::max(0., stiffness.eigenvalue(i).real())));
          ritz.push_back(zero);
          for (unsigned int j = 0; j < n; ++j)
            ritz[i].add(vectors[i][j], modes[j]);
        }
      modes.swap(ritz);
    }
  };



  std::vector<double>
  frequencies(const std::vector<std::string> &geometry,
              const std::string              &support,
              const unsigned int              n_modes)
  {
    std::vector<std::string> overrides = {"Dimension=2",
                                          "Model/Fields=displacement",
                                          "Model/Viscosity=0",
                                          "Model/Poisson ratio=0.3",
                                          "Boundary/sides/Support=free",
                                          "Boundary/left/Support=" + support,
                                          "Contact/Massless nodes=off",
                                          "Mesh/Cells=12",
                                          "Mesh/Degree=4"};
    overrides.insert(overrides.end(), geometry.begin(), geometry.end());
    const Scene scene(read_parameters("", overrides));
    return Frequencies(scene, n_modes).values;
  }



  const std::vector<std::string> plate     = {"Mesh/Width=0.2",
                                              "Mesh/Cells across=3"};
  const std::vector<std::string> round_rod = {"Mesh/Geometry=axisymmetric",
                                              "Mesh/Width=0.1",
                                              "Mesh/Cells across=2"};



  void
  check(const std::string              &name,
        const std::vector<std::string> &geometry,
        const unsigned int              n_modes,
        const std::vector<double>      &speeds)
  {
    const auto found = frequencies(geometry, "sliding", n_modes);
    deallog << name << ", within 1e-5:";
    for (unsigned int n = 1; n <= speeds.size(); ++n)
      {
        const double exact = speeds[n - 1] * n * numbers::PI;
        double       error = 1.;
        for (const double omega : found)
          error = std::min(error, std::abs(omega / exact - 1.));
        deallog << ' ' << within(error, 1e-5);
      }
    deallog << std::endl;
  }
} // namespace



void
main_guided_waves()
{
  initlog();

  check("plate",
        plate,
        20,
        {0.9006844829, 0.8909546597, 0.8694362022, 0.8256100595});
  const std::vector<double> speeds = {0.8599472975,
                                      0.8537338247,
                                      0.8419918458,
                                      0.8223352167};
  check("round rod", round_rod, 5, speeds);
  const double clamped = frequencies(round_rod, "clamped", 2)[0];
  deallog << "clamped, off by more than 1e-3 "
          << (std::abs(clamped / (speeds[0] * numbers::PI) - 1.) > 1e-3)
          << std::endl;
}
