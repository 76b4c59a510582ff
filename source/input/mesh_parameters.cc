// SPDX-License-Identifier: LGPL-2.1-or-later

#include <thermocontact/input/parameters.h>
#include <thermocontact/input/words_of_kinds.h>

#include <deal.II/base/patterns.h>

#include <cmath>

namespace ThermoContact
{
  namespace
  {
    /** @p ratio is that of the first size to the last. */
    std::vector<double>
    geometric_progression(const unsigned int n,
                          const double       ratio,
                          const double       length)
    {
      const double        factor = n > 1 ? std::pow(ratio, -1. / (n - 1.)) : 1.;
      std::vector<double> sizes(n);
      double              sum = 0.;
      for (unsigned int i = 0; i < n; ++i)
        sum += sizes[i] = std::pow(factor, i);
      for (double &size : sizes)
        size = size * length / sum;
      return sizes;
    }
  } // namespace



  void
  MeshParameters::add_parameters(ParameterHandler &prm)
  {
    using namespace dealii::Patterns;

    prm.enter_subsection("Mesh");
    prm.add_parameter("Cells",
                      cells,
                      "Number of cells along the rod; the paper: 250.",
                      Integer(1, 10000000));
    prm.add_parameter("Degree",
                      degree,
                      "Polynomial degree p of both fields; the paper: 1.",
                      Integer(1, 30));
    prm.add_parameter("Refinements",
                      refinements,
                      "Global refinements of that mesh.",
                      Integer(0, 30));
    prm.add_parameter("Grading",
                      grading,
                      "Size of the first cell over size of the last, in "
                      "geometric progression; 1 is uniform.",
                      Double(1e-8, 1e8));
    prm.add_parameter("Mass matrix",
                      mass_matrix,
                      "consistent; lumped (Gauss-Lobatto rule: diagonal); or "
                      "midpoint (one point to a cell), with which waves in an "
                      "elastic rod of equal linear cells have no dispersion if "
                      "Time/Scheme = energy conserving and Time/Step size = "
                      "h sqrt(b).",
                      Selection("consistent|lumped|midpoint"));
    prm.add_parameter("Geometry",
                      geometry,
                      "What the mesh stands for, for Dimension = 2: " +
                        in_words(geometries(),
                                 [](const auto &kind) {
                                   return " (" + kind.text + ")";
                                 }) +
                        ".",
                      Selection(names_of(geometries())));
    prm.add_parameter("Width",
                      width,
                      "Width (and height) of the body, for Dimension > 1; its "
                      "length is 1. With Geometry = axisymmetric its radius.",
                      Double(1e-3, 1e3));
    prm.add_parameter("Cells across",
                      cells_across,
                      "Number of cells across the body, for Dimension > 1.",
                      Integer(1, 100000));
    prm.add_parameter("Grading across",
                      grading_across,
                      "Size of the first cell across the body, at y = 0, over "
                      "size of the last, in geometric progression; for "
                      "Dimension > 1.",
                      Double(1e-8, 1e8));
    prm.leave_subsection();
  }



  std::vector<double>
  MeshParameters::cell_sizes() const
  {
    return geometric_progression(cells, grading, 1.);
  }



  std::vector<double>
  MeshParameters::cell_sizes_across() const
  {
    return geometric_progression(cells_across, grading_across, width);
  }



  unsigned int
  MeshParameters::n_halvings() const
  {
    unsigned int n = 0;
    while (grading == 1. && grading_across == 1. && cells % (2U << n) == 0 &&
           cells_across % (2U << n) == 0)
      ++n;
    return n;
  }



  double
  MeshParameters::n_nodes(const unsigned int dim) const
  {
    const auto along = [this](const unsigned int n_cells) {
      return degree * std::ldexp(n_cells, refinements) + 1.;
    };
    return along(cells) * std::pow(along(cells_across), dim - 1.);
  }



  double
  MeshParameters::contact_spacing() const
  {
    return std::ldexp(cell_sizes().back(), -static_cast<int>(refinements)) /
           degree;
  }
} // namespace ThermoContact
