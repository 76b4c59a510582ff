// SPDX-License-Identifier: LGPL-2.1-or-later

#include <thermocontact/base/shares.h>
#include <thermocontact/base/text.h>
#include <thermocontact/input/parameters.h>
#include <thermocontact/input/section_of_entries.h>

#include <deal.II/base/patterns.h>

#include <algorithm>
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



    /** Nearly the same ones, of which some end at the planes. */
    std::vector<double>
    sizes_between(const std::vector<double> &planes,
                  const unsigned int         n,
                  const double               length)
    {
      std::vector<double> parts;
      double              last = 0.;
      for (const double plane : planes)
        {
          parts.push_back(plane - last);
          last = plane;
        }
      parts.push_back(length - last);
      std::vector<double>             sizes;
      const std::vector<unsigned int> numbers = shares(parts, n);
      for (std::size_t i = 0; i < parts.size(); ++i)
        sizes.insert(sizes.end(), numbers[i], parts[i] / numbers[i]);
      return sizes;
    }
  } // namespace



  void
  MeshParameters::add_parameters(ParameterHandler &prm)
  {
    using namespace dealii::Patterns;

    SectionOfEntries entry(prm, "Mesh");
    entry("Cells", cells, NumberOrText::word_or_count("automatic", 1, 10000000))
      .means(text("Number of cells along the rod; automatic: ",
                  cells_by_default,
                  ", as many as resolve fronts of waves, or with Time/Scheme = "
                  "box by Time/Tolerance. The paper: 250."));
    entry("Degree", degree, NumberOrText::word_or_count("automatic", 1, 30))
      .means(text("Polynomial degree p of both fields; automatic: ",
                  degree_by_default,
                  ", 8 where it resolves fronts, or 1 with Time/Scheme = box. "
                  "The paper: 1."));
    entry("Refinements", refinements, Integer(0, 30))
      .means("Global refinements of that mesh.");
    entry("Grading", grading, Double(1e-8, 1e8))
      .means("Size of the first cell over size of the last, in geometric "
             "progression; 1 is uniform.");
    entry("Mass matrix", mass_matrix, Selection("consistent|lumped"))
      .means("consistent, or lumped (Gauss-Lobatto rule: diagonal). That of "
             "Time/Scheme = box has one point to a cell.");
    entry("Geometry", geometry, Selection(names_of(geometries())))
      .means("What the mesh stands for, for Dimension = 2: " +
             in_words(geometries(),
                      [](const auto &kind) { return " (" + kind.text + ")"; }) +
             ".");
    entry("Width", width, Double(1e-3, 1e3))
      .means("Width (and height) of the body, for Dimension > 1; its length is "
             "1. With Geometry = axisymmetric its radius.",
             "length");
    entry("Cells across", cells_across, Integer(0, 100000))
      .means("Number of cells across the body, for Dimension > 1; 0: as many "
             "as make them squares or cubes.");
    entry("Grading across", grading_across, Double(1e-8, 1e8))
      .means("Size of the first cell across the body, at y = 0, over size of "
             "the last, in geometric progression; for Dimension > 1.");
  }



  std::vector<double>
  MeshParameters::cell_sizes() const
  {
    return planes[0].empty() ? geometric_progression(cells, grading, 1.) :
                               sizes_between(planes[0], cells, 1.);
  }



  std::vector<double>
  MeshParameters::cell_sizes_across() const
  {
    return planes[1].empty() ?
             geometric_progression(n_cells_across(), grading_across, width) :
             sizes_between(planes[1], n_cells_across(), width);
  }



  unsigned int
  MeshParameters::n_cells_across() const
  {
    return cells_across > 0 ? cells_across :
                              std::max(1., std::round(cells * width));
  }



  double
  MeshParameters::cell_aspect() const
  {
    std::vector<double>       sizes  = cell_sizes();
    const std::vector<double> across = cell_sizes_across();
    sizes.insert(sizes.end(), across.begin(), across.end());
    const auto [min, max] = std::minmax_element(sizes.begin(), sizes.end());
    return *max / *min;
  }



  unsigned int
  MeshParameters::n_halvings() const
  {
    unsigned int n = 0;
    while (has_equal_cells() && cells % (2U << n) == 0 &&
           n_cells_across() % (2U << n) == 0)
      ++n;
    return n;
  }



  double
  MeshParameters::n_nodes(const unsigned int dim) const
  {
    return (degree * n_cells_along() + 1.) * n_contact_nodes(dim);
  }



  double
  MeshParameters::n_contact_nodes(const unsigned int dim) const
  {
    return std::pow(degree * std::ldexp(n_cells_across(), refinements) + 1.,
                    dim - 1.);
  }



  double
  MeshParameters::spacing() const
  {
    const double n_nodes = (degree > 0 ? degree : degree_by_default) *
                           (cells > 0 ? cells : cells_by_default);
    return 1. / std::ldexp(n_nodes, refinements);
  }



  double
  MeshParameters::contact_spacing() const
  {
    return std::ldexp(cell_sizes().back(), -static_cast<int>(refinements)) /
           degree;
  }



  double
  MeshParameters::contact_node_length() const
  {
    return contact_spacing() / (degree + 1.);
  }



  bool
  MeshParameters::halve(const unsigned int dim)
  {
    if (refinements > 0)
      {
        --refinements;
        return true;
      }
    const auto half = [this](const unsigned int n, const unsigned int d) {
      return std::max<unsigned int>((n + 1) / 2, planes[d].size() + 1);
    };
    const unsigned int along = cells, across = n_cells_across();
    cells = half(along, 0);
    if (dim > 1)
      cells_across = half(across, 1);
    return cells < along || (dim > 1 && cells_across < across);
  }



  std::string
  MeshParameters::limits_of_places(
    const unsigned int                                dim,
    const std::function<std::string(const double x)> &in_unit) const
  {
    std::string limits = dim == 1 ? "x" : dim == 2 ? "x, y" : "x, y, z";
    limits += " with 0 <= x <= " + in_unit(1.);
    if (dim > 1)
      limits += (dim == 2 ? ", 0 <= y <= " : ", 0 <= y, z <= ") +
                in_unit(width) + " (Mesh/Width)";
    return limits;
  }
} // namespace ThermoContact
