// SPDX-License-Identifier: LGPL-2.1-or-later

#include <thermocontact/multigrid/level_matrix.h>

#include <deal.II/base/quadrature_lib.h>

namespace ThermoContact
{
  namespace
  {
    /** What a basis function is at a quadrature point. */
    template <int dim>
    struct BasisPoint
    {
      double                  value;
      Tensor<1, dim>          gradient;
      std::array<Strain, dim> strains; ///< of a displacement along each axis
    };



    /**
     * @param corner its node; bit d: the upper one along direction d
     * @param place in the unit cell
     * @param point in the body
     * @param size of the cell
     */
    template <int dim>
    BasisPoint<dim>
    basis_at(const Geometry<dim>  &geometry,
             const unsigned int    corner,
             const Point<dim>     &place,
             const Point<dim>     &point,
             const Tensor<1, dim> &size)
    {
      BasisPoint<dim> basis{1., {}, {}};
      for (unsigned int d = 0; d < dim; ++d)
        {
          const bool is_upper = (corner >> d & 1U) != 0;
          basis.value *= is_upper ? place[d] : 1. - place[d];
          basis.gradient[d] = is_upper ? 1. / place[d] : -1. / (1. - place[d]);
        }
      for (unsigned int d = 0; d < dim; ++d)
        basis.gradient[d] *= basis.value / size[d];
      for (unsigned int c = 0; c < dim; ++c)
        {
          Tensor<2, dim> gradient;
          Tensor<1, dim> value;
          gradient[c]      = basis.gradient;
          value[c]         = basis.value;
          basis.strains[c] = geometry.strain(gradient, value, point);
        }
      return basis;
    }
  } // namespace



  template <int dim, typename Number>
  LevelMatrix<dim, Number>::LevelMatrix(
    const Scene               &scene,
    const Discretization<dim> &discretization,
    const LevelGrid<dim>      &grid)
    : n_nodes(grid.n_nodes())
    , mass(std::size_t(n_nodes) * n_neighbours)
  {
    for (unsigned int k = 0; k < n_neighbours; ++k)
      {
        // the digits of k and of the centre, to the base of 3
        int          offset = 0;
        unsigned int rest   = k + n_neighbours - 1;
        for (unsigned int d = dim; d-- > 0; rest /= 3)
          offset += (int(rest % 3) - 1) * int(grid.strides()[d]);
        offsets[k] = offset;
      }
    for (const Field::Block field : all_fields)
      if (discretization.has_field(field))
        stiffness[field].resize(mass.size() * n_components(field) *
                                n_components(field));
    for (unsigned int node = 0; node < n_nodes; ++node)
      {
        const typename LevelGrid<dim>::Index index    = grid.index(node);
        bool                                 has_cell = true;
        for (unsigned int d = 0; d < dim; ++d)
          has_cell = has_cell && index[d] + 1 < grid.positions(d).size();
        if (has_cell)
          add_cell(
            scene, discretization.geometry(), grid, index, QGauss<dim>(2));
      }
  }



  template <int dim, typename Number>
  void
  LevelMatrix<dim, Number>::add_cell(
    const Scene                          &scene,
    const Geometry<dim>                  &geometry,
    const LevelGrid<dim>                 &grid,
    const typename LevelGrid<dim>::Index &first,
    const Quadrature<dim>                &rule)
  {
    constexpr unsigned int n_corners  = 1U << dim;
    const Point<dim>       corner     = grid.node(first);
    unsigned int           first_node = 0;
    double                 volume     = 1.;
    Tensor<1, dim>         size;
    for (unsigned int d = 0; d < dim; ++d)
      {
        size[d] = grid.positions(d)[first[d] + 1] - corner[d];
        volume *= size[d];
        first_node += first[d] * grid.strides()[d];
      }
    std::vector<Number> &conduction = stiffness[Field::temperature];
    std::vector<Number> &elasticity = stiffness[Field::displacement];
    for (unsigned int q = 0; q < rule.size(); ++q)
      {
        Point<dim> point = corner;
        for (unsigned int d = 0; d < dim; ++d)
          point[d] += rule.point(q)[d] * size[d];
        const double weight =
          rule.weight(q) * volume * geometry.weight_at(point);
        std::array<BasisPoint<dim>, n_corners> basis;
        for (unsigned int i = 0; i < n_corners; ++i)
          basis[i] = basis_at(geometry, i, rule.point(q), point, size);
        for (unsigned int i = 0; i < n_corners; ++i)
          for (unsigned int j = 0; j < n_corners; ++j)
            {
              unsigned int node = first_node, digits = 0;
              for (unsigned int d = 0; d < dim; ++d)
                {
                  node += (i >> d & 1U) * grid.strides()[d];
                  digits = 3 * digits + (j >> d & 1U) + 1 - (i >> d & 1U);
                }
              if (digits + 1 < n_neighbours)
                continue;
              const std::size_t k =
                std::size_t(node) * n_neighbours + digits + 1 - n_neighbours;
              mass[k] += weight * basis[i].value * basis[j].value;
              if (!conduction.empty())
                conduction[k] +=
                  weight * (basis[i].gradient * basis[j].gradient);
              if (elasticity.empty())
                continue;
              for (unsigned int c = 0; c < dim; ++c)
                for (unsigned int e = 0; e < dim; ++e)
                  elasticity[(k * dim + c) * dim + e] +=
                    weight * elastic_product(scene.material,
                                             basis[i].strains[c],
                                             basis[j].strains[e]);
            }
      }
  }



  template <int dim, typename Number>
  LevelVector<Number>
  LevelMatrix<dim, Number>::make_vector(const Field::Block field) const
  {
    return LevelVector<Number>(n_nodes * n_components(field));
  }



  template <int dim, typename Number>
  void
  LevelMatrix<dim, Number>::vmult(const Field::Block         field,
                                  const double               mass_factor,
                                  const double               stiffness_factor,
                                  LevelVector<Number>       &y,
                                  const LevelVector<Number> &x) const
  {
    y                       = Number();
    const Number *const in  = x.begin();
    Number *const       out = y.begin();
    visit_entries(field,
                  mass_factor,
                  stiffness_factor,
                  [in, out](const unsigned int row,
                            const unsigned int column,
                            const Number       value) {
                    out[row] += value * in[column];
                    if (row != column)
                      out[column] += value * in[row];
                  });
  }



  template class LevelMatrix<2, float>;
  template class LevelMatrix<2, double>;
  template class LevelMatrix<3, float>;
  template class LevelMatrix<3, double>;
} // namespace ThermoContact
